"""From a mission file to a mission, with every finding at its place in the file."""

from __future__ import annotations

import time
from dataclasses import dataclass, field
from fractions import Fraction
from functools import partial
from pathlib import Path
from typing import TYPE_CHECKING, Any

from tsplan.errors import Finding, InputError, MissionError
from tsplan.milp.solver_choice import SolverChoice
from tsplan.mission.costs import cost_problems
from tsplan.mission.findings import Entry, Place, Problem
from tsplan.mission.formulas import Formulas, spelled_out
from tsplan.mission.mission import (
    ORDERS,
    Group,
    Mission,
    Order,
    Preference,
    SwarmBounds,
    SwarmRules,
)
from tsplan.mission.mission_checks import (
    formula_horizon,
    formula_problems,
    horizon_problems,
    map_problems,
    moved,
    objective_problems,
    team_problems,
    wish_problems,
)
from tsplan.mission.named_parts import with_named_classes
from tsplan.mission.objectives import DEFAULT_OBJECTIVE, DEFAULT_SWARM_OBJECTIVE
from tsplan.mission.swarm_rules import KINDS, ONE_SWARM, kind_problems, total_problems
from tsplan.words import nfc

if TYPE_CHECKING:
    from collections.abc import Iterable, Mapping

    from tsplan.document import Document
    from tsplan.logic import Formula
    from tsplan.mission.mission_schema import Member, MissionFile, Swarm, Wish
    from tsplan.ts import TransitionSystem


def load_mission(path: str | Path) -> Mission:
    """Read a mission file and the map it names.

    Raises MissionError with everything that is wrong with the file, its map and its formula.
    """
    from tsplan.document import read_document  # noqa: PLC0415  (the reader is slow to import)

    return _in_one_family(lambda: mission_from_document(read_document(path), Path(path).parent))


def mission_from_text(text: str, source: str = "mission", folder: str | Path = ".") -> Mission:
    """Read a mission from its text; maps are looked for in `folder`. Raises MissionError."""
    from tsplan.document import parse_document  # noqa: PLC0415  (the reader is slow to import)

    return _in_one_family(lambda: mission_from_document(parse_document(text, source), Path(folder)))


def _in_one_family(read: Any) -> Mission:
    try:
        mission: Mission = read()
    except MissionError:
        raise
    except InputError as error:
        raise MissionError(error.findings) from None
    return mission


def mission_from_document(
    document: Document, folder: Path, system: TransitionSystem | None = None
) -> Mission:
    """A mission from its document. With `system`, the document's own map is not read."""
    from tsplan.document.kinds import MISSION, misfit  # noqa: PLC0415  (as below)
    from tsplan.document.validation import salvaged, validated  # noqa: PLC0415  (slow to import)
    from tsplan.mission.mission_schema import STAND_INS, MissionFile  # noqa: PLC0415  (needs pydantic)

    strange = misfit(document, (), MISSION)
    if strange is not None:
        raise MissionError([strange])
    document = spelled_out(document)
    file, findings = validated(document, MissionFile)
    draft = _Draft(document, list(findings))
    draft.judge_kind()
    draft.system = system if system is not None else draft.read_map(folder)
    began = time.perf_counter()
    draft.formulas.read()
    draft.seconds = time.perf_counter() - began
    if file is not None:
        draft.read_agents(file)
        draft.judge(file)
    else:
        draft.judge_rest(*salvaged(document, MissionFile, STAND_INS))
    serious = any(draft.known.get(finding, True) for finding in draft.findings)
    formula = draft.formulas.formula
    if serious or file is None or draft.system is None or formula is None:
        raise MissionError(draft.in_order())
    made = draft.mission(file, draft.system, formula)
    for problem in cost_problems(made.system, made.team, made.horizon, made.objective):
        draft.file(problem)
    if draft.findings and any(draft.known.get(finding, True) for finding in draft.findings):
        raise MissionError(draft.in_order())
    return made


@dataclass
class _Draft:
    """A mission while it is read: its parts as far as they are known, and what is wrong so far."""

    document: Document
    findings: list[Finding]
    warnings: list[Finding] = field(default_factory=list)
    known: dict[Finding, bool] = field(default_factory=dict)  # by whether they are serious
    system: TransitionSystem | None = None
    entries: list[Entry] | None = None  # None where what is said of them is wrong
    swarm: SwarmRules | None = None
    seconds: float = 0.0

    def __post_init__(self) -> None:
        self.formulas = Formulas(self.document, self.findings)

    def read_map(self, folder: Path) -> TransitionSystem | None:
        """The map, inline or from the file beside the mission."""
        from tsplan.document.files import beside  # noqa: PLC0415  (missions made in Python)
        from tsplan.ts.io.map_files import load_map, map_from_document  # noqa: PLC0415  (slow to import)

        given = self.document.data.get("map") if isinstance(self.document.data, dict) else None
        if isinstance(given, dict):
            read = partial(map_from_document, self.document, ("map",))
        elif isinstance(given, str):
            read = partial(load_map, beside(folder, given))
        else:
            if given is not None:
                what = "the map is neither a file name nor a map"
                self._report(("map",), what, "write the name of a map file")
            return None
        try:
            return read()
        except InputError as error:
            self.findings += error.findings
            what = "the map cannot be used, so labels and start states were not looked up in it"
            self._report(("map",), what, "correct the map first")
            return None

    def judge_kind(self) -> None:
        """Report what a mission file says of teams and swarms that it cannot be for at once."""
        for problem in kind_problems(self.document.data):
            line, column = self.document.key_place(problem.path)
            self.findings.append(
                Finding(problem.message, problem.remedy, self.document.source, line, column)
            )

    def read_agents(self, file: MissionFile) -> None:
        """The groups of the team and of the swarms, and the rules of swarms."""
        team: list[Entry] = [
            (("team", n), self._group(member, ("team", n))) for n, member in enumerate(file.team)
        ]
        taken: frozenset[str] = frozenset().union(*(group.capabilities for _, group in team))
        swarms: list[tuple[Place, str, Swarm]] = [
            (("swarms", n), self._word(entry.name, ("swarms", n, "name")), entry)
            for n, entry in enumerate(file.swarms)
        ]
        if file.swarm is not None:
            swarms = [(("swarm",), ONE_SWARM, file.swarm)]
        for path, name, entry in swarms:
            able = frozenset({nfc(name)}) - taken if path[0] == "swarms" else frozenset()
            team.append((path, Group(name, able, self._swarm_starts(entry, path))))
        self.entries = team
        if swarms:
            each = {
                name: SwarmBounds(one.max_subswarms, one.min_subswarm) for _, name, one in swarms
            }
            self.swarm = SwarmRules(each, file.max_subswarms, file.margin)

    @property
    def team(self) -> tuple[Group, ...] | None:
        """The groups, as far as they are known."""
        return None if self.entries is None else tuple(group for _, group in self.entries)

    def _swarm_starts(self, entry: Swarm, path: Place) -> tuple[tuple[str, int], ...]:
        if isinstance(self.document.at((*path, "at")), dict):
            starts = tuple(entry.at.items())
            for problem in total_problems(entry.size, starts, path):
                self.file(problem)
            return starts
        (state,) = entry.at
        return ((self._word(state, (*path, "at")), entry.size),)

    def _group(self, member: Member, path: Place) -> Group:
        if isinstance(self.document.at((*path, "at")), dict):
            starts = tuple(member.at.items())
            total = sum(member.at.values())
            if member.count is not None and member.count != total:
                what = f"the count is {member.count} and the start states hold {total}"
                self._report((*path, "count"), what, f"leave the count out or write {total}")
        else:
            (name,) = member.at
            starts = ((self._word(name, (*path, "at")), member.count or 1),)
        able = [
            self._word(name, (*path, "capabilities", n))
            for n, name in enumerate(member.capabilities)
        ]
        return Group(self._word(member.class_name, (*path, "class")), frozenset(able), starts)

    def _word(self, value: str, path: Place) -> str:
        """A name as it is written: `01` is no number here."""
        return self.document.text(path) or value

    def judge_rest(self, file: MissionFile | None, faulty: frozenset[str]) -> None:
        """Judge what a file says elsewhere than under its faulty keys."""
        if file is None:
            return
        if not faulty.intersection(KINDS) and any(kind in self.document.data for kind in KINDS):
            self.read_agents(file)
        self.judge(file)

    def judge(self, file: MissionFile) -> None:
        """Report what does not fit together, as far as the parts are known."""
        if self.entries is not None:
            formulas = [formula for _, formula in self.formulas.all()]
            named = with_named_classes(self.team or (), self.system, formulas)
            places = (place for place, _ in self.entries)
            self.entries = list(zip(places, named, strict=True))
        names, wishes = self.objective(file), self.preferences(file.spec.prefer)
        problems = []
        if self.entries is not None:
            problems += objective_problems(names, self.swarm)
            problems += wish_problems(names, wishes, self.swarm)
            problems += team_problems(self.entries, self.system, self.swarm)
        if self.system is not None and self.team is not None:
            problems += map_problems(self.system, self.team)
        for where, formula in self.formulas.all():
            found = formula_problems(formula, self.system, self.team, self.swarm)
            _, empty = formula_horizon(formula, file.task_interval)
            found += empty or horizon_problems(formula, file.task_interval, file.horizon)
            problems += moved(found, where)
        for problem in problems:
            self.file(problem)

    def objective(self, file: MissionFile) -> tuple[str, ...]:
        """The objectives, by default those of the mission's kind."""
        if file.objective is not None:
            return objective_names(file.objective)
        return DEFAULT_OBJECTIVE if self.swarm is None else DEFAULT_SWARM_OBJECTIVE

    def preferences(self, wishes: Iterable[Wish]) -> tuple[Preference, ...]:
        """The preferences whose formulas could be read, named by their text if by nothing else."""
        made = []
        for number, wish in enumerate(wishes):
            read = self.formulas.wishes.get(number)
            if read is not None:
                formula, text = read
                place = ("spec", "prefer", number, "name")
                name = self._word(wish.name, place) if wish.name else text.strip()
                weight = Fraction(str(wish.weight))
                made.append(Preference(formula, text, weight, name, wish.level, wish.partial))
        return tuple(made)

    def _report(self, path: Place, message: str, remedy: str) -> None:
        self.file(Problem(path, message, remedy))

    def file(self, problem: Problem) -> None:
        """Turn a problem into a finding at its place."""
        at = problem.at or (self.document.source, *self.formulas.place(problem))
        finding = Finding(problem.message, problem.remedy, *at)
        if finding not in self.known:
            self.known[finding] = problem.serious
            self.findings.append(finding)
            if not problem.serious:
                self.warnings.append(finding)

    def in_order(self) -> list[Finding]:
        """All findings, those of other files first, then by their place."""
        own = self.document.source
        return sorted(self.findings, key=lambda f: (f.source == own, f.line or 0, f.column or 0))

    def mission(self, file: MissionFile, system: TransitionSystem, formula: Formula) -> Mission:
        """The mission, when nothing serious is wrong."""
        prefer = self.preferences(file.spec.prefer)
        formulas = (formula, *(wish.formula for wish in prefer))
        own = max(formula_horizon(item, file.task_interval)[0] or 0 for item in formulas)
        order = objective_order(file.objective or ())
        solver: Mapping[str, Any] = file.solver.model_dump() if file.solver else {}
        return Mission(
            name=file.name,
            system=system,
            team=self.team or (),
            language=file.spec.language,
            text=self.formulas.text,
            formula=formula,
            horizon=file.horizon if file.horizon is not None else own,
            objective=self.objective(file),
            task_interval=file.task_interval,
            solver=SolverChoice(**solver),
            swarm=self.swarm,
            satisfaction=order,
            prefer=prefer,
            digest=self.document.digest,
            warnings=tuple(self.warnings),
            parse_seconds=self.seconds,
            origin=self.document,
        )


_ORDERED = {f"satisfaction: {order}": order for order in ORDERS}


def objective_names(objective: Iterable[str]) -> tuple[str, ...]:
    """The objectives without the order of satisfaction."""
    return tuple("satisfaction" if name in _ORDERED else name for name in objective)


def objective_order(objective: Iterable[str]) -> Order:
    """The order of satisfaction that is asked for."""
    return next((_ORDERED[name] for name in objective if name in _ORDERED), "weighted")
