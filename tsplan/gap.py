"""The one measure of how far a value may be from the best."""

from __future__ import annotations

_LEAST = 1e-9
"""An objective nearer to 0 is taken as this, so that the gap stays a finite number."""


def relative_gap(objective: float | None, bound: float | None) -> float | None:
    """`|objective - bound| / |objective|`, None while one of them is unknown.

    >>> relative_gap(50.0, 45.0)
    0.1
    """
    if objective is None or bound is None:
        return None
    distance = abs(objective - bound)
    return 0.0 if distance == 0 else distance / max(abs(objective), _LEAST)


class Gapped:
    """What has an objective and a bound on the best one, None while not known."""

    __slots__ = ()

    objective: float | None
    bound: float | None

    @property
    def gap(self) -> float | None:
        """How far the objective may be from the best, relative to it; None while not known."""
        return relative_gap(self.objective, self.bound)
