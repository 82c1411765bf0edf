"""From a mission to its explanation: facts, conflicts, changes; or what is tight."""

from __future__ import annotations

import time
from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from contextlib import contextmanager, suppress
from dataclasses import dataclass, field, replace
from pathlib import Path
from types import MappingProxyType
from typing import TYPE_CHECKING, Any, NamedTuple, TypeAlias, get_args

from tsplan.clock import Clock
from tsplan.errors import Finding, MissionError
from tsplan.explanation.explanation import (
    Change,
    Conflict,
    Cut,
    Explanation,
    Fact,
    Found,
    Likely,
    Status,
)
from tsplan.explanation.why.signal_tightness import tight_signals
from tsplan.explanation.why.tightness import deadline_slacks, slacks, tight_facts
from tsplan.explanation.whynot.change_search import ChangeSearch
from tsplan.explanation.whynot.changes import Repairs
from tsplan.explanation.whynot.conflict_search import PATIENCE, ConflictSearch
from tsplan.explanation.whynot.conflicts import Core, Finder
from tsplan.explanation.whynot.oracle import EnoughError, Oracle
from tsplan.explanation.whynot.posed_mission import PosedMission
from tsplan.explanation.whynot.signal_subject import Signals
from tsplan.explanation.whynot.team_subject import Teams
from tsplan.mission import Mission
from tsplan.parameters import refuse_options
from tsplan.process.interrupt import on_interrupt
from tsplan.process.quiet_output import audible, hushed_alone
from tsplan.run.problem import Problem
from tsplan.signals.signal_files import mission_given
from tsplan.signals.signal_mission import SignalMission

if TYPE_CHECKING:
    from tsplan.explanation.whynot.mission_numbers import Edit
    from tsplan.explanation.whynot.subject import Subject
    from tsplan.signals.result_check import AnyMission

Listener: TypeAlias = Callable[[str], object]

MOST_CONFLICTS = 10
"""Different conflicts that are looked for when all are asked for."""

_SHARE = 0.5  # of the time goes to facts at most
_SUSPECTED = 5  # changes that are named where they could not be tried
_FOR_FACTS = 1.0  # seconds that the search for facts gets at least
_REASONS: tuple[Cut, ...] = get_args(Cut)  # gravest first


def explain(
    mission: AnyMission | Problem | str | Path,
    *,
    conflicts: int = 1,
    slack: bool = False,
    time_limit: float | None = None,
    solver: str | None = None,
    certified: bool = False,
    on_stage: Listener | None = None,
    on_found: Callable[[Found], object] | None = None,
) -> Explanation:
    """Say why a mission cannot be met and what would help; or what is tight where it can be.

    The mission, for a team or over signals, may be the path of its file, or a `Problem` with own
    constraints, which can be in conflicts and be loosened; changed missions are problems then.

    Up to `conflicts` different conflicts are looked for. With `slack`, for a mission that can be
    met, it is found how much sooner each deadline could be. `time_limit` is in seconds; `on_stage`
    hears the stage of the work with every question of it, `on_found` each fact, conflict and change
    as it is found (`Found`). Ctrl-C and the time limit end the search with what is known; `cut`
    says what they kept from being looked at, `likely` what from being proven. With `certified` no
    solver's word is taken for it that something cannot be met; over signals there are no such
    answers.

    Raises SolverUnavailableError for a solver that cannot be used, SolverError if one fails, and
    InputError for a time limit out of range; MissionError for a mission over expected numbers.

    >>> import tsplan
    >>> made = tsplan.explain(tsplan.load_mission("mission.yaml"))
    >>> made.status.value, [[part.text for part in conflict.parts] for conflict in made.conflicts]
    ('feasible', [])
    >>> heard = []
    >>> made = tsplan.explain(tsplan.load_mission("mission.yaml"), on_found=heard.append)
    >>> heard[0].value, heard[1] == made.facts[0]
    ('feasible', True)
    """
    refuse_options(time_limit=time_limit)
    posed = mission if isinstance(mission, Problem) else None
    known = mission.mission if isinstance(mission, Problem) else mission_given(mission)
    if certified and isinstance(known, SignalMission):
        what = "there are no certified answers over signals"
        raise MissionError([Finding(what, "explain it without them")])
    if getattr(known, "expected", None) is not None:
        what = "why expected numbers cannot be met is not told"
        raise MissionError([Finding(what, "ask for less in the formula, or add agents")])
    limit = known.solver.time_limit if time_limit is None else time_limit
    hear = (audible(on_stage or (lambda _: None)), audible(on_found or (lambda _: None)))
    run = _Run(known, limit, solver, *hear, posed=posed, certified=certified)
    with on_interrupt(run.stop), hushed_alone():
        return run.explanation(conflicts, slack=slack).with_mission(known)


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
    found: Callable[[Found], object]
    certified: bool = False
    seconds: dict[str, float] = field(default_factory=dict)
    cut: dict[str, Cut] = field(default_factory=dict)
    cores: list[Core] = field(default_factory=list)
    possible: bool | None = None
    posed: Problem | None = None
    _stopped: bool = False
    _at: str = "facts"
    _work: ChangeSearch | None = None

    def __post_init__(self) -> None:
        self.clock = Clock(self.limit, lambda: self._stopped)
        self._kind = _KINDS[SignalMission if isinstance(self.mission, SignalMission) else Mission]
        asked = self.mission if self.posed is None else PosedMission.from_problem(self.posed)
        subject = self._kind.subject(asked, lambda: self.oracle.pause())  # noqa: PLW0108
        self.oracle = Oracle(
            replace(subject, certified=self.certified),
            self.clock,
            self.solver,
            stop=self.stop,
            asking=lambda: self.tell(self._at),
        )
        self.known = Explanation(Status.NO_ANSWER, self.mission.name)

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
        finder = Finder(self.oracle)
        search = ConflictSearch(finder, self.clock)
        with self._stage("conflicts"):
            self._find_conflict(search)
        if self.possible:
            self._feasible(slack=slack)
        elif self.cores:
            with self._stage("conflicts"):
                for core in finder.others(self.cores[0], most - 1):
                    self._conflict(core)
            with self._stage("facts"):
                for fact in self.subject.measured(self._asked):
                    self._hear(fact)
            with self._stage("changes"):
                self._find_changes(finder, search)
        self._suspect(search)
        return self._made()

    def _asked(self, question: Any) -> Any:
        return self.oracle.planned(question, self.oracle.patience)

    def _hear(self, item: Found) -> None:
        """Take in something that was found, and tell of it at once."""
        if isinstance(item, Change):
            if any(item.text == other.text for other in self.known.changes):
                return
            item = replace(item, fix=len(self.known.changes) + 1)
            if self.posed is not None and isinstance(item.mission, PosedMission):
                item = replace(item, mission=item.mission.over(self.posed))
        self.known = self.known.with_found(item)
        self.found(item)

    def _outcome(self, status: Status) -> None:
        if self.known.status is not status:
            self._hear(status)

    def _conflict(self, core: Core) -> None:
        """One that was not proven minimal may hold a smaller one, which is found later."""
        self._outcome(Status.EXPLAINED)
        self.cores = [c for c in self.cores if not core.constraints < c.constraints] + [core]
        parts = self.subject.wording.parts(core.constraints)
        self._hear(Conflict(parts, core.minimal, self.certified))

    def _find_facts(self) -> None:
        """Facts are an answer by themselves, so they get some time however short the limit is."""
        if self.clock.limit is not None:
            seconds = max(_SHARE * self.clock.limit, _FOR_FACTS)
            self.oracle.clock = replace(self.clock, limit=seconds)
        for fact in self.subject.facts():  # one by one: what is found before a stop stays
            self._outcome(Status.EXPLAINED)
            self._hear(fact)

    def _find_conflict(self, search: ConflictSearch) -> None:
        """Look for a conflict, and whether there is one at all."""
        core = search.among(self.known.facts)
        if core is None:
            self.possible = search.possible()
            if self.possible is False:
                self._outcome(Status.EXPLAINED)
                core = search.found()
        else:
            self.possible = False
        if core is not None:
            self._conflict(core)

    @contextmanager
    def _stage(self, stage: str) -> Iterator[None]:
        """A stage of the work: what it takes, and why it was cut short if it was."""
        self._at = stage
        self.tell(stage)
        self.oracle.unanswered.clear()
        began = time.perf_counter()
        with suppress(EnoughError):
            yield
        spent = time.perf_counter() - began
        self.seconds[stage] = self.seconds.get(stage, 0.0) + spent
        if reasons := sorted(self.oracle.unanswered, key=_REASONS.index):
            self.cut[stage] = reasons[0]

    def _made(self) -> Explanation:
        """What is known in the end."""
        parts = self.subject.wording.parts
        timings = {**self.seconds, "solve": self.oracle.seconds, "total": self.clock.elapsed}
        return replace(
            self.known,
            conflicts=tuple(
                Conflict(parts(c.constraints), c.minimal, self.certified) for c in self.cores
            ),
            timings={name: round(value, 6) for name, value in timings.items()},
            cut=self.cut,
        )

    def _feasible(self, *, slack: bool) -> None:
        """What is tight about a mission that can be met."""
        self.oracle.clock = self.clock
        self.known = replace(self.known, facts=())
        self._outcome(Status.FEASIBLE)
        with self._stage("tight"):
            for fact in self._kind.tight(self.oracle):
                self._hear(fact)
        if slack:
            with self._stage("slack"):
                for fact in self._kind.slacks(self.oracle):
                    self._hear(fact)

    # --- changes -----------------------------------------------------------------------------

    def _find_changes(self, finder: Finder, search: ConflictSearch) -> None:
        """Single changes that help, and several together; those that are found soonest first."""
        self.oracle.clock = self.clock
        self.oracle.patience = PATIENCE
        if self.clock.left is not None:
            self.oracle.patience = min(PATIENCE, self.clock.left / 4)
        repairs = Repairs(self.oracle, finder.everything, [core.constraints for core in self.cores])
        conflict = self.cores[0].constraints
        self._work = ChangeSearch(repairs, self.clock, conflict, search.shortage, self._hear)
        self._work.run()

    def _suspect(self, search: ConflictSearch) -> None:
        """Say what is likely where nothing could be proven."""
        self.oracle.clock = Clock(None)  # this is arithmetic alone
        if self.possible is None and not self.known.conflicts:
            for likely in self.subject.suspected():
                self._hear(likely)
        elif "changes" not in self.cut:
            return
        texts = []
        if not self.known.changes:
            texts = ["; and ".join(edit.words(amount) for edit, amount in search.shortage)]
        if self.cores:
            untried: Sequence[Edit] = [] if self._work is None else self._work.untried
            if not (untried or self.known.changes):  # not even what could be tried was known
                untried = self.subject.candidates(self.cores[0].constraints)
            texts += [edit.words(1) for edit in untried[:_SUSPECTED]]
        for text in dict.fromkeys(filter(None, texts)):
            self._hear(Likely("change", text))
