"""From a document to the parts of a mission, with every finding at its place in the file."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass, field, replace
from functools import partial
from pathlib import Path
from typing import Any

from tsplan.document import Document
from tsplan.document.files import beside
from tsplan.document.kinds import MISSION
from tsplan.document.validation import salvaged, validated
from tsplan.errors import InputError, MissionError
from tsplan.logic import Formula, parse_with_places
from tsplan.logic.weight_values import Weight
from tsplan.milp.solver_choice import SolverChoice
from tsplan.mission.booking_checks import Booked, booking_faults
from tsplan.mission.configuration_checks import (
    Building,
    carriers,
    module_faults,
    unperformed,
)
from tsplan.mission.configurations import ModuleRules
from tsplan.mission.costs import cost_faults
from tsplan.mission.expectation_checks import chance_faults, expectation_faults
from tsplan.mission.filing import Filing
from tsplan.mission.findings import Entry, Fault, Place, moved
from tsplan.mission.formula_checks import (
    formula_faults,
    formula_horizon,
    horizon_faults,
    weight_faults,
)
from tsplan.mission.formulas import spelled_out
from tsplan.mission.mission_checks import (
    delay_faults,
    late_faults,
    objective_faults,
    preference_faults,
)
from tsplan.mission.mission_parts import MissionParts
from tsplan.mission.mission_schema import (
    STAND_INS,
    Member,
    MissionFile,
    Swarm,
)
from tsplan.mission.module_entries import module_rules
from tsplan.mission.name_resolution import with_named_classes, with_named_configurations
from tsplan.mission.objectives import default_objective
from tsplan.mission.resource_checks import Carrying, resource_faults, spending_faults
from tsplan.mission.resources import Resource
from tsplan.mission.start_entries import starts_of
from tsplan.mission.team import (
    ONE_SWARM,
    Expectation,
    Group,
    SwarmBounds,
    SwarmRules,
    with_brought,
)
from tsplan.mission.team_checks import map_faults, team_faults
from tsplan.mission.vocabulary import ORDERS, WHO, Order, default_language
from tsplan.mission.weight_entries import settled, weights_in
from tsplan.ts import TransitionSystem
from tsplan.ts.io.map_files import load_map, map_from_document
from tsplan.ts.io.map_settings import is_reference, read_settings
from tsplan.words import nfc

MODULAR = ("configurations", "reconfigure", "performance")


@dataclass(frozen=True)
class Beside:
    """What a document cannot hold: a map, which it names then, and weights that are functions."""

    system: TransitionSystem | None = None
    weights: Mapping[str, Weight] = field(default_factory=dict)


_NOTHING = Beside()


def parts_from_document(document: Document, folder: Path, given: Beside = _NOTHING) -> MissionParts:
    """The parts of a mission from its document, but for what is given beside it."""
    strange = document.misfit((), MISSION)
    if strange is not None:
        raise MissionError([strange])
    if isinstance(document.data, dict):
        document = spelled_out(document, default_language(team="team" in document.data))
    file, findings = validated(document, MissionFile)
    draft = _Draft.of(document, findings)
    sound, faulty = (file, frozenset[str]()) if file else salvaged(document, MissionFile, STAND_INS)
    draft.judge_kind()
    draft.system = given.system if given.system is not None else draft.read_map(folder)
    draft.warn_of_choices()
    known = None if sound is None or "spec" in faulty else sound.spec.weights
    draft.weights = {**weights_in(document, known), **given.weights}
    draft.formulas.reading = partial(parse_with_places, weights=draft.weights)
    draft.formulas.read()
    draft.judge_rest(sound, faulty)
    draft.judge_weights(draft.weights)
    formula = draft.formulas.formula
    if draft.serious or file is None or draft.system is None or formula is None:
        raise MissionError(draft.in_order())
    return draft.parts(file, draft.system, formula)


@dataclass
class _Draft(Filing):
    """A mission while it is read: its parts as far as they are known, and what is wrong so far."""

    system: TransitionSystem | None = None
    entries: list[Entry] | None = None  # None where what is said of them is wrong
    swarm: SwarmRules | None = None
    resources: tuple[Resource, ...] | None = None  # as the entries
    modular: ModuleRules | None = None  # as the entries
    expected: Expectation | None = None
    horizon: int = 0
    weights: Mapping[str, Weight] = field(default_factory=dict)

    def read_map(self, folder: Path) -> TransitionSystem | None:
        """The map, inline or from the file beside the mission."""
        given = self.document.data.get("map") if isinstance(self.document.data, dict) else None
        read: Callable[[], TransitionSystem]
        if is_reference(given):
            read = partial(_named_map, self.document, ("map",), folder)
        elif isinstance(given, dict):
            read = partial(map_from_document, self.document, ("map",))
        elif isinstance(given, str):
            read = partial(load_map, beside(folder, given))
        else:
            if given is not None:
                what = "the map is neither a file name nor a map"
                self.report(("map",), what, "write the name of a map file")
            return None
        try:
            return read()
        except InputError as error:
            self.findings += error.findings
            what = "the map cannot be used, so labels and start states were not looked up in it"
            self.report(("map",), what, "correct the map first")
            return None

    def warn_of_choices(self) -> None:
        """Warn of what was chosen when the map was converted, where something can be done."""
        for note in () if self.system is None else self.system.notes:
            if note.remedy:
                spot = note.source, note.line, note.column
                fault = Fault(("map",), note.message, note.remedy, serious=False, at=spot)
                self.file(fault)

    def judge_kind(self) -> None:
        """Report what a mission file says of teams and swarms that does not go together."""
        if isinstance(self.document.data, dict):
            self.findings += [
                self.document.key_finding(*words) for words in misplaced(self.document.data)
            ]

    def read_agents(self, file: MissionFile) -> None:
        """The groups of the team and of the swarms, and the rules of swarms."""
        team: list[Entry] = [
            (("team", n), self._group(member, ("team", n))) for n, member in enumerate(file.team)
        ]
        taken: frozenset[str] = frozenset().union(*(group.capabilities for _, group in team))
        swarms: list[tuple[Place, str, Swarm]] = [
            (("swarms", n), self.word(entry.name, ("swarms", n, "name")), entry)
            for n, entry in enumerate(file.swarms)
        ]
        if file.swarm is not None:
            swarms = [(("swarm",), ONE_SWARM, file.swarm)]
        for path, name, entry in swarms:
            able = {nfc(name)} - taken if path[0] == "swarms" else set()
            able |= self._words(entry.capabilities, (*path, "capabilities"))
            team.append((path, self._swarm(entry, path, name, frozenset(able))))
        self.entries = team
        if swarms:
            each = {
                name: SwarmBounds(one.max_subswarms, one.min_subswarm) for _, name, one in swarms
            }
            self.swarm = SwarmRules(each, file.max_subswarms, file.margin)
        if file.dynamics == "expected":
            self.expected = Expectation(file.policy == "deterministic", file.margin)

    @property
    def rules(self) -> ModuleRules:
        """What modules can become, nothing where that is not known."""
        return self.modular or ModuleRules()

    @property
    def team(self) -> tuple[Group, ...] | None:
        """The groups, as far as they are known."""
        return None if self.entries is None else tuple(group for _, group in self.entries)

    def _swarm(self, entry: Swarm, path: Place, name: str, able: frozenset[str]) -> Group:
        starts = starts_of(entry.at, self.document, (*path, "at"), entry.size)
        total = sum(count for _, count in starts)
        if entry.size != total:
            what = f"the size is {entry.size:,} and the start states hold {total:,}"
            remedy = f"write {total} or correct the start states"
            self.report((*path, "size"), what, remedy)
        return Group.of(name, starts, able)

    def _group(self, member: Member, path: Place) -> Group:
        starts = starts_of(member.at, self.document, (*path, "at"), member.count)
        total = sum(count for _, count in starts)
        if member.count is not None and member.count != total:
            what = f"the count is {member.count} and the start states hold {total}"
            self.report((*path, "count"), what, f"leave the count out or write {total}")
        able = self._words(member.capabilities, (*path, "capabilities"))
        shape = member.configuration and self.word(member.configuration, (*path, "configuration"))
        name = self.word(member.class_name, (*path, "class"))
        group = Group.of(name, starts, able, configuration=shape)
        return replace(group, carries=member.carries)

    def read_resources(self, file: MissionFile) -> None:
        """The resources."""
        self.resources = tuple(
            Resource(
                self.word(entry.name, ("resources", number, "name")),
                tuple(entry.at.items()),
                entry.indivisible,
                entry.consumed,
            )
            for number, entry in enumerate(file.resources)
        )

    def _words(self, names: Sequence[str], path: Place) -> frozenset[str]:
        return frozenset(self.word(name, (*path, n)) for n, name in enumerate(names))

    def judge_rest(self, file: MissionFile | None, faulty: frozenset[str]) -> None:
        """Judge what a file says elsewhere than under its faulty keys."""
        if file is None:
            return
        if not faulty.intersection(WHO) and any(kind in self.document.data for kind in WHO):
            self.read_agents(file)
        if "resources" not in faulty:
            self.read_resources(file)
        if not faulty.intersection(MODULAR):
            self.modular = module_rules(file, self.document)
        self.judge(file)

    def _agent_faults(self, file: MissionFile) -> Iterator[Fault]:
        """What does not fit together in the agents, as far as they are known."""
        if self.entries is None:
            return
        formulas = [formula for _, formula in self.formulas.all()]
        named = with_named_classes(self.team or (), self.swarm, self.system, formulas)
        if self.modular is not None:
            self.modular = with_named_configurations(self.modular, named, self.system, formulas)
        places = (place for place, _ in self.entries)
        self.entries = list(zip(places, named, strict=True))
        names, prefer = self.objective(file), self.preferences(file.spec.prefer)
        yield from objective_faults(names, self.swarm)
        yield from preference_faults(names, prefer, self.swarm)
        yield from expectation_faults(
            self.expected,
            self.swarm,
            names,
            prefer,
            resources=bool(self.resources),
            modular=bool(self.rules),
        )
        yield from team_faults(self.entries, self.system, self.swarm, self.rules)
        if self.modular is not None:
            swarms = self.swarm is not None
            given = Building(self.modular, self.entries, self.system, names, swarms)
            yield from module_faults(given)
        if self.system is not None:
            yield from map_faults(self.system, named)
            yield from chance_faults(self.system, self.expected)

    def judge(self, file: MissionFile) -> None:
        """Report what does not fit together, as far as the parts are known."""
        faults = list(self._agent_faults(file))
        if self.resources is not None:
            faults += resource_faults(self._carrying(file), self.objective(file), self.swarm)
        faults += delay_faults(
            file.delay,
            self.objective(file),
            resources=bool(self.resources),
            expected=self.expected is not None,
            modular=bool(self.rules),
        )
        formulas = [formula for _, formula in self.formulas.all()]
        faults += booking_faults(self._booked(file), self.objective(file), formulas)
        if self.formulas.formula is not None:
            faults += unperformed(self.formulas.formula, self.rules)
        horizons = []
        for where, formula in self.formulas.all():
            known = self.team is not None and self.modular is not None
            team = self.rules.possible(self.team or ()) if known else None
            found = [*formula_faults(formula, self.system, team, self.swarm)]
            found += horizon_faults(formula, file.task_interval, file.horizon)
            whole = where == self.formulas.where and self.order(file, where) is None
            found += spending_faults(formula, self._carrying(file), whole=whole)
            faults += moved(found, where)
            horizons.append(formula_horizon(formula, file.task_interval) or 0)
        self.horizon = max(horizons, default=0) if file.horizon is None else file.horizon
        for fault in faults:
            self.file(fault)
        if not self.serious and self.system is not None and self.team is not None:
            names = self.objective(file)
            late = [*cost_faults(self.system, self.team, self.horizon, names, self.rules)]
            late += late_faults(file.delay, self.horizon)
            for where, formula in self.formulas.all():
                late += moved(weight_faults(formula, self.order(file, where)), where)
            for fault in late:
                self.file(fault)

    def _carrying(self, file: MissionFile) -> Carrying:
        entries = None if self.entries is None else carriers(self.entries, self.rules)
        known = self.resources
        if known is not None:
            known = with_brought(known, self.team or (), self.rules.sizes)
        return Carrying(known, entries, self.system, file.booking != "shared")

    def _booked(self, file: MissionFile) -> Booked:
        return Booked(
            file.booking,
            swarms=self.swarm is not None,
            delay=file.delay,
            expected=self.expected is not None,
        )

    def order(self, file: MissionFile, where: Place) -> Order | None:
        """The order in which the formula at a place may hold in part, None where it may not."""
        if where != self.formulas.where:
            return "weighted" if file.spec.prefer[int(where[-2])].partial else None
        in_part = "satisfaction" in self.objective(file)
        return objective_order(file.objective or ()) if in_part else None

    def objective(self, file: MissionFile) -> tuple[str, ...]:
        """The objectives, by default those of the mission's kind."""
        if file.objective is not None:
            return objective_names(file.objective)
        return default_objective(swarms=self.swarm is not None)

    def parts(self, file: MissionFile, system: TransitionSystem, formula: Formula) -> MissionParts:
        """The parts, when nothing serious is wrong."""
        solver: dict[str, Any] = file.solver.model_dump() if file.solver else {}
        return MissionParts(
            name=file.name,
            system=system,
            team=self.team or (),
            language=file.spec.language,
            text=self.formulas.text,
            formula=formula,
            horizon=self.horizon,
            objective=self.objective(file),
            task_interval=file.task_interval,
            solver=SolverChoice(**solver),
            swarm=self.swarm,
            resources=self.resources or (),
            modular=self.rules,
            expected=self.expected,
            delay=file.delay,
            booking=file.booking,
            satisfaction=objective_order(file.objective or ()),
            prefer=self.preferences(file.spec.prefer),
            weights=settled(self.weights),
            digest=self.document.digest,
            warnings=tuple(self.warnings),
            parse_seconds=self.formulas.seconds,
            origin=self.document,
        )


def _named_map(document: Document, path: Place, folder: Path) -> TransitionSystem:
    """The map of a file that a mission names, with what it says of reading it."""
    name, settings = read_settings(document, path)
    return load_map(beside(folder, name), settings)


def misplaced(data: Mapping[str, Any]) -> Iterator[tuple[Place, str, str]]:
    """Keys at the top of a mission file that are missing, too many, or belong elsewhere."""
    given = [kind for kind in WHO if kind in data]
    single = "swarm" in given and "swarms" not in given
    if not given:
        remedy = "add 'team: ...', or 'swarm: ...' for a swarm that may split"
        yield (), "'team' is missing", remedy
    if "swarm" in given and "swarms" in given:
        yield ("swarms",), "the mission has 'swarms' beside 'swarm'", "keep one of them"
    expected = data.get("dynamics") == "expected"
    if "margin" in data and given == ["team"] and not expected:
        what = "'margin' is head-room for a swarm, and this mission has a team"
        yield ("margin",), what, "remove it, or describe a swarm"
    if "policy" in data and not expected:
        what = "'policy' is about uncertain moves, and those of this mission are certain"
        yield ("policy",), what, "remove it, or add 'dynamics: expected'"
    if "max_subswarms" in data and given == ["team"]:
        what = "'max_subswarms' bounds swarms, and this mission has a team"
        yield ("max_subswarms",), what, "remove it, or describe a swarm"
    if "max_subswarms" in data and single:
        what = "'max_subswarms' stands here only to bound several swarms together"
        yield ("max_subswarms",), what, "write it inside 'swarm'"
    if "min_subswarm" in data:
        what = "'min_subswarm' is a bound of one swarm"
        yield ("min_subswarm",), what, "write it inside the swarm"


_ORDERED = {f"satisfaction: {order}": order for order in ORDERS}


def objective_names(objective: Iterable[str]) -> tuple[str, ...]:
    """The objectives without the order of satisfaction."""
    return tuple("satisfaction" if name in _ORDERED else name for name in objective)


def objective_order(objective: Iterable[str]) -> Order:
    """The order of satisfaction that is asked for."""
    return next((_ORDERED[name] for name in objective if name in _ORDERED), "weighted")
