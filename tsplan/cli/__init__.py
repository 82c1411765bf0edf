"""The command line: `tsplan plan`, `check`, `parse`, `show` and `lint`."""

from tsplan.cli.main import main

__all__ = ["main"]
