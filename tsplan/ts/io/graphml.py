"""Graphs in GraphML: read into the same document as node-link JSON is, with the places in the XML.

The format is that of http://graphml.graphdrawing.org/specification.html: keys with types, nodes,
edges and their data. Hyperedges are refused; what stands below data, as yEd's graphics, is not
looked at.
"""

from __future__ import annotations

import re
from dataclasses import dataclass, field
from typing import Any
from xml.parsers import expat

from tsplan.document import Document
from tsplan.document.document import document_of
from tsplan.document.scalars import resolve
from tsplan.document.yaml_nodes import Node
from tsplan.errors import Finding, InputError

TAG = "!graphml"
_BEGINNING = re.compile(  # what is matched once is not tried in another way
    r"\s*(?><\?xml.*?\?>)?\s*(?><!--.*?-->\s*|<!DOCTYPE\s[^>\[]*(?>\[.*?\]\s*)?>\s*)*"
    r"<(\w+:)?graphml\b",
    re.DOTALL,
)
_NUMBERS = ("int", "long", "float", "double")
_OWN = ("id", "source", "target", "directed")  # what elements say of themselves
_TRUTHS = {"true": True, "1": True, "false": False, "0": False}


@dataclass
class _Key:
    """What a key of data is called, and of which type its values are."""

    name: str
    kind: str
    default: str | None = None


_STRING = _Key("", "string")


@dataclass
class _Reader:
    """Takes in the events of the XML parser: a list of nodes, and one of links."""

    source: str
    parser: Any
    directed: Node | None = None
    items: dict[str, list[Node]] = field(default_factory=lambda: {"node": [], "edge": []})
    keys: dict[str, tuple[str, _Key]] = field(default_factory=dict)
    findings: list[Finding] = field(default_factory=list)
    _open: list[tuple[str, Node | None]] = field(default_factory=list)
    _text: list[str] = field(default_factory=list)
    _data: tuple[str, tuple[int, int]] | None = None  # the key of data that is read, and its place

    def place(self) -> tuple[int, int]:
        """Where the parser is."""
        return self.parser.CurrentLineNumber, self.parser.CurrentColumnNumber + 1

    def refuse(self, message: str, remedy: str, place: tuple[int, int]) -> None:
        """Keep one more finding."""
        self.findings.append(Finding(message, remedy, self.source, *place))

    def begin(self, name: str, attributes: dict[str, str]) -> None:
        """An element begins."""
        name, node, place = name.rpartition(":")[2], None, self.place()
        if name == "key":
            given = attributes.get("id", "")
            kind = attributes.get("attr.type", "string")
            key = _Key(attributes.get("attr.name", given), kind)
            self.keys[given] = (attributes.get("for", "all"), key)
            name = given  # by which its default finds it
        elif name == "graph" and self.directed is None:
            self.directed = _scalar(attributes.get("edgedefault") != "undirected", place)
        elif name in self.items:
            node = self._item(name, attributes)
        elif name == "hyperedge":
            self.refuse("this is a hyperedge", "write an edge for each of its pairs", place)
        elif name == "data":
            self._data = (attributes.get("key", ""), place)
        self._text = []
        self._open.append((name, node))

    def _item(self, name: str, attributes: dict[str, str]) -> Node:
        """A node or an edge, with the defaults of its keys."""
        place = self.place()
        node = _mapping(place)
        for word in ("id",) if name == "node" else ("source", "target"):
            if word in attributes:
                node.put(word, _scalar(attributes[word], place), place)
            else:
                self.refuse(f"this {name} has no {word}", f"write {word}='...'", place)
        if name == "edge" and "directed" in attributes:
            node.put("directed", _scalar(attributes["directed"] == "true", place), place)
        for part, key in self.keys.values():
            if key.default is not None and part in (name, "all"):
                self._put(node, key, key.default, place)
        self.items[name].append(node)
        return node

    def text(self, data: str) -> None:
        """Characters of an element."""
        self._text.append(data)

    def end(self, name: str) -> None:
        """An element ends."""
        self._open.pop()
        name, text = name.rpartition(":")[2], "".join(self._text).strip()
        if name == "default" and self._open:
            self.keys.get(self._open[-1][0], ("", _STRING))[1].default = text
        elif name == "data" and self._data is not None:
            (given, place), self._data = self._data, None
            owner = next((node for _, node in reversed(self._open) if node is not None), None)
            if owner is not None and given in self.keys:
                self._put(owner, self.keys[given][1], text, place)
            elif owner is not None:
                self.refuse(f"no key has the id '{given}'", "declare it as <key>", place)
        self._text = []

    def _put(self, owner: Node, key: _Key, text: str, place: tuple[int, int]) -> None:
        """Give a node or an edge the value of a key; a later one takes the place of a default."""
        if key.name in _OWN:
            return
        value: Any = text
        if key.kind in _NUMBERS:
            value = resolve(text)
            if isinstance(value, str | bool) or value is None:
                what = f"{key.name}: '{text}' is not of the type {key.kind}"
                self.refuse(what, "write a number", place)
                return
        elif key.kind == "boolean":
            value = _TRUTHS.get(text.lower(), text)
        owner.put(key.name, _scalar(value, place, text), place)

    def tree(self) -> Node:
        """All that was read, as node-link JSON has it."""
        root = _mapping((1, 1))
        root.tag = TAG
        for key, items in (("nodes", self.items["node"]), ("links", self.items["edge"])):
            listed = Node([item.value for item in items], 1, 1, 0, 0, children=[*items])
            root.put(key, listed, (1, 1))
        root.put("directed", self.directed or _scalar(value=True, place=(1, 1)), (1, 1))
        return root


def _mapping(place: tuple[int, int]) -> Node:
    return Node({}, *place, 0, 0, children={}, keys={})


def _scalar(value: Any, place: tuple[int, int], text: str | None = None) -> Node:
    return Node(value, *place, 0, 0, text=str(value) if text is None else text)


def open_graphml(text: str, source: str) -> Document | None:
    """A graph in GraphML as a document of nodes and links; None for any other text.

    Raises
    ------
    InputError
        The XML is broken, or what it says is no graph: all that is wrong, each with its place.

    """
    if _BEGINNING.match(text) is None:
        return None
    parser = expat.ParserCreate("utf-8")
    reader = _Reader(source, parser)
    parser.StartElementHandler = reader.begin
    parser.EndElementHandler = reader.end
    parser.CharacterDataHandler = reader.text
    parser.EntityDeclHandler = _no_entities(reader)
    try:
        parser.Parse(text.encode(), True)
    except expat.ExpatError as error:
        what = f"not valid XML: {expat.ErrorString(error.code)}"
        place = error.lineno, error.offset + 1
        last = Finding(what, "look at the tags here", source, *place)
        raise InputError([*reader.findings, last]) from None
    if reader.findings:
        raise InputError(reader.findings)
    return document_of(reader.tree(), text, source)


def _no_entities(reader: _Reader) -> Any:
    """Entities may grow without end, and graphs need none."""

    def declared(*_: object) -> None:
        where = reader.place()
        raise InputError(
            [Finding("XML entities are not read", "remove them", reader.source, *where)]
        )

    return declared
