"""Swarms against all joint plans of tiny missions: groups, sizes, splits and every objective."""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterator
from dataclasses import dataclass
from itertools import combinations_with_replacement, product
from math import comb, prod
from random import Random

import pytest

from tests.random_missions import LABELS, random_map, random_text
from tests.test_brute_force import Path, paths, trace, within_capacity
from tsplan import Mission
from tsplan.encode.options import Idea
from tsplan.errors import MissionError
from tsplan.logic import horizon, parse
from tsplan.logic.evaluation import robustness
from tsplan.milp.solver import solver
from tsplan.run.problem import Problem, Tuning
from tsplan.search.clock import Clock
from tsplan.search.effort import Effort
from tsplan.search.lexicographic import Outcome

MOST_JOINT_PLANS = 3000
SENSE = {
    "splits": 1,
    "travel": 1,
    "moves": 1,
    "makespan": 1,
    "balance": -1,
    "agents": 1,
    "cost": 1,
    "availability": -1,
}
OBJECTIVES = [
    ["splits", "travel"],
    ["splits"],
    ["travel", "splits"],
    ["moves", "splits"],
    ["balance", "splits"],
    ["splits", "balance", "travel"],
    ["makespan", "splits"],
    [],
]


@dataclass(frozen=True)
class Groups:
    """What the joint plan of one swarm comes to."""

    sizes: tuple[tuple[int, ...], ...]  # of the sub-swarms at each step
    splits: int
    moves: int


def groups(mission: Mission, joint: tuple[Path, ...]) -> Groups:
    """Sub-swarms at each step, by definition: at one state, or on one edge since the same step."""
    sizes = []
    for step in range(mission.horizon + 1):
        there: Counter[object] = Counter()
        for path in joint:
            state = path.states[step]
            inside = [e for e in path.entered if e[2] < step < e[2] + e[3]]
            there[state if state is not None else inside[0]] += 1
        sizes.append(tuple(there.values()))
    entered = {edge for path in joint for edge in path.entered}
    left = {(source, step) for source, _, step, _ in entered}
    moves = sum(source != target for source, target, _, _ in entered)
    return Groups(tuple(sizes), len(entered) - len(left), moves)


def allowed(mission: Mission, swarms: dict[str, Groups]) -> bool:
    rules = mission.swarm
    assert rules is not None
    for name, found in swarms.items():
        bounds = rules.each[name]
        for sizes in found.sizes:
            if bounds.most is not None and len(sizes) > bounds.most:
                return False
            if min(sizes) < bounds.least:
                return False
    if rules.together is None:
        return True
    steps = zip(*(found.sizes for found in swarms.values()), strict=True)
    return all(sum(map(len, sizes)) <= rules.together for sizes in steps)


def joints(mission: Mission) -> Iterator[tuple[Path, ...]]:
    """Every joint plan, agents of one swarm and start being all alike."""
    ways = []
    for alike in _alike(mission):
        agents = [mission.agents[number] for number in alike]
        ways.append(list(combinations_with_replacement(paths(mission, agents[0]), len(agents))))
    for choice in product(*ways):
        yield tuple(path for part in choice for path in part)


def _alike(mission: Mission) -> list[list[int]]:
    found: dict[tuple[str, str], list[int]] = {}
    for number, agent in enumerate(mission.agents):
        found.setdefault((agent.class_name, agent.start), []).append(number)
    assert [n for part in found.values() for n in part] == list(range(len(mission.agents)))
    return list(found.values())


def how_many(mission: Mission) -> int:
    counts = []
    for alike in _alike(mission):
        ways = len(paths(mission, mission.agents[alike[0]]))
        counts.append(comb(ways + len(alike) - 1, len(alike)))
    return prod(counts)


def possible(mission: Mission) -> Iterator[tuple[tuple[Path, ...], dict[str, Groups]]]:
    """Every joint plan that keeps the bounds and capacities, whatever becomes of the formula."""
    for joint in joints(mission):
        swarms = {
            group.class_name: groups(
                mission,
                tuple(
                    path
                    for path, agent in zip(joint, mission.agents, strict=True)
                    if agent.class_name == group.class_name
                ),
            )
            for group in mission.team
            if mission.group_bounds(group.class_name) is not None
        }
        if allowed(mission, swarms) and within_capacity(mission, joint):
            yield joint, swarms


def best(mission: Mission) -> tuple[float, ...] | None:
    """The best objective values, signed to be minimised; None if there is no plan."""
    found = None
    for joint, swarms in possible(mission):
        worth = {
            "splits": sum(item.splits for item in swarms.values()),
            "moves": sum(item.moves for item in swarms.values()),
            "travel": sum(path.travel for path in joint),
            "makespan": max(path.makespan for path in joint),
            "balance": min(min(sizes) for item in swarms.values() for sizes in item.sizes),
            "agents": sum(any(a != b for a, b, *_ in path.entered) for path in joint),
            "cost": sum(path.cost for path in joint),
            "availability": float(robustness(mission.goal, trace(mission, joint))[0]),
        }
        value = tuple(float(SENSE[name] * worth[name]) for name in mission.objective)
        if worth["availability"] >= 0 and (found is None or value < found):
            found = value
    return found


PLAIN = Tuning()


def solved(mission: Mission, tuning: Tuning = PLAIN) -> Outcome:
    effort = Effort(solver("highs"))
    return Problem(mission, tuning).solve(effort, Clock(60.0), lambda *_: None)


def dividing_text(random: Random) -> str:
    """A formula that wants agents at two labels at once, and something else now and then."""
    one, other = random.sample(LABELS, 2)
    need = random.choice(["", "", f"sum({other},u) >= 2 && "])
    low = random.randint(1, 3)
    both = f"F[{low},{low + random.randint(0, 2)}] ({need}{one} && {other})"
    return both if random.random() < 0.5 else f"{both} && ({random_text(random, 1)})"


MIXED_OBJECTIVES = [
    *OBJECTIVES,
    ["availability", "splits"],
    ["availability", "travel", "splits"],
    ["splits", "availability"],
    ["agents", "splits"],
    ["cost", "moves"],
    ["makespan", "travel"],
]


def random_mixed(seed: int) -> Mission | None:
    """A tiny mission of a few robots and a swarm, small enough to be enumerated."""
    random = Random(seed)
    system = random_map(random, random.randint(2, 4), strange=random.random() < 0.3)
    text = random_text(random, 2) if random.random() < 0.4 else dividing_text(random)
    text = text.replace(",v", random.choice([",rover", ",x", ""])).replace(",u", ",u")
    steps = random.randint(2, 4)
    if horizon(parse(text, language="mtl")) > steps:
        return None
    states = list(system.states)
    robots = Counter(random.choice(states) for _ in range(random.randint(1, 2)))
    swarm = Counter(random.choice(states) for _ in range(random.randint(1, 2)))
    swarm[next(iter(swarm))] += random.randint(0, 2)
    try:
        mission = Mission.of(
            map=system,
            language="mtl",
            team=[{"class": "rover", "at": dict(robots), "capabilities": ["x"]}],
            swarms=[
                {
                    "name": "u",
                    "size": sum(swarm.values()),
                    "at": dict(swarm),
                    "max_subswarms": random.choice([None, 1, 2]),
                    "min_subswarm": random.choice([1, 1, 2]),
                }
            ],
            formula=text,
            objective=random.choice(MIXED_OBJECTIVES),
            horizon=steps,
        )
    except MissionError:
        return None
    return mission if how_many(mission) <= MOST_JOINT_PLANS else None


def random_swarms(seed: int) -> Mission | None:
    """A tiny mission of one or two swarms, small enough to be enumerated; None if it is not."""
    random = Random(seed)
    system = random_map(random, random.randint(2, 4), strange=random.random() < 0.3)
    text = random_text(random, 3) if random.random() < 0.3 else dividing_text(random)
    names = ["u", "v"] if random.random() < 0.4 else ["u"]
    if len(names) == 1:
        text = text.replace(",v", "").replace(",u", "")
    steps = random.randint(2, 5)
    if horizon(parse(text, language="mtl")) > steps:
        return None
    swarms = []
    for name in names:
        at = {random.choice(list(system.states)): random.randint(1, 4 if len(names) == 1 else 2)}
        if random.random() < 0.3:
            at[random.choice(list(system.states))] = 1
        swarms.append(
            {
                "name": name,
                "size": sum(at.values()),
                "at": at,
                "max_subswarms": random.choice([None, 1, 2, 3]),
                "min_subswarm": random.choice([1, 1, 2]),
            }
        )
    single = {key: value for key, value in swarms[0].items() if key != "name"}
    try:
        mission = Mission.of(
            map=system,
            formula=text,
            objective=random.choice(OBJECTIVES),
            horizon=steps,
            **(
                {"swarm": single}
                if len(names) == 1
                else {"swarms": swarms, "max_subswarms": random.choice([None, 2, 3])}
            ),
        )
    except MissionError:
        return None
    return mission if how_many(mission) <= MOST_JOINT_PLANS else None


def compare(mission: Mission, tuning: Tuning = PLAIN) -> None:
    expected = best(mission)
    outcome = solved(mission, tuning)
    if expected is None:
        assert outcome.infeasible
        assert outcome.point is None
        return
    assert outcome.point is not None
    assert outcome.proven
    found = tuple(SENSE[item.name] * item.value for item in outcome.reached)
    assert found == expected


@pytest.mark.parametrize("block", range(6))
def test_swarms_do_as_well_as_the_best_of_all_joint_plans(block: int) -> None:
    for seed in range(30_000 + 20 * block, 30_020 + 20 * block):
        mission = random_swarms(seed)
        if mission is not None:
            compare(mission)


@pytest.mark.parametrize("block", range(6))
def test_robots_and_a_swarm_do_as_well_as_the_best_of_all_joint_plans(block: int) -> None:
    for seed in range(50_000 + 20 * block, 50_020 + 20 * block):
        mission = random_mixed(seed)
        if mission is not None:
            compare(mission)


@pytest.mark.long
@pytest.mark.parametrize("block", range(100))
def test_robots_and_a_swarm_do_as_well_as_the_best_of_many(block: int) -> None:
    for seed in range(51_000 + 20 * block, 51_020 + 20 * block):
        mission = random_mixed(seed)
        if mission is not None:
            compare(mission)
            compare(mission, Tuning("reference"))


@pytest.mark.parametrize("block", range(4))
def test_the_reference_encoding_and_a_search_without_ideas_do_as_well(block: int) -> None:
    plain = Tuning(without=frozenset(Idea))
    for seed in range(30_200 + 10 * block, 30_210 + 10 * block):
        mission = random_swarms(seed)
        if mission is not None:
            compare(mission, Tuning("reference"))
            compare(mission, plain)


@pytest.mark.long
@pytest.mark.parametrize("block", range(100))
def test_swarms_do_as_well_as_the_best_of_many(block: int) -> None:
    for seed in range(31_000 + 20 * block, 31_020 + 20 * block):
        mission = random_swarms(seed)
        if mission is not None:
            compare(mission)


def test_the_random_missions_are_of_all_kinds() -> None:
    missions = [mission for seed in range(30_000, 30_200) if (mission := random_swarms(seed))]
    assert len(missions) >= 60
    outcomes = [solved(mission) for mission in missions[:60]]
    assert sum(outcome.infeasible for outcome in outcomes) >= 5
    values = [item.value for o in outcomes for item in o.reached if item.name == "splits"]
    assert max(values) >= 1


def test_the_random_mixed_missions_are_of_all_kinds() -> None:
    missions = [mission for seed in range(50_000, 50_150) if (mission := random_mixed(seed))]
    assert len(missions) >= 40
    outcomes = [solved(mission) for mission in missions[:40]]
    assert 5 <= sum(outcome.infeasible for outcome in outcomes) <= 30
