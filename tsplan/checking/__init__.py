"""The independent check: what a plan does on the map, what it satisfies, what it is worth."""
