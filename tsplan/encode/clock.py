"""Time limits and interruption, shared by all stages of one planning run."""

from __future__ import annotations

import time
from collections.abc import Callable
from dataclasses import dataclass, field


@dataclass(frozen=True)
class Clock:
    """Seconds since the run began, and when it has to stop."""

    limit: float | None = None
    stop: Callable[[], bool] = lambda: False
    began: float = field(default_factory=time.perf_counter)

    @property
    def elapsed(self) -> float:
        """Seconds since the clock was made."""
        return time.perf_counter() - self.began

    @property
    def left(self) -> float | None:
        """Seconds that remain; None without a limit."""
        return None if self.limit is None else max(self.limit - self.elapsed, 0.0)

    @property
    def over(self) -> bool:
        """Whether the time is up or the run was asked to stop."""
        return self.stop() or (self.limit is not None and self.elapsed >= self.limit)

    def within(self, seconds: float) -> Clock:
        """The same clock with at most `seconds` from now."""
        until = self.elapsed + seconds
        limit = until if self.limit is None else min(self.limit, until)
        return Clock(limit, self.stop, self.began)
