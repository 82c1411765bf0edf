"""Objectives of missions over signals as files have them: names, and weighted sums of terms."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from typing import Any, NamedTuple

from tsplan.document.fields import shown
from tsplan.document.flow_style import short
from tsplan.errors import nearest
from tsplan.limits import MOST_WEIGHT, Range
from tsplan.mission.findings import Fault, Place
from tsplan.mission.vocabulary import ORDERS, Order
from tsplan.signals.aims import CHOSEN, SENSES, Aim
from tsplan.signals.linear_system import System

DEFAULT = ("robustness",)
"""What a mission asks for where it names no objective."""

_FACTOR = Range(0, MOST_WEIGHT)
_EXAMPLE = "write a name, or a sum such as {robustness: 1, control_effort: 0.1}"


class Aims(NamedTuple):
    """The objectives of a file: what could be read, and what could not."""

    aims: tuple[Aim, ...]
    order: Order | None
    faults: tuple[Fault, ...]


def aims_of(given: Any) -> Aims:
    """The objectives that a file gives: one sum, or names and sums one after the other.

    >>> aims_of({"robustness": 1, "control_effort": 0.1}).aims[0].name
    'J'
    """
    path: Place = ("objective",)
    entries = given if isinstance(given, list | tuple) else [given]
    if not isinstance(given, list | tuple | dict):
        fault = Fault(path, f"objective: {shown(given)} is no objective", f"{_EXAMPLE}, in a list")
        return Aims((), None, (fault,))
    aims: list[Aim] = []
    faults: list[Fault] = []
    order: Order | None = None
    for place, entry in enumerate(entries):
        found: list[Fault] = []
        if isinstance(entry, dict) and "satisfaction" in entry:
            order, found = _order(entry, (*path, place))
            entry = "satisfaction"  # noqa: PLW2901  (what is left of it)
        elif entry == "satisfaction":
            order = ORDERS[0]
        if isinstance(entry, str):
            aims.append(Aim(((entry, 1.0),)))
        elif isinstance(entry, dict) and entry:
            aim, found = _sum(entry, (*path, place))
            aims.append(aim)
        else:
            found = [Fault((*path, place), f"{shown(entry)} is no objective", _EXAMPLE)]
        faults += found
    return Aims(tuple(aims), order, tuple(faults))


def _order(entry: Mapping[str, Any], path: Place) -> tuple[Order | None, list[Fault]]:
    given = entry["satisfaction"]
    known = next((order for order in ORDERS if order == given), None)
    if len(entry) > 1:
        what = "'satisfaction' is not weighed against other objectives"
        return known, [Fault(path, what, "write [{satisfaction: weighted}, robustness]")]
    if known is None:
        what = f"{shown(given)} is no order of satisfaction"
        return None, [Fault((*path, "satisfaction"), what, nearest(str(given), ORDERS))]
    return known, []


def _sum(entry: Mapping[str, Any], path: Place) -> tuple[Aim, list[Fault]]:
    """A weighted sum; an effort may have a factor for each of some signals instead of its own."""
    weights: list[tuple[str, float]] = []
    efforts: dict[str, dict[str, float]] = {}
    faults = []
    for term, factor in entry.items():
        each = factor if isinstance(factor, dict) else {None: factor}
        numbers: dict[Any, float] = {}
        for name, value in each.items():
            words = _FACTOR.complaint(value)
            place = (*path, term) if name is None else (*path, term, name)
            if words is not None:
                faults.append(Fault(place, f"{term}: {words}", "write a number from 0 on"))
            numbers[name] = 1.0 if words is not None else float(value)
        weights.append((term, numbers.get(None, 1.0)))
        if isinstance(factor, dict):
            efforts[term] = numbers
    return Aim(tuple(weights), efforts), faults


def aim_faults(aims: Sequence[Aim]) -> Iterator[Fault]:
    """Unknown and repeated objectives, and sums of what cannot be weighed."""
    known = (*SENSES, *CHOSEN)
    for place, aim in enumerate(aims):
        terms = [term for term, _ in aim.weights]
        for number, (term, factor) in enumerate(aim.weights):
            path: Place = ("objective", place, term)
            words = _FACTOR.complaint(factor)
            if term not in known:
                yield Fault(path, f"unknown objective '{term}'", nearest(term, known))
            elif words is not None:
                yield Fault(path, f"{term}: {words}", "write a number from 0 on")
            elif term in CHOSEN and (len(terms) > 1 or factor != 1):
                what = f"'{term}' is not weighed against other objectives"
                yield Fault(path, what, f"name it first: [{term}, robustness]")
            elif term in terms[:number] or aim in aims[:place]:
                yield Fault(path, f"objective '{term}' is named twice", "remove one")
        if not any(factor for _, factor in aim.weights):
            yield Fault(("objective", place), "the sum weighs nothing", "give a factor above 0")


def effort_faults(aims: Sequence[Aim], system: System) -> Iterator[Fault]:
    """Efforts of what is no signal or control, and (a warning) of controls where there are none."""
    sides = {
        "state_effort": ("signal", system.signals),
        "control_effort": ("control", system.controls),
    }
    for place, aim in enumerate(aims):
        for term, _ in aim.weights:
            if term in sides and not sides[term][1]:
                what = f"there are no {sides[term][0]}s, so '{term}' is always 0"
                yield Fault(("objective", place, term), what, "remove it", serious=False)
        for term, factors in aim.efforts.items():
            path: Place = ("objective", place, term)
            if term not in sides or term not in dict(aim.weights):
                what = f"'{term}' has no factors of signals"
                yield Fault(path, what, "only state_effort and control_effort have them")
                continue
            if not factors:
                yield Fault(path, f"'{term}' is of no signal", "name some, or give a number")
            kind, known = sides[term]
            for name, factor in factors.items():
                words = _FACTOR.complaint(factor)
                if name not in known:
                    yield Fault((*path, name), f"there is no {kind} '{name}'", nearest(name, known))
                elif words is not None:
                    yield Fault((*path, name), words, "write a number from 0 on")


def aim_entry(aim: Aim, order: Order | None = None) -> Any:
    """The entry of an objective in a file, in which an effort has either one factor or several.

    >>> aim_entry(Aim((("robustness", 1.0), ("state_effort", 0.5))))
    {'robustness': 1, 'state_effort': 0.5}
    """
    if aim.name == "satisfaction":
        return {"satisfaction": order or ORDERS[0]}
    if aim.name != "J" and not aim.efforts:
        return aim.name
    return {
        term: {name: short(factor * each) for name, each in aim.efforts[term].items()}
        if term in aim.efforts
        else short(factor)
        for term, factor in aim.weights
    }
