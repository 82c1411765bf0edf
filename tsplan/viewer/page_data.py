"""What the page shows, as plain JSON data: numbers in lists, names once, places by number."""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence
from dataclasses import asdict
from typing import Any, TypeAlias

from tsplan.checking.fitting import refuse_misfit
from tsplan.draw.layout import links, places, usual_duration
from tsplan.draw.palette import PLAIN, Paint, Palette, classes_of
from tsplan.draw.timeline_rows import is_idle, paired
from tsplan.draw.tracks import Track, tracks
from tsplan.explanation.why.stock_lines import StockLine, stock_lines
from tsplan.mission import Mission
from tsplan.plans.cargo_rows import AgentLoads, loads_of
from tsplan.plans.outcomes import ObjectiveValue
from tsplan.plans.plan import Plan
from tsplan.plans.summary import infinite_word, objective_line, outcome
from tsplan.plans.supplies import load_words
from tsplan.ts import State, TransitionSystem
from tsplan.viewer.formula_rows import Part, formula_parts
from tsplan.viewer.freight import freights, rebuildings
from tsplan.viewer.positions import with_slots
from tsplan.words import number

Json: TypeAlias = dict[str, Any]

MOST_IDS = 20_000
"""Agents up to which each one's own name goes into the page; above, only their bundles' names."""


def page_data(mission: Mission, plan: Plan, executed: Plan | None = None) -> Json:
    """Everything the page needs to know; raises PlanError for a plan that does not fit the map.

    Where it is known what happened, everything is told of that, and what was planned beside it.
    """
    shown = plan if executed is None else executed
    for each in {id(plan): plan, id(shown): shown}.values():
        refuse_misfit(each, mission)
    endless = infinite_word(plan)
    moving, before = _pairs(mission, plan, executed)
    places_of = {state: place for place, state in enumerate(mission.system.states)}
    parts = [part_data(part, places_of) for part in formula_parts(mission, shown)]
    if executed is not None:
        _add_planned(parts, formula_parts(mission, plan))
    said = outcome(plan)
    return {
        "title": plan.mission.name or mission.name or mission.system.name or "plan",
        "outcome": said if executed is None else f"what happened, beside the {said}",
        "facts": [
            {"text": fact_words(item, endless), "about": objective_line(item, endless)}
            for item in plan.objective
        ],
        "horizon": max(plan.horizon, shown.horizon),
        "map": map_data(mission.system),
        "classes": _classes(mission),
        **_moves(mission, shown, moving),
        "planned": _moves(mission, plan, before) if executed is not None else None,
        "formula": parts,
    }


def _classes(mission: Mission) -> list[Json]:
    paints = Palette.of(mission).classes
    return [
        {
            "name": group.words(name) if group.modules else name,
            "capabilities": list(group.capabilities),
            "agents": None if group.modules else group.agents,
            "color": paints[name].colour,
            "mark": place,
        }
        for place, (name, group) in enumerate(classes_of(mission).items())
    ]


def _pairs(
    mission: Mission, plan: Plan, executed: Plan | None
) -> tuple[list[Track], list[Track | None]]:
    """The tracks of what is shown, and for each that of the plan for the same agents, if any.

    Further tracks of the plan come after all others. Without what happened there are those of the
    plan alone.
    """
    found = tracks(executed or plan, mission, moving=True)
    if executed is None:
        return [*found], []
    planned = tracks(plan, mission, moving=True)
    rows = paired(found, planned)
    seen = {name for row in rows for name in row.shown.ids}
    before = [
        row.planned
        and (row.planned.only(frozenset(row.shown.ids)) if row.shown.ids else row.planned)
        for row in rows
    ]
    kept = {row.planned.name for row in rows if row.planned and not row.planned.ids}
    rest = [
        track for track in planned if not seen.intersection(track.ids) and track.name not in kept
    ]
    return [row.shown for row in rows], [*before, *rest]


def _same_agents(planned: Track, shown: Track) -> Track | None:
    """Of a track those agents that another one has."""
    return planned.only(frozenset(shown.ids)) if shown.ids else planned


def _moves(mission: Mission, plan: Plan, found: Sequence[Track | None]) -> Json:
    """Who moves when, what they carry and what lies where."""
    moving = [track for track in found if track is not None]
    slotted = iter(with_slots(moving))
    places_of = {state: place for place, state in enumerate(mission.system.states)}
    kind = {name: place for place, name in enumerate(Palette.of(mission).classes)}
    loads = loads_of(plan.cargo)
    named = sum(track.count for track in moving) <= MOST_IDS
    return {
        "tracks": [
            None if track is None else _track(next(slotted), kind, places_of, loads, named=named)
            for track in found
        ],
        "freights": [
            [places_of[item.source], places_of[item.target], item.left, item.come, item.words]
            for item in (*freights(moving, loads), *rebuildings(plan, mission))
        ],
        "stocks": [stock_data(line, places_of) for line in stock_lines(plan, mission)],
    }


def _track(
    track: Track,
    kind: Mapping[str, int],
    places_of: Mapping[str, int],
    loads: AgentLoads,
    *,
    named: bool,
) -> Json:
    return {
        "class": kind[track.class_name],
        "count": track.count,
        "name": track.name,
        "ids": list(track.ids) if named else [],
        "end": track.end,
        "idle": is_idle(track),
        "stops": _flat(track, places_of),
        "loads": _carried(track, loads),
    }


def _add_planned(parts: Sequence[Json], planned: Sequence[Part]) -> None:
    """Give each chart of what happened the counts that were planned."""
    for part, before in zip(parts, planned, strict=True):
        counts = {chart.text: chart.counts for chart in before.charts}
        for chart in part["charts"]:
            chart["planned"] = counts.get(chart["text"])


def _flat(track: Track, place: Mapping[str, int]) -> list[int]:
    """All stops in a row, four numbers each.

    Agents that are on an edge from before step 0 have left its beginning a step before that.
    """
    before = [] if track.begun is None else [-1, -1, place[track.begun], 0]
    stops = [n for stop in track.stops for n in (*stop[:2], place[stop.state], stop.slot)]
    return before + stops


def _carried(track: Track, loads: AgentLoads) -> list[list[Any]]:
    """What they carry, with the step at which they set out."""
    ways = ((stop.last, track.load(stop.last, loads)) for stop in track.stops)
    return [[step, load_words(load)] for step, load in ways if load]


def stock_data(line: StockLine, place: Mapping[str, int]) -> Json:
    """What lies of a resource at a state.

    `amounts` has the steps at which that changes, each with what lies there at it and what stays.
    """
    pairs = zip(line.amounts.tolist(), line.staying.tolist(), strict=True)
    changes, before = [], None
    for step, (there, stays) in enumerate(pairs):
        if (there, there) != (before, stays):
            changes.append([step, *(number(round(amount, 6)) for amount in (there, stays))])
        before = stays
    return {"state": place[line.state], "name": line.resource.name, "amounts": changes}


def fact_words(item: ObjectiveValue, infinite: str = "unbounded") -> str:
    """An objective's value, and in one word whether it is proven.

    >>> fact_words(ObjectiveValue("travel", 12.0, 12.0)), fact_words(ObjectiveValue("cost", 8, 6))
    ('travel 12 · proven', 'cost 8 · bound 6')
    """
    words = f"{item.name} {number(item.value, infinite)}"
    if item.value is None or item.bound is None:
        return words
    same = math.isclose(item.value, item.bound, rel_tol=1e-9, abs_tol=1e-9)
    return f"{words} \u00b7 proven" if same else f"{words} \u00b7 bound {number(item.bound)}"


def map_data(system: TransitionSystem) -> Json:
    """States with their places, and the lines between them."""
    number = {state: place for place, state in enumerate(system.states)}
    where = places(system)
    paints = Palette(system).states
    states = [_state(state, where[name], paints[name]) for name, state in system.states.items()]
    usual = usual_duration(system)
    edges = [
        {
            "from": number[source],
            "to": number[target],
            "words": "" if words == usual else words,
            "oneWay": one_way,
        }
        for source, target, one_way, words in links(system)
    ]
    told = "" if usual == "1" else f"{usual} steps if not marked"
    return {"name": system.name, "states": states, "edges": edges, "usual": told}


def _state(state: State, at: tuple[float, float], paint: Paint) -> Json:
    return {
        "name": state.name,
        "x": at[0],
        "y": at[1],
        "labels": sorted(state.labels),
        "shape": [list(point) for point in state.shape] if state.shape else None,
        "color": None if paint == PLAIN else paint.colour,
        "capacity": state.capacity,
    }


def part_data(part: Part, number: Mapping[str, int]) -> Json:
    """A row of the formula; `number` has the numbers of states or regions."""
    return {
        **asdict(part),
        "when": span_words(part.needed),
        "duties": part.duties,
        "states": [number[state] for state in part.states],
    }


def span_words(spans: tuple[tuple[int, int], ...]) -> str:
    """Steps in words: the span, or the first and the last step where there are several.

    >>> span_words(((3, 5), (9, 9))), span_words(((4, 4),)), span_words(())
    ('3…9', '4', '')
    """
    if not spans:
        return ""
    first, last = spans[0][0], spans[-1][1]
    if first == last:
        return str(first)
    return f"{first}\u2013{last}" if len(spans) == 1 else f"{first}\u2026{last}"
