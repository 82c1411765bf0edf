"""How many agents of each class serve a task: columns that change no optimum."""

from __future__ import annotations

import random

import numpy as np
import pytest
from scipy import optimize

from tests.seeds import sampled
from tests.test_encode_rivals import rival_mission
from tsplan import Mission, plan
from tsplan.clock import Clock
from tsplan.encode.assemble import tight
from tsplan.encode.class_shares import with_shares
from tsplan.encode.encoded import Encoded
from tsplan.encode.preparation import prepare
from tsplan.encode.priced_objectives import Travel
from tsplan.milp.model import Floats, Model
from tsplan.milp.solver import solver
from tsplan.mission import Group
from tsplan.search.effort import Effort
from tsplan.search.search import Search
from tsplan.ts import Edge, State, TransitionSystem


def best(model: Model) -> tuple[float, Floats] | None:
    """The least value of a model and a point, as scipy finds it; None if it has none."""
    rows = optimize.LinearConstraint(model.matrix, model.row_lower, model.row_upper)
    bounds = optimize.Bounds(model.lower, model.upper)
    found = optimize.milp(
        model.objective, constraints=rows, bounds=bounds, integrality=model.integer.astype(int)
    )
    return None if found.x is None else (float(found.fun), np.asarray(found.x))


def encoded(mission: Mission) -> Encoded | None:
    """The model of least travel, unless it is refuted at once."""
    setting = prepare(mission)
    made = tight(setting)
    if made.refuted:
        return None
    target = Travel().target(setting, made)
    return Encoded(**{**vars(made), "model": made.model.with_objective(target.vector)})


@pytest.mark.parametrize("seed", sampled(range(200), range(6)))
def test_shares_change_no_optimum(seed: int) -> None:
    made = encoded(rival_mission(seed))
    plain = None if made is None else best(made.model)
    if made is None or plain is None:
        return
    value, point = plain
    more, start = with_shares(made.served, made.network, made.model, point)
    assert start is not None
    assert more.size.columns == len(start)
    shared = best(more)
    assert shared is not None
    assert shared[0] == pytest.approx(value)


def test_what_is_known_of_a_plan_is_a_point_of_the_shares_too() -> None:
    points = 0
    for seed in range(12):
        made = encoded(rival_mission(seed))
        plain = None if made is None else best(made.model)
        if made is not None and plain is not None:
            more, start = with_shares(made.served, made.network, made.model, plain[1])
            assert start is not None
            points += more.violation(start) < 1e-6
    assert points >= 5


def triangle(seed: int) -> Mission:
    """Tasks of three capabilities of which every class has two: parts of agents do better."""
    rng = random.Random(f"shares {seed}")
    names = [f"s{n}" for n in range(6)]
    labels = dict(zip(rng.sample(names, 3), "ABC", strict=True))
    states = [State(name, labels={labels[name]} if name in labels else set()) for name in names]
    edges = [Edge(name, name, 1) for name in names]
    edges += [Edge(x, y, rng.randint(1, 3)) for x in names for y in names if x != y]
    system = TransitionSystem.build(states, edges)
    pairs = ({"u", "v"}, {"v", "w"}, {"u", "w"})
    return Mission.of(
        map=system,
        team=[Group.of(f"g{n}", {rng.choice(names): 3}, able) for n, able in enumerate(pairs)],
        formula=" && ".join(
            f"F[{rng.randint(0, 4)},{rng.randint(5, 9)}] T(1,{label},{{({c},3)}})"
            for label, c in zip("ABC", "uvw", strict=True)
        ),
        language="catl",
        objective=("travel",),
    )


@pytest.mark.parametrize("seed", sampled(range(100), [2]))
def test_tasks_that_classes_share_agree_with_the_reference(seed: int) -> None:
    mission = triangle(seed)
    tightly, plainly = plan(mission), plan(mission, encoding="reference")
    assert tightly.status == plainly.status
    assert [o.value for o in tightly.objective] == [o.value for o in plainly.objective]


def test_the_solver_asked_by_shares_claims_no_more_than_is_true() -> None:
    """Its bound is at most the least travel of whole agents, and what it finds is a plan."""
    asked = 0
    for seed in range(12):
        made = encoded(rival_mission(seed))
        plain = None if made is None else best(made.model)
        if made is None or plain is None:
            continue
        target = Travel().target(made.setting, made)
        search = Search(made, target, Effort(solver("highs")), Clock(), lambda *_: None)
        search._by_shares()
        found = search._known.found(Clock())
        assert found.bound <= plain[0] + 1e-6
        assert found.objective is None or found.objective >= plain[0] - 1e-6
        asked += found.proven
    assert asked >= 4
