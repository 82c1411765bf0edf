"""Waiting: the states without it as an element of a mission, as facts and as changes."""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from dataclasses import dataclass, replace
from math import ceil, inf
from typing import TYPE_CHECKING

from tsplan.explanation.agent_numbers import agents, many
from tsplan.explanation.explanation import Element, Fact, Part, Place
from tsplan.ts.map_lint import listed
from tsplan.ts.reachability import usable
from tsplan.ts.waits import longest_ways, with_waits, without_wait

if TYPE_CHECKING:
    from tsplan.explanation.explanation import ChangeKind
    from tsplan.explanation.whynot.facts import View
    from tsplan.explanation.whynot.unconditional_demands import Demand
    from tsplan.mission import Group, Mission

WAITING = Element("waiting", ())
"""That nobody can wait at the states without an edge to themselves."""


def waiting_elements(mission: Mission) -> tuple[Element, ...]:
    """The element of a map on which agents cannot wait everywhere; nothing for others."""
    return (WAITING,) if without_wait(mission.system) else ()


def waiting_part(mission: Mission, place: Place) -> Part:
    """The element in words."""
    where = listed(without_wait(mission.system))
    text = f"nobody can wait at {where}: no edge leads from there to itself"
    return Part("waiting", text, place, frozenset({WAITING}))


# --- changes -----------------------------------------------------------------------------------


@dataclass(frozen=True)
class WaitAt:
    """An edge from one state to itself."""

    state: str
    most: int = 1
    kind: ChangeKind = "waiting"

    def applied(self, mission: Mission, amount: int) -> Mission:
        """The mission on a map where agents can wait at the state, if they could not yet."""
        return _waiting_at(mission, (self.state,) if amount else ())

    def words(self, mission: Mission, amount: int) -> str:
        """Where agents can wait."""
        return f"let agents wait at '{self.state}' (an edge from '{self.state}' to itself)"


@dataclass(frozen=True)
class WaitEverywhere:
    """Edges from every state to itself."""

    most: int = 1
    kind: ChangeKind = "waiting"

    def applied(self, mission: Mission, amount: int) -> Mission:
        """The mission on a map where agents can wait everywhere."""
        return _waiting_at(mission, mission.system.states if amount else ())

    def words(self, mission: Mission, amount: int) -> str:
        """What the map says then."""
        return "let agents wait at every state (`waiting: true` in the map)"


def _waiting_at(mission: Mission, names: Iterable[str]) -> Mission:
    chosen = set(names)
    missing = [name for name in without_wait(mission.system) if name in chosen]
    return replace(mission, system=with_waits(mission.system, missing), warnings=())


# --- facts -------------------------------------------------------------------------------------


def stuck(view: View) -> Iterator[Fact]:
    """Robots that cannot be anywhere at the end, whatever they do: all of their ways end before."""
    mission = view.mission
    for number, group in enumerate(mission.team):
        view.pause()
        moves = [*usable(mission.system, group.class_name, group.capabilities)]
        if len({edge.source for edge, _ in moves}) == len(mission.system.states):
            continue  # there is a way on from everywhere
        ways = longest_ways(moves)
        for state, count in group.starts:
            length, end = ways.get(state, (0, state))
            if count and length < mission.horizon:
                yield _stuck(view, number, (state, end), int(length))
                break


def _stuck(view: View, number: int, ways: tuple[str, str], length: int) -> Fact:
    """Of one entry of the team, that its ways from a state end after so many steps."""
    start, end = ways
    mission = view.mission
    whose = f"{many(1, mission.team[number].class_name)} that starts at '{start}'"
    there = "it cannot go on from there" if start == end else f"its longest way ends at '{end}'"
    wait = f", and nobody can wait at '{end}'" if end in without_wait(mission.system) else ""
    text = (
        f"{whose} can be nowhere after step {length}: {there}{wait}; the mission lasts "
        f"{mission.horizon} steps"
    )
    own = [Element("team", (number,)), Element("start", (number,))]
    teams = own if mission.swarm is None else []
    return view.fact("waiting", text, [], *waiting_elements(mission), *teams)


def restless(view: View) -> Iterator[Fact]:
    """Needs for several steps at a state where nobody can wait, and too few robots to take turns.

    Whoever leaves such a state is there again when the quickest way back is over, so that everybody
    can only be there at some of the steps.
    """
    nowhere = frozenset(without_wait(view.mission.system))
    for need in view.needs:
        view.pause()
        fixed = need.reach == "each" or len(need.states) == 1
        if not (nowhere and fixed and need.span.lasts):
            continue
        if view.mission.having(need.capability) < need.amount:
            continue  # too few even for one step: that is scarcity
        asked = need.amount * (need.span.lasts + 1)
        for state in need.states:
            most = _presences(view, need, state) if state in nowhere else asked
            if most < asked:
                text = (
                    f"{agents(need.amount, need.capability)} must be at '{state}' ({need.label}) "
                    f"for {need.span.lasts + 1} steps on end, and nobody can wait there: together "
                    f"the agents can be there {most} times at most, {asked} are needed"
                )
                able = view.team(need.capability, "team")
                yield view.fact("waiting", text, [need], WAITING, *able)
                break


def _presences(view: View, need: Demand, state: str) -> int:
    """At how many of the steps of a need the robots can be at its state, each counted, at most."""
    steps = need.span.lasts + 1
    return sum(
        group.count * max(1, ceil(steps / _back(view, group, state)))
        for group in view.mission.team
        if need.capability is None or need.capability in group.capabilities
    )


def _back(view: View, group: Group, state: str) -> float:
    """Fewest steps of a way from a state back to it, for robots like those of a group."""
    moves = usable(view.mission.system, group.class_name, group.capabilities)
    return min(
        (
            duration + view.arrivals.between(group, edge.target, state)
            for edge, duration in moves
            if edge.source == state and not edge.is_wait
        ),
        default=inf,
    )
