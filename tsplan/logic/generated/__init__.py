"""Lexers and parsers that ANTLR generates; see `scripts/generate_parsers.py`."""
