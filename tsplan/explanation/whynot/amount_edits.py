"""Changes of amounts: less asked for, more at its place, more carried by each robot."""

from __future__ import annotations

from typing import TYPE_CHECKING

from tsplan.exact import exact
from tsplan.explanation.whynot.amount_numbers import (
    resource_of,
    unit_of,
    useful_amount,
    useful_hold,
)
from tsplan.explanation.whynot.mission_numbers import Edit, Number, literal
from tsplan.explanation.whynot.occurrences import amounts_of, counts_of, node_at
from tsplan.logic import Execution, Task, walk
from tsplan.logic.text import number_text

if TYPE_CHECKING:
    from collections.abc import Iterator
    from fractions import Fraction

    from tsplan.explanation.whynot.occurrences import Occurrence
    from tsplan.mission import Mission

MOST_STOCKS = 6
"""States at which more of a resource is tried."""


def lower_amount(mission: Mission, part: Occurrence, was: str) -> Iterator[Edit]:
    """Less of a resource asked for by a task."""
    node = node_at(mission.formula, part.way)
    if not isinstance(node, Task):
        return
    field = part.need or 0
    place = field - len(counts_of(node))
    if not 0 <= place < len(amounts_of(node)):
        return
    name, now = amounts_of(node)[place]
    resource = resource_of(mission, name)
    if node.begun and resource.consumed:  # is used up
        return
    unit = unit_of(mission, resource)
    label = literal(node.label)
    change = f"at '{label}' from {number_text(now)} to {{new}} {literal(name)} in {was}"
    nothing = f"ask for no {literal(name)} at '{label}' in {was}"
    number = Number("formula", (part.way, field))
    text = f"lower the need {change}"
    yield Edit(number, "lower_need", _steps(now, unit), text, now, -1, nothing, _plain(unit))


def more_stock(mission: Mission, name: str) -> Iterator[Edit]:
    """More of a resource where it lies at first; where none does, where tasks need it."""
    resource = resource_of(mission, name)
    own = [state for state, amount in resource.at if amount]
    needed = (
        state
        for node in walk(mission.goal)
        if isinstance(node, Execution) and dict(node.resources).get(name)
        for state in mission.system.labels[node.label]
    )
    unit = unit_of(mission, resource)
    most = _steps(float(useful_amount(mission, resource)), unit)
    for state in list(dict.fromkeys(own or needed))[:MOST_STOCKS]:
        text = f"add {{amount}} {literal(name)} at '{literal(state)}'"
        now = dict(resource.at).get(state, 0.0)
        number = Number("stock", (name, state))
        yield Edit(number, "add_stock", most, text, now, unit=_plain(unit))


def more_carried(mission: Mission, entry: int) -> Iterator[Edit]:
    """More that each robot of an entry carries: of each resource it carries, or of all together."""
    group = mission.team[entry]
    whose = f"let each agent of class {literal(group.class_name)} carry"
    if not isinstance(group.carries, tuple):
        unit = min((unit_of(mission, item) for item in mission.resources), default=exact(1.0))
        most = _steps(float(useful_hold(mission)) - group.carries, unit)
        text = f"{whose} {{new}} of all resources together (now {number_text(group.carries)})"
        number = Number("carries", (entry, ""))
        yield Edit(number, "carry_more", most, text, group.carries, unit=_plain(unit))
        return
    for name, now in group.carries:
        resource = resource_of(mission, name)
        unit = unit_of(mission, resource)
        most = _steps(float(resource.total) - now, unit)
        text = f"{whose} {{new}} {literal(name)} (now {number_text(now)})"
        number = Number("carries", (entry, name))
        yield Edit(number, "carry_more", most, text, now, unit=_plain(unit))


def stocked(mission: Mission) -> list[str]:
    """The states at which resources lie at first."""
    return [state for item in mission.resources for state, amount in item.at if amount]


def _steps(amount: float, unit: Fraction) -> int:
    """How many steps of a unit an amount is at most; one more where it is no multiple."""
    return -int(-exact(amount) // unit)


def _plain(unit: Fraction) -> int | Fraction:
    return 1 if unit == 1 else unit
