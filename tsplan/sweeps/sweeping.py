"""Running a sweep: what is not done yet is done, wherever that is, and recorded at once."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping, Sequence
from concurrent.futures import CancelledError, Executor, Future
from contextlib import contextmanager
from dataclasses import dataclass, field
from pathlib import Path
from queue import Empty, SimpleQueue
from typing import Any

from tsplan.document.files import write_whole
from tsplan.errors import SolverError
from tsplan.process.child_process import CrashError
from tsplan.process.interrupt import Requests
from tsplan.stopping import StoppedBy
from tsplan.sweeps.journal import Journal
from tsplan.sweeps.run_answer import Answer, answer_of, failure
from tsplan.sweeps.sweep_rows import SweepResults, SweepRow
from tsplan.sweeps.sweep_runs import SweepRun
from tsplan.sweeps.worker_pool import WorkerPool

_POLL = 0.2  # seconds until it is asked again whether to stop
_STOPPING = b"what is done"

Listener = Callable[[SweepRow], object]


@dataclass(eq=False)
class Sweeping:
    """A sweep while it runs, and its rows by the ids of their runs.

    `table` is the CSV to write, beside which the journal stands; `plans` the folder of plans.
    """

    runs: Sequence[SweepRun]
    table: Path | None = None
    plans: Path | None = None
    listener: Listener | None = None
    quiet: bool = True
    rows: dict[str, SweepRow] = field(default_factory=dict)
    cancelled: int = 0

    @property
    def results(self) -> SweepResults:
        """What is recorded so far, in the order of the runs."""
        return SweepResults(self.rows[run.id] for run in self.runs if run.id in self.rows)

    @property
    def open(self) -> list[SweepRun]:
        """The runs that are not recorded."""
        return [run for run in self.runs if run.id not in self.rows]

    @property
    def journal(self) -> Journal | None:
        """Where each row is written at once, if anywhere."""
        return None if self.table is None else Journal.beside(self.table)

    def resume(self, *, fresh: bool = False, retry: bool = False) -> None:
        """Take in what is recorded, and be ready to record more.

        `fresh` forgets what is recorded, `retry` the runs that have failed.
        """
        if self.journal is None:
            return
        self.journal.begin(fresh=fresh)
        self.rows = {
            name: row
            for name, row in self.journal.rows(self.runs).items()
            if not (retry and row.failed)
        }

    def work(self, executor: Executor | None = None, workers: int = 1) -> SweepResults:
        """Do the runs that are open, in an executor or in so many processes.

        Ctrl-C ends it in good order and is raised once the table is written. Raises InputError
        where something cannot be written, and SolverError if an executor has dropped runs.
        """
        requests = Requests(quiet=self.quiet, what=_STOPPING)
        try:
            with requests.heard(), _working(executor, workers, requests) as (pool, width):
                self._all(pool, width, requests)
        finally:
            self.write()
        if requests.asked:
            raise KeyboardInterrupt
        if self.cancelled:
            what = f"{self.cancelled} runs were cancelled by the executor; sweep again to do them"
            raise SolverError(what)
        return self.results

    def write(self) -> None:
        """Write the table of all that is recorded."""
        if self.table is not None:
            self.results.to_csv(self.table)

    def _all(self, pool: Executor, width: int | None, requests: Requests) -> None:
        """Give out runs, at most `width` at a time, and record what comes back."""
        waiting = iter(self.open)
        done: SimpleQueue[Future[Answer]] = SimpleQueue()
        given: dict[Future[Answer], SweepRun] = {}
        try:
            while True:
                while not requests.asked and (width is None or len(given) < width):
                    run = next(waiting, None)
                    if run is None:
                        break
                    future = _submitted(pool, run, keep=self.plans is not None)
                    given[future] = run
                    future.add_done_callback(done.put)
                if not given:
                    return
                try:
                    future = done.get(timeout=_POLL)
                except Empty:
                    if requests.asked:
                        return
                    continue
                self._record(given.pop(future), future, requests)
        finally:
            for future in given:
                future.cancel()

    def _record(self, run: SweepRun, future: Future[Answer], requests: Requests) -> None:
        """Record what became of a run, unless it was interrupted."""
        try:
            answer = future.result()
        except CancelledError:
            self.cancelled += 1
            return
        except Exception as error:  # noqa: BLE001  (whatever an executor raises)
            words = f"the worker of this run was lost: {str(error) or type(error).__name__}"
            answer = failure(run, CrashError(words))
        row = answer.row
        if row.get("stopped_by") == StoppedBy.INTERRUPT:
            requests.asked = max(requests.asked, 1)
            return
        self._keep(run, answer)
        if self.journal is not None:
            self.journal.append(row)
        self.rows[run.id] = row
        if self.listener is not None:
            self.listener(row)

    def _keep(self, run: SweepRun, answer: Answer) -> None:
        """Write the plan of a run, and its mission, into their folder."""
        texts: Mapping[str, str | None] = {
            f"{run.id}.json": answer.plan,
            f"{run.id}.mission.yaml": answer.mission,
        }
        for name, text in texts.items():
            if self.plans is not None and text is not None:
                write_whole(self.plans / name, text.encode())


def _submitted(pool: Executor, run: SweepRun, *, keep: bool) -> Future[Answer]:
    """The future of a run, also of one that a broken executor does not take."""
    try:
        return pool.submit(answer_of, run, keep)
    except RuntimeError as error:  # as BrokenExecutor, and after a shutdown
        future: Future[Answer] = Future()
        future.set_exception(error)
        return future


@dataclass(eq=False)
class _InTurn(Executor):
    """Does each job right when it is given, and lets it hear of signals."""

    requests: Requests

    def submit(self, job: Callable[..., Any], /, *given: Any, **named: Any) -> Future[Any]:
        """Do a job; its future is done then."""
        future: Future[Any] = Future()
        try:
            future.set_result(job(*given, **named, requests=self.requests))
        except Exception as error:  # noqa: BLE001  (raised by the future)
            future.set_exception(error)
        return future


@contextmanager
def _working(
    executor: Executor | None, workers: int, requests: Requests
) -> Iterator[tuple[Executor, int | None]]:
    """Who does the work, and how much is given out at a time (None: all of it)."""
    if executor is not None:
        yield executor, None
        return
    if workers == 1:
        yield _InTurn(requests), 1
        return
    pool = WorkerPool(workers)
    finished = False
    try:
        yield pool, workers
        finished = not requests.asked
    finally:
        pool.shutdown(cancel_futures=not finished)
