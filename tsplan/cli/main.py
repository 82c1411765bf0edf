"""Runs one command, and turns whatever goes wrong into one line each and an exit code."""

from __future__ import annotations

from contextlib import suppress
from importlib import import_module
from typing import TYPE_CHECKING

from tsplan.cli.arguments import Exit, parser
from tsplan.process.interrupt import TimeUpError

if TYPE_CHECKING:
    from collections.abc import Sequence


def main(arguments: Sequence[str] | None = None) -> int:
    """Run the command line and return its exit code; never a traceback for bad input."""
    from tsplan.cli import output  # noqa: PLC0415  (after the arguments)

    output.fill_closed()
    try:
        try:
            options = parser().parse_args(arguments)
        except SystemExit as stop:  # argparse has said what is wrong
            code = Exit(int(stop.code or 0))
        else:
            command = import_module(f"tsplan.cli.{options.command}_command")
            code = command.run(options)
        output.OUT.flush()
    except (Exception, KeyboardInterrupt, TimeUpError) as error:  # noqa: BLE001  (no traceback)
        code, lines = _answer(error)
        for line in lines:
            output.remark(line)
        with suppress(output.OutputError):
            output.OUT.flush()
    output.ERR.flush()
    return int(code)


def _answer(error: BaseException) -> tuple[Exit, list[str]]:
    """The exit code and the lines that say what went wrong."""
    from tsplan.cli.output import OutputError  # noqa: PLC0415  (after the help)
    from tsplan.errors import InputError, TsplanError, told  # noqa: PLC0415  (after the help)

    if isinstance(error, InputError):
        return Exit.BAD_INPUT, [" ".join(line.splitlines()) for line in told(error.findings)]
    known: tuple[tuple[type[BaseException], Exit, str], ...] = (
        (TsplanError, Exit.FAILED, str(error)),
        (KeyboardInterrupt, Exit.INTERRUPTED, "interrupted"),
        (TimeUpError, Exit.NO_PLAN, str(error)),
        (OutputError, Exit.UNSHOWN, str(error)),
        (MemoryError, Exit.FAILED, "there is not enough memory for this; try a smaller input"),
    )
    for kind, code, words in known:
        if isinstance(error, kind):
            return code, words.splitlines()
    return Exit.FAILED, [internal(error)]


def internal(error: BaseException) -> str:
    """One line on an error of the program itself, with the place where it happened."""
    trace = error.__traceback__
    while trace is not None and trace.tb_next is not None:
        trace = trace.tb_next
    where = ""
    if trace is not None:
        name = trace.tb_frame.f_globals.get("__name__", "?")
        where = f" in {name}:{trace.tb_lineno}"
    text = " ".join(str(error).split()) or "no message"
    return (
        f"internal error{where}: {type(error).__name__}: {text}; this is a mistake in tsplan, "
        "please report it with this line and the input"
    )
