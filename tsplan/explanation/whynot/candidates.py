"""Which changes may help against a conflict: those that touch one of its parts."""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from dataclasses import dataclass
from itertools import pairwise
from math import inf
from typing import TYPE_CHECKING

from tsplan.explanation.explanation import Element
from tsplan.explanation.whynot.elements import leaf_of, of_leaf
from tsplan.explanation.whynot.formula_edits import FORMULA_DIMENSIONS, Deadline, Dimension
from tsplan.explanation.whynot.occurrences import Leaf, leaves, node_at, nodes_along
from tsplan.explanation.whynot.relaxing import useful_number
from tsplan.explanation.whynot.swarm_edits import LooserBound
from tsplan.explanation.whynot.team_map_edits import EdgeRoom, EdgeTime, MoreAgents, StateRoom
from tsplan.explanation.whynot.waiting import WAITING, WaitAt, WaitEverywhere
from tsplan.logic import Count, Limit, Task
from tsplan.logic import labels as labels_of
from tsplan.ts.waits import without_wait

if TYPE_CHECKING:
    from tsplan.explanation.whynot.facts import View

MOST_PLACES = 6
"""States at which more robots are tried, for each entry of the team, and at which waits are."""

MOST_EDGES = 12
"""Edges that are tried, those on quickest ways first."""


@dataclass(frozen=True)
class Candidate:
    """A dimension that may help.

    It weakens nothing but `within`: if the mission cannot be met even without that, it does not
    help. Of one `family`, larger ranks are only worth trying where smaller ones do not help.
    """

    dimension: Dimension
    within: frozenset[Element]
    family: tuple[str, int] | None = None
    rank: int = 0


def candidates(view: View, conflict: frozenset[Element]) -> list[Candidate]:
    """Everything that can be tried against one conflict, each once."""
    found: dict[object, Candidate] = {}
    for element in sorted(conflict, key=repr):
        for candidate in _of(view, element, conflict):
            found.setdefault(candidate.dimension, candidate)
    return list(found.values())


def _of(view: View, element: Element, conflict: frozenset[Element]) -> Iterator[Candidate]:
    if element.kind == "formula":
        yield from _in_formula(view, leaf_of(element))
    elif element.kind in ("team", "start"):
        yield from _more_agents(view, element.key[0], conflict)
        if element.kind == "start":
            yield from _quicker(view, element.key[0], conflict)
    elif element.kind == "swarm":
        bound = LooserBound.of(view.mission, element)
        if bound is not None:
            yield Candidate(bound, frozenset({element}))
    elif element.kind == "waiting":
        yield from _waits(view, conflict)
    elif element.kind == "capacity":
        within = frozenset({element})
        if len(element.key) == 1:
            yield Candidate(StateRoom(element.key[0], view.mission.size), within)
        else:
            yield Candidate(EdgeRoom(element.key, view.mission.size), within)


def _in_formula(view: View, leaf: Leaf) -> Iterator[Candidate]:
    """Changes of the leaf itself and of the deadlines above it."""
    mission = view.mission
    was = view.wording.text(Leaf(view.wording.conjunct(leaf.way)))
    for kind in FORMULA_DIMENSIONS:
        dimension = kind.of(mission, leaf, was)
        if dimension is not None:
            yield Candidate(dimension, _below(view, dimension.leaf))
    for way, _ in nodes_along(mission.formula, leaf.way[:-1]):
        deadline = Deadline.of(mission, Leaf(way), was)
        if deadline is not None:
            yield Candidate(deadline, _below(view, Leaf(way)))


def _below(view: View, leaf: Leaf) -> frozenset[Element]:
    """A leaf, or all those of a sub-formula."""
    if leaf.pair is not None:
        return frozenset({of_leaf(leaf)})
    return frozenset(of_leaf(item) for item in leaves(view.mission.formula, leaf.way))


def _more_agents(view: View, entry: int, conflict: frozenset[Element]) -> Iterator[Candidate]:
    mission = view.mission
    group = mission.team[entry]
    most = useful_number(mission)
    own = [state for state, _ in group.starts]
    others = [state for other in mission.team for state, _ in other.starts]
    wanted = list(_states_of(view, conflict))
    open_ = [
        state
        for state in dict.fromkeys([*own, *others, *wanted])
        if mission.system.states[state].needs <= group.capabilities
    ]
    for state in open_[:MOST_PLACES]:
        within = {Element("team", (entry,))}
        if state not in own:
            within.add(Element("start", (entry,)))
        rank = 0 if state in own else 1 if state in others else 2
        dimension = MoreAgents(entry, state, most)
        yield Candidate(dimension, frozenset(within), ("agents", entry), rank)


def _waits(view: View, conflict: frozenset[Element]) -> Iterator[Candidate]:
    """Waits at single states: where the conflict needs somebody, at ends, at starts; and at all."""
    mission = view.mission
    missing = without_wait(mission.system)
    ends = (name for name in missing if not mission.system.leaving(name))
    starts = (state for group in mission.team for state, _ in group.starts)
    ordered = dict.fromkeys([*_states_of(view, conflict), *ends, *starts, *missing])
    within = frozenset({WAITING})
    for state in [name for name in ordered if name in set(missing)][:MOST_PLACES]:
        yield Candidate(WaitAt(state), within)
    yield Candidate(WaitEverywhere(), within)


def _states_of(view: View, conflict: Iterable[Element]) -> Iterator[str]:
    """The states that the conflict's needs speak about."""
    mission = view.mission
    for element in conflict:
        if element.kind != "formula":
            continue
        node = node_at(mission.formula, leaf_of(element).way)
        limit = isinstance(node, Limit) or (isinstance(node, Count) and node.relation == "<=")
        if isinstance(node, Task | Count) and not limit:
            yield from mission.system.labels[node.label]
        elif not limit:
            for label in labels_of(node):
                yield from mission.system.labels[label]


def _quicker(view: View, entry: int, conflict: frozenset[Element]) -> Iterator[Candidate]:
    """Edges on the quickest ways from where robots start to where the conflict needs them."""
    mission = view.mission
    group = mission.team[entry]
    pairs: dict[tuple[str, str], None] = {}
    targets = list(dict.fromkeys(_states_of(view, conflict)))
    for origin in [*(state for state, _ in group.starts), *targets]:
        for target in targets:
            if view.arrivals.between(group, origin, target) < inf:
                way = view.arrivals.way(group, origin, target)
                pairs.update(dict.fromkeys(pairwise(way)))
    for pair in list(pairs)[:MOST_EDGES]:
        edge = mission.system.edges[pair]
        longest = edge.duration if isinstance(edge.duration, int) else max(edge.duration.values())
        if longest > 1:
            yield Candidate(EdgeTime(pair, longest - 1), frozenset())
