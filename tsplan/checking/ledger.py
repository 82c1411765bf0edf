"""Stocks, cargo and executions of a plan, read against the mission alone.

Amounts are the decimal numbers that files write, added up exactly. What may be parted comes from
solvers' arithmetic, so there a stock may fall short by `FORGIVEN` of all there is; whole pieces are
counted exactly.
"""

from __future__ import annotations

import math
from collections import Counter, defaultdict
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass
from fractions import Fraction
from functools import cached_property
from typing import TYPE_CHECKING, NamedTuple

from tsplan.checking.team_check import told
from tsplan.exact import digits, exact
from tsplan.logic import Task, walk
from tsplan.name_runs import Names, Run, RunMap, overlaid
from tsplan.plans.bundles import Agents
from tsplan.plans.cargo_rows import CargoRows
from tsplan.plans.structures import Structure
from tsplan.plans.supplies import StockHistory

if TYPE_CHECKING:
    from tsplan.mission import Mission, Resource
    from tsplan.plans.cargo_rows import CargoRow
    from tsplan.plans.loading import Walker
    from tsplan.plans.plan import Plan
    from tsplan.ts import Edge

FORGIVEN = Fraction(1, 10**5)
"""Of all there is of a resource: solvers forgive 1e-6 in each of the steps that add up."""

_NOTHING = Fraction(0)


class Haul(NamedTuple):
    """An amount that leaves a state at step `left` and is at another at `come`.

    `agents` carry it together, the same amount each.
    """

    agents: Run
    resource: str
    source: str
    target: str
    left: int
    come: int
    amount: Fraction


class Use(NamedTuple):
    """A task that is executed at a state from step `first` to `last`."""

    task: Task
    state: str
    first: int
    last: int

    def needs(self, resource: str) -> Fraction:
        """How much of a resource it needs."""
        return exact(dict(self.task.resources).get(resource, 0.0))


@dataclass(frozen=True)
class Ledger:
    """What a plan does with the resources of a mission."""

    resources: tuple[Resource, ...] = ()
    horizon: int = 0
    hauls: tuple[Haul, ...] = ()
    uses: tuple[Use, ...] = ()

    @cached_property
    def _moved(self) -> tuple[Mapping[tuple[str, str, int], Fraction], ...]:
        """By resource, state and step: what comes, what is carried away, what is used up."""
        come: dict[tuple[str, str, int], Fraction] = defaultdict(Fraction)
        left: dict[tuple[str, str, int], Fraction] = defaultdict(Fraction)
        spent: dict[tuple[str, str, int], Fraction] = defaultdict(Fraction)
        for haul in self.hauls:
            left[haul.resource, haul.source, haul.left] += haul.amount
            come[haul.resource, haul.target, haul.come] += haul.amount
        for resource in self.resources:
            for state, step, amount in resource.sources:
                come[resource.name, state, step] += exact(amount)
            for use in self.uses if resource.consumed else ():
                spent[resource.name, use.state, use.first] += use.needs(resource.name)
        return come, left, spent

    @cached_property
    def lying(self) -> Mapping[tuple[str, str], tuple[Fraction, ...]]:
        """What lies there at every step, before anything is used up or carried away then."""
        come, left, spent = self._moved
        places = dict.fromkeys((name, state) for name, state, _ in (*come, *left, *spent))
        found = {}
        for name, state in places:
            here, amounts = _NOTHING, []
            for step in range(self.horizon + 1):
                here += come.get((name, state, step), _NOTHING)
                amounts.append(here)
                here -= left.get((name, state, step), _NOTHING)
                here -= spent.get((name, state, step), _NOTHING)
            found[name, state] = tuple(amounts)
        return found

    def at(self, resource: str, state: str, step: int) -> Fraction:
        """What lies of a resource at a state at a step."""
        amounts = self.lying.get((resource, state))
        return _NOTHING if amounts is None else amounts[step]

    def staying(self, resource: str, state: str, step: int) -> Fraction:
        """What stays there after a step, once everything is used up and carried away then."""
        _, left, spent = self._moved
        node = (resource, state, step)
        return self.at(*node) - left.get(node, _NOTHING) - spent.get(node, _NOTHING)

    @cached_property
    def histories(self) -> tuple[StockHistory, ...]:
        """The stocks as a plan says them."""
        order = {resource.name: number for number, resource in enumerate(self.resources)}
        return tuple(
            StockHistory(name, state, _changes(amounts))
            for (name, state), amounts in sorted(
                self.lying.items(), key=lambda item: (order[item[0][0]], item[0][1])
            )
            if any(amounts)
        )

    def asked(self, resource: Resource, state: str, step: int) -> Fraction:
        """What the executions there need at a step: what they use up then, or the tools in use."""
        needs = (
            use.needs(resource.name)
            for use in self.uses
            if use.state == state
            and use.first <= step <= (use.first if resource.consumed else use.last)
        )
        return sum(needs, _NOTHING)

    @property
    def haulage(self) -> Fraction:
        """Amounts times the steps they are moved."""
        return sum((haul.amount * (haul.come - haul.left) for haul in self.hauls), _NOTHING)

    @property
    def reserve(self) -> Fraction | float:
        """The least amount left at any execution beside what is needed; infinite without any."""
        left = (
            self.at(resource.name, use.state, use.first)
            - self.asked(resource, use.state, use.first)
            for resource in self.resources
            for use in self.uses
            if use.needs(resource.name)
        )
        return min(left, default=math.inf)

    def shortages(self) -> Iterator[str]:
        """Where more is used or carried away than there is."""
        _, left, spent = self._moved
        for resource in self.resources:
            name = resource.name
            forgiven = (
                _NOTHING if resource.indivisible else FORGIVEN * max(Fraction(1), resource.total)
            )
            nodes = {node[1:] for node in (*left, *spent) if node[0] == name}
            if not resource.consumed:
                busy = (use for use in self.uses if use.needs(name))
                nodes |= {(u.state, step) for u in busy for step in range(u.first, u.last + 1)}
            for state, step in sorted(nodes, key=lambda node: (node[1], node[0])):
                if step > self.horizon:
                    continue
                here = self.at(name, state, step)
                away = left.get((name, state, step), _NOTHING)
                needed = self.asked(resource, state, step)
                wanted = away + needed if resource.consumed else max(away, needed)
                if wanted > here + forgiven:
                    yield (
                        f"{digits(wanted)} of {name} are used or carried away at {state} at step "
                        f"{step}, and {digits(here)} lie there"
                    )


def _changes(amounts: Sequence[Fraction]) -> tuple[tuple[int, float], ...]:
    """The steps from which another amount lies there."""
    found: list[tuple[int, float]] = []
    for step, amount in enumerate(amounts):
        if not found or found[-1][1] != float(max(amount, _NOTHING)):
            found.append((step, float(max(amount, _NOTHING))))
    return tuple(found)


def read_ledger(mission: Mission, plan: Plan) -> tuple[Ledger, list[str]]:
    """What a plan does with resources, and what of it cannot be."""
    hauls, problems = _read_cargo(mission, plan)
    uses, wrong = _read_executions(mission, plan)
    return Ledger(mission.resources, plan.horizon, tuple(hauls), tuple(uses)), problems + wrong


def _read_cargo(mission: Mission, plan: Plan) -> tuple[list[Haul], list[str]]:
    """What is hauled, and what of it cannot be; whoever carries the same is told of together."""
    steps: dict[int, list[tuple[Run, CargoRow]]] = defaultdict(list)
    for row in CargoRows.of(plan.cargo).order:
        steps[row.step].append((row.names, row))
    walkers: RunMap[Walker] = RunMap(Agents.of(plan.agents).stretches if steps else ())
    for each in plan.structures if steps else ():
        walkers.give(Run.of(each.id), each)
    hauls: list[Haul] = []
    problems: list[str] = []
    for step, rows in sorted(steps.items()):
        for names, loads in overlaid(rows):
            for part, who in walkers.parts(names):
                loaded = _Loaded(part, step, who, loads)
                mine, wrong = _hauled(mission, loaded)
                hauls += mine
                problems += wrong or _overloaded(mission, loaded)
    return hauls, problems


class _Loaded(NamedTuple):
    """Agents that carry the same loads from a step on; `who` is None if the plan has no such."""

    names: Run
    step: int
    who: Walker | None
    loads: Sequence[CargoRow]


def _hauled(mission: Mission, loaded: _Loaded) -> tuple[list[Haul], list[str]]:
    """What some agents haul, and what of it cannot be."""
    names, step, who, loads = loaded
    resources = {item.name: item for item in mission.resources}
    ride = None if who is None else _ride(mission, who, step)
    times = Counter(row.resource for row in loads)
    hauls, problems = [], []
    for row in loads:
        what = f"{told(Names((names,)))} carries {row.resource} from step {step} on"
        if row.resource not in resources:
            problems.append(f"{what}, which the mission does not have")
        elif who is None:
            problems.append(f"{what} and is not in the plan")
        elif ride is None:
            problems.append(f"{what} and enters no edge then but a wait")
        elif times[row.resource] > 1:
            problems.append(f"{what} twice")
        elif resources[row.resource].indivisible and row.amount != int(row.amount):
            problems.append(f"{what}: {row.amount} pieces, which is no whole number")
        else:
            hauls.append(Haul(names, row.resource, *ride, exact(row.amount) * names.size))
    return hauls, list(dict.fromkeys(problems))


def _ride(mission: Mission, agent: Walker, step: int) -> tuple[str, str, int, int] | None:
    """The edge that an agent enters at a step, which is no wait: its ends and its two steps."""
    for place, (_, left, source) in enumerate(agent.stays):
        if left != step:
            continue
        if place + 1 < len(agent.stays):
            come, _, target = agent.stays[place + 1]
            return (source, target, left, come) if target != source else None
        edge = mission.system.edges.get((source, agent.heading or ""))
        duration = None if edge is None else _duration(mission, agent, edge)
        if edge is not None and duration is not None and not edge.is_wait:
            return source, edge.target, left, left + duration
    return None


def _duration(mission: Mission, agent: Walker, edge: Edge) -> int | None:
    """How long an agent or a structure needs for an edge."""
    if isinstance(agent, Structure):
        return mission.modular.of[agent.configuration].steps(edge, agent.class_name)
    return edge.duration_for(agent.class_name)


def _overloaded(mission: Mission, loaded: _Loaded) -> Iterator[str]:
    """Agents that carry more than they can."""
    names, step, who, loads = loaded
    if isinstance(who, Structure):
        limits = [(names, mission.modular.of[who.configuration].carries)]
    else:
        limits = [
            (part, () if rank is None else mission.team[rank.group].carries)
            for part, rank in mission.roster.parts(names)
        ]
    amounts = [(exact(row.amount), row.resource) for row in loads]
    everything = sum((amount for amount, _ in amounts), _NOTHING), "everything together"
    for part, limit in limits:
        if isinstance(limit, tuple):
            own = dict(limit)
            rooms = [(*each, exact(own.get(each[1], 0.0))) for each in amounts]
        else:
            rooms = [(*everything, exact(limit))]
        for amount, what, room in rooms:
            if amount > room * (1 + FORGIVEN):
                yield (
                    f"{told(Names((part,)))} carries {digits(amount)} of {what} at step {step}, "
                    f"and can carry {digits(room)}"
                )


def _read_executions(mission: Mission, plan: Plan) -> tuple[list[Use], list[str]]:
    known = {
        str(node): node
        for node in walk(mission.formula)
        if isinstance(node, Task) and (node.resources or mission.books)
    }
    uses, problems = [], []
    for item, times in Counter(plan.executions).items():
        what = f"{item.task} is executed at {item.state} at step {item.step}"
        task = known.get(item.task)
        if task is None:
            problems.append(f"{what}, and the mission has no such task to execute")
            continue
        last = item.step + task.duration - (mission.task_interval != "closed")
        if item.state not in mission.system.labels.get(task.label, ()):
            problems.append(f"{what}, which does not have the label {task.label}")
        elif last > plan.horizon:
            problems.append(f"{what} and lasts until step {last}, beyond the horizon")
        elif times > 1:
            problems.append(f"{what} twice")
        else:
            uses.append(Use(task, item.state, item.step, last))
    return uses, problems
