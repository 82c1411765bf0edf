"""The distributed protocol: agents that go by chance, each with the planned probabilities.

Nobody tells the agents apart, and they do not communicate. An agent at a state at a step enters
each edge with the probability that is the planned fraction, `Plan.shares`, independently of all
others. So the agents that enter the edges of one state at one step are a multinomial sample of
those that are there, and agents are expected to be everywhere in the planned numbers.
"""

from __future__ import annotations

import math
from collections.abc import Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass
from statistics import NormalDist
from typing import TYPE_CHECKING

import numpy as np

from tsplan.checking.count_traces import count_trace
from tsplan.checking.plan_check import check
from tsplan.errors import Finding, PlanError
from tsplan.limits import refuse_options
from tsplan.plans.moves import leaving, present

if TYPE_CHECKING:
    from tsplan.milp.model import Ints
    from tsplan.mission import Group, Mission
    from tsplan.plans.moves import Durations, Move, Node
    from tsplan.plans.plan import Plan

_ENTRIES = 4_000_000  # counts of a batch of runs, which are kept at once
_CONFIDENCE = 0.95


@dataclass(frozen=True, slots=True)
class Frequency:
    """How many of `runs` came out so, and an interval for the probability that one does.

    The interval is Wilson's score interval at 95 % (E. B. Wilson, "Probable inference, the law of
    succession, and statistical inference", J. Am. Stat. Assoc. 22, 1927).

    >>> half = Frequency(50, 100)
    >>> half.rate, round(half.low, 3), round(half.high, 3)
    (0.5, 0.404, 0.596)
    """

    times: int
    runs: int

    @property
    def rate(self) -> float:
        """The share of the runs."""
        return self.times / self.runs

    @property
    def low(self) -> float:
        """Lower end of the interval."""
        middle, half = self._interval()
        return max(middle - half, 0.0)

    @property
    def high(self) -> float:
        """Upper end of the interval."""
        middle, half = self._interval()
        return min(middle + half, 1.0)

    def _interval(self) -> tuple[float, float]:
        square = NormalDist().inv_cdf((1 + _CONFIDENCE) / 2) ** 2
        spread = square / self.runs
        middle = (self.rate + spread / 2) / (1 + spread)
        variance = self.rate * (1 - self.rate) * spread + spread**2 / 4
        return middle, math.sqrt(variance) / (1 + spread)


@dataclass(frozen=True, slots=True)
class Simulation:
    """What came of many runs of the protocol.

    `formula` tells how often the formula held, `bounds` how often every sub-swarm was large
    enough and there were never too many, at every step. `stray_max` is the largest and `stray_mean`
    the mean distance, in agents, between a swarm's number at a state at a step and the planned
    one, over all states and steps where the plan has agents.
    """

    runs: int
    seed: int
    formula: Frequency
    bounds: Frequency
    stray_max: int
    stray_mean: float


def simulate(mission: Mission, plan: Plan, *, runs: int = 1000, seed: int = 0) -> Simulation:
    """Let every agent follow the plan's shares by chance, `runs` times.

    The work grows with the moves of the plan and the runs, not with the number of agents. The
    result is the same for equal seeds. Raises PlanError for a plan without moves of swarms, or
    one that the independent check refuses, and ValueError for fewer runs than one
    and other numbers out of range.
    """
    if runs < 1:
        raise ValueError(f"at least one run is needed, not {runs}")
    refuse_options(runs=runs, seed=seed)
    if mission.swarm is None or not plan.moves:
        what = "only plans of swarms, with their moves, can be simulated"
        raise PlanError([Finding(what, "plan a mission with a swarm")])
    report = check(mission, plan)
    if not report.ok:
        raise PlanError(report.findings)
    random = np.random.default_rng(seed)
    flows = [_Flow.of(mission, group, plan.moves[group.class_name]) for group in mission.team]
    tallies = [_tally(mission, flows, random, size) for size in _batches(mission, runs)]
    places = sum(len(flow.planned) for flow in flows)
    return Simulation(
        runs,
        seed,
        Frequency(sum(tally.holding for tally in tallies), runs),
        Frequency(sum(tally.bounded for tally in tallies), runs),
        max(tally.stray_max for tally in tallies),
        sum(tally.stray_sum for tally in tallies) / (runs * places),
    )


@dataclass(frozen=True)
class _Flow:
    """What one swarm is to do: its moves by state and step, and the planned numbers there."""

    group: Group
    least: int
    durations: Durations
    leaving: Mapping[Node, tuple[Move, ...]]
    planned: Mapping[Node, int]

    @classmethod
    def of(cls, mission: Mission, group: Group, moves: Sequence[Move]) -> _Flow:
        assert mission.swarm is not None
        durations = {
            (move.source, move.target): mission.system.edges[move.source, move.target].duration_for(
                group.class_name
            )
            or 0
            for move in moves
        }
        return cls(
            group,
            mission.swarm.each[group.class_name].least,
            durations,
            leaving(moves),
            present(dict(group.starts), moves, durations, mission.horizon),
        )


@dataclass(frozen=True)
class _Sample:
    """The numbers of one swarm in a batch of runs: at states and steps, and on long edges."""

    present: Mapping[Node, Ints]
    travelling: tuple[Ints, ...]


@dataclass(frozen=True, slots=True)
class _Tally:
    """How many runs of a batch held and kept the bounds, and how far their numbers strayed."""

    holding: int
    bounded: int
    stray_max: int
    stray_sum: float


def _batches(mission: Mission, runs: int) -> Iterator[int]:
    """Sizes of batches whose counts fit into memory."""
    entries = len(mission.system.states) * (mission.horizon + 1) * (len(mission.team) + 1)
    size = max(_ENTRIES // entries, 1)
    for begin in range(0, runs, size):
        yield min(size, runs - begin)


def _tally(
    mission: Mission, flows: Sequence[_Flow], random: np.random.Generator, runs: int
) -> _Tally:
    samples = [_sampled(flow, random, runs) for flow in flows]
    pairs = list(zip(flows, samples, strict=True))
    bounded = np.ones(runs, dtype=np.bool_)
    for flow, sample in pairs:
        # never more sub-swarms than planned: nobody goes where the plan sends nobody
        for counts in (*sample.present.values(), *sample.travelling):
            bounded &= (counts == 0) | (counts >= flow.least)
    strays = [
        np.abs(sample.present[node] - count)
        for flow, sample in pairs
        for node, count in flow.planned.items()
    ]
    return _Tally(
        int(_holding(mission, pairs, runs).sum()),
        int(bounded.sum()),
        max(int(stray.max()) for stray in strays),
        float(sum(stray.sum() for stray in strays)),
    )


def _sampled(flow: _Flow, random: np.random.Generator, runs: int) -> _Sample:
    """A batch of runs of one swarm, step by step."""
    counts = {
        node: np.zeros(runs, dtype=np.int64) + (flow.planned[node] if node[1] == 0 else 0)
        for node in flow.planned
    }
    travelling = []
    for node in sorted(flow.leaving, key=lambda node: node[1]):
        moves = flow.leaving[node]
        total = sum(move.count for move in moves)
        parts = random.multinomial(counts[node], [move.count / total for move in moves])
        for move, part in zip(moves, parts.T, strict=True):
            duration = flow.durations[move.source, move.target]
            arrival = (move.target, move.step + duration)
            if arrival in counts:
                counts[arrival] += part
            if duration > 1:
                travelling.append(part)
    return _Sample(counts, tuple(travelling))


def _holding(
    mission: Mission, pairs: Iterable[tuple[_Flow, _Sample]], runs: int
) -> np.ndarray[tuple[int, ...], np.dtype[np.bool_]]:
    """In which runs the formula holds."""
    from tsplan.logic import capabilities, holds  # noqa: PLC0415  (the parser is slow to import)

    row = {state: number for number, state in enumerate(mission.system.states)}
    shape = (runs, len(row), mission.horizon + 1)
    named = (None, *capabilities(mission.counted))
    counts = {name: np.zeros(shape, dtype=np.int64) for name in named}
    for flow, sample in pairs:
        for name in named:
            if name is None or name in flow.group.capabilities:
                for (state, step), agents in sample.present.items():
                    counts[name][:, row[state], step] += agents
    return np.asarray(holds(mission.counted, count_trace(mission.system, counts))[..., 0])
