"""Following a plan step by step, at a cost that does not grow with its length."""

from __future__ import annotations

from collections.abc import Mapping
from types import MappingProxyType

from tsplan.errors import Finding, InputError, PlanError
from tsplan.history.changed_formula import changed_mission
from tsplan.history.changed_map import Maps
from tsplan.mission import Mission
from tsplan.monitoring.agent_tracks import Position
from tsplan.monitoring.decisions import FAILS, HOLDS, OPEN
from tsplan.monitoring.fleet import Fleet, Shift
from tsplan.monitoring.outlook import Outlook
from tsplan.monitoring.part_formulas import MissionPart, parts_of
from tsplan.monitoring.planned_changes import Codes
from tsplan.monitoring.verdict import PartVerdict, Slack, Truth, Verdict
from tsplan.parameters import step_within
from tsplan.plans.plan import Plan

_TRUTHS: Mapping[int, Truth] = MappingProxyType({HOLDS: "holds", FAILS: "violated", OPEN: "open"})
_NOBODY: Mapping[str, Position] = MappingProxyType({})
_NO_COUNTS: Mapping[str, Mapping[str, int]] = MappingProxyType({})


class Monitor:
    """Follows a plan of a mission while it is carried out.

    After each step it says what is decided of the mission and of each of its parts, whether the
    plan as it stands still works, and how much there is to spare (`Verdict`).

    A part `holds` or is `violated` as soon as the counts so far decide it: by what has happened,
    window by window, and by there being no more agents than are left, each at one state. That no
    way of the agents could make it hold any more is not looked for; that needs planning. Agents
    that are not told of go on as they are taken to: by their paths, where they are late as soon as
    they can (each leaves a state at the step of its path, or at once where that has gone by), and
    not at all where they have strayed from their paths. Structures of modules are rebuilt as soon
    as all that go in are there. Tasks are executed as the plan says. Capacities are not watched.

    `agents` are the ids of the robots with paths and of the structures that there are at any step,
    and `states` those of the map, in the order of arrays of positions.

    Of a plan that was replanned the steps before are told of, too, and the parts are those that it
    was replanned for.

    Raises PlanError for a plan without paths or of another horizon, and for policies, by which
    nobody is expected anywhere.
    """

    def __init__(self, mission: Mission, plan: Plan) -> None:
        mission = changed_mission(mission, plan.replanned)
        _refuse(mission, plan)
        self._parts = parts_of(mission)
        self._outlook = Outlook(mission, plan, [part.goal for part in self._parts])
        self._fleet = Fleet(plan, mission.system.states, Maps(mission.system, plan.replanned).edges)
        self._horizon = plan.horizon
        self._now = -1
        self._told: list[PartVerdict] = []
        self._asked = [self._is_asked(mission, part) for part in self._parts]

    @property
    def agents(self) -> tuple[str, ...]:
        """The ids of the agents that have paths: robots, and structures of modules."""
        return self._fleet.agents

    @property
    def states(self) -> tuple[str, ...]:
        """The names of the map's states."""
        return self._fleet.states

    def update(
        self,
        step: int,
        positions: Mapping[str, Position] | Codes = _NOBODY,
        counts: Mapping[str, Mapping[str, int]] = _NO_COUNTS,
    ) -> Verdict:
        """What is to be said once it is known where agents are at a step.

        `positions` has by their ids the agents that are told of: at a state, on an edge of the map
        as `(from, to)`, or None for one that is lost from now on. Structures are told of by their
        ids or by one of their modules, and what is being rebuilt at a state as on the way from
        there to there, by what it will be. Instead it may be an array of
        whole numbers with one for each of `agents`: that of its state in `states`, -1 for one that
        is between two states, on the edge that its path has next, and -2 for one that is lost.
        `counts` has by the names of swarms the numbers of their agents at states at this step;
        where they are not told of, nobody of such a swarm is. The rest of a swarm's way is taken to
        go on as planned.

        Steps come one after the other from 0 on; those that are left out went as was expected.
        Raises InputError for a step that was told of before or is after the end of the plan, and
        for positions and counts that cannot be; then nobody is elsewhere than before, and the step
        can be told of again.
        """
        now = step_within(step, self._horizon)
        if now <= self._now:
            what = f"step {now} comes after step {self._now} was told of"
            raise InputError([Finding(what, "tell of steps one after the other")])
        self._outlook.refuse(counts, self._fleet.states)
        for earlier in range(self._now + 1, now):
            self._go_on(earlier, [], _NO_COUNTS)
        self._fleet.advance(now)
        self._go_on(now, self._fleet.see(positions, now), counts)
        return self._verdict()

    def _go_on(
        self, now: int, shifts: list[Shift], counts: Mapping[str, Mapping[str, int]]
    ) -> None:
        self._fleet.advance(now)
        self._outlook.advance(now, shifts, counts)
        self._now = now
        parts = enumerate(self._parts)
        self._told = [self._part(part, self._told[n] if self._told else None) for n, part in parts]

    def _is_asked(self, mission: Mission, part: MissionPart) -> bool:
        """Whether the plan works only if it meets a part; in part, those count that it meets."""
        met = self._outlook.slack(part.goal).agents >= 0
        return part.required and (met or not mission.partial)

    def _part(self, part: MissionPart, before: PartVerdict | None) -> PartVerdict:
        truth, slack = _TRUTHS[self._outlook.truth(part.goal)], self._outlook.slack(part.goal)
        if before is not None and before.truth == truth and before.slack == slack:
            return before
        decided = None if before is None else before.decided
        if decided is None and truth != "open":
            decided = self._now
        return PartVerdict(part.text, truth, slack, decided, part.required)

    def _verdict(self) -> Verdict:
        required = [part for part in self._told if part.required]
        truths = {part.truth for part in required}
        truth: Truth = "violated" if "violated" in truths else "open"
        asked = zip(self._told, self._asked, strict=True)
        works = all(part.slack.agents >= 0 for part, is_asked in asked if is_asked)
        slack = Slack(*map(min, zip(*(part.slack for part in required), strict=True)))
        truth = "holds" if truths == {"holds"} else truth
        return Verdict(self._now, truth, works, slack, tuple(self._told))


def _refuse(mission: Mission, plan: Plan) -> None:
    """Raise PlanError for what cannot be followed."""
    wrong = []
    if not plan.has_paths:
        wrong.append(Finding(f"a plan of status {plan.status} has no paths to follow"))
    elif plan.policies:
        what = "the plan has policies, by which no agent is expected anywhere"
        wrong.append(Finding(what, "follow a mission of certain moves"))
    elif plan.horizon != mission.horizon:
        what = f"the plan ends at step {plan.horizon} and the mission at step {mission.horizon}"
        wrong.append(Finding(what, "give the mission that the plan was made for"))
    if wrong:
        raise PlanError(wrong)
