"""From a mission to its explanation: facts, conflicts, changes; or what is tight."""

from __future__ import annotations

import time
from collections.abc import Callable, Iterable, Iterator, Mapping
from contextlib import contextmanager, suppress
from dataclasses import dataclass, field, replace
from types import MappingProxyType
from typing import TYPE_CHECKING, Any, NamedTuple, TypeAlias, get_args

from tsplan.clock import Clock
from tsplan.errors import Finding, MissionError
from tsplan.explanation.explanation import Change, Conflict, Cut, Explanation, Fact, Status
from tsplan.explanation.why.signal_tightness import tight_signals
from tsplan.explanation.why.tightness import deadline_slacks, slacks, tight_facts
from tsplan.explanation.whynot.changes import Repairs, ranked
from tsplan.explanation.whynot.conflicts import Core, Finder
from tsplan.explanation.whynot.joint_repair import JointRepair
from tsplan.explanation.whynot.mission_numbers import ORDER
from tsplan.explanation.whynot.oracle import EnoughError, Oracle
from tsplan.explanation.whynot.signal_subject import Signals
from tsplan.explanation.whynot.team_subject import Teams
from tsplan.mission import Mission
from tsplan.parameters import refuse_options
from tsplan.process.interrupt import on_interrupt
from tsplan.process.quiet_output import audible, hushed_alone
from tsplan.signals.signal_mission import SignalMission

if TYPE_CHECKING:
    from tsplan.explanation.whynot.mission_numbers import Edit
    from tsplan.explanation.whynot.subject import Subject
    from tsplan.signals.result_check import AnyMission

Listener: TypeAlias = Callable[[str], object]

MOST_CONFLICTS = 10
"""Different conflicts that are looked for when all are asked for."""

_PATIENCE = 10.0  # seconds for one question about a part or a change
_ENOUGH = 3  # changes, if more would take longer than
_LONG = 20.0  # seconds and no time limit was set
_SHARE = 0.5  # of the time goes to facts at most, and of what is left to conflicts
_FOR_HANDING = 0.05  # of the time goes to saying what is known so far
_FOR_FACTS = 1.0  # seconds that the search for facts gets at least
_REASONS: tuple[Cut, ...] = get_args(Cut)  # gravest first


def explain(
    mission: AnyMission,
    *,
    conflicts: int = 1,
    slack: bool = False,
    time_limit: float | None = None,
    solver: str | None = None,
    on_stage: Listener | None = None,
    on_found: Callable[[Explanation], object] | None = None,
) -> Explanation:
    """Say why a mission cannot be met and what would help; or what is tight where it can be.

    Up to `conflicts` different conflicts are looked for. With `slack`, for a mission that can be
    met, it is found how much sooner each deadline could be. `time_limit` is in seconds;
    `on_stage` hears in words what is done, `on_found` what is known so far. Ctrl-C and the time
    limit end the search with what is known; `cut` says what they kept from being looked at.

    Raises SolverUnavailableError for a solver that cannot be used, SolverError if one fails, and
    InputError for a time limit out of range; MissionError for a mission over expected numbers.

    >>> import tsplan
    >>> made = tsplan.explain(tsplan.load_mission("mission.yaml"))
    >>> made.status.value, [[part.text for part in conflict.parts] for conflict in made.conflicts]
    ('feasible', [])
    """
    refuse_options(time_limit=time_limit)
    if getattr(mission, "expected", None) is not None:
        what = "why expected numbers cannot be met is not told"
        raise MissionError([Finding(what, "ask for less in the formula, or add agents")])
    limit = mission.solver.time_limit if time_limit is None else time_limit
    hear = (audible(on_stage or (lambda _: None)), audible(on_found or (lambda _: None)))
    run = _Run(mission, limit, solver, *hear)
    with on_interrupt(run.stop), hushed_alone():
        return run.explanation(conflicts, slack=slack)


class _Kind(NamedTuple):
    """A kind of missions: how they are asked about, and what is said of those that can be met."""

    subject: Callable[[Any, Callable[[], None]], Subject[Any]]
    tight: Callable[[Oracle], Iterable[Fact]]
    slacks: Callable[[Oracle], Iterator[Fact]]


_KINDS: Mapping[type, _Kind] = MappingProxyType(
    {
        Mission: _Kind(Teams, tight_facts, slacks),
        SignalMission: _Kind(Signals, tight_signals, deadline_slacks),
    }
)


@dataclass(eq=False)
class _Run:
    """One explanation in the making."""

    mission: AnyMission
    limit: float | None
    solver: str | None
    tell: Listener
    found: Callable[[Explanation], object]
    seconds: dict[str, float] = field(default_factory=dict)
    cut: dict[str, Cut] = field(default_factory=dict)
    facts: list[Fact] = field(default_factory=list)
    cores: list[Core] = field(default_factory=list)
    changes: list[Change] = field(default_factory=list)
    possible: bool | None = None
    _stopped: bool = False
    _handing: float = 0.0

    def __post_init__(self) -> None:
        self.clock = Clock(self.limit, lambda: self._stopped)
        self._kind = _KINDS[type(self.mission)]
        subject = self._kind.subject(self.mission, lambda: self.oracle.pause())  # noqa: PLW0108
        self.oracle = Oracle(subject, self.clock, self.solver, stop=self.stop)

    @property
    def subject(self) -> Subject[Any]:
        """The mission as it is asked about."""
        return self.oracle.subject

    def stop(self) -> None:
        """Ask no more questions."""
        self._stopped = True

    def explanation(self, most: int, *, slack: bool) -> Explanation:
        """Facts first, then the conflict, then changes."""
        with self._stage("facts"):
            self._find_facts()
        with self._stage("conflicts"):
            finder = Finder(self.oracle)
            self._find_conflict(finder)
        if self.possible:
            self._feasible(slack=slack)
        elif self.cores:
            with self._stage("conflicts"):
                for core in finder.others(self.cores[0], most - 1):
                    # one that was not proven minimal may hold a smaller one
                    kept = [c for c in self.cores if not core.constraints < c.constraints]
                    self.cores = [*kept, core]
            with self._stage("facts"):
                self.facts += self.subject.measured(self._asked)
            with self._stage("changes"):
                self.oracle.clock = self.clock
                self._find_changes(finder)
        return self._made()

    def _asked(self, question: Any) -> Any:
        return self.oracle.planned(question, self.oracle.patience)

    def _find_facts(self) -> None:
        """Facts are an answer by themselves, so they get some time however short the limit is."""
        if self.clock.limit is not None:
            seconds = max(_SHARE * self.clock.limit, _FOR_FACTS)
            self.oracle.clock = replace(self.clock, limit=seconds)
        for fact in self.subject.facts():  # one by one: what is found before a stop stays
            self.facts.append(fact)

    def _find_conflict(self, finder: Finder) -> None:
        """Look for a conflict, and whether there is one at all."""
        core = self._seeded(finder)
        self.possible = False
        if core is None:
            # questions about parts may take as long as the whole, or some seconds
            self.oracle.clock, self.oracle.patience = self.clock, None
            began = time.perf_counter()
            self.possible = self.oracle.without(())
            self._limit_questions(time.perf_counter() - began)
            core = finder.within(finder.everything) if self.possible is False else None
        self.cores += [] if core is None else [core]

    def _limit_questions(self, least: float) -> None:
        """Leave a share of the time to the changes."""
        self.oracle.patience = max(_PATIENCE, least)
        self.oracle.clock = self.clock
        if self.clock.left is not None:
            self.oracle.clock = self.clock.within(_SHARE * self.clock.left)

    @contextmanager
    def _stage(self, stage: str) -> Iterator[None]:
        """A stage of the work: what it takes, and why it was cut short if it was."""
        self.tell(stage)
        self.oracle.unanswered.clear()
        began = time.perf_counter()
        with suppress(EnoughError):
            yield
        spent = time.perf_counter() - began
        self.seconds[stage] = self.seconds.get(stage, 0.0) + spent
        if reasons := sorted(self.oracle.unanswered, key=_REASONS.index):
            self.cut[stage] = reasons[0]
        self._hand_over()

    def _hand_over(self) -> None:
        """Say what is known so far, unless that takes too much of the time."""
        if self._handing <= _FOR_HANDING * self.clock.elapsed:
            began = time.perf_counter()
            self.found(self._made())
            self._handing += time.perf_counter() - began

    def _seeded(self, finder: Finder) -> Core | None:
        """A conflict among what the first fact that solves do not contradict follows from.

        Where they are too slow to confirm it, its own proof stands.
        """
        self._limit_questions(0.0)
        for fact in self.facts:
            constraints = frozenset().union(*(part.constraints for part in fact.parts))
            core = finder.within(constraints)
            rest = finder.everything - constraints
            if core is None and self.oracle.without(rest) is None:
                self.oracle.learn_impossible(rest)
                core = finder.within(constraints)
            if core is not None:
                return core
        return None

    def _made(self) -> Explanation:
        """What is known so far."""
        known = Status.EXPLAINED if self.facts or self.cores else Status.NO_ANSWER
        parts = self.subject.wording.parts
        timings = {**self.seconds, "solve": self.oracle.seconds, "total": self.clock.elapsed}
        return Explanation(
            status=Status.FEASIBLE if self.possible else known,
            name=self.mission.name,
            facts=tuple(self.facts),
            conflicts=tuple(Conflict(parts(c.constraints), c.minimal) for c in self.cores),
            changes=ranked(self.changes),
            timings={name: round(value, 6) for name, value in timings.items()},
            cut=self.cut,
        )

    def _feasible(self, *, slack: bool) -> None:
        """What is tight about a mission that can be met."""
        self.oracle.clock = self.clock
        self.facts.clear()
        with self._stage("tight"):
            self.facts += self._kind.tight(self.oracle)
        if slack:
            with self._stage("slack"):
                for fact in self._kind.slacks(self.oracle):
                    self.facts.append(fact)

    # --- changes -----------------------------------------------------------------------------

    def _find_changes(self, finder: Finder) -> None:
        """Single changes that help; several together where none does."""
        repairs = Repairs(self.oracle, finder.everything, [core.constraints for core in self.cores])
        every = self.subject.candidates(self.cores[0].constraints)
        every.sort(key=lambda e: (ORDER.index(e.kind), self.subject.rank(e.number)))
        self.oracle.patience = _PATIENCE
        if self.clock.left is not None:
            self.oracle.patience = min(_PATIENCE, self.clock.left / 4)
        self._singles(repairs, every)
        if not self.changes:
            several = JointRepair(self.oracle, repairs)
            together = several.change(self.cores[0].constraints)
            self.changes += [together] if together is not None else []

    def _singles(self, repairs: Repairs, every: list[Edit]) -> None:
        began = time.perf_counter()
        helped: dict[int, int] = {}  # least rank at which more agents of an entry do
        quick = [(edit, edit.most) for edit in every if edit.number.kind == "edge"]
        for edit in every:
            enough = len(self.changes) >= _ENOUGH and time.perf_counter() - began > _LONG
            if enough and self.clock.limit is None:
                self.oracle.unanswered.add("patience")
                return
            kind, key = edit.number
            place = self.subject.rank(edit.number)
            if kind == "agents" and place > helped.get(key[0], place):
                continue
            if kind == "edge" and not repairs.possible(quick):
                continue  # not even all edges as quick as can be would do
            change = repairs.single(edit)
            if change is not None:
                self.changes.append(change)
                self._hand_over()
                if kind == "agents":
                    helped.setdefault(key[0], place)
