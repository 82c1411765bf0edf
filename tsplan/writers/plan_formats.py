"""The formats that plans can be written in, by their names, and how others add theirs.

A format of another package is an entry point of the group `tsplan.plan_writers`: its name is that
of the format, and what it refers to a function from a `Handover` to the parts of a text.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Mapping
from importlib.metadata import entry_points
from typing import TypeAlias

from tsplan.errors import Finding, InputError, nearest
from tsplan.writers import (
    csv_steps,
    geojson_lines,
    graphml_moves,
    nav2_routes,
    octile_map,
    planviz_paths,
    rmf_tasks,
)
from tsplan.writers.handover import Handover

GROUP = "tsplan.plan_writers"

Writer: TypeAlias = Callable[[Handover], Iterable[str]]
"""What makes the text of a file, in parts; raises PlanError or MapError for what it cannot say."""

FORMATS: Mapping[str, Writer] = {
    "nav2": nav2_routes.write,
    "rmf": rmf_tasks.write,
    "planviz": planviz_paths.write,
    "movingai": octile_map.write,
    "csv": csv_steps.write,
    "geojson": geojson_lines.write,
    "graphml": graphml_moves.write,
}
"""The formats of this package; none of another package takes their names."""


def writer(name: str) -> Writer:
    """What writes a format; InputError for an unknown one, or one that cannot be loaded."""
    if name in FORMATS:
        return FORMATS[name]
    others = {entry.name: entry for entry in entry_points(group=GROUP)}
    if name not in others:
        what = f"plans cannot be written as '{name}'"
        raise InputError([Finding(what, nearest(name, [*FORMATS, *others]))])
    try:
        found: Writer = others[name].load()
    except Exception as error:
        what = f"the format '{name}' of {others[name].value} cannot be loaded: {error}"
        raise InputError([Finding(what, "install its package anew")]) from error
    return found
