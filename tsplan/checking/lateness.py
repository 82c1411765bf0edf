"""Who is where for certain, and who may be, where every agent is up to some steps late.

An agent that is up to n steps late at step k is where the plan has it at some step of
`max(0, k-n) .. k`, each agent independently and at every step anew. So an agent is at a state for
certain where the plan has it there throughout that window, and it may be there where the plan has
it there at some step of it. An agent is told by its own path: going from one state of a label to
another it is at neither for certain, and may be at both.

Of a swarm moves say only how many go where. Whoever came last to a state leaves it first, which any
agent can keep to by itself: so as many have been there throughout a window as waited there at each
of its steps. And nobody is taken to come back: so those may be there that are there, and all that
left within the window, which is never too few.
"""

from __future__ import annotations

from collections import defaultdict
from typing import TYPE_CHECKING, NamedTuple

from tsplan.plans.agent_plans import joined
from tsplan.plans.presence import Presence

if TYPE_CHECKING:
    from collections.abc import Iterable

    from tsplan.checking.path_segments import Segment
    from tsplan.plans.bundles import Bundle


class Late(NamedTuple):
    """Where agents are for certain, and where they may be."""

    sure: tuple[Presence, ...]
    possible: tuple[Presence, ...]


def late(bundles: Iterable[Bundle], delay: int) -> Late:
    """Where agents with some paths are when each is up to `delay` steps late.

    >>> from tsplan.plans.bundles import Bundle
    >>> stays = ((0, 0, "a"), (1, 4, "b"), (6, 9, "a"))
    >>> robot = Bundle("cart", frozenset(), stays, None, ("cart-1",))
    >>> sure, possible = late([robot], 2)
    >>> [presence[:3] for presence in sure]
    [('a', 0, 0), ('b', 3, 4), ('a', 8, 9)]
    >>> [presence[:3] for presence in possible]
    [('a', 0, 2), ('a', 6, 11), ('b', 1, 6)]
    """
    sure, possible = [], []
    for bundle in bundles:
        who = len(bundle.agents), bundle.capabilities
        own = list(joined(bundle.stays))
        for first, last, state in own:
            begin = first if first == 0 else first + delay
            if begin <= last:
                sure.append(Presence(state, begin, last, *who))
        lingering: dict[str, list[tuple[int, int]]] = defaultdict(list)
        for first, last, state in own:
            spans = lingering[state]
            if spans and first <= spans[-1][1] + 1:  # it is back before it is sure to be gone
                spans[-1] = spans[-1][0], last + delay
            else:
                spans.append((first, last + delay))
        possible += [
            Presence(state, *span, *who) for state, spans in lingering.items() for span in spans
        ]
    return Late(tuple(sure), tuple(possible))


def late_swarm(
    present: Iterable[Presence], segments: Iterable[Segment], delay: int, horizon: int
) -> Late:
    """Where the agents of a swarm are for certain and may be, by its moves.

    `present` has how many are at each state and step, `segments` are its moves one by one.
    """
    present = tuple(present)
    able = next((item.capabilities for item in present), frozenset[str]())
    waiting: dict[str, dict[int, int]] = defaultdict(dict)
    possible = [*present]
    for item in segments:
        state = item.edge.source
        if item.edge.is_wait and item.left == item.entered + 1:
            waiting[state][item.entered] = item.agents
        else:
            span = item.entered + 1, item.entered + delay
            possible.append(Presence(state, *span, item.agents, able))
    sure = [item for item in present if item.first == 0]
    for state, waits in waiting.items():
        for step in range(1, horizon + 1):
            stood = min(waits.get(before, 0) for before in range(max(0, step - delay), step))
            if stood:
                sure.append(Presence(state, step, step, stood, able))
    return Late(tuple(sure), tuple(possible))
