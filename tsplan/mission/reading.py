"""From a mission file to a mission, with every finding at its place in the file."""

from __future__ import annotations

import re
import time
from dataclasses import dataclass, field, replace
from fractions import Fraction
from functools import partial
from pathlib import Path
from typing import TYPE_CHECKING, Any, NamedTuple

from tsplan.errors import Finding, InputError, MissionError
from tsplan.mission.checks import (
    formula_horizon,
    formula_problems,
    horizon_problems,
    map_problems,
    moved,
    objective_problems,
    preferred,
    team_problems,
    wish_problems,
)
from tsplan.mission.data import (
    DEFAULT_OBJECTIVE,
    DEFAULT_SWARM_OBJECTIVE,
    LANGUAGES,
    ORDERS,
    Group,
    Mission,
    Order,
    Preference,
    SolverChoice,
    SwarmRules,
)
from tsplan.mission.problem import FORMULA, Place, Problem
from tsplan.mission.swarms import kind_problems, swarm_rules, total_problems

if TYPE_CHECKING:
    from collections.abc import Iterable, Mapping

    from tsplan.document import Document
    from tsplan.logic import Formula
    from tsplan.mission.schema import Member, MissionFile, Swarm, Wish
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
    from tsplan.document.schema import validated  # noqa: PLC0415  (pydantic is slow to import)
    from tsplan.mission.schema import MissionFile  # noqa: PLC0415  (needs pydantic)

    file, findings = validated(document, MissionFile)
    draft = _Draft(document, list(findings))
    draft.judge_kind()
    draft.system = system if system is not None else draft.read_map(folder)
    began = time.perf_counter()
    draft.read_formulas()
    draft.seconds = time.perf_counter() - began
    if file is not None:
        draft.read_agents(file)
        draft.judge(file)
    serious = [finding for finding in draft.findings if finding not in draft.warnings]
    if serious or file is None or draft.system is None or draft.formula is None:
        raise MissionError(draft.in_order())
    return draft.mission(file, draft.system, draft.formula)


class Span(NamedTuple):
    """Where a part of a formula stands: `place` is (line, column, end line, end column)."""

    path: Place
    text: str
    place: tuple[int, int, int, int]

    def find(self, word: str) -> tuple[int, int]:
        """Line and column of a word inside the part; where the part begins if it is not there."""
        line, column, end_line, end_column = self.place
        lines = self.text.split("\n")
        begin = sum(len(row) + 1 for row in lines[: line - 1]) + column - 1
        end = sum(len(row) + 1 for row in lines[: end_line - 1]) + end_column - 1
        # after the operator's own letter: a label may be called T, too
        found = re.compile(rf"(?<![\w.]){re.escape(word)}(?![\w.])").search(
            self.text, begin + 1, end
        )
        if not word or found is None:
            return line, column
        before = self.text[: found.start()]
        return before.count("\n") + 1, len(before) - (before.rfind("\n") + 1) + 1


@dataclass
class _Draft:
    """A mission while it is read: its parts as far as they are known, and what is wrong so far."""

    document: Document
    findings: list[Finding]
    warnings: list[Finding] = field(default_factory=list)
    system: TransitionSystem | None = None
    formula: Formula | None = None
    team: tuple[Group, ...] = ()
    swarm: SwarmRules | None = None
    text: str = ""
    seconds: float = 0.0
    where: Place = FORMULA
    wishes: dict[int, tuple[Formula, str] | None] = field(default_factory=dict)
    places: dict[tuple[Place, Formula], Span] = field(default_factory=dict)

    def read_map(self, folder: Path) -> TransitionSystem | None:
        """The map, inline or from the file beside the mission."""
        from tsplan.ts.read import load_map, map_from_document  # noqa: PLC0415  (slow to import)

        given = self.document.data.get("map") if isinstance(self.document.data, dict) else None
        if isinstance(given, dict):
            read = partial(map_from_document, self.document, ("map",))
        elif isinstance(given, str):
            read = partial(load_map, folder / given)
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

    def read_formulas(self) -> None:
        """The formula that must hold, and those that are preferred."""
        from tsplan.logic import TRUE  # noqa: PLC0415  (the parser is slow to import)

        spec = self.document.data.get("spec") if isinstance(self.document.data, dict) else None
        if not isinstance(spec, dict):
            return
        prefer = spec.get("prefer")
        wishes = prefer if isinstance(prefer, list) else []
        for number, wish in enumerate(wishes):
            if isinstance(wish, dict) and "formula" in wish:
                self.wishes[number] = self._formula_at(preferred(number))
        if "formula" in spec and "must" in spec:
            what = "the formula is there twice, as 'formula' and as 'must'"
            self._report(("spec", "must"), what, "keep one of them")
        self.where = ("spec", "must") if "must" in spec else FORMULA
        if self.where[-1] in spec:
            read = self._formula_at(self.where)
            self.formula, self.text = (None, "") if read is None else read
        elif wishes:
            self.formula, self.text = TRUE, "true"
        else:
            self._report(("spec",), "'formula' is missing", "add 'formula: ...'")

    def _formula_at(self, where: Place) -> tuple[Formula, str] | None:
        """A formula and its text; a list of texts means their conjunction."""
        from tsplan import logic  # noqa: PLC0415  (the parser is slow to import)

        given = self.document.at(where)
        entries = given if isinstance(given, list) else [given]
        paths: list[Place] = [
            (*where, n) if isinstance(given, list) else where for n in range(len(entries))
        ]
        if not entries:
            self._report(where, "the list of formulas is empty", "write true for no demand")
            return None
        texts = [self._text(entry, path) for entry, path in zip(entries, paths, strict=True)]
        parsed = [
            self._parsed(text, path, where)
            for text, path in zip(texts, paths, strict=True)
            if text is not None
        ]
        formulas = [formula for formula in parsed if formula is not None]
        if len(formulas) < len(entries):
            return None
        known = [text for text in texts if text is not None]
        text = known[0] if len(known) == 1 else " && ".join(f"({text})" for text in known)
        return formulas[0] if len(formulas) == 1 else logic.And(tuple(formulas)), text

    def _text(self, value: Any, path: Place) -> str | None:
        if isinstance(value, bool):
            return "true" if value else "false"
        if isinstance(value, str):
            return value
        self._report(path, "the formula is not a text", "write it in quotes or after a bar |")
        return None

    def _parsed(self, text: str, path: Place, where: Place) -> Formula | None:
        from tsplan.logic.parsing import parse_with_places  # noqa: PLC0415  (slow to import)

        language = str(self.document.data["spec"].get("language"))
        known = next((name for name in LANGUAGES if name == language), None)
        if known is None:
            return None  # an unknown language is the schema's finding
        try:
            formula, places = parse_with_places(text, known)
        except InputError as error:
            for item in error.findings:
                line, column = self.document.inside(path, item.line or 1, item.column or 1)
                self.findings.append(
                    replace(item, source=self.document.source, line=line, column=column)
                )
            return None
        for node, found in places.items():
            if found:
                self.places.setdefault((where, node), Span(path, text, found[0]))
        return formula

    def judge_kind(self) -> None:
        """Report what a mission file says of teams and swarms that it cannot be for at once."""
        for problem in kind_problems(self.document.data):
            line, column = self.document.key_place(problem.path)
            self.findings.append(
                Finding(problem.message, problem.remedy, self.document.source, line, column)
            )

    def read_agents(self, file: MissionFile) -> None:
        """The groups of the team or of the swarms, and the rules of swarms."""
        if file.swarm is not None:
            self.team = (self._swarm(file.swarm, "swarm", ("swarm",)),)
        elif file.swarms:
            self.team = tuple(
                self._swarm(entry, self._word(entry.name, ("swarms", n, "name")), ("swarms", n))
                for n, entry in enumerate(file.swarms)
            )
        else:
            self.team = self.read_team(file.team)
            return
        entries = [file.swarm] if file.swarm is not None else file.swarms
        names = [group.class_name for group in self.team]
        self.swarm = swarm_rules(names, entries, file.max_subswarms, file.margin)

    def _swarm(self, entry: Swarm, name: str, path: Place) -> Group:
        """A swarm as one group; of several, each has its name as capability."""
        if isinstance(self.document.at((*path, "at")), dict):
            starts = tuple(entry.at.items())
            for problem in total_problems(entry.size, starts, path):
                self._file(problem)
        else:
            (state,) = entry.at
            starts = ((self._word(state, (*path, "at")), entry.size),)
        return Group(name, frozenset() if path == ("swarm",) else frozenset({name}), starts)

    def read_team(self, members: Iterable[Member]) -> tuple[Group, ...]:
        """The groups of the team; names as they are written."""
        return tuple(self._group(member, ("team", n)) for n, member in enumerate(members))

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

    def judge(self, file: MissionFile) -> None:
        """Report what does not fit together, as far as the parts are known."""
        names, wishes = self.objective(file), self.preferences(file.spec.prefer)
        problems = objective_problems(names, self.swarm) + wish_problems(names, wishes, self.swarm)
        problems += team_problems(self.team, self.system, self.swarm)
        if self.system is not None:
            problems += map_problems(self.system, self.team)
        formulas = [(self.where, self.formula)]
        formulas += [(preferred(n), read and read[0]) for n, read in self.wishes.items()]
        for where, formula in formulas:
            if formula is not None:
                found = formula_problems(formula, self.system, self.team, self.swarm)
                _, empty = formula_horizon(formula, file.task_interval)
                found += empty or horizon_problems(formula, file.task_interval, file.horizon)
                problems += moved(found, where)
        for problem in problems:
            self._file(problem)

    def objective(self, file: MissionFile) -> tuple[str, ...]:
        """The objectives, by default those of the mission's kind."""
        if file.objective is not None:
            return objective_names(file.objective)
        return DEFAULT_OBJECTIVE if self.swarm is None else DEFAULT_SWARM_OBJECTIVE

    def preferences(self, wishes: Iterable[Wish]) -> tuple[Preference, ...]:
        """The preferences whose formulas could be read, named by their text if by nothing else."""
        made = []
        for number, wish in enumerate(wishes):
            read = self.wishes.get(number)
            if read is not None:
                formula, text = read
                place = ("spec", "prefer", number, "name")
                name = self._word(wish.name, place) if wish.name else text.strip()
                weight = Fraction(str(wish.weight))
                made.append(Preference(formula, text, weight, name, wish.level, wish.partial))
        return tuple(made)

    def _report(self, path: Place, message: str, remedy: str) -> None:
        self._file(Problem(path, message, remedy))

    def _file(self, problem: Problem) -> None:
        """Turn a problem into a finding at its place."""
        line, column = self.document.place(problem.path)
        span = self.places.get((problem.path, problem.node)) if problem.node is not None else None
        if span is not None:
            line, column = self.document.inside(span.path, *span.find(problem.word))
        finding = Finding(problem.message, problem.remedy, self.document.source, line, column)
        if finding not in self.findings:
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
            team=self.team,
            language=file.spec.language,
            text=self.text,
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
