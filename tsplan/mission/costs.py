"""Costs that can be told apart: what a plan costs is an exact number, or it is refused."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from fractions import Fraction

from tsplan.exact import MOST_EXACT, common_unit, digits, exact
from tsplan.mission.configurations import ModuleRules
from tsplan.mission.findings import Fault
from tsplan.mission.team import Group
from tsplan.ts import Edge, TransitionSystem
from tsplan.ts.edges import RISKS

_DECIMALS = 10**15
"""Decimal numbers of up to 15 digits are told apart in double precision."""


def cost_faults(
    system: TransitionSystem,
    team: Sequence[Group],
    horizon: int,
    objective: Sequence[str],
    modular: ModuleRules,
) -> list[Fault]:
    """The costs that have more digits than the cost of a plan can be told with.

    Costs are counted in the largest unit of which all are multiples. What a plan can come to must
    be told apart in this unit: up to 2^53 of it, or 10^15 where it is a part of 1.
    """
    if "risk" in objective:
        risked = _most(system, sum(group.count for group in team), horizon, _risk)
        if risked * RISKS > MOST_EXACT:
            what = (
                f"the risk of a plan can come to {float(risked):.3g}, too much to be told exactly"
            )
            remedy = "give edges a greater chance of success"
            return [Fault(("objective", objective.index("risk")), what, remedy)]
    named = next((name for name in objective if name in ("cost", "energy")), None)
    if named is None:
        return []
    most = _most(system, sum(group.count for group in team), horizon, _cost)
    most += _most_of_structures(system, team, horizon, modular)
    unit = cost_unit(system, team, modular)
    if most / unit <= _limit(unit):
        return []
    if modular:
        what = f"the {named} of a plan can come to {float(most):.3g}, which has too many digits"
        remedy = "write costs and their factors with fewer digits"
        return [Fault(("objective", objective.index(named)), what, remedy)]
    needed = _coarser(most)
    priced = [edge for edge in system.edges.values() if edge.cost]
    fine = [edge for edge in priced if exact(edge.cost or 0) % needed] or priced
    if not fine:  # durations alone add up to too much
        what = f"the cost of a plan can come to {float(most):.3g}, too much to be told exactly"
        return [Fault(("objective", objective.index(named)), what, "use 'travel' instead")]
    return [_fault(system, edge, most, needed) for edge in fine]


def cost_unit(system: TransitionSystem, team: Sequence[Group], modular: ModuleRules) -> Fraction:
    """The largest number of which all that a plan may pay for is a whole multiple."""
    if not modular.configurations:
        return system.cost_unit
    prices = [exact(rule.cost) for rule in modular.reconfigurations]
    prices += [
        shape.price(edge, team[pool.groups[0]].class_name)
        for pool in modular.pools(team)
        for shape in pool.shapes
        for edge in system.edges.values()
        if edge.duration_for(team[pool.groups[0]].class_name) is not None
    ]
    robots = any(group.configuration is None for group in team)
    return common_unit([*prices, *([system.cost_unit] if robots else [])])


def _most_of_structures(
    system: TransitionSystem, team: Sequence[Group], horizon: int, modular: ModuleRules
) -> Fraction:
    """What structures can cost beyond robots at the most: in every step the dearest of all."""
    factor = max((exact(shape.cost) for shape in modular.configurations), default=Fraction(0))
    dearest = max((_cost(edge, edge.shortest() or 0) for edge in system.edges.values()), default=0)
    rule = max((exact(each.cost) for each in modular.reconfigurations), default=Fraction(0))
    modules = sum(group.count for group in team if group.configuration is not None)
    return modules * (horizon + 1) * (factor * dearest + rule)


def _cost(edge: Edge, duration: int) -> Fraction:
    return exact(edge.cost) if edge.cost is not None else Fraction(0 if edge.is_wait else duration)


def _risk(edge: Edge, _duration: int) -> Fraction:
    return edge.risk


def _most(
    system: TransitionSystem, agents: int, horizon: int, price: Callable[[Edge, int], Fraction]
) -> Fraction:
    """What the moves of all agents can cost at the most: the dearest steps, and a last move."""
    dearest, last = Fraction(0), Fraction(0)
    for edge in system.edges.values():
        duration = edge.shortest()
        if duration is None:
            continue
        cost = price(edge, duration)
        dearest, last = max(dearest, cost / duration), max(last, cost)
    return agents * (dearest * horizon + last)


def _limit(unit: Fraction) -> int:
    return MOST_EXACT if unit.denominator == 1 else _DECIMALS


def _coarser(most: Fraction) -> Fraction:
    """The least power of ten in which the costs of plans could be told apart."""
    power = -30
    while most / Fraction(10) ** power > _limit(Fraction(10) ** power):
        power += 1
    return Fraction(10) ** power


def _fault(system: TransitionSystem, edge: Edge, most: Fraction, needed: Fraction) -> Fault:
    what = (
        f"cost: {digits(edge.cost or 0)} from '{edge.source}' to '{edge.target}' has digits that "
        f"are lost in the cost of a plan, which can come to {float(most):.3g}"
    )
    if needed < 1:
        places = len(str(needed.denominator)) - 1
        remedy = f"write at most {places} digits after the point"
    elif needed == 1:
        remedy = "write no digits after the point"
    else:
        unit = needed.numerator
        lost = len(str(unit)) - 1
        last = "digit" if lost == 1 else f"{lost} digits"
        remedy = f"drop the last {last} of all costs: count them in units of {unit:,}"
    return Fault(("map",), what, remedy, at=system.places.get(edge.pair))
