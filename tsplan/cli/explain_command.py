"""`tsplan explain`: say why a mission cannot be met and what would help."""

from __future__ import annotations

from typing import TYPE_CHECKING

from tsplan.cli.arguments import Exit
from tsplan.cli.inputs import mission_to_solve
from tsplan.cli.output import attempted, console, remark, say_json
from tsplan.cli.progress import Progress
from tsplan.cli.told_explanation import Heard, explained
from tsplan.document.files import write_whole
from tsplan.errors import Finding, InputError
from tsplan.explanation.explanation import Explanation, Status
from tsplan.explanation.report import WIDTH, Report
from tsplan.process.interrupt import Requests

if TYPE_CHECKING:
    import argparse
    from pathlib import Path

    from tsplan.signals.result_check import AnyMission


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
            heard = Heard(mission.name, report, progress)
            how = {"every": options.all, "slack": options.slack, "certified": options.certified}
            explanation = explained(mission, choice, requests, heard, **how)
        if options.fix is not None:
            unwritten = attempted(lambda: _write(mission, explanation, options))
    if report is None:
        say_json(explanation.to_json())
    else:
        report.finish(explanation)
    if unwritten is not None:
        raise unwritten
    return Exit.NO_PLAN if explanation.status is Status.NO_ANSWER else Exit.DONE


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
