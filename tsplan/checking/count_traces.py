"""The meaning of a formula on counted agents."""

from __future__ import annotations

from collections.abc import Mapping
from typing import TYPE_CHECKING, Any

import numpy as np

if TYPE_CHECKING:
    from tsplan.logic import Formula
    from tsplan.logic.traces import CountTrace
    from tsplan.ts import TransitionSystem


def count_trace(system: TransitionSystem, counts: Mapping[str | None, Any]) -> CountTrace:
    """Counts by capability, arrays (..., states of the map, steps), as a trace of the map."""
    from tsplan.logic.traces import CountTrace  # noqa: PLC0415  (the parser is slow to import)

    row = {state: number for number, state in enumerate(system.states)}
    labels = {
        label: np.array([row[state] for state in members], dtype=np.int64)
        for label, members in system.labels.items()
    }
    return CountTrace(counts, labels)


def counts_robustness(
    system: TransitionSystem, formula: Formula, counts: Mapping[str | None, Any]
) -> float:
    """Counting robustness at step 0 of a formula, on counts (states of the map, steps)."""
    from tsplan.logic.evaluation import robustness  # noqa: PLC0415  (the parser is slow to import)

    return float(robustness(formula, count_trace(system, counts))[0])
