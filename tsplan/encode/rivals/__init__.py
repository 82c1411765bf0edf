"""Witnesses that the same agents would have to serve: which exclude each other, what follows."""
