"""Routes of single agents past the tasks of a mission: a bound on what they cost, and plans."""
