"""The protocol every solver fulfils, and the registry that finds one by name."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass
from types import MappingProxyType
from typing import Any, Protocol

from tsplan.errors import SolverUnavailableError, nearest
from tsplan.milp.model import Model
from tsplan.milp.solution import Options, Solution, Watcher


@dataclass(frozen=True)
class Availability:
    """Whether a solver is installed and whether it may be used here; why not, and what to do."""

    installed: bool
    usable: bool
    version: str | None = None
    why: str = ""
    remedy: str = ""


class Solver(Protocol):
    """A solver of mixed-integer linear programs. `name` is what the registry knows it by."""

    name: str

    @property
    def features(self) -> frozenset[str]:
        """What it can do.

        Of "start", "progress", "incumbents", "first", "log", "seed", "threads", "gap", "cutoff" and
        "presolve";
        options for what it cannot do are passed over.
        """

    def availability(self) -> Availability:
        """Whether it is installed and usable. Never raises."""

    def solve(self, model: Model, options: Options, watch: Watcher | None = None) -> Solution:
        """Minimise the model. Raises SolverError or SolverUnavailableError, nothing else."""

    def native(self, model: Model) -> Any:
        """The model loaded into the solver's own object, not yet solved."""


def _highs(_: str) -> Solver:
    from tsplan.milp.highs import Highs  # noqa: PLC0415 - no solver is imported unasked

    return Highs()


def _gurobi(_: str) -> Solver:
    from tsplan.milp.gurobi import Gurobi  # noqa: PLC0415 - no solver is imported unasked

    return Gurobi()


def _pulp(backend: str) -> Solver:
    from tsplan.milp.pulp import Pulp  # noqa: PLC0415 - no solver is imported unasked

    return Pulp(backend)


SOLVERS: Mapping[str, Callable[[str], Solver]] = MappingProxyType(
    {"highs": _highs, "gurobi": _gurobi, "pulp": _pulp}
)
"""How to make each solver from what follows the colon in its name."""


def solver(name: str) -> Solver:
    """The solver of a name such as `highs`, `gurobi`, `pulp` or `pulp:PULP_CBC_CMD`.

    Raises SolverUnavailableError for unknown names and for solvers that cannot be used, with
    what to do about it.
    """
    family, _, backend = name.partition(":")
    if family not in SOLVERS:
        raise SolverUnavailableError(f"there is no solver '{name}'; {nearest(family, SOLVERS)}")
    made = SOLVERS[family](backend)
    found = made.availability()
    if not found.usable:
        raise SolverUnavailableError(f"solver '{name}' cannot be used: {found.why}; {found.remedy}")
    return made


def available() -> dict[str, Availability]:
    """Every registered solver and whether it can be used."""
    return {name: make("").availability() for name, make in SOLVERS.items()}


def installed() -> list[str]:
    """The names of the solvers that can be used here, PuLP's each on its own."""
    names = [name for name, state in available().items() if state.usable and name != "pulp"]
    if available()["pulp"].usable:
        from tsplan.milp.pulp import backends  # noqa: PLC0415 - no solver is imported unasked

        names += [f"pulp:{name}" for name in backends()]
    return names
