"""Sub-swarms as lanes: from the moves of a swarm, groups that last until they split or merge."""

from __future__ import annotations

from collections import defaultdict
from collections.abc import Iterable, Mapping
from dataclasses import dataclass, field
from typing import TypeAlias

MoveTuple: TypeAlias = tuple[int, str, str, int]
"""`(step, source, target, count)`: so many agents enter this edge at this step."""

Stay: TypeAlias = tuple[int, int, str]


@dataclass(eq=False)
class Lane:
    """`count` agents that stay together: their stays, and the step from which they are no more.

    A lane that ends where others begin ends at the step at which they begin.
    """

    count: int
    end: int
    stays: list[Stay] = field(default_factory=list)

    def arrive(self, step: int, state: str) -> None:
        """Go on at a state from a step on; at the same state as before, stay on there."""
        if self.stays and self.stays[-1][1:] == (step - 1, state):
            self.stays[-1] = (self.stays[-1][0], step, state)
        else:
            self.stays.append((step, step, state))


def lanes(
    starts: Mapping[str, int],
    moves: Iterable[MoveTuple],
    durations: Mapping[tuple[str, str], int],
    horizon: int,
) -> tuple[Lane, ...]:
    """The lanes of one swarm, in the order they begin.

    `moves` name every edge entered at every step, waits included, as those of a swarm's plan do;
    `durations` has their edges. Where exactly one group comes to a state and goes on together, it
    keeps its lane; otherwise all that come end there and each that goes begins.

    >>> made = lanes({"p": 5}, [(0, "p", "p", 2), (0, "p", "q", 3), (1, "p", "q", 2)],
    ...              {("p", "p"): 1, ("p", "q"): 1}, 1)
    >>> [(lane.count, lane.stays) for lane in made]
    [(2, [(0, 1, 'p'), (2, 2, 'q')]), (3, [(0, 0, 'p'), (1, 1, 'q')])]
    """
    leaving: defaultdict[tuple[int, str], list[MoveTuple]] = defaultdict(list)
    for move in moves:
        leaving[move[0], move[1]].append(move)
    made: list[Lane] = []
    here: defaultdict[tuple[int, str], list[Lane]] = defaultdict(list)
    for state, count in starts.items():
        lane = Lane(count, horizon + 1, [(0, 0, state)])
        made.append(lane)
        here[0, state].append(lane)
    for (step, state), gone in sorted(leaving.items()):
        came = here[step, state]
        if len(came) == 1 and len(gone) == 1:
            going = came
        else:
            going = [Lane(move[3], horizon + 1, [(step, step, state)]) for move in sorted(gone)]
            made += going
            for lane in came:
                lane.end = step
        for lane, (_, _, target, _) in zip(going, sorted(gone), strict=True):
            arrival = step + durations[state, target]
            lane.arrive(arrival, target)
            here[arrival, target].append(lane)
    return tuple(lane for lane in made if lane.end > lane.stays[0][0])
