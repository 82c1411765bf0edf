"""What is tight about a mission over signals that can be met: what keeps robustness down."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import replace
from typing import TYPE_CHECKING

import numpy as np

from tsplan.explanation.explanation import Fact
from tsplan.explanation.why.critical_atoms import MOST_ATOMS, settling
from tsplan.explanation.why.requirements import runs
from tsplan.explanation.why.tightness import PATIENCE, held_down, part_ways
from tsplan.explanation.why.witness_tree import explain_on
from tsplan.explanation.whynot.occurrences import Occurrence, exchanged, node_at
from tsplan.explanation.whynot.signal_numbers import grain, width_of
from tsplan.logic import Formula, Linear, fold, positive, walk
from tsplan.logic.text import sum_text
from tsplan.plans.outcomes import Status
from tsplan.signals.aims import Aim
from tsplan.words import number, run_words

if TYPE_CHECKING:
    from tsplan.explanation.whynot.oracle import Oracle
    from tsplan.signals.signal_mission import SignalMission
    from tsplan.signals.trajectory import Trajectory

_CLOSE = 1e-6  # of the range: robustness this near the whole's counts as that
_MORE = 100  # steps in which numbers are told, by which more robustness is asked for


def tight_signals(oracle: Oracle) -> Iterator[Fact]:
    """What keeps robustness from being greater: in any trajectory, and in the best one found."""
    subject = oracle.subject
    mission: SignalMission = subject.mission
    left = oracle.clock.left
    limit = PATIENCE if left is None else min(PATIENCE, max(left / 2, 1.0))
    aim = Aim((("robustness", 1.0),))
    wanted = replace(mission, objective=(aim,), prefer=(), satisfaction=None, warnings=())
    best = oracle.planned(wanted, limit)
    if best is None or not best.has_signals or best.robustness is None:
        return  # no time, or it asks for nothing
    level = number(best.robustness)
    place = subject.wording.sources.place(Occurrence(()))
    if best.status is not Status.OPTIMAL:
        text = f"the most robust trajectory found has robustness {level}; there may be better ones"
        yield Fact("tight", text, place)
    else:
        text = f"the most robust trajectories have robustness {level}"
        reason = []
        if not _weighted(mission.formula):
            more = _MORE * float(grain(_widest(mission)))
            reason = held_down(oracle, _tightened(mission, best.robustness + more))
        if reason:
            named = "; ".join(words for words, _ in reason)
            text += f"; with {number(more)} more these cannot hold together: {named}"
        yield Fact("tight", text, reason[0][1] if reason else place)
    if not _weighted(mission.formula):
        yield from _critical(oracle, best)


def _weighted(formula: Formula) -> bool:
    return any(getattr(node, "weights", None) is not None for node in walk(formula))


def _widest(mission: SignalMission) -> float:
    atoms = (node for node in walk(mission.formula) if isinstance(node, Linear))
    return max((width_of(mission, node.terms) for node in atoms), default=1.0)


def _critical(oracle: Oracle, best: Trajectory) -> Iterator[Fact]:
    """The comparisons whose robustness is that of the whole trajectory, with their steps."""
    mission, wording = oracle.subject.mission, oracle.subject.wording
    top = explain_on(mission.formula, best.trace())
    close = _CLOSE * _widest(mission)
    told = 0
    for occurrence, _, node in sorted(settling(top), key=lambda found: found[0].way):
        judged = zip(node.steps, node.availability, strict=True)
        steps = [step for step, value in judged if value <= (top.worst or 0.0) + close]
        if steps and told < MOST_ATOMS:
            told += 1
            when = run_words(runs(np.array(sorted(steps), dtype=np.int64)))
            at = f"step {when}" if when.isdigit() else f"steps {when}"
            part = wording.part_of(occurrence)
            values = ""
            if isinstance(node.formula, Linear):
                trace = best.trace()
                value = sum(
                    factor * trace.signals[name][steps[0]] for name, factor in node.formula.terms
                )
                values = f"{sum_text(node.formula.terms)} is {number(value)} "
            yield Fact("tight", f"{part.text}: {values}at {at}", part.place, (part,))


def _tightened(mission: SignalMission, level: float) -> Formula:
    """The formula that holds where the mission's has a robustness of at least `level`."""

    def atom(node: Formula, below: tuple[Formula, ...]) -> Formula:
        if not isinstance(node, Linear):
            return node.over(below)
        by = level if node.relation in (">=", ">") else -level
        return replace(node, bound=node.bound + by)

    formula = mission.formula
    return exchanged(
        formula, {way: fold(positive(node_at(formula, way)), atom) for way in part_ways(mission)}
    )
