"""What ends a search before its question is settled."""

from __future__ import annotations

from enum import StrEnum


class StoppedBy(StrEnum):
    """What ended a search before its question was settled.

    PRECISION: the solver is done, and its arithmetic cannot tell whether there is something better.
    WINDOW: the mission was planned in pieces, of which nobody knows whether they go well together.
    """

    TIME_LIMIT = "time_limit"
    GAP = "gap"
    INTERRUPT = "interrupt"
    MEMORY = "memory"
    PRECISION = "precision"
    WINDOW = "window"


class Halted(Exception):  # noqa: N818 - nothing has gone wrong
    """The run ends before what was being made is ready; the words say why if it is not its time."""

    def __init__(self, reason: StoppedBy, words: str = "") -> None:
        super().__init__(words or reason.value)
        self.reason = reason
        self.words = words


LIMITS = frozenset(StoppedBy) - {StoppedBy.GAP}
"""What may keep a search from finding anything at all."""


def true_reason(
    said: StoppedBy | None, asked: float | None, limit: float | None
) -> StoppedBy | None:
    """What truly ended a search: a wish to stop is no time limit, nor the other way round.

    `said` is what the search calls the reason, `asked` the seconds after which it was asked to stop
    (None: never), `limit` its time limit in seconds.

    >>> true_reason(StoppedBy.TIME_LIMIT, 2.0, 5.0).value
    'interrupt'
    """
    if said not in (StoppedBy.INTERRUPT, StoppedBy.TIME_LIMIT):
        return said
    if limit is None:
        return said if asked is None else StoppedBy.INTERRUPT
    return StoppedBy.INTERRUPT if asked is not None and asked < limit else StoppedBy.TIME_LIMIT
