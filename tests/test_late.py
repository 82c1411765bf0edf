"""Agents that may be late: the two counts, the best plans by them, and replays of these plans."""

from __future__ import annotations

from collections import Counter
from dataclasses import replace
from functools import cache
from itertools import chain
from math import inf
from pathlib import Path
from random import Random

import numpy as np
import pytest

import tsplan
from tests.joint_plans import SENSE, best, small_enough
from tests.seeds import sampled, seed_blocks
from tests.test_encode_agree import answer
from tests.test_partial_brute_force import (
    compare_preferences,
    compare_satisfaction,
    team_in_part,
    team_preferring,
    team_weighing,
)
from tsplan import Mission, Plan, load_mission
from tsplan.checking.lateness import late
from tsplan.checking.plan_check import certify, check
from tsplan.checking.traffic import read_traffic
from tsplan.encode.agent_classes import agent_classes, map_arrays
from tsplan.encode.late_modes import with_modes
from tsplan.encode.switches import Switch
from tsplan.errors import MissionError, SolverError
from tsplan.logic import Count, Formula, fold, parse, positive
from tsplan.logic.evaluation import CountTrace, holds, margins, robustness
from tsplan.mission.read import mission_from_text
from tsplan.plans.bundles import Agents, Bundle
from tsplan.plans.decomposition import paths_of
from tsplan.plans.presence import state_counts
from tsplan.plans.summary import summary
from tsplan.testing import random_mission, random_swarm_mission
from tsplan.testing.random_missions import random_formula
from tsplan.ts.builders import grid

ENVIRONMENTS = Path(__file__).parents[1] / "environments"
CORRIDOR = grid(1, 5, labels={(0, 4): "dock", (0, 1): "gate"}, name="corridor")
TEXT = "F[0,12] sum(dock) >= 1 && G[0,9] sum(gate) <= 1 && F[0,14] sum(dock) >= 2"


def mission_of(**parts: object) -> Mission:
    given = {"formula": TEXT, "language": "mtl", "objective": ["travel"], **parts}
    return Mission.of(map=CORRIDOR, team=[tsplan.Group.of("cart", {"r0c0": 2})], **given)


def delayed(seed: int, **size: int) -> Mission:
    """A random mission whose agents may be one to three steps late."""
    mission = random_mission(seed, **size)
    return replace(mission, delay=min(1 + seed % 3, mission.horizon))


def wanting(seed: int) -> Mission:
    """One that wants its agents to be as late as they can, at some place among its objectives."""
    mission = random_mission(seed, states=4, most_agents=3, steps=6)
    aims = list(mission.objective)
    aims.insert(seed % (len(aims) + 1), "delay")
    return replace(mission, objective=tuple(aims), delay=min(seed % 3, mission.horizon))


# --- the counts ---------------------------------------------------------------------------------


def random_stays(random: Random, horizon: int) -> tuple[tuple[int, int, str], ...]:
    stays, step = [], 0
    while step <= horizon:
        last = min(horizon, step + random.choice([0, 0, 1, 2, 5]))
        stays.append((step, last, random.choice("abc")))
        step = last + random.randint(1, 3)
    return tuple(stays)


@pytest.mark.parametrize("delay", [1, 2, 3, 20])
def test_who_is_there_for_certain_and_who_may_be(delay: int) -> None:
    random, horizon = Random(delay), 15
    for _ in range(100):
        robots = [
            Bundle("k", frozenset(), random_stays(random, horizon), None, ("k",) * count)
            for count in (1, 3)
        ]
        sure, possible = (state_counts(where, "abc", horizon) for where in late(robots, delay))
        for row, state in enumerate("abc"):
            for step in range(horizon + 1):
                least = most = 0
                for robot in robots:
                    there = [
                        any(
                            first <= time <= last and state == at for first, last, at in robot.stays
                        )
                        for time in range(max(0, step - delay), step + 1)
                    ]
                    least += all(there) * len(robot.agents)
                    most += any(there) * len(robot.agents)
                assert (sure[row, step], possible[row, step]) == (least, most)


def apart(node: Formula, below: tuple[Formula, ...]) -> Formula:
    """Bounds from above on labels of their own."""
    if isinstance(node, Count) and node.relation == "<=":
        return Count(node.function, f"{node.label}_most", node.capability, "<=", node.bound)
    return node.over(below)


@pytest.mark.parametrize("seed", range(60))
def test_each_atom_reads_its_own_count(seed: int) -> None:
    random, states = Random(seed), 4
    labels = {"a": np.array([0]), "b": np.array([1, 2]), "c": np.array([0, 2, 3])}
    numbers = np.random.default_rng(seed)
    formula = parse(random_formula(random, 3), language="mtl")
    names = (None, "u", "v")
    sure = {name: numbers.integers(0, 4, (states, 60)) for name in names}
    most = {name: sure[name] + numbers.integers(0, 3, (states, 60)) for name in names}
    trace = CountTrace(sure, labels, most=most)
    both = {name: np.concatenate([sure[name], most[name]]) for name in names}
    shifted = {f"{label}_most": places + states for label, places in labels.items()}
    plain = CountTrace(both, labels | shifted)
    expected = robustness(fold(positive(formula), apart), plain)
    assert np.array_equal(robustness(formula, trace), expected)
    assert np.array_equal(holds(formula, trace), expected >= 0)
    assert np.array_equal(margins(formula, trace)[formula][: len(expected)], expected)


def test_an_agent_that_is_back_counts_once() -> None:
    mission = Mission.of(
        map=CORRIDOR,
        team=[tsplan.Group.of("cart", {"r0c1": 1})],
        formula="F[2,2] sum(dock) <= 0",
        language="mtl",
    )
    (item,) = agent_classes(mission.system, mission.team, ())
    none = np.zeros(5, dtype=np.bool_)
    gate = none.copy()
    gate[map_arrays(mission.system).states_with(mission.system, "gate")] = True
    near = with_modes(item.graph, none, gate, 2)
    # whoever steps out may be back in two steps, and is away for longer after that
    assert len(near.start) == 5 + 2
    assert near.modes is not None
    assert near.modes.recent.sum() == 2
    assert sorted(near.modes.lingers[near.modes.lingers >= 0].tolist()) == [0, 0]
    assert len(with_modes(item.graph, none, gate, 1).start) == 5
    assert len(with_modes(item.graph, gate, none, 3).start) == 5 + 3


# --- plans --------------------------------------------------------------------------------------


def compare(mission: Mission) -> bool:
    expected = best(mission)
    for encoding in ("tight", "reference"):
        plan = tsplan.plan(mission, encoding=encoding)
        if expected is None:
            assert plan.status == "infeasible", encoding
            continue
        assert (plan.status, plan.verified) == ("optimal", True)
        for said in ([item.value for item in plan.objective], [i.bound for i in plan.objective]):
            signed = zip(mission.objective, said, strict=True)
            found = tuple(SENSE[name] * (inf if value is None else value) for name, value in signed)
            assert found == pytest.approx(expected, abs=1e-6), encoding
        assert Plan.from_json(plan.to_json()) == plan
        replay(mission, plan)
    return expected is not None


def replay(mission: Mission, plan: Plan, times: int = 20) -> None:
    """At every step every agent is where the plan has it at a random step of its window."""
    delay = plan.delay or 0
    random = np.random.default_rng(1)
    steps = np.arange(plan.horizon + 1)
    names = list(mission.system.states)
    counts = {
        name: np.zeros((times, len(names), plan.horizon + 1))
        for name in (None, *mission.capabilities)
    }
    for agent in plan.agents:
        where = [
            plan_state and names.index(plan_state)
            for plan_state in map(agent.state_at, steps.tolist())
        ]
        ago = random.integers(0, delay + 1, (times, len(steps)))
        for run, when in np.ndindex(ago.shape):
            state = where[max(0, when - ago[run, when])]
            if state is not None:
                for name in (None, *agent.capabilities):
                    counts[name][run, state, when] += 1
    labels = {
        label: np.array([names.index(state) for state in members])
        for label, members in mission.system.labels.items()
    }
    assert holds(mission.counted, CountTrace(counts, labels))[..., 0].all()


@pytest.mark.parametrize("seeds", seed_blocks(range(10), range(3000), 20))
def test_teams_do_as_well_as_the_best_of_all_joint_plans(seeds: list[int]) -> None:
    made = [delayed(seed, states=4, most_agents=3, steps=6) for seed in seeds]
    planned = [compare(mission) for mission in made if small_enough(mission)]
    assert 3 <= sum(planned) <= len(planned) - 3


@pytest.mark.parametrize("seeds", seed_blocks(range(11), range(1500), 20))
def test_agents_may_be_as_late_as_in_the_best_of_all_joint_plans(seeds: list[int]) -> None:
    made = [wanting(seed) for seed in seeds]
    planned = [compare(mission) for mission in made if small_enough(mission)]
    assert sum(planned) >= 3


def late_swarms(seed: int) -> Mission:
    """Swarms, every other one beside robots; some want their agents to be as late as they can."""
    if seed % 2:
        mission = random_mission(seed, states=4, most_agents=2, steps=4, mixed=True)
    else:
        mission = random_swarm_mission(seed, fits=small_enough)
    aims = list(mission.objective)
    if seed % 3 == 0:
        aims.insert(seed % (len(aims) + 1), "delay")
    return replace(mission, objective=tuple(aims), delay=min(1 + seed % 3, mission.horizon))


@pytest.mark.parametrize("seeds", seed_blocks(range(7), range(2000), 20))
def test_swarms_do_as_well_as_the_best_of_all_joint_plans(seeds: list[int]) -> None:
    planned = [compare(mission) for mission in map(late_swarms, seeds) if small_enough(mission)]
    assert 3 <= sum(planned) <= len(planned) - 3


@pytest.mark.parametrize("seed", sampled(range(40), range(14)))
def test_who_came_last_leaves_first(seed: int) -> None:
    mission = late_swarms(2 * seed)
    on_time = replace(mission, delay=0, objective=("travel",))
    plan = tsplan.plan(on_time)
    if not plan.has_paths:
        return
    traffic, _ = read_traffic(on_time, plan)
    assert traffic is not None
    for group, swarm in zip(mission.team, traffic.swarms, strict=True):
        ranks = [rank for rank in mission.ranks if rank.class_name == group.class_name]
        made = paths_of(mission, ranks, swarm.moves, seed, late=True)
        walked = Agents.along(chain.from_iterable(made))
        states = list(mission.system.states)
        assert Counter(agent.stays[0][2] for agent in walked) == dict(group.starts)
        for delay in range(1, 6):
            by_paths, by_moves = (
                [state_counts(where, states, mission.horizon) for where in counts]
                for counts in (late(walked.bundles, delay), traffic.late(swarm, delay))
            )
            assert (by_paths[0] == by_moves[0]).all()
            assert (by_paths[1] <= by_moves[1]).all()


def test_paths_by_which_others_leave_are_refused() -> None:
    swarm = {"size": 2, "at": {"r0c3": 1, "r0c4": 1}}
    mission = Mission.of(
        map=CORRIDOR, swarm=swarm, formula="G[3,4] sum(dock) >= 1", delay=2, objective=["travel"]
    )
    plan = tsplan.plan(mission)
    (far, near) = sorted(plan.agents, key=lambda agent: agent.stays[0][2])
    turns = [((0, 0, "r0c3"), (1, 4, "r0c4")), ((0, 1, "r0c4"), (2, 4, "r0c3"))]
    agents = [replace(a, stays=s, heading=None) for a, s in zip((far, near), turns, strict=True)]
    order = {agent.id: agent for agent in agents}
    forged = replace(
        plan,
        agents=tuple(order[agent.id] for agent in plan.agents),
        moves={},
        groups=(),
        availability=None,
        objective=(),
    )
    with pytest.raises(SolverError, match="if who came last leaves first"):
        certify(mission, forged)


@pytest.mark.parametrize("seeds", seed_blocks(range(2), range(200), 6))
def test_what_may_hold_in_part_is_told_by_the_counts(seeds: list[int]) -> None:
    kinds = (
        (team_in_part, compare_satisfaction),
        (team_weighing, compare_satisfaction),
        (team_preferring, compare_preferences),
    )
    for seed in seeds:
        for make, judge in kinds:
            mission = make(seed)
            judge(replace(mission, delay=min(1 + seed % 2, mission.horizon)))


@pytest.mark.parametrize("seed", sampled(range(7000, 9060), range(7000, 7010)))
def test_tight_and_reference_agree(seed: int) -> None:
    mission = delayed(seed)
    plan = tsplan.plan(mission)
    assert answer(plan) == answer(tsplan.plan(mission, encoding="reference"))
    if plan.has_paths:
        replay(mission, plan)


@cache
def all_switched_on(seed: int) -> tuple[object, ...]:
    return answer(tsplan.plan(delayed(seed)))


@pytest.mark.parametrize("switch", list(Switch))
@pytest.mark.parametrize("seeds", seed_blocks(range(7100, 7101), range(7100, 7106), 6))
def test_switching_a_switch_off_changes_no_answer(switch: Switch, seeds: list[int]) -> None:
    for seed in seeds:
        switched = tsplan.plan(delayed(seed), without=(switch.value,))
        assert answer(switched) == all_switched_on(seed)


def test_capacities_and_own_counts_are_those_of_the_plan() -> None:
    mission = mission_of(formula="F[0,9] sum(dock) >= 2", delay=3)
    problem = tsplan.Problem(mission)
    problem.add(problem.count("r0c4", step=6) == 2)
    problem.add(problem.count("r0c1", step=1) == 1)
    plan = tsplan.plan(problem)
    assert plan.counts(states=["r0c4", "r0c1"])[[0, 1], [6, 1]].tolist() == [2, 1]
    assert (plan.availability, plan.delay) == (0, 3)


# --- what is said of them -----------------------------------------------------------------------


def test_a_plan_says_how_late_agents_may_be() -> None:
    plan = tsplan.plan(mission_of(objective=["delay", "travel"]))
    assert (plan.delay, [item.value for item in plan.objective]) == (4, [4, 8])
    assert "  holds with every agent up to 4 steps late" in summary(plan)
    assert "delay" not in tsplan.plan(mission_of()).to_json()
    mission = mission_of(delay=1)
    assert tsplan.plan(mission).delay == 1
    assert certify(mission, replace(tsplan.plan(mission), delay=None)).delay == 1
    wanting = mission_of(objective=["travel", "delay"])
    bare = replace(
        tsplan.plan(wanting), delay=None, objective=(), status="feasible", stopped_by="gap"
    )
    assert certify(wanting, bare).objective[1].value == 4


def test_forged_plans_are_refused() -> None:
    mission = mission_of(objective=["delay"])
    plan = tsplan.plan(mission)
    more = replace(plan, delay=5, objective=(replace(plan.objective[0], value=5.0, bound=5.0),))
    with pytest.raises(SolverError, match="the formula does not hold"):
        certify(mission, more)
    with pytest.raises(SolverError, match=r"claims delay 4\.0 and has 3"):
        certify(mission, replace(plan, delay=3))
    on_time = tsplan.plan(mission_of())
    asked = mission_of(delay=3)
    with pytest.raises(SolverError, match="up to 0 steps late, and the mission asks for 3"):
        certify(asked, replace(on_time, delay=0))
    hasty = tsplan.plan(mission_of(formula="F[0,4] sum(dock) >= 2"))
    with pytest.raises(SolverError, match="the formula does not hold"):
        certify(mission_of(formula="F[0,4] sum(dock) >= 2", delay=1), replace(hasty, delay=None))
    with pytest.raises(SolverError, match="up to 2 steps late, and the mission asks for 0"):
        certify(mission_of(), replace(on_time, delay=2))
    assert check(asked, tsplan.plan(asked)).ok


def test_files_say_it() -> None:
    mission = mission_of(delay=2, objective=["delay", "travel"])
    assert "delay: 2" in mission.to_yaml()
    assert mission_from_text(mission.to_yaml()) == mission
    assert "delay:" not in mission_of().to_yaml()


def test_what_cannot_be_late_is_said() -> None:
    with pytest.raises(MissionError, match="20 steps late, and the mission ends at step 14"):
        mission_of(delay=20)
    with pytest.raises(MissionError, match="told of what must hold alone"):
        mission_of(objective=["satisfaction", "delay"])
    with pytest.raises(MissionError, match="these may be late"):
        mission_of(delay=1, resources=[{"name": "brick", "at": {"r0c0": 1}}])
    icy = load_mission(ENVIRONMENTS / "ice_crossing.yaml")
    with pytest.raises(MissionError, match="these say nothing of delays"):
        replace(icy, delay=1)
    with pytest.raises(MissionError, match="delay"):
        mission_of(delay=-1)


def test_what_cannot_be_done_so_late_is_explained() -> None:
    mission = mission_of(formula="F[0,6] sum(dock) >= 1", delay=3)
    assert tsplan.plan(mission).status == "infeasible"
    assert tsplan.plan(replace(mission, delay=2)).status == "optimal"
