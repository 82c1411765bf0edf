"""How many robots and structures there can be of each capability, of those that are not lost."""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterable
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from tsplan.mission import Mission
    from tsplan.plans.plan import Plan


class AbleCounts:
    """The agents of a mission, and those who have joined in a plan that was replanned."""

    def __init__(self, mission: Mission, plan: Plan) -> None:
        self._mission = mission
        self._lost: Counter[int] = Counter()  # by groups of the team
        self._joined = {
            name: bundle.capabilities
            for bundle in plan.robots
            for name in bundle.agents
            if plan.replanned and mission.roster.get(name) is None
        }

    def of(self, capability: str | None) -> int:
        """How many can have a capability at once; all of them for None."""
        joined = sum(capability is None or capability in able for able in self._joined.values())
        return self._mission.having(capability, lost=self._lost) + joined

    def lose(self, names: Iterable[str]) -> None:
        """Robots or modules are lost."""
        for name in names:
            rank = self._mission.roster.get(name)
            if rank is None:
                self._joined.pop(name, None)
            else:
                self._lost[rank.group] += 1
