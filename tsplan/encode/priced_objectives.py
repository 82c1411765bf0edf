"""Objectives that give every edge a price: travel, costs, energy and risk."""

from __future__ import annotations

from collections.abc import Callable
from fractions import Fraction

import numpy as np

from tsplan.encode.class_columns import ClassColumns
from tsplan.encode.class_graph import ClassGraph
from tsplan.encode.encoded import Encoded, Setting
from tsplan.encode.objective_kinds import Grouping, ModelObjective
from tsplan.encode.structure_flows import PART, Rebuilding
from tsplan.exact import exact
from tsplan.milp.model import Floats, Ints
from tsplan.milp.target import Target
from tsplan.ts.edges import RISKS


class Travel(ModelObjective):
    """Agent-steps spent in moves that are not waits."""

    name = "travel"
    grouping = Grouping.FEW_MOVES

    def vector(self, setting: Setting, encoded: Encoded) -> Floats:
        """The duration of every move."""
        return _priced(encoded, lambda item: item.graph.travel)


class Cost(ModelObjective):
    """Summed edge costs of all moves; waits are free unless their edge says otherwise."""

    name = "cost"
    priced = True

    def toll(self, graph: ClassGraph) -> Floats | None:
        """The costs, unless a class pays the same for every step of a move."""
        return None if _even(graph) else graph.cost

    def vector(self, setting: Setting, encoded: Encoded) -> Floats:
        """The cost of every edge in whole units."""
        return _priced(encoded, lambda item: item.graph.cost)

    def target(self, setting: Setting, encoded: Encoded) -> Target:
        """Costs in the map's own unit."""
        return Target(self.vector(setting, encoded), setting.mission.cost_unit)


class Energy(Cost):
    """Costs of moves, and of structures that are rebuilt."""

    name = "energy"

    def vector(self, setting: Setting, encoded: Encoded) -> Floats:
        """The cost of every edge and of every reconfiguration in whole units."""
        vector = super().vector(setting, encoded)
        made: Rebuilding | None = encoded.own_columns.get(PART)
        if made is not None:
            unit = setting.mission.cost_unit
            rules = setting.mission.modular.reconfigurations
            made.price(vector, [float(exact(rule.cost) / unit) for rule in rules])
        return vector


class Risk(ModelObjective):
    """-log of the probability that no move of the plan fails."""

    name = "risk"

    def toll(self, graph: ClassGraph) -> Floats | None:
        """The risks, if any."""
        return graph.risk if graph.risk.any() else None

    def vector(self, setting: Setting, encoded: Encoded) -> Floats:
        """The risk of every edge in millionths."""
        return _priced(encoded, lambda item: item.graph.risk)

    def target(self, setting: Setting, encoded: Encoded) -> Target:
        """Risks in their own unit."""
        return Target(self.vector(setting, encoded), Fraction(1, RISKS))


def _even(graph: ClassGraph) -> bool:
    """Whether all edges cost the same for each step that they last, exactly; waits cost nothing."""
    ride = graph.rides
    costs = [Fraction(cost) for cost in graph.cost[ride].tolist()]
    steps = graph.travel[ride].tolist()
    rates = {cost / step for cost, step in zip(costs, steps, strict=True) if step}
    return len(rates) <= 1 and not any(c for c, step in zip(costs, steps, strict=True) if not step)


def _priced(encoded: Encoded, price: Callable[[ClassColumns], Floats | Ints]) -> Floats:
    """What every flow column costs, where each edge has a price."""
    vector = np.zeros(encoded.model.size.columns)
    for item in encoded.network.classes:
        item.price(vector, price(item))
    return vector
