"""Why a problem with own constraints has no plan: these are requirements like any others."""

from __future__ import annotations

from dataclasses import replace
from itertools import combinations_with_replacement
from pathlib import Path
from random import Random

import pytest

import tsplan
from tests.seeds import sampled
from tsplan.explanation.whynot.changes import applied
from tsplan.explanation.whynot.posed_mission import PosedMission, problem_of, useful_robots
from tsplan.explanation.whynot.soft_constraints import named_facts

HERE = Path(__file__).name


def mission(formula="F[0,5] dock >= 2", **more) -> tsplan.Mission:
    corridor = tsplan.grid(1, 3, labels={(0, 2): "dock"}, name="corridor")
    given = {"team": {"cart": {"r0c0": 4}}, "objective": ["travel"]} | more
    return tsplan.Mission.of(map=corridor, formula=formula, language="mtl", **given)


def door(problem: tsplan.Problem) -> object:
    return sum(problem.flow(("r0c1", "r0c2"), step=step) for step in range(5))


def texts(made: tsplan.Explanation) -> list[list[str]]:
    return [[part.text for part in conflict.parts] for conflict in made.conflicts]


def test_a_conflict_names_own_constraints_and_what_they_are_against():
    problem = tsplan.Problem(mission())
    problem.add(door(problem) <= 1, "narrow door")
    problem.add(problem.count("r0c0", step=1) >= 1, "idle")
    made = tsplan.explain(problem)
    [conflict] = made.conflicts
    assert conflict.minimal
    assert [part.kind for part in conflict.parts] == ["formula", "own", "start"]
    assert conflict.parts[1].text.startswith(f"own constraint 'narrow door' ({HERE}:")
    kinds = {change.kind: change for change in made.changes}
    assert {"loosen_constraint", "drop_constraint", "lower_need", "add_agents"} <= set(kinds)
    assert "<= 2 (now 1) in own constraint 'narrow door'" in kinds["loosen_constraint"].text
    assert "own constraint 'narrow door'" in str(made)


def test_one_without_a_name_is_told_by_its_place():
    problem = tsplan.Problem(mission())
    problem.add(problem.count("dock", step=1) >= 1)
    line = test_one_without_a_name_is_told_by_its_place.__code__.co_firstlineno + 2
    [parts] = texts(tsplan.explain(problem))
    assert parts[0] == f"the own constraint of {HERE}:{line}: count('dock', step=1) >= 1"


def test_own_variables_and_differences_are_told_of_too():
    problem = tsplan.Problem(mission())
    vans = problem.variable("vans", 0, 2)
    problem.add(problem.count("dock", step=5) <= vans, "room")
    problem.add(2 * vans <= 1, "few vans")
    problem.add(problem.count("dock", step=5) - problem.count("r0c0", step=1) >= 1, "more")
    made = tsplan.explain(problem)
    [parts] = texts(made)
    assert [text.split("'")[1] for text in parts] == ["room", "few vans", "more"]
    for change in made.changes:
        assert not change.mission.broken(tsplan.plan(change.mission))


def test_real_constraints_can_be_dropped():
    problem = tsplan.Problem(mission("F[0,5] true"))
    load = problem.variable("load", 0, 1, integer=False)
    problem.add(load * 3 >= problem.count("r0c0", step=0), "heavy")
    made = tsplan.explain(problem)
    assert [text.split("'")[1] for text in texts(made)[0][:1]] == ["heavy"]
    assert "drop_constraint" in {change.kind for change in made.changes}


def test_what_never_holds_is_alone():
    problem = tsplan.Problem(mission())
    problem.add(2 * problem.count("dock", step=4) == 3, "half a cart")
    made = tsplan.explain(problem)
    [[text]] = texts(made)
    assert "half a cart" in text


def test_a_change_is_a_problem_with_all_that_the_first_had():
    problem = tsplan.Problem(mission())
    problem.add(door(problem) <= 1, "narrow door")
    problem.maximise(problem.count("r0c1", step=4))
    made = tsplan.explain(problem)
    change = next(each for each in made.changes if each.kind == "lower_need")
    assert change.mission.constraints == problem.constraints
    plan = tsplan.plan(change.mission)
    assert plan.notes[0].startswith("own objective, maximised: 4 ")
    assert not isinstance(change.mission.mission, PosedMission)


@pytest.mark.long
def test_swarms_are_explained_too():
    swarm = {"size": 20, "at": "r0c0"}
    asked = mission("F[5,5] dock >= 2", team=None, swarm=swarm, objective=())
    problem = tsplan.Problem(asked)
    problem.add(problem.count("r0c0", step=5) >= 19, "stay")
    made = tsplan.explain(problem)
    assert [part.kind for part in made.conflicts[0].parts] == ["formula", "own"]
    assert all(tsplan.plan(change.mission).has_paths for change in made.changes)


def test_of_what_can_be_met_the_own_constraints_are_kept():
    problem = tsplan.Problem(mission())
    problem.add(problem.count("dock", step=3) <= 2, "few")
    made = tsplan.explain(problem)
    assert made.status == "feasible"
    for step in range(6):
        problem.add(problem.count("dock", step=step) <= 2, "few")
    told = tsplan.explain(problem)
    assert "have 0 agents to spare" in told.facts[0].text
    assert "own constraint 'few'" in told.facts[0].text


def test_numbers_of_robots_stay_where_agents_count_against_each_other():
    problem = tsplan.Problem(mission())
    here, there = problem.count("r0c0", step=0), problem.count("dock", step=5)
    problem.add(here >= 3)
    problem.add(there + here <= 5)
    posed = PosedMission.from_problem(problem)
    assert useful_robots(posed) == 3
    assert "team" in {fact.kind for fact in named_facts(posed)}
    problem.add(there - here >= 0)
    posed = PosedMission.from_problem(problem)
    assert useful_robots(posed) is None
    assert "team" not in {fact.kind for fact in named_facts(posed)}


# --- random ones: each half of "cannot hold together, and without any one the rest can" --------


def random_problem(seed: int) -> tsplan.Problem:
    random = Random(seed)
    capacity = random.choice([None, 1])
    states = [
        tsplan.State("a"),
        tsplan.State("b", capacity=capacity),
        tsplan.State("c", frozenset({"goal"})),
    ]
    edges = [tsplan.Edge(s.name, s.name) for s in states]
    edges += [tsplan.Edge("a", "b"), tsplan.Edge("b", "c", 2), tsplan.Edge("c", "a")]
    system = tsplan.TransitionSystem.build(states, edges)
    made = tsplan.Mission.of(
        map=system,
        team={"cart": {"a": 2}},
        formula=random.choice(["F[0,4] true", "F[0,3] goal >= 1", "G[0,3] goal <= 0"]),
        language="mtl",
        horizon=4,
        objective=[],
    )
    problem = tsplan.Problem(made)
    for number in range(3):
        terms = []
        for _ in range(random.randint(1, 2)):
            if random.random() < 0.5:
                edge = random.choice([("a", "b"), ("b", "c"), ("c", "a"), ("a", "a")])
                term = problem.flow(edge, step=random.randint(0, 3))
            else:
                term = problem.count(random.choice("abc"), step=random.randint(0, 4))
            terms.append(random.choice([1, 1, 1, 2, -1]) * term)
        total, bound = sum(terms), random.randint(1, 2)
        if total.terms:
            problem.add(random.choice([total >= bound, total <= bound - 1]), f"own {number}")
    return problem


def possible(
    problem: tsplan.Problem, own, *, whole: bool, roomy: bool, anywhere: bool, sized: bool
):
    """Whether some of a problem can be met, by the reference encoding on missions made by hand."""
    mission, system = problem.mission, problem.mission.system
    if roomy:
        states = [replace(state, capacity=None) for state in system.states.values()]
        system = system.rebuilt(states, system.edges.values())
    formula = mission.formula if whole else tsplan.parse("true", "mtl")
    empty = all(item.holds(0) for item in own) and not (whole and ">=" in mission.text)
    if not sized and empty:  # whose number is open may stay away, too
        return True
    counts = [2] if sized else range(1, 6)
    starts = [
        chosen
        for count in counts
        for chosen in (
            combinations_with_replacement("abc", count) if anywhere else [("a",) * count]
        )
    ]
    for chosen in starts:
        at = {state: chosen.count(state) for state in chosen}
        if any(
            (room := system.states[state].capacity) is not None and number > room
            for state, number in at.items()
        ):
            continue
        team = (replace(mission.team[0], starts=tuple(at.items())),)
        asked = replace(mission, system=system, team=team, formula=formula, text=str(formula))
        if tsplan.plan(problem.with_constraints(asked, own), encoding="reference").has_paths:
            return True
    return False


def explained(seed: int) -> bool:
    problem = random_problem(seed)
    made = tsplan.explain(problem)
    there = tsplan.plan(problem)
    assert (made.status == "feasible") == there.has_paths, seed
    if there.has_paths:
        return False
    [conflict] = made.conflicts
    assert conflict.minimal, seed
    every = frozenset().union(*(part.constraints for part in conflict.parts))
    for gone in [None, *every]:
        kept = every - {gone}
        kinds = {item.kind for item in kept}
        own = [problem.constraints[item.key[0]] for item in kept if item.kind == "own"]
        free = {"whole": "formula" in kinds, "roomy": "capacity" not in kinds}
        sized = "team" in kinds or useful_robots(PosedMission.from_problem(problem)) is None
        free |= {"anywhere": "start" not in kinds, "sized": sized}
        assert possible(problem, own, **free) == (gone is not None), (seed, gone)
    posed = PosedMission.from_problem(problem)
    for change in made.changes:
        plan = tsplan.plan(change.mission)
        assert plan.has_paths, seed
        assert not change.mission.broken(plan), seed
        if change.proven and len(change.steps) == 1:
            [(edit, amount)] = change.steps
            less = problem_of(applied(posed, [(edit, amount - 1)]))
            assert tsplan.plan(less).status == "infeasible", (seed, change.text)
    return True


@pytest.mark.parametrize("seed", sampled(range(400), range(1)))
def test_random_conflicts_are_minimal_and_changes_help(seed: int) -> None:
    explained(seed)


def test_some_of_them_are_conflicts():
    assert (
        not tsplan.plan(random_problem(1)).has_paths or not tsplan.plan(random_problem(0)).has_paths
    )
