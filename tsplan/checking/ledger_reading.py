"""What a plan does with resources, read against the mission alone."""

from __future__ import annotations

from collections import Counter, defaultdict
from collections.abc import Iterator, Sequence
from dataclasses import replace
from fractions import Fraction
from typing import TYPE_CHECKING, NamedTuple

from tsplan.checking.team_check import told
from tsplan.exact import digits, exact
from tsplan.logic import Execution, walk
from tsplan.name_runs import Names, Run, RunMap, overlaid
from tsplan.plans.begun_loads import begun_loads
from tsplan.plans.bundles import Agents
from tsplan.plans.cargo_rows import CargoRows
from tsplan.plans.ledger import FORGIVEN, Haul, Ledger, Use
from tsplan.plans.structures import Structure

if TYPE_CHECKING:
    from tsplan.mission import Mission, Resource
    from tsplan.plans.cargo_rows import CargoRow
    from tsplan.plans.loading import Walker
    from tsplan.plans.plan import Plan
    from tsplan.ts import Edge

_NOTHING = Fraction(0)


def read_ledger(mission: Mission, plan: Plan) -> tuple[Ledger, list[str]]:
    """What a plan does with resources, and what of it cannot be."""
    hauls, problems = _read_cargo(mission, plan)
    uses, wrong = _read_executions(mission, plan)
    found = {
        (name, state, world.step): exact(amount)
        for world in plan.replanned
        for name, amounts in world.stocks.items()
        for state, amount in amounts.items()
    }
    resources = _really_brought(mission, plan) if plan.replanned else mission.resources
    ledger = Ledger(resources, plan.horizon, tuple(hauls), tuple(uses), found)
    return ledger, problems + wrong


def _really_brought(mission: Mission, plan: Plan) -> tuple[Resource, ...]:
    """The resources with what those brought that started under way, where they came in the end."""
    others = {each.class_name for each in plan.structures}
    robots = Agents.of(plan.agents).only(lambda bundle: bundle.class_name not in others)
    brought: dict[str, list[tuple[str, int, float]]] = defaultdict(list)
    for each in begun_loads(mission, robots, plan.structures):
        if each.who.stays:
            first, _, state = each.who.stays[0]
            total = float(exact(each.amount) * each.names.size)
            brought[each.resource].append((state, first, total))
    every = mission.resources
    return tuple(replace(item, brought=tuple(brought[item.name])) for item in every)


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
                lost = _lost(plan, loaded)
                mine, wrong = (lost, []) if lost else _hauled(mission, loaded)
                hauls += mine
                problems += wrong or _overloaded(mission, loaded)
    return hauls, problems


class _Loaded(NamedTuple):
    """Agents that carry the same loads from a step on; `who` is None if the plan has no such."""

    names: Run
    step: int
    who: Walker | None
    loads: Sequence[CargoRow]


def _lost(plan: Plan, loaded: _Loaded) -> list[Haul]:
    """What agents carried that were lost on the way, which comes nowhere before the end."""
    names, step, who, loads = loaded
    if not plan.replanned or who is None or who.heading or who.stays[-1][1:2] != (step,):
        return []
    state, never = who.stays[-1][2], plan.horizon + 1
    return [
        Haul(names, row.resource, state, state, step, never, exact(row.amount) * names.size)
        for row in loads
    ]


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
    known = {node.task: node for node in walk(mission.counted) if isinstance(node, Execution)}
    uses, problems = [], []
    for item, times in Counter(plan.executions).items():
        what = f"{item.task} is executed at {item.state} at step {item.step}"
        task = known.get(item.task)
        if task is None:
            problems.append(f"{what}, and the mission has no such task to execute")
            continue
        last, ends = item.step + task.last, item.given_up
        if item.state not in mission.system.labels.get(task.label, ()):
            problems.append(f"{what}, which does not have the label {task.label}")
        elif last > plan.horizon:
            problems.append(f"{what} and lasts until step {last}, beyond the horizon")
        elif times > 1:
            problems.append(f"{what} twice")
        elif ends is not None and not item.step < ends <= last:
            problems.append(f"{what}, and is given up at step {ends}, when it is not")
        else:
            last = last if ends is None else ends - 1
            uses.append(Use(task, item.state, item.step, last, ends is None))
    return uses, problems
