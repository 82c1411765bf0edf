"""What has become of resources until a step: what was carried, what was executed, what lies where.

What was planned has happened as far as it could. A task of which robots or amounts were not there
has not been executed, and what did not lie there was not carried away. Who is lost on the way is
lost with all that it carried.
"""

from __future__ import annotations

from collections import defaultdict
from collections.abc import Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass, field, replace
from fractions import Fraction
from math import floor
from typing import TYPE_CHECKING, NamedTuple, TypeAlias

from tsplan.errors import Finding, PlanError, nearest
from tsplan.exact import exact
from tsplan.logic import Execution, Formula, walk
from tsplan.name_runs import Run, RunMap, overlaid
from tsplan.plans.begun_loads import begun_loads
from tsplan.plans.cargo_rows import CargoRow, CargoRows
from tsplan.plans.double_booking import overbooked
from tsplan.plans.ledger import Use, changes, forgiven_of
from tsplan.plans.presence import of_bundles, state_counts
from tsplan.plans.structures import of_structures
from tsplan.plans.supplies import StockHistory

if TYPE_CHECKING:
    from tsplan.history.past_paths import Past
    from tsplan.mission import Mission, Resource
    from tsplan.plans.loading import Walker
    from tsplan.plans.presence import Presence
    from tsplan.plans.supplies import ExecutedTask
    from tsplan.plans.worlds import World

Load: TypeAlias = "tuple[tuple[str, float], ...]"
"""What a robot carries: amounts of resources by their names."""

_Node: TypeAlias = tuple[str, str]  # a resource and a state
_NOTHING = Fraction(0)
_DIGITS = 6  # after the point, to which amounts are told that differ from them by rounding alone
_ROUNDING = Fraction(1, 10**7)


@dataclass(frozen=True)
class Amounts:
    """What has become of resources until a step.

    `cargo` is what was carried and `executions` what was executed, `stocks` say what lay where
    before the step. What lies there at it is in `lying`, by resource and state, and `loads` are
    what robots carry that are under way then.
    """

    cargo: CargoRows = field(default_factory=CargoRows)
    executions: tuple[ExecutedTask, ...] = ()
    stocks: tuple[StockHistory, ...] = ()
    lying: Mapping[_Node, float] = field(default_factory=dict)
    loads: RunMap[Load] = field(default_factory=RunMap)

    def left(self, resources: Iterable[Resource]) -> tuple[Resource, ...]:
        """The resources as they lie at the step."""
        lying: dict[str, dict[str, float]] = defaultdict(dict)
        for (name, state), amount in self.lying.items():
            if amount > 0:
                lying[name][state] = amount
        return tuple(replace(each, at=tuple(lying[each.name].items())) for each in resources)


def amounts_until(
    mission: Mission, past: Past, worlds: Sequence[World], formula: Formula
) -> Amounts:
    """What has become of resources until the last of some worlds.

    `past` has the paths of robots as they were, and what was to be carried and executed then; the
    `formula` is what has to hold since things have changed. Raises PlanError for stocks of what is
    not there.
    """
    findings = [finding for world in worlds for finding in _unknown(mission, world)]
    if findings:
        raise PlanError(findings)
    if not (mission.resources or mission.books):
        return Amounts()
    step = worlds[-1].step
    replay = _Replay(mission, step)
    for world in worlds:
        replay.correct(world)
    replay.bring(past)
    replay.carry(past)
    replay.execute(_staffed(mission, past, _uses(mission, past, formula), step))
    return replay.run()


def _unknown(mission: Mission, world: World) -> Iterator[Finding]:
    """What a world says of stocks and cannot be."""
    known = {each.name: each for each in mission.resources}
    for name, amounts in world.stocks.items():
        if name not in known:
            yield Finding(f"the mission has no resource '{name}'", nearest(name, known))
            continue
        for state, amount in amounts.items():
            if state not in mission.system.states:
                what = f"the map has no state '{state}', where {name} is said to lie"
                yield Finding(what, nearest(state, mission.system.states))
            if known[name].indivisible and amount != int(amount):
                what = f"'{name}' comes in whole pieces, and {amount:g} is no whole number"
                yield Finding(what, "write a whole number")


def executable(mission: Mission, *formulas: Formula) -> dict[str, Execution]:
    """The tasks that are executed of some formulas of a mission, by their texts."""
    return {
        node.task: node
        for formula in formulas
        for node in walk(mission.counting(formula))
        if isinstance(node, Execution)
    }


class _Done(NamedTuple):
    """An execution as the plan has it, and what it uses."""

    item: ExecutedTask
    use: Use


def _uses(mission: Mission, past: Past, formula: Formula) -> list[_Done]:
    known = executable(mission, mission.formula, formula)
    found = []
    for item in past.executions:
        node = known.get(item.task)
        if node is not None:
            last = item.step + node.last
            last = last if item.given_up is None else min(last, item.given_up - 1)
            found.append(_Done(item, Use(node, item.state, item.step, last)))
    return sorted(found, key=lambda done: done.use.first)


def _staffed(mission: Mission, past: Past, wanted: Iterable[_Done], step: int) -> list[_Done]:
    """The executions whose robots have been there, as far as they have come."""
    structures = of_structures(past.built.structures)
    present = [*of_bundles(past.agents.bundles), *structures]
    known: dict[tuple[str, str], Sequence[int]] = {}

    def there(state: str, capability: str) -> Sequence[int]:
        if (state, capability) not in known:
            counts = state_counts(present, [state], step, capability)
            known[state, capability] = counts[0].tolist()
        return known[state, capability]

    kept = [
        each._replace(use=use)
        for each in wanted
        for use in [each.use._replace(last=min(each.use.last, step - 1))]
        if all(
            min(there(use.state, name)[use.first : use.last + 1]) >= number
            for name, number in use.task.needs
        )
    ]
    return _booked(mission, kept, present)


def _booked(mission: Mission, kept: list[_Done], present: Sequence[Presence]) -> list[_Done]:
    """The same without those that began last where robots were too few for all of them."""
    while True:
        uses = [each.use for each in kept]
        over = next(overbooked(uses, present, mission.booking), None)
        if over is None:
            return kept
        gone = over.uses[-1]
        kept = [each for each in kept if each.use is not gone]


class _Ride(NamedTuple):
    """An amount that robots carry, the same each, to a state where they come at a step.

    The step is None for those that are under way still, who have no target where they were lost.
    """

    row: CargoRow
    source: str
    target: str
    come: int | None


class _Replay:
    """Goes through the steps until one, and tells what could be carried and executed."""

    def __init__(self, mission: Mission, step: int) -> None:
        self._mission = mission
        self._step = step
        self._of = {each.name: each for each in mission.resources}
        self._lying: dict[_Node, Fraction] = defaultdict(Fraction)
        self._coming: dict[int, list[tuple[_Node, Fraction]]] = defaultdict(list)
        self._found: dict[int, dict[_Node, Fraction]] = defaultdict(dict)
        self._leaving: dict[int, list[_Ride]] = defaultdict(list)
        self._begun: dict[int, list[_Done]] = defaultdict(list)
        self._busy: dict[_Node, list[tuple[int, Fraction]]] = defaultdict(list)
        self._cargo: list[CargoRow] = []
        self._executions: list[ExecutedTask] = []
        self._loads: list[tuple[Run, tuple[str, float]]] = []
        self._told: dict[_Node, dict[int, Fraction]] = defaultdict(dict)
        for resource in mission.resources:
            for state, amount in resource.at:
                self._coming[0].append(((resource.name, state), exact(amount)))

    def correct(self, world: World) -> None:
        """What a world says of stocks that are not as planned."""
        for name, amounts in world.stocks.items():
            for state, amount in amounts.items():
                self._found[world.step][name, state] = exact(amount)

    def bring(self, past: Past) -> None:
        """What those bring that started under way."""
        for each in begun_loads(self._mission, past.agents, past.built.structures):
            if each.who.stays:
                first, _, state = each.who.stays[0]
                total = exact(each.amount) * each.names.size
                self._coming[first].append(((each.resource, state), total))
            else:
                self._loads.append((each.names, (each.resource, each.amount)))

    def carry(self, past: Past) -> None:
        """What was to be carried, as far as robots really left then."""
        walkers: RunMap[Walker] = RunMap(past.agents.stretches)
        for each in past.built.structures:
            walkers.give(Run.of(each.id), each)
        for row in past.cargo.order:
            for part, who in walkers.parts(row.names):
                ride = None if who is None else _ride(row._replace(names=part), who)
                if ride is not None:
                    self._leaving[row.step].append(ride)

    def execute(self, done: Iterable[_Done]) -> None:
        """What was to be executed, as far as the robots were there."""
        for each in done:
            self._begun[each.use.first].append(each)

    def run(self) -> Amounts:
        """Go through all steps."""
        for step in range(self._step + 1):
            for node, amount in self._coming.get(step, ()):
                self._lying[node] += amount
            self._lying.update(self._found.get(step, {}))
            if step == self._step:
                break
            for node, amount in self._lying.items():
                self._told[node][step] = amount
            for each in self._begun.get(step, ()):
                self._execute(each)
            for ride in self._leaving.get(step, ()):
                self._load(ride)
        return Amounts(
            CargoRows.joined(self._cargo),
            tuple(self._executions),
            tuple(self._histories()),
            {node: _told(self._of[node[0]], amount) for node, amount in self._lying.items()},
            RunMap((names, tuple(load)) for names, load in overlaid(self._loads)),
        )

    def _free(self, node: _Node, step: int) -> Fraction:
        """What lies there and is not in use at a step or after it."""
        busy = (amount for last, amount in self._busy[node] if last >= step)
        return self._lying[node] - sum(busy, _NOTHING)

    def _execute(self, done: _Done) -> None:
        use = done.use
        asked = {(name, use.state): use.needs(name) for name, _ in use.task.resources}
        for node, amount in asked.items():
            if amount > self._free(node, use.first) + forgiven_of(self._of[node[0]]):
                return
        self._executions.append(done.item)
        for node, amount in asked.items():
            if self._of[node[0]].consumed:
                self._lying[node] -= amount
            else:
                self._busy[node].append((use.last, amount))

    def _load(self, ride: _Ride) -> None:
        """Load what robots carry as far as it lies there, one robot after the other."""
        row, name = ride.row, ride.row.resource
        node, each = (name, ride.source), exact(ride.row.amount)
        # tools may leave at the last step at which they are used
        free = max(self._free(node, row.step + 1), _NOTHING)
        parts = [(row.names, row.amount)]
        if each * row.names.size > free + forgiven_of(self._of[name]):
            full = floor(free / each)
            left = free - full * each
            left = Fraction(floor(left)) if self._of[name].indivisible else left
            parts = [(row.names.part(0, full), row.amount)] if full else []
            parts += [(row.names.part(full, full + 1), float(left))] if left else []
        for names, amount in parts:
            total = exact(amount) * names.size
            self._lying[node] -= total
            self._cargo.append(row._replace(names=names, amount=amount))
            if ride.come is not None:
                self._coming[ride.come].append(((name, ride.target), total))
            elif ride.target:
                self._loads.append((names, (name, amount)))

    def _histories(self) -> Iterator[StockHistory]:
        for (name, state), amounts in self._told.items():
            steps = [amounts.get(step, _NOTHING) for step in range(self._step)]
            if any(steps):
                yield StockHistory(name, state, changes(steps))


def _told(resource: Resource, amount: Fraction) -> float:
    """An amount as a file says it; what is a rounding away from few digits has these."""
    short = Fraction(round(amount, _DIGITS))
    near = not resource.indivisible and abs(short - amount) <= _ROUNDING
    return max(float(short if near else amount), 0.0)


def _ride(row: CargoRow, who: Walker) -> _Ride | None:
    """The edge that robots entered at the step of a row, if they did, and when they came."""
    for place, (_, left, source) in enumerate(who.stays):
        if left == row.step:
            later = who.stays[place + 1 :]
            if later:
                return _Ride(row, source, later[0][2], later[0][0])
            return _Ride(row, source, who.heading or "", None)
    return None
