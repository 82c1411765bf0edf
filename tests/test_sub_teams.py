"""First plans by teams that see to a few parts of a goal each."""

from __future__ import annotations

from concurrent.futures import Executor, ThreadPoolExecutor

import numpy as np
import pytest

import tsplan
from tests.many_tasks import mission
from tests.seeds import sampled
from tsplan.clock import Clock
from tsplan.encode.assemble import tight
from tsplan.encode.encoded import Encoded
from tsplan.encode.goal_parts import parts_of
from tsplan.encode.preparation import prepare
from tsplan.encode.priced_objectives import Travel
from tsplan.milp.model import Floats
from tsplan.milp.solver import solver
from tsplan.mission import Group, Mission
from tsplan.search import stages
from tsplan.search.effort import Effort
from tsplan.search.search import Search
from tsplan.search.sub_teams import SubTeams, clustered, shared_out
from tsplan.ts.builders import grid


def by_teams(encoded: Encoded, executor: Executor | None = None, size: int = 3) -> Floats | None:
    teams = SubTeams(Effort(solver("highs")), executor, many=4, size=size)
    return teams.flows(encoded, Clock())


@pytest.mark.parametrize("seed", sampled(range(2), [0]))
def test_what_teams_find_is_a_plan_of_the_whole_and_no_better_than_the_best(seed: int) -> None:
    encoded = tight(prepare(mission(seed)))
    flows = by_teams(encoded)
    assert flows is not None
    target = Travel().target(encoded.setting, encoded)
    search = Search(encoded, target, Effort(solver("highs")), Clock(), lambda *_: None)
    values = search.adopt(flows)
    assert values is not None
    assert encoded.model.violation(values) < 1e-6
    best = tsplan.plan(mission(seed)).objective[0].value
    assert best is not None
    assert target.value(values) >= best


def test_teams_that_are_planned_side_by_side_find_the_same() -> None:
    encoded = tight(prepare(mission(1)))
    with ThreadPoolExecutor(2) as threads:
        one, other = by_teams(encoded), by_teams(encoded, threads)
    assert one is not None
    assert other is not None
    np.testing.assert_array_equal(one, other)


def test_every_agent_is_in_one_team_and_every_part_too() -> None:
    setting = prepare(mission(2, tasks=9))
    parts = parts_of(setting)
    clusters = clustered(setting, parts, 3)
    assert sorted(map(id, parts)) == sorted(id(part) for cluster in clusters for part in cluster)
    assert max(map(len, clusters)) <= 3
    teams = shared_out(setting, clusters)
    for number, item in enumerate(setting.classes):
        np.testing.assert_array_equal(sum(team[number] for team in teams), item.graph.start)


def test_a_team_that_can_not_do_its_parts_is_joined_to_another() -> None:
    """Two agents serve both tasks, one after the other; none are left for a second team."""
    tasks = [f"F[4,40] T(0,{label},{{(x,2)}})" for label in "abcd"]
    labels = {(0, 1): "a", (0, 3): "b", (3, 0): "c", (3, 3): "d"}
    made = Mission.of(
        map=grid(4, 4, labels=labels),
        team=[Group.of("one", {"r0c0": 2}, {"x"})],
        formula=" && ".join(tasks),
        objective=["travel"],
    )
    assert by_teams(tight(prepare(made)), size=2) is not None


@pytest.mark.parametrize(
    "formula",
    [
        "F[4,20] l0 && F[4,20] l1 && F[4,20] l2 && G[0,9] !l3",  # a bound from above
        "F[4,20] (l0 && l1 && l2 && l3)",  # one part
    ],
)
def test_goals_of_which_teams_can_not_see_to_parts_are_left_whole(formula: str) -> None:
    made = mission(0)
    made = Mission.of(
        map=made.system, team=made.team, formula=formula, language="mtl", objective=["travel"]
    )
    assert parts_of(prepare(made)) == ()


@pytest.mark.parametrize("seed", sampled(range(2), [0]))
def test_plans_with_and_without_teams_agree(seed: int, monkeypatch: pytest.MonkeyPatch) -> None:
    """Large models begin with teams; here all of them do."""
    asked = []

    def eager(effort: Effort) -> SubTeams:
        asked.append(effort)
        return SubTeams(effort, many=4, size=3)

    monkeypatch.setattr(stages, "WIDE", 0)
    monkeypatch.setattr(stages, "SubTeams", eager)
    one = tsplan.plan(mission(seed))
    assert len(asked) == 1
    other = tsplan.plan(mission(seed), without=("teams",))
    assert len(asked) == 1
    assert one.verified
    assert (one.status, one.objective) == (other.status, other.objective)
