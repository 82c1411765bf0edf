"""What the search for an explanation asks of a mission, whatever kind of mission it is."""

from __future__ import annotations

from abc import ABC, abstractmethod
from collections.abc import Callable, Iterable, Iterator, Sequence
from dataclasses import dataclass
from functools import cached_property
from itertools import combinations
from typing import TYPE_CHECKING, Any, ClassVar, Generic, Self, TypeAlias, TypeVar

from tsplan.explanation.change_kinds import ORDER, ChangeKind
from tsplan.explanation.explanation import Likely, SoftConstraint
from tsplan.explanation.whynot.soft_constraints import formula_groups

if TYPE_CHECKING:
    from tsplan.explanation.explanation import Fact
    from tsplan.explanation.part_words import Wording
    from tsplan.explanation.whynot.least_shortage import Shortage
    from tsplan.explanation.whynot.mission_numbers import Edit, Number
    from tsplan.plans.plan import Plan
    from tsplan.run.events import Event
    from tsplan.signals.result_check import AnyMission
    from tsplan.signals.trajectory import Trajectory

M = TypeVar("M", bound="AnyMission")

Constraints: TypeAlias = frozenset[SoftConstraint]
MOST_TRIED = 4
"""Conjuncts of a formula of which every two are tried by themselves."""

Question: TypeAlias = Any
"""What a planner is given: a mission, or a problem made of one."""


@dataclass(frozen=True, eq=False)
class Subject(ABC, Generic[M]):
    """One mission that is to be explained: what it consists of, and how its planner is asked.

    `pause` is called between parts of longer work, and raises where that is to end. With
    `certified` a planner's "no" counts only if no solver's word is needed for it.
    """

    mission: M
    pause: Callable[[], None] = lambda: None
    certified: bool = False
    orders: ClassVar[tuple[Sequence[ChangeKind], ...]] = (ORDER,)
    """The kinds of changes that are tried together, one choice of them after the other."""

    def about(self, mission: M) -> Self:
        """Another mission of the same kind."""
        return type(self)(mission, self.pause, self.certified)

    @property
    def restrained(self) -> bool:
        """Whether more agents can do harm."""
        return False

    # --- what can be taken out -------------------------------------------------------------------

    @cached_property
    def groups(self) -> tuple[tuple[SoftConstraint, ...], ...]:
        """The parts of the formula, those of one conjunct together, in the order of the text."""
        return formula_groups(self.mission)

    @property
    @abstractmethod
    def bounds(self) -> tuple[SoftConstraint, ...]:
        """Everything else that can be taken out, what matters most to people first."""

    @property
    @abstractmethod
    def wording(self) -> Wording:
        """Words and places for what can be taken out."""

    # --- how its planner is asked ----------------------------------------------------------------

    @abstractmethod
    def plain(self) -> M:
        """The mission that asks for no more than that its formula holds, as a whole."""

    @abstractmethod
    def without(self, gone: Iterable[SoftConstraint]) -> Question:
        """The plain mission without some of its constraints."""

    def needless(self, gone: Constraints) -> Constraints:
        """Those of some constraints that say nothing anyway once all of them are taken out."""
        del gone
        return frozenset()

    def broken_by(self, gone: Constraints, question: Question, found: Any) -> Constraints:
        """Those of some constraints that what was found without them breaks, or may break."""
        del question, found
        return gone

    @abstractmethod
    def planned(
        self,
        question: Question,
        time_limit: float | None,
        solver: str | None,
        enough: Callable[[Event], bool] | None = None,
    ) -> Plan | Trajectory:
        """What the planner finds in some seconds, or until something it tells is `enough`."""

    # --- what is said of it ----------------------------------------------------------------------

    @abstractmethod
    def facts(self) -> Iterator[Fact]:
        """What forbids every plan and can be seen without a solver, as it is found."""

    def measured(self, ask: Callable[[Question], Any]) -> Iterator[Fact]:
        """What forbids every plan and takes a question to find."""
        del ask
        yield from ()

    def suspected(self) -> Iterator[Likely]:
        """What may be to blame where nothing is proven, the most likely first."""
        for group in self.groups:
            for part in self.wording.parts(frozenset(group)):
                yield Likely("conflict", part.text, part.place)

    def guesses(self, steps: Iterable[tuple[Edit, int]]) -> Iterator[Constraints]:
        """Constraints that may well be impossible together, where some changes would help.

        Of a few conjuncts each one is tried alone, then every two.
        """
        del steps
        if len(self.groups) <= MOST_TRIED:
            for number in (1, 2):
                for chosen in combinations(self.groups, number):
                    if len(chosen) < len(self.groups):
                        yield frozenset(
                            {part for group in chosen for part in group}.union(self.bounds)
                        )

    # --- what can be changed ---------------------------------------------------------------------

    @abstractmethod
    def candidates(self, conflict: Constraints) -> list[Edit]:
        """Everything that can be tried against one conflict, each once."""

    @abstractmethod
    def touched(self, number: Number) -> Constraints:
        """What an edit of a number weakens at most; nothing where that cannot be said."""

    def shortage(self, edits: Sequence[Edit]) -> Shortage | None:
        """By how little some edits may do together, as a problem; None where there is none."""
        del edits
        return None

    def rank(self, number: Number) -> int:
        """Of edits of a kind, those of a larger rank are tried where smaller ones do not help."""
        del number
        return 0

    def guessed(self, edit: Edit, ask: Callable[[Question], Any]) -> int | None:
        """An amount by which the edit may just do, from what a planner finds; None for no idea."""
        del edit, ask
        return None
