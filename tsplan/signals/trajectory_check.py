"""The independent check of a trajectory.

It reads nothing but the system, the formula and what the trajectory says of its start and its
controls: it simulates these in floats, holds every step against the bounds and limits, and
evaluates the formula as written on what comes out. Nothing of the model, the encoding or the
solver enters, so a mistake there cannot hide here.
"""

from __future__ import annotations

import math
from collections.abc import Iterator, Sequence
from dataclasses import replace

from tsplan.checking.check_report import Report, findings_of, refuse
from tsplan.errors import PlanError
from tsplan.plans.outcomes import ObjectiveValue, Status
from tsplan.plans.satisfaction import Depth
from tsplan.signals.equalities import TOLERANCE
from tsplan.signals.motion_check import (
    Motion,
    broken,
    deviations,
    led,
    settled,
    strangers,
)
from tsplan.signals.signal_measures import Measures, Worth, measured
from tsplan.signals.signal_mission import SignalMission
from tsplan.signals.trajectory import PartValue, Trajectory
from tsplan.stopping import StoppedBy
from tsplan.words import known, number

_NOUN = "trajectory"


def check(mission: SignalMission, trajectory: Trajectory) -> Report:
    """Judge a trajectory against its mission by its start and its controls alone.

    The report lists everything that is wrong at once. Signals, bounds, limits and values may be
    amiss by a millionth of their range. Values in the report are measured.
    """
    if not trajectory.has_signals:
        what = f"a trajectory of status {trajectory.status} has no signals to check"
        return Report(findings_of([what], _NOUN), (), noun=_NOUN)
    problems = list(strangers(mission.system, trajectory, mission.horizon))
    if problems:
        return Report(findings_of(problems, _NOUN), (), noun=_NOUN)
    motion = Motion(mission.system, trajectory)
    problems = list(deviations(motion, motion.simulated, "and the dynamics lead to"))
    try:
        own = led(motion, trajectory)
    except PlanError as error:  # an unstable system that is led beyond all numbers
        words = [finding.message for finding in error.findings]
        return Report(findings_of([*problems, *words], _NOUN), (), noun=_NOUN)
    motion = Motion(mission.system, own)
    measures = measured(mission, motion, own.trace())
    problems += [*broken(motion), *_broken_formula(mission, measures)]
    problems += _false_claims(trajectory, measures)
    facts = () if problems else tuple(_facts(mission, measures))
    values = {"robustness": measures.robustness}
    values |= {line.name: line.value for line in measures.objective if line.value is not None}
    return Report(findings_of(problems, _NOUN), facts, values=values, noun=_NOUN)


def certify(mission: SignalMission, trajectory: Trajectory) -> Trajectory:
    """The trajectory with everything in it measured, marked as verified.

    Controls and the start are brought into their bounds first, and the signals become what they
    lead to; without dynamics the signals themselves are brought into their bounds. Of what the
    trajectory claims its status and the bounds of its objective are kept as far as they stand up
    to what is measured: a bound that is refuted is left out, and a trajectory that falls short of
    what was claimed is called optimal no longer; notes say so.

    Trajectories without signals are returned as they are. Raises SolverError with everything that
    is wrong, and with where the simulation leads elsewhere than the trajectory said.
    """
    if not trajectory.has_signals:
        return trajectory
    refuse(list(strangers(mission.system, trajectory, mission.horizon)), _NOUN)
    own, problems = appraised(mission, trajectory)
    if problems:
        claimed = {name: trajectory[name] for name in mission.system.signals}
        motion = Motion(mission.system, own)
        refuse([*problems, *deviations(motion, claimed, "where the search had")], _NOUN)
    return replace(own, verified=True)


def appraised(
    mission: SignalMission, trajectory: Trajectory, past: int | None = None
) -> tuple[Trajectory, tuple[str, ...]]:
    """The trajectory with everything in it measured as `certify` does, and what is wrong, in words.

    What is `past` stays as it was measured: the signals up to that step and the controls before it.
    The dynamics lead on from there, and bounds and limits are judged from there on; the formula is
    judged on all of it.
    """
    own = settled(mission.system, trajectory, past)
    motion = Motion(mission.system, own, past)
    measures = measured(mission, motion, own.trace())
    told = replace(
        _with_claims(own, measures),
        robustness=known(measures.robustness),
        agm=measures.agm,
        fraction=measures.fraction,
        preference=measures.preference,
        parts=measures.parts,
    )
    return told, (*broken(motion), *_broken_formula(mission, measures))


def _broken_formula(mission: SignalMission, measures: Measures) -> Iterator[str]:
    """Whether the formula holds where it must as a whole, and which of its parts do not."""
    if measures.satisfied or mission.satisfaction is not None:
        return
    yield f"the formula does not hold ({_by(measures.robustness)})"
    for part in measures.parts[: len(mission.parts)]:
        if part.fraction != 1:
            slack = -math.inf if part.robustness is None else part.robustness
            yield f"the part {part.text} does not hold ({_by(slack)})"


def _by(robustness: float) -> str:
    if robustness == 0:
        return "its robustness is 0, and a comparison is strict"
    return f"its robustness is {_told(robustness)}"


def _told(value: float | None) -> str:
    if value is None or math.isinf(value):
        return "impossible" if value is not None and value < 0 else "unbounded"
    return number(value)


def _with_claims(trajectory: Trajectory, measures: Measures) -> Trajectory:
    """The trajectory with its measured objective, and with its claims as far as they stand."""
    claims: dict[str, list[ObjectiveValue]] = {}
    for item in trajectory.objective:
        claims.setdefault(item.name, []).append(item)
    lines, notes, proven = [], [], True
    for worth in measures.objective:
        claimed = (claims.get(worth.name) or [ObjectiveValue(worth.name, None)]).pop(0)
        bound, words = _bound_left(worth, claimed)
        proof = None if bound is None else claimed.proof
        lines.append(ObjectiveValue(worth.name, worth.value, bound, proof))
        notes += words
        proven = proven and not words and not (worth.head and _open(worth, bound))
    bounds = {item.depth: item.bound for item in trajectory.depths}
    depths = tuple(Depth(d, n, bounds.get(d)) for d, n in enumerate(measures.depths))
    proven = proven and all(item.bound == item.value for item in depths)
    made = replace(
        trajectory, objective=tuple(lines), depths=depths, notes=(*trajectory.notes, *notes)
    )
    if trajectory.status is not Status.OPTIMAL or proven:
        return made
    return replace(made, status=Status.FEASIBLE, stopped_by=StoppedBy.PRECISION)


def _bound_left(worth: Worth, claimed: ObjectiveValue) -> tuple[float | None, list[str]]:
    """The bound that the measured value leaves, and what was claimed and is not so."""
    words = []
    if claimed.value is not None and worth.better(claimed.value) > worth.tolerance:
        what = f"the search claimed {worth.name} {_told(claimed.value)}"
        words.append(f"{what}, and the trajectory has {_told(worth.value)}")
    if claimed.bound is None:
        return None, words
    short = -worth.better(claimed.bound)
    if short > worth.tolerance:
        what = f"the trajectory has {worth.name} {_told(worth.value)}"
        return None, [*words, f"{what}, better than the bound {_told(claimed.bound)} of the search"]
    return worth.value if short > 0 else claimed.bound, words


def _open(worth: Worth, bound: float | None) -> bool:
    """Whether a trajectory might do better; an infinite robustness is the best there is."""
    if worth.value is None:
        return False
    return bound is None or worth.better(bound) > worth.tolerance


def _false_claims(trajectory: Trajectory, measures: Measures) -> Iterator[str]:
    """What a trajectory says about itself and is not so."""
    for name in ("robustness", "agm", "fraction", "preference"):
        said, actual = getattr(trajectory, name), known(getattr(measures, name))
        if not _same(said, actual, measures.slack if name == "robustness" else TOLERANCE):
            yield f"the trajectory claims {name} {said} and has {actual}"
    yield from _false_depths(trajectory, measures)
    yield from _false_parts(trajectory.parts, measures.parts, measures.slack)
    names = [line.name for line in measures.objective]
    if [item.name for item in trajectory.objective] != names:
        said = ", ".join(item.name for item in trajectory.objective)
        yield f"the objective of the trajectory is {said}, and the mission's {', '.join(names)}"
        return
    for worth, item in zip(measures.objective, trajectory.objective, strict=True):
        yield from _false_line(worth, item, trajectory.status)


def _false_depths(trajectory: Trajectory, measures: Measures) -> Iterator[str]:
    told = tuple(item.value for item in trajectory.depths)
    if told != measures.depths:
        yield f"the trajectory claims {told} parts by depth and has {measures.depths}"
        return
    for item in trajectory.depths:
        if trajectory.status is Status.OPTIMAL and item.bound != item.value:
            what = "no bound" if item.bound is None else f"the bound {item.bound}"
            yield f"the {item.value} parts at depth {item.depth} are called optimal, with {what}"
            return


def _false_parts(
    told: Sequence[PartValue], actual: Sequence[PartValue], slack: float
) -> Iterator[str]:
    if [part.text for part in told] != [part.text for part in actual]:
        yield "the parts of the trajectory are not those of the mission's formula"
        return
    for said, true in zip(told, actual, strict=True):
        same = _same(said.robustness, true.robustness, slack)
        if not (same and _same(said.fraction, true.fraction, TOLERANCE)):
            shown = f"{_told(true.robustness)}, {number(true.fraction)} of it holds"
            yield f"the account of the part {said.text} is not so: its robustness is {shown}"


def _false_line(worth: Worth, item: ObjectiveValue, status: Status) -> Iterator[str]:
    if not _same(item.value, worth.value, worth.tolerance):
        yield f"the trajectory claims {worth.name} {item.value} and has {worth.value}"
    value = _told(worth.value)
    if item.bound is not None and -worth.better(item.bound) > worth.tolerance:
        yield f"{worth.name} {value} is better than its bound {_told(item.bound)}"
    elif status is Status.OPTIMAL and worth.head and _open(worth, item.bound):
        bound = "no bound proves it" if item.bound is None else f"its bound is {_told(item.bound)}"
        yield f"{worth.name} is called optimal at {value}, and {bound}"


def _same(said: float | None, actual: float | None, slack: float) -> bool:
    if said is None or actual is None:
        return said is actual
    return abs(said - actual) <= slack


def _facts(mission: SignalMission, measures: Measures) -> Iterator[str]:
    """In words, what was found to hold of an accepted trajectory."""
    system = mission.system
    within = f"within {TOLERANCE:g} of its range"
    if system.dynamics is None:
        yield f"every signal stays in its bounds up to step {mission.horizon}, {within}"
    else:
        yield f"the controls lead every signal from its start as told, {within}"
        yield f"signals and controls stay in their bounds up to step {mission.horizon}"
    if system.limits:
        yield "every limit is kept"
    if measures.satisfied:
        yield f"the formula holds, with robustness {_told(measures.robustness)}"
    else:
        yield f"the formula holds in part, with satisfaction {_told(measures.fraction)}"
    if measures.agm is not None:
        yield f"its arithmetic-geometric mean robustness is {number(measures.agm)}"
    yield from (f"{line.name} is {_told(line.value)}" for line in measures.objective)
