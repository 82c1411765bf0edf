"""Pictures of maps, missions and plans (matplotlib, the `plot` extra).

`layout` and `palette` are plain data without matplotlib, for every other way of showing a plan.
Every drawing function takes `ax=None` and returns `(figure, axes)`.
"""
