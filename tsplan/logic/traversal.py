"""Walking over formulas without recursion: nesting of any depth, shared parts once."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator
from typing import Any, Protocol, TypeAlias, TypeVar


class Tree(Protocol):
    """What can be walked over: formulas."""

    @property
    def children(self) -> tuple[Any, ...]:
        """What is below, in order."""

    @property
    def parameters(self) -> tuple[Any, ...]:
        """What it has beside its children."""

    def over(self, children: Iterable[Any]) -> Any:
        """The same over other children."""


N = TypeVar("N", bound=Tree)
T = TypeVar("T")
Packed: TypeAlias = "tuple[tuple[Any, tuple[Any, ...], tuple[int, ...]], ...]"


def walk(formula: N) -> Iterator[N]:
    """Every sub-formula once, children before their parents, the formula itself last."""
    yield from walk_all((formula,))


def walk_all(formulas: Iterable[N]) -> Iterator[N]:
    """Every sub-formula of several formulas once, children before their parents."""
    seen: set[N] = set()
    stack = [(formula, False) for formula in reversed(tuple(formulas))]
    while stack:
        node, opened = stack.pop()
        if opened:
            yield node
        elif node not in seen:
            seen.add(node)
            stack.append((node, True))
            stack += ((child, False) for child in reversed(node.children) if child not in seen)


def fold(formula: N, combine: Callable[[N, tuple[T, ...]], T]) -> T:
    """The value of a formula from the values of its children, bottom up; shared parts once.

    >>> from tsplan.logic import parse
    >>> fold(parse("F[0,2] (a && b)"), lambda node, below: 1 + max(below, default=0))
    3
    """
    return fold_all(formula, combine)[formula]


def fold_all(formula: N, combine: Callable[[N, tuple[T, ...]], T]) -> dict[N, T]:
    """The value of every sub-formula of a formula, as `fold` makes them."""
    values: dict[N, T] = {}
    for node in walk(formula):
        values[node] = combine(node, tuple(values[child] for child in node.children))
    return values


def packed(formula: Tree) -> Packed:
    """A formula as a flat table that can be pickled whatever its depth; see `unpacked`."""
    table: list[tuple[Any, tuple[Any, ...], tuple[int, ...]]] = []

    def placed(node: Tree, below: tuple[int, ...]) -> int:
        table.append((type(node), node.parameters, below))
        return len(table) - 1

    fold(formula, placed)
    return tuple(table)


def unpacked(table: Packed) -> Any:
    """The formula of a flat table: the very same object in the same process."""
    made: list[Any] = []
    for kind, parameters, below in table:
        children = tuple(made[place] for place in below)
        made.append(kind.assembled(parameters, children))
    return made[-1]


def substitute(formula: N, replacements: dict[N, N]) -> N:
    """The formula with some sub-formulas exchanged, all at once.

    What is put in is not searched again.

    >>> from tsplan.logic import parse
    >>> print(substitute(parse("F[0,2] a && b"), {parse("a"): parse("c || d")}))
    F[0,2] (c || d) && b
    """

    def exchanged(node: N, below: tuple[N, ...]) -> N:
        changed: N = replacements[node] if node in replacements else node.over(below)
        return changed

    return fold(formula, exchanged)
