"""By how much signals miss what they cannot keep any more, and as little of that as can be.

Where a disturbance has led a system to where its formula or its bounds cannot be kept, the best
that is left is to miss them by little. The violation of a trajectory adds up the amounts by which
things are missed that are still to come: at every step the bounds of signals, the limits that name
one, own constraints, and once the formula, by how far its robustness is below 0. What the past has
settled is not counted: nothing can be done about it, and it would hide what can. A sum, unlike the
greatest of the amounts, lets nothing be missed in the shade of something else.

Source: E. C. Kerrigan and J. M. Maciejowski, "Soft constraints and exact penalty functions in model
predictive control", UKACC Control 2000.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass

import numpy as np

from tsplan.logic import Always, And, Constant, Formula, conjunction, horizon
from tsplan.logic.evaluation import robustness
from tsplan.milp.model import Floats
from tsplan.milp.target import Target
from tsplan.signals.linear_system import Limit
from tsplan.signals.signal_model import SignalModel
from tsplan.signals.signal_objectives import SignalObjective, SignalPoint
from tsplan.signals.signal_setting import SignalSetting


def remaining(goal: Formula, step: int) -> Formula:
    """What a formula asks for beyond what the steps up to one have settled.

    Parts of it that must all hold are left out where they look at no later step.

    >>> from tsplan.logic import parse
    >>> print(remaining(parse("F[0,3] a > 0 && G[2,9] (b > 0 && F[0,1] c > 0)", "stl"), 4))
    G[5,9] (b > 0) && G[4,9] F[0,1] (c > 0)
    """
    return conjunction(_remaining(goal, 0, 0, step))


def _remaining(goal: Formula, low: int, high: int, step: int) -> Iterator[Formula]:
    """The parts of a formula that must hold at the steps from `low` to `high`."""
    waiting = [(goal, low, high)]
    while waiting:
        node, low, high = waiting.pop()
        if isinstance(node, And):
            waiting += [(child, low, high) for child in reversed(node.children)]
        elif isinstance(node, Always):
            waiting.append((node.child, low + node.low, high + node.high))
        else:
            first = max(low, step + 1 - horizon(node))
            if first <= high and not isinstance(node, Constant):
                yield node if first == high == 0 else node.always(first, high)


def violation(setting: SignalSetting, rows: Floats) -> float:
    """The amounts by which signals and controls (names, T+1) miss what is to come, added up."""
    names, reach = setting.system.names, setting.reach
    values = dict(zip(names, rows, strict=True))
    found = []
    for name, ends in setting.system.signals.items():
        ahead = values[name][reach.ahead :]
        found.append(float(np.abs(ahead - np.clip(ahead, *ends)).sum()))
    found += [_excess(setting, limit, values) for limit in setting.system.limits]
    for row in setting.own:
        if not row.settled(setting.system, reach.past):
            total = sum(by * float(values[name][step]) for name, step, by in row.terms)
            found += [max(row.low - total, 0.0), max(total - row.high, 0.0)]
    demand = setting.goal if setting.soft is None else setting.soft.demand
    trace = SignalPoint.of(rows).trace(setting.system)
    found.append(max(-float(robustness(demand, trace)[0]), 0.0))
    return sum(found)


def _excess(setting: SignalSetting, limit: Limit, values: dict[str, Floats]) -> float:
    """By how much a limit is missed at the steps to come, added up."""
    steered = any(name in setting.system.controls for name in limit.names)
    first = setting.reach.now if steered else setting.reach.ahead
    last = setting.reach.horizon + (0 if steered else 1)
    parts = [(1.0, limit.terms, False), *((by, terms, True) for by, terms in limit.absolute)]
    total = np.full(max(last - first, 0), -float(limit.bound))
    for by, terms, absolute in parts:
        inner = sum((own * values[name][first:last] for name, own in terms), np.zeros(total.shape))
        total += by * (np.abs(inner) if absolute else inner)
    return float(np.maximum(total, 0.0).sum())


@dataclass(frozen=True, eq=False)
class LeastViolation(SignalObjective):
    """The violation, minimised."""

    name = "violation"
    sign = 1.0

    def target(self, setting: SignalSetting, made: SignalModel) -> Target:
        """The columns of what is missed."""
        vector = np.zeros(made.model.size.columns)
        vector[made.missed] = 1.0
        return Target(vector, step=0.0)

    def worth(self, setting: SignalSetting, point: SignalPoint) -> float:
        """The violation of the point's signals."""
        return violation(setting, point.rows)

    def ideal(self, setting: SignalSetting) -> float | None:
        """Nothing is missed by less than nothing."""
        return max(0.0, -setting.ideal if setting.soft is None else 0.0)
