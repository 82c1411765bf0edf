"""Following a plan while it is carried out: what is decided, and whether the plan still works."""
