"""The margin that makes the distributed protocol succeed with a given probability.

Under the protocol of `tsplan.protocol.simulation` the agents of swarms are independent, and robots
beside them go as planned; agents that follow policies are independent all of them. So the number of
those at the states of a label at a step is a sum of independent 0/1 variables, expected to be the
planned number. Among all such sums with one mean the binomial has the heaviest tails at a distance
of one or more from the mean (W. Hoeffding, "On the distribution of the number of successes in
independent trials", Annals of Mathematical Statistics 27, 1956, theorem 4). A demand for m of n
agents, planned with a margin of h, therefore fails with probability at most P(X < m) for X ~
Binomial(n, (m + h)/n). One for at most m is a demand for n - m elsewhere. Where all agents are to
be, or none, nothing is left to chance.

A plan meets a formula by some demands at some steps. The probabilities that one of them fails are
added up (Boole's inequality), because how they depend on each other is not known: at every step of
an always, on all sides of an and; of an or the worse side counts.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping
from typing import Any

from tsplan import logic
from tsplan.errors import Finding, MissionError
from tsplan.limits import clipped
from tsplan.logic import Count, Formula
from tsplan.mission import Mission


def margin_for(mission: Mission, probability: float = 0.95) -> int:
    """The least margin, in agents, with which the protocol is sure to succeed so often.

    Every plan of the mission with this `margin` meets its formula with at least `probability`
    when each agent follows the plan's shares by chance. The bound holds whatever the plan, so
    most plans do with less; it says nothing of `min_subswarm`. Raises MissionError for a mission
    of a team and ValueError for a probability that is not between 0 and 1.
    """
    if not 0 < probability < 1:
        raise ValueError(f"a probability between 0 and 1 is needed, not {clipped(probability)}")
    if mission.swarm is None and mission.expected is None:
        what = "only the agents of a swarm go by chance, and the mission has a team"
        raise MissionError([Finding(what, "describe a swarm, or uncertain moves")])
    formula = logic.simplify(logic.positive(mission.counted))
    low, high = -1, mission.size  # with all agents to spare nothing is left to chance
    while high - low > 1:
        middle = (low + high) // 2
        if failing(mission, formula, middle) <= 1 - probability:
            high = middle
        else:
            low = middle
    return high


def failing(mission: Mission, formula: Formula, margin: int) -> float:
    """A bound on the probability that a plan with so large a margin misses a formula.

    `formula` is one over the mission's map and classes, in positive normal form.
    """

    def risk(node: Formula, below: tuple[float, ...]) -> float:
        if isinstance(node, Count):
            return _at(node, mission, margin)
        return _RISKS[type(node)](node, below)

    bound: float = logic.fold(formula, risk)
    return min(bound, 1.0)


_RISKS: Mapping[type[Formula], Callable[[Any, tuple[float, ...]], float]] = {
    logic.Constant: lambda *_: 0.0,
    logic.Known: lambda *_: 0.0,
    logic.And: lambda _, below: sum(below),
    logic.Or: lambda _, below: max(below),
    logic.Eventually: lambda _, below: below[0],
    logic.Always: lambda node, below: (node.high - node.low + 1) * below[0],
    logic.Until: lambda node, below: node.high * below[0] + below[1],
    logic.Release: lambda node, below: below[0] + (node.high - node.low + 1) * below[1],
}
"""The bound of a node of positive normal form from those of its children."""


def _at(node: Count, mission: Mission, margin: int) -> float:
    """The bound of an atom at one step."""
    agents = mission.having(node.capability)
    assert isinstance(node.bound, int)
    needed = node.bound if node.relation == ">=" else agents - node.bound
    # `min >=` and `max <=` speak about every state with the label, the others about one or all
    every = (node.function, node.relation) in {("min", ">="), ("max", "<=")}
    places = len(mission.system.labels[node.label]) if every else 1
    return places * shortfall(agents, needed, margin)


def shortfall(agents: int, needed: int, margin: int) -> float:
    """P(X < needed) for X ~ Binomial(agents, (needed + margin) / agents).

    0 where any number does or where all or more are needed, which is left to no chance.

    >>> round(shortfall(100, 50, 0), 3), round(shortfall(100, 50, 10), 3)
    (0.46, 0.017)
    """
    from scipy.special import bdtr  # noqa: PLC0415  (slow to import)

    if needed <= 0 or needed + margin >= agents:
        return 0.0
    return float(bdtr(needed - 1, agents, (needed + margin) / agents))
