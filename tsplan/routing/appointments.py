"""What a goal asks for, as appointments: agents wanted at places, at a step that can be chosen.

A conjunction of eventualities asks for so many agents at places each, from some step of a window on
and for as long as the eventuality says. Which agents come and when they begin is open; how the
appointment looks is not.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass

import numpy as np

from tsplan.encode.atom_encoders import Bound
from tsplan.encode.capability_mask import is_counted
from tsplan.encode.count_atoms import CountEncoder
from tsplan.encode.encoded import Setting
from tsplan.logic import TRUE, Always, And, Count, Eventually, Formula
from tsplan.routing.crowd import Quota


@dataclass(frozen=True)
class Need:
    """So many agents of the `able` classes at some of `states`, `after` so many steps each."""

    states: tuple[int, ...]
    able: frozenset[int]
    many: int
    after: tuple[int, ...]


@dataclass(frozen=True)
class Appointment:
    """Needs counted from one step between `first` and `last`."""

    first: int
    last: int
    needs: tuple[Need, ...]

    @property
    def span(self) -> int:
        """How many steps after its beginning it ends."""
        return max(need.after[-1] for need in self.needs)


@dataclass(frozen=True)
class Agenda:
    """All appointments of a goal, and where it allows so many agents at most."""

    appointments: tuple[Appointment, ...]
    quotas: tuple[Quota, ...] = ()

    @property
    def needs(self) -> tuple[Need, ...]:
        """The needs of all appointments."""
        return tuple(need for item in self.appointments for need in item.needs)


def agenda_of(setting: Setting, level: int = 0) -> Agenda | None:
    """The agenda of a goal, with availability at least `level`.

    None where the goal asks for more than that: for one of several things, for something again and
    again, or for something before something else.
    """
    network = setting.unrolled()
    encoder = CountEncoder(network, setting.mission.system, setting.arrays, level)
    parts = list(_parts(setting.goal))
    appointments: list[Appointment] = []
    quotas: list[Quota] = []
    for part in parts:
        found = _appointment(setting, part, encoder)
        if found is None:
            return None
        made, few = found
        quotas += few
        appointments += [made] if made.needs else []
    late = any(made.last + made.span > setting.horizon for made in appointments)
    return None if late or not appointments else Agenda(tuple(appointments), tuple(quotas))


def _parts(goal: Formula) -> Iterator[Formula]:
    if isinstance(goal, And):
        for child in goal.children:
            yield from _parts(child)
    elif goal is not TRUE:
        yield goal


def _appointment(
    setting: Setting, part: Formula, encoder: CountEncoder
) -> tuple[Appointment, list[Quota]] | None:
    """One part as an appointment, and what it allows at most; None where it is none."""
    first = last = 0
    while isinstance(part, Eventually):
        first, last, part = first + part.low, last + part.high, part.child
    counted = _counted(part, frozenset({0}))
    if counted is None:
        return None
    steps: dict[Bound, frozenset[int]] = {}
    for atom, after in counted:
        requirement = encoder.requirement(atom)
        if not requirement.every and len(requirement.bounds) > 1:
            return None
        for bound in requirement.bounds:
            steps[bound] = steps.get(bound, frozenset()) | after
    if first < last and any(bound.upper for bound in steps):
        return None
    needs: list[Need] = []
    quotas: list[Quota] = []
    for bound, after in steps.items():
        able = able_classes(setting, bound)
        if bound.upper:
            when = np.array(sorted(after)) + first
            quotas.append(Quota(np.array(bound.states, dtype=np.int64), able, when, bound.amount))
        elif bound.amount > 0:
            needs.append(Need(bound.states, able, bound.amount, tuple(sorted(after))))
    return Appointment(first, last, tuple(needs)), quotas


def able_classes(setting: Setting, bound: Bound) -> frozenset[int]:
    """The numbers of the classes whose agents a bound counts."""
    return frozenset(
        number
        for number, item in enumerate(setting.classes)
        if is_counted(bound.capability, item.graph.capabilities)
    )


def _counted(node: Formula, steps: frozenset[int]) -> Sequence[tuple[Count, frozenset[int]]] | None:
    """The atoms that all have to hold, and when; None where there is something to be chosen."""
    if isinstance(node, Count):
        return [(node, steps)]
    if isinstance(node, Always):
        window = range(node.low, node.high + 1)
        return _counted(node.child, frozenset(step + ago for step in steps for ago in window))
    if not isinstance(node, And):
        return None
    found: list[tuple[Count, frozenset[int]]] = []
    for child in node.children:
        below = _counted(child, steps)
        if below is None:
            return None
        found += below
    return found
