"""Objectives that give every edge a price: travel, costs, energy and risk."""

from __future__ import annotations

from abc import abstractmethod
from fractions import Fraction

import numpy as np

from tsplan.encode.class_graph import ClassGraph
from tsplan.encode.encoded import Encoded, Setting
from tsplan.encode.objective_kinds import Grouping, ModelObjective
from tsplan.encode.structure_flows import PART, Rebuilding
from tsplan.exact import exact
from tsplan.milp.model import Floats, Ints
from tsplan.milp.target import Target
from tsplan.ts.edges import RISKS


class Priced(ModelObjective):
    """An objective that gives every edge a price, and adds up what the agents' moves cost."""

    @abstractmethod
    def price(self, graph: ClassGraph) -> Floats | Ints:
        """What an agent that enters each edge costs, in whole units."""

    def vector(self, setting: Setting, encoded: Encoded) -> Floats:
        """The price of every flow column."""
        vector = np.zeros(encoded.model.size.columns)
        for item in encoded.network.classes:
            item.price(vector, self.price(item.graph))
        return vector


class Travel(Priced):
    """Agent-steps spent in moves that are not waits."""

    name = "travel"
    grouping = Grouping.FEW_MOVES

    def price(self, graph: ClassGraph) -> Ints:
        """The duration of every move."""
        return graph.travel


class Cost(Priced):
    """Summed edge costs of all moves; waits are free unless their edge says otherwise."""

    name = "cost"
    priced = True

    def toll(self, graph: ClassGraph) -> Floats | None:
        """The costs, unless a class pays the same for every step of a move."""
        return None if _even(graph) else graph.cost

    def price(self, graph: ClassGraph) -> Floats:
        """The cost of every edge in whole units."""
        return graph.cost

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


class Risk(Priced):
    """-log of the probability that no move of the plan fails."""

    name = "risk"

    def toll(self, graph: ClassGraph) -> Floats | None:
        """The risks, if any."""
        return graph.risk if graph.risk.any() else None

    def price(self, graph: ClassGraph) -> Floats:
        """The risk of every edge in millionths."""
        return graph.risk

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
