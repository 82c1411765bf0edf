"""What a plan says of its objectives, held against what its paths come to; exact throughout."""

from __future__ import annotations

import math
from collections.abc import Iterator, Mapping
from fractions import Fraction

from tsplan.exact import digits, exact
from tsplan.limits import clipped, is_finite
from tsplan.mission.mission import Mission
from tsplan.mission.objectives import OBJECTIVES
from tsplan.plans.outcomes import ObjectiveValue, Status
from tsplan.plans.plan import Plan

_NEAR = 1e-6
"""Relative distance of two amounts or expected values that solvers do not tell apart."""


def false_objectives(
    mission: Mission, plan: Plan, values: Mapping[str, Fraction | float]
) -> Iterator[str]:
    """Whether the objectives are the mission's, with their true values and possible bounds."""
    names = tuple(item.name for item in plan.objective)
    if names != mission.objective:
        yield (
            f"the plan's objectives are {', '.join(names) or 'none'} and the mission's "
            f"{', '.join(mission.objective) or 'none'}"
        )
        return
    for item in plan.objective:
        actual = values.get(item.name)
        if actual is None:
            if item.value is not None:
                what = f"the plan claims {item.name} {clipped(item.value)}"
                yield f"{what}, and has none, since the formula does not hold"
            continue
        if not _claimed(mission, item.value, actual):
            yield f"the plan claims {item.name} {clipped(item.value)} and has {shown(actual)}"
        yield from _bound(item, actual, plan.status, _near(mission, item.name))


def unproven(plan: Plan, values: Mapping[str, Fraction | float]) -> Iterator[str]:
    """Objectives of a plan that is called optimal and does not say what proves them."""
    for item in plan.objective if plan.status is Status.OPTIMAL else ():
        actual = values.get(item.name, math.inf)
        if item.bound is not None or not is_finite(actual):
            continue
        if not (OBJECTIVES[item.name].first and _settled_by_depth(plan)):
            yield f"{item.name} is called optimal at {shown(actual)}, and no bound proves it"


def same(mission: Mission, claimed: float | None, actual: float | None) -> bool:
    """Whether a number that is claimed is the actual one; expected ones are sums of floats."""
    if claimed is None or actual is None or mission.expected is None:
        return claimed == actual
    return near_enough(claimed, actual)


def near_enough(claimed: float, actual: float) -> bool:
    """Whether two floats are not told apart."""
    if not (math.isfinite(claimed) and math.isfinite(actual)):
        return claimed == actual
    return abs(claimed - actual) <= _NEAR * max(1.0, abs(actual))


def _claimed(mission: Mission, value: float | None, actual: Fraction | float) -> bool:
    """Whether a value is the exact one, as the nearest number that a file can hold."""
    if value is None or not is_finite(actual):
        return value is None and not is_finite(actual)
    return same(mission, value, float(actual))


def _near(mission: Mission, name: str) -> float:
    """How far a value may be from a bound that proves it, by its size: 0 where all are whole.

    Amounts that may be parted and expected numbers come from solvers' arithmetic.
    """
    if mission.expected is not None:
        return _NEAR
    parted = any(not item.indivisible for item in mission.resources)
    return _NEAR if parted and OBJECTIVES[name].of_amounts else 0.0


def _bound(
    item: ObjectiveValue, actual: Fraction | float, status: Status, near: float
) -> Iterator[str]:
    if item.bound is None or not is_finite(actual):
        return
    if abs(item.bound - float(actual)) <= near * max(1.0, abs(item.bound)):
        return
    value, bound = shown(actual), shown(item.bound)
    if OBJECTIVES[item.name].is_better(actual, exact(item.bound)):
        yield f"{item.name} {value} is better than its bound {bound}"
    elif status is Status.OPTIMAL:
        yield f"{item.name} is called optimal at {value} with the bound {bound}"


def shown(value: Fraction | float, infinite: str = "unbounded") -> str:
    """A value with all its digits, or the word for an infinite one; below all it is impossible."""
    if is_finite(value):
        return digits(value)
    return infinite if value > 0 else "impossible"


def _settled_by_depth(plan: Plan) -> bool:
    """Whether what holds is proven depth by depth, in place of a bound on the whole."""
    depths = () if plan.satisfaction is None else plan.satisfaction.depths
    return bool(depths) and all(item.bound == item.value for item in depths)
