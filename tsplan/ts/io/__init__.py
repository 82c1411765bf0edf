"""Map files: one module for each format, which is recognised by its content."""
