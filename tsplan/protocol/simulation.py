"""The distributed protocol: agents that go by chance, each with the planned probabilities.

Nobody tells the agents apart, and they do not communicate. An agent at a state at a step enters
each edge with the probability that is the planned fraction, `Plan.shares`, independently of all
others. So the agents that enter the edges of one state at one step are a multinomial sample of
those that are there, and agents are expected to be everywhere in the planned numbers.

Where the outcomes of actions are uncertain, agents follow the policies of the plan likewise
(`tsplan.protocol.policy_runs`), and the planned numbers are the expected ones.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from dataclasses import dataclass
from pathlib import Path
from typing import TYPE_CHECKING, Literal

import numpy as np

from tsplan.checking.class_traffic import ClassTraffic
from tsplan.checking.plan_check import check
from tsplan.checking.traffic import Traffic, read_traffic
from tsplan.display import Told
from tsplan.errors import Finding, PlanError
from tsplan.frequency import Frequency
from tsplan.logic import capabilities, holds
from tsplan.mission import Group, Mission
from tsplan.parameters import refuse_options
from tsplan.plans.count_traces import count_trace
from tsplan.plans.plan import Plan
from tsplan.plans.policies import expected_counts
from tsplan.plans.presence import state_counts
from tsplan.protocol.policy_runs import sampled_counts
from tsplan.signals.result_check import mixed_up, result_given
from tsplan.signals.signal_files import mission_given
from tsplan.words import number

if TYPE_CHECKING:
    from tsplan.checking.path_segments import Segment
    from tsplan.milp.model import Ints
    from tsplan.plans.moves import Node

_ENTRIES = 4_000_000  # counts of a batch of runs, which are kept at once


@dataclass(frozen=True, slots=True)
class Simulation(Told):
    """What came of many runs of the protocol; `str` tells it in words.

    `formula` tells how often the formula held, `bounds` how often every sub-swarm was large
    enough and there were never too many, at every step. `stray_max` is the largest and `stray_mean`
    the mean distance, in agents, between a swarm's number at a state at a step and the planned
    one, over all states and steps where the plan has agents. The chance is `by` the plan's shares,
    or its policies, which have no sub-swarms.
    """

    runs: int
    seed: int
    formula: Frequency
    bounds: Frequency
    stray_max: float
    stray_mean: float
    by: Literal["shares", "policies"] = "shares"

    def __str__(self) -> str:
        """What `tsplan simulate` prints of the runs."""
        runs = f"{self.runs:,} runs (seed {self.seed})"
        lines = [
            f"{runs}: every agent by chance, by the plan's {self.by}",
            f"the formula held in {self.formula}",
        ]
        if self.by == "shares":
            lines.append(f"the bounds on sub-swarms held in {self.bounds}")
        mean, most = f"{self.stray_mean:.2f} agents", number(round(self.stray_max, 2))
        lines.append(
            f"numbers at a state strayed from the plan by {mean} on average, at most by {most}"
        )
        return "\n".join(lines)


def simulate(
    mission: Mission | str | Path, plan: Plan | str | Path, *, runs: int = 1000, seed: int = 0
) -> Simulation:
    """Let every agent follow the plan's shares by chance, `runs` times.

    The mission and the plan may be the paths of their files.
    The work grows with the moves of the plan and the runs, not with the number of agents. The
    result is the same for equal seeds. Raises PlanError for a plan without moves of swarms, or
    policies, one that the independent check refuses, and ValueError for fewer runs than one
    and other numbers out of range.
    """
    if runs < 1:
        raise ValueError(f"at least one run is needed, not {runs}")
    refuse_options(runs=runs, seed=seed)
    known, result = mission_given(mission), result_given(plan)
    if not (isinstance(known, Mission) and isinstance(result, Plan)):
        raise PlanError([mixed_up(known, result)])
    return _simulated(known, result, runs, seed)


def _simulated(mission: Mission, plan: Plan, runs: int, seed: int) -> Simulation:
    chancy = plan.policies if mission.expected is not None else plan.moves
    if not chancy or (mission.swarm is None and mission.expected is None):
        what = "only plans of swarms, with their moves, and policies can be simulated"
        raise PlanError([Finding(what, "plan a mission with a swarm or with uncertain moves")])
    report = check(mission, plan)
    if report.ok and mission.expected is not None:
        return _by_policies(mission, plan, runs, seed)
    traffic, _ = read_traffic(mission, plan)
    if not report.ok or traffic is None:
        raise PlanError(report.findings)
    random = np.random.default_rng(seed)
    tallies = [_tally(traffic, random, size) for size in _batches(mission, runs)]
    places = max(sum(len(swarm.present) for swarm in traffic.swarms), 1)
    return Simulation(
        runs,
        seed,
        Frequency(sum(tally.holding for tally in tallies), runs),
        Frequency(sum(tally.bounded for tally in tallies), runs),
        max(tally.stray_max for tally in tallies),
        sum(tally.stray_sum for tally in tallies) / (runs * places),
    )


def _by_policies(mission: Mission, plan: Plan, runs: int, seed: int) -> Simulation:
    """Let every agent follow the policy of its class, `runs` times."""
    random = np.random.default_rng(seed)
    states = tuple(mission.system.states)
    tallies = [_policy_tally(mission, plan, random, size) for size in _batches(mission, runs)]
    places = sum(
        np.count_nonzero(expected_counts([policy], states, plan.horizon))
        for policy in plan.policies
    )
    return Simulation(
        runs,
        seed,
        Frequency(sum(tally.holding for tally in tallies), runs),
        Frequency(runs, runs),  # there are no sub-swarms
        max(tally.stray_max for tally in tallies),
        float(sum(tally.stray_sum for tally in tallies) / (runs * places)),
        "policies",
    )


def _policy_tally(mission: Mission, plan: Plan, random: np.random.Generator, runs: int) -> _Tally:
    states = tuple(mission.system.states)
    counts = {}
    for name in (None, *capabilities(mission.counted)):
        counts[name] = np.zeros((runs, len(states), mission.horizon + 1), dtype=np.int64)
    strays = []
    for policy in plan.policies:
        drawn = sampled_counts(mission, policy, random, runs)
        for name in counts:
            if name is None or name in policy.capabilities:
                counts[name] += drawn
        strays.append(np.abs(drawn - expected_counts([policy], states, plan.horizon)))
    held = holds(mission.counted, count_trace(mission.system, counts))[..., 0]
    most = max(float(stray.max()) for stray in strays)
    total_stray = float(sum(stray.sum() for stray in strays))
    return _Tally(int(np.sum(held)), runs, most, total_stray)


@dataclass(frozen=True, slots=True)
class _Tally:
    """How many runs of a batch held and kept the bounds, and how far their numbers strayed."""

    holding: int
    bounded: int
    stray_max: float
    stray_sum: float


def _batches(mission: Mission, runs: int) -> Iterator[int]:
    """Sizes of batches whose counts fit into memory."""
    entries = len(mission.system.states) * (mission.horizon + 1) * (len(mission.team) + 1)
    size = max(_ENTRIES // entries, 1)
    for begin in range(0, runs, size):
        yield min(size, runs - begin)


def _tally(traffic: Traffic, random: np.random.Generator, runs: int) -> _Tally:
    mission = traffic.mission
    samples = {}
    bounded = np.ones(runs, dtype=np.bool_)
    strays = []
    for swarm in traffic.swarms:
        bounds = mission.group_bounds(swarm.class_name)
        assert bounds is not None
        (group,) = (each for each in mission.team if each.class_name == swarm.class_name)
        counts, travelling = _sampled(swarm, group, random, runs)
        samples[swarm.class_name] = counts
        # never more sub-swarms than planned: nobody goes where the plan sends nobody
        for size in (*counts.values(), *travelling):
            bounded &= (size == 0) | (size >= bounds.least)
        strays += [np.abs(counts[p.state, p.first] - p.agents) for p in swarm.present]
    return _Tally(
        int(_holding(traffic, samples, runs).sum()),
        int(bounded.sum()),
        max((int(stray.max()) for stray in strays), default=0),
        float(sum(stray.sum() for stray in strays)),
    )


def _sampled(
    swarm: ClassTraffic, group: Group, random: np.random.Generator, runs: int
) -> tuple[dict[Node, Ints], list[Ints]]:
    """The numbers of a swarm in a batch of runs: at states and steps, and on long edges."""
    counts = {(p.state, p.first): np.zeros(runs, dtype=np.int64) for p in swarm.present}
    for state, step, agents in group.begins:
        if (state, step) in counts:
            counts[state, step] += agents
    leaving: dict[Node, list[Segment]] = {}
    for segment in swarm.segments:
        leaving.setdefault((segment.edge.source, segment.entered), []).append(segment)
    travelling = []
    for node in sorted(leaving, key=lambda node: node[1]):
        gone = [segment.agents for segment in leaving[node]]
        parts = random.multinomial(counts[node], [agents / sum(gone) for agents in gone])
        for segment, part in zip(leaving[node], parts.T, strict=True):
            arrival = (segment.edge.target, segment.left)
            if arrival in counts:
                counts[arrival] += part
            if segment.left - segment.entered > 1:
                travelling.append(part)
    return counts, travelling


def _holding(
    traffic: Traffic, samples: Mapping[str, Mapping[Node, Ints]], runs: int
) -> np.ndarray[tuple[int, ...], np.dtype[np.bool_]]:
    """In which runs the formula holds; robots beside the swarms go as planned."""
    mission = traffic.mission
    states = tuple(mission.system.states)
    row = {state: number for number, state in enumerate(states)}
    robots = [p for c in traffic.classes if c.class_name not in samples for p in c.present]
    counts = {}
    for name in (None, *capabilities(mission.counted)):
        planned = state_counts(robots, states, mission.horizon, name)
        counts[name] = np.repeat(planned[np.newaxis], runs, axis=0)
        for group in mission.team:
            if name is None or name in group.capabilities:
                for (state, step), agents in samples.get(group.class_name, {}).items():
                    counts[name][:, row[state], step] += agents
    return np.asarray(holds(mission.counted, count_trace(mission.system, counts))[..., 0])
