"""`tsplan parse`: what a formula means, in every form it takes."""

from __future__ import annotations

from typing import TYPE_CHECKING

from tsplan import logic
from tsplan.cli.arguments import Exit
from tsplan.cli.formula_inputs import formula_of
from tsplan.cli.output import say
from tsplan.errors import FormulaError, InputError
from tsplan.logic.text import operator_text

if TYPE_CHECKING:
    import argparse
    from collections.abc import Iterator

DEEPEST_INDENT = 40
_SIGNS = "FGUR&|!<=>"


def run(options: argparse.Namespace) -> Exit:
    """Print a formula's tree, text, horizon, positive normal form and, for CaTL, its MTL."""
    formula = formula_of(options)
    rows = [
        ("text", str(formula)),
        ("horizon", str(logic.horizon(formula))),
        ("positive", _positive(formula)),
    ]
    if options.language == "catl":
        rows.append(("mtl", str(logic.translate(formula))))
    say("tree")
    for line in tree(formula):
        say(f"  {line}")
    for name, text in rows:
        say(f"{name:<10}{text}")
    return Exit.DONE


def _positive(formula: logic.Formula) -> str:
    try:
        return str(logic.positive(logic.translate(formula)))
    except FormulaError as error:
        raise InputError(error.findings) from None


def tree(formula: logic.Formula) -> Iterator[str]:
    r"""One line a node, indented by its depth.

    >>> from tsplan.logic import parse
    >>> print("\n".join(tree(parse("F[0,2] a &&^[1, 3] !b", "wmtl"))))
    and ^[1, 3]
      eventually [0,2]
        a
      not
        b
    """
    stack: list[tuple[int, logic.Formula]] = [(0, formula)]
    while stack:
        depth, node = stack.pop()
        yield "  " * min(depth, DEEPEST_INDENT) + _headline(node)
        stack.extend((depth + 1, child) for child in reversed(node.children))


def _headline(node: logic.Formula) -> str:
    if not node.children:
        return str(node)
    sign = operator_text(node)
    after = sign.lstrip(_SIGNS)  # the window and the weights
    return f"{type(node).__name__.lower()} {after}".rstrip()
