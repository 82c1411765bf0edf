"""When a formula asks for its predicates over signals, and when a trajectory fulfils it by them.

Everything is computed by the evaluator from the signals, never from the solver.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np

from tsplan.explanation.why.requirements import judged_atoms, runs
from tsplan.logic.atoms import Linear
from tsplan.logic.nodes import And
from tsplan.logic.traces import SignalTrace
from tsplan.signals.equalities import approximate

if TYPE_CHECKING:
    from tsplan.logic.nodes import Formula
    from tsplan.logic.time_horizon import Span
    from tsplan.signals.signal_mission import SignalMission
    from tsplan.signals.trajectory import Trajectory


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
    one that fails does not hide what holds. Preferred formulas follow. Weights are left aside.
    """
    if trajectory is None:
        nothing = np.zeros(mission.horizon + 1)
        trace = SignalTrace(dict.fromkeys(mission.system.names, nothing))
    else:
        trace = trajectory.trace()
    made = []
    for formula, wished in _demands(mission):
        for atom, values, owed in judged_atoms(formula, trace):
            if isinstance(atom, Linear):
                steps = owed.steps if trajectory is not None else owed.steps[:0]
                spare = float(values[steps].min()) if steps.size else None
                windows = tuple(sorted(owed.windows))
                made.append(PredicateDemand(atom, windows, runs(steps), spare, wished))
    return tuple(made)


def _demands(mission: SignalMission) -> Iterator[tuple[Formula, bool]]:
    """The formulas that are looked at, and whether they are only preferred."""
    whole = approximate(mission.formula, mission.system)
    apart = mission.satisfaction is not None and isinstance(whole, And)
    yield from ((part, False) for part in (whole.children if apart else (whole,)))
    yield from ((approximate(soft.formula, mission.system), True) for soft in mission.prefer)
