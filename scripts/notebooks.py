"""Run the notebooks of `docs/notebooks` and keep what they print; or see whether that is stale.

    python scripts/notebooks.py             # run and store
    python scripts/notebooks.py --check     # run and compare

Only what is the same wherever it runs is compared: cells with the tag `varies` (they show one of
several equally good plans) and pictures are not. Needs nbclient and ipykernel.
"""

from __future__ import annotations

import argparse
import difflib
import os
import sys
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import nbformat
from nbclient import NotebookClient

ROOT = Path(__file__).resolve().parent.parent
NOTEBOOKS = ROOT / "docs" / "notebooks"
PATIENCE = 300
"""Seconds for one cell."""


def executed(path: Path, folder: Path = ROOT) -> Any:
    """The notebook as it comes out of a run from `folder`, without times and versions."""
    book = nbformat.read(path, as_version=4)
    client = NotebookClient(
        book,
        timeout=PATIENCE,
        kernel_name="python3",
        record_timing=False,
        resources={"metadata": {"path": str(folder)}},
    )
    client.execute(env={**os.environ, "PYTHONPATH": str(ROOT)})
    book.metadata.pop("language_info", None)
    return book


def printed(book: Any) -> Iterator[tuple[str, str]]:
    """Each cell's text that is the same everywhere, with the cell's code."""
    for cell in book.cells:
        if cell.cell_type != "code" or "varies" in cell.metadata.get("tags", ()):
            continue
        yield cell.source, "\n".join(_texts(cell))


def _texts(cell: Any) -> Iterator[str]:
    for output in cell.outputs:
        if output.output_type == "stream":
            yield output.text.rstrip("\n")
        elif set(output.get("data", ())) == {"text/plain"}:
            yield output.data["text/plain"]


def stale(path: Path, folder: Path = ROOT) -> list[str]:
    """How what a run prints differs from what is stored; nothing if it does not."""
    stored = list(printed(nbformat.read(path, as_version=4)))
    return [
        "\n".join(difflib.unified_diff(before[1].split("\n"), after[1].split("\n"), lineterm=""))
        for before, after in zip(stored, printed(executed(path, folder)), strict=True)
        if before[1] != after[1]
    ]


def main() -> int:
    """Run or check all notebooks."""
    parser = argparse.ArgumentParser(description="Run the notebooks of docs/notebooks.")
    parser.add_argument("--check", action="store_true", help="compare, and write nothing")
    checking = parser.parse_args().check
    differing = 0
    for path in sorted(NOTEBOOKS.glob("*.ipynb")):
        if checking:
            found = stale(path)
            differing += bool(found)
            print(path.name, *(found or ["is up to date"]), sep="\n")
        else:
            nbformat.write(executed(path), path)
            print(path.name)
    return 1 if differing else 0


if __name__ == "__main__":
    sys.exit(main())
