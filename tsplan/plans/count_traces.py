"""The meaning of a formula on counted agents."""

from __future__ import annotations

from collections.abc import Mapping
from types import MappingProxyType
from typing import TYPE_CHECKING, Any

import numpy as np

from tsplan.logic.traces import CountTrace

if TYPE_CHECKING:
    from tsplan.ts import TransitionSystem


def count_trace(
    system: TransitionSystem,
    counts: Mapping[str | None, Any],
    executions: Mapping[str, Any] = MappingProxyType({}),
    most: Mapping[str | None, Any] = MappingProxyType({}),
) -> CountTrace:
    """Counts by capability, arrays (..., states of the map, steps), as a trace of the map.

    So are `executions`, by the texts of tasks, and `most`, what bounds from above are held against.
    """
    row = {state: number for number, state in enumerate(system.states)}
    labels = {
        label: np.array([row[state] for state in members], dtype=np.int64)
        for label, members in system.labels.items()
    }
    return CountTrace(counts, labels, executions, most)
