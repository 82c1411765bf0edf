"""The values of a YAML document as a tree, each with its place."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

from tsplan.document.scalars import STANDARD

SET = STANDARD + "set"
TUPLE = STANDARD + "python/tuple"


@dataclass(slots=True, eq=False)
class Node:
    """One value of a document, with its place (from 1) and its children.

    `children` follows `value`: a dict or list of nodes, None for scalars. `text` is a scalar's
    own text; `start` and `end` are offsets into the document's text; `keys` holds the places of a
    mapping's keys, None for others. `size` counts the nodes below, aliases expanded. `flow` says
    that a scalar stands inside braces or brackets.
    """

    value: Any
    line: int
    column: int
    start: int
    end: int
    tag: str | None = None
    text: str | None = None
    style: str | None = None
    children: dict[str, Node] | list[Node] | None = None
    keys: dict[str, tuple[int, int]] | None = None
    size: int = 1
    flow: bool = False

    def put(self, key: str, child: Node, place: tuple[int, int]) -> None:
        """Take in an entry of a mapping, whose key stands at a place."""
        assert isinstance(self.children, dict)
        assert self.keys is not None
        self.children[key], self.value[key], self.keys[key] = child, child.value, place

    def as_list(self) -> Node:
        """Itself; a `!!set` as the list of its members."""
        if self.tag == SET and isinstance(self.children, dict):
            places = (self.keys or {}).items()
            self.children = [Node(key, *at, self.start, self.end, text=key) for key, at in places]
            self.value = [child.value for child in self.children]
        return self
