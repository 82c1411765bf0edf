"""From a JSON text to nodes that know their places, as YAML's are made.

JSON is nearly YAML, but not where lines are indented by tabs, and not in what is said of a mistake.
The grammar is that of RFC 8259; numbers and words mean what they mean in YAML.
"""

from __future__ import annotations

import re
from bisect import bisect_right
from itertools import accumulate
from json import JSONDecodeError
from json.decoder import scanstring  # type: ignore[attr-defined]  # as json itself uses it
from typing import Any

from tsplan.document.compose import DEEPEST, TOO_DEEP
from tsplan.document.pause import collector_paused
from tsplan.document.scalars import resolve
from tsplan.document.yaml_nodes import Node
from tsplan.errors import Finding, InputError

_BEGINNING = re.compile(r"\s*(\{\s*[\"}]|\[\s*[\[\]{\"\d-])")
_SPACE = re.compile(r"[ \t\n\r]*")
_PLAIN = re.compile(r"-?(?:0|[1-9]\d*)(?:\.\d+)?(?:[eE][+-]?\d+)?|true|false|null")


def may_be_json(text: str) -> bool:
    """Whether a text begins as one in JSON does."""
    return _BEGINNING.match(text) is not None


@collector_paused()
def json_nodes(text: str, source: str) -> Node:
    """The node tree of a JSON text.

    Raises
    ------
    JSONDecodeError
        The text is no JSON; it may still be YAML.
    InputError
        Keys that appear twice, or nesting beyond what YAML's may be.

    """
    reader = _Reader(text, source)
    node, at = reader.value(reader.next(0), 1)
    if (rest := reader.next(at)) < len(text):
        raise JSONDecodeError("the text goes on after its end", text, rest)
    if reader.findings:
        raise InputError(reader.findings)
    return node


class _Reader:
    def __init__(self, text: str, source: str) -> None:
        self._text, self._source = text, source
        self._lines = [0, *accumulate(len(line) + 1 for line in text.split("\n"))]
        self.findings: list[Finding] = []

    def next(self, at: int) -> int:
        """Where the next character is that is no white space."""
        found = _SPACE.match(self._text, at)
        return at if found is None else found.end()

    def value(self, at: int, depth: int) -> tuple[Node, int]:
        """The value that begins at an offset, and where it ends."""
        if depth > DEEPEST:
            raise InputError([Finding(*TOO_DEEP, self._source, *self._place(at))])
        char = self._text[at : at + 1]
        if char == "{":
            return self._object(at, depth)
        if char == "[":
            return self._array(at, depth)
        if char == '"':
            text, end = self._string(at)
            return Node(text, *self._place(at), at, end, None, text, '"', flow=depth > 1), end
        found = _PLAIN.match(self._text, at)
        if found is None:
            raise JSONDecodeError("a value is expected", self._text, at)
        text, end = found.group(), found.end()
        return Node(resolve(text), *self._place(at), at, end, text=text, flow=depth > 1), end

    def _string(self, at: int) -> tuple[str, int]:
        found: tuple[str, int] = scanstring(self._text, at + 1, True)
        return found

    def _place(self, at: int) -> tuple[int, int]:
        line = bisect_right(self._lines, at)
        return line, at - self._lines[line - 1] + 1

    def _object(self, start: int, depth: int) -> tuple[Node, int]:
        node = Node({}, *self._place(start), start, start, children={}, keys={})
        at = self.next(start + 1)
        if self._text[at : at + 1] == "}":
            return self._closed(node, at)
        while True:
            if self._text[at : at + 1] != '"':
                raise JSONDecodeError("a key in double quotes is expected", self._text, at)
            begins = at
            key, at = self._string(at)
            at = self.next(at)
            if self._text[at : at + 1] != ":":
                raise JSONDecodeError("':' is expected", self._text, at)
            child, at = self.value(self.next(at + 1), depth + 1)
            node.size += child.size + 1
            self._put(node, key, child, begins)
            at = self.next(at)
            if self._text[at : at + 1] == "}":
                return self._closed(node, at)
            at = self._after_comma(at, "}")

    def _put(self, node: Node, key: str, child: Node, at: int) -> None:
        assert node.keys is not None
        if key in node.keys:
            what = f"the key '{key}' appears twice, first in line {node.keys[key][0]}"
            self.findings.append(Finding(what, "keep one of them", self._source, *self._place(at)))
        else:
            node.put(key, child, self._place(at))

    def _array(self, start: int, depth: int) -> tuple[Node, int]:
        children: list[Node] = []
        node = Node([], *self._place(start), start, start, children=children)
        at = self.next(start + 1)
        if self._text[at : at + 1] == "]":
            return self._closed(node, at)
        while True:
            child, at = self.value(at, depth + 1)
            node.size += child.size
            node.value.append(child.value)
            children.append(child)
            at = self.next(at)
            if self._text[at : at + 1] == "]":
                return self._closed(node, at)
            at = self._after_comma(at, "]")

    def _closed(self, node: Node, at: int) -> tuple[Node, int]:
        node.end = at + 1
        return node, at + 1

    def _after_comma(self, at: int, end: str) -> int:
        if self._text[at : at + 1] != ",":
            raise JSONDecodeError(f"',' or '{end}' is expected", self._text, at)
        return self.next(at + 1)


def json_finding(error: Any, source: str) -> Finding:
    """What keeps a text from being JSON, and where."""
    message = str(error.msg).removesuffix(" at")
    what = f"not valid JSON: {message[:1].lower()}{message[1:]}"
    return Finding(what, "look at the punctuation here", source, error.lineno, error.colno)
