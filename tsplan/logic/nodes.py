"""Formulas as trees: the temporal and Boolean operators that all languages share.

Nodes are frozen and hash-consed: two formulas of the same shape are the same object, `==` is `is`,
and a formula that is used twice is stored once. The atoms are in `tsplan.logic.atoms`.

Adding an operator means one class here and one registration in every single-dispatch function of
this package (printing, horizon, normal form, simplification, evaluation, ...); a test walks them
all and names the one that is missing.
"""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from dataclasses import dataclass, field, fields
from types import MappingProxyType
from typing import Any, cast

from tsplan import display
from tsplan.logic.interning import Interned
from tsplan.logic.text import text_of
from tsplan.logic.traversal import packed, unpacked
from tsplan.logic.weight_values import Weight, Weights, weights_for

_SHOWN = 200  # characters of a formula that `repr` shows at most


class Formula(display.Displayed, metaclass=Interned):
    """A formula of any of the languages; equality is identity.

    Formulas are combined with `&` (and), `|` (or), `~` (not), `>>` (implies) and the methods
    `eventually`, `always`, `until`, `release` and `iff`. `str` prints a text that parses back to
    the same formula. Weights, of the parts of an `And` or `Or` or of the steps of a window, say how
    much each of them counts; see `tsplan.logic.weight_values`.

    >>> from tsplan.logic import parse
    >>> print(parse("depot").until(parse("field"), 0, 5) & ~parse("fire").always(0, 9))
    (depot U[0,5] field) && !G[0,9] fire
    """

    __slots__ = ("__weakref__",)

    def __post_init__(self) -> None:
        """Refuse operands that are no formulas."""
        for child in self.children:
            _formula(child)

    @property
    def children(self) -> tuple[Formula, ...]:
        """The sub-formulas one level below, in the order of the text."""
        return ()

    @property
    def parameters(self) -> tuple[Any, ...]:
        """The values of the fields that are no sub-formulas, in their order."""
        names = (item.name for item in fields(cast("Any", self)))
        return tuple(
            value for name in names if not isinstance(value := getattr(self, name), Formula)
        )

    def over(self, children: Iterable[Formula]) -> Formula:
        """The same operator with other sub-formulas; an atom stays itself."""
        made = tuple(children)
        return self.assembled(self.parameters, made) if made else self

    @classmethod
    def assembled(cls, parameters: Iterable[Any], children: Iterable[Formula]) -> Formula:
        """A node of this class from what `parameters` and `children` give."""
        return cls(*parameters, *children)

    def __and__(self, other: Formula) -> And:
        """Both hold."""
        return And((self, _formula(other)))

    def __or__(self, other: Formula) -> Or:
        """At least one holds."""
        return Or((self, _formula(other)))

    def __invert__(self) -> Not:
        """Negate: the formula does not hold."""
        return Not(self)

    def __rshift__(self, other: Formula) -> Implies:
        """Where the formula holds, the other does."""
        return Implies(self, other)

    def iff(self, other: Formula) -> Iff:
        """Both hold or neither does."""
        return Iff(self, other)

    def eventually(self, low: int, high: int, weights: Weight | None = None) -> Eventually:
        """The formula holds at some step `low .. high` from now; weights are those of the steps."""
        return Eventually(low, high, self, cast("Weights", weights))

    def always(self, low: int, high: int, weights: Weight | None = None) -> Always:
        """The formula holds at every step `low .. high` from now."""
        return Always(low, high, self, cast("Weights", weights))

    def until(self, other: Formula, low: int, high: int, weights: Weight | None = None) -> Until:
        """The other holds at some step `low .. high` from now, this one at every step before."""
        return Until(low, high, self, other, cast("Weights", weights))

    def release(
        self, other: Formula, low: int, high: int, weights: Weight | None = None
    ) -> Release:
        """The dual of until: the other holds at `low .. high`, up to where this has held before."""
        return Release(low, high, self, other, cast("Weights", weights))

    def __bool__(self) -> bool:
        raise TypeError("a formula is neither true nor false by itself; use &, |, ~ to combine it")

    def __str__(self) -> str:
        return text_of(self)

    def __repr__(self) -> str:
        return f"<{type(self).__name__}: {text_of(self, _SHOWN)}>"

    def _repr_svg_(self) -> str:
        """The formula as a tree, as notebooks show it."""
        return display.formula_svg(self)

    def __copy__(self) -> Formula:
        return self

    def __deepcopy__(self, memo: dict[int, Any]) -> Formula:
        return self

    def __reduce__(self) -> tuple[Any, ...]:
        return unpacked, (packed(self),)


def _formula(value: object) -> Formula:
    if not isinstance(value, Formula):
        raise TypeError(f"a formula is needed here, not {value!r}")
    return value


def _interval(low: object, high: object) -> None:
    """Bounds are whole numbers of steps, 0 <= low <= high."""
    for bound in (low, high):
        if not isinstance(bound, int) or isinstance(bound, bool):
            raise TypeError(f"an interval is bounded by whole numbers of steps, not {bound!r}")
    if not 0 <= low <= high:  # type: ignore[operator]  # both are whole numbers by now
        raise ValueError(f"the interval [{low},{high}] is empty or begins before now")


def _weigh(node: Several | _Timed, indices: range, what: str) -> None:
    """Bring the weights of a node into one form."""
    object.__setattr__(node, "weights", weights_for(node.weights, indices, what))


def _given(weights: Weights) -> tuple[Any, ...]:
    return () if weights is None else (weights,)


class _OfOne(Formula):
    __slots__ = ()
    child: Formula

    @property
    def children(self) -> tuple[Formula, ...]:
        """The child."""
        return (self.child,)


class _OfTwo(Formula):
    __slots__ = ()
    left: Formula
    right: Formula

    @property
    def children(self) -> tuple[Formula, ...]:
        """Left and right."""
        return self.left, self.right


@dataclass(frozen=True, eq=False, repr=False, slots=True)
class Constant(Formula):
    """What always holds (`TRUE`) or never does (`FALSE`)."""

    value: bool


@dataclass(frozen=True, eq=False, repr=False, slots=True)
class Not(_OfOne):
    """The child does not hold."""

    child: Formula


@dataclass(frozen=True, eq=False, repr=False, slots=True)
class Whole(_OfOne):
    """The child, which counts as a whole or not at all where formulas may hold in part."""

    child: Formula


@dataclass(frozen=True, eq=False, repr=False, slots=True)
class Several(Formula):
    """Two or more sub-formulas, grouped as the text groups them, with a weight each or none."""

    children: tuple[Formula, ...] = field()
    weights: Weights = None

    def __post_init__(self) -> None:
        object.__setattr__(self, "children", tuple(_formula(child) for child in self.children))
        if len(self.children) < 2:  # noqa: PLR2004  (one part alone prints without its operator)
            raise ValueError(
                f"'{type(self).__name__}' joins two or more formulas; "
                "use conjunction() or disjunction() for any number of them"
            )
        _weigh(self, range(len(self.children)), "part")

    @property
    def parameters(self) -> tuple[Any, ...]:
        """The weights, if there are any."""
        return _given(self.weights)

    @classmethod
    def assembled(cls, parameters: Iterable[Any], children: Iterable[Formula]) -> Formula:
        """A node of this class from its parts."""
        return cls(tuple(children), *parameters)


@dataclass(frozen=True, eq=False, repr=False, slots=True)
class And(Several):
    """All children hold. `a && b && c` is one node, `a && (b && c)` keeps its two."""


@dataclass(frozen=True, eq=False, repr=False, slots=True)
class Or(Several):
    """At least one child holds."""


@dataclass(frozen=True, eq=False, repr=False, slots=True)
class Pair(_OfTwo):
    """A left and a right sub-formula."""

    left: Formula
    right: Formula


@dataclass(frozen=True, eq=False, repr=False, slots=True)
class Implies(Pair):
    """The right side holds if the left side does."""


@dataclass(frozen=True, eq=False, repr=False, slots=True)
class Iff(Pair):
    """Both sides hold or neither does."""


class _Timed(Formula):
    """What looks at the steps `low .. high` from now, both included, with a weight each or none."""

    __slots__ = ()
    low: int
    high: int
    weights: Weights

    def __post_init__(self) -> None:
        """Refuse operands that are no formulas, and what is no interval or weight."""
        _interval(self.low, self.high)
        Formula.__post_init__(self)
        _weigh(self, range(self.low, self.high + 1), "step")

    @property
    def parameters(self) -> tuple[Any, ...]:
        """The ends of the window, and the weights of its steps if there are any."""
        return self.low, self.high, *_given(self.weights)

    @classmethod
    def assembled(cls, parameters: Iterable[Any], children: Iterable[Formula]) -> Formula:
        """A node of this class from the ends of its window, its weights if any, and its parts."""
        low, high, *weights = parameters
        return cls(low, high, *children, *weights)  # type: ignore[call-arg]  # those of dataclasses


@dataclass(frozen=True, eq=False, repr=False, slots=True)
class Window(_Timed, _OfOne):
    """One sub-formula over the steps `low .. high` from now, both included."""

    low: int
    high: int
    child: Formula
    weights: Weights = None


@dataclass(frozen=True, eq=False, repr=False, slots=True)
class Eventually(Window):
    """The child holds at some step of the window."""


@dataclass(frozen=True, eq=False, repr=False, slots=True)
class Always(Window):
    """The child holds at every step of the window."""


@dataclass(frozen=True, eq=False, repr=False, slots=True)
class Switch(_Timed, _OfTwo):
    """A left and a right sub-formula and the window in which they change over."""

    low: int
    high: int
    left: Formula
    right: Formula
    weights: Weights = None


@dataclass(frozen=True, eq=False, repr=False, slots=True)
class Until(Switch):
    """The right side holds at some step s of the window, the left side from now to before s."""


@dataclass(frozen=True, eq=False, repr=False, slots=True)
class Release(Switch):
    """The dual of until: `left R right` is `!(!left U !right)`."""


DUAL: Mapping[type[Formula], type[Formula]] = MappingProxyType(
    {And: Or, Or: And, Eventually: Always, Always: Eventually, Until: Release, Release: Until}
)
"""The operator that a negation turns another one into, over negated operands; weights stay."""

TRUE = Constant(True)
FALSE = Constant(False)


def conjunction(parts: Iterable[Formula]) -> Formula:
    """All of any number of formulas: none is `TRUE`, a single one is itself.

    >>> conjunction([]) is TRUE
    True
    """
    return _joined(And, tuple(parts), TRUE)


def disjunction(parts: Iterable[Formula]) -> Formula:
    """Any of any number of formulas: none is `FALSE`, a single one is itself."""
    return _joined(Or, tuple(parts), FALSE)


def _joined(kind: type[And | Or], parts: tuple[Formula, ...], nothing: Constant) -> Formula:
    return kind(parts) if len(parts) > 1 else (*parts, nothing)[0]
