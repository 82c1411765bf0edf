"""The values of axes, and of listed runs, as settings of runs."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from dataclasses import dataclass, field
from typing import Any

from tsplan.document import Document, Path
from tsplan.errors import Finding, MissionError, nearest
from tsplan.milp.solver import SOLVERS
from tsplan.milp.solver_choice import SolverChoice
from tsplan.run.problem import Tuning
from tsplan.sweeps.mission_variant import Edit
from tsplan.sweeps.parameter_paths import NoPathError, located_path
from tsplan.sweeps.sweep_runs import Setting
from tsplan.sweeps.sweep_schema import AxesEntry, RunEntry, SolverEntry


@dataclass
class AxisReader:
    """Reads settings from a sweep; `base` is its mission, None where that cannot be read."""

    document: Document
    base: Document | None
    findings: list[Finding] = field(default_factory=list)

    def axes(self, entry: AxesEntry) -> Iterator[tuple[Path, list[Setting]]]:
        """Each axis with its place and its values, in the order of the file."""
        path: Path = ("axes",)
        readers: dict[str, Callable[[], Iterator[tuple[Path, list[Setting]]]]] = {
            "seeds": lambda: self._seeds(entry, path),
            "parameters": lambda: self._parameters(entry, path),
            "formulas": lambda: self._formulas(entry, path),
            "solvers": lambda: self._solvers(entry, path),
        }
        for name in self.document.at(path):
            yield from readers[name]() if getattr(entry, name) is not None else ()

    def listed(self, entry: RunEntry, path: Path) -> tuple[Setting, ...]:
        """What one run of a list sets."""
        settings: list[Setting] = []
        for text in entry.parameters:
            place = (*path, "parameters", text)
            settings += self._parameter(text, [place], place)
        if entry.formula is not None:
            settings.append(self._formula(entry.formula, (*path, "formula")))
        if entry.solver is not None:
            settings.append(self._solver(entry.solver, (*path, "solver")))
        if entry.seed is not None:
            settings.append(_seed(entry.seed))
        return tuple(settings)

    def _seeds(self, entry: AxesEntry, path: Path) -> Iterator[tuple[Path, list[Setting]]]:
        yield (*path, "seeds"), [_seed(seed) for seed in entry.seeds or ()]

    def _parameters(self, entry: AxesEntry, path: Path) -> Iterator[tuple[Path, list[Setting]]]:
        for text, values in (entry.parameters or {}).items():
            place = (*path, "parameters", text)
            values_at: list[Path] = [(*place, number) for number in range(len(values))]
            yield place, self._parameter(text, values_at, place)

    def _formulas(self, entry: AxesEntry, path: Path) -> Iterator[tuple[Path, list[Setting]]]:
        place = (*path, "formulas")
        yield place, [self._formula(name, (*place, name)) for name in entry.formulas or ()]

    def _solvers(self, entry: AxesEntry, path: Path) -> Iterator[tuple[Path, list[Setting]]]:
        place = (*path, "solvers")
        entries = enumerate(entry.solvers or ())
        yield place, [self._solver(one, (*place, number)) for number, one in entries]

    def _parameter(self, text: str, values: list[Path], key: Path) -> list[Setting]:
        """The values of a parameter, none where it names nothing."""
        if self.base is None:
            return []
        try:
            path = located_path(self.base, text)
        except NoPathError as wrong:
            self.findings.append(self.document.key_finding(key, wrong.what, wrong.remedy))
            return []
        return [Setting(text, self.document.at(value), Edit(path, value)) for value in values]

    def _formula(self, shown: Any, value: Path) -> Setting:
        """A formula, for the place at which the mission has its own."""
        spec = self.base.data.get("spec") if self.base is not None else None
        where: Path = ("spec",)
        if isinstance(spec, dict):
            where = ("spec", "must" if "must" in spec else "formula")
        return Setting("formula", shown, Edit(where, value))

    def _solver(self, entry: SolverEntry, path: Path) -> Setting:
        name = entry.name
        if name is not None and name.partition(":")[0] not in SOLVERS:
            what = f"there is no solver '{name}'"
            self._refuse((*path, "name"), what, nearest(name, SOLVERS))
        for number, idea in enumerate(entry.without):
            try:
                Tuning.named("tight", (idea,))
            except MissionError as error:
                wrong = error.findings[0]
                self._refuse((*path, "without", number), wrong.message, wrong.remedy)
        without = tuple(entry.without)
        return Setting("solver", entry.title, None, entry.choice, entry.encoding, without)

    def _refuse(self, path: Path, what: str, remedy: str) -> None:
        self.findings.append(self.document.finding(path, what, remedy))


def _seed(seed: int) -> Setting:
    return Setting("seed", seed, choice=SolverChoice(seed=seed))
