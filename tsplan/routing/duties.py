"""Where each agent has to be, and where not, so that a formula goes on to hold as it does.

What settles the formula on the counts of a point is known atom by atom and step by step
(`tsplan.logic.obligations`). Of the agents that are where an atom wants some, as many as it asks
for are given the duty to be there at that step; what it bounds from above becomes a quota. Ways
that keep all duties and quotas keep the formula, by the same margin.
"""

from __future__ import annotations

from collections import defaultdict
from collections.abc import Iterator, Sequence
from dataclasses import dataclass, field
from typing import TypeAlias

import numpy as np

from tsplan.encode.atom_encoders import Bound, Requirement
from tsplan.encode.capability_mask import is_counted
from tsplan.encode.count_atoms import CountEncoder
from tsplan.encode.encoded import Point, Setting
from tsplan.encode.read_back import counts_of
from tsplan.logic import Count
from tsplan.logic.evaluation import margins
from tsplan.logic.obligations import START, obligations
from tsplan.milp.model import Bools, Ints
from tsplan.routing.crowd import Quota
from tsplan.routing.walks import Walk

Duties: TypeAlias = dict[int, Bools]
"""The states of which an agent has to be at one, by step."""


@dataclass(frozen=True, eq=False)
class Sharing:
    """Gives the agents of a point their duties; `level` is the availability to be kept."""

    setting: Setting
    walks: Sequence[Walk]
    level: int
    duties: list[Duties] = field(init=False)
    quotas: list[Quota] = field(default_factory=list, init=False)
    _where: Ints = field(init=False)

    def __post_init__(self) -> None:
        """Everybody is free at first."""
        classes = self.setting.classes
        where = [
            walk.states(classes[walk.number].graph, self.setting.horizon) for walk in self.walks
        ]
        object.__setattr__(self, "_where", np.array(where))
        object.__setattr__(self, "duties", [{} for _ in self.walks])

    def share(self, point: Point) -> None:
        """Give duties and quotas for all that settles the goal at a point."""
        setting = self.setting
        values = margins(setting.goal, counts_of(setting, setting.goal, point))
        encoder = CountEncoder(
            point.encoded.network, setting.mission.system, setting.arrays, self.level
        )
        for (atom, _), owed in obligations(setting.goal, START, values).items():
            if isinstance(atom, Count) and len(owed.steps):
                self._settle(encoder.requirement(atom), owed.steps)

    def _settle(self, requirement: Requirement, steps: Ints) -> None:
        wanted_few: dict[Bound, list[int]] = defaultdict(list)
        last: dict[Bound, list[int]] = {}
        for step in steps.tolist():
            for bound in self._chosen(requirement, step):
                if bound.upper:
                    wanted_few[bound].append(step)
                else:
                    last[bound] = self._appoint(bound, step, last.get(bound, []))
        for bound, when in wanted_few.items():
            states = np.array(bound.states, dtype=np.int64)
            able = frozenset(self._able(bound))
            self.quotas.append(Quota(states, able, np.array(when), bound.amount))

    def _chosen(self, requirement: Requirement, step: int) -> Iterator[Bound]:
        """The bounds that are to hold: all of them, or the first that does."""
        for bound in requirement.bounds:
            count = len(self._present(bound, step))
            if requirement.every:
                yield bound
            elif count <= bound.amount if bound.upper else count >= bound.amount:
                yield bound
                return

    def _able(self, bound: Bound) -> Iterator[int]:
        for number, item in enumerate(self.setting.classes):
            if is_counted(bound.capability, item.graph.capabilities):
                yield number

    def _present(self, bound: Bound, step: int) -> list[int]:
        """The agents that a bound counts at a step."""
        able = set(self._able(bound))
        there = np.flatnonzero(np.isin(self._where[:, step], bound.states))
        return [agent for agent in there.tolist() if self.walks[agent].number in able]

    def _appoint(self, bound: Bound, step: int, before: Sequence[int]) -> list[int]:
        """Give as many agents as a bound asks for their duty; rather those who had it before."""
        present = self._present(bound, step)
        known = set(before)
        rank = {
            agent: (agent not in known, step not in self.duties[agent], agent) for agent in present
        }
        chosen = sorted(present, key=rank.__getitem__)[: max(bound.amount, 0)]
        mask = np.zeros(len(self.setting.arrays.names), dtype=np.bool_)
        mask[list(bound.states)] = True
        for agent in chosen:
            other = self.duties[agent].get(step)
            self.duties[agent][step] = mask if other is None else mask & other
        return chosen
