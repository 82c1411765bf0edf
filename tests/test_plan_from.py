"""Plans read from the solver's own object, which somebody else has solved."""

from __future__ import annotations

import numpy as np
import pytest

import tsplan
from tsplan.errors import InputError, SolverError
from tsplan.milp.solver import SOLVERS
from tsplan.milp.solver import solver as solver_named
from tsplan.run.problem import Tuning


def usable(name: str) -> bool:
    """Whether a solver may be used here."""
    return solver_named(name).availability().usable


def problem(encoding: str = "tight", **more) -> tsplan.Problem:
    """Three carts of which two are wanted at the gate, and one in the middle at step 2."""
    yard = tsplan.grid(1, 3, labels={(0, 2): "gate"})
    given = {"team": {"cart": {"r0c0": 3}}} | more
    mission = tsplan.Mission.of(map=yard, formula="F[0,4] gate >= 2", language="mtl", **given)
    made = tsplan.Problem(mission, Tuning.named(encoding))
    made.add(made.count("r0c1", step=2) == 1, "one in the middle")
    return made


def solved(native, name: str):
    """What the object of a solver is after it was solved, by that solver's own words."""
    if name == "highs":
        native.run()
    elif name == "gurobi":
        native.optimize()
    else:
        native.solve(pulp_backend())
    return native


def pulp_backend():
    """The silent backend of PuLP that is installed."""
    pulp = pytest.importorskip("pulp")
    return pulp.getSolver(solver_named("pulp").names()[1].partition(":")[2], msg=False)


@pytest.mark.parametrize("encoding", ["tight", "reference"])
@pytest.mark.parametrize("name", list(SOLVERS))
def test_a_solved_object_is_read_as_a_verified_plan(name, encoding):
    if not usable(name):
        pytest.skip(f"{name} is not usable here")
    asked = problem(encoding)
    plan = asked.plan_from(solved(asked.native(name), name), name)
    assert (plan.status, plan.verified) == ("feasible", True)
    assert plan.counts(states=["r0c1"])[0, 2] == 1
    assert tsplan.check(asked.mission, plan).ok
    assert plan.known_mission() is asked.mission


def test_a_swarm_is_read_too():
    asked = problem(team=None, swarm={"size": 3, "at": "r0c0"})
    plan = asked.plan_from(solved(asked.native(), "highs"))
    assert plan.verified
    assert plan.groups


def test_own_objectives_are_the_solver_s_business():
    """An objective that tsplan knows nothing of: as many as possible at the gate at the end."""
    asked = problem()
    native = asked.native()
    best = tsplan.plan(asked).value("travel")
    every = np.zeros(native.getNumCol())
    moves = asked.encode().moves
    every[moves] = 1.0
    native.changeColsCost(len(every), np.arange(len(every), dtype=np.int32), -every)
    native.run()
    assert asked.plan_from(native).value("travel") > best


def test_values_alone_will_do():
    asked = problem()
    values = solved(asked.native(), "highs").getSolution().col_value
    assert asked.plan_from(values) == asked.plan_from(np.array(values))


@pytest.mark.parametrize("name", list(SOLVERS))
def test_an_object_that_nobody_has_solved_has_no_point(name):
    if not usable(name):
        pytest.skip(f"{name} is not usable here")
    asked = problem()
    with pytest.raises(SolverError, match="has no point of the model"):
        asked.plan_from(asked.native(name), name)


def test_what_is_no_point_of_the_problem_is_refused():
    asked = problem()
    values = np.array(solved(asked.native(), "highs").getSolution().col_value)
    with pytest.raises(SolverError, match="breaks rows"):
        asked.plan_from(np.zeros_like(values))
    with pytest.raises(SolverError, match="breaks rows"):
        asked.plan_from(np.full_like(values, np.nan))
    with pytest.raises(InputError, match="3 values"):
        asked.plan_from(values[:3])
    with pytest.raises(InputError, match=r"2 values|has .* values"):
        asked.plan_from(values.reshape(1, -1))
