"""The text of a formula, and the places in it."""

from __future__ import annotations

from bisect import bisect_right

from tsplan.errors import Finding

_CLIP = 48  # characters of a part that a message quotes at most


class Source:
    """A text whose offsets can be told as lines and columns, both from 1."""

    def __init__(self, text: str) -> None:
        self.text = text
        ends = (place for place, character in enumerate(text, start=1) if character == "\n")
        self._starts = [0, *ends]

    def position(self, offset: int) -> tuple[int, int]:
        """Line and column of a character."""
        line = bisect_right(self._starts, offset)
        return line, offset - self._starts[line - 1] + 1

    def quote(self, start: int, stop: int) -> str:
        """The text from `start` to `stop` inclusive, on one line and not too long."""
        words = " ".join(self.text[start : stop + 1].split())
        return words if len(words) <= _CLIP else f"{words[: _CLIP - 4]} ..."

    def finding(self, offset: int, message: str, remedy: str = "") -> Finding:
        """A finding at a character."""
        line, column = self.position(offset)
        return Finding(message, remedy, line=line, column=column)
