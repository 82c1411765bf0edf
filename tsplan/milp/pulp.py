"""Any solver that PuLP finds, by its PuLP name after a colon: `pulp:PULP_CBC_CMD`.

PuLP knows no progress, no interruption and no limits that hold everywhere, so the solve is attended
from outside; what differs between PuLP 3 and PuLP 4 is in `tsplan.milp.pulp_terms`.
"""

from __future__ import annotations

import inspect
import time
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
from tsplan.milp.descendants import Offspring
from tsplan.milp.model import Floats, Model
from tsplan.milp.pulp_terms import UnclearError, load, pulp_module, told
from tsplan.milp.quiet_output import hushed
from tsplan.milp.solution import Options, Solution, Watcher, settled
from tsplan.milp.solver import Availability
from tsplan.milp.verdict import Ending, Question, Verdict
from tsplan.milp.watchdog import Attendant, Patience
from tsplan.stopping import StoppedBy

_PREFERRED = ("PULP_CBC_CMD", "COIN_CMD", "HiGHS", "HiGHS_CMD", "SCIP_PY", "SCIP_CMD", "GLPK_CMD")
_UNFIT = frozenset({"CPSAT"})  # takes continuous columns for whole ones
_INSTALL = "pip install 'tsplan[pulp]'"
_LEAST_GAP = (
    1e-9  # some backends take a gap of 0 for none given, and have a larger one of their own
)
_SLACK = 0.25  # seconds after its time limit until a backend is interrupted from outside
_PATIENCE = Patience(time_limit=1.0, interrupt=3.0)  # then it has to write its point
_MOST = 0.9  # of a time limit, after which it is what stopped a backend that does not say
_CBC = frozenset({"PULP_CBC_CMD", "COIN_CMD"})


class Pulp:
    """Solves models through PuLP with the named backend, or with the first good one it finds."""

    def __init__(self, backend: str = "") -> None:
        self._backend = backend
        self.name = f"pulp:{backend}" if backend else "pulp"

    @cached_property
    def _found(self) -> list[str]:
        # looking costs a moment: some backends start their licence to see whether they can
        return backends() if find_spec("pulp") is not None else []

    @property
    def features(self) -> frozenset[str]:
        """What the backend can do through PuLP; empty while there is none."""
        if not self.availability().usable:
            return frozenset()
        name = self._chosen()
        known = _parameters(name)
        able = {
            "start": "warmStart" in known,
            "log": "logPath" in known,
            "threads": "threads" in known,
            "gap": "gapRel" in known,
            "seed": bool(_seeded(name, 0, known)),
            "first": name in _CBC,
            "cutoff": True,
        }
        return frozenset(feature for feature, can in able.items() if can)

    def availability(self) -> Availability:
        """Installed if PuLP is there; usable if PuLP finds the backend."""
        if find_spec("pulp") is None:
            return Availability(
                installed=False, usable=False, why="PuLP is not installed", remedy=_INSTALL
            )
        found, number = self._found, version("pulp")
        listed = f"PuLP finds here: {', '.join(found)}" if found else "PuLP finds none here"
        if self._backend and self._backend not in found:
            why = f"PuLP finds no usable {self._backend}"
            return Availability(
                installed=True, usable=False, version=number, why=why, remedy=listed
            )
        if not found:
            remedy = "install one, such as CBC (pip install cbcbox), or use --solver highs"
            return Availability(
                installed=True, usable=False, version=number, why=listed, remedy=remedy
            )
        return Availability(installed=True, usable=True, version=number)

    def native(self, model: Model) -> Any:
        """The model as a `pulp.LpProblem`."""
        self._chosen()
        return load(model)[0]

    def solve(
        self, model: Model, options: Options | None = None, watch: Watcher | None = None
    ) -> Solution:
        """Minimise the model; see `tsplan.milp.solver.Solver`.

        PuLP hands no progress over, so `watch` is not called; `Options.stop` is asked.
        """
        del watch
        began = time.perf_counter()
        options = options or Options()
        name = self._chosen()
        known = settled(model)
        if known is not None:
            return known
        question = Question(model, options)
        said = _Solve(name, question, began).ending()
        return question.answer(said, time.perf_counter() - began)

    def _chosen(self) -> str:
        """PuLP's name of the backend. Raises SolverUnavailableError if it cannot be used."""
        state = self.availability()
        if not state.usable:
            raise SolverUnavailableError(f"{state.why}; {state.remedy}")
        best = (name for name in _PREFERRED if name in self._found)
        return self._backend or next(best, self._found[0])


@dataclass(eq=False)
class _Solve:
    """One solve with one backend."""

    backend: str
    question: Question
    began: float
    _said: Ending = field(default=Ending(Verdict.ENDED), init=False)
    _read: int = field(default=0, init=False)

    def ending(self) -> Ending:
        model, said = self.question.model, None
        try:
            # no backend has a cutoff that all versions of PuLP pass on
            said = self._run(self.question.cut())
        except UnclearError:
            if _bounded(model):
                raise
        if said is None or (said.verdict is Verdict.REFUTED and not _bounded(model)):
            # some backends say so of unbounded models too: ask for any point
            said = self._run(model.with_objective(np.zeros(model.size.columns)))
            if said.values is not None:
                raise SolverError("the model is unbounded: its objective can fall without end")
        return said

    def _run(self, model: Model) -> Ending:
        with TemporaryDirectory(prefix="tsplan-") as folder:
            log = Path(folder, "log")
            return self._logged(model, log)

    def _logged(self, model: Model, log: Path) -> Ending:
        offspring, limit = Offspring(), self.question.options.time_limit
        attendant = Attendant(
            None if limit is None else self.began + max(limit, 0.0) + _SLACK,
            asked=lambda: self._asked(log),
            stop=offspring.interrupt,
            patience=_PATIENCE,
        )

        def work() -> None:
            offspring.mine()
            try:
                self._said = self._solved(model, log, attendant)
            except SolverError:
                raise
            except Exception as error:
                # backends raise errors of their own, and some when they are interrupted
                if not attendant.stopping:
                    raise SolverError(f"PuLP's {self.backend} failed: {error}") from error
                self._said = Ending(Verdict.ENDED, stopped_by=attendant.stopped_by)

        if attendant.run(work):
            self._pass_on(log)
            return self._said
        offspring.kill()
        return Ending(Verdict.ENDED, stopped_by=attendant.stopped_by)

    def _solved(self, model: Model, log: Path, attendant: Attendant) -> Ending:
        problem, variables = load(model)
        arguments = self._arguments(log)
        start = self.question.options.start
        if "warmStart" in arguments and start is not None:
            for variable, value in zip(variables, start.tolist(), strict=True):
                variable.setInitialValue(value, check=False)
        answer = problem.solve(_backend(self.backend, arguments))
        said = told(problem, answer)
        if said.verdict is Verdict.REFUTED:
            return said
        values = self._values(variables, said.verdict)
        reason = said.stopped_by or attendant.stopped_by
        if said.verdict is Verdict.ENDED and reason is None:
            reason = self._reason(values)
        return replace(said, values=values, stopped_by=reason)

    def _reason(self, values: Floats | None) -> StoppedBy | None:
        """What may have stopped a backend that does not say."""
        options = self.question.options
        if options.first and values is not None:
            return None
        limit, spent = options.time_limit, time.perf_counter() - self.began
        late = limit is not None and spent >= _MOST * limit
        return StoppedBy.TIME_LIMIT if late else StoppedBy.INTERRUPT

    def _values(self, variables: list[Any], verdict: Verdict) -> Floats | None:
        """The backend's point, or None; the model says whether what it left behind is one."""
        model = self.question.model
        listed = (variable.value() for variable in variables)
        read = np.array([0.0 if value is None else float(value) for value in listed])
        values: Floats = np.minimum(np.maximum(read, model.lower), model.upper)
        if self.question.whole(values) is not None:
            return values
        if verdict is Verdict.ENDED:
            return None
        polished = _polished(model, values)
        return values if polished is None else polished

    def _arguments(self, log: Path) -> dict[str, object]:
        """What the backend is given, as far as it takes it."""
        options, known = self.question.options, _parameters(self.backend)
        asked: dict[str, object] = {
            "msg": False,
            "gapRel": max(options.gap, _LEAST_GAP),
            "threads": options.threads,
        }
        if options.time_limit is not None:
            left = self.began + options.time_limit - time.perf_counter()
            asked["timeLimit"] = max(round(left, 3), 0.01)
        if options.start is not None:
            asked["warmStart"] = True
        if options.log is not None:
            asked["logPath"] = str(log)
        taken = {key: value for key, value in asked.items() if value is not None and key in known}
        if options.seed is not None:
            taken |= _seeded(self.backend, options.seed, known)
        if options.first and self.backend in _CBC:
            taken["options"] = [*_listed(taken.get("options")), "maxSolutions 1"]
        return taken | _extra(self.backend, options.extra, known)

    def _asked(self, log: Path) -> bool:
        self._pass_on(log)
        stop = self.question.options.stop
        return stop is not None and stop()

    def _pass_on(self, log: Path) -> None:
        """Hand the new lines of the backend's log over."""
        hear = self.question.options.log
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
        from tsplan.milp.highs import option_names  # noqa: PLC0415 - no solver imported unasked

        known, open_ended = {**known, **dict.fromkeys(option_names())}, False
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
    from tsplan.milp.highs import Highs  # noqa: PLC0415 - no solver is imported unasked

    fixed = np.round(values)
    lower = np.where(model.integer, fixed, model.lower)
    upper = np.where(model.integer, fixed, model.upper)
    near = model.with_bounds(lower, upper).with_integrality(np.zeros(len(values), dtype=bool))
    return Highs().solve(near).values
