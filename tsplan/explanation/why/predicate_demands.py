"""When a formula asks for its predicates over signals, and when a trajectory fulfils it by them.

Everything is computed by the evaluator from the signals, never from the solver.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from dataclasses import dataclass
from math import isclose
from typing import TYPE_CHECKING

import numpy as np

from tsplan.explanation.why.requirements import judged_atoms, runs
from tsplan.logic.atoms import Linear
from tsplan.logic.evaluation import robustness
from tsplan.logic.nodes import And
from tsplan.logic.normal_form import positive
from tsplan.logic.traces import SignalTrace
from tsplan.logic.traversal import walk
from tsplan.logic.weights import unweighted
from tsplan.signals.equalities import approximate

if TYPE_CHECKING:
    from tsplan.logic.nodes import Formula
    from tsplan.logic.time_horizon import Span
    from tsplan.signals.signal_mission import SignalMission
    from tsplan.signals.trajectory import Trajectory


_CLOSE = 1e-12  # by which a number that was multiplied and divided again may differ


@dataclass(frozen=True, slots=True)
class PredicateDemand:
    """One predicate of a formula in positive normal form, and the steps it is asked for.

    `windows` are the steps `(first, last)` at which the formula can ask for it, one for each place
    in the formula. `witness_steps` are the runs of steps at which the trajectory satisfies the
    formula by it, or comes nearest to that where it fails; `spare` is the least robustness over
    them, None where there are none. `wished` says that it belongs to a preferred formula.
    """

    atom: Linear
    windows: tuple[Span, ...]
    witness_steps: tuple[Span, ...]
    spare: float | None
    wished: bool = False

    @property
    def fails(self) -> bool:
        """Whether it is what makes the formula fail."""
        return self.spare is not None and self.spare < 0


def predicate_demands(
    mission: SignalMission, trajectory: Trajectory | None = None
) -> tuple[PredicateDemand, ...]:
    """The predicates of a mission in the order of its text; without a trajectory no witnesses.

    Where the formula may hold in part, each of its outermost parts is looked at by itself, so that
    one that fails does not hide what holds. Preferred formulas follow. Weights are multiplied into
    the robustness, not into the predicates as they are shown.
    """
    if trajectory is None:
        nothing = np.zeros(mission.horizon + 1)
        trace = SignalTrace(dict.fromkeys(mission.system.names, nothing))
    else:
        trace = trajectory.trace()
    made = []
    for formula, wished in _demands(mission):
        written = [node for node in walk(formula) if isinstance(node, Linear)]
        judged = positive(unadorned(mission, formula, trace))
        for atom, values, owed in judged_atoms(judged, trace):
            if isinstance(atom, Linear):
                steps = owed.steps if trajectory is not None else owed.steps[:0]
                spare = float(values[steps].min()) if steps.size else None
                windows = tuple(sorted(owed.windows))
                shown = _alike(atom, written)
                made.append(PredicateDemand(shown, windows, runs(steps), spare, wished))
    return tuple(made)


def unadorned(mission: SignalMission, formula: Formula, trace: SignalTrace) -> Formula:
    """A formula with weights multiplied into its predicates, and equations as the check takes them.

    Its robustness is that which is told of a trajectory.
    """
    nodes = tuple(walk(formula))
    if any(getattr(node, "weights", None) is not None for node in nodes):
        holds = bool(robustness(formula, trace, kind=mission.weighting)[0] >= 0)
        formula = unweighted(formula, mission.weighting, satisfied=holds)
    if any(isinstance(node, Linear) and node.relation in ("=", "!=") for node in nodes):
        formula = approximate(formula, mission.system)
    return formula


def _alike(atom: Linear, written: Iterable[Linear]) -> Linear:
    """The predicate that was written, of which another one is a multiple; else that one."""
    for other in written:
        factor = atom.terms[0][1] / other.terms[0][1] if atom.terms and other.terms else 1.0
        same = [name for name, _ in atom.terms] == [name for name, _ in other.terms]
        pairs = zip(
            (*atom.terms, ("", atom.bound)), (*other.terms, ("", other.bound)), strict=False
        )
        close = all(isclose(a, factor * b, rel_tol=_CLOSE) for (_, a), (_, b) in pairs)
        if same and close and atom.relation == other.relation:
            return other
    return atom


def _demands(mission: SignalMission) -> Iterator[tuple[Formula, bool]]:
    """The formulas that are looked at, and whether they are only preferred."""
    whole = positive(mission.formula)
    apart = mission.satisfaction is not None and isinstance(whole, And)
    yield from ((part, False) for part in (whole.children if apart else (whole,)))
    yield from ((positive(soft.formula), True) for soft in mission.prefer)
