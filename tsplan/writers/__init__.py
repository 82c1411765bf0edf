"""Plans in the formats of other programs: of robots' navigation, fleets, viewers and tables.

`tsplan.export` writes them. Each format is one file with a function from a `Handover`, which is a
plan together with its map, to the text of a file, and a line in `tsplan/writers/plan_formats.py`.
"""
