"""From the events of the YAML parser to nodes, without recursion and without running any code.

Three things are bounded, so that no file can exhaust the machine: how deep collections nest, how
much aliases multiply, and which tags are understood (an unknown tag is a finding, never a call).
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

import yaml
from yaml import events

from tsplan.document.mishaps import FORMULA_KEYS, quoted, stopped
from tsplan.document.pause import collector_paused
from tsplan.document.scalars import STANDARD, TAGS, resolve
from tsplan.document.yaml_nodes import SET, TUPLE, Node
from tsplan.errors import Finding, InputError, in_order
from tsplan.words import nfc

DEEPEST = 50
TOO_DEEP = (f"nested deeper than {DEEPEST} levels", "use a flatter structure")
MOST_FROM_ALIASES = 100_000

MERGE = "<<"
_COLLECTIONS = frozenset({"!", SET, TUPLE, "!Ts", "!Model"}) | {
    STANDARD + word for word in ("map", "seq", "omap", "python/dict", "python/list")
}
_Loader: Any = getattr(yaml, "CSafeLoader", yaml.SafeLoader)


@dataclass(slots=True, eq=False)
class _Open:
    """A collection whose end has not been seen; `key` waits for its value."""

    node: Node
    anchor: str | None
    flow: bool
    key: Node | None = None
    merged: list[Node] | None = None


class Composer:
    """Builds the node tree of one text; see `compose`."""

    def __init__(self, source: str) -> None:
        self.source = source
        self.findings: list[Finding] = []
        self.root: Node | None = None
        self._stack: list[_Open] = []
        self._anchors: dict[str, Node | None] = {}
        self.unused: dict[str, Finding] = {}  # anchors of formulas to which no alias refers yet
        self._copied = 0

    def take(self, event: Any) -> None:
        """Take in the next event."""
        kind = type(event)
        if kind is events.ScalarEvent:
            self._place(self._scalar(event), event.anchor)
        elif kind is events.MappingStartEvent or kind is events.SequenceStartEvent:
            self._begin(event, mapping=kind is events.MappingStartEvent)
        elif kind is events.MappingEndEvent or kind is events.SequenceEndEvent:
            done = self._stack.pop()
            self._merge(done)
            done.node.end = event.end_mark.index
            self._place(done.node, done.anchor)
        elif kind is events.AliasEvent:
            self._alias(event)
        elif kind is events.DocumentStartEvent and self.root is not None:
            raise self._stop("the file holds more than one document", "keep one", event.start_mark)

    @property
    def flow(self) -> bool:
        """Whether the next value stands inside braces or brackets."""
        return bool(self._stack) and self._stack[-1].flow

    @property
    def what(self) -> str:
        """What the next text is, in words: a formula or just a text."""
        keys = {opened.key.text for opened in self._stack if opened.key is not None}
        return "formula" if keys & FORMULA_KEYS else "text"

    def _stop(self, message: str, remedy: str, mark: Any) -> InputError:
        last = Finding(message, remedy, self.source, mark.line + 1, mark.column + 1)
        return InputError([*self.findings, last])

    def _finding(self, node: Node, message: str, remedy: str) -> Finding:
        return Finding(message, remedy, self.source, node.line, node.column)

    def _report(self, node: Node, message: str, remedy: str) -> None:
        self.findings.append(self._finding(node, message, remedy))

    def _scalar(self, event: Any) -> Node:
        mark, end, text, tag = event.start_mark, event.end_mark.index, nfc(event.value), event.tag
        node = Node(text, mark.line + 1, mark.column + 1, mark.index, end, tag, text, event.style)
        node.flow = self.flow
        if tag in TAGS:
            try:
                node.value = TAGS[tag](text)
            except ValueError:
                self._report(node, f"'{text}' does not fit its tag", "drop the tag")
        elif tag is not None:
            self._tagged(node)
        elif event.implicit[0]:
            node.value = resolve(text)
        if event.anchor is not None and self.what == "formula":
            message = f"YAML takes '&{event.anchor}' for an anchor, and only '{text}' is left"
            self.unused[event.anchor] = self._finding(node, message, quoted("formula"))
        return node

    def _tagged(self, node: Node) -> None:
        """A word with an exclamation mark: not accepted as a tag, and hardly ever meant as one."""
        shown, text = str(node.tag).replace(STANDARD, "!!"), node.text or ""
        formula = self.what == "formula" and node.tag == "!"
        if (node.text is None and not formula) or (shown.startswith("!!") and text):
            self._report(node, f"the tag '{shown}' is not accepted", "write plain data")
            return
        left = f", and only '{text}' is left" if text else ""
        remedy = f"put the {self.what} in quotes: '{f'{shown} {text}'.rstrip()}'"
        self._report(node, f"YAML takes '{shown}' for a tag{left}", remedy)

    def _begin(self, event: Any, *, mapping: bool) -> None:
        mark, tag = event.start_mark, event.tag
        if len(self._stack) >= DEEPEST:
            raise self._stop(*TOO_DEEP, mark)
        node = Node([], mark.line + 1, mark.column + 1, mark.index, mark.index, tag, children=[])
        if mapping:
            node.value, node.children, node.keys = {}, {}, {}
        if tag is not None and (tag not in _COLLECTIONS or (tag == "!" and self.what == "formula")):
            self._tagged(node)
        if event.anchor is not None:
            self._anchors[event.anchor] = None
        self._stack.append(_Open(node, event.anchor, bool(event.flow_style)))

    def _alias(self, event: Any) -> None:
        self.unused.pop(event.anchor, None)
        if event.anchor not in self._anchors:
            formula = self.what == "formula"
            remedy = quoted("formula") if formula else "define its anchor first"
            raise self._stop(f"'*{event.anchor}' refers to nothing", remedy, event.start_mark)
        target = self._anchors[event.anchor]
        if target is None:
            raise self._stop(
                f"'*{event.anchor}' contains itself", "write the value out", event.start_mark
            )
        self._copied += target.size
        if self._copied > MOST_FROM_ALIASES:
            raise self._stop(
                f"aliases multiply to more than {MOST_FROM_ALIASES} values",
                "write the values out",
                event.start_mark,
            )
        self._place(target, None)

    def _place(self, node: Node, anchor: str | None) -> None:
        """Put a finished node into the collection that is open."""
        if anchor is not None:
            self._anchors[anchor] = node
        if not self._stack:
            self.root = node.as_list()
            return
        top = self._stack[-1]
        if isinstance(top.node.children, list):
            node = node.as_list()
            top.node.size += node.size
            top.node.value.append(node.value)
            top.node.children.append(node)
        elif top.key is None:
            top.key = node
        else:
            self._entry(top, top.key, node.as_list())
            top.key = None

    def _entry(self, top: _Open, key_node: Node, node: Node) -> None:
        key, keys = self._key(key_node), top.node.keys or {}
        top.node.size += node.size + 1
        if key == MERGE and not key_node.style:
            if top.merged is None:
                top.merged = self._sources(key_node, node)
            else:
                remedy = f"name all in one list, {MERGE}: [*one, *two]"
                self._report(key_node, f"the key '{MERGE}' appears twice", remedy)
        elif key in keys:
            what = f"the key '{key}' appears twice, first in line {keys[key][0]}"
            self._report(key_node, what, "keep one of them")
        else:
            top.node.put(key, node, (key_node.line, key_node.column))

    def _sources(self, key: Node, node: Node) -> list[Node]:
        """The mappings that a merge key names, the one that wins first."""
        several = isinstance(node.children, list)
        sources = list(node.children) if isinstance(node.children, list) else [node]
        wrong = [source for source in sources if not isinstance(source.children, dict)]
        if wrong or not sources:
            at = wrong[0] if wrong and several else key
            what = f"'{MERGE}' takes in the entries of mappings, and this is none"
            self._report(at, what, f"write {MERGE}: *name or {MERGE}: [*one, *two]")
            return []
        return sources

    def _merge(self, top: _Open) -> None:
        """Take in what merge keys name: https://yaml.org/type/merge.html.

        An entry that the mapping has itself wins, then the first mapping that has it. What is
        taken in keeps its place, so that findings point at where it is written.
        """
        for source in top.merged or ():
            assert isinstance(source.children, dict)
            for key, child in source.children.items():
                if key not in (top.node.keys or ()):
                    top.node.put(key, child, (source.keys or {})[key])

    def _key(self, node: Node) -> str:
        """The text of a key; a sequence of scalars (a tuple in Python) is written `(a, b)`."""
        if node.text is not None:
            return node.text
        if isinstance(node.children, list) and all(c.text is not None for c in node.children):
            return "(" + ", ".join(str(child.text) for child in node.children) + ")"
        self._report(node, "a key cannot be a collection", "use a word")
        return ""


def compose(text: str, source: str) -> Node:
    """The node tree of a YAML text.

    Raises
    ------
    InputError
        With every duplicate key and unknown tag, or with the one place where reading had to stop:
        wrong syntax, nesting beyond `DEEPEST`, aliases beyond `MOST_FROM_ALIASES` values.

    """
    composer = Composer(source)
    try:
        loader = _Loader(text)
        try:
            with collector_paused():
                while loader.check_event():
                    composer.take(loader.get_event())
        finally:
            loader.dispose()
    except yaml.MarkedYAMLError as error:
        raise InputError([*composer.findings, _syntax(error, text, composer)]) from None
    except yaml.YAMLError as error:
        raise InputError([*composer.findings, _character(error, text, source)]) from None
    findings = [*composer.findings, *composer.unused.values()]
    if findings:
        raise InputError(in_order(findings))
    return composer.root or Node(None, 1, 1, 0, 0, text="")


def _syntax(error: yaml.MarkedYAMLError, text: str, composer: Composer) -> Finding:
    """Where reading had to stop, and what YAML took the text there for."""
    mark = error.problem_mark or error.context_mark
    place = (mark.line + 1, mark.column + 1) if mark else (None, None)
    words = ", ".join(part for part in (error.context, error.problem) if part)
    message, remedy = words, "look at the punctuation and the indentation here"
    if mark and _unclosed(text[: _offset(text, mark)]) >= DEEPEST:
        return Finding(*TOO_DEEP, composer.source, *place)  # the library has a limit of its own
    if mark:
        began = None if error.context_mark is None else _offset(text, error.context_mark)
        known = stopped(text, _offset(text, mark), began, flow=composer.flow, what=composer.what)
        message, remedy = known or (message, remedy)
    return Finding(f"not valid YAML: {message}", remedy, composer.source, *place)


def _unclosed(text: str) -> int:
    """How many braces and brackets are open at the end of a text, quotes not looked at."""
    return sum(map(text.count, "[{")) - sum(map(text.count, "]}"))


def _offset(text: str, mark: Any) -> int:
    """The offset of a mark, by its line and column."""
    lines = text.split("\n")
    return sum(len(line) + 1 for line in lines[: mark.line]) + int(mark.column)


def _character(error: yaml.YAMLError, text: str, source: str) -> Finding:
    """A character that YAML does not allow; the C parser counts its place in bytes."""
    for number, line in enumerate(text.split("\n"), start=1):
        for column, char in enumerate(line, start=1):
            if not char.isprintable() and char not in "\t\r\x85\ufeff\u2028\u2029":
                what = f"the character U+{ord(char):04X} is not allowed in YAML"
                return Finding(what, "remove it", source, number, column)
    return Finding(f"not valid YAML: {str(error).splitlines()[0]}", "", source)
