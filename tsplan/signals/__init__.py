"""Signals: trajectories of linear systems that satisfy a formula over real numbers."""
