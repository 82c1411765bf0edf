"""A document with parts of others in it, each of which keeps its own file, line and column."""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass, replace

from tsplan.document.document import Document, Path
from tsplan.document.yaml_nodes import Node
from tsplan.errors import Finding


@dataclass(frozen=True)
class Patchwork:
    r"""A document, and the sources whose texts follow each other in its content.

    So every part is read as if all of it stood in one file; `placed` says where it truly stands.
    Its digest stays that of the first document. `sources` has each source with the number of lines
    and of characters before it.

    >>> from tsplan.document import parse_document
    >>> mission = parse_document("team: [{count: 2}]", "mission.yaml")
    >>> sweep = parse_document("counts:\n- 3", "sweep.yaml")
    >>> patched = Patchwork.of(mission).with_part(("team", 0, "count"), sweep, ("counts", 0))
    >>> patched.document.data
    {'team': [{'count': 3}]}
    >>> finding = patched.document.finding(("team", 0, "count"), "too many", "take less")
    >>> [str(item) for item in patched.placed([finding])]
    ['sweep.yaml:2:3: too many; take less']
    """

    document: Document
    sources: tuple[tuple[str, int, int], ...]

    @classmethod
    def of(cls, document: Document, path: Path = ()) -> Patchwork:
        """A document, or what it has at a path, with nothing in it that is not its own."""
        if path:
            root = document.node(path)
            document = replace(document, data=root.value, root=root)
        return cls(document, ((document.source, 0, 0),))

    def with_part(self, path: Path, other: Document, at: Path) -> Patchwork:
        """Itself with what `other` has at a path in place of what it has at its own.

        A key of a mapping may be new. Raises KeyError where nothing else is there.
        """
        known = {source: (lines, before) for source, lines, before in self.sources}
        content, sources = self.document.content, self.sources
        if other.source not in known:
            content += "\n"
            known[other.source] = content.count("\n"), len(content)
            sources = (*sources, (other.source, *known[other.source]))
            content += other.content
        part = _shifted(other.node(at), *known[other.source], {})
        root = _replaced(self.document.root, path, part)
        made = replace(self.document, data=root.value, content=content, root=root)
        return Patchwork(made, sources)

    def placed(self, findings: Iterable[Finding]) -> list[Finding]:
        """Findings of the document at their places in the files of its parts."""
        return [self._placed(finding) for finding in findings]

    def _placed(self, finding: Finding) -> Finding:
        line = finding.line
        if finding.source != self.document.source or line is None:
            return finding
        own = [(source, lines) for source, lines, _ in self.sources if lines < line]
        source, lines = own[-1]
        return replace(finding, source=source, line=line - lines)


def _replaced(node: Node, path: Path, part: Node) -> Node:
    """A node with another one at a path; what is not on the way is shared."""
    if not path:
        return part
    step, rest = path[0], path[1:]
    below = node.children
    if isinstance(below, dict) and isinstance(step, str) and (step in below or not rest):
        child = _replaced(below[step], rest, part) if step in below else part
        keys = dict(node.keys or {})
        keys.setdefault(step, (part.line, part.column))
        children, value = {**below, step: child}, {**node.value, step: child.value}
        return replace(node, value=value, children=children, keys=keys)
    if isinstance(below, list) and isinstance(step, int) and 0 <= step < len(below):
        items = [*below]
        items[step] = _replaced(items[step], rest, part)
        return replace(node, value=[item.value for item in items], children=items)
    raise KeyError(path)


def _shifted(node: Node, lines: int, before: int, made: dict[int, Node]) -> Node:
    """A node whose text stands after so many lines and characters; shared ones stay shared."""
    if id(node) in made:
        return made[id(node)]
    children, keys = node.children, node.keys
    if isinstance(children, dict):
        children = {key: _shifted(child, lines, before, made) for key, child in children.items()}
    elif isinstance(children, list):
        children = [_shifted(child, lines, before, made) for child in children]
    if keys is not None:
        keys = {key: (line + lines, column) for key, (line, column) in keys.items()}
    start, end = node.start + before, node.end + before
    moved = replace(
        node, line=node.line + lines, start=start, end=end, children=children, keys=keys
    )
    made[id(node)] = moved
    return moved
