"""The monitor against whole traces, progression and agents that are moved on step by step."""

from __future__ import annotations

from dataclasses import replace
from fractions import Fraction
from functools import cache
from math import inf
from random import Random

import numpy as np
import pytest

import tsplan
from tests.fleet_worlds import Walker, counted, followed_mission, onwards, walked_plan
from tests.resource_missions import random_booked_mission
from tests.seeds import seed_blocks
from tests.slippery import grid_mission
from tests.test_monitor_parts import spare
from tsplan.errors import InputError, PlanError
from tsplan.logic import (
    Always,
    And,
    Eventually,
    Or,
    Until,
    holds,
    parse,
    progress,
    robustness,
    walk,
)
from tsplan.logic.settled import settled
from tsplan.mission import Preference, mission_from_text
from tsplan.monitoring.agent_tracks import Route
from tsplan.monitoring.monitor import Monitor
from tsplan.monitoring.part_formulas import parts_of
from tsplan.plans.agent_plans import AgentPlan
from tsplan.plans.outcomes import MissionRef, Status
from tsplan.plans.plan import Plan
from tsplan.stopping import StoppedBy
from tsplan.testing import random_mission, random_swarm_mission


class World:
    """A plan that is carried out, with delays and losses, beside a monitor that is told of it."""

    def __init__(self, seed: int, *, late: float = 0.15, loss: float = 0.02):
        self.random = Random(seed)
        self.late, self.loss = late, loss
        self.mission = followed_mission(seed)
        self.plan = walked_plan(self.mission, self.random)
        self.monitor = Monitor(self.mission, self.plan)
        self.walkers = [Walker(agent, self.mission.horizon) for agent in self.plan.agents]
        self.columns: list[list[str | None]] = []

    def step(self, now: int):
        """Let a step go by and tell the monitor of what it does not expect, or of everything."""
        if now:
            self.walkers = [
                replace(walker, lost=walker.lost or self.random.random() < self.loss).step(
                    now, late=self.random.random() < self.late
                )
                for walker in self.walkers
            ]
        self.columns.append([walker.state for walker in self.walkers])
        names = [agent.id for agent in self.plan.agents]
        told = {n: w.position for n, w in zip(names, self.walkers, strict=True)}
        return self.monitor.update(now, told)

    @property
    def so_far(self):
        return counted(self.mission, self.columns)

    def expected(self, pause: int = 0):
        """The trace if all agents stop for so long and then go on."""
        now = len(self.columns) - 1
        rest = [self.columns[-1]] * pause + onwards(self.walkers, now)
        return counted(self.mission, [*self.columns, *rest][: self.mission.horizon + 1])


def follow(seed: int) -> None:
    world = World(seed)
    parts = parts_of(world.mission)
    goal = And(tuple(p.goal for p in parts)) if len(parts) > 1 else parts[0].goal
    agents = world.mission.size
    for now in range(world.mission.horizon + 1):
        verdict = world.step(now)
        rest = world.expected()
        assert verdict.slack.agents == robustness(goal, rest)[0], (seed, now)
        assert verdict.works is bool(holds(goal, rest)[0])
        for part, said in zip(parts, verdict.parts, strict=True):
            assert said.slack.agents == robustness(part.goal, rest)[0]
            known = settled(progress(part.goal, world.so_far))
            if known is not None and said.truth == "open":
                raise AssertionError(f"{part.text} is decided at {now} in mission {seed}")
            if said.truth != "open":
                judge_early(world, part.goal, said.truth == "holds", agents)
        assert verdict.slack.steps == late(goal, rest, now), (seed, now)
        if 0 <= verdict.slack.steps < inf:
            for pause in range(int(verdict.slack.steps) + 1):
                assert holds(goal, world.expected(pause))[0], (seed, now, pause)
        elif verdict.slack.steps == inf:
            assert all(holds(goal, world.expected(pause))[0] for pause in range(20))
    whole = world.so_far
    for part, said in zip(parts, verdict.parts, strict=True):
        assert said.truth == ("holds" if holds(part.goal, whole)[0] else "violated")
    assert verdict.truth == ("holds" if holds(goal, whole)[0] else "violated")


def late(goal, trace, now):
    """By how many steps all may be late, by the definitions; `trace` is what is expected."""
    truths = {node: holds(node, trace).tolist() for node in walk(goal) if not node.children}

    @cache
    def at(node, step):
        if not node.children:
            return spare(truths[node], step, now)
        best = max if isinstance(node, Or | Eventually | Until) else min
        if isinstance(node, And | Or):
            return best(at(child, step) for child in node.children)
        window = range(step + node.low, step + node.high + 1)
        if isinstance(node, Always | Eventually):
            return best(at(node.child, other) for other in window)
        worst = min if best is max else max
        return best(
            worst([at(node.right, s), *(at(node.left, before) for before in range(step, s))])
            for s in window
        )

    return at(goal, 0)


def judge_early(world: World, goal, truth: bool, agents: int) -> None:
    """No continuation in which agents that are left are anywhere undoes what is decided."""
    states = [*world.mission.system.states, None]
    for _ in range(3):
        rest = [
            [None if w.lost else world.random.choice(states) for w in world.walkers]
            for _ in range(world.mission.horizon + 1 - len(world.columns))
        ]
        trace = counted(world.mission, [*world.columns, *rest])
        assert bool(holds(goal, trace)[0]) is truth


@pytest.mark.parametrize("seeds", seed_blocks(range(6), range(2000), 6))
def test_verdicts_are_those_of_whole_traces_and_never_too_early(seeds):
    for seed in seeds:
        follow(seed)


# --- one monitor by hand ------------------------------------------------------------------------

TEXT = """\
format: tsplan-mission/1
name: ferry
map:
  waiting: true
  states: {yard: {labels: [home]}, road: {}, dock: {labels: [shore]}, moor: {}}
  edges: [{from: yard, to: road, duration: 1, both_ways: true},
    {from: road, to: dock, duration: 2, both_ways: true}, [yard, moor, 1], [moor, road, 1]]
team: [{class: crew, count: 3, at: yard, capabilities: [row]}]
spec:
  language: mtl
  formula: "F[0,6] sum(shore,row) >= 2 && G[0,9] sum(home) <= 3 && F[7,9] sum(home) >= 1"
horizon: 10
"""
RIDE = ((0, 1, "yard"), (2, 2, "road"), (4, 6, "dock"), (8, 8, "road"), (9, 10, "yard"))
STAY = ((0, 10, "yard"),)


def ferry(*paths, text: str = TEXT) -> Monitor:
    mission = mission_from_text(text)
    agents = tuple(
        AgentPlan(f"crew-{number}", "crew", frozenset({"row", "crew"}), stays)
        for number, stays in enumerate(paths, start=1)
    )
    ref = MissionRef(mission.name, "")
    return Monitor(mission, Plan(Status.FEASIBLE, ref, 10, StoppedBy.GAP, agents=agents))


def test_what_is_said_as_a_plan_goes_on():
    monitor = ferry(RIDE, RIDE, STAY)
    first = monitor.update(0)
    assert (first.truth, first.works) == ("open", True)
    assert first.slack == (0, 2)  # both are at the dock from step 4 to 6, and 6 is the last step
    assert [part.slack for part in first.parts] == [(0, 2), (0, inf), (2, inf)]
    assert [part.truth for part in monitor.update(3).parts] == ["open", "holds", "open"]
    there = monitor.update(4)
    assert [(part.truth, part.decided) for part in there.parts] == [
        ("holds", 4),
        ("holds", 0),  # there are no more than three
        ("open", None),
    ]
    assert there.slack == (0, inf)
    last = monitor.update(7)
    assert (last.truth, last.works, str(last).count("holds")) == ("holds", True, 4)
    assert monitor.update(10).parts[2].decided == 7


def test_what_holds_from_now_on_has_all_the_time():
    text = TEXT.replace("F[7,9] sum(home) >= 1", "G[4,8] sum(home) <= 1")
    monitor = ferry(
        ((0, 0, "yard"), (1, 10, "moor")), ((0, 0, "yard"), (1, 10, "moor")), STAY, text=text
    )
    slack = [monitor.update(step).parts[2].slack for step in range(2)]
    assert slack == [(0, 3), (0, inf)]


def test_those_who_are_late_go_on_as_soon_as_they_can():
    monitor = ferry(RIDE, RIDE, STAY)
    monitor.update(2)
    late = monitor.update(4, {"crew-1": ("road", "dock")})
    assert (late.works, late.slack) == (True, (0, 1))  # it comes at step 5
    later = monitor.update(5, {"crew-1": ("road", "dock")})
    assert later.slack == (0, 0)
    gone = monitor.update(6, {"crew-1": ("road", "dock")})
    assert (gone.truth, gone.works) == ("violated", False)
    assert gone.parts[0].decided == 6
    assert gone.slack == (-1, -inf)
    assert "1 agent missing" in str(gone)
    back = monitor.update(7, {"crew-1": "dock", "crew-2": ("dock", "road")})
    assert back.parts[2].truth == "holds"


def test_one_that_waits_too_long_is_taken_to_leave_at_once():
    monitor = ferry(RIDE, RIDE, STAY)
    monitor.update(1)
    assert monitor.update(2, {"crew-2": "yard"}).slack == (0, 1)
    assert monitor.update(3, {"crew-2": "yard"}).slack == (0, 0)
    assert monitor.update(4).works  # of whom nothing is said goes on as it was taken to
    assert monitor.update(6).parts[0].truth == "holds"


def test_what_is_lost_counts_nowhere_and_few_agents_decide():
    monitor = ferry(RIDE, RIDE, STAY)
    one = monitor.update(2, {"crew-3": None})
    assert (one.truth, one.works) == ("open", True)
    assert one.parts[2].slack == (1, 0)  # those who ride come home at the last moment
    two = monitor.update(3, {"crew-1": None})
    assert (two.truth, two.works, two.parts[0].decided) == ("violated", False, 3)
    assert two.parts[2].truth == "open"
    none = monitor.update(5, {"crew-2": None})
    assert [part.truth for part in none.parts] == ["violated", "holds", "violated"]


def test_who_strays_stays_there_until_it_is_back_on_its_path():
    monitor = ferry(RIDE, RIDE, STAY)
    monitor.update(1)
    astray = monitor.update(2, {"crew-1": "moor"})
    assert not astray.works
    assert astray.truth == "open"
    assert not monitor.update(3, {"crew-1": ("moor", "road")}).works
    back = monitor.update(4, {"crew-1": "road"})
    assert (back.works, back.slack) == (True, (0, 0))
    assert monitor.update(6, {"crew-1": "dock"}).parts[0].truth == "holds"


def test_who_has_caught_up_is_expected_where_its_path_is():
    monitor = ferry(RIDE, RIDE, STAY)
    fleet = monitor._fleet
    # it is there one step late, with time to wait
    monitor.update(4, {"crew-1": ("road", "dock"), "crew-3": None})
    monitor.update(6)
    monitor.update(8)
    assert fleet.see({"crew-1": "road", "crew-2": "road"}, 8) == []
    assert list(fleet._tracked) == [2]
    route = Route(RIDE, None, 10)
    assert route.onwards(2, 5) == (((5, 6, "dock"),), 2, 3)
    assert route.onwards(1, 4) == (((4, 4, "road"), (6, 6, "dock")), 1, 3)


def test_an_array_says_the_same_as_names():
    for seed in range(4):
        world = World(seed, loss=0.05)
        other = Monitor(world.mission, world.plan)
        number = {state: place for place, state in enumerate(other.states)}
        assert other.agents == tuple(agent.id for agent in world.mission.agents)
        for now in range(world.mission.horizon + 1):
            said = world.step(now)
            codes = [
                -2 if w.lost else -1 if w.state is None else number[w.state] for w in world.walkers
            ]
            assert other.update(now, np.array(codes)) == said


def test_a_step_that_is_refused_changes_nothing():
    monitor, other = ferry(RIDE, RIDE, STAY), ferry(RIDE, RIDE, STAY)
    monitor.update(3, {"crew-3": None})
    other.update(3, {"crew-3": None})
    wrong = {
        "crew-9": "yard",
        "crew-1": "yrad",
        "crew-2": ("yard", "dock"),
        "crew-3": "yard",
        4: "yard",
    }
    with pytest.raises(InputError) as refused:
        monitor.update(4, wrong)
    assert len(refused.value.findings) == 5
    for positions in (np.array([1, 2]), np.array([0.0, 1, 2]), np.array([0, 9, -2])):
        with pytest.raises(InputError):
            monitor.update(4, positions)
    for step in (3, 11, 2.5):
        with pytest.raises(InputError):
            monitor.update(step)
    with pytest.raises(InputError, match="no swarm"):
        monitor.update(4, {}, {"bees": {"yard": 3}})
    assert [monitor.update(step) for step in (4, 9)] == [other.update(step) for step in (4, 9)]


def test_what_cannot_be_followed_is_refused():
    mission = mission_from_text(TEXT)
    failed = Plan(Status.INFEASIBLE, MissionRef("", ""), 10)
    with pytest.raises(PlanError, match="no paths"):
        Monitor(mission, failed)
    plan = tsplan.plan(mission)
    with pytest.raises(PlanError, match="ends at step 10"):
        Monitor(replace(mission, horizon=11), plan)
    with pytest.raises(PlanError, match="policies"):
        Monitor(*planned(grid_mission(3, 2, "F[0,9] goal")))


def planned(mission):
    return mission, tsplan.plan(mission)


# --- other kinds of missions --------------------------------------------------------------------


def test_swarms_are_told_of_by_counts():
    text = """\
format: tsplan-mission/1
map:
  waiting: true
  states: {hive: {labels: [in]}, wood: {labels: [out]}}
  edges: [{from: hive, to: wood, duration: 2, both_ways: true}]
swarm: {size: 20, at: hive}
spec: {language: mtl, formula: "F[0,6] sum(out) >= 60% && G[0,1] sum(in) >= 20"}
horizon: 8
"""
    mission, plan = planned(mission_from_text(text))
    monitor = Monitor(mission, plan)
    assert monitor.update(0).works
    few = monitor.update(1, {}, {next(iter(plan.moves)): {"hive": 19}})
    assert (few.truth, few.parts[1].decided, few.parts[1].slack.agents) == ("violated", 1, -1)
    assert few.parts[0].slack.agents >= 0
    assert monitor.update(8).parts[0].truth == "holds"
    with pytest.raises(InputError, match="whole number"):
        Monitor(mission, plan).update(0, {}, {next(iter(plan.moves)): {"hive": -1}})


def test_a_plan_that_goes_on_as_planned_keeps_its_word():
    for seed in range(4):
        for made in (
            random_mission(seed),
            random_swarm_mission(seed),
            random_booked_mission(seed, "exclusive"),
        ):
            mission, plan = planned(made)
            if not plan.has_paths:
                continue
            monitor = Monitor(mission, plan)
            for step in range(plan.horizon + 1):
                verdict = monitor.update(step)
                assert verdict.works
                assert verdict.slack.agents == (
                    inf if plan.availability is None else plan.availability
                )
            assert verdict.truth == "holds"
            assert all(part.truth == "holds" for part in verdict.parts)


def test_what_is_preferred_and_what_holds_in_part_is_told_but_not_asked_for():
    base = mission_from_text(TEXT)
    wish = Preference(parse("F[0,3] moor"), name="call at the mooring")
    mission, plan = planned(replace(base, prefer=(wish,)))
    told = Monitor(mission, plan).update(0).parts
    assert [part.required for part in told] == [True] * 3 + [False]
    assert told[-1].text == "call at the mooring"
    hard = parse("F[0,2] sum(shore) >= 3 && F[0,9] shore")
    part, plan = planned(
        replace(base, formula=hard, text=str(hard), horizon=10, objective=("satisfaction",))
    )
    monitor = Monitor(part, plan)
    assert plan.satisfaction.fraction == Fraction(1, 2)
    assert [each.slack.agents >= 0 for each in monitor.update(0).parts] == [False, True]
    end = [monitor.update(step) for step in range(1, 11)]
    assert all(verdict.works for verdict in end)
    assert (end[-1].truth, [each.truth for each in end[-1].parts]) == (
        "violated",
        ["violated", "holds"],
    )


def test_a_plan_that_was_replanned_is_followed_by_what_it_was_replanned_for():
    mission, plan = planned(replace(mission_from_text(TEXT), objective=("travel",)))
    more = {"class": "crew", "at": "moor", "capabilities": ["row"]}
    made = tsplan.replan(
        *(mission, plan, 2),
        added=[more],
        withdrawn=["G[0,9] (sum(home) <= 3)"],
        demanded=["G[0,7] (sum(home) <= 3)", "F[0,11] moor"],
        opened=[{"from": "moor", "to": "yard"}],
    )
    monitor = Monitor(mission, made)
    told = monitor.update(0).parts
    assert [part.text for part in told][-2:] == [
        "F[2,2] G[0,7] (sum(home) <= 3)",
        "F[2,2] F[0,11] moor",
    ]
    assert told[-2].truth == "open"  # there will be four
    assert monitor.update(3, {"crew-4": ("moor", "yard")}).parts[-1].truth == "holds"


def test_who_starts_under_way_may_be_late_for_its_first_state():
    text = TEXT.replace("[{class: crew, count: 3, at: yard", "[{class: crew, count: 3, at: START")
    text = text.replace("START", "{from: road, to: dock, arrives: 2}")
    text = text.replace("G[0,9] sum(home) <= 3 && F[7,9] sum(home) >= 1", "G[0,3] sum(home) <= 3")
    mission, plan = planned(mission_from_text(text))
    monitor = Monitor(mission, plan)
    assert monitor.update(0).slack.agents == 1
    late = monitor.update(2, dict.fromkeys(["crew-1", "crew-2"], ("road", "dock")))
    assert (late.works, late.truth) == (True, "open")
    assert monitor.update(3).parts[0].truth == "holds"  # they are taken to come a step later
