"""Why tasks with resources are executed: what they need, who brought it and when."""

from __future__ import annotations

from dataclasses import replace

from tests.deliveries import GARDEN, WALL, building, site
from tests.viewing import plan_of
from tsplan import Mission
from tsplan.explanation.why.stock_lines import stock_lines, supplies
from tsplan.explanation.why.supply_words import MOST_SUPPLIES, supply_lines, supply_words
from tsplan.logic.atoms import Execution
from tsplan.mission import Group, Resource
from tsplan.plans.supplies import Cargo, ExecutedTask
from tsplan.viewer.formula_rows import formula_parts


def told(mission, plan, task, *steps):
    return [supply_words(one) for one in supplies(stock_lines(plan, mission), task, steps)]


def test_who_brought_it_and_when():
    assert told(*building(), WALL, 3) == [
        (
            "3 brick at wall at step 3: 1 there from the start, man-1 brought 1 at step 2, "
            "man-2 brought 1 at step 2"
        ),
        "1 drill at wall at step 3: man-1 brought 1 at step 2",
    ]
    assert told(*building(), GARDEN, 4, 6) == [
        "0.75 water of 1.5 at garden at step 4: cart-1 brought 1.5 at step 4",
        (
            "0.75 water at garden at step 6: cart-1 brought 1.5 at step 4; "
            "0.75 used or carried away before"
        ),
    ]


def test_the_tree_has_the_executions_with_their_supplies():
    mission, plan = building()
    tree = plan.explain(mission)
    executed = [node for _, node in tree.walk() if isinstance(node.formula, Execution)]
    assert [node.steps for node in executed] == [(3,), (4,), (6,)]
    assert [len(node.supplies) for node in executed] == [2, 1, 1]
    lines = [" ".join(line.split()) for line in str(tree).splitlines()]
    at = lines.index("executed at 3")
    assert lines[at + 2] == "1 drill at wall at step 3: man-1 brought 1 at step 2"
    assert "executed at 6" in lines


def test_what_is_not_executed_says_so():
    mission, plan = building()
    none = replace(plan, executions=plan.executions[1:])
    lines = [" ".join(line.split()) for line in str(none.explain(mission)).splitlines()]
    assert any(line.startswith("executed fails at") for line in lines)
    assert not any("brick" in line and "brought" in line for line in lines)


def test_what_was_gone_before_is_not_told_again():
    """Once nothing is left, what comes later is all that counts."""
    mission = Mission.of(
        map=site(),
        team=[Group.of("cart", {"yard": 1}, carries=1)],
        resources=[Resource.of("water", {"yard": 2, "wall": 1})],
        formula="F[0,2] T(0,wall,{},{(water,1)}) && F[4,8] T(0,wall,{},{(water,1)})",
        horizon=8,
    )
    task = "T(0,wall,{},{(water,1)})"
    plan = plan_of(mission, [(((0, 3, "yard"), (5, 8, "wall")), None)])
    plan = replace(
        plan,
        cargo=(Cargo("cart-1", 3, "water", 1.0),),
        executions=(ExecutedTask(task, "wall", 2), ExecutedTask(task, "wall", 6)),
    )
    assert told(mission, plan, task, 2, 6) == [
        "1 water at wall at step 2: 1 there from the start",
        "1 water at wall at step 6: cart-1 brought 1 at step 5",
    ]


def test_many_amounts_and_deliveries_are_counted():
    mission, plan = building()
    (one, _) = supplies(stock_lines(plan, mission), WALL, [3])
    lines = list(supply_lines([one] * (MOST_SUPPLIES + 3)))
    assert lines[-1] == "... and 3 further amounts"
    assert len(lines) == MOST_SUPPLIES + 1
    crowd = replace(one, first=0.0, brought=one.brought * 4)
    assert supply_words(crowd).endswith("4 in 4 more")


def test_parts_tick_off_when_they_are_executed():
    mission, plan = building()
    *_, early, late = formula_parts(mission, plan)
    assert (early.needed, late.needed) == (((4, 4),), ((6, 6),))
    assert (early.share(3), early.share(4)) == (0.0, 1.0)
    assert early.states == ("garden",)
