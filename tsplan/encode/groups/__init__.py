"""Classes with group bounds: where the groups of a swarm are, and how many agents each has."""
