"""Swarms: groups of agents that split and merge, and how many agents each of them has."""
