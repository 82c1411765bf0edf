"""Rows by which agents at a state serve what is executed there, where they are booked for it.

They are written for every state and step at which two needs may have to be met, over the columns
of executions. Who serves what may change from step to step.

* `exclusive`: every need has agents of its own, each of which has its capability. By the theorem of
  Hall (1935), with numbers, there are such agents exactly if for every set of capabilities the
  needs for these are no more than the agents that have any of them. Sets that fall apart into two
  between which no agent has capabilities say no more than these do, and so do sets to which a
  capability can be added without another agent; the others are written. Where these are too many,
  a flow from agents to needs says the same.
* `per-label`: for each capability, the largest need at every label of the state, added up, is no
  more than the agents that have it (the rule of the published code of CaTL).
"""

from __future__ import annotations

from collections import defaultdict
from collections.abc import Collection, Mapping, Sequence
from typing import NamedTuple, TypeAlias

import numpy as np

from tsplan.encode.executions import Executions
from tsplan.encode.flow_network import Network
from tsplan.logic import Execution
from tsplan.milp.model import Block, Draft, Ints, Terms
from tsplan.mission import Mission

MOST_SETS = 24
"""Sets of capabilities at a state and step; where there are more a flow is written."""

Ability: TypeAlias = frozenset[str]
"""The capabilities that agents have of those that are asked for."""


class Running(NamedTuple):
    """A task that may run at a state and step, and the columns of the steps it may have begun."""

    task: Execution
    columns: Ints


class Need(NamedTuple):
    """So many agents with a capability for each of the columns that is 1."""

    capability: str
    label: str
    number: int
    columns: Ints


class Kind(NamedTuple):
    """How many agents of one ability are there: the columns summed up, and a number."""

    columns: Sequence[int]
    fixed: int


def booking_rows(mission: Mission, executions: Executions, network: Network, draft: Draft) -> None:
    """Rows for executions whose agents are booked; none where an agent counts for everything."""
    if not mission.books:
        return
    write = _exclusive if mission.booking == "exclusive" else _per_label
    rows = Block("booking")
    for (state, step), running in _running(executions).items():
        needs = [
            Need(capability, task.label, number, columns)
            for task, columns in running
            for capability, number in task.needs
            if number
        ]
        if _options(needs) > 1:
            write(needs, _Place(network, state, step), draft, rows)
    rows.write(draft)


def _running(executions: Executions) -> Mapping[tuple[int, int], list[Running]]:
    """What may run at each state and step."""
    found: dict[tuple[int, int], list[Running]] = defaultdict(list)
    for bound, timed in executions.items():
        task = bound.task
        for step in range(timed.first, timed.last + task.last + 1):
            begun = max(step - task.last - timed.first, 0)
            columns = timed.columns[begun : step - timed.first + 1]
            found[bound.state, step].append(Running(task, columns))
    return found


def _options(needs: Collection[Need]) -> int:
    """How many executions there may be of which some agents serve a need, each need counted."""
    return sum(len(need.columns) for need in needs)


class _Place(NamedTuple):
    """A state and a step."""

    network: Network
    state: int
    step: int

    def having(self, capability: str) -> tuple[Ints, int]:
        """The agents that have a capability: columns whose sum they are, and a number."""
        return self.network.present(np.array([self.state]), capability, self.step)

    def kinds(self, asked: Collection[str]) -> Mapping[Ability, Kind]:
        """The agents by which they have of the capabilities that are asked for."""
        if self.network.horizon == 0:
            return self._standing(asked)
        able: dict[int, set[str]] = defaultdict(set)
        for capability in asked:
            for column in self.having(capability)[0].tolist():
                able[column].add(capability)
        alike: dict[Ability, list[int]] = defaultdict(list)
        for column, capabilities in able.items():
            alike[frozenset(capabilities)].append(column)
        return {ability: Kind(columns, 0) for ability, columns in alike.items()}

    def _standing(self, asked: Collection[str]) -> Mapping[Ability, Kind]:
        """Where nobody moves the agents are a number."""
        counted = {name: self.network.counted(name)[:, self.state] for name in asked}
        there: dict[Ability, int] = defaultdict(int)
        for place, item in enumerate(self.network.classes):
            ability = frozenset(name for name in asked if counted[name][place])
            there[ability] += int(item.graph.start[self.state])
        return {ability: Kind((), number) for ability, number in there.items() if ability}


def _exclusive(needs: Sequence[Need], place: _Place, draft: Draft, rows: Block) -> None:
    """Every need has agents of its own."""
    asked = dict.fromkeys(need.capability for need in needs)
    kinds = place.kinds(asked)
    sets = telling_sets(kinds, asked, MOST_SETS)
    if sets is None:
        _assigned(needs, kinds, draft, rows)
        return
    for chosen in sets:
        mine = [need for need in needs if need.capability in chosen]
        if _options(mine) > 1:  # a single one has the agents that its task asks for
            able = [kind for ability, kind in kinds.items() if ability & chosen]
            there = [(0, kind.columns, 1.0) for kind in able]
            rows.add(*there, *map(_taken, mine), lower=-float(sum(kind.fixed for kind in able)))


def _taken(need: Need) -> Terms:
    """What a need takes away."""
    return 0, need.columns, -float(need.number)


def _assigned(
    needs: Sequence[Need], kinds: Mapping[Ability, Kind], draft: Draft, rows: Block
) -> None:
    """A flow: agents of every ability go to capabilities, as many as are needed for each."""
    going: dict[str, list[int]] = {need.capability: [] for need in needs}
    most = float(sum(need.number * len(need.columns) for need in needs))
    for ability, kind in kinds.items():
        # whole by themselves, and said to be: HiGHS 1.15.1 refuted a model with others by mistake
        columns = draft.columns(len(ability), upper=most, integer=True)
        for capability, column in zip(sorted(ability), columns.tolist(), strict=True):
            going[capability].append(column)
        rows.add((0, kind.columns, 1.0), (0, columns, -1.0), lower=-float(kind.fixed))
    for capability, columns_ in going.items():
        mine = (need for need in needs if need.capability == capability)
        rows.add((0, columns_, 1.0), *map(_taken, mine), lower=0.0)


def telling_sets(
    abilities: Collection[Ability], asked: Collection[str], most: int
) -> list[Ability] | None:
    """The sets of capabilities that have to be compared with agents; None if more than `most`.

    >>> both, lift = frozenset({"lift", "look"}), frozenset({"lift"})
    >>> [sorted(chosen) for chosen in telling_sets([both, lift], ["lift", "look"], 9)]
    [['lift', 'look'], ['look']]
    """
    having = {name: [ability for ability in abilities if name in ability] for name in asked}

    def closed(chosen: Ability) -> Ability:
        """With all capabilities that only agents have who have some of these."""
        more = (name for name, able in having.items() if able and all(a & chosen for a in able))
        return chosen.union(more)

    found: dict[Ability, None] = {}
    waiting = [closed(frozenset({name})) for name in asked]
    while waiting:
        chosen = waiting.pop(0)
        if chosen in found:
            continue
        if len(found) == most:
            return None
        found[chosen] = None
        near = {name for ability in abilities if ability & chosen for name in ability - chosen}
        waiting += (closed(chosen | {name}) for name in sorted(near))
    return list(found)


def _per_label(needs: Sequence[Need], place: _Place, draft: Draft, rows: Block) -> None:
    """Different labels have different agents; what is executed at one label shares them."""
    for capability in dict.fromkeys(need.capability for need in needs):
        labels: dict[str, list[Need]] = defaultdict(list)
        for need in needs:
            if need.capability == capability:
                labels[need.label].append(need)
        if len(labels) > 1:  # of one label every task has its agents anyway
            columns, fixed = place.having(capability)
            largest = [_largest(mine, draft, rows) for mine in labels.values()]
            rows.add((0, columns, 1.0), *largest, lower=-float(fixed))


def _largest(needs: Sequence[Need], draft: Draft, rows: Block) -> Terms:
    """What the largest of the needs that have to be met takes away."""
    if _options(needs) == 1:
        return _taken(needs[0])
    column = draft.columns(1, upper=float(max(need.number for need in needs)))
    for need in needs:
        count = len(need.columns)
        each = (np.arange(count), need.columns, -float(need.number))
        rows.add((np.arange(count), np.repeat(column, count), 1.0), each, lower=np.zeros(count))
    return 0, column, -1.0
