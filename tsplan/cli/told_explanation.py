"""An explanation made in a child process, told as it comes."""

from __future__ import annotations

import time
from dataclasses import replace
from typing import TYPE_CHECKING, Any, cast

from tsplan.cli.output import remark
from tsplan.explanation.explanation import Cut, Explanation, Found, Status
from tsplan.process.child_process import ENDED, Leash, reason_of, run_guarded
from tsplan.run.events import Bound, Stage

if TYPE_CHECKING:
    from collections.abc import Callable

    from tsplan.cli.progress import Progress
    from tsplan.explanation.report import Report
    from tsplan.milp.solver_choice import SolverChoice
    from tsplan.process.interrupt import Requests
    from tsplan.signals.result_check import AnyMission
    from tsplan.stopping import StoppedBy


class Heard:
    """What the child has said so far: the stage it is in, and what it has found, told at once."""

    def __init__(self, name: str, report: Report | None, progress: Progress) -> None:
        self.known = Explanation(Status.NO_ANSWER, name)
        self.stage = "facts"
        self._report = report
        self._progress = progress
        self._began = time.monotonic()

    def hear(self, news: str | Found) -> None:
        """Take in what the child says: the stage it is in or goes on with, or what it has found."""
        if isinstance(news, Status) or not isinstance(news, str):
            self._progress.pause()
            self.known = self.known.with_found(news)
            if self._report is not None:
                self._report.tell(news)
            return
        elapsed = time.monotonic() - self._began
        same, self.stage = news == self.stage and elapsed > 0, news
        event = Bound(news, None, None, elapsed) if same else Stage(news, elapsed)
        self._progress.tell(event)

    def given_up(self, why: StoppedBy) -> Explanation:
        """What was known when the child had to be ended, or ended by itself, with the reason."""
        return replace(self.known, cut={**self.known.cut, self.stage: cast("Cut", why.value)})


def explained(
    mission: AnyMission,
    choice: SolverChoice,
    requests: Requests,
    heard: Heard,
    *,
    every: bool = False,
    slack: bool = False,
    certified: bool = False,
) -> Explanation:
    """The explanation, made in a child process: a crash of native code becomes a message.

    What the child has handed over is kept where it does not come to an end.
    """
    keywords = {"slack": slack, "time_limit": choice.time_limit, "solver": choice.name}
    keywords |= {"certified": certified}
    leash = Leash(choice.time_limit)
    try:
        with requests.passed_to(leash.ask):
            return run_guarded(_job, (mission, every, keywords), heard.hear, leash)
    except ENDED as error:
        words = "it was interrupted" if isinstance(error, KeyboardInterrupt) else str(error)
        remark(f"{words}; this is what was known")
        return heard.given_up(reason_of(error, asked=requests.asked > 0))


def _job(
    given: tuple[AnyMission, bool, dict[str, Any]], send: Callable[[str | Found], object]
) -> Explanation:
    """The child's part."""
    from tsplan.explanation.whynot.diagnosis import MOST_CONFLICTS, explain  # noqa: PLC0415  (slow)

    mission, every, keywords = given
    most = MOST_CONFLICTS if every else 1
    return explain(mission, conflicts=most, **keywords, on_stage=send, on_found=send)
