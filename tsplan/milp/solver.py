"""What every solver fulfils, and the registry that finds one by name.

To add a solver: one file with a class of `Solver`, and one line in `SOLVERS`.
"""

from __future__ import annotations

import time
from abc import ABC, abstractmethod
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, replace
from importlib import import_module
from types import MappingProxyType
from typing import Any

import numpy as np

from tsplan.errors import SolverError, SolverUnavailableError, nearest
from tsplan.milp.model import Floats, Model
from tsplan.milp.request import RawResult, Request
from tsplan.milp.solution import Options, Solution, Watcher, presolved

FEATURES = frozenset(
    {
        *("start", "progress", "incumbents", "first", "log"),
        *("seed", "threads", "gap", "cutoff", "presolve"),
    }
)
"""What a solver may be able to do."""


@dataclass(frozen=True)
class Availability:
    """Whether a solver is installed and whether it may be used here; why not, and what to do."""

    installed: bool = True
    version: str | None = None
    why: str = ""
    remedy: str = ""

    @property
    def usable(self) -> bool:
        """Whether it may be used."""
        return not self.why


class Solver(ABC):
    """A solver of mixed-integer linear programs.

    `name` is what the registry knows it by, before the colon of a variant. Of `FEATURES` it has
    `features`; options for what it cannot do are passed over.
    """

    name: str
    features: frozenset[str] = FEATURES

    def __init__(self, variant: str = "") -> None:
        self.variant = variant

    @abstractmethod
    def availability(self) -> Availability:
        """Whether it is installed and usable. Never raises."""

    @abstractmethod
    def native(self, model: Model) -> Any:
        """The model loaded into the solver's own object, not yet solved."""

    def named(self, model: Model, columns: Sequence[str], rows: Sequence[str]) -> Any:
        """The same with a name for every column and row, where the solver has such names."""
        return self.native(model)

    def point(self, native: Any) -> Floats:
        """The point of `native`'s own object that somebody has solved, in the order of columns.

        Raises SolverError where there is none.
        """
        raise SolverError(f"points of {self.name}'s own objects are not read; give the values")

    @abstractmethod
    def answer(self, request: Request) -> RawResult:
        """What the solver makes of a request; `NativeRun` keeps its limits for it."""

    def solve(
        self, model: Model, options: Options | None = None, watch: Watcher | None = None
    ) -> Solution:
        """Minimise the model. Raises SolverError or SolverUnavailableError, nothing else.

        `watch` is called where the solver has the features "progress" or "incumbents".
        """
        request = Request(model, options or Options(), watch)
        known = presolved(model)
        return known or request.solution(self._settled(request), request.elapsed)

    def _settled(self, request: Request) -> RawResult:
        """An answer whose point fits the model with its whole numbers rounded.

        A solver takes 1e-6 for 0. Where a row multiplies that by a large factor, columns that need
        not be whole have gone too far; they are sought again, with the others where they belong.
        """
        raw, model = self.answer(request), request.model
        if raw.values is None or not request.is_off(raw.values):
            return raw
        whole = np.flatnonzero(model.integer)
        rounded = model.with_fixed(whole, raw.values[whole])
        left = request.deadline and request.deadline - time.perf_counter()
        asked = Options(threads=request.options.threads, time_limit=left)
        again = self.answer(Request(rounded.with_integrality(np.zeros_like(model.integer)), asked))
        return raw if again.values is None else replace(raw, values=again.values)

    def option_names(self) -> list[str]:
        """The solver's own names of its options, if it tells them."""
        return []

    def names(self) -> list[str]:
        """The names by which it can be used here, that of each variant on its own."""
        return [self.name] if self.availability().usable else []


def _deferred(module: str, kind: str) -> Callable[[str], Solver]:
    """Makes a solver of a class, given the name of a variant; none is imported unasked."""

    def make(variant: str) -> Solver:
        made: Solver = getattr(import_module(f"tsplan.milp.{module}"), kind)(variant)
        return made

    return make


SOLVERS: Mapping[str, Callable[[str], Solver]] = MappingProxyType(
    {
        "highs": _deferred("highs", "Highs"),
        "gurobi": _deferred("gurobi", "Gurobi"),
        "pulp": _deferred("pulp", "Pulp"),
    }
)
"""How to make each solver from what follows the colon in its name."""


def solver(name: str) -> Solver:
    """The solver of a name such as `highs`, `gurobi`, `pulp` or `pulp:PULP_CBC_CMD`.

    Raises SolverUnavailableError for unknown names and for solvers that cannot be used, with
    what to do about it.
    """
    family, _, variant = name.partition(":")
    if family not in SOLVERS:
        raise SolverUnavailableError(f"there is no solver '{name}'; {nearest(family, SOLVERS)}")
    made = SOLVERS[family](variant)
    state = made.availability()
    if not state.usable:
        raise SolverUnavailableError(f"solver '{name}' cannot be used: {state.why}; {state.remedy}")
    return made


def available() -> dict[str, Availability]:
    """Every registered solver and whether it can be used."""
    return {name: make("").availability() for name, make in SOLVERS.items()}


def installed() -> list[str]:
    """The names of the solvers that can be used here, PuLP's each on its own."""
    return [name for make in SOLVERS.values() for name in make("").names()]
