"""Several robots of one kind: the system of all of them, with the names of each beginning alike."""

from __future__ import annotations

from collections.abc import Callable, Hashable, Iterable, Mapping
from dataclasses import dataclass
from functools import partial
from typing import TypeAlias, TypeVar

import numpy as np

from tsplan.signals.linear_system import Dynamics, Limit, Range, System, Terms

T = TypeVar("T")
H = TypeVar("H", bound=Hashable)
Call: TypeAlias = Callable[[str], str]
"""What something is called otherwise; KeyError for what has no other name."""


def prefixed(copy: str, name: str) -> str:
    """The name that a robot's signal, control, output or region has; without robots as it is.

    >>> prefixed("a", "x"), prefixed("", "x")
    ('a_x', 'x')
    """
    return f"{copy}_{name}" if copy else name


def base_names(names: Iterable[str], copies: Iterable[str]) -> frozenset[str]:
    """The names that every one of several robots has, by what a single one would call them.

    >>> sorted(base_names(["a_x", "b_x", "a_y", "gap"], ["a", "b"]))
    ['x']
    """
    own = [
        {name[len(begin) :] for name in names if name.startswith(begin)}
        for begin in (prefixed(copy, "") for copy in copies)
    ]
    return frozenset(set.intersection(*own) if own else ())


@dataclass(frozen=True)
class Renaming:
    """Which names mean the same for every robot: those of one `base` robot.

    Whatever uses only names of the base is there once for every robot; whatever uses only names
    of robots is there once.
    """

    base: frozenset[str]
    copies: tuple[str, ...]

    def shared(self, names: Iterable[str]) -> bool:
        """Whether something that uses some names is there for every robot."""
        return set(names) <= self.base

    def of(self, names: Iterable[str]) -> tuple[str, ...]:
        """The robots for which something that uses some names is there; `("",)` for once."""
        return self.copies if self.copies and self.shared(names) else ("",)


def copied(base: System, starts: Mapping[str, Mapping[str, Range]]) -> System:
    """The system of several robots, of which each begins as the base does unless it says otherwise.

    >>> cart = System({"p": (0, 9)}, {"u": (-1, 1)}, Dynamics(((1,),), ((1,),), (0,)))
    >>> both = copied(cart, {"a": {"p": (1, 1)}, "b": {}})
    >>> both.names, dict(both.initial)
    (('a_p', 'b_p', 'a_u', 'b_u'), {'a_p': (1, 1)})
    """
    initial = {copy: {**base.initial, **own} for copy, own in starts.items()}
    dynamics = base.dynamics
    if dynamics is not None:
        each = np.eye(len(starts))
        a, b, d = dynamics.arrays
        dynamics = Dynamics(
            tuple(map(tuple, np.kron(each, a).tolist())),
            tuple(map(tuple, np.kron(each, b).tolist())),
            tuple(np.tile(d, len(starts)).tolist()),
        )
    return System(
        _every(starts, dict.fromkeys(starts, base.signals)),
        _every(starts, dict.fromkeys(starts, base.controls)),
        dynamics,
        _every(starts, initial),
    )


def _every(copies: Iterable[str], parts: Mapping[str, Mapping[str, T]]) -> dict[str, T]:
    return {prefixed(copy, name): value for copy in copies for name, value in parts[copy].items()}


@dataclass(frozen=True)
class Single:
    """One robot of several: its system, and what all of them have, said of it alone."""

    system: System
    copies: tuple[str, ...]

    @classmethod
    def of(cls, system: System, copies: tuple[str, ...]) -> Single:
        """The first of several robots, whose signals come first; it begins anywhere."""
        count, steered = (len(part) // len(copies) for part in (system.signals, system.controls))
        skip = len(prefixed(copies[0], ""))
        signals, controls = (
            {name[skip:]: ends for name, ends in [*part.items()][:size]}
            for part, size in ((system.signals, count), (system.controls, steered))
        )
        dynamics = system.dynamics
        if dynamics is not None:
            a = tuple(row[:count] for row in dynamics.a[:count])
            b = tuple(row[:steered] for row in dynamics.b[:count])
            dynamics = Dynamics(a, b, dynamics.d[:count])
        return cls(System(signals, controls, dynamics), copies)

    def starts(self, copy: str, system: System) -> dict[str, Range]:
        """Where a robot begins, by the names that the single one has for its signals."""
        own = {name: prefixed(copy, name) for name in self.system.signals}
        return {name: system.initial[one] for name, one in own.items() if one in system.initial}

    def said_once(
        self, items: Iterable[tuple[str, H]], rename: Callable[[H, Call], H]
    ) -> list[tuple[str, H]]:
        """What every robot has, under its own name if any, once; and the rest as it is."""
        given = list(items)
        there, said = set(given), set[tuple[str, H]]()
        names = {prefixed(self.copies[0], name): name for name in self.system.names}
        made: list[tuple[str, H]] = []
        for key, value in given:
            if (key, value) in said:
                continue
            try:
                stem = key.removeprefix(prefixed(self.copies[0], ""))
                one = rename(value, names.__getitem__)
                every = {
                    (key and prefixed(copy, stem), rename(one, partial(prefixed, copy)))
                    for copy in self.copies
                }
            except KeyError:  # it names signals of other robots
                every = set()
            if every and every <= there:
                said |= every
                made.append((stem, one))
            else:
                made.append((key, value))
        return made


def renamed_terms(terms: Terms, call: Call) -> Terms:
    """A sum whose signals are called otherwise."""
    return tuple((call(name), factor) for name, factor in terms)


def renamed_limit(limit: Limit, call: Call) -> Limit:
    """A limit whose signals are called otherwise."""
    sized = tuple((factor, renamed_terms(terms, call)) for factor, terms in limit.absolute)
    return Limit(renamed_terms(limit.terms, call), sized, limit.bound)
