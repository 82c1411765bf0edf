"""Map files: one module for each format, which is recognised by its content.

- `map_files`: the formats, and reading and writing by them.
- `map_settings`, `label_areas`: what a mission says of reading a map, and the labels it gives.
- `map_draft`, `graph_draft`: a map while it is read, of steps or of metres.
- `grey_image`: the picture of an occupancy grid.
"""
