"""What YAML makes of a text that was meant otherwise, said in a sentence.

Formulas are full of characters that mean something to YAML: a leading `!` is a tag, `&` an anchor,
`*` an alias, ` #` a comment, `, ` inside braces the next entry, and a backslash in double quotes an
escape. The words of the YAML library are no help there, and differ from release to release, so
nothing here looks at them: only the character at which reading stopped counts.
"""

from __future__ import annotations

from tsplan.document.yaml_nodes import Node

Words = tuple[str, str]

# keys below which a text is a formula
FORMULA_KEYS = frozenset({"formula", "must", "prefer", "spec"})
QUOTES = "put the whole {what} in quotes, as in '...', or on a line of its own after a bar |"

_TAKEN = {
    "!": "YAML takes '!' at the beginning for a tag",
    "&": "YAML takes '&' at the beginning of a word for an anchor",
    "*": "YAML takes '*' at the beginning for the name of an anchor",
    "[": "YAML takes this '[' for the beginning of a list",
    "{": "YAML takes this '{' for the beginning of a mapping",
    "@": "no text may begin with '@' in YAML",
    "`": "no text may begin with '`' in YAML",
    "%": "no text may begin with '%' in YAML",
    "|": "after '|', YAML begins a text on the next line",
    ">": "after '>', YAML begins a text on the next line",
    '"': "this quote is never closed",
    "'": "this quote is never closed",
}
_IN_FLOW = "inside { } and [ ], YAML ends a text without quotes at commas and brackets"
_LINES = "write the {what} on the next line, further to the right, or put it in quotes"


def quoted(what: str) -> str:
    """The remedy for a text that YAML takes apart; `what` is a formula or a text."""
    return QUOTES.format(what=what)


def stopped(text: str, at: int, began: int | None, *, flow: bool, what: str) -> Words | None:
    """Why reading stopped at offset `at`, inside something that began at `began`, if known.

    `flow` says that it stopped inside braces or brackets.
    """
    if "\\" in (text[at : at + 1], text[at - 1 : at]) and began is not None:
        sign = text[text.rindex("\\", 0, at + 1) :][:2]
        remedy = f"put the {what} in single quotes, where a backslash is nothing special"
        return f"inside double quotes, YAML knows no '{sign}'", remedy
    here = text[at : at + 1]
    if flow and here in ("[", "{", "]", "}"):
        return _IN_FLOW, quoted(what)
    line = text[text.rfind("\n", 0, at) + 1 : at]
    if here == ":" and ": " in line:
        return "YAML takes a second ': ' in a line for another key", quoted(what)
    sign = text[began : began + 1] if began is not None and began <= at else ""
    for taken in (sign, here):
        if taken in _TAKEN and taken:
            return _TAKEN[taken], (_LINES.format(what=what) if taken in "|>" else quoted(what))
    return None


def cut(node: Node, content: str) -> Words | None:
    """What YAML took away from a formula that cannot be read as it stands, if it did.

    `content` is the text of the document.
    """
    if node.style == '"' and "\\" in content[node.start : node.end]:
        remedy = "put the formula in single quotes, where a backslash is nothing special"
        return "inside double quotes, YAML takes a backslash for an escape: '/\\' is lost", remedy
    rest = content[node.end :].lstrip(" \t")
    if node.style or not rest:
        return None
    if rest[0] == "#":
        return "YAML takes ' #' for a comment, so the formula ends before it", quoted("formula")
    if node.flow and rest[0] in ",:[]{}":
        return _IN_FLOW, quoted("formula")
    return None


def loses_end(node: Node, around: Node, content: str) -> bool:
    """Whether YAML made a key of what follows a comma in a formula inside braces.

    Such a key has no value and no colon: `{formula: a && b, c}`.
    """
    if node.style or not node.flow or not isinstance(around.children, dict):
        return False
    return any(
        other.text == "" and other.start > node.end and content[: other.start].rstrip()[-1:] != ":"
        for other in around.children.values()
    )
