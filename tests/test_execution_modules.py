"""Carrying out plans of modular robots: by chance, with robots of another process, in pieces."""

from __future__ import annotations

import json
import random
import sys
from collections.abc import Sequence
from dataclasses import replace
from functools import cache

import pytest

import tsplan
from tests.command_line import ROOT, here
from tests.module_missions import random_module_mission
from tests.rich_missions import random_rich_mission
from tests.seeds import sampled, seed_blocks
from tests.watched_fleet import Watched, slack
from tsplan import Mission, Plan
from tsplan.errors import PlanError
from tsplan.history.joined_structures import modules_along
from tsplan.logic import parse
from tsplan.mission.read import load_mission
from tsplan.plans.bundles import Agents
from tsplan.plans.outcomes import ObjectiveValue, Status
from tsplan.plans.structures import Rebuilt, Structure
from tsplan.replanning.execution import Executed, Execution
from tsplan.replanning.replanner import replan
from tsplan.replanning.robot_fleet import Assembly, MoveOrder, Order, RebuildOrder, Seen
from tsplan.replanning.simulated_fleet import Chances, SimulatedFleet
from tsplan.stopping import StoppedBy

FENCE = ROOT / "environments" / "fence_build.yaml"
WORTH = {"a": {"duo": 2, "trio": 3}, "b": {"one": 1, "trio": 2}}


def carried_out(mission: Mission, plan: Plan, fleet: SimulatedFleet, *, again: bool) -> Executed:
    return Execution(mission, plan, fleet, tsplan.plan if again else None).run()


def was_there(plan: Plan, step: int) -> dict[str, str]:
    """Who was at which state: structures, and robots that are of none."""
    modules = {module for each in plan.structures for module in each.modules}
    robots = [agent for agent in plan.agents if agent.id not in modules]
    bodies = [each for each in plan.structures if each.first <= step <= each.last]
    every: list[Structure | tsplan.AgentPlan] = [*robots, *bodies]
    return {each.id: state for each in every if (state := each.state_at(step))}


def met_truly(mission: Mission, plan: Plan, fleet: Watched, *, again: bool) -> bool:
    """Whether the formula held, where what happened is told as the fleet wrote it down."""
    done = carried_out(mission, plan, fleet, again=again)
    for step, places in enumerate(fleet.states):
        there = {name: state for name, state in places.items() if state}
        assert was_there(done.plan, step) == there, (fleet.seed, step)
    assert done.availability == slack(mission, fleet), fleet.seed
    if done.met:
        assert tsplan.check(mission, Plan.from_json(done.plan.to_json())).ok, fleet.seed
    return done.met


@pytest.mark.parametrize("seeds", seed_blocks(range(14), range(2000), 20))
def test_what_happened_is_what_structures_did_and_planning_again_helps(seeds: list[int]) -> None:
    met = {False: 0, True: 0}
    for seed in seeds:
        mission = random_module_mission(seed, steps=6, modules=5)
        plan = tsplan.plan(mission)
        chances = Chances(random.Random(seed).choice([0.2, 0.5]), 0.01, 0.05)
        for again in met if plan.has_paths else ():
            fleet = Watched(mission, chances, seed)
            met[again] += met_truly(mission, plan, fleet, again=again)
    assert met[True] >= met[False]


@pytest.mark.parametrize("seeds", seed_blocks(range(7), range(600), 20))
def test_what_structures_carried_is_what_the_check_finds(seeds: list[int]) -> None:
    for seed in seeds:
        mission = random_rich_mission(seed)
        if not mission.modular or mission.partial or mission.prefer:
            continue
        plan = tsplan.plan(mission)
        for again in (False, True) if plan.has_paths else ():
            fleet = Watched(mission, Chances(0.3, 0.02, 0.03), seed)
            done = carried_out(mission, plan, fleet, again=again)
            assert not done.met or tsplan.check(mission, done.plan).ok, seed


@cache
def fence() -> tuple[Mission, Plan]:
    mission = load_mission(str(FENCE))
    return mission, tsplan.plan(mission)


class Told(SimulatedFleet):
    """A fleet of which more is told at some steps."""

    more: dict[int, dict[str, object]]

    def advance(self, step, orders):
        self.orders = [*getattr(self, "orders", []), *orders]
        seen = super().advance(step, orders)
        return Seen(seen.step, {**seen.places, **self.more.get(seen.step, {})})


def told(mission: Mission, plan: Plan, more: dict[int, dict[str, object]]) -> Executed:
    fleet = Told(mission, Chances(), 0)
    fleet.more = more
    return carried_out(mission, plan, fleet, again=False)


def test_where_nothing_happens_the_plan_is_carried_out() -> None:
    mission, plan = fence()
    fleet = Told(mission, Chances(), 0)
    fleet.more = {}
    assert carried_out(mission, plan, fleet, again=True).plan == plan
    assert {o.done for o in fleet.orders if isinstance(o, RebuildOrder)} == {2, 3, 4}
    line = next(each for each in plan.structures if each.id == "line-2")
    ways = [o for o in fleet.orders if isinstance(o, MoveOrder) and o.agent == "line-2"]
    assert [way.target for way in ways] == [state for _, _, state in line.stays[1:]]
    assert [way.arrives for way in ways] == [first for first, _, _ in line.stays[1:]]


def test_what_is_rebuilt_late_is_waited_for() -> None:
    """The ring waits for a line that comes out two steps late; the other line does not."""
    mission, plan = fence()
    ring = next(each for each in plan.structures if each.configuration == "ring")
    making = next(each for each in plan.rebuilt if ring.id in each.made)
    line = next(each for each in plan.structures if each.id == making.parts[0])
    late = ("hall", "hall")
    done = told(mission, plan, {line.first: {line.id: late}, line.first + 1: {line.id: late}})
    after = {each.id: each for each in done.plan.structures}
    assert after[line.id].first == line.first + 2
    assert after[ring.id].first == ring.first + 2
    others = [e for e in plan.structures if not set(e.modules) & set(ring.modules)]
    assert others
    assert all(after[each.id] == each for each in others)
    assert not done.met  # posts at the north and the south were to the step
    easy = replace(mission, formula=parse("F[0,18] sum(rail) >= 1"), text="", language="mtl")
    again = replan(easy, plan, line.first, late={line.id: 2})
    assert next(e for e in again.structures if e.id == line.id).first == line.first + 2


def test_what_is_lost_while_it_is_rebuilt_is_gone() -> None:
    mission, plan = fence()
    rebuilt = min(plan.rebuilt, key=lambda each: each.step)
    line = next(each for each in plan.structures if each.id in rebuilt.made)
    done = told(mission, plan, {rebuilt.step + 1: {line.id: None}})
    assert line.id not in {each.id for each in done.plan.structures}
    assert not any(done.plan.state_at(9)[module] for module in line.modules)
    made = replan(mission, plan, rebuilt.step + 1, lost=[line.modules[0]])
    modules = {module for each in made.structures for module in each.modules if each.last > 1}
    assert not modules & set(line.modules)


def test_what_is_not_done_by_the_end_is_as_lost() -> None:
    mission, plan = fence()
    rebuilt = min(plan.rebuilt, key=lambda each: each.step)
    line = next(each for each in plan.structures if each.id in rebuilt.made)
    late = replan(mission, plan, rebuilt.step + 1, late={line.id: 50})
    lost = replan(mission, plan, rebuilt.step + 1, lost=[line.id])
    assert late.status == lost.status
    assert late.structures == lost.structures


def test_who_is_rebuilt_is_told_of_where_it_comes_out() -> None:
    mission, plan = fence()
    rebuilt = min(plan.rebuilt, key=lambda each: each.step)
    line = next(each for each in plan.structures if each.id in rebuilt.made)
    early = replan(mission, plan, rebuilt.step + 1, moved={line.id: "hall"})
    assert next(e for e in early.structures if e.id == line.id).first == rebuilt.step + 1
    way = {"from": "hall", "to": "yard", "arrives": 9}
    with pytest.raises(PlanError, match="is being rebuilt at step"):
        replan(mission, plan, rebuilt.step + 1, moved={line.id: way})


def test_structures_have_the_luck_of_their_modules() -> None:
    """Whatever they are called, and whatever they are part of."""
    mission, _ = fence()
    chances = Chances(loss=0.2)
    found = []
    for name in ("line-1", "line-7@3"):
        fleet = SimulatedFleet(mission, chances, 5)
        fleet.begin(0, {name: "hall"}, [Assembly(name, "line", ("module-1", "module-2"))])
        found.append([name in fleet.advance(step, []).places for step in range(9)])
    assert found[0] == found[1]


def test_a_trial_of_modular_robots() -> None:
    mission, plan = fence()
    trial = tsplan.execute(mission, plan, runs=3, delay=0.1, loss=0.005)
    assert trial.replanned is not None
    assert trial.replanned.times >= trial.kept.times


@pytest.mark.parametrize("late", sampled(["0", "0.15"], ["0"]))
def test_robots_of_another_process_are_rebuilt(tmp_path, late: str) -> None:
    plan, journal = tmp_path / "plan.json", tmp_path / "run.jsonl"
    tsplan.save_plan(fence()[1], plan)
    simulator = ROOT / "environments" / "robots" / "simulator.py"
    command = f"{sys.executable} {simulator} --late {late} --seed 3"
    out = tmp_path / "executed.json"
    given = ["execute", str(FENCE), str(plan), "--robots", command, "--quiet", "-o", str(out)]
    done = here(*given, "--journal", str(journal))
    assert done.code in (0, 1), done.err
    assert (done.code == 0) == ("the formula held" in done.out)
    assert (here("check", str(FENCE), str(out)).code == 0) == (done.code == 0)
    if late == "0":
        assert tsplan.load_plan(out).structures == tsplan.load_plan(plan).structures
    lines = journal.read_text().splitlines()
    middle = tmp_path / "middle.jsonl"
    middle.write_text("\n".join(lines[:3]) + "\n")  # while lines are being made
    assert here(*given, "--journal", str(middle)).code == done.code
    assert [json.loads(line).get("seen") for line in middle.read_text().splitlines()[:3]] == [
        json.loads(line).get("seen") for line in lines[:3]
    ]


@pytest.mark.parametrize("seeds", seed_blocks(range(7), range(1000), 20))
def test_plans_in_pieces_stand(seeds: list[int]) -> None:
    for seed in seeds:
        others = {"performance": WORTH} if seed % 3 == 0 else {}
        mission = random_module_mission(seed, steps=8, **others)
        draw = random.Random(seed)
        window = draw.randint(2, 6)
        made = tsplan.plan_in_pieces(mission, window, draw.randint(1, window))
        if made.has_paths:
            assert tsplan.check(mission, Plan.from_json(made.to_json())).ok, seed
        elif made.status == "infeasible":
            assert tsplan.plan(mission).status == "infeasible", seed


def test_a_plan_whose_formula_does_not_hold_has_no_performance() -> None:
    mission = random_module_mission(0, performance=WORTH)
    plan = tsplan.plan(mission)
    assert plan.has_paths
    more = replace(mission, formula=parse("F[0,2] sum(a) >= 9"), text="", language="mtl")
    report = tsplan.check(more, plan)
    assert "and has none, since the formula does not hold" in str(report)


def test_what_was_to_come_out_after_the_end_does_when_the_plan_goes_on() -> None:
    short = {"formula": parse("sum(hall) >= 1"), "horizon": 1, "objective": ("travel",)}
    mission = replace(fence()[0], text="", language="mtl", **short)
    plan = tsplan.plan(mission)
    parts = [replace(each, last=0, stays=((0, 0, "hall"),)) for each in plan.structures[:3]]
    structures = (*parts, *plan.structures[3:])
    started = replace(
        plan,
        structures=structures,
        rebuilt=(Rebuilt(0, "hall", 0, tuple(each.id for each in parts), ()),),
        agents=Agents.along(modules_along(mission.agents, structures)),
        objective=(ObjectiveValue("travel", None),),
        status=Status.FEASIBLE,
        stopped_by=StoppedBy.GAP,
    )
    made = replan(mission, started, 1, demanded=["F[0,9] sum(yard, lift) >= 1"])
    assert made.has_paths
    line = next(each for each in made.structures if each.configuration == "line")
    assert (line.first, line.id in made.rebuilt[0].made) == (2, True)
    assert len(made.rebuilt) == 1
    assert tsplan.check(mission, Plan.from_json(made.to_json())).ok


class Clumsy(Watched):
    """A fleet in which what is to be rebuilt often does not begin: its parts are seen still."""

    def advance(self, step: int, orders: Sequence[Order]) -> Seen:
        kept = [o for o in orders if not isinstance(o, RebuildOrder) or not self._fails(o, step)]
        return super().advance(step, kept)

    def _fails(self, order: RebuildOrder, step: int) -> bool:
        modules = sorted(module for name in order.parts for module in self._who(name))
        return self._chance("fails", step, *modules) < 0.5


@pytest.mark.parametrize("seeds", seed_blocks(range(20), range(20, 1000), 20))
def test_what_does_not_begin_to_be_rebuilt_is_begun_later(seeds: list[int]) -> None:
    met = {False: 0, True: 0}
    for seed in seeds:
        mission = random_module_mission(seed, steps=6, modules=5)
        plan = tsplan.plan(mission)
        for again in met if plan.has_paths else ():
            fleet = Clumsy(mission, Chances(0.1, 0.01, 0.0), seed)
            met[again] += met_truly(mission, plan, fleet, again=again)
    assert met[True] >= met[False]


def test_structures_are_told_of_as_they_are_at_the_step() -> None:
    mission, plan = fence()
    with pytest.raises(PlanError, match="single-9 has become line-1 at step 0"):
        replan(mission, plan, 8, lost=["single-9"])
    with pytest.raises(PlanError, match="ring-1 is not there, nor being made, at step 1"):
        replan(mission, plan, 1, late={"ring-1": 1})
    easy = replace(mission, formula=parse("F[0,18] sum(rail) >= 1"), text="", language="mtl")
    made = replan(easy, plan, 1, lost=["single-9"])  # so the line is not being made
    bodies = {each.id: each for each in made.structures}
    assert (bodies["single-8"].last >= 1, "line-1" in bodies) == (True, False)
    assert bodies["single-9"].last == 0
