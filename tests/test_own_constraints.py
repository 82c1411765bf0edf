"""A user's own constraints: what they say is what holds, and what they cannot say is an error."""

from __future__ import annotations

from decimal import Decimal
from fractions import Fraction
from itertools import product
from random import Random

import numpy as np
import pytest

import tsplan
from tests.joint_plans import Path, paths, within_capacity
from tests.seeds import sampled
from tsplan.encode.expressions import Constraint, Expression
from tsplan.errors import InputError, MissionError, SolverError
from tsplan.exact import digits
from tsplan.mission import Group
from tsplan.plans.agent_plans import AgentPlan
from tsplan.plans.outcomes import MissionRef
from tsplan.plans.plan import Plan
from tsplan.run.events import Incumbent
from tsplan.ts import Edge, State, TransitionSystem

HORIZON = 4


def mission(count: int = 3, waits: bool = True) -> tsplan.Mission:
    """Three places in a row, the last one the goal of nobody in particular."""
    states = [State("home"), State("way"), State("end", labels=frozenset({"goal"}))]
    edges = [Edge(s.name, s.name) for s in states if waits or s.name != "way"]
    edges += [Edge("home", "way"), Edge("way", "end"), Edge("end", "way", 2), Edge("way", "home")]
    return tsplan.Mission.of(
        map=TransitionSystem.build(states, edges),
        team=[Group.of("scout", {"home": count}, ["see"])],
        formula=f"F[0,{HORIZON}] true",
        language="mtl",
        objective=["travel"],
    )


@pytest.fixture
def problem() -> tsplan.Problem:
    return tsplan.Problem(mission())


def written(problem: tsplan.Problem, text: str) -> object:
    """What a text means in Python; `c` and `d` are counts at two places."""
    names = {"p": problem, "np": np, "Fraction": Fraction, "Decimal": Decimal}
    names |= {"c": problem.count("end", step=4), "d": problem.count("way", step=3)}
    return eval(text, names)


@pytest.mark.parametrize(
    ("text", "words"),
    [
        ("1 <= c <= 3", r"between\(low, high\)"),
        ("c >= 1 and c <= 3", "neither true nor false"),
        ("c >= 1 or d >= 1", "neither true nor false"),
        ("not c >= 1", "neither true nor false"),
        ("(c >= 1) & (c <= 3)", "by itself"),
        ("(c >= 1) | (c <= 3)", "by itself"),
        ("~(c >= 1)", "by itself"),
        ("max(c, d) >= 1", "neither true nor false"),
        ("c == d == 1", "neither true nor false"),
        ("c in (d, 2)", "neither true nor false"),
        ("bool(c)", "depends on the plan"),
        ("c != 2", "'!='"),
        ("c * d <= 3", "sum of counts"),
        ("c ** 2 <= 3", "sum of counts"),
        ("2 ** c <= 3", "sum of counts"),
        ("c / d <= 3", "sum of counts"),
        ("1 / d <= 3", "sum of counts"),
        ("d // 2 <= 3", "sum of counts"),
        ("d % 2 == 0", "sum of counts"),
        ("abs(d - 2) <= 1", "sum of counts"),
        ("int(d) <= 1", "sum of counts"),
        ("d / 0 <= 3", "divided by 0"),
        ("p.count('end', step=2.5) >= 1", "not a whole number"),
        ("p.count('end', step=True) >= 1", "not a whole number"),
        ("p.count('end', step='2') >= 1", "not a whole number"),
        ("p.count('end', step=-1) >= 1", r"outside 0\.\.4"),
        ("p.count('end', step=5) >= 1", r"outside 0\.\.4"),
        ("c >= float('nan')", "not a finite number"),
        ("c <= float('inf')", "not a finite number"),
        ("c <= Decimal('nan')", "not a finite number"),
        ("np.inf * c <= 1", "not a finite number"),
        ("c >= True", "True is not a number"),
        ("c >= (d >= 1)", "is a constraint"),
        ("(c >= 1) + d >= 1", "is a constraint"),
        ("c >= '1'", "'1' is not a number"),
        ("c == None", "None is not a number"),
        ("c * np.array([1, 2]) >= 1", "is not a number"),
        ("c.between(3, 1)", "nothing is between 3 and 1"),
        ("c.between(0, d)", "is not a number"),
        ("p.count('hom', step=1) >= 1", "did you mean 'home'"),
        ("p.count('gaol', step=1) >= 1", "did you mean 'goal'"),
        ("p.count('end', 'sea', step=1) >= 1", "did you mean 'see'"),
        ("p.count('end', 'scout', step=1) >= 1", "is a class, not a capability"),
        ("p.count(3, step=1) >= 1", "3 is not the name"),
        ("1e30 * c + d >= 1", "drop digits"),
        ("c >= Decimal('1e99999999')", "drop digits"),
    ],
)
def test_what_cannot_be_meant_is_an_error_where_it_is_written(problem, text, words) -> None:
    with pytest.raises(MissionError, match=words):
        problem.add(written(problem, text))


@pytest.mark.parametrize("text", ["True", "c", "None", "c >= 1, d >= 1", "'c >= 1'"])
def test_only_constraints_can_be_added(problem, text: str) -> None:
    with pytest.raises(MissionError, match="is not a constraint; compare counts"):
        problem.add(written(problem, text))


@pytest.mark.parametrize("sense", ["minimise", "maximise"])
def test_only_sums_of_counts_are_objectives(problem, sense: str) -> None:
    count = problem.count("end", step=4)
    for given in (count >= 1, 3, None, count - count, "count"):
        with pytest.raises(MissionError, match="is not an objective"):
            getattr(problem, sense)(given)
    with pytest.raises(MissionError, match="did you mean"):
        getattr(problem, sense)(tsplan.Problem(other()).count("hem", step=0))


def other() -> tsplan.Mission:
    """A mission of another map."""
    return tsplan.Mission.of(
        map=TransitionSystem.build([State("hem")], [Edge("hem", "hem")]),
        team=[Group.of("scout", {"hem": 1})],
        formula="F[0,1] true",
        language="mtl",
    )


def test_counts_of_another_mission_are_refused(problem) -> None:
    with pytest.raises(MissionError, match="no state or label 'hem'; did you mean 'home'"):
        problem.add(tsplan.Problem(other()).count("hem", step=0) >= 1)


@pytest.mark.parametrize(
    ("text", "words"),
    [
        ("c == 2", "count('end', step=4) == 2"),
        ("2 == c", "count('end', step=4) == 2"),
        ("2 <= c", "count('end', step=4) >= 2"),
        ("c > 1.5", "count('end', step=4) >= 2"),
        ("c < 2", "count('end', step=4) <= 1"),
        ("c.between(0.5, Fraction(7, 3))", "1 <= count('end', step=4) <= 2"),
        ("0.1 * c + Decimal('0.2') * d >= 0.3", "count('end', step=4) + 2*count"),
        ("np.float32(0.1) * c >= np.int64(1)", "count('end', step=4) >= 10"),
        ("np.int64(2) <= c", "count('end', step=4) >= 2"),
        ("np.float64(1.5) < c", "count('end', step=4) >= 2"),
        ("sum([c, d, 1]) <= c / 3 + 4", "2*count('end', step=4) + 3*count('way', step=3) <= 9"),
        ("c * (d - d + 2) >= 3", "count('end', step=4) >= 2"),
        ("-c >= -2", "-count('end', step=4) >= -2"),
        ("1e30 * c >= 1", "count('end', step=4) >= 1"),
    ],
)
def test_constraints_are_exact_in_whole_numbers(problem, text: str, words: str) -> None:
    made = written(problem, text)
    assert isinstance(made, Constraint)
    assert str(made).startswith(words)


def test_a_constraint_that_never_holds_leaves_no_plan(problem) -> None:
    problem.add(2 * problem.count("end", step=4) == 3)
    assert tsplan.plan(problem).status == "infeasible"
    far = tsplan.Problem(mission())
    far.add(far.count("end", step=4) >= 10**20)
    assert tsplan.plan(far).status == "infeasible"


def test_what_always_holds_changes_nothing(problem) -> None:
    problem.add(problem.count("end", step=4) <= 10**20)
    problem.add(problem.count("end", step=4) - problem.count("end", step=4) <= 1)
    assert tsplan.plan(problem).objective[0].value == 0


def test_a_range_is_kept(problem) -> None:
    problem.add(problem.count("goal", "see", step=4).between(2, 3))
    plan = tsplan.plan(problem)
    assert plan.counts("see", states=["end"])[0, 4] == 2


def test_what_is_maximised_is_told_in_its_own_sense(problem) -> None:
    problem.maximise(2.5 * problem.count("end", step=4) - 1)
    problem.maximise(problem.count("end", step=3))
    assert tsplan.plan(problem).notes == ("own objective, maximised: 9.5 (bound 9.5)",)
    told = []
    tsplan.plan(problem, on_event=told.append)
    assert {
        item.objective for item in told if isinstance(item, Incumbent) and item.stage == "own"
    } == {9.5}


def test_what_is_preferred_comes_before_an_own_objective() -> None:
    plain = mission()
    wished = tsplan.Mission.of(
        map=plain.system,
        team=list(plain.team),
        formula="F[0,4] true",
        prefer=[{"formula": "F[0,4] sum(goal) >= 2"}],
        language="mtl",
        objective=["preferences", "travel"],
    )
    problem = tsplan.Problem(wished)
    problem.maximise(problem.count("home", step=4))
    plan = tsplan.plan(problem)
    assert [item.met for item in plan.preferences] == [True]
    assert plan.notes == ("own objective, maximised: 1 (bound 1)",)


def test_a_difference_of_two_senses_is_minimised(problem) -> None:
    problem.maximise(problem.count("end", step=4))
    problem.minimise(3 * problem.count("way", step=2) + 0.5)
    assert tsplan.plan(problem).notes == ("own objective -2.5 (bound -2.5)",)


def test_values_of_floats_that_cannot_be_told_apart_say_so(problem) -> None:
    problem.maximise(np.pi * problem.count("end", step=4) + np.e * problem.count("way", step=4))
    assert "own is told apart to 1e-06 of its size" in tsplan.plan(problem).notes


def test_a_plan_that_breaks_an_own_constraint_is_refused(problem, monkeypatch) -> None:
    problem.add(problem.count("end", step=4) >= 1, "somebody there")
    monkeypatch.setattr("tsplan.encode.assemble.constraint_rows", lambda *_: None)
    with pytest.raises(SolverError, match=r"'somebody there' asks for count\('end', step=4\) >= 1"):
        tsplan.plan(problem)


# --- against brute force ----------------------------------------------------------------------

RELATIONS = {
    "<=": lambda c, v: c <= v,
    ">=": lambda c, v: c >= v,
    "<": lambda c, v: c < v,
    ">": lambda c, v: c > v,
    "==": lambda c, v: c == v,
}
NUMBERS = [1, 2, -1, 3, 0.1, -0.5, 2.5, 0.001, 1e6, Fraction(1, 3), Decimal("0.7"), 12345.678]
PLACES = ["home", "way", "end", "goal"]


def exactly(value) -> Fraction:
    """The number as it is written."""
    return Fraction(str(value)) if isinstance(value, float) else Fraction(value)


def counted(joint: tuple[Path, ...], place: str, step: int) -> int:
    where = "end" if place == "goal" else place
    return sum(path.states[step] == where for path in joint)


def agrees(seed: int) -> None:
    """One random mission with own constraints and an own objective, against all joint plans."""
    random = Random(seed)
    chosen = mission(random.choice([1, 2]), waits=random.random() < 0.7)
    problem = tsplan.Problem(chosen)

    def some(numbers=NUMBERS) -> list[tuple[object, str, int]]:
        return [
            (random.choice(numbers), random.choice(PLACES), random.randint(0, HORIZON))
            for _ in range(random.randint(1, 3))
        ]

    def built(terms) -> Expression:
        return sum(factor * problem.count(place, step=step) for factor, place, step in terms)

    def worth(terms, joint) -> Fraction:
        return sum(exactly(f) * counted(joint, place, step) for f, place, step in terms)

    demands = [
        (some(), random.choice(sorted(RELATIONS)), random.choice([0, 1, 2, 0.5, 1.7, -1]))
        for _ in range(random.randint(1, 2))
    ]
    for terms, relation, value in demands:
        problem.add(RELATIONS[relation](built(terms), value))
    own = some() if random.random() < 0.5 else []
    if own and built(own).terms:
        problem.maximise(built(own) + 7)
    ways = [paths(chosen, agent) for agent in chosen.agents]
    allowed = [
        joint
        for joint in product(*ways)
        if within_capacity(chosen, joint)
        and all(RELATIONS[r](worth(terms, joint), exactly(v)) for terms, r, v in demands)
    ]
    plan = tsplan.plan(problem, seed=0)
    if not allowed:
        assert plan.status == "infeasible", seed
        return
    assert plan.status == "optimal", seed
    best = max(worth(own, joint) for joint in allowed)
    if own and built(own).terms:
        assert plan.notes[0].startswith(f"own objective, maximised: {digits(best + 7)} "), seed
    travel = min(sum(p.travel for p in joint) for joint in allowed if worth(own, joint) == best)
    assert plan.objective[0].value == travel, seed


@pytest.mark.parametrize("seed", sampled([*range(40), *range(100, 1100)], range(14)))
def test_random_constraints_agree_with_brute_force(seed: int) -> None:
    agrees(seed)


# --- what a plan is asked ---------------------------------------------------------------------

PLAN = Plan(
    "feasible",
    MissionRef("made up", ""),
    5,
    "gap",
    agents=(
        AgentPlan("a-1", "a", frozenset({"see"}), ((0, 1, "p"), (3, 5, "q"))),
        AgentPlan("a-2", "a", frozenset({"fly"}), ((0, 3, "p"),), "q"),
    ),
)


@pytest.mark.parametrize("step", [-1, 6, 2.5, True, float("nan"), None, "2"])
def test_a_plan_is_asked_about_its_own_steps(step) -> None:
    with pytest.raises(InputError, match=r"0\.\.5"):
        PLAN.state_at(step)
    with pytest.raises(InputError, match=r"0\.\.5"):
        PLAN.groups_at(step)


def test_steps_of_numpy_and_whole_floats_are_steps() -> None:
    assert PLAN.state_at(np.int64(4)) == PLAN.state_at(4.0) == {"a-1": "q", "a-2": None}
    assert PLAN.agents[1].state_at(9) is None  # a path does not know where the plan ends
    for step in (-1, 0.5, True):
        with pytest.raises(InputError, match="from 0 on"):
            PLAN.agents[1].state_at(step)


def test_counts_refuse_what_the_plan_does_not_know() -> None:
    assert PLAN.counts("fly", states=("p", "elsewhere")).tolist() == [
        [1, 1, 1, 1, 0, 0],
        [0, 0, 0, 0, 0, 0],
    ]
    for capability, states, words in [
        ("sea", None, "no capability 'sea'; did you mean 'see'"),
        (3, None, "3 is not the name of a capability"),
        (None, "p", r"'p' is one text; give a list of the names of states: \['p'\]"),
        (None, [1], "1 is not the name of a state"),
        (None, 7, "7 is no list"),
    ]:
        with pytest.raises(InputError, match=words):
            PLAN.counts(capability, states=states)
