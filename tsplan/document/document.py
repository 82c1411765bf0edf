"""A YAML document whose every part knows its place in the file."""

from __future__ import annotations

import hashlib
import pathlib
from dataclasses import dataclass, field
from json import JSONDecodeError
from typing import Any, TypeAlias

from tsplan.document import mishaps
from tsplan.document.compose import compose
from tsplan.document.files import read_text
from tsplan.document.json_text import json_finding, json_nodes, may_be_json
from tsplan.document.kinds import kind_of_data, kind_of_text, remedy_for
from tsplan.document.yaml_nodes import Node
from tsplan.errors import Finding, InputError
from tsplan.exact import digits, is_lost
from tsplan.words import nfc

Path: TypeAlias = tuple[str | int, ...]

LARGEST_FILE = 64 * 1024 * 1024  # bytes


@dataclass(frozen=True)
class Document:
    """What a YAML text says, and where.

    `data` is made of dict, list, str, int, float, bool and None only; the keys of its dicts are
    the text of the keys. A path is a tuple of keys and list positions from the root. Lines and
    columns count from 1.

    >>> document = parse_document("team: [{count: two}]", "mission.yaml")
    >>> document.place(("team", 0, "count"))
    (1, 16)
    >>> str(document.finding(("team", 0, "count"), "not a number", "write 2"))
    'mission.yaml:1:16: not a number; write 2'
    """

    data: Any
    source: str
    digest: str
    content: str = field(repr=False, compare=False)
    root: Node = field(repr=False, compare=False)

    def _nearest(self, path: Path) -> tuple[Node, int]:
        """The node at a path or its nearest ancestor, and how many steps of the path lead to it."""
        node = self.root
        for depth, step in enumerate(path):
            children = node.children
            if isinstance(children, dict) and step in children:
                node = children[str(step)]
            elif isinstance(children, list) and isinstance(step, int) and step < len(children):
                node = children[step]
            else:
                return node, depth
        return node, len(path)

    def node(self, path: Path) -> Node:
        """The node at a path; KeyError where there is none."""
        node, depth = self._nearest(path)
        if depth < len(path):
            raise KeyError(path)
        return node

    def at(self, path: Path) -> Any:
        """The value at a path; KeyError where there is none."""
        return self.node(path).value

    def place(self, path: Path) -> tuple[int | None, int | None]:
        """Line and column of the value at a path, or of its nearest ancestor."""
        node, _ = self._nearest(path)
        return node.line, node.column

    def key_place(self, path: Path) -> tuple[int | None, int | None]:
        """Line and column of the key that a path ends with; for a list entry, of the entry."""
        if path:
            node, depth = self._nearest(path[:-1])
            if depth == len(path) - 1 and node.keys and path[-1] in node.keys:
                return node.keys[str(path[-1])]
        return self.place(path)

    def text(self, path: Path) -> str | None:
        """A scalar exactly as written (`01` where `data` says 1); None for collections."""
        return self.node(path).text

    def span(self, path: Path) -> tuple[int, int]:
        """Offsets into `content` of the value at a path: its first character, and after its last.

        White space and comments that follow a block may be counted with it.
        """
        node = self.node(path)
        return node.start, node.end

    def finding(self, path: Path, message: str, remedy: str = "") -> Finding:
        """A finding at the place of a path."""
        return Finding(message, remedy, self.source, *self.place(path))

    def key_finding(self, path: Path, message: str, remedy: str = "") -> Finding:
        """A finding at the place of the key that a path ends with."""
        return Finding(message, remedy, self.source, *self.key_place(path))

    def misfit(self, path: Path, wanted: str) -> Finding | None:
        """The one thing to say of what is of another kind than is wanted; None where it may fit."""
        data = self.at(path)
        kind = kind_of_data(data)
        if kind is None and isinstance(data, str) and not path:
            kind = kind_of_text(self.content)
        if kind is None or kind == wanted:
            return None
        return self.finding(path, f"this is {kind}", remedy_for(kind, wanted, self.source))

    def lost_digits(self, path: Path, number: float | None) -> list[Finding]:
        """A finding where the number at a path is written with digits that get lost."""
        text = None if number is None else self.text(path)
        if number is None or text is None or not is_lost(text, number):
            return []
        what = f"{path[-1]}: {text} has more digits than are kept"
        return [self.finding(path, what, f"write {digits(number)}")]

    def cut(self, path: Path) -> list[Finding]:
        """What YAML took away from the formula at a path, with the place where; else nothing."""
        node = self.node(path)
        words = mishaps.cut(node, self.content)
        if words is None:
            return []
        at = node.start if node.style else node.end
        return [Finding(*words, self.source, *self._line_and_column(at))]

    def loses_end(self, path: Path) -> bool:
        """Whether YAML made a key of the end of the formula at a path, inside braces."""
        return mishaps.loses_end(self.node(path), self.node(path[:-1]), self.content)

    def inside(self, path: Path, line: int, column: int) -> tuple[int, int]:
        """Where line `line`, column `column` of the text of a scalar lies in the file."""
        lines = (self.text(path) or "").split("\n")
        offset = sum(len(part) + 1 for part in lines[: line - 1]) + column - 1
        return self.character(path, offset)

    def character(self, path: Path, offset: int) -> tuple[int, int]:
        """Line and column in the file of the character `offset` of the text of a scalar.

        Folding, indentation and quotes move white space only, so the place is found by counting
        the other characters. Inside double quotes, escapes are not counted exactly.
        """
        node = self.node(path)
        start = self._content_start(node)
        place = _aligned(node.text or "", offset, self.content, start, node.end)
        return self._line_and_column(place)

    def _content_start(self, node: Node) -> int:
        """Offset of a scalar's content: after its quote, or on the line after `|` or `>`."""
        if node.style in ("'", '"'):
            return node.start + 1
        if node.style not in ("|", ">"):
            return node.start
        start = self.content.find("\n", node.start) + 1
        while start < node.end and self.content[start].isspace():
            start += 1
        # leading spaces that belong to the text, beyond the indentation
        lead = (node.text or "").split("\n")[0]
        return start - (len(lead) - len(lead.lstrip()))

    def _line_and_column(self, offset: int) -> tuple[int, int]:
        before = self.content[:offset]
        return before.count("\n") + 1, offset - (before.rfind("\n") + 1) + 1


def _aligned(text: str, offset: int, content: str, start: int, end: int) -> int:
    """Offset into `content` of the character `offset` of a scalar whose content is there."""
    place, last = start, -1
    for index, char in enumerate(text[: offset + 1]):
        if char.isspace():
            continue
        at = content.find(char, place, end)
        if at < 0:
            break
        if index == offset:
            return at
        place, last = at + 1, index
    return place + max(offset - last - 1, 0)


def parse_document(text: str, source: str) -> Document:
    """A document from its text; `source` is what findings call it.

    Raises
    ------
    InputError
        Wrong YAML, duplicate keys, unknown tags, nesting or aliases beyond the bounds.

    """
    text = text.removeprefix("\ufeff")
    digest = _digest(text)
    text = nfc(text)
    root = _nodes(text, source)
    return Document(root.value, source, digest, text, root)


def document_of(root: Node, text: str, source: str) -> Document:
    """A document from the tree that somebody else made of its text."""
    return Document(root.value, source, _digest(text), text, root)


def _digest(text: str) -> str:
    return hashlib.sha256(text.encode("utf-8", "surrogatepass")).hexdigest()


def _nodes(text: str, source: str) -> Node:
    """The tree of a text in JSON or YAML."""
    broken = None
    if may_be_json(text):
        try:
            return json_nodes(text, source)
        except JSONDecodeError as error:
            broken = error
    try:
        return compose(text, source)
    except InputError:
        kind = kind_of_text(text)
        if kind is not None:
            found = Finding(f"this is {kind}", remedy_for(kind, "", source), source)
            raise InputError([found]) from None
        if broken is not None:
            raise InputError([json_finding(broken, source)]) from None
        raise


def read_document(path: str | pathlib.Path) -> Document:
    """A document from a file.

    Raises
    ------
    InputError
        The file is missing, no ordinary file, too large or not UTF-8, or as `parse_document` says.

    """
    return parse_document(read_text(path, most=LARGEST_FILE), str(path))
