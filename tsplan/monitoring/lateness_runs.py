"""By how many steps what is still to come may be late, for each atom at each step.

If all agents stop now for a while and then go on as planned, counts stay as they are now for so
long and then come later. An atom that holds at a step has held since some step; it still holds then
if all is later by no more steps than have passed since, and however late all is if it holds from
now on until then. What has been so far is not changed by being late. The operators take the least
and the greatest of that, so a formula whose value is d holds if all is late by up to d steps.

Source: A. Donzé and O. Maler, "Robust satisfaction of temporal logic over real-valued signals",
FORMATS 2010 (time robustness).
"""

from __future__ import annotations

import numpy as np
import numpy.typing as npt

from tsplan.logic.traces import Floats

Bools = npt.NDArray[np.bool_]


class LatenessRuns:
    """The runs of steps at which one atom holds, as the trace is expected to be."""

    def __init__(self, holds: Bools) -> None:
        self._holds = holds.copy()
        self._since = np.zeros(holds.size, dtype=np.int64)
        self.refresh(0, holds, 0)

    def starts(self, first: int, end: int) -> npt.NDArray[np.int64]:
        """The steps from `first` to before `end` at which a run begins."""
        steps = np.arange(first, min(end, self._holds.size))
        return np.asarray(steps[self._holds[steps] & (self._since[steps] == steps)])

    def refresh(self, first: int, holds: Bools, now: int) -> tuple[int, Floats]:
        """Change the truths from a step on; from which step on there are which new values."""
        end = first + holds.size
        self._holds[first:end] = holds
        rest = self._holds[end:]
        end += int(rest.argmin()) if rest.size and not rest.all() else rest.size
        steps = np.arange(first, end)
        before = self._since[first - 1] if first and self._holds[first - 1] else first
        breaks = np.where(self._holds[first:end], before, steps + 1)
        self._since[first:end] = np.maximum.accumulate(breaks)
        return first, self._values(first, end, now)

    def begun(self, now: int) -> tuple[int, Floats] | None:
        """The same where a run begins just now: how late all is does not matter to it any more."""
        if now >= self._holds.size or not now or self._since[now] != now or not self._holds[now]:
            return None
        rest = self._holds[now:]
        end = now + (rest.size if rest.all() else int(rest.argmin()))
        return now, self._values(now, end, now)

    def _values(self, first: int, end: int, now: int) -> Floats:
        since = self._since[first:end]
        spare = np.where(since <= now, np.inf, np.arange(first, end) - since)
        return np.where(self._holds[first:end], spare, -np.inf)
