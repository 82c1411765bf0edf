"""Plans of modular robots in words: the table, what is rebuilt, and what was checked."""

from __future__ import annotations

import io
from dataclasses import replace

import pytest
from rich.console import Console

import tsplan
from tests.fence_missions import fence
from tsplan.plans.plan import Plan
from tsplan.plans.structure_table import rebuilt_line
from tsplan.plans.structures import Rebuilt
from tsplan.plans.summary import MOST_PATHS, print_summary


@pytest.fixture(scope="module")
def plan() -> Plan:
    return tsplan.plan(fence())


def printed(plan: Plan) -> list[str]:
    stream = io.StringIO()
    print_summary(plan, Console(file=stream, width=100))
    return stream.getvalue().splitlines()


def test_the_table_has_structures_that_move_or_are_built(plan: Plan) -> None:
    lines = printed(plan)
    assert "line-1 (module-3..5)  line    dock:2, lane:5, wall:7-14" in lines
    assert any(line.startswith("single-2 (module-2)   single") for line in lines)
    assert not any(line.startswith("single-1") for line in lines)
    assert "  never moved or rebuilt: 1 single" in lines
    assert "  horizon 14, 5 agents" in lines


def test_what_is_rebuilt_is_told_in_order_of_time(plan: Plan) -> None:
    assert "  step 0 at dock: single-3..5 become line-1, done at step 2" in printed(plan)
    late = Rebuilt(13, "dock", 0, ("single-1",))
    assert rebuilt_line(plan, late, "single-1", "") == (
        "step 13 at dock: single-1 is rebuilt, which is not done by step 14"
    )


def test_long_lists_are_cut(plan: Plan) -> None:
    many = replace(plan, rebuilt=plan.rebuilt * (MOST_PATHS + 2))
    assert "  ... and 2 more reconfigurations; the JSON plan has them all" in printed(many)


def test_a_plan_without_any_move_has_no_table() -> None:
    lines = printed(tsplan.plan(fence(formula="F[0,2] T(1, dock, {(look,1)})")))
    assert "  never moved or rebuilt: 5 single" in lines
    assert not any(line.startswith("agents") for line in lines)


def test_the_check_says_what_holds_of_structures(plan: Plan) -> None:
    facts = tsplan.check(fence(), plan).facts
    assert facts[1].startswith("6 structures of 5 modules: each module is in one at every step")
    assert facts[2].startswith("1 reconfiguration by the rules of the mission")
