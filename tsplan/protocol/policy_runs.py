"""Agents that follow policies by chance, where the outcomes of their actions are by chance too.

Every agent draws its action by the policy of its class and the outcome by the action, independently
of all others. So those who leave a state at a step are a multinomial sample of those that are
there.
"""

from __future__ import annotations

from collections import Counter, defaultdict
from collections.abc import Iterator
from typing import TYPE_CHECKING

import numpy as np

if TYPE_CHECKING:
    from tsplan.milp.model import Ints
    from tsplan.mission import Mission
    from tsplan.plans.policies import Policy


def sampled_counts(
    mission: Mission, policy: Policy, random: np.random.Generator, runs: int
) -> Ints:
    """How many agents of one policy are where when, in each run: (runs, states, steps)."""
    row = {state: number for number, state in enumerate(mission.system.states)}
    counts = np.zeros((runs, len(row), mission.horizon + 1), dtype=np.int64)
    start: Counter[str] = Counter()
    for group in mission.team:
        if (group.class_name, group.capabilities) == (policy.class_name, policy.capabilities):
            start.update(dict(group.starts))
    for state, count in start.items():
        counts[:, row[state], 0] = count
    leaving: dict[int, list[str]] = defaultdict(list)
    taken = policy.taken
    for state, step in taken:
        leaving[step].append(state)
    for step in range(mission.horizon):
        for state in leaving[step]:
            ends, chances = zip(*_ends(mission, state, step, taken[state, step]), strict=True)
            shares = np.array(chances) / sum(chances)
            parts = random.multinomial(counts[:, row[state], step], shares)
            for (target, arrival), part in zip(ends, parts.T, strict=True):
                if arrival <= mission.horizon:
                    counts[:, row[target], arrival] += part
    return counts


def _ends(
    mission: Mission, state: str, step: int, actions: tuple[tuple[str, float], ...]
) -> Iterator[tuple[tuple[str, int], float]]:
    """Where and when an agent may end that acts at a state, and how likely that is."""
    for name, chance in actions:
        action = mission.system.actions[state, name]
        for target, likely in action.possible:
            yield (target, step + action.duration), chance * likely
