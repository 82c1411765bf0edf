"""Mixed-integer linear programs as arrays, and one file per solver."""
