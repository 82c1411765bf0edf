"""Plans: paths and moves of all agents, their files, and their summary in words."""
