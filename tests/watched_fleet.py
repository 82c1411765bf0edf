"""A fleet by chance that writes down where everybody was, and what a formula is worth on that."""

from __future__ import annotations

from collections.abc import Mapping, Sequence

import numpy as np

from tsplan import Mission
from tsplan.logic.evaluation import CountTrace, robustness
from tsplan.plans.worlds import OnEdge
from tsplan.replanning.robot_fleet import Assembly, Order, RebuildOrder, Seen
from tsplan.replanning.simulated_fleet import SimulatedFleet


class Watched(SimulatedFleet):
    """Robots and structures at every step, and of which configuration structures are."""

    def begin(
        self, step: int, places: Mapping[str, str | OnEdge], built: Sequence[Assembly] = ()
    ) -> None:
        super().begin(step, places, built)
        self.shapes = {each.structure: each for each in built}
        self.seen: list[Seen] = []
        self.states: list[dict[str, str | None]] = []
        self._write(places)

    def advance(self, step: int, orders: Sequence[Order]) -> Seen:
        for order in orders:
            for each in order.made if isinstance(order, RebuildOrder) else ():
                self.shapes[each.structure] = each
        self.seen.append(super().advance(step, orders))
        self._write(self.seen[-1].places)
        return self.seen[-1]

    def _write(self, places: Mapping[str, object]) -> None:
        self.states.append({n: p if isinstance(p, str) else None for n, p in places.items()})


def able(mission: Mission, fleet: Watched) -> dict[str, frozenset[str]]:
    """What everybody can do."""
    of = {agent.id: agent.capabilities for agent in mission.agents}
    for each in fleet.shapes.values():
        shape = mission.modular.of[each.configuration]
        of[each.structure] = of[each.modules[0]] | shape.capabilities
    return of


def slack(mission: Mission, fleet: Watched) -> float:
    """The robustness of the formula on what a fleet wrote down."""
    names, states, of = list(mission.system.states), fleet.states, able(mission, fleet)
    every = {name for capabilities in of.values() for name in capabilities}
    counts = {name: np.zeros((len(names), len(states))) for name in (None, *every)}
    for step, places in enumerate(states):
        for agent, state in places.items():
            for name in (None, *of[agent]) if state is not None else ():
                counts[name][names.index(state), step] += 1
    labels = {
        label: np.array([names.index(state) for state in members])
        for label, members in mission.system.labels.items()
    }
    return float(robustness(mission.counted, CountTrace(counts, labels))[0])
