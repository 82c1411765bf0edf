"""`tsplan explain`: say why a mission cannot be met and what would help."""

from __future__ import annotations

import sys
from dataclasses import dataclass
from typing import TYPE_CHECKING

from tsplan.cli.arguments import Exit
from tsplan.cli.inputs import mission_of, refuse_place, refuse_solver
from tsplan.errors import Finding, InputError
from tsplan.explanation.data import Explanation, Status

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
    refuse_place(asked.output, "the mission")
    mission = mission_of(asked.mission)
    refuse_solver(asked.solver or mission.solver.name or "highs")
    found = _explained(mission, asked)
    if asked.json:
        sys.stdout.write(found.to_json())
    else:
        _print(found, mission)
    if asked.fix is not None:
        _write(mission, found, asked)
    return Exit.NO_PLAN if found.status is Status.NO_ANSWER else Exit.DONE


@dataclass(frozen=True, slots=True)
class _Order:
    """What the child process is to do."""

    mission: Mission
    conflicts: int
    slack: bool
    time_limit: float | None
    solver: str | None


def _explained(mission: Mission, asked: argparse.Namespace) -> Explanation:
    """The explanation, made in a child process: a crash of native code becomes a message."""
    from tsplan.explanation.explaining import MOST_CONFLICTS  # noqa: PLC0415  (loads a solver)
    from tsplan.milp.guard import run_guarded  # noqa: PLC0415

    most = MOST_CONFLICTS if asked.all else 1
    order = _Order(mission, most, asked.slack, asked.time_limit, asked.solver)

    def tell(stage: object) -> None:
        if sys.stderr.isatty():
            sys.stderr.write(f"{stage} ...\n")

    return run_guarded(_job, order, tell)


def _job(order: _Order, send: Callable[[str], None]) -> Explanation:
    """The child's part."""
    from tsplan.explanation.explaining import explain  # noqa: PLC0415  (loads a solver)

    return explain(
        order.mission,
        conflicts=order.conflicts,
        slack=order.slack,
        time_limit=order.time_limit,
        solver=order.solver,
        on_stage=send,
    )


def _print(found: Explanation, mission: Mission) -> None:
    from rich.console import Console  # noqa: PLC0415  (slow to import)

    from tsplan.explanation.report import print_explanation  # noqa: PLC0415

    console = Console()
    wide = console if console.is_terminal else Console(width=_PIPE_WIDTH)
    print_explanation(found, mission, wide)


def _write(mission: Mission, found: Explanation, asked: argparse.Namespace) -> None:
    """Write the mission after one of the changes, as a file that can be planned."""
    from tsplan.explanation.rewriting import rewritten  # noqa: PLC0415  (rarely needed)

    output: Path = asked.output
    if not 1 <= asked.fix <= len(found.changes):
        known = f"there are {len(found.changes)}" if found.changes else "there is none"
        raise InputError([Finding(f"there is no change {asked.fix}; {known}", "choose another")])
    changed = found.changes[asked.fix - 1].mission
    written = rewritten(mission, changed, asked.mission.parent, output.parent)
    output.write_text(written.text, encoding="utf-8")
    if written.comments_lost:
        sys.stderr.write(f"{output}: some comments of the mission could not be kept\n")
