"""Any solver that PuLP finds, by its PuLP name after a colon: `pulp:PULP_CBC_CMD`.

PuLP knows no progress, no interruption and no limits that hold everywhere, so the solve is attended
from outside; what differs between PuLP 3 and PuLP 4 is in `tsplan.milp.pulp_terms`.
"""

from __future__ import annotations

import inspect
import threading
import warnings
from collections.abc import Mapping
from dataclasses import dataclass, field, replace
from functools import cached_property
from importlib.metadata import version
from importlib.util import find_spec
from pathlib import Path
from tempfile import TemporaryDirectory
from typing import Any

import numpy as np

from tsplan.errors import SolverError, SolverUnavailableError, nearest
from tsplan.milp.highs import rules_off
from tsplan.milp.model import Floats, Model
from tsplan.milp.pulp_terms import UnclearError, load, pulp_module, raw_result
from tsplan.milp.request import NativeRun, RawResult, Request
from tsplan.milp.solution import Status
from tsplan.milp.solver import Availability, Solver, solver
from tsplan.process.descendants import INTERRUPT, KILL, Descendants
from tsplan.process.grace_period import COMMAND
from tsplan.process.quiet_output import hushed
from tsplan.process.watchdog import Watchdog
from tsplan.stopping import StoppedBy

_PREFERRED = ("PULP_CBC_CMD", "COIN_CMD", "HiGHS", "HiGHS_CMD", "SCIP_PY", "SCIP_CMD", "GLPK_CMD")
_UNFIT = frozenset({"CPSAT"})  # takes continuous columns for whole ones
_INSTALL = "pip install 'tsplan[pulp]'"
# some backends take a gap of 0 for none given, and have a larger one of their own
_LEAST_GAP = 1e-9
_SLACK = 0.25  # seconds after its time limit until a backend is interrupted from outside
_MOST = 0.9  # of a time limit, after which it is what stopped a backend that does not say
_CBC = frozenset({"PULP_CBC_CMD", "COIN_CMD"})
_WITHOUT_PRESOLVE: Mapping[str, Mapping[str, object]] = {
    **{name: {"options": ["presolve off", "preprocess off"]} for name in _CBC},
    "HiGHS": {"presolve": "off"},
    "GUROBI": {"Presolve": 0},
}


class Pulp(Solver):
    """Solves models through PuLP with the named backend, or with the first good one it finds.

    PuLP hands no progress over, so nobody hears of any; wishes to stop are heard.
    """

    def __init__(self, variant: str = "") -> None:
        super().__init__(variant)
        self.name = f"pulp:{variant}" if variant else "pulp"

    @cached_property
    def _found(self) -> list[str]:
        # looking costs a moment: some backends start their licence to see whether they can
        return backends() if find_spec("pulp") is not None else []

    @property
    def features(self) -> frozenset[str]:  # type: ignore[override]  # it depends on the backend
        """What the backend can do through PuLP; empty while there is none."""
        if not self.availability().usable:
            return frozenset()
        name = self._chosen()
        known = _parameters(name)
        taken = {"start": "warmStart", "log": "logPath", "threads": "threads", "gap": "gapRel"}
        able = {feature for feature, word in taken.items() if word in known} | {"cutoff"}
        able |= {"seed"} if _seeded(name, 0, known) else set()
        able |= {"presolve"} if name in _WITHOUT_PRESOLVE else set()
        return frozenset(able | {"first"} if name in _CBC else able)

    def availability(self) -> Availability:
        """Installed if PuLP is there; usable if PuLP finds the backend."""
        if find_spec("pulp") is None:
            return Availability(False, None, "PuLP is not installed", _INSTALL)
        found, number = self._found, version("pulp")
        listed = f"PuLP finds here: {', '.join(found)}" if found else "PuLP finds none here"
        if self.variant and self.variant not in found:
            return Availability(True, number, f"PuLP finds no usable {self.variant}", listed)
        if not found:
            remedy = "install one, such as CBC (pip install cbcbox), or use --solver highs"
            return Availability(True, number, listed, remedy)
        return Availability(True, number)

    def names(self) -> list[str]:
        """Every backend that PuLP finds."""
        return [f"{self.name}:{name}" for name in self._found]

    def native(self, model: Model) -> Any:
        """The model as a `pulp.LpProblem`."""
        self._chosen()
        return load(model)[0]

    def point(self, native: Any) -> Floats:
        """The point of a solved `pulp.LpProblem`, whose variables are numbered."""
        named = {variable.name: variable for variable in native.variables()}
        # one of its own stands for an objective that is missing
        ordered = [
            named[f"x{number}"] for number in range(sum(name[1:].isdigit() for name in named))
        ]
        values = [variable.value() for variable in ordered]
        if any(value is None for value in values):
            raise SolverError("PuLP has no point of the model; solve it first")
        return np.array(values, dtype=np.float64)

    def answer(self, request: Request) -> RawResult:
        """What the backend makes of a request; see `tsplan.milp.solver.Solver`."""
        return _Solve(self._chosen(), request).answer()

    def _chosen(self) -> str:
        """PuLP's name of the backend. Raises SolverUnavailableError if it cannot be used."""
        state = self.availability()
        if not state.usable:
            raise SolverUnavailableError(f"{state.why}; {state.remedy}")
        best = (name for name in _PREFERRED if name in self._found)
        return self.variant or next(best, self._found[0])


@dataclass(eq=False)
class _Solve:
    """One solve with one backend."""

    backend: str
    request: Request
    _read: int = field(default=0, init=False)

    def answer(self) -> RawResult:
        model, raw = self.request.model, None
        try:
            # no backend has a cutoff that all versions of PuLP pass on
            raw = self._run(self.request.cut())
        except UnclearError:
            if _bounded(model):
                raise
        if raw is None or (raw.status is Status.INFEASIBLE and not _bounded(model)):
            # some backends say so of unbounded models too: ask for any point
            raw = self._run(model.with_objective(np.zeros(model.size.columns)))
            if raw.values is not None:
                raise SolverError("the model is unbounded: its objective can fall without end")
        return raw

    def _run(self, model: Model) -> RawResult:
        """Run the backend, watched from outside, as it knows no interruption."""
        descendants, deadline = Descendants(), self.request.deadline

        def work(watchdog: Watchdog) -> RawResult:
            descendants.thread = threading.get_native_id()
            try:
                return self._solved(model, log, watchdog)
            except SolverError:
                raise
            except Exception as error:
                # backends raise errors of their own, and some when they are interrupted
                if not watchdog.stopping:
                    raise SolverError(f"PuLP's {self.backend} failed: {error}") from error
                return RawResult(Status.UNKNOWN)

        with TemporaryDirectory(prefix="tsplan-") as folder:
            log = Path(folder, "log")
            try:
                raw = NativeRun(self.request).result(
                    work,
                    deadline=None if deadline is None else deadline + _SLACK,
                    asked=lambda: self._asked(log),
                    stop=lambda: descendants.send(INTERRUPT),
                    grace=COMMAND,
                )
            finally:
                descendants.send(KILL)  # one that was left behind
            self._pass_on(log)
            return raw

    def _solved(self, model: Model, log: Path, watchdog: Watchdog) -> RawResult:
        problem, variables = load(model)
        arguments = self._arguments(log)
        start = self.request.options.start
        if "warmStart" in arguments and start is not None:
            for variable, value in zip(variables, start.tolist(), strict=True):
                variable.setInitialValue(value, check=False)
        answer = problem.solve(_backend(self.backend, arguments))
        raw = raw_result(problem, answer)
        if raw.status is Status.INFEASIBLE:
            return raw
        values = self._values(variables, raw.status)
        reason = raw.stopped_by or watchdog.stopped_by
        if raw.status is Status.UNKNOWN and reason is None:
            reason = self._reason(values)
        return replace(raw, values=values, stopped_by=reason)

    def _reason(self, values: Floats | None) -> StoppedBy | None:
        """What may have stopped a backend that does not say."""
        options = self.request.options
        if options.first and values is not None:
            return None
        limit = options.time_limit
        late = limit is not None and self.request.elapsed >= _MOST * limit
        return StoppedBy.TIME_LIMIT if late else StoppedBy.INTERRUPT

    def _values(self, variables: list[Any], claim: Status) -> Floats | None:
        """The backend's point, or None; the model says whether what it left behind is one."""
        model = self.request.model
        listed = (variable.value() for variable in variables)
        read = np.array([0.0 if value is None else float(value) for value in listed])
        values: Floats = np.minimum(np.maximum(read, model.lower), model.upper)
        if self.request.rounded(values) is not None:
            return values
        if claim is Status.UNKNOWN:
            return None
        polished = _polished(model, values)
        return values if polished is None else polished

    def _arguments(self, log: Path) -> dict[str, object]:
        """What the backend is given, as far as it takes it."""
        options, known = self.request.options, _parameters(self.backend)
        asked: dict[str, object] = {
            "msg": False,
            "gapRel": max(options.gap, _LEAST_GAP),
            "threads": options.threads,
        }
        if options.time_limit is not None:
            left = options.time_limit - self.request.elapsed
            asked["timeLimit"] = max(round(left, 3), 0.01)
        if options.start is not None:
            asked["warmStart"] = True
        if options.log is not None:
            asked["logPath"] = str(log)
        taken = {key: value for key, value in asked.items() if value is not None and key in known}
        parts: list[Mapping[str, object]] = []
        if self.backend == "HiGHS":
            parts.append({"presolve_rule_off": rules_off(self.request.model)})
        if options.seed is not None:
            parts.append(_seeded(self.backend, options.seed, known))
        if not options.presolve:
            parts.append(_WITHOUT_PRESOLVE.get(self.backend, {}))
        if options.first and self.backend in _CBC:
            parts.append({"options": ["maxSolutions 1"]})
        for part in parts:
            taken |= part
        if words := [word for part in parts for word in _listed(part.get("options"))]:
            taken["options"] = words
        return taken | _extra(self.backend, options.extra, known)

    def _asked(self, log: Path) -> bool:
        self._pass_on(log)
        stop = self.request.options.stop
        return stop is not None and stop()

    def _pass_on(self, log: Path) -> None:
        """Hand the new lines of the backend's log over."""
        hear = self.request.options.log
        if hear is None or not log.exists():
            return
        with log.open(errors="replace") as file:
            file.seek(self._read)
            text = file.read()
            whole = text[: text.rfind("\n") + 1]
            self._read += len(whole.encode())
        for line in whole.splitlines():
            hear(line)


def backends() -> list[str]:
    """PuLP's names of the solvers it can use here."""
    pulp = pulp_module()
    with warnings.catch_warnings(), hushed():  # some load their solver or start its licence
        warnings.simplefilter("ignore", DeprecationWarning)
        return [name for name in pulp.listSolvers(onlyAvailable=True) if name not in _UNFIT]


def _backend(name: str, arguments: dict[str, object]) -> Any:
    pulp = pulp_module()
    with warnings.catch_warnings(), hushed():
        # PuLP 3 warns of the end of the CBC it brings along, whoever asked for it
        warnings.simplefilter("ignore", DeprecationWarning)
        try:
            return pulp.getSolver(name, **arguments)
        except TypeError as error:
            raise SolverError(f"PuLP's {name} refused its options: {error}") from error


def _parameters(name: str) -> dict[str, inspect.Parameter]:
    """What the backend's constructor takes by name."""
    return dict(inspect.signature(type(_backend(name, {"msg": False})).__init__).parameters)


def _extra(
    name: str, extra: Mapping[str, object], known: Mapping[str, inspect.Parameter | None]
) -> dict[str, object]:
    """The user's own options. Raises SolverError for one that the backend would not notice."""
    given = dict(extra)
    open_ended = any(p.kind is inspect.Parameter.VAR_KEYWORD for p in known.values() if p)
    if name == "HiGHS":
        own = solver("highs").option_names()
        known, open_ended = {**known, **dict.fromkeys(own)}, False
    for option in given:
        if option not in known and not open_ended:
            raise SolverError(f"PuLP's {name} has no option '{option}'; {nearest(option, known)}")
    return given


def _seeded(name: str, seed: int, known: dict[str, inspect.Parameter]) -> dict[str, object]:
    """The seed under the backend's own name for it; nothing where PuLP has no way to pass it."""
    if "randomSeed" in known:
        return {"randomSeed": seed}
    if name in _CBC:
        return {"options": [f"randomSeed {seed}", f"randomCbcSeed {seed}"]}
    word = {"HiGHS": "random_seed", "GUROBI": "Seed"}.get(name)
    return {} if word is None else {word: seed}


def _listed(options: object) -> list[str]:
    return list(options) if isinstance(options, list) else []


def _bounded(model: Model) -> bool:
    """Whether the bounds of the columns alone keep the objective from falling without end."""
    falls = np.where(model.objective > 0, model.lower, model.upper)[model.objective != 0]
    return bool(np.isfinite(falls).all())


def _polished(model: Model, values: Floats) -> Floats | None:
    """A point that fits the model, near one that was written with too few digits.

    The integer columns are fixed at the nearest whole numbers, HiGHS finds the others.
    """
    fixed = np.round(values)
    lower = np.where(model.integer, fixed, model.lower)
    upper = np.where(model.integer, fixed, model.upper)
    near = model.with_bounds(lower, upper).with_integrality(np.zeros(len(values), dtype=bool))
    return solver("highs").solve(near).values
