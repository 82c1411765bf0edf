"""Points from few linear programs, and better ones near them."""

from __future__ import annotations

from itertools import islice

import pytest

import tsplan
from tests.many_tasks import mission
from tsplan.clock import Clock
from tsplan.encode.assemble import tight
from tsplan.encode.preparation import prepare
from tsplan.encode.priced_objectives import Travel
from tsplan.milp.lp import WarmLP
from tsplan.milp.solver import solver
from tsplan.search import search
from tsplan.search.dive import fractional, plunge
from tsplan.search.effort import Effort
from tsplan.search.neighbourhood import Improving
from tsplan.search.search import Search
from tsplan.search.sub_teams import SubTeams


@pytest.mark.parametrize("seed", range(3))
def test_a_plunge_settles_all_choices_and_leaves_the_program_as_it_was(seed: int) -> None:
    encoded = tight(prepare(mission(seed)))
    model = encoded.model.with_objective(Travel().vector(encoded.setting, encoded))
    lp = WarmLP(model)
    root = lp.solve()
    found = plunge(lp, encoded.choices, root, Clock())
    assert found is not None
    assert found.values is not None
    assert not len(fractional(found.values, encoded.indicators))
    assert found.objective >= root.objective - 1e-6
    assert lp.solve().objective == pytest.approx(root.objective)
    assert plunge(lp, encoded.choices, root, Clock(), cutoff=root.objective - 1.0) is None


def test_choices_that_are_freed_in_blocks_bring_better_points() -> None:
    encoded = tight(prepare(mission(5, tasks=12)))
    target = Travel().target(encoded.setting, encoded)
    model = encoded.model.with_objective(target.vector)
    effort = Effort(solver("highs"))
    flows = SubTeams(effort, many=4, size=2).flows(encoded, Clock())  # far from the best
    assert flows is not None
    start = Search(encoded, target, effort, Clock(), lambda *_: None).adopt(flows)
    assert start is not None
    improving = Improving(encoded, target, effort, Clock())
    values = [target.value(start)]
    for point in islice(improving.steps(model, start, 1.0), 2):
        assert model.violation(point) < 1e-6
        values.append(target.value(point))
    assert len(values) > 1
    assert values == sorted(values, reverse=True)


def test_what_is_done_for_slow_programs_changes_no_answer(monkeypatch: pytest.MonkeyPatch) -> None:
    usual = tsplan.plan(mission(0)).objective
    monkeypatch.setattr(search, "_LONG", -1.0)  # every program counts as slow
    assert tsplan.plan(mission(0)).objective == usual
