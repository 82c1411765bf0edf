"""`tsplan explain`: say why a mission cannot be met and what would help."""

from __future__ import annotations

import time
from dataclasses import replace
from typing import TYPE_CHECKING, Any, cast

from tsplan.cli.arguments import Exit
from tsplan.cli.inputs import mission_to_solve
from tsplan.cli.output import attempted, console, remark, say_json
from tsplan.cli.progress import Progress
from tsplan.document.files import write_whole
from tsplan.errors import Finding, InputError
from tsplan.explanation.explanation import Cut, Explanation, Found, Status
from tsplan.explanation.report import WIDTH, Report
from tsplan.process.child_process import ENDED, Leash, reason_of, run_guarded
from tsplan.process.interrupt import Requests
from tsplan.run.events import Bound, Stage

if TYPE_CHECKING:
    import argparse
    from collections.abc import Callable
    from pathlib import Path

    from tsplan.milp.solver_choice import SolverChoice
    from tsplan.signals.result_check import AnyMission
    from tsplan.stopping import StoppedBy


def run(options: argparse.Namespace) -> Exit:
    """Explain the mission; write a changed one where that is asked for."""
    if (options.fix is None) != (options.output is None):
        raise InputError([Finding("--fix and -o need each other", "say --fix N -o FILE")])
    mission, choice, _ = mission_to_solve(options, "the mission")
    requests, unwritten = Requests(quiet=options.quiet, what=b"what is known"), None
    report = None
    if not options.json:
        report = Report(mission, console(WIDTH), several=options.all)
    with requests.heard():
        with Progress(quiet=options.quiet) as progress:
            heard = _Heard(mission.name, report, progress)
            explanation = _explained(mission, choice, options, requests, heard)
        if options.fix is not None:
            unwritten = attempted(lambda: _write(mission, explanation, options))
    if report is None:
        say_json(explanation.to_json())
    else:
        report.finish(explanation)
    if unwritten is not None:
        raise unwritten
    return Exit.NO_PLAN if explanation.status is Status.NO_ANSWER else Exit.DONE


class _Heard:
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


def _explained(
    mission: AnyMission,
    choice: SolverChoice,
    options: argparse.Namespace,
    requests: Requests,
    heard: _Heard,
) -> Explanation:
    """The explanation, made in a child process: a crash of native code becomes a message.

    What the child has handed over is kept where it does not come to an end.
    """
    keywords = {
        "slack": options.slack,
        "time_limit": choice.time_limit,
        "solver": choice.name,
    }
    leash = Leash(choice.time_limit)
    try:
        with requests.passed_to(leash.ask):
            return run_guarded(_job, (mission, options.all, keywords), heard.hear, leash)
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


def _write(mission: AnyMission, explanation: Explanation, options: argparse.Namespace) -> None:
    """Write the mission after one of the changes, as a file that can be planned."""
    from tsplan.explanation.whynot.rewriting import rewritten  # noqa: PLC0415  (rarely needed)

    output: Path = options.output
    changed = {change.fix: change.mission for change in explanation.changes}
    if options.fix not in changed:
        known = f"there are {len(changed)}" if changed else "there is none"
        raise InputError([Finding(f"there is no change {options.fix}; {known}", "choose another")])
    written = rewritten(mission, changed[options.fix], options.mission.parent, output.parent)
    write_whole(output, written.text.encode())
    if written.comments_lost:
        remark(f"{output}: some comments of the mission could not be kept")
