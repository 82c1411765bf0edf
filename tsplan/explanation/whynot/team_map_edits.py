"""Ways to change a team and its map step by step, each making the mission easier."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass, replace
from typing import TYPE_CHECKING

from tsplan.explanation.agent_numbers import many
from tsplan.mission import Group
from tsplan.ts import Edge, TransitionSystem

if TYPE_CHECKING:
    from tsplan.explanation.explanation import ChangeKind
    from tsplan.mission import Mission


@dataclass(frozen=True)
class MoreAgents:
    """More robots like those of one entry of the team, at one state."""

    entry: int
    state: str
    most: int
    kind: ChangeKind = "add_agents"

    def applied(self, mission: Mission, amount: int) -> Mission:
        """The mission with a larger entry, or with an entry more if the state is a new one."""
        team = list(mission.team)
        group = team[self.entry]
        starts = dict(group.starts)
        if self.state in starts:
            starts[self.state] += amount
            team[self.entry] = Group(group.class_name, group.capabilities, tuple(starts.items()))
        else:
            team.append(Group(group.class_name, group.capabilities, ((self.state, amount),)))
        return replace(mission, team=tuple(team), warnings=())

    def words(self, mission: Mission, amount: int) -> str:
        """Which robots are added where."""
        return f"add {many(amount, mission.team[self.entry].class_name)} at '{self.state}'"


@dataclass(frozen=True)
class StateRoom:
    """A larger capacity of a state."""

    state: str
    most: int
    kind: ChangeKind = "loosen_limit"

    def applied(self, mission: Mission, amount: int) -> Mission:
        """The mission on a map with more room at the state."""
        system = mission.system
        states = [
            replace(state, capacity=(state.capacity or 0) + amount)
            if state.name == self.state
            else state
            for state in system.states.values()
        ]
        changed = TransitionSystem.build(states, system.edges.values(), system.name)
        return replace(mission, system=changed, warnings=())

    def words(self, mission: Mission, amount: int) -> str:
        """The capacity, from what to what."""
        now = mission.system.states[self.state].capacity or 0
        return f"raise the capacity of state '{self.state}' from {now} to {now + amount}"


@dataclass(frozen=True)
class EdgeRoom:
    """A larger capacity of an edge, of both its directions where they share it."""

    pair: tuple[str, str]
    most: int
    kind: ChangeKind = "edge"

    def applied(self, mission: Mission, amount: int) -> Mission:
        """The mission on a map with more room on the edge."""
        return _with_edge(
            mission, self.pair, lambda e: replace(e, capacity=(e.capacity or 0) + amount)
        )

    def words(self, mission: Mission, amount: int) -> str:
        """The capacity, from what to what."""
        now = mission.system.edges[self.pair].capacity or 0
        source, target = self.pair
        edge = f"the edge from '{source}' to '{target}'"
        return f"raise the capacity of {edge} from {now} to {now + amount}"


@dataclass(frozen=True)
class EdgeTime:
    """A quicker edge, in both its directions where they were written as one, for all classes."""

    pair: tuple[str, str]
    most: int
    kind: ChangeKind = "edge"

    def applied(self, mission: Mission, amount: int) -> Mission:
        """The mission on a map where the edge takes fewer steps, at least one."""
        return _with_edge(mission, self.pair, lambda edge: _quicker(edge, amount))

    def words(self, mission: Mission, amount: int) -> str:
        """By how much the edge must be quicker."""
        source, target = self.pair
        edge = mission.system.edges[self.pair]
        steps = "step" if amount == 1 else "steps"
        was = f" (now {edge.duration})" if isinstance(edge.duration, int) else ""
        return f"cross the edge from '{source}' to '{target}'{was} in {amount} {steps} less"


def _quicker(edge: Edge, amount: int) -> Edge:
    if isinstance(edge.duration, int):
        return replace(edge, duration=max(edge.duration - amount, 1))
    return replace(edge, duration={k: max(v - amount, 1) for k, v in edge.duration.items()})


def _with_edge(mission: Mission, pair: tuple[str, str], edit: Callable[[Edge], Edge]) -> Mission:
    system = mission.system
    pairs = {pair, *((pair[::-1],) if system.edges[pair].both_ways else ())}
    edges = [edit(edge) if edge.pair in pairs else edge for edge in system.edges.values()]
    changed = TransitionSystem.build(system.states.values(), edges, system.name)
    return replace(mission, system=changed, warnings=())
