"""From a mission to its explanation: facts, conflicts, changes; or what is tight."""

from __future__ import annotations

import time
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from dataclasses import dataclass, field, replace
from typing import TYPE_CHECKING, TypeAlias

from tsplan.encode.clock import Clock
from tsplan.explanation.candidates import Candidate, candidates
from tsplan.explanation.changes import ORDER, Repairs, ranked
from tsplan.explanation.conflicts import Core, Finder
from tsplan.explanation.data import Change, Conflict, Explanation, Fact, Status
from tsplan.explanation.facts import View, find_facts
from tsplan.explanation.oracle import Oracle
from tsplan.explanation.several import Several
from tsplan.explanation.surroundings import EdgeTime
from tsplan.milp.hush import audible, hushed_alone
from tsplan.running import on_interrupt

if TYPE_CHECKING:
    from tsplan.mission import Mission

Listener: TypeAlias = Callable[[str], object]

MOST_CONFLICTS = 10
"""Different conflicts that are looked for when all are asked for."""

_PATIENCE = 10.0  # seconds for one question about a part or a change
_ENOUGH = 3  # changes, if more would take longer than
_LONG = 20.0  # seconds and no time limit was set
_SHARE = 0.5  # of the time goes to the conflicts at most


def explain(
    mission: Mission,
    *,
    conflicts: int = 1,
    slack: bool = False,
    time_limit: float | None = None,
    solver: str | None = None,
    on_stage: Listener | None = None,
) -> Explanation:
    """Say why a mission cannot be met and what would help; or what is tight where it can be.

    Up to `conflicts` different conflicts are looked for. With `slack`, for a mission that can be
    met, it is found how much sooner each deadline could be. `time_limit` is in seconds;
    `on_stage` hears in words what is done. Ctrl-C ends the search with what is known.

    Raises SolverUnavailableError for a solver that cannot be used, SolverError if one fails.

    >>> import tsplan
    >>> mission = tsplan.load_mission("mission.yaml")                   # doctest: +SKIP
    >>> for conflict in tsplan.explain(mission).conflicts:              # doctest: +SKIP
    ...     print([part.text for part in conflict.parts])
    """
    limit = mission.solver.time_limit if time_limit is None else time_limit
    run = _Run(mission, Clock(limit), solver, audible(on_stage or (lambda _: None)))
    with on_interrupt(run.oracle.stop), hushed_alone():
        return run.explanation(conflicts, slack=slack)


@dataclass(eq=False)
class _Run:
    """One explanation in the making."""

    mission: Mission
    clock: Clock
    solver: str | None
    tell: Listener
    seconds: dict[str, float] = field(default_factory=dict)

    def __post_init__(self) -> None:
        self.view = View.of(self.mission)
        self.oracle = Oracle(self.mission, self.clock, self.solver)

    def explanation(self, most: int, *, slack: bool) -> Explanation:
        """Facts first, then the conflict, then changes."""
        with self._timed("facts"):
            facts = find_facts(self.view)
        finder = Finder(self.oracle)
        with self._timed("conflicts"):
            core = self._seeded(finder, facts)
            possible = False if core is not None else self._asked_whole()
            if possible is False:
                core = core or finder.within(finder.everything)
        if possible:
            return self._feasible(slack=slack)
        if core is None:
            return self._made(Status.EXPLAINED if facts else Status.NO_ANSWER, facts, [], ())
        cores = [core]
        with self._timed("conflicts"):
            cores += finder.others(core, most - 1)
        with self._timed("changes"):
            self.oracle.clock = self.clock
            changes = self._changes(finder, cores)
        return self._made(Status.EXPLAINED, facts, cores, changes)

    def _asked_whole(self) -> bool | None:
        """Whether there is a plan; questions about parts may then take as long, or some seconds."""
        self.oracle.clock, self.oracle.patience = self.clock, None
        began = time.perf_counter()
        answer = self.oracle.without(())
        self._limit_questions(time.perf_counter() - began)
        return answer

    def _limit_questions(self, least: float) -> None:
        """Leave a share of the time to the changes."""
        self.oracle.patience = max(_PATIENCE, least)
        if self.clock.left is not None:
            self.oracle.clock = self.clock.within(_SHARE * self.clock.left)

    @contextmanager
    def _timed(self, stage: str) -> Iterator[None]:
        self.tell(stage)
        began = time.perf_counter()
        yield
        spent = time.perf_counter() - began
        self.seconds[stage] = self.seconds.get(stage, 0.0) + spent

    def _seeded(self, finder: Finder, facts: tuple[Fact, ...]) -> Core | None:
        """A conflict among what the first fact that solves do not contradict follows from.

        Where they are too slow to confirm it, its own proof stands.
        """
        self._limit_questions(0.0)
        for fact in facts:
            elements = frozenset().union(*(part.elements for part in fact.parts))
            core = finder.within(elements)
            rest = finder.everything - elements
            if core is None and self.oracle.without(rest) is None and not self.oracle.interrupted:
                self.oracle.learn_impossible(rest)
                core = finder.within(elements)
            if core is not None:
                return core
        return None

    def _made(
        self,
        status: Status,
        facts: tuple[Fact, ...],
        cores: list[Core],
        changes: tuple[Change, ...],
    ) -> Explanation:
        conflicts = tuple(
            Conflict(self.view.wording.parts(core.elements), core.minimal) for core in cores
        )
        timings = {**self.seconds, "solve": self.oracle.seconds, "total": self.clock.elapsed}
        rounded = {name: round(value, 6) for name, value in timings.items()}
        return Explanation(status, self.mission.name, facts, conflicts, changes, rounded)

    def _feasible(self, *, slack: bool) -> Explanation:
        """What is tight about a mission that can be met."""
        from tsplan.explanation.tightness import slacks, tight_facts  # noqa: PLC0415  (rarely needed)

        self.oracle.clock = self.clock
        with self._timed("tight"):
            facts = tight_facts(self.view, self.oracle)
        if slack:
            with self._timed("slack"):
                facts += slacks(self.view, self.oracle)
        return self._made(Status.FEASIBLE, facts, [], ())

    # --- changes -----------------------------------------------------------------------------

    def _changes(self, finder: Finder, cores: list[Core]) -> tuple[Change, ...]:
        """Single changes that help; several together where none does."""
        cores_known = [core.elements for core in cores]
        repairs = Repairs(self.oracle, finder.everything, cores_known)
        every = candidates(self.view, cores[0].elements)
        every.sort(key=lambda item: (ORDER.index(item.dimension.kind), item.rank))
        self.oracle.patience = _PATIENCE
        if self.clock.left is not None:
            self.oracle.patience = min(_PATIENCE, self.clock.left / 4)
        found = self._singles(repairs, every)
        if not found:
            several = Several(self.view, self.oracle, repairs)
            together = several.change(cores[0].elements)
            found = [together] if together is not None else []
        return ranked([replace(change, mission=self._whole(change)) for change in found])

    def _singles(self, repairs: Repairs, every: list[Candidate]) -> list[Change]:
        found: list[Change] = []
        began = time.perf_counter()
        helped: dict[tuple[str, int] | None, int] = {}
        quick = [item.dimension for item in every if isinstance(item.dimension, EdgeTime)]
        for candidate in every:
            enough = len(found) >= _ENOUGH and time.perf_counter() - began > _LONG
            if self.oracle.over or (enough and self.clock.limit is None):
                break
            if candidate.family and candidate.rank > helped.get(candidate.family, candidate.rank):
                continue
            if isinstance(candidate.dimension, EdgeTime) and not repairs.at_most(quick):
                continue
            change = repairs.single(candidate)
            if change is not None:
                found.append(change)
                helped.setdefault(candidate.family, candidate.rank)
        return found

    def _whole(self, change: Change) -> Mission:
        """The changed mission with everything that the solves left out."""
        return replace(change.mission, objective=self.mission.objective)
