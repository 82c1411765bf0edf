"""The agents of a plan, those of one class on one path as one bundle however many they are.

What is asked of all agents is asked of their bundles; a single agent is made when it is looked at.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass, replace
from typing import NamedTuple

from tsplan.name_runs import Names, Run, RunMap
from tsplan.plans.agent_plans import AgentPlan, Stay
from tsplan.plans.unfolded import Unfolded

_NOBODY = Names(())


@dataclass(frozen=True, slots=True)
class Bundle:
    """Agents of one class that share one path; `agents` are their ids in the plan's order.

    Without agents it is a path that somebody may take.
    """

    class_name: str
    capabilities: frozenset[str]
    stays: tuple[Stay, ...]
    heading: str | None
    agents: Sequence[str] = _NOBODY
    coming: str | None = None

    def agent(self, name: str) -> AgentPlan:
        """One of the agents by itself."""
        own = self.class_name, self.capabilities, self.stays, self.heading, self.coming
        return AgentPlan(name, *own)


class Stretch(NamedTuple):
    """Agents that follow each other in a plan, named by a run, and their common path."""

    names: Run
    path: Bundle


@dataclass(frozen=True, eq=False, repr=False)
class Agents(Unfolded[AgentPlan]):
    """The agents of a plan in its order; equal to any sequence of the same agents.

    `bundles` are their distinct paths in order of first appearance, and `order` the agents one
    after the other, as many at a time as follow each other in name, each run with its bundle's
    place.

    >>> first = AgentPlan("a-1", "a", frozenset(), ((0, 5, "p"),))
    >>> agents = Agents.of([first, replace(first, id="a-2")])
    >>> len(agents), agents[1].id, [(len(b.agents), b.stays) for b in agents.bundles]
    (2, 'a-2', [(2, ((0, 5, 'p'),))])
    """

    bundles: tuple[Bundle, ...]
    order: tuple[tuple[Run, int], ...] = ()

    @classmethod
    def of(cls, agents: Iterable[AgentPlan]) -> Agents:
        """The agents of any sequence."""
        return agents if isinstance(agents, Agents) else cls.along(_alone(agents))

    @classmethod
    def along(cls, stretches: Iterable[tuple[Run, Bundle]]) -> Agents:
        """The agents of some runs of names, each along a path; equal paths become one bundle."""
        number = _Numbering()
        ordered: list[tuple[Run, int]] = []
        for names, path in stretches:
            place = number(path)
            both = ordered[-1][0].continued(names) if ordered and ordered[-1][1] == place else None
            if both is None:
                ordered.append((names, place))
            else:
                ordered[-1] = both, place
        runs: list[list[Run]] = [[] for _ in number.paths]
        for names, place in ordered:
            runs[place].append(names)
        bundles = tuple(
            replace(path, agents=Names.joined(mine))
            for path, mine in zip(number.paths, runs, strict=True)
        )
        return cls(bundles, tuple(ordered))

    @property
    def stretches(self) -> Iterator[Stretch]:
        """The agents in order, as many at a time as follow each other in name and path."""
        return (Stretch(names, self.bundles[place]) for names, place in self.order)

    def only(self, chosen: Callable[[Bundle], bool]) -> Agents:
        """The agents of some bundles."""
        kept = {id(bundle) for bundle in self.bundles if chosen(bundle)}
        return Agents.along(each for each in self.stretches if id(each.path) in kept)

    def made(self, row: tuple[Run, int], name: str) -> AgentPlan:
        """The agent of a name."""
        return self.bundles[row[1]].agent(name)

    def __eq__(self, other: object) -> bool:
        if isinstance(other, Agents):
            return self.bundles == other.bundles and self.order == other.order
        return super().__eq__(other)

    __hash__ = Unfolded.__hash__

    def __repr__(self) -> str:
        return f"<{len(self):,} agents on {len(self.bundles):,} paths>"


class _Numbering:
    """Equal paths by one number; those that are one object are known without being compared."""

    def __init__(self) -> None:
        self.paths: dict[Bundle, int] = {}
        self._known: dict[int, tuple[int, Bundle]] = {}  # an object that is kept keeps its id

    def __call__(self, path: Bundle) -> int:
        known = self._known.get(id(path))
        if known is None:
            bare = replace(path, agents=_NOBODY) if path.agents else path
            known = self.paths.setdefault(bare, len(self.paths)), path
            self._known[id(path)] = known
        return known[0]


def _alone(agents: Iterable[AgentPlan]) -> Iterator[Stretch]:
    """Agents one by one; large teams share the objects of their stays, which tells most apart."""
    paths: dict[tuple[object, ...], Bundle] = {}
    for agent in agents:
        ends = agent.heading, agent.coming
        key = (agent.class_name, agent.capabilities, id(agent.stays), *ends)
        path = paths.get(key)
        if path is None:
            own = agent.class_name, agent.capabilities, agent.stays, agent.heading
            path = paths[key] = Bundle(*own, coming=agent.coming)
        yield Stretch(Run.of(agent.id), path)


class AgentsById(Mapping[str, AgentPlan]):
    """The agents of a plan by their ids, of an id that is there twice the last; made when asked."""

    def __init__(self, agents: Agents) -> None:
        self._agents = agents
        self._paths: RunMap[Bundle] = RunMap(agents.stretches)

    def __getitem__(self, name: str) -> AgentPlan:
        path = self._paths.get(name)
        if path is None:
            raise KeyError(name)
        return path.agent(name)

    def __iter__(self) -> Iterator[str]:
        names = (name for each in self._agents.stretches for name in each.names.names())
        return names if len(self) == len(self._agents) else iter(dict.fromkeys(names))

    def __len__(self) -> int:
        return len(self._paths)
