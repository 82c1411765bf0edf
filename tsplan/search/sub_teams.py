"""First plans of goals with many parts: teams of their own see to parts that lie close together.

The parts are sorted into clusters of places near each other, a small linear program gives each
cluster agents, as many times what it needs as all can have and those that are close, and every
cluster is planned apart. What the teams do is a plan of the whole, as nothing in such a goal is
bounded from above (`encode.goal_parts`). It proves nothing: agents of one team never help another.
"""

from __future__ import annotations

from collections import Counter
from collections.abc import Callable, Iterable, Sequence
from concurrent.futures import Executor
from dataclasses import dataclass, replace
from typing import Any, TypeAlias

import numpy as np
from scipy import sparse
from scipy.sparse.csgraph import dijkstra

from tsplan.clock import Clock, Halted
from tsplan.encode.assemble import tight
from tsplan.encode.encoded import Encoded, Point, Setting
from tsplan.encode.goal_parts import GoalPart, of_team, parts_of
from tsplan.encode.priced_objectives import Travel
from tsplan.encode.straight_ways import flows_in
from tsplan.errors import SolverError
from tsplan.milp.lp import WarmLP
from tsplan.milp.model import Bools, Draft, Floats, Ints
from tsplan.search.effort import Effort
from tsplan.search.search import Search

MANY = 30
"""Parts from which on a goal is planned by teams first."""

_SIZE = 16  # parts for one team: its linear programs take tenths of a second
_PLENTY = 2.0  # times its needs that a team may have before agents that are closer count more
_SCARCE = 1e4  # what lacking all agents costs, in steps of travel of one agent
_SHARE = 1 / 3  # of the time that is left, for all teams
_EACH = 5.0  # seconds for any plan of one of them

Cluster: TypeAlias = tuple[GoalPart, ...]


@dataclass(frozen=True, eq=False)
class SubTeams:
    """Plans the parts of a goal by teams, from `many` parts on, each of up to `size` of them.

    With an `executor`, which must be one of threads, teams are planned side by side.
    """

    effort: Effort
    executor: Executor | None = None
    many: int = MANY
    size: int = _SIZE

    def flows(self, encoded: Encoded, clock: Clock) -> Floats | None:
        """Flows of the whole model in a plan that teams find, or None."""
        setting = encoded.setting
        parts = parts_of(setting)
        if len(parts) < self.many:
            return None
        left = clock.left
        clock = clock if left is None else clock.within(_SHARE * left)
        clusters = clustered(setting, parts, self.size)
        given = zip(clusters, shared_out(setting, clusters), strict=True)
        teams = self._all_planned([Team(encoded, *each, self.effort, clock) for each in given])
        found = [flows_in(encoded, team.point) for team in teams if team.point is not None]
        flows = [part for part in found if part is not None]
        return np.asarray(sum(flows)) if flows and len(flows) == len(teams) else None

    def _all_planned(self, teams: list[Team]) -> list[Team]:
        """The teams with a plan each; those that find none are joined to others. Or none."""
        teams = list(self._map(Team.planned, teams, [_EACH] * len(teams)))
        while len(teams) > 1 and any(team.point is None for team in teams):
            teams.sort(key=lambda team: (team.point is not None, team.plenty))
            first, *others, richest = teams
            teams = [first.joined(richest).planned(_EACH), *others]
        return [team for team in teams if team.point is not None]

    @property
    def _map(self) -> Callable[..., Iterable[Any]]:
        return map if self.executor is None else self.executor.map


@dataclass(frozen=True, eq=False)
class Team:
    """Some parts of the goal of a whole model, for each class where its agents begin, and a plan.

    The plan is a `point` of a model of these parts alone, None where none is known.
    """

    whole: Encoded
    parts: Cluster
    starts: Sequence[Ints]
    effort: Effort
    clock: Clock
    point: Point | None = None

    @property
    def plenty(self) -> float:
        """How many times as many agents there are as the parts need together."""
        needs = sum(sum(part.needs.values()) for part in self.parts)
        return sum(int(start.sum()) for start in self.starts) / max(needs, 1)

    def joined(self, other: Team) -> Team:
        """Two teams as one, without a plan."""
        starts = [one + two for one, two in zip(self.starts, other.starts, strict=True)]
        return replace(self, parts=self.parts + other.parts, starts=starts, point=None)

    def planned(self, seconds: float) -> Team:
        """With any plan that is found in so many seconds."""
        clock = self.clock.within(seconds)
        try:
            setting = replace(self.whole.setting, clock=clock)
            own = tight(of_team(setting, self.parts, self.starts), self.whole.level)
            target = Travel().target(own.setting, own)
            search = Search(own, target, self.effort, clock, lambda *_: None)
            values = search.minimise(first=True).values
        except (Halted, SolverError):  # the whole is searched anyway
            return self
        return self if values is None else replace(self, point=Point(own, values, tight=True))


def clustered(setting: Setting, parts: Sequence[GoalPart], size: int) -> list[Cluster]:
    """The parts in clusters of at most `size`, each halved between the two that are furthest."""
    apart = _distances(setting, [part.states for part in parts], [part.states for part in parts])
    apart = np.maximum(apart, apart.T)
    done: list[Cluster] = []
    waiting = [np.arange(len(parts))]
    while waiting:
        members = waiting.pop()
        if len(members) <= size:
            done.append(tuple(parts[place] for place in members.tolist()))
            continue
        own = apart[np.ix_(members, members)]
        one, other = np.unravel_index(int(np.argmax(own)), own.shape)
        order = members[np.argsort(own[one] - own[other], kind="stable")]
        waiting += np.array_split(order, 2)
    return done


def shared_out(setting: Setting, clusters: Sequence[Cluster]) -> list[list[Ints]]:
    """For every cluster its agents: of each class how many begin at each state."""
    graphs = [item.graph for item in setting.classes]
    begun = [(g, int(q)) for g, graph in enumerate(graphs) for q in np.flatnonzero(graph.start)]
    supply = np.array([graphs[g].start[q] for g, q in begun])
    parts = [part for cluster in clusters for part in cluster]
    far = _distances(setting, [(state,) for _, state in begun], [part.states for part in parts])
    of = np.repeat(np.arange(len(clusters)), [len(cluster) for cluster in clusters])
    nearest = np.stack([far[:, of == number].min(axis=1) for number in range(len(clusters))], 1)
    draft = Draft()
    given = draft.columns(nearest.size, upper=np.repeat(supply, len(clusters)))
    given = given.reshape(nearest.shape)
    lack = draft.columns(2, lower=[1.0 - _PLENTY, 0.0], upper=1.0)
    whose = np.repeat(np.arange(len(begun)), len(clusters))
    draft.sums((whose, given.ravel(), 1.0), lower=supply, upper=supply, kind="supply")
    for number, cluster in enumerate(clusters):
        for name, amount in sum((part.needs for part in cluster), Counter()).items():
            able = given[_able(setting, begun, name), number]
            terms = (0, able, 1.0), (0, lack[:1], float(amount))
            draft.sums(*terms, lower=float(amount), kind="needs")
    for place, part in enumerate(parts):
        near = far[:, place] <= part.latest
        for name, amount in part.needs.items():
            able = given[_able(setting, begun, name) & near, of[place]]
            terms = (0, able, 1.0), (0, lack[1:], float(amount))
            draft.sums(*terms, lower=float(amount), kind="in time")
    cost = np.zeros(draft.column_count)
    cost[given.ravel()] = nearest.ravel()
    cost[lack] = _SCARCE * supply.sum() * np.array([1.0, len(parts)])
    values = WarmLP(draft.build().with_objective(cost)).solve().values
    assert values is not None  # all may be lacking
    return _teams(setting, begun, _rounded(values[given], supply))


def _able(setting: Setting, begun: Sequence[tuple[int, int]], name: str | None) -> Bools:
    """Which of the agents that begin somewhere have a capability."""
    graphs = [item.graph for item in setting.classes]
    return np.array([name is None or name in graphs[g].capabilities for g, _ in begun])


def _rounded(share: Floats, supply: Ints) -> Ints:
    """Whole numbers near shares, whose sums are those given: the largest remainders go up."""
    low = np.floor(share + 1e-6).astype(np.int64)
    for row, (least, whole) in enumerate(zip(low, supply.tolist(), strict=True)):
        order = np.argsort(least - share[row], kind="stable")
        low[row, order[: whole - int(least.sum())]] += 1
    return low


def _teams(setting: Setting, begun: Sequence[tuple[int, int]], given: Ints) -> list[list[Ints]]:
    teams = [[np.zeros_like(item.graph.start) for item in setting.classes] for _ in given[0]]
    for (number, state), row in zip(begun, given.tolist(), strict=True):
        for team, agents in zip(teams, row, strict=True):
            team[number][state] = agents
    return teams


def _distances(
    setting: Setting, ones: Sequence[Sequence[int]], others: Sequence[Sequence[int]]
) -> Floats:
    """Steps from each set of states to each other one, by the edges of all classes.

    More than twice the horizon is never told.
    """
    graphs = [base.graph for base in setting.reduced]
    tail, head, last = (
        np.concatenate([getattr(graph, name) for graph in graphs])
        for name in ("tail", "head", "duration")
    )
    order = np.argsort(last, kind="stable")  # of several edges between two states the quickest
    pairs, place = np.unique(np.stack([tail[order], head[order]]), axis=1, return_index=True)
    count = len(graphs[0].start)
    ways = sparse.csr_array((last[order][place], tuple(pairs)), shape=(count, count))
    sources = sorted({state for states in ones for state in states})
    steps = np.minimum(dijkstra(ways, indices=sources), 2.0 * setting.horizon)
    row = {state: number for number, state in enumerate(sources)}
    from_each = np.array([steps[[row[q] for q in states]].min(axis=0) for states in ones])
    return np.array([from_each[:, list(states)].min(axis=1) for states in others]).T
