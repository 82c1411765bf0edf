"""`tsplan explain`: say why a mission cannot be met and what would help."""

from __future__ import annotations

from dataclasses import dataclass, replace
from typing import TYPE_CHECKING

from tsplan.cli.arguments import Exit
from tsplan.cli.inputs import mission_to_solve
from tsplan.cli.output import ERR, console, remark, say_json
from tsplan.cli.time_limit import rest
from tsplan.document.files import write_whole
from tsplan.errors import Finding, InputError
from tsplan.explanation.explanation import Cut, Explanation, Status
from tsplan.explanation.report import print_explanation
from tsplan.milp.child_process import LateError, OutOfMemoryError, run_guarded
from tsplan.milp.grace_period import Leash, Patience
from tsplan.run.isolate import Requests

if TYPE_CHECKING:
    import argparse
    from collections.abc import Callable
    from pathlib import Path

    from tsplan.mission import Mission

_PIPE_WIDTH = 100  # columns where there is no terminal to ask


def run(asked: argparse.Namespace) -> Exit:
    """Explain the mission; write a changed one where that is asked for."""
    if (asked.fix is None) != (asked.output is None):
        raise InputError([Finding("--fix and -o need each other", "say --fix N -o FILE")])
    mission, loaded = mission_to_solve(asked, "the mission")
    requests = Requests(what=b"what is known")
    with requests.heard():
        found = _explained(mission, asked, loaded, requests)
        unwritten = _written(mission, found, asked)
    if asked.json:
        say_json(found.to_json())
    else:
        print_explanation(found, mission, console(_PIPE_WIDTH))
    if unwritten is not None:
        raise unwritten
    return Exit.NO_PLAN if found.status is Status.NO_ANSWER else Exit.DONE


@dataclass(frozen=True, slots=True)
class _Order:
    """What the child process is to do."""

    mission: Mission
    conflicts: int
    slack: bool
    time_limit: float | None
    solver: str | None


@dataclass(eq=False, slots=True)
class _Heard:
    """What the child has said so far: the stage it is in, and what it knows."""

    stage: str
    known: Explanation

    def hear(self, news: str | Explanation) -> None:
        """Take in what the child says."""
        if isinstance(news, Explanation):
            self.known = news
            return
        self.stage = news
        if ERR.isatty():
            remark(f"{news} ...")

    def given_up(self, error: BaseException, *, asked: bool) -> Explanation:
        """What was known when the child had to be ended, or ended by itself, with the reason."""
        why: Cut = "interrupt"
        if isinstance(error, OutOfMemoryError):
            why = "memory"
        elif isinstance(error, LateError) and not asked:
            why = "time_limit"
        return replace(self.known, cut={**self.known.cut, self.stage: why})


def _explained(
    mission: Mission, asked: argparse.Namespace, loaded: float, requests: Requests
) -> Explanation:
    """The explanation, made in a child process: a crash of native code becomes a message.

    What the child has handed over is kept where it does not come to an end.
    """
    from tsplan.explanation.whynot.explaining import MOST_CONFLICTS  # noqa: PLC0415  (loads a solver)

    most = MOST_CONFLICTS if asked.all else 1
    limit = mission.solver.time_limit if asked.time_limit is None else asked.time_limit
    limit = rest(limit, loaded)  # reading the mission was a part of the work
    order = _Order(mission, most, asked.slack, limit, asked.solver)

    heard = _Heard("facts", Explanation(Status.NO_ANSWER, mission.name))
    leash = Leash(Patience(limit))
    try:
        with requests.passed_to(leash):
            return run_guarded(_job, order, heard.hear, leash)
    except (LateError, OutOfMemoryError, KeyboardInterrupt) as error:
        words = "it was interrupted" if isinstance(error, KeyboardInterrupt) else str(error)
        remark(f"{words}; this is what was known")
        return heard.given_up(error, asked=requests.asked > 0)


def _job(order: _Order, send: Callable[[str | Explanation], object]) -> Explanation:
    """The child's part."""
    from tsplan.explanation.whynot.explaining import explain  # noqa: PLC0415  (loads a solver)

    return explain(
        order.mission,
        conflicts=order.conflicts,
        slack=order.slack,
        time_limit=order.time_limit,
        solver=order.solver,
        on_stage=send,
        on_found=send,
    )


def _written(mission: Mission, found: Explanation, asked: argparse.Namespace) -> InputError | None:
    """Write the changed mission before anything is printed; what keeps it unwritten comes last."""
    if asked.fix is not None:
        try:
            _write(mission, found, asked)
        except InputError as error:
            return error
    return None


def _write(mission: Mission, found: Explanation, asked: argparse.Namespace) -> None:
    """Write the mission after one of the changes, as a file that can be planned."""
    from tsplan.explanation.whynot.rewriting import rewritten  # noqa: PLC0415  (rarely needed)

    output: Path = asked.output
    if not 1 <= asked.fix <= len(found.changes):
        known = f"there are {len(found.changes)}" if found.changes else "there is none"
        raise InputError([Finding(f"there is no change {asked.fix}; {known}", "choose another")])
    changed = found.changes[asked.fix - 1].mission
    written = rewritten(mission, changed, asked.mission.parent, output.parent)
    write_whole(output, written.text.encode())
    if written.comments_lost:
        remark(f"{output}: some comments of the mission could not be kept")
