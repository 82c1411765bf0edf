"""The mission that is left at a step: from where everybody is, what of the formula is open.

It is a mission like any other, whose step 0 is that step: agents start where they are or on the
edge that they are on, the map is what it has become, and the formula is what progression leaves of
it (`tsplan.logic.progression`), so that whatever is planned, judged and explained of missions is of
the rest of one, too.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Sequence
from dataclasses import dataclass, replace
from typing import TYPE_CHECKING, NamedTuple

from tsplan.errors import Finding, MissionError, PlanError
from tsplan.history.changed_formula import changed_mission, parts_of
from tsplan.history.changed_map import Maps
from tsplan.history.module_places import modules_now
from tsplan.history.past_amounts import Amounts, Load, amounts_until
from tsplan.history.past_moves import presences, swarms_now
from tsplan.history.past_paths import Now, Past, whereabouts
from tsplan.history.path_traces import path_trace
from tsplan.history.present_room import with_present_room
from tsplan.history.rest_tasks import with_tasks
from tsplan.history.told_paths import Whereabouts
from tsplan.logic import CountTrace, Formula, progress
from tsplan.logic.unfolding import unfolded
from tsplan.mission import Group
from tsplan.mission.team import UnderWay
from tsplan.plans.structures import of_structures
from tsplan.plans.worlds import OnEdge

if TYPE_CHECKING:
    from tsplan.mission import Mission
    from tsplan.mission.resources import Carries
    from tsplan.name_runs import Run, RunMap
    from tsplan.plans.supplies import StockHistory
    from tsplan.plans.worlds import World


@dataclass(frozen=True)
class Rest:
    """The `mission` that is left at the step of the last of some `worlds`.

    `past` is what happened until then. `names` are, rank by rank, the robots that
    those of the mission are; `formula` is the whole one, judged at step 0 of the plan, `parts` has
    each of its parts that must hold with what is left of it, and `horizon` is the last step of the
    plan. `stocks` say what lay where before the step.
    """

    mission: Mission
    worlds: tuple[World, ...]
    past: Past
    names: tuple[tuple[Run, ...], ...]
    formula: Formula
    parts: tuple[tuple[Formula, Formula], ...]
    horizon: int
    stocks: tuple[StockHistory, ...] = ()

    @property
    def step(self) -> int:
        """The step of the plan at which the mission begins."""
        return self.worlds[-1].step


class NobodyLeftError(MissionError):
    """Everybody is lost at the step from which on it is to be planned again."""


def rest_of(mission: Mission, worlds: Sequence[World], past: Past) -> Rest:
    """What is left of a mission, given what happened until the last world's step.

    Raises PlanError for worlds that cannot be, MissionError for missions that cannot be planned
    again, and NobodyLeftError where nobody is left.
    """
    refuse_unknown_kinds(mission)
    if mission.modular and set(STABLE).intersection(objective_of(mission, worlds)):
        what = "which modules go on as planned is not told, since structures do"
        raise MissionError([Finding(f"{what}; 'stability' is of other robots", "name others")])
    step = worlds[-1].step
    mission = changed_mission(mission, worlds)
    formula, last = mission.formula, mission.horizon
    maps = Maps(mission.system, tuple(worlds))
    if step > last:
        what = f"the mission ends at step {last}, and it is to be planned again at step {step}"
        raise PlanError([Finding(what, "name a step of the plan")])
    past, amounts = accounted(mission, past._replace(built=past.built.by(last)), worlds, formula)
    loads = amounts.loads
    places = [
        *_loaded(whereabouts(mission, past.agents, worlds, maps), loads),
        *modules_now(mission, past, worlds, maps, loads),
    ]
    robots, names = _team(mission, places, step)
    swarms = tuple(swarms_now(mission, past.moves, worlds, maps))
    team = (*robots, *swarms)
    if not team:
        raise NobodyLeftError([Finding(f"nobody is left at step {step}", "add agents")])
    nobody = sum(len(swarm.starts) + len(swarm.coming) for swarm in swarms) * ((),)
    left = _Left(mission, past, step)
    made = replace(
        mission,
        system=with_present_room(maps.from_step(step), map(mission.modular.structures, team)),
        team=team,
        resources=amounts.left(mission.resources),
        formula=left.soft(formula) if mission.partial else left.of(formula),
        text="",
        objective=objective_of(mission, worlds),
        prefer=tuple(
            replace(soft, formula=left.soft(soft.formula), text="") for soft in mission.prefer
        ),
        horizon=last - step,
        warnings=(),
        origin=None,
    )
    demands = () if mission.partial else parts_of(formula)
    parts = tuple((part, left.of(part)) for part in demands)
    every = (*names, *nobody)
    return Rest(made, tuple(worlds), past, every, formula, parts, last, amounts.stocks)


def accounted(
    mission: Mission, past: Past, worlds: Sequence[World], formula: Formula
) -> tuple[Past, Amounts]:
    """What was carried and executed as far as that could be, and what has become of resources."""
    amounts = amounts_until(mission, past, worlds, formula)
    return past._replace(cargo=amounts.cargo, executions=amounts.executions), amounts


def _loaded(places: Iterable[Now], loads: RunMap[Load]) -> Iterator[Now]:
    """Robots in a row that carry the same, if they are under way."""
    for now in places:
        begin = 0
        for part, load in loads.parts(now.names) if isinstance(now.place, OnEdge) else ():
            begin += part.size
            yield now._replace(names=part, load=load or ())
        if not begin:
            yield now


STABLE = ("stability", "deviation")
"""Objectives for which it matters what was planned before."""


def objective_of(mission: Mission, worlds: Iterable[World]) -> tuple[str, ...]:
    """The objectives of the rest: those named last; after stability comes deviation."""
    named = mission.objective
    for world in worlds:
        named = world.objective or named
    if STABLE[0] not in named or STABLE[1] in named:
        return named
    place = named.index(STABLE[0]) + 1
    return (*named[:place], STABLE[1], *named[place:])


class _Left(NamedTuple):
    """What is left of the formulas of a mission at a step."""

    mission: Mission
    past: Past
    step: int

    def of(self, formula: Formula) -> Formula:
        """What is left of a formula that is judged at step 0 of the plan."""
        mission, step = self.mission, self.step
        counted = mission.counting(formula)
        if step:
            consumed = {each.name for each in mission.resources if each.consumed}
            counted = progress(counted, self._trace(counted), consumed)
        return with_tasks(counted, formula, mission)

    def soft(self, formula: Formula) -> Formula:
        """The same of a formula that may hold in part: a tree, all parts of which count."""
        tree = self.mission.tree(formula)
        if not self.step:
            return tree
        levels = self.mission.partial and self.mission.satisfaction != "weighted"
        try:
            return unfolded(tree, self._trace(tree), levels=levels)
        except ValueError as error:
            remedy = "ask for the weighted order, or plan its rest by hand"
            raise MissionError([Finding(str(error), remedy)]) from None

    def _trace(self, formula: Formula) -> CountTrace:
        """What has happened, as far as a formula is about it."""
        mission, past = self.mission, self.past
        others = *presences(mission, past.moves), *of_structures(past.built.structures)
        where = mission.system, formula, past.agents, self.step - 1
        return path_trace(*where, others=others, executions=past.executions)


def refuse_unknown_kinds(mission: Mission) -> None:
    """Raise MissionError for missions of which no rest can be told."""
    if mission.expected is not None:
        what = "a mission with expected numbers cannot be planned again"
        raise MissionError([Finding(what, "plan its rest by hand")])


def _team(
    mission: Mission, places: Iterable[Now], step: int
) -> tuple[tuple[Group, ...], tuple[tuple[Run, ...], ...]]:
    """The groups of a team that begins where everybody is, and rank by rank who they are."""
    kinds: dict[_Kind, dict[str | UnderWay, list[Run]]] = {}
    ordered = sorted(places, key=lambda now: isinstance(now.place, OnEdge))  # as ranks are
    for now in ordered:
        starts = kinds.setdefault(_kind(mission, now), {})
        starts.setdefault(_start(now.place, step, now.load), []).append(now.names)
    groups = tuple(
        Group.of(
            kind.class_name,
            [(start, sum(run.size for run in runs)) for start, runs in starts.items()],
            kind.capabilities,
            dict(kind.carries) if isinstance(kind.carries, tuple) else kind.carries,
            kind.configuration,
        )
        for kind, starts in kinds.items()
    )
    every = tuple(tuple(runs) for starts in kinds.values() for runs in starts.values())
    return groups, every


class _Kind(NamedTuple):
    """What tells the groups of a team apart."""

    class_name: str
    capabilities: frozenset[str]
    carries: Carries
    configuration: str | None


def _kind(mission: Mission, now: Now) -> _Kind:
    """The group that robots are of."""
    path, rank = now.path, mission.roster.get(now.names.name())
    alike = [group.carries for group in mission.team if group.class_name == path.class_name]
    carries = next(iter(alike), ()) if rank is None else mission.team[rank.group].carries
    return _Kind(path.class_name, path.capabilities, carries, now.configuration)


def _start(place: Whereabouts, step: int, load: Load) -> str | UnderWay:
    """Where somebody begins in a mission whose step 0 is a step of the plan."""
    if isinstance(place, str):
        return place
    return UnderWay(place.source, place.target, place.arrives - step, load)
