"""Atoms: counts of agents (MTL), linear predicates over signals (STL), tasks and limits (CaTL)."""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from dataclasses import dataclass
from fractions import Fraction
from math import isfinite
from types import MappingProxyType
from typing import Literal, TypeAlias, cast

from tsplan.exact import exact
from tsplan.logic.nodes import Formula
from tsplan.words import nfc

Function: TypeAlias = Literal["sum", "min", "max"]
Relation: TypeAlias = Literal[">=", "<=", ">", "<", "=", "!="]
Needs: TypeAlias = "tuple[tuple[str, int], ...]"

FUNCTIONS: tuple[Function, ...] = ("sum", "min", "max")
RELATIONS: tuple[Relation, ...] = (">=", "<=", ">", "<", "=", "!=")

OPPOSITE: Mapping[Relation, Relation] = MappingProxyType(
    {">=": "<", "<": ">=", "<=": ">", ">": "<=", "=": "!=", "!=": "="}
)
"""The relation that holds exactly where another does not."""

MIRRORED: Mapping[Relation, Relation] = MappingProxyType(
    {">=": "<=", "<=": ">=", "<": ">", ">": "<", "=": "=", "!=": "!="}
)
"""The relation that says the same with its two sides exchanged."""

_WHOLE = 100  # percent


@dataclass(frozen=True, slots=True)
class Percent:
    """A share of all agents, in percent: `Percent(Fraction(30))` is 30 %.

    Only shares that can be written as a decimal number, from 0 to 100.
    """

    value: Fraction

    def __post_init__(self) -> None:
        object.__setattr__(self, "value", Fraction(self.value))
        if not 0 <= self.value <= _WHOLE:
            raise ValueError(f"a percentage lies between 0 and 100, not at {self.value}")
        if _decimals(self.value) is None:
            raise ValueError(f"{self.value} percent cannot be written as a decimal number")

    def of(self, total: int) -> Fraction:
        """Take the share of a number of agents, exact.

        >>> Percent(Fraction(25)).of(10)
        Fraction(5, 2)
        """
        return self.value * total / _WHOLE

    def __str__(self) -> str:
        places = _decimals(self.value) or 0
        digits = str(int(self.value * 10**places)).rjust(places + 1, "0")
        whole, part = digits[: len(digits) - places], digits[len(digits) - places :]
        return f"{whole}.{part}%" if part else f"{whole}%"


def _decimals(value: Fraction) -> int | None:
    """How many decimal places write a fraction exactly; None if none do."""
    rest, places = value.denominator, 0
    for prime in (2, 5):
        count = 0
        while rest % prime == 0:
            rest, count = rest // prime, count + 1
        places = max(places, count)
    return places if rest == 1 else None


@dataclass(frozen=True, eq=False, repr=False, slots=True)
class Count(Formula):
    """A number of agents compared with a bound.

    `sum` counts the agents at all states with the label together; `min` and `max` are the least
    and the greatest number at one such state. `capability` None counts every agent.
    """

    function: Function
    label: str
    capability: str | None
    relation: Relation
    bound: int | Percent

    def __post_init__(self) -> None:
        _known(self.function, FUNCTIONS)
        _known(self.relation, RELATIONS)
        object.__setattr__(self, "label", _name(self.label))
        if self.capability is not None:
            object.__setattr__(self, "capability", _name(self.capability))
        if not isinstance(self.bound, Percent):
            _whole(self.bound)

    @property
    def upper(self) -> bool:
        """Whether it bounds the number from above alone."""
        return self.relation in ("<=", "<")


@dataclass(frozen=True, eq=False, repr=False, slots=True)
class Linear(Formula):
    """A linear combination of signals compared with a number: `2*x - y >= 3`.

    Whatever is given is brought into one form: signals sorted by name, each once, none with
    coefficient 0, the first coefficient positive. The robustness does not change by that.

    >>> print(Linear((("y", 1.0), ("x", -2.0)), ">", 3.0))
    2*x - y < -3
    """

    terms: tuple[tuple[str, float], ...]
    relation: Relation
    bound: float

    def __post_init__(self) -> None:
        _known(self.relation, RELATIONS)
        merged: dict[str, float] = {}
        for given, factor in self.terms:
            name = _name(given)
            merged[name] = merged.get(name, 0.0) + float(factor)
        terms = tuple((name, merged[name]) for name in sorted(merged) if merged[name] != 0)
        bound, relation = float(self.bound), self.relation
        if terms and terms[0][1] < 0:
            terms = tuple((name, -factor) for name, factor in terms)
            bound, relation = -bound, MIRRORED[relation]
        if not all(isfinite(number) for number in (bound, *(factor for _, factor in terms))):
            raise ValueError("the numbers of a predicate must be finite")
        object.__setattr__(self, "terms", terms)
        object.__setattr__(self, "relation", relation)
        object.__setattr__(self, "bound", bound + 0.0)  # never the negative zero


@dataclass(frozen=True, eq=False, repr=False, slots=True)
class Known(Formula):
    """What is known to hold, or to fail, by a margin: how counts turned out that are past.

    Its availability is `margin`, a whole number of agents, and it holds where that is not negative.
    What is known of signals is a `Linear` without terms.

    >>> print(Known(2), Known(-1))
    known(2) known(-1)
    """

    margin: int

    def __post_init__(self) -> None:
        _whole(self.margin)


@dataclass(frozen=True, eq=False, repr=False, slots=True)
class Task(Formula):
    """Every state with the label is staffed, for each need (capability, m), by m agents or more.

    This lasts `duration` steps. `resources` are (name, amount) pairs: a task with some is executed,
    and they are needed for that at each of the states. A name that is repeated adds up.

    A task may have `begun` so many steps ago. Then it goes on for the steps that are left of it,
    and needs of its resources those that are used, and not used up when it begins.

    >>> print(Task(3, "wall", (("lift", 2),), begun=1))
    begun(T(3,wall,{(lift,2)}),1)
    """

    duration: int
    label: str
    needs: Needs
    resources: tuple[tuple[str, float], ...] = ()
    begun: int = 0

    def __post_init__(self) -> None:
        _whole(self.duration, least=0)
        _whole(self.begun, least=0)
        if self.begun > self.duration:
            raise ValueError(f"a task of {self.duration} steps has not begun {self.begun} ago")
        object.__setattr__(self, "label", _name(self.label))
        object.__setattr__(self, "needs", _staffing(self.needs))
        spent: dict[str, float] = {}
        for given, amount in self.resources:
            name = _name(given)
            total = (
                exact(float(amount)) + exact(spent.get(name, 0.0)) if isfinite(amount) else amount
            )
            spent[name] = float(total)
        object.__setattr__(self, "resources", tuple(spent.items()))
        if not all(isfinite(amount) and amount >= 0 for _, amount in self.resources):
            raise ValueError("amounts of resources are finite and not negative")
        if not self.needs and not self.resources:
            raise ValueError("a task asks for some capability or resource")

    @property
    def left(self) -> int:
        """The steps that are left of it, from now on."""
        return self.duration - self.begun


@dataclass(frozen=True, eq=False, repr=False, slots=True)
class Execution(Formula):
    """A task is executed now, at every state with the task's label.

    Nothing in a text is read as this: it is a part of what a task translates to that has resources
    or agents of its own.
    `whole` is the text of the task. Its needs hold, and tools are in use, from now on to `last`.
    It may have `begun` so many steps ago.
    """

    whole: str
    label: str
    needs: Needs
    resources: tuple[tuple[str, float], ...]
    last: int
    begun: int = 0

    @property
    def task(self) -> str:
        """The text of the task, or of the rest of it."""
        return begun_text(self.whole, self.begun)


def begun_text(task: str, steps: int) -> str:
    """The text of a task that has begun so many steps ago, by its own."""
    return f"begun({task},{steps})" if steps else task


@dataclass(frozen=True, eq=False, repr=False, slots=True)
class Limit(Formula):
    """No state with the label holds, for any need (capability, m), more than m agents, now.

    Without needs it holds no agent at all.
    """

    label: str
    needs: Needs

    def __post_init__(self) -> None:
        object.__setattr__(self, "label", _name(self.label))
        object.__setattr__(self, "needs", _staffing(self.needs))


def _staffing(needs: Iterable[tuple[str, int]]) -> Needs:
    pairs = tuple((_name(name), number) for name, number in needs)
    _distinct(name for name, _ in pairs)
    for _, number in pairs:
        _whole(number, least=0)
    return pairs


def _distinct(names: Iterable[str]) -> None:
    seen: set[str] = set()
    for name in names:
        if name in seen:
            raise ValueError(f"'{name}' is named twice")
        seen.add(name)


def _whole(value: object, least: int | None = None) -> None:
    if not isinstance(value, int) or isinstance(value, bool):
        raise TypeError(f"a whole number is needed here, not {value!r}")
    if least is not None and value < least:
        raise ValueError(f"a number of at least {least} is needed here, not {value}")


def _name(value: object) -> str:
    """A name in the form in which names are compared."""
    if not isinstance(value, str) or not value:
        raise TypeError(f"a name is needed here, not {value!r}")
    return nfc(value)


def _known(value: str, words: tuple[str, ...]) -> None:
    if value not in words:
        raise ValueError(f"'{value}' is none of {', '.join(words)}")


def at_least(label: str, number: int = 1, capability: str | None = None) -> Count:
    """At least a number of agents at all states with the label together.

    >>> print(at_least("depot", 3, "Vis").eventually(0, 5))
    F[0,5] (sum(depot,Vis) >= 3)
    """
    return Count("sum", label, capability, ">=", number)


def at_most(label: str, number: int, capability: str | None = None) -> Count:
    """At most a number of agents at all states with the label together."""
    return Count("sum", label, capability, "<=", number)


def each_at_least(label: str, number: int, capability: str | None = None) -> Count:
    """At least a number of agents at every state with the label."""
    return Count("min", label, capability, ">=", number)


def each_at_most(label: str, number: int, capability: str | None = None) -> Count:
    """At most a number of agents at every state with the label."""
    return Count("max", label, capability, "<=", number)


def linear(terms: Mapping[str, float], relation: str, bound: float) -> Linear:
    """A linear predicate over signals.

    >>> print(linear({"x": 2, "y": -1}, ">=", 3))
    2*x - y >= 3
    """
    _known(relation, RELATIONS)
    return Linear(tuple(terms.items()), cast("Relation", relation), bound)


def task(duration: int, label: str, needs: Mapping[str, int]) -> Task:
    """A task without resources.

    >>> print(task(2, "green", {"IR": 2}))
    T(2,green,{(IR,2)})
    """
    return Task(duration, label, tuple(needs.items()))


def limit(label: str, needs: Mapping[str, int] | None = None) -> Limit:
    """A limit; without needs it allows no agent at all."""
    return Limit(label, tuple((needs or {}).items()))
