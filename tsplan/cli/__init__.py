"""The command line: `tsplan plan`, `sweep`, `check`, `simulate`, `parse`, `show` and `lint`."""

from tsplan.cli.main import main

__all__ = ["main"]
