"""Planning again where tasks are executed: against everything that can still be done."""

from __future__ import annotations

import random
from collections.abc import Callable, Iterator
from dataclasses import dataclass, replace
from itertools import chain, combinations
from math import inf

import numpy as np
import pytest

import tsplan
from tests.deliveries import GARDEN, WALL, building
from tests.joint_plans import JointPlan, Path, how_many, joint_plans
from tests.module_missions import TooManyError
from tests.resource_missions import (
    Depot,
    Done,
    Now,
    random_booked_mission,
    random_resource_mission,
)
from tests.seeds import seed_blocks
from tests.test_replanning import SENSE, Past, whole_trace
from tsplan import Mission, Plan
from tsplan.checking.ledger_reading import read_ledger
from tsplan.errors import PlanError
from tsplan.logic.evaluation import CountTrace, robustness
from tsplan.mission import UnderWay, mission_from_text
from tsplan.replanning.execution import Execution
from tsplan.replanning.receding_horizon import plan_in_pieces
from tsplan.replanning.replanner import replan
from tsplan.replanning.simulated_fleet import Chances, SimulatedFleet
from tsplan.testing.random_beginnings import with_starts_under_way

MOST = 300
"""Ways to go on of a mission, each with all that can be done with its resources."""


LARGEST = 2_000
"""Different things that may have been done by a step of one way to go on."""


@dataclass(frozen=True)
class Whole:
    """What happened and one way to go on, as one joint plan of a whole mission."""

    past: Past
    joint: JointPlan

    @property
    def paths(self) -> list[Path]:
        mission, step = self.past.mission, self.past.step
        later = dict(zip(self.past.places, self.joint.paths, strict=True))
        gone = (None,) * (mission.horizon + 1 - step)
        found = []
        for agent in mission.agents:
            path = later.get(agent.id)
            ahead = gone if path is None else path.states
            entered = () if path is None else path.entered
            moves = tuple((a, b, begun + step, steps) for a, b, begun, steps in entered)
            states = (*self.past.states[agent.id][:step], *ahead)
            found.append(Path(states, moves, 0, 0.0, 0))
        return found

    def trace(self) -> CountTrace:
        return whole_trace(self.past, self.joint)


class Stores:
    """What lies where and who carries what at a step, by the plan and what became of robots."""

    def __init__(self, past: Past, plan: Plan) -> None:
        self.past, self.plan = past, plan
        mission, step = past.mission, past.step
        self.names = [item.name for item in mission.resources]
        self.states = list(mission.system.states)
        self.lying = np.zeros((len(self.names), len(self.states)), dtype=int)
        self.coming: set[tuple[int, int, int, int, int]] = set()
        for r, item in enumerate(mission.resources):
            for state, amount in item.at:
                self.lying[r, self.states.index(state)] += round(amount)
        for number, agent in enumerate(mission.agents):
            if isinstance(agent.start, UnderWay):
                for name, amount in agent.start.carrying:
                    self._arrive(number, agent.id, name, round(amount), None)
        numbers = {agent.id: number for number, agent in enumerate(mission.agents)}
        for item in plan.cargo:
            if item.step < step:
                (source,) = [s for _, last, s in plan.agent[item.agent].stays if last == item.step]
                amount = round(item.amount)
                self.lying[self.names.index(item.resource), self.states.index(source)] -= amount
                self._arrive(numbers[item.agent], item.agent, item.resource, amount, item.step)
        tasks = {str(node): node for node in tsplan.logic.walk(mission.formula)}
        self.begun = [each for each in plan.executions if each.step < step]
        for each in self.begun:
            for r, item in enumerate(mission.resources):
                need = round(dict(tasks[each.task].resources).get(item.name, 0))
                self.lying[r, self.states.index(each.state)] -= need * item.consumed
        self.open = [each for each in self.begun if each.step + tasks[each.task].duration >= step]

    def _arrive(self, number: int, name: str, resource: str, amount: int, left: int | None) -> None:
        """An amount that a robot carries comes to where that has come, or is on its way to."""
        stays = self.plan.agent[name].stays
        later = [stay for stay in stays if left is None or stay[0] > left]
        if later and later[0][0] < self.past.step:
            self.lying[self.names.index(resource), self.states.index(later[0][2])] += amount
            return
        place, arrives = self.past.places.get(name), self.past.step
        if isinstance(place, UnderWay):
            place, arrives = place.target, place.arrives + self.past.step
        if place is not None:
            at = self.states.index(place)
            self.coming.add((arrives, self.names.index(resource), at, amount, number))

    def beginnings(self) -> Iterator[Now]:
        """What has begun may be given up."""
        lying = tuple(tuple(row) for row in self.lying.tolist())
        every = (combinations(self.open, size) for size in range(len(self.open) + 1))
        for given_up in chain.from_iterable(every):
            kept = frozenset((e.task, e.state, e.step) for e in self.begun if e not in given_up)
            yield Now(lying, frozenset(self.coming), Done(kept, 0.0, inf))


def goings_on(past: Past, stores: Stores, joint: JointPlan) -> Iterator[tuple[Whole, Done]]:
    """All that can be done on one way to go on."""
    whole = Whole(past, joint)
    depot = Depot(past.mission, whole, 1.0)  # type: ignore[arg-type]
    now = set(stores.beginnings())
    for step in range(past.step, past.mission.horizon + 1):
        there = {depot.arrived(here, step) for here in now}
        for name, amounts in past.said.get("stocks", {}).items() if step == past.step else ():
            there = {with_stock(here, stores, name, amounts) for here in there}
        now = {after for here in there for after in depot.executions(here, step)}
        if len(now) > LARGEST:
            raise TooManyError
        if step < past.mission.horizon:
            now = {after for here in now for after in depot.departures(here, step)}
    yield from ((whole, here.done) for here in now)


def with_stock(here: Now, stores: Stores, name: str, amounts: dict[str, int]) -> Now:
    lying = [list(row) for row in here.lying]
    for state, amount in amounts.items():
        lying[stores.names.index(name)][stores.states.index(state)] = amount
    return replace(here, lying=tuple(map(tuple, lying)))


def best_continuation(past: Past, plan: Plan) -> tuple[float, ...] | None:
    """The best values of all ways to go on, signed to be minimised."""
    mission, found = past.mission, None
    stores, states = Stores(past, plan), list(past.mission.system.states)
    for joint in joint_plans(past.continued(mission.system)):
        judged: dict[frozenset[tuple[str, str, int]], float] = {}
        for whole, done in goings_on(past, stores, joint):
            if done.executed not in judged:
                counts, tables = whole.trace(), {}
                for task, state, step in done.executed:
                    none = np.zeros((len(states), mission.horizon + 1), bool)
                    tables.setdefault(task, none)[states.index(state), step] = True
                trace = replace(counts, executions=tables)
                judged[done.executed] = float(robustness(mission.counted, trace)[0])
            spare = judged[done.executed]
            if spare < 0:
                continue
            last = joint.worth("makespan")
            own = {
                "availability": spare,
                "haulage": done.haulage,
                "makespan": last + past.step if last else 0,
            }
            value = tuple(
                float(SENSE[name] * (own[name] if name in own else joint.worth(name)))
                for name in mission.objective
            )
            found = value if found is None else min(found, value)
    return found


SENSE = {**SENSE, "haulage": 1}


def disturbed(mission: Mission, plan: Plan, seed: int) -> Past:
    draw = random.Random(seed)
    eventful = [item.step + 1 for item in (*plan.executions, *plan.cargo)] or [0]
    often = min(draw.choice(eventful), mission.horizon)
    past = Past(mission, plan, draw.choice([often, draw.randint(0, mission.horizon)]))
    names = list(past.places)
    kind = draw.choice(["nothing", "nothing", "lost", "moved", "late", "spilled"])
    if kind == "lost" and len(names) > 1 and past.step:
        past.lose(draw.choice(names))
    if kind == "moved" and past.step:
        past.move(draw.choice(names), draw.choice(list(mission.system.states)))
    away = [name for name, place in past.places.items() if isinstance(place, UnderWay)]
    if kind == "late" and away:
        past.delay(plan, draw.choice(away), draw.randint(1, 2))
    if kind == "spilled" and mission.resources:
        state, item = draw.choice(list(mission.system.states)), draw.choice(mission.resources)
        past.said["stocks"] = {item.name: {state: draw.randint(0, 2)}}
    return past


def resources(seed: int) -> Mission:
    made = random_resource_mission(seed, most=2)
    return with_starts_under_way(made, seed) if seed % 3 == 0 else made


def exclusive(seed: int) -> Mission:
    return random_booked_mission(seed, "exclusive")


def by_label(seed: int) -> Mission:
    return random_booked_mission(seed, "per-label")


def test_what_was_to_be_brought_is_lost_with_who_brings_it() -> None:
    compare(resources(594), 594)  # it started under way and was lost before it came anywhere


@pytest.mark.parametrize("draw", [resources, exclusive, by_label])
@pytest.mark.parametrize("seeds", seed_blocks(range(6), range(1500), 8))
def test_what_is_executed_goes_on_as_well_as_can_be(
    draw: Callable[[int], Mission], seeds: list[int]
) -> None:
    for seed in seeds:
        compare(draw(seed), seed)


def compare(mission: Mission, seed: int) -> None:
    kept = tuple(name for name in mission.objective if name != "reserve")
    mission = replace(mission, objective=kept)
    plan = tsplan.plan(mission)
    if not plan.has_paths:
        return
    past = disturbed(mission, plan, seed)
    if how_many(past.continued(mission.system)) > MOST:
        return
    try:
        expected = best_continuation(past, plan)
    except TooManyError:
        return
    made = replan(mission, plan, past.step, **past.said)
    if expected is None:
        assert made.status == "infeasible", (seed, past.step, past.said)
        return
    assert (made.status, made.verified) == ("optimal", True), (seed, past.step, past.said)
    values = {item.name: inf if item.value is None else item.value for item in made.objective}
    found = tuple(SENSE[name] * values[name] for name in mission.objective)
    assert found == pytest.approx(expected, abs=1e-6), (seed, past.step, past.said)
    assert tsplan.check(mission, Plan.from_json(made.to_json())).ok, seed
    told = {(each.resource, each.state): each.amounts for each in made.stocks}
    ledger, problems = read_ledger(mission, made)
    assert not problems
    assert {(each.resource, each.state): each.amounts for each in ledger.histories} == told, seed
    rest = tsplan.rest_mission(mission, plan, past.step, **past.said)
    again = mission_from_text(rest.to_yaml())
    assert (again.formula, again.team) == (rest.formula, rest.team), seed


def late(step: int, **said: object) -> tuple[Mission, Plan]:
    """What is left of building a wall when a man comes late, and perhaps more has happened."""
    mission, plan = building()
    return mission, replan(mission, plan, step, **said)


def test_what_was_not_there_was_not_used() -> None:
    mission, made = late(4, late={"man-1": 2})
    done = [(each.task, each.step) for each in made.executions]
    assert sorted(done) == [(GARDEN, 4), (GARDEN, 6), (WALL, 4)]  # a brick and the drill come at 4
    assert tsplan.check(mission, made).ok
    brick = next(each for each in made.stocks if (each.resource, each.state) == ("brick", "wall"))
    assert brick.amounts == ((0, 1.0), (2, 2.0), (4, 3.0), (5, 0.0))
    assert made.status == "optimal"


def test_what_does_not_lie_there_is_not_carried_away() -> None:
    mission, made = late(5, late={"cart-1": 1})  # so it was not at the garden by step 4
    assert made.status == "infeasible"
    assert made.notes == (f"cannot hold any more: F[4,4] {GARDEN}",)
    mission, plan = building()
    brick, water, drill = mission.resources
    scarce = replace(water, at=(("yard", 1.0),))
    mission = replace(mission, resources=(brick, scarce, drill))
    rest = tsplan.rest_mission(mission, plan, 2)
    (way,) = [way for group in rest.team for way, _ in group.coming]
    assert way.carrying == (("water", 1.0),)


def test_what_was_lost_on_the_way_is_gone_with_all_of_it() -> None:
    mission, plan = building()
    rest = tsplan.rest_mission(mission, plan, 1, lost=["man-1"])
    lying = {item.name: dict(item.at) for item in rest.resources}
    assert lying == {"brick": {"yard": 2.0, "wall": 1.0}, "water": {"yard": 2.5}, "drill": {}}
    assert replan(mission, plan, 1, lost=["man-1"]).status == "infeasible"
    found = replan(mission, plan, 1, lost=["man-1"], stocks={"drill": {"yard": 1}})
    assert "1 drill at yard" in str(found)


def test_who_leaves_gives_a_task_up() -> None:
    mission = mission_from_text(TWO_SITES)
    plan = tsplan.plan(mission)
    (begun,) = [each for each in plan.executions if each.state == "wall"]
    step = begun.step + 1
    rest = tsplan.rest_mission(mission, plan, step)
    assert f"begun({begun.task},1)" in rest.text
    made = replan(mission, plan, step, demanded=["F[0,2] T(0,tower,{(lay,2)})"])
    assert [each.given_up for each in made.executions if each.state == "wall"] == [step, None]
    assert "given up at step" in str(made)
    assert tsplan.check(mission, made).ok
    kept = replace(made, executions=tuple(replace(e, given_up=None) for e in made.executions))
    assert not tsplan.check(mission, kept).ok


TWO_SITES = """
format: tsplan-mission/1
map:
  waiting: true
  states: {wall: {}, tower: {}}
  edges: [{from: wall, to: tower, duration: 1, both_ways: true}]
resources: [{name: brick, at: {wall: 4}, indivisible: true}]
team: [{class: man, count: 2, at: wall, capabilities: [lay], carries: 1}]
spec: {language: catl, formula: "F[0,9] T(3,wall,{(lay,2)},{(brick,2)})"}
objective: [makespan, travel]
booking: exclusive
horizon: 14
"""


def test_stocks_of_what_is_not_there_are_refused() -> None:
    mission, plan = building()
    said = {"brik": {"wall": 1}, "brick": {"wal": 1, "wall": 0.5}}
    with pytest.raises(PlanError) as error:
        replan(mission, plan, 3, stocks=said)
    assert [finding.message for finding in error.value.findings] == [
        "the mission has no resource 'brik'",
        "the map has no state 'wal', where brick is said to lie",
        "'brick' comes in whole pieces, and 0.5 is no whole number",
    ]


def test_what_is_demanded_of_places_that_are_not_there_is_refused() -> None:
    mission, plan = building()
    with pytest.raises(PlanError) as error:
        replan(mission, plan, 3, demanded=["F[0,2] towr", "T(0,gardn,{(lay,1)})"])
    assert [finding.message for finding in error.value.findings] == [
        "no state of the map has the label 'towr' (F[0,2] towr)",
        "no state of the map has the label 'gardn' (T(0,gardn,{(lay,1)}))",
    ]


def larger(seed: int) -> Mission:
    return random_resource_mission(seed, states=4, robots=4, steps=9, parted=seed % 4 == 0)


def booked(seed: int) -> Mission:
    return random_booked_mission(seed, "exclusive", robots=4, steps=7)


@pytest.mark.parametrize("draw", [larger, booked])
@pytest.mark.parametrize("seeds", seed_blocks(range(2), range(600), 6))
def test_executions_are_those_that_robots_and_amounts_were_there_for(
    draw: Callable[[int], Mission], seeds: list[int]
) -> None:
    met = {False: 0, True: 0}
    for seed in seeds:
        mission = draw(seed)
        plan = tsplan.plan(mission)
        for replanning in met if plan.has_paths else ():
            fleet = SimulatedFleet(mission, Chances(0.2, 0.02, 0.05), seed)
            done = Execution(mission, plan, fleet, tsplan.plan if replanning else None).run()
            assert tsplan.check(mission, done.plan).ok == done.met, (seed, replanning)
            met[replanning] += done.met
    assert met[True] >= met[False]


@pytest.mark.parametrize("draw", [larger, booked])
@pytest.mark.parametrize("seeds", seed_blocks(range(4), range(4, 400), 4))
def test_pieces_go_on_with_what_lies_there(
    draw: Callable[[int], Mission], seeds: list[int]
) -> None:
    found = 0
    for seed in seeds:
        mission = draw(seed)
        plan, whole = plan_in_pieces(mission, 5, 2), tsplan.plan(mission)
        found += plan.has_paths
        assert plan.verified == plan.has_paths, seed
        assert whole.has_paths or not plan.has_paths, seed
        assert plan.status != "infeasible" or not whole.has_paths, seed
    assert found or seeds[0]  # most of the first have a plan, and of others perhaps none
