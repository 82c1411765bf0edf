"""What has to fit together in a mission over signals: formula and system, objective, horizon."""

from __future__ import annotations

from collections.abc import Iterator
from math import isfinite

import numpy as np

from tsplan.errors import Nearest
from tsplan.limits import MOST_STEPS
from tsplan.logic import (
    Always,
    And,
    Constant,
    Count,
    Eventually,
    Formula,
    Limit,
    Linear,
    Task,
    positive,
    substitute,
    walk,
    walk_all,
)
from tsplan.mission.findings import FORMULA, Fault, moved, preferred
from tsplan.mission.formula_checks import horizon_faults
from tsplan.mission.mission_checks import preference_faults
from tsplan.signals.aim_entries import aim_faults, effort_faults
from tsplan.signals.copies import base_names, prefixed
from tsplan.signals.linear_system import System
from tsplan.signals.reach import reach
from tsplan.signals.signal_parts import SignalParts
from tsplan.signals.signal_schema import LARGEST_VALUE
from tsplan.signals.system_checks import system_faults


def mission_faults(mission: SignalParts) -> list[Fault]:
    """Everything that does not fit together in a mission."""
    faults = system_faults(mission.system)
    faults += region_faults(mission)
    faults += choice_faults(mission, named=True)
    sound = not any(fault.serious for fault in faults)
    partial = mission.satisfaction is not None
    faults += formula_checks(mission.formula, mission, optional=partial, sound=sound)
    for number, soft in enumerate(mission.prefer):
        found = formula_checks(soft.formula, mission, optional=True, sound=sound)
        faults += moved(found, preferred(number))
    return faults


def formula_checks(
    formula: Formula, mission: SignalParts, *, optional: bool, sound: bool
) -> list[Fault]:
    """What does not fit in a formula of a mission; one may be `optional`, as preferences are.

    Where the system is not `sound`, nothing is said of how far its signals can go.
    """
    system, horizon = mission.system, mission.horizon
    faults = [
        *formula_faults(formula, mission),
        *horizon_faults(formula, "closed", horizon),
    ]
    if sound and not faults:
        unbounded = unbounded_names(system, horizon)
        faults += unbounded_faults(formula, unbounded, optional=optional)
    if weighs_robustness(mission) and not optional:
        faults += equation_faults(formula)
    return faults


def choice_faults(mission: SignalParts, *, named: bool) -> Iterator[Fault]:
    """Objectives and preferences that are out of place; of efforts, where signals are known."""
    yield from aim_faults(mission.objective)
    if named:
        yield from effort_faults(mission.objective, mission.system)
    names = [aim.name for aim in mission.objective]
    yield from preference_faults(names, mission.prefer, None)


def weighs_robustness(mission: SignalParts) -> bool:
    """Whether some objective is about the robustness of the formula."""
    return any(term == "robustness" for aim in mission.objective for term, _ in aim.weights)


def region_faults(mission: SignalParts) -> Iterator[Fault]:
    """Regions along something that is no signal of the system, or of each of several robots."""
    known = set(mission.system.signals)
    shared = base_names(mission.system.signals, mission.copies)
    closest = Nearest({*known, *shared})
    for name, region in mission.regions.items():
        if not (set(region.axes) <= known or set(region.axes) <= shared):
            for axis in region.axes:
                if axis not in known:
                    what = f"there is no signal '{axis}', along which region '{name}' lies"
                    yield Fault(("regions", name, axis), what, closest(axis))


def formula_faults(formula: Formula, mission: SignalParts) -> Iterator[Fault]:
    """Names of no signal, numbers that no solver takes, atoms of other languages."""
    known = frozenset(mission.system.names)
    named = {*known, *mission.system.outputs}
    shared = base_names(named, mission.copies)
    closest = Nearest(named)
    for node in walk(formula):
        if isinstance(node, Count | Task | Limit):
            what = f"'{node}' counts robots, and this mission has only signals"
            yield Fault(FORMULA, what, "compare signals, such as x >= 3", node=node)
        if not isinstance(node, Linear):
            continue
        for name, _ in node.terms:
            if name in known:
                continue
            what, remedy = f"there is no signal or control '{name}'", closest(name)
            if name in mission.system.outputs:
                what = f"'{name}' is an output, and not written out as what it stands for"
                remedy = "give the formula to SignalMission.of"
            elif name in shared:
                one = mission.copies[0]
                remedy = f"say of which robot: {prefixed(one, name)}, or in({one}, region)"
            yield Fault(FORMULA, what, remedy, node=node, way=("signal", name))
        if mission.horizon == 0 and any(name in mission.system.controls for name, _ in node.terms):
            what = f"'{node}' is about a control, and there is none with a horizon of 0"
            yield Fault(FORMULA, what, "set 'horizon' to at least 1", node=node)
        if any(abs(number) >= LARGEST_VALUE for number in (node.bound, *dict(node.terms).values())):
            what = f"'{node}' has a number that is as good as infinite"
            yield Fault(FORMULA, what, "use smaller units", node=node)


def unbounded_names(system: System, horizon: int) -> frozenset[str]:
    """The signals and controls that may be without end at some step, for all that is known.

    A signal without bounds has an end all the same where it begins and goes on within some.
    """
    ranges = [*system.signals.values(), *system.controls.values()]
    if all(isfinite(end) for ends in ranges for end in ends) or horizon > MOST_STEPS:
        return frozenset()
    reached = reach(system, horizon)
    ended = np.isfinite(np.hstack([reached.low, reached.high])).all(axis=1)
    return frozenset(system.names[row] for row in np.flatnonzero(~ended))


def unbounded_faults(
    formula: Formula, unbounded: frozenset[str], *, optional: bool
) -> Iterator[Fault]:
    """Names without bounds in predicates that need not hold; any, where the formula is `optional`.

    What need not hold is relaxed by how far its signals can go, which has to be known then.
    """
    if not unbounded or not _is_over_signals(formula):
        return
    normal = positive(formula)
    choices = [normal] if optional else _choices(normal)
    loose = {(one.terms, one.bound) for one in walk_all(choices) if isinstance(one, Linear)}
    told: set[str] = set()
    for node in walk(formula):
        if isinstance(node, Linear) and (node.terms, node.bound) in loose:
            for name, _ in node.terms:
                if name in unbounded and name not in told:
                    told.add(name)
                    what = f"'{node}' need not hold, and '{name}' in it has no bounds"
                    remedy = f"give '{name}' a min and a max"
                    yield Fault(FORMULA, what, remedy, node=node, way=("signal", name))


def _choices(normal: Formula) -> list[Formula]:
    """The parts of a normal form that need not hold for it to hold."""
    return [
        child
        for node in walk(normal)
        if not isinstance(node, And | Always)
        and not (isinstance(node, Eventually) and node.low == node.high)
        for child in node.children
    ]


def equation_faults(formula: Formula) -> Iterator[Fault]:
    """Equations that are to hold, whose robustness is never above 0 (warnings)."""
    if not _is_over_signals(formula):
        return
    equations = [n for n in walk(formula) if isinstance(n, Linear) and n.relation in ("=", "!=")]
    # as a predicate whose relation says in the normal form whether the equation is to hold
    marks: dict[Formula, Formula] = {
        node: Linear((("=", 1.0),), ">" if node.relation == "=" else "<=", float(number))
        for number, node in enumerate(equations)
    }
    asked = {
        node.bound
        for node in walk(positive(substitute(formula, marks)))
        if isinstance(node, Linear) and node.terms == (("=", 1.0),) and node.relation == ">"
    }
    for number, node in enumerate(equations):
        if number in asked:
            what = f"'{node}' can only hold with a robustness of 0, so there is none to maximise"
            if node.relation == "!=":
                what = f"the negation of {what}"
            remedy = "ask for a range, such as x >= 2.9 && x <= 3.1"
            yield Fault(FORMULA, what, remedy, serious=False, node=node)


def _is_over_signals(formula: Formula) -> bool:
    """Whether all its atoms are predicates over signals."""
    return all(node.children or isinstance(node, Linear | Constant) for node in walk(formula))
