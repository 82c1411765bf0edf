"""Which labels, capabilities and signals a formula speaks about."""

from __future__ import annotations

from functools import singledispatch
from typing import NamedTuple

from tsplan.logic.atoms import Count, Execution, Known, Limit, Linear, Task
from tsplan.logic.nodes import Constant, Formula, Not, Pair, Several, Switch, Whole, Window
from tsplan.logic.traversal import walk


class Names(NamedTuple):
    """The names that one node uses itself, in the order of the text."""

    labels: tuple[str, ...] = ()
    capabilities: tuple[str, ...] = ()
    variables: tuple[str, ...] = ()


def labels(formula: Formula) -> tuple[str, ...]:
    """The labels a formula counts at, each once, in the order of their first use.

    >>> from tsplan.logic import parse
    >>> labels(parse("F[0,2] b && sum(a,Vis) >= 2 && b"))
    ('b', 'a')
    """
    return tuple(dict.fromkeys(name for node in walk(formula) for name in names(node).labels))


def capabilities(formula: Formula) -> tuple[str, ...]:
    """The capabilities a formula counts, each once, in the order of their first use."""
    return tuple(dict.fromkeys(name for node in walk(formula) for name in names(node).capabilities))


def variables(formula: Formula) -> tuple[str, ...]:
    """The signals a formula compares, each once, in the order of their first use."""
    return tuple(dict.fromkeys(name for node in walk(formula) for name in names(node).variables))


@singledispatch
def names(node: Formula) -> Names:
    """The names of one node without its children. Every class of nodes registers its own."""
    raise TypeError(f"no names are registered for {type(node).__name__}")


@names.register
def _(_node: Constant | Known | Not | Whole | Several | Pair | Window | Switch) -> Names:
    return Names()


@names.register
def _(node: Count) -> Names:
    return Names((node.label,), () if node.capability is None else (node.capability,))


@names.register
def _(node: Execution) -> Names:
    return Names((node.label,))


@names.register
def _(node: Linear) -> Names:
    return Names(variables=tuple(name for name, _ in node.terms))


@names.register
def _(node: Task | Limit) -> Names:
    return Names((node.label,), tuple(name for name, _ in node.needs))
