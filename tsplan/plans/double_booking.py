"""Whether agents that are booked for tasks are enough for all that is executed at their state.

Where an agent serves one task alone, it is asked how many of the needs a largest flow from agents
to needs can meet; nothing is known here of how plans are made.
"""

from __future__ import annotations

from collections import Counter, defaultdict
from typing import TYPE_CHECKING, NamedTuple

if TYPE_CHECKING:
    from collections.abc import Collection, Iterable, Iterator, Mapping, Sequence

    from tsplan.mission.vocabulary import Booking
    from tsplan.plans.ledger import Use
    from tsplan.plans.presence import Presence


class Overbooked(NamedTuple):
    """Too few agents are at a state at a step for all the `uses` there; `words` say why."""

    state: str
    step: int
    uses: Sequence[Use]
    words: str

    def __str__(self) -> str:
        tasks = " and ".join(use.task.task for use in self.uses)
        return f"{tasks} are executed at {self.state} at step {self.step}: {self.words}"


def overbooked(
    uses: Sequence[Use], present: Iterable[Presence], booking: Booking
) -> Iterator[Overbooked]:
    """States and steps, in the order of steps, at which more is executed than agents can serve."""
    there: dict[str, list[Presence]] = defaultdict(list)
    for presence in present if booking != "shared" else ():
        there[presence.state].append(presence)
    short = _unserved if booking == "exclusive" else _crowded_labels
    for (state, step), running in (_running(uses) if booking != "shared" else {}).items():
        here = [item for item in there[state] if item.first <= step <= item.last]
        for words in short(running, here):
            yield Overbooked(state, step, running, words)


def _running(uses: Sequence[Use]) -> Mapping[tuple[str, int], list[Use]]:
    """What is executed at each state and step, in the order of steps."""
    found: dict[tuple[str, int], list[Use]] = defaultdict(list)
    for use in uses:
        for step in range(use.first, use.last + 1):
            found[use.state, step].append(use)
    return dict(sorted(found.items(), key=lambda item: (item[0][1], item[0][0])))


def _unserved(uses: Sequence[Use], present: Collection[Presence]) -> Iterator[str]:
    """Needs that cannot all be met by agents that serve one of them each."""
    asked: Counter[str] = Counter()
    for use in uses:
        asked.update(dict(use.task.needs))
    agents: Counter[frozenset[str]] = Counter()
    for item in present:
        agents[item.capabilities.intersection(asked)] += item.agents
    served = _served(agents, asked)
    if served < asked.total():
        needs = ", ".join(f"{number} with {name}" for name, number in asked.items() if number)
        yield (
            f"{needs} are needed, each agent for one task, and {served} of these "
            f"{asked.total()} can be there"
        )


def _served(agents: Mapping[frozenset[str], int], asked: Mapping[str, int]) -> int:
    """How many needs can be met: a largest flow from agents, by what they can, to needs."""
    import networkx as nx  # noqa: PLC0415  (slow to import)

    graph: nx.DiGraph[object] = nx.DiGraph()
    graph.add_nodes_from(("begin", "end"))
    for ability, number in agents.items():
        graph.add_edge("begin", ability, capacity=number)
        for name in ability:
            graph.add_edge(ability, (name,))
    for name, number in asked.items():
        graph.add_edge((name,), "end", capacity=number)
    return int(nx.maximum_flow_value(graph, "begin", "end"))


def _crowded_labels(uses: Sequence[Use], present: Collection[Presence]) -> Iterator[str]:
    """Capabilities of which the labels of a state need more than are there."""
    largest: dict[str, dict[str, int]] = defaultdict(dict)
    for use in uses:
        for name, number in use.task.needs:
            of = largest[name]
            of[use.task.label] = max(of.get(use.task.label, 0), number)
    for name, labels in largest.items():
        here = sum(item.agents for item in present if name in item.capabilities)
        if here < sum(labels.values()):
            parts = " and ".join(f"{number} for {label}" for label, number in labels.items())
            yield f"{parts} are needed with {name}, and {here} are there"
