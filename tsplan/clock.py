"""Time limits and interruption, shared by all stages of one planning run."""

from __future__ import annotations

import time
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from dataclasses import dataclass, field

from tsplan.stopping import Halted, StoppedBy

__all__ = ["Clock", "Halted"]


@dataclass(frozen=True)
class Clock:
    """Seconds since the run began, when it has to stop, and what its phases have taken."""

    limit: float | None = None
    stop: Callable[[], bool] = lambda: False
    began: float = field(default_factory=time.perf_counter)
    spent: dict[str, float] = field(default_factory=dict, compare=False)

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
        return self.stopped_by is not None

    @property
    def stopped_by(self) -> StoppedBy | None:
        """What has ended the run, None while it goes on."""
        if self.stop():
            return StoppedBy.INTERRUPT
        late = self.limit is not None and self.elapsed >= self.limit
        return StoppedBy.TIME_LIMIT if late else None

    def check(self) -> None:
        """Raise Halted if the clock is over."""
        reason = self.stopped_by
        if reason is not None:
            raise Halted(reason)

    def within(self, seconds: float) -> Clock:
        """The same clock with at most `seconds` from now."""
        until = self.elapsed + seconds
        limit = until if self.limit is None else min(self.limit, until)
        return Clock(limit, self.stop, self.began, self.spent)

    @contextmanager
    def timed(self, phase: str) -> Iterator[None]:
        """Add the seconds that a block takes to those of a phase."""
        since = time.perf_counter()
        try:
            yield
        finally:
            self.spent[phase] = self.spent.get(phase, 0.0) + time.perf_counter() - since
