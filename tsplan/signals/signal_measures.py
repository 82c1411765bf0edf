"""What a trajectory is worth, by the evaluator alone: robustness, fractions, efforts."""

from __future__ import annotations

import math
from collections.abc import Iterator, Mapping
from dataclasses import dataclass
from typing import NamedTuple

import numpy as np

from tsplan.checking.satisfaction_check import least_spare
from tsplan.logic import Formula, Linear, positive, variables, walk
from tsplan.logic.evaluation import holds, robustness
from tsplan.logic.fraction import fraction
from tsplan.logic.traces import SignalTrace
from tsplan.logic.weights import unweighted
from tsplan.logic.witness_steps import levels
from tsplan.mission.mission_parts import Preference
from tsplan.signals.aims import SENSES, Aim
from tsplan.signals.equalities import TOLERANCE, approximate, equations, tree
from tsplan.signals.motion_check import Motion
from tsplan.signals.signal_mission import SignalMission
from tsplan.signals.trajectory import PartValue
from tsplan.words import known

_EXACT = 1e-9  # fractions are sums of few, and exact but for what floats round


class Worth(NamedTuple):
    """One line of the objective: what it comes to, by how much a claim may differ, its sense.

    `head` is the aim itself; what follows are the terms of its sum. An aim that is settled depth
    by depth is no head: its bounds are told there.
    """

    name: str
    value: float | None
    tolerance: float
    rises: bool
    head: bool

    def better(self, other: float) -> float:
        """By how much another value is better than that of the trajectory."""
        gain = other - (math.inf if self.value is None else self.value)
        return gain if self.rises else -gain


@dataclass(frozen=True)
class Measures:
    """What was measured; `parts` are those that the mission's formula joins, and the preferred.

    Claims of a robustness may differ from it by `slack`.
    """

    satisfied: bool
    robustness: float
    agm: float | None
    fraction: float | None
    preference: float | None
    parts: tuple[PartValue, ...]
    depths: tuple[int, ...]
    objective: tuple[Worth, ...]
    slack: float


def measured(mission: SignalMission, motion: Motion, trace: SignalTrace) -> Measures:
    """Judge the formula and what it consists of on a trace, and add up the efforts."""
    formula, partial = mission.formula, mission.satisfaction is not None
    satisfied, by = _judged(mission, formula, trace)
    # equations hold within as much again
    slack = (
        TOLERANCE * _widest(mission, motion) * (1 if next(equations(formula), None) is None else 2)
    )
    whole = mission.parts or ((mission.text or str(formula), formula),)
    parts = (*whole, *((wish.text, wish.formula) for wish in mission.prefer))
    terms = {"robustness": _spare(mission, trace, by)}
    near = approximate(formula, mission.system)
    preferred = float(fraction(near, trace, weighted=True)) if partial else None
    if preferred is not None:
        terms["satisfaction"] = preferred
    by_depth = levels(tree(formula, mission.system), trace).counts if _by_depth(mission) else ()
    if mission.prefer:
        terms["preferences"] = sum(_gain(wish, mission, trace) for wish in mission.prefer)
    return Measures(
        satisfied,
        by,
        _agm(mission, trace),
        float(fraction(near, trace)) if partial else None,
        preferred,
        tuple(_part(mission, text, part, trace) for text, part in parts),
        by_depth,
        tuple(
            line._replace(head=line.head and not (by_depth and aim.name == "satisfaction"))
            for aim in mission.objective
            for line in _lines(aim, motion, terms, slack)
        ),
        slack,
    )


def _by_depth(mission: SignalMission) -> bool:
    """Whether what holds is counted by its depth."""
    return mission.satisfaction not in (None, "weighted")


def _judged(mission: SignalMission, formula: Formula, trace: SignalTrace) -> tuple[bool, float]:
    """Whether a formula holds at the first step, and its robustness there, with its weights."""
    by = robustness(formula, trace, kind=mission.weighting)
    return bool(holds(approximate(formula, mission.system), trace)[0]), float(by[0])


def _agm(mission: SignalMission, trace: SignalTrace) -> float | None:
    """The arithmetic-geometric mean robustness, None where a signal of the formula is unbounded."""
    system = mission.system
    bounds = {**system.signals, **system.controls}
    named = [bounds[name] for name in variables(mission.formula)]
    if not all(low < high and math.isfinite(high - low) for low, high in named):
        return None
    return float(robustness(mission.formula, trace, kind="agm", bounds=bounds)[0])


def _spare(mission: SignalMission, trace: SignalTrace, slack: float) -> float:
    """The robustness that is optimised: of what holds, where not everything has to."""
    if mission.satisfaction is not None:
        return least_spare([(tree(mission.formula, mission.system), True)], trace)
    wishes = [(tree(wish.formula, mission.system), wish.partial) for wish in mission.prefer]
    return least_spare(wishes, trace, slack)


def _gain(wish: Preference, mission: SignalMission, trace: SignalTrace) -> float:
    """What a preferred formula is worth."""
    near = approximate(wish.formula, mission.system)
    share = float(fraction(near, trace, weighted=wish.partial))
    return float(wish.weight) * (share if wish.partial else float(share == 1))


def _part(mission: SignalMission, text: str, part: Formula, trace: SignalTrace) -> PartValue:
    satisfied, slack = _judged(mission, part, trace)
    near = approximate(part, mission.system)
    return PartValue(text, known(slack), 1.0 if satisfied else float(fraction(near, trace)))


def _lines(aim: Aim, motion: Motion, terms: Mapping[str, float], slack: float) -> Iterator[Worth]:
    """An aim, and what its sum consists of."""
    worth = [_term(aim, name, motion, terms, slack) for name, _ in aim.weights]
    if len(worth) == 1 and aim.name == worth[0].name:
        yield worth[0]._replace(head=True)
        return
    factors = [factor for _, factor in aim.weights]
    if any(item.value is None for item in worth):
        total = None
    else:
        signed = (
            (factor if item.rises else -factor) * (item.value or 0.0)
            for factor, item in zip(factors, worth, strict=True)
        )
        total = math.fsum(signed)
    tolerance = sum(abs(f) * item.tolerance for f, item in zip(factors, worth, strict=True))
    yield Worth(aim.name, total, tolerance, aim.rises, head=True)
    yield from worth


def _term(aim: Aim, name: str, motion: Motion, terms: Mapping[str, float], slack: float) -> Worth:
    """One term of an aim."""
    rises = SENSES.get(name, "maximise") == "maximise"
    if name in terms:
        exact = name != "robustness"
        return Worth(name, known(terms[name]), _EXACT if exact else slack, rises, head=False)
    system = motion.system
    every = system.signals if name == "state_effort" else system.controls
    factors = aim.efforts.get(name) or dict.fromkeys(every, 1.0)
    value = math.fsum(f * float(np.abs(motion.values[n]).sum()) for n, f in factors.items())
    width = motion.horizon * motion.width(tuple(factors.items()))
    return Worth(name, value, TOLERANCE * width, rises, head=False)


def _widest(mission: SignalMission, motion: Motion) -> float:
    """The greatest range of a predicate, with the weights on the way to it."""
    plain = unweighted(positive(mission.formula), mission.weighting)
    return max(
        (motion.width(node.terms) for node in walk(plain) if isinstance(node, Linear)),
        default=0.0,
    )
