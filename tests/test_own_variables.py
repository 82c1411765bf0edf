"""Own variables beside counts and flows: chosen by the plan, recorded in it, and judged exactly."""

from __future__ import annotations

from dataclasses import replace
from fractions import Fraction
from itertools import product
from random import Random

import pytest

import tsplan
from tests.seeds import sampled
from tsplan.errors import MissionError, PlanError, SolverError
from tsplan.run.problem import Tuning
from tsplan.run.rational_program import Row, least


def mission(count: int = 3, **more) -> tsplan.Mission:
    """Carts in a corridor of three states, of whom as many as one likes may go to the dock."""
    corridor = tsplan.grid(1, 3, labels={(0, 2): "dock"}, name="corridor")
    given = {"team": {"cart": {"r0c0": count}}, "objective": ["travel"]} | more
    return tsplan.Mission.of(map=corridor, formula="F[0,5] true", language="mtl", **given)


@pytest.fixture
def problem() -> tsplan.Problem:
    return tsplan.Problem(mission())


@pytest.mark.parametrize("encoding", ["tight", "reference"])
def test_a_whole_variable_is_chosen_and_recorded(encoding):
    problem = tsplan.Problem(mission(), Tuning.named(encoding))
    lifts = problem.variable("lifts", -3, 5)
    problem.add(problem.count("dock", step=5) <= 2 * lifts)
    problem.add(problem.count("dock", step=5) >= 3)
    problem.minimise(10 * lifts)
    plan = tsplan.plan(problem)
    assert plan.variables == {"lifts": 2}
    assert plan.notes == ("own objective 20 (bound 20)",)
    assert "  lifts = 2" in str(plan).splitlines()
    assert tsplan.Plan.from_json(plan.to_json()) == plan
    assert problem.plan_from(solved(problem)).variables["lifts"] >= 2


def solved(problem):
    native = problem.native()
    native.run()
    return native


@pytest.mark.parametrize("encoding", ["tight", "reference"])
def test_a_real_variable_is_exact(encoding):
    problem = tsplan.Problem(mission(), Tuning.named(encoding))
    share = problem.variable("share", 0, 1, integer=False)
    problem.add(problem.count("dock", step=5) >= 1)
    problem.add(3 * share == problem.count("dock", step=5))
    problem.maximise(-share)
    plan = tsplan.plan(problem)
    assert plan.variables == {"share": Fraction(1, 3)}
    assert '"variables": {"share": "1/3"}' in plan.to_json()
    assert tsplan.Plan.from_json(plan.to_json()) == plan
    assert not problem.broken(plan)
    assert tsplan.check(problem, plan).ok
    forged = replace(plan, variables={"share": Fraction(1, 2)})
    assert tsplan.check(problem.mission, forged).ok
    [finding] = tsplan.check(problem, forged).findings
    assert "asks for 3*share - count('dock', step=5) == 0" in str(finding)


def test_variables_alone_can_be_in_conflict(problem):
    boxes = problem.variable("boxes", 0, 4)
    weight = problem.variable("weight", 0, 10, integer=False)
    problem.add(weight >= 3 * boxes)
    problem.add(boxes >= 3)
    problem.add(weight <= 8)
    assert tsplan.plan(problem).status == "infeasible"


def test_a_variable_is_named_in_the_solver_s_own_model(problem):
    boxes = problem.variable("boxes", 0, 4)
    problem.add(boxes >= problem.count("dock", step=5), "room")
    native = problem.native()
    names = {native.getColName(number)[1] for number in range(native.getNumCol())}
    assert "boxes" in names


def test_of_swarms_and_with_wishes_there_are_variables_too():
    given = {"team": None, "swarm": {"size": 20, "at": "r0c0"}, "objective": ()}
    problem = tsplan.Problem(mission(**given))
    vans = problem.variable("vans", 0, 9)
    problem.add(problem.count("dock", step=5) == 4 * vans)
    problem.maximise(vans - problem.count("r0c1", step=1))
    assert tsplan.plan(problem).variables == {"vans": 5}
    wish = [{"formula": "F[5,5] sum(dock) >= 2"}]
    soft = tsplan.Problem(mission(prefer=wish, objective=["preferences", "travel"]))
    vans = soft.variable("vans", 0, 9)
    soft.add(soft.count("dock", step=5) <= vans)
    soft.minimise(vans)
    assert tsplan.plan(soft).variables == {"vans": 2}


@pytest.mark.parametrize(
    ("given", "words"),
    [
        (("", 0, 1), "'' is not a name"),
        ((3, 0, 1), "3 is not a name"),
        (("x", 1, 0), "no whole number is between 1 and 0"),
        (("x", 0.2, 0.8), "no whole number is between"),
        (("x", 0, float("inf")), "not a finite number"),
        (("x", None, 1), "None is not a number"),
        (("x", 0, 10**7), "larger than 1,000,000"),
        (("known", 0, 2), "there is another variable 'known', between 0 and 1"),
    ],
)
def test_what_is_no_variable_is_an_error_where_it_is_written(problem, given, words):
    problem.variable("known", 0, 1)
    with pytest.raises(MissionError, match=words):
        problem.variable(*given)


def test_the_same_name_and_bounds_are_the_same_variable(problem):
    one, other = (problem.variable("x", 0.5, 2.5) for _ in range(2))
    assert str(one + 2 * other >= 4) == "x >= 2"
    with pytest.raises(MissionError, match="another variable"):
        problem.variable("x", 1, 2, integer=False)


def test_variables_of_another_problem_are_refused(problem):
    other = tsplan.Problem(mission()).variable("share", 0, 1)
    problem.variable("shape", 0, 1)
    with pytest.raises(MissionError, match="another problem; did you mean 'shape'"):
        problem.add(other >= 1)
    with pytest.raises(MissionError, match="another problem"):
        problem.minimise(other)


def test_real_values_are_not_told_strictly(problem):
    share = problem.variable("share", 0, 1, integer=False)
    with pytest.raises(MissionError, match="of real values"):
        problem.add(share > 0)


def test_forged_values_are_told(problem):
    boxes = problem.variable("boxes", 0, 4)
    problem.add(boxes >= problem.count("r0c0", step=0), "room")
    plan = tsplan.plan(problem)
    assert problem.broken(plan) == ()
    for value, words in [
        (Fraction(7, 2), "'boxes' is 7/2, no whole number"),
        (Fraction(5), "'boxes' is 5, outside 0..4"),
        (Fraction(2), "'room' asks for boxes - count('r0c0', step=0) >= 0, and it comes to -1"),
    ]:
        assert words in " ".join(problem.broken(replace(plan, variables={"boxes": value})))
    assert "has no value" in problem.broken(replace(plan, variables={}))[0]


def test_a_plan_whose_values_break_a_constraint_is_refused(problem, monkeypatch):
    boxes = problem.variable("boxes", 0, 4)
    problem.add(boxes >= 2, "some")
    monkeypatch.setattr("tsplan.encode.assemble.constraint_rows", lambda *_: None)
    with pytest.raises(SolverError, match=r"'some' asks for boxes >= 2, and it comes to 0"):
        tsplan.plan(problem)


@pytest.mark.parametrize("value", ['"1/0"', '"a"', "true", "null", "[1]"])
def test_what_is_no_value_is_refused_in_files(problem, value):
    problem.add(problem.variable("x", 1, 1) >= 1)
    text = tsplan.plan(problem).to_json().replace('{"x": 1}', f'{{"x": {value}}}')
    with pytest.raises(PlanError, match=r"variables\.x: a value is a number, or a fraction"):
        tsplan.Plan.from_json(text)


def test_numbers_of_files_are_the_decimals_that_they_write():
    plan = tsplan.plan(mission())
    made = replace(plan, variables={"x": Fraction(1, 10), "y": Fraction(-5), "z": Fraction(-1, 7)})
    assert '{"x": 0.1, "y": -5, "z": "-1/7"}' in made.to_json()
    assert tsplan.Plan.from_json(made.to_json()) == made


# --- against brute force ----------------------------------------------------------------------


def numbers(random: Random) -> Fraction:
    return Fraction(random.randint(-4, 4), random.choice([1, 1, 2, 3, 7]))


@pytest.mark.parametrize("seed", sampled(range(1000), range(15)))
def test_small_programs_are_solved_exactly(seed: int) -> None:
    """Against all corners: every choice of rows and bounds that meet in a point."""
    random = Random(seed)
    count = random.randint(1, 3)
    most = [abs(numbers(random)) + random.choice([0, 1]) for _ in range(count)]
    costs = [numbers(random) for _ in range(count)]
    rows = []
    for _ in range(random.randint(0, 3)):
        low, high = sorted([numbers(random), numbers(random)])
        sides = random.choice([(low, high), (low, None), (None, high), (low, low)])
        rows.append(Row([numbers(random) for _ in range(count)], *sides))
    values = [cost for point in corners(rows, most) for cost in [dot(costs, point)]]
    found = least(costs, rows, most)
    assert (found is None) == (not values)
    if found is not None:
        assert all(fits(row, found) for row in rows)
        assert all(0 <= value <= bound for value, bound in zip(found, most, strict=True))
        assert dot(costs, found) == min(values)


def dot(left, right) -> Fraction:
    return sum((a * b for a, b in zip(left, right, strict=True)), Fraction(0))


def fits(row: Row, point) -> bool:
    total = dot(row.factors, point)
    above = row.lower is None or total >= row.lower
    return above and (row.upper is None or total <= row.upper)


def corners(rows, most):
    """Points at which as many sides are met as there are columns, and all are kept."""
    count = len(most)
    unit = [[Fraction(int(a == b)) for b in range(count)] for a in range(count)]
    sides = [(row.factors, b) for row in rows for b in (row.lower, row.upper) if b is not None]
    sides += [(unit[n], side) for n in range(count) for side in (Fraction(0), most[n])]
    for chosen in product(sides, repeat=count):
        point = crossing([[*factors, side] for factors, side in chosen])
        inside = point and all(0 <= v <= m for v, m in zip(point, most, strict=True))
        if inside and all(fits(row, point) for row in rows):
            yield point


def crossing(system):
    """The one solution of a square system, by elimination; None where there is none."""
    count = len(system)
    for place in range(count):
        pivot = next((row for row in range(place, count) if system[row][place]), None)
        if pivot is None:
            return None
        system[place], system[pivot] = system[pivot], system[place]
        system[place] = [value / system[place][place] for value in system[place]]
        for row in range(count):
            if row != place:
                factor = system[row][place]
                system[row] = [
                    a - factor * b for a, b in zip(system[row], system[place], strict=True)
                ]
    return [row[-1] for row in system]


@pytest.mark.parametrize("seed", sampled(range(300), range(12)))
def test_random_reals_are_the_best_of_all_numbers_of_agents(seed: int) -> None:
    """A real variable beside the number at the dock: the best for each number, then of these."""
    random = Random(seed)
    problem = tsplan.Problem(mission())
    low, high = sorted([numbers(random), numbers(random)])
    y = problem.variable("y", low, high, integer=False)
    dock = problem.count("dock", step=5)
    demands = [
        (numbers(random), numbers(random), random.choice([">=", "<=", "=="]), numbers(random))
        for _ in range(2)
    ]
    for a, b, relation, bound in demands:
        made = a * y + b * dock
        if made.terms:
            problem.add(
                made >= bound
                if relation == ">="
                else made <= bound
                if relation == "<="
                else made == bound
            )
    cost = numbers(random) or Fraction(1)
    problem.minimise(cost * y + dock)
    best = None
    for number in range(4):
        rows = []
        for a, b, relation, bound in demands:
            if a or b:
                side = bound - b * number - a * low
                rows.append(
                    Row([a], None if relation == "<=" else side, None if relation == ">=" else side)
                )
        found = least([cost], rows, [high - low])
        if found is not None:
            value = cost * (low + found[0]) + number
            best = value if best is None else min(best, value)
    plan = tsplan.plan(problem)
    assert (plan.status == "infeasible") == (best is None), seed
    if best is not None:
        at_dock = int(plan.counts(states=["r0c2"])[0, 5])
        assert float(cost * plan.variables["y"] + at_dock) == pytest.approx(float(best), abs=1e-5)
        assert not problem.broken(plan)
