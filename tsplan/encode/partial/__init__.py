"""Missions that hold as far as possible: formulas met in part, and preferred formulas."""
