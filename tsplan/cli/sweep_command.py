"""`tsplan sweep`: run many missions, keep a table of their results, and show it."""

from __future__ import annotations

from contextlib import nullcontext
from functools import partial
from pathlib import Path
from typing import TYPE_CHECKING

from tsplan.cli.arguments import Exit
from tsplan.cli.inputs import refuse_place, refuse_solver
from tsplan.cli.output import attempted, console, remark, say_json
from tsplan.cli.sweep_progress import SweepProgress
from tsplan.draw.matplotlib_loading import library
from tsplan.draw.picture_files import kind_of, save_picture
from tsplan.errors import Finding, InputError
from tsplan.milp.solver_choice import SolverChoice
from tsplan.plans.summary import print_parts
from tsplan.sweeps.cluster import dask_cluster
from tsplan.sweeps.journal import Journal
from tsplan.sweeps.sweep_chart import draw_sweep
from tsplan.sweeps.sweep_summary import counts_line, sweep_json, sweep_parts
from tsplan.sweeps.sweeper import runs_of
from tsplan.sweeps.sweeping import Sweeping

if TYPE_CHECKING:
    import argparse
    from concurrent.futures import Executor
    from contextlib import AbstractContextManager

_PIPE_WIDTH = 120  # columns where there is no terminal to ask


def run(options: argparse.Namespace) -> Exit:
    """Run what is not recorded yet, write the table, and show it."""
    if options.output is None:
        options.output = Path(f"{options.file.resolve().stem}.csv")
    runs = runs_of(options.file)
    _refuse_places(options)
    if options.solver is not None:
        refuse_solver(options.solver)
    choice = SolverChoice(options.solver, options.time_limit, options.gap, options.threads)
    chosen = tuple(run.chosen(choice) for run in runs)
    sweeping = Sweeping(chosen, options.output, options.plans, quiet=options.quiet)
    sweeping.resume(fresh=options.fresh, retry=options.retry)
    code = _worked(sweeping, options)
    unwritten = attempted(partial(_plot, sweeping, options))
    _show(sweeping, options)
    if unwritten is not None:
        raise unwritten
    return code


def _refuse_places(options: argparse.Namespace) -> None:
    """Say at once what could not be written, not after hours of runs."""
    inputs = [options.file]
    refuse_place(options.output, "the results", inputs)
    refuse_place(Journal.beside(options.output).path, "the journal", inputs)
    if options.plot is not None:
        kind_of(options.plot)
        library("figure")
        refuse_place(options.plot, "the plot", [*inputs, options.output])
    if options.plans is not None:
        try:
            options.plans.mkdir(exist_ok=True)
        except OSError as error:
            what = f"plans cannot be kept: {error.strerror}"
            raise InputError([Finding(what, "name a folder", str(options.plans))]) from None


def _worked(sweeping: Sweeping, options: argparse.Namespace) -> Exit:
    """Do the work; what is recorded when it is interrupted stays."""
    total, done = len(sweeping.runs), len(sweeping.rows)
    if done and not options.quiet:
        remark(
            f"{done} of {total} runs are recorded already in {Journal.beside(options.output).path}"
        )
    with SweepProgress(total, done, quiet=options.quiet) as progress:
        sweeping.listener = progress.tell
        try:
            if sweeping.open:
                with _executor(options) as executor:
                    sweeping.work(executor, options.jobs)
            else:
                sweeping.write()
        except KeyboardInterrupt:
            code = Exit.INTERRUPTED
        else:
            code = Exit.DONE
    if code is Exit.INTERRUPTED:
        remark(f"interrupted; {counts_line(sweeping.results, total)}; sweep again to go on")
    return code


def _executor(options: argparse.Namespace) -> AbstractContextManager[Executor | None]:
    if options.dask is None:
        return nullcontext()
    return dask_cluster(options.dask, options.jobs)


def _plot(sweeping: Sweeping, options: argparse.Namespace) -> None:
    if options.plot is not None and sweeping.rows:
        save_picture(draw_sweep(sweeping.results)[0], options.plot, tell=remark)


def _show(sweeping: Sweeping, options: argparse.Namespace) -> None:
    results, total = sweeping.results, len(sweeping.runs)
    files = {"csv": str(options.output), "journal": str(Journal.beside(options.output).path)}
    if options.json:
        say_json(sweep_json(results, total, files))
    elif not options.quiet:
        parts = [*sweep_parts(results, total), f"results in {options.output}"]
        print_parts(parts, console(_PIPE_WIDTH))
