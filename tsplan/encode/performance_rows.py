"""How well structures do what a formula asks for, as columns and rows of a model.

What the best way to meet a formula is worth (`tsplan.logic.performance`) is asked for from the top:
of alternatives one is chosen, by a 0/1 column each, and what is asked for in a chosen part must
hold there. A task that is asked for under such a guard is worth nothing where the guard is 0, and
at most as much as those can do it that are there.
"""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from dataclasses import dataclass
from typing import TypeAlias

import numpy as np

from tsplan.encode.atom_encoders import Executed
from tsplan.encode.count_atoms import atoms_over
from tsplan.encode.encoded import Setting
from tsplan.encode.executions import Executions
from tsplan.encode.flow_network import Network
from tsplan.logic import FALSE, Count, Execution, Formula, Known, nodes
from tsplan.logic.performance import tree_of_tasks
from tsplan.milp.model import Draft, Floats, Ints
from tsplan.mission.performances import Kind, Performances, Serving, rooms

Guard: TypeAlias = "Ints | None"
"""Columns of which at most one is 1: where one is, a part is asked for. None if it always is."""


@dataclass(frozen=True, eq=False)
class Performed:
    """The columns that add up to what a plan is worth, with how much each counts, in units."""

    columns: Ints
    worth: Floats


def kinds_of(setting: Setting) -> list[tuple[int, Kind]]:
    """The classes that are structures, and of which kind."""
    return [
        (number, Kind(item.shape, item.graph.capabilities))
        for number, item in enumerate(setting.classes)
        if item.shape is not None
    ]


def performed(setting: Setting, network: Network, executed: Executions, draft: Draft) -> Performed:
    """The columns and rows for what the structures of a model do."""
    rows = _Rows(setting, network, executed, draft)
    tree = tree_of_tasks(setting.mission.formula, setting.mission.task_interval)
    rows.ask(tree, 0, None)
    columns = sorted(rows.worth)
    return Performed(
        np.array(columns, dtype=np.int64),
        np.array([rows.worth[column] for column in columns], dtype=np.float64),
    )


class _Rows:
    """Writes the rows of one model; `worth` gathers what every column counts."""

    def __init__(
        self, setting: Setting, network: Network, executed: Executions, draft: Draft
    ) -> None:
        mission = setting.mission
        given = setting.arrays, 0, mission.resources
        self._setting = setting
        self._network = network
        self._executions = executed
        self._draft = draft
        self._atoms = atoms_over(network, mission.system, *given)
        self._rules = Performances(mission.modular)
        self._kinds = kinds_of(setting)
        self._served: dict[tuple[Execution, int], list[tuple[float, Ints]]] = {}
        self.worth: dict[int, float] = {}

    def ask(self, node: Formula, step: int, guard: Guard) -> None:
        """Ask for a part of the formula at a step."""
        match node:
            case nodes.And():
                for child in node.children:
                    self.ask(child, step, guard)
            case nodes.Always():
                for late in range(node.low, node.high + 1):
                    self.ask(node.child, step + late, guard)
            case nodes.Or():
                self._either([(child, step) for child in node.children], guard)
            case nodes.Eventually():
                window = range(step + node.low, step + node.high + 1)
                self._either([(node.child, late) for late in window], guard)
            case nodes.Until():
                self._change_over(node, step, guard)
            case _:
                self._leaf(node, step, guard)

    def _leaf(self, node: Formula, step: int, guard: Guard) -> None:
        if isinstance(node, Execution):
            self._task(node, step, guard)
        elif isinstance(node, Count | Known):
            self._count(node, step, guard)
        elif isinstance(node, nodes.Not) or node == FALSE:  # not to execute is nowhere asked for
            self._never(guard)

    def _either(self, options: Sequence[tuple[Formula, int]], guard: Guard) -> None:
        if len(options) == 1:
            self.ask(*options[0], guard)
            return
        for (child, step), choice in zip(options, self._choices(len(options), guard), strict=True):
            self.ask(child, step, np.array([choice]))

    def _choices(self, count: int, guard: Guard) -> Ints:
        """0/1 columns of which one is 1 where the guard is."""
        made = self._draft.columns(count, upper=1.0, integer=True)
        terms = [(0, made, 1.0)] if guard is None else [(0, made, 1.0), (0, guard, -1.0)]
        one = 1.0 if guard is None else 0.0
        self._draft.sums(*terms, lower=one, upper=one, kind="performance")
        return made

    def _change_over(self, node: nodes.Until, step: int, guard: Guard) -> None:
        steps = range(node.low, node.high + 1)
        chosen = self._choices(len(steps), guard)
        for late, choice in zip(steps, chosen, strict=True):
            self.ask(node.right, step + late, np.array([choice]))
        for late in range(node.high):
            after = chosen[max(late + 1 - node.low, 0) :]
            self.ask(node.left, step + late, guard if len(after) == len(chosen) else after)

    def _never(self, guard: Guard) -> None:
        """What cannot be is not asked for; what is asked for anyway the model itself refuses."""
        if guard is not None:
            self._draft.sums((0, guard, 1.0), lower=0.0, upper=0.0, kind="performance")

    def _count(self, node: Count | Known, step: int, guard: Guard) -> None:
        """What must hold anyway the model asks for already."""
        if guard is None:
            return
        encoder, needed = self._atoms.of(node)
        bounds = needed.bounds
        guards: Iterable[Ints] = [guard] * len(bounds)
        if not needed.every and len(bounds) > 1:
            guards = [np.array([choice]) for choice in self._choices(len(bounds), guard)]
        for bound, own in zip(bounds, guards, strict=True):
            slack = encoder.slack(bound, step)
            if slack.low < 0:
                terms = (0, slack.columns, slack.factor), (0, own, slack.low)
                self._draft.sums(*terms, lower=slack.low - slack.constant, kind="performance")

    def _task(self, node: Execution, step: int, guard: Guard) -> None:
        """A task is worth what those do who are there; some must be executed for that."""
        mission, states = self._setting.mission, self._states(node)
        for state in states if node.resources or mission.books else ():
            self._executed(Executed(node, state), step, guard)
        served = self._serving(node, step)
        if guard is None:
            for worth, columns in served:
                for column in columns.tolist():
                    self.worth[column] = self.worth.get(column, 0.0) + worth
            return
        if not served:
            return
        most = float(max(worth for worth, _ in served))
        most *= len(states) * sum(number for _, number in node.needs)
        own = int(self._draft.columns(1, upper=most)[0])
        terms = [(0, columns, worth) for worth, columns in served]
        self._draft.sums(*terms, (0, [own], -1.0), kind="performance")
        self._draft.sums((0, guard, most), (0, [own], -1.0), kind="performance")
        self.worth[own] = 1.0

    def _states(self, node: Execution) -> list[int]:
        arrays, system = self._setting.arrays, self._setting.mission.system
        found: list[int] = arrays.states_with(system, node.label).tolist()
        return found

    def _executed(self, bound: Executed, step: int, guard: Guard) -> None:
        timed = self._executions.get(bound)
        if timed is None or not timed.first <= step <= timed.last:
            self._never(guard)
        elif guard is not None:
            own = (0, [int(timed.columns[step - timed.first])], 1.0)
            self._draft.sums(own, (0, guard, -1.0), kind="performance")

    def _serving(self, node: Execution, step: int) -> list[tuple[float, Ints]]:
        """Columns of those who serve a task from a step on, by what each of them is worth."""
        if (node, step) not in self._served:
            kinds = tuple(dict.fromkeys(kind for _, kind in self._kinds))
            able = self._rules.serving(node, kinds)
            found = []
            for state in self._states(node):
                serve = [self._who(serving, node, state, step) for serving in able]
                self._room(node, able, serve)
                found += [(float(s.worth), columns) for s, columns in zip(able, serve, strict=True)]
            self._served[node, step] = found
        return self._served[node, step]

    def _who(self, serving: Serving, node: Execution, state: int, step: int) -> Ints:
        """A column of those of a kind who serve: no more than are there at every step."""
        most = sum(number for _, number in node.needs)
        made = self._draft.columns(1, upper=float(most))
        mine = [n for n, kind in self._kinds if kind == serving.kind]
        network = Network(tuple(self._network.classes[n] for n in mine), self._network.horizon)
        for time in range(step, step + node.last + 1):
            here, constant = network.present(np.array([state]), None, time)
            terms = (0, here, 1.0), (0, made, -1.0)
            self._draft.sums(*terms, lower=-float(constant), kind="performance")
        return made

    def _room(self, node: Execution, able: Sequence[Serving], serve: Sequence[Ints]) -> None:
        """Each serves one need: of every set of capabilities no more than there is to do."""
        for some, room in rooms(node):
            mine = [columns for s, columns in zip(able, serve, strict=True) if s.needs <= some]
            if mine:
                terms = [(0, columns, 1.0) for columns in mine]
                self._draft.sums(*terms, lower=-np.inf, upper=float(room), kind="performance")
