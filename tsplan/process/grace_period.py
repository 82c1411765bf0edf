"""How long work may take to end once it was asked to: every such wait of the program."""

from __future__ import annotations

from dataclasses import dataclass

from tsplan.stopping import StoppedBy


@dataclass(frozen=True, slots=True)
class GracePeriod:
    """Seconds that work gets to end, by what it has to end for; `poll` is between looks.

    `finishing` takes their place once the work only makes its answer ready; `settling` is to end
    after the answer.
    """

    time_limit: float
    interrupt: float
    finishing: float = 0.0
    settling: float = 0.0
    poll: float = 0.05

    def after(self, why: StoppedBy) -> float:
        """Seconds from when the work was asked to end until it is given up."""
        return self.time_limit if why is StoppedBy.TIME_LIMIT else self.interrupt


CHILD = GracePeriod(time_limit=5.0, interrupt=5.0, finishing=25.0, settling=1.0)
"""Of a child process."""

NATIVE = GracePeriod(time_limit=0.2, interrupt=1.0)
"""Of native code in a thread."""

COMMAND = GracePeriod(time_limit=1.0, interrupt=3.0)
"""Of a solver that runs as a command and has to write its point to a file."""
