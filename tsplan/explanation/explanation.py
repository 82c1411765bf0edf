"""What an explanation is made of: facts, conflicts and changes, each in the mission's own words."""

from __future__ import annotations

import json
from collections.abc import Iterable, Mapping
from dataclasses import dataclass, field, replace
from enum import StrEnum
from typing import TYPE_CHECKING, Any, Literal, NamedTuple, TypeAlias

from tsplan import display
from tsplan.display import Told
from tsplan.explanation.change_kinds import ORDER, ChangeKind
from tsplan.plans.known_mission import OfMission

if TYPE_CHECKING:
    from tsplan.explanation.whynot.mission_numbers import Edit
    from tsplan.run.problem import Problem
    from tsplan.signals.result_check import AnyMission

FORMAT = "tsplan-explanation/1"

PartKind: TypeAlias = Literal[
    "formula",
    "own",
    "team",
    "start",
    "carries",
    "stock",
    "booking",
    "waiting",
    "capacity",
    "zone",
    "swarm",
    "control",
    "limit",
    "signal",
]
Cut: TypeAlias = Literal["interrupt", "time_limit", "memory", "precision", "patience"]
"""Why something was not looked at to its end: the run was interrupted, its time was up, the
system's memory was, a solver's precision did not do, or one question took longer than its share of
the time."""


class Status(StrEnum):
    """What is known about the mission."""

    EXPLAINED = "explained"  # there is no plan, and facts or a conflict say why
    FEASIBLE = "feasible"  # there is a plan; facts say what is tight
    NO_ANSWER = "no_answer"  # the time was too short to know


class SoftConstraint(NamedTuple):
    """One thing that can be taken out of a mission: a part of its formula, a bound, a count.

    The key says which: the way to a sub-formula and the place of a task's need (or None), the
    number of a team's entry, the name of a resource, of a state or of a zone, the ends of an edge,
    a swarm and which bound, the number of an own constraint; over signals, the name of one that
    begins somewhere, of one with bounds and which end (0, 1), or the number of a limit.
    """

    kind: PartKind
    key: tuple[Any, ...]


@dataclass(frozen=True, slots=True)
class Place:
    """A place in the mission file, or, for a mission without one, in the text of its formula.

    The end, where it is known, is just after the last character.
    """

    line: int | None = None
    column: int | None = None
    end_line: int | None = None
    end_column: int | None = None


@dataclass(frozen=True, slots=True)
class Part:
    """A requirement in words: what `constraints` of the mission it stands for, and where it is."""

    kind: PartKind
    text: str
    place: Place = Place()
    constraints: frozenset[SoftConstraint] = field(default=frozenset(), repr=False)


@dataclass(frozen=True, slots=True)
class Fact:
    """Something that follows without a solver, and that already forbids every plan.

    `parts` are the requirements it follows from. For a mission that can be met, facts say what is
    tight (kinds `tight` and `slack`) and forbid nothing.
    """

    kind: str
    text: str
    place: Place = Place()
    parts: tuple[Part, ...] = field(default=(), repr=False)


@dataclass(frozen=True, slots=True)
class Conflict:
    """Requirements that cannot hold together.

    With `minimal`, leaving any one of them out makes the rest possible; solves proved both. What is
    `certified` takes no solver's word for it.
    """

    parts: tuple[Part, ...]
    minimal: bool
    certified: bool = False


@dataclass(frozen=True, slots=True)
class Change:
    """A change of the mission after which it can be met, by the least `amount`.

    With `proven`, a verified plan shows that the changed mission can be met, and it could not with
    less: with one less of a whole number, with `within` less of a real one. `mission` is the
    changed mission, or the problem of it where one with own constraints was explained. `steps` says
    how far each edit went. `fix` numbers changes as they are found.
    """

    kind: ChangeKind
    text: str
    amount: float
    proven: bool
    mission: AnyMission | Problem = field(repr=False, compare=False)
    steps: tuple[tuple[Edit, int], ...] = field(default=(), repr=False, compare=False)
    within: float = 1
    fix: int = field(default=0, compare=False)


@dataclass(frozen=True, slots=True)
class Likely:
    """What may be to blame, or may help: nothing proves it, as the time did not do.

    It is about a `conflict`, where no conflict could be proven, or about a `change`.
    """

    kind: Literal["conflict", "change"]
    text: str
    place: Place = Place()


Found: TypeAlias = Status | Fact | Conflict | Change | Likely
"""What is told as soon as it is found: the outcome, then facts, conflicts, changes, in this order;
of facts that take solves some come after the first conflict. Last comes what is likely."""


@dataclass(frozen=True)
class Explanation(OfMission["AnyMission"], Told):
    """Why a mission cannot be met and what would help; for one that can, what is tight.

    `str` is what `tsplan explain` prints, where the mission is known: `tsplan.explain` sees to it.

    `cut` says which stages (`facts`, `conflicts`, `changes`, `tight`, `slack`) were cut short, and
    why: there may be more than they found. What is `likely` stands for what they could not prove.
    """

    status: Status
    name: str
    facts: tuple[Fact, ...] = ()
    conflicts: tuple[Conflict, ...] = ()
    changes: tuple[Change, ...] = ()
    likely: tuple[Likely, ...] = ()
    timings: Mapping[str, float] = field(default_factory=dict)
    cut: Mapping[str, Cut] = field(default_factory=dict)

    def with_found(self, item: Found) -> Explanation:
        """The explanation with one thing more; whoever hears all that is found knows it all."""
        match item:
            case Status():
                return replace(self, status=item)
            case Fact():
                return replace(self, facts=(*self.facts, item))
            case Conflict():
                return replace(self, conflicts=(*self.conflicts, item))
            case Likely():
                return replace(self, likely=(*self.likely, item))
        return replace(self, changes=ranked([*self.changes, item]))

    def __str__(self) -> str:
        """What `tsplan explain` prints; without the mission it is the `repr`."""
        mission = self.known_mission()
        return repr(self) if mission is None else display.explanation_words(self, mission)

    def to_json(self) -> str:
        """The explanation as a `tsplan-explanation/1` document, with a line break at its end."""
        data = {
            "format": FORMAT,
            "status": str(self.status),
            "facts": [_located(fact) for fact in self.facts],
            "conflicts": [
                _sure(conflict)
                | {
                    "minimal": conflict.minimal,
                    "parts": [_located(part) for part in conflict.parts],
                }
                for conflict in self.conflicts
            ],
            "changes": [
                {
                    key: getattr(change, key)
                    for key in ("kind", "text", "amount", "proven", "within", "fix")
                }
                for change in self.changes
            ],
            "likely": [_located(likely) for likely in self.likely],
            "cut_short": dict(self.cut),
            "timings": dict(self.timings),
        }
        return json.dumps(data, indent=2, ensure_ascii=False, allow_nan=False) + "\n"


def _sure(conflict: Conflict) -> dict[str, bool]:
    return {"certified": True} if conflict.certified else {}


def ranked(changes: Iterable[Change]) -> tuple[Change, ...]:
    """The changes, smallest amounts first, each text once."""
    distinct = {change.text: change for change in changes}
    return tuple(
        sorted(distinct.values(), key=lambda item: (item.amount, ORDER.index(item.kind), item.text))
    )


def _located(said: Fact | Part | Likely) -> dict[str, Any]:
    """Words with their kind and place; places that are not known are null."""
    place = said.place
    return {"kind": said.kind, "text": said.text, "line": place.line, "column": place.column}
