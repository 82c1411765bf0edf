"""HiGHS, the default solver.

Every solve runs in a fresh thread. HiGHS keeps its workers per calling thread and refuses another
number of them there, so a fresh thread is also what lets `threads` differ from solve to solve.
"""

from __future__ import annotations

import time
from dataclasses import dataclass, field
from typing import Any

import numpy as np

from tsplan.errors import SolverError, nearest
from tsplan.milp.model import Floats, Model
from tsplan.milp.quiet_output import Hear, hushed
from tsplan.milp.solution import Options, Progress, Solution, Watcher, settled
from tsplan.milp.solver import Availability
from tsplan.milp.verdict import Ending, Question, Verdict
from tsplan.milp.watchdog import Attendant
from tsplan.stopping import StoppedBy

with hushed():
    import highspy
    from highspy import HighsModelStatus as Ended

_LEAST_GAP = 1e-6
_UNCLEAR = (Ended.kUnboundedOrInfeasible, Ended.kUnbounded)
_REASONS = {
    Ended.kTimeLimit: StoppedBy.TIME_LIMIT,
    Ended.kInterrupt: StoppedBy.INTERRUPT,
    Ended.kMemoryLimit: StoppedBy.MEMORY,
}
_VERDICTS = {
    Ended.kOptimal: Verdict.SOLVED,
    Ended.kModelEmpty: Verdict.SOLVED,
    Ended.kInfeasible: Verdict.REFUTED,
    Ended.kObjectiveBound: Verdict.REFUTED,
    Ended.kSolutionLimit: Verdict.ENDED,
    **dict.fromkeys(_REASONS, Verdict.ENDED),
}


def silent(log: Hear | None = None) -> highspy.Highs:
    """An empty HiGHS object that writes nothing; what it writes all the same goes to `log`."""
    with hushed(log):
        highs = highspy.Highs()
        checked(highs.setOptionValue("output_flag", False), "output_flag")
    return highs


def load(model: Model, *, relaxed: bool = False, log: Hear | None = None) -> highspy.Highs:
    """A silent HiGHS object that holds the model (its LP relaxation if `relaxed`)."""
    highs = silent(log)
    rows, columns = model.matrix.shape
    whole = np.zeros(columns, np.int32) if relaxed else model.integer.astype(np.int32)
    status = highs.passModel(
        columns,
        rows,
        model.matrix.nnz,
        int(highspy.MatrixFormat.kRowwise),
        int(highspy.ObjSense.kMinimize),
        float(model.offset),
        np.ascontiguousarray(model.objective, dtype=np.float64),
        np.ascontiguousarray(model.lower, dtype=np.float64),
        np.ascontiguousarray(model.upper, dtype=np.float64),
        np.ascontiguousarray(model.row_lower, dtype=np.float64),
        np.ascontiguousarray(model.row_upper, dtype=np.float64),
        model.matrix.indptr.astype(np.int32),
        model.matrix.indices.astype(np.int32),
        np.ascontiguousarray(model.matrix.data, dtype=np.float64),
        whole,
    )
    checked(status, "the model")
    return highs


def checked(status: highspy.HighsStatus, what: str) -> None:
    """Raise SolverError where HiGHS reports an error by return code only."""
    if status == highspy.HighsStatus.kError:
        raise SolverError(f"HiGHS refused {what}")


class Highs:
    """Solves models with HiGHS."""

    name = "highs"
    features = frozenset(
        {
            *("start", "progress", "incumbents", "first", "log"),
            *("seed", "threads", "gap", "cutoff", "presolve"),
        }
    )

    def availability(self) -> Availability:
        """HiGHS comes with tsplan."""
        return Availability(installed=True, usable=True, version=silent().version())

    def native(self, model: Model) -> highspy.Highs:
        """The model as a `highspy.Highs`."""
        return load(model)

    def solve(
        self, model: Model, options: Options | None = None, watch: Watcher | None = None
    ) -> Solution:
        """Minimise the model; see `tsplan.milp.solver.Solver`."""
        began = time.perf_counter()
        options = options or Options()
        known = settled(model)
        if known is not None:
            return known
        question = Question(model, options)
        said = _Solve(question, watch, began).ending()
        return question.answer(said, time.perf_counter() - began)


@dataclass(eq=False)
class _Solve:
    """One solve, from the loaded model to what HiGHS says at its end."""

    question: Question
    watch: Watcher | None
    began: float
    _best: Floats | None = field(default=None, init=False)
    _progress: Progress = field(default=Progress(None, None, 0.0), init=False)
    _why: StoppedBy | None = field(default=None, init=False)

    @property
    def _deadline(self) -> float | None:
        limit = self.question.options.time_limit
        return None if limit is None else self.began + max(limit, 0.0)

    def ending(self) -> Ending:
        model, options = self.question.model, self.question.options
        # HiGHS counts points above its bound as found, so a first point needs a row
        strict = options.first and options.cutoff is not None
        highs = load(self.question.cut() if strict else model, log=options.log)
        _configure(highs, options)
        said = self._run(highs)
        if said is not None and highs.getModelStatus() in _UNCLEAR:
            return self._clear(highs)
        return said or self._left()

    def _clear(self, highs: highspy.Highs) -> Ending:
        """Tell infeasible and unbounded apart: presolve cannot, and branching may not."""
        set_option(highs, "presolve", "off")
        said = self._run(highs)
        if said is None or highs.getModelStatus() not in _UNCLEAR:
            return said or self._left()
        size = self.question.model.size.columns
        every = np.arange(size, dtype=np.int32)
        checked(highs.changeColsCost(size, every, np.zeros(size)), "a zero objective")
        set_option(highs, "objective_bound", highspy.kHighsInf)
        said = self._run(highs)
        if said is not None and said.values is not None:
            raise SolverError("the model is unbounded: its objective can fall without end")
        return said or self._left()

    def _run(self, highs: highspy.Highs) -> Ending | None:
        """Run HiGHS; None if it did not come to an end of its own."""
        options = self.question.options
        attendant = Attendant(self._deadline, self._hear, options.stop or (lambda: False))
        _subscribe(highs, attendant, options)
        if self._deadline is not None:
            # HiGHS counts the seconds of all its runs together
            left = max(self._deadline - time.perf_counter(), 0.0)
            set_option(highs, "time_limit", highs.getRunTime() + left)
        outcome: list[highspy.HighsStatus] = []
        try:
            if not attendant.run(lambda: outcome.append(highs.run())):
                self._why = attendant.stopped_by
                return None
        except MemoryError:
            self._why = StoppedBy.MEMORY
            return None
        except RuntimeError as error:
            raise SolverError(f"HiGHS failed: {error}") from error
        highs.clearCallbacks()
        ended = highs.getModelStatus()
        if outcome[0] == highspy.HighsStatus.kError:
            raise SolverError(f"HiGHS ended with an error: {highs.modelStatusToString(ended)}")
        return self._said(highs, ended, attendant.stopped_by)

    def _said(self, highs: highspy.Highs, ended: Ended, stopped_by: StoppedBy | None) -> Ending:
        if ended in _UNCLEAR:
            return Ending(Verdict.ENDED)
        if ended not in _VERDICTS:
            words = highs.modelStatusToString(ended)
            raise SolverError(f"HiGHS could not solve the model: {words}")
        info = highs.getInfo()
        feasible = int(highspy.SolutionStatus.kSolutionStatusFeasible)
        whole = bool(self.question.model.integer.any())
        values = None
        if info.primal_solution_status == feasible:
            values = np.array(highs.getSolution().col_value)
        return Ending(
            _VERDICTS[ended],
            values,
            finite(info.mip_dual_bound) if whole else None,
            # the watchdog's interrupt is the time limit's
            stopped_by or _REASONS.get(ended),
            max(int(info.mip_node_count), 0),
        )

    def _left(self) -> Ending:
        """What is known of a solve that did not come to an end of its own."""
        return Ending(Verdict.ENDED, self._best, self._progress.bound, self._why)

    def _hear(self, news: Any) -> bool:
        """Pass progress and log lines on, in the calling thread."""
        if isinstance(news, str):
            for line in news.splitlines():
                if self.question.options.log is not None:
                    self.question.options.log(line)
            return False
        objective, bound, values = news
        point = None if values is None else self.question.whole(values)
        if point is not None and self.question.wanted(self.question.objective(point)):
            self._best = point
        else:
            point = None
        self._progress = Progress(
            objective if objective is not None and self.question.wanted(objective) else None,
            self.question.true_bound(bound),
            time.perf_counter() - self.began,
            point,
        )
        return self.watch is not None and self.watch(self._progress)


def set_option(highs: highspy.Highs, name: str, value: object) -> None:
    """Set one option; SolverError names the nearest option where HiGHS knows none of the name."""
    if highs.getOptionType(name)[0] == highspy.HighsStatus.kError:
        raise SolverError(f"HiGHS has no option '{name}'; {nearest(name, option_names())}")
    try:
        checked(highs.setOptionValue(name, value), f"option {name} = {value}")
    except TypeError:
        raise SolverError(f"HiGHS refused option {name} = {value!r}") from None


def option_names() -> list[str]:
    """HiGHS' own names of its options."""
    return [word for word in dir(highspy.HighsOptions()) if not word.startswith("_")]


def finite(value: float) -> float | None:
    """The number, or None for what HiGHS takes as infinite."""
    return float(value) if abs(value) < highspy.kHighsInf else None


def _configure(highs: highspy.Highs, options: Options) -> None:
    asked = {
        "mip_rel_gap": float(options.gap),
        "mip_abs_gap": max(float(options.absolute_gap), _LEAST_GAP),
        "random_seed": options.seed,
        "mip_max_improving_sols": 1 if options.first else None,
        "objective_bound": options.cutoff,
        "threads": options.threads,
        "log_to_console": False,
        "output_flag": options.log is not None,
        "presolve": None if options.presolve else "off",
        **options.extra,
    }
    for name, value in asked.items():
        if value is not None:
            set_option(highs, name, value)
    if options.start is not None:
        point = highspy.HighsSolution()
        point.col_value = np.asarray(options.start, dtype=np.float64).tolist()
        checked(highs.setSolution(point), "the start")


def _subscribe(highs: highspy.Highs, attendant: Attendant, options: Options) -> None:
    def interrupt(event: Any) -> None:
        if attendant.stopping:
            event.interrupt()

    def told(event: Any) -> None:
        data = event.data_out
        attendant.tell((finite(data.mip_primal_bound), finite(data.mip_dual_bound), None))

    def improved(event: Any) -> None:
        data = event.data_out
        ends = finite(data.mip_primal_bound), finite(data.mip_dual_bound)
        attendant.tell((*ends, np.array(data.mip_solution)))

    highs.cbMipImprovingSolution += improved
    highs.cbMipLogging += told
    highs.cbMipInterrupt += interrupt
    highs.cbSimplexInterrupt += interrupt
    highs.cbIpmInterrupt += interrupt
    if options.log is not None:
        highs.cbLogging += lambda event: attendant.tell(event.message)
