"""Ways to make a mission over signals easier, each by moving one of its numbers."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import replace
from fractions import Fraction
from math import ceil, isinf
from typing import TYPE_CHECKING, TypeAlias

from tsplan.exact import exact
from tsplan.explanation.explanation import SoftConstraint
from tsplan.explanation.whynot.edits import deadline
from tsplan.explanation.whynot.mission_numbers import Edit, Number, literal
from tsplan.explanation.whynot.occurrences import Occurrence, node_at, nodes_along, occurrences
from tsplan.explanation.whynot.signal_constraints import system_side
from tsplan.explanation.whynot.signal_numbers import MAX, MIN, alike, grain, scale, width_of
from tsplan.explanation.whynot.soft_constraints import occurrence_of, of_occurrence
from tsplan.logic import Always, Eventually, Linear, Release, Until, horizon
from tsplan.logic.text import number_text, sum_text

if TYPE_CHECKING:
    from tsplan.explanation.change_kinds import ChangeKind
    from tsplan.explanation.explanation import PartKind
    from tsplan.explanation.part_words import Wording
    from tsplan.explanation.whynot.occurrences import Way
    from tsplan.explanation.whynot.subject import Constraints
    from tsplan.signals.signal_mission import SignalMission


Timed: TypeAlias = Always | Eventually | Release | Until

_MOST = 10.0
"""Times the width of its range, or the largest number of a mission, that a number is moved."""


def touched(mission: SignalMission, number: Number) -> Constraints:
    """What an edit of a number weakens at most; nothing where that cannot be said."""
    kind, key = number
    if kind == "formula":
        return frozenset(map(of_occurrence, occurrences(mission.formula, key[0])))
    if kind == "side":
        side: PartKind = "signal" if key[0] in mission.system.signals else "control"
        return frozenset({SoftConstraint(side, key)})
    if kind == "begin":
        return frozenset({SoftConstraint("start", key[:1])})
    return frozenset({SoftConstraint("limit", key)}) if kind == "limit" else frozenset()


def candidates(wording: Wording, conflict: Constraints) -> list[Edit]:
    """Everything that can be tried against one conflict, each once."""
    found: dict[Edit, None] = {}
    for constraint in sorted(conflict, key=repr):
        found.update(dict.fromkeys(_against(wording, constraint)))
    found.update(dict.fromkeys(_sooner_end(wording.mission, conflict)))
    return [edit for edit in found if edit.most > 0]


def _against(wording: Wording, constraint: SoftConstraint) -> Iterator[Edit]:
    mission: SignalMission = wording.mission
    kind, key = constraint
    if kind == "formula":
        way = occurrence_of(constraint).way
        was = literal(wording.whole(way))
        yield from _threshold(mission, way, was)
        for above, node in nodes_along(mission.formula, way):
            if isinstance(node, Timed):
                said = literal(wording.part_of(Occurrence(above)).text)
                yield from _window(mission, above, node, said)
    elif kind == "start":
        yield from (_start(mission, key[0], place) for place in (MIN, MAX))
    elif kind == "limit":
        limit = mission.system.limits[key[0]]
        width = sum(
            abs(factor) * width_of(mission, terms)
            for factor, terms in ((1.0, limit.terms), *limit.absolute)
            if terms
        )
        what = f"raise the end of the limit {literal(str(limit))} to {{new}}"
        yield _real(mission, Number("limit", key), "loosen_limit", what, (width, 1))
    else:
        yield _side(mission, *key)


def _real(
    mission: SignalMission, number: Number, kind: ChangeKind, text: str, by: tuple[float, int]
) -> Edit:
    """A real number that is moved in some sense, in steps that suit the width of its range."""
    width, sense = by
    unit = grain(width)
    most = ceil(Fraction(_MOST * max(width, scale(mission))) / unit)
    return Edit(number, kind, most, text, number.get(mission), sense, unit=unit)


def _threshold(mission: SignalMission, way: Way, was: str) -> Iterator[Edit]:
    """A comparison with another number; of equations nothing is moved."""
    node = node_at(mission.formula, way)
    if isinstance(node, Linear) and node.terms and node.relation not in ("=", "!="):
        sense = -1 if node.relation in (">=", ">") else 1
        sum_ = literal(sum_text(node.terms))
        text = f"ask for {sum_} {node.relation} {{new}} instead of {number_text(node.bound)}"
        number = Number("formula", (way, "bound"))
        by = width_of(mission, node.terms), sense
        yield _real(mission, number, "move_threshold", f"{text} in {was}", by)


def _window(mission: SignalMission, way: Way, node: Timed, was: str) -> Iterator[Edit]:
    """A window that begins sooner or ends later where one step is enough, or is shortened."""
    if isinstance(node, Eventually | Until):
        yield from deadline(mission, way, was)
        text = f"begin the window at {{new}} instead of {node.low} ({{steps}} sooner) in {was}"
        number = Number("formula", (way, "low"))
        yield Edit(number, "start_sooner", node.low, text, node.low, -1)
    else:
        ends: tuple[tuple[str, str, str, int, int], ...] = (
            ("high", "end", "sooner", node.high, -1),
            ("low", "begin", "later", node.low, 1),
        )
        for field, verb, than, now, sense in ends:
            text = f"{verb} the window at {{new}} instead of {now} ({{steps}} {than}) in {was}"
            number = Number("formula", (way, field))
            yield Edit(number, "shorten_window", node.high - node.low, text, now, sense)


def _start(mission: SignalMission, name: str, place: int) -> Edit:
    """A signal that may begin lower or higher, up to its bounds."""
    number = Number("begin", (name, place))
    now, sense = number.get(mission), (-1, 1)[place]
    width = width_of(mission, ((name, 1.0),))
    text = f"let {literal(name)} begin as {'high' if place else 'low'} as {{new}}"
    text = f"{text} (now {number_text(now)})"
    edit = _real(mission, number, "widen_start", text, (width, sense))
    end = mission.system.signals[name][place]
    room = edit.most if isinf(end) else int(abs(exact(end) - exact(now)) / edit.unit)
    return replace(edit, most=min(edit.most, room))


def _side(mission: SignalMission, name: str, place: int) -> Edit:
    """A bound of a signal or control further out."""
    now = system_side(mission.system, name)[place]
    which, verb = ("max", "raise") if place else ("min", "lower")
    names = literal(", ".join(alike(mission, name)))
    text = f"{verb} the {which} of {names} from {number_text(now)} to {{new}}"
    by = width_of(mission, ((name, 1.0),)), (-1, 1)[place]
    return _real(mission, Number("side", (name, place)), "loosen_bound", text, by)


def _sooner_end(mission: SignalMission, conflict: Constraints) -> Iterator[Edit]:
    """A mission that ends with its formula, where what bounds it all along is in the way."""
    if any(item.kind in ("control", "limit", "signal") for item in conflict):
        most = mission.horizon - horizon(mission.formula)
        text = f"end the mission at step {{new}} instead of {mission.horizon}"
        number = Number("last", ())
        yield Edit(number, "shorten_mission", most, text, mission.horizon, -1)
