"""Decimal numbers that a file writes with more digits than are kept of them."""

from __future__ import annotations

from typing import TYPE_CHECKING

from tsplan.exact import digits, is_lost

if TYPE_CHECKING:
    from collections.abc import Iterator

    from tsplan.document.document import Document, Path
    from tsplan.errors import Finding


def lost_digits(document: Document, path: Path, number: float | None) -> Iterator[Finding]:
    """A finding where the number at a path is written with digits that get lost."""
    text = None if number is None else document.text(path)
    if number is None or text is None or not is_lost(text, number):
        return
    what = f"{path[-1]}: {text} has more digits than are kept"
    yield document.finding(path, what, f"write {digits(number)}")
