"""What a map file says, gathered part by part until it is a transition system."""

from __future__ import annotations

from abc import ABC, abstractmethod
from collections.abc import Iterable, Iterator
from dataclasses import dataclass, field
from typing import ClassVar

from tsplan.document import Document, Path, validated
from tsplan.document.validation import SchemaT
from tsplan.errors import Finding, MapError, in_order
from tsplan.ts.actions import Action, ActionFlaw, action_flaws
from tsplan.ts.edges import Edge, State
from tsplan.ts.system import Extras, TransitionSystem
from tsplan.ts.validity import Problem, problems

_SWAPPED = {"source": "target", "target": "source"}


@dataclass
class MapDraft(ABC):
    """What has been read so far of the map at `path`, and where each edge of it is written.

    A format says where its files list states and edges, and where the parts of an edge stand.
    """

    STATES: ClassVar[Path]
    EDGES: ClassVar[Path]
    ZONES: ClassVar[Path] = ("zones",)

    document: Document
    path: Path
    states: list[State] = field(default_factory=list)
    edges: list[Edge] = field(default_factory=list)
    actions: list[Action] = field(default_factory=list)
    zones: dict[str, int] = field(default_factory=dict)
    notes: list[Finding] = field(default_factory=list)
    findings: list[Finding] = field(default_factory=list)
    _origins: list[tuple[Path, bool]] = field(default_factory=list)  # and whether it is the reverse

    @abstractmethod
    def edge_part(self, path: Path, part: str) -> Path:
        """Where a field of the edge that is written at a path stands."""

    def state_path(self, name: str) -> Path:
        """Where a state is written."""
        return (*self.path, *self.STATES, name)

    def edge_path(self, index: int) -> Path:
        """Where the entry of a number in the list of edges is written."""
        return (*self.path, *self.EDGES, index)

    def part(self, schema: type[SchemaT], path: Path) -> SchemaT | None:
        """A part of the document by a schema; None, and findings, where it does not fit."""
        part, faults = validated(self.document, schema, path)
        self.findings += faults
        return part

    def refuse(self, path: Path, message: str, remedy: str) -> None:
        """Keep one more finding."""
        self.findings.append(self.document.finding(path, message, remedy))

    def add_edge(self, edge: Edge, path: Path, *, back: bool) -> None:
        """Take in the edge that is written at a path; with `back`, its reverse as well."""
        self.edges.append(edge)
        self._origins.append((path, False))
        if back:
            self.edges.append(edge.reverse())
            self._origins.append((path, True))

    def locate(self, problem: Problem) -> Finding:
        """A problem with its place in the document."""
        message, remedy = problem.message, problem.remedy
        if problem.kind == "state":
            path = self.state_path(self.states[problem.index].name)
            return self.document.key_finding(path, message, remedy)
        if problem.kind == "zone":
            path = (*self.path, *self.ZONES, list(self.zones)[problem.index])
            return self.document.finding(path, message, remedy)
        if problem.kind == "system":
            return self.document.finding((*self.path, *self.STATES), message, remedy)
        path, reverse = self._origins[problem.index]
        if problem.first is not None:
            line, _ = self.document.place(self._origins[problem.first][0])
            message = f"{message}, the first in line {line}"
        if problem.part is not None:
            part = _SWAPPED.get(problem.part, problem.part) if reverse else problem.part
            path = self.edge_part(path, part)
        return self.document.finding(path, message, remedy)

    def action_path(self, flaw: ActionFlaw) -> Path:
        """Where what is wrong with an action is written."""
        return (*self.path, *self.STATES, flaw.action.state)

    def locate_action(self, flaw: ActionFlaw) -> Finding:
        """What is wrong with an action, with its place in the document."""
        return self.document.key_finding(self.action_path(flaw), flaw.message, flaw.remedy)

    def system(
        self,
        name: str,
        more: Iterable[Edge] = (),
        extras: Extras | None = None,
        *,
        step_seconds: float | None = None,
        frame: str | None = None,
    ) -> TransitionSystem:
        """The map, with `more` edges than are listed; raises MapError with all that is wrong."""
        if self.findings:
            if self.states:  # else there is nothing that edges could fit to
                found = problems(self.states, self.edges, self.zones)
                self.findings += map(self.locate, found)
                self.findings += map(self.locate_action, action_flaws(self.states, self.actions))
            raise MapError(in_order(self.findings))
        return TransitionSystem.build(
            self.states,
            [*self.edges, *more],
            name,
            extras=extras,
            actions=self.actions,
            zones=self.zones,
            step_seconds=step_seconds,
            frame=frame,
            notes=in_order(self.notes),
            locate=self.locate,
            locate_action=self.locate_action,
        )


def written_once(system: TransitionSystem) -> Iterator[Edge]:
    """Every edge, of those that go both ways only the direction that comes first."""
    done = set()
    for pair, edge in system.edges.items():
        if edge.both_ways and (edge.target, edge.source) in done:
            continue
        done.add(pair)
        yield edge
