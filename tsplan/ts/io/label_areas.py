"""Labels that a mission gives to the states of a map: by their ids, or by where they lie."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from dataclasses import replace

import numpy as np
from numpy.typing import NDArray

from tsplan.errors import Finding, MapError, Nearest
from tsplan.ts.edges import State
from tsplan.ts.io.map_settings import Area, Corners, MapSettings
from tsplan.ts.system import TransitionSystem

_ON_EDGE = 1e-9  # square metres by which a point may miss the line of an edge: rounding of floats


def labelled(system: TransitionSystem, settings: MapSettings) -> TransitionSystem:
    """The map with the labels of a mission.

    Raises MapError for ids that no state has, and areas in which none lies.
    """
    if not settings.labels and not settings.areas:
        return system
    findings: list[Finding] = []
    more: dict[str, set[str]] = {name: set() for name in system.states}
    for label, name in (*_by_id(system, settings, findings), *_by_area(system, settings, findings)):
        more[name].add(label)
    if findings:
        raise MapError(findings)
    states = {
        name: replace(state, labels=state.labels | more[name]) if more[name] else state
        for name, state in system.states.items()
    }
    return replace(system, states=states)


def _by_id(
    system: TransitionSystem, settings: MapSettings, findings: list[Finding]
) -> Iterator[tuple[str, str]]:
    """Labels with the states whose names or original ids are listed."""
    known: dict[str, str] = {}
    for state in system.states.values():
        if state.origin is not None:
            known.setdefault(str(state.origin), state.name)
    known |= {name: name for name in system.states}
    closest = Nearest(known)
    for label, ids in settings.labels.items():
        for each, path in ids:
            if str(each) in known:
                yield label, known[str(each)]
            else:
                what = f"no state of the map has the name or id '{each}'"
                findings.append(settings.locate(path, what, closest(str(each))))


def _by_area(
    system: TransitionSystem, settings: MapSettings, findings: list[Finding]
) -> Iterator[tuple[str, str]]:
    """Labels with the states that lie in the areas."""
    placed = [(state, at) for state in system.states.values() if (at := _point(state)) is not None]
    points = np.array([at for _, at in placed], dtype=np.float64).reshape(-1, 2)
    levels = {state.level for state in system.states.values() if state.level is not None}
    for area in settings.areas:
        if area.level is not None and area.level not in levels:
            what = f"the map has no level '{area.level}'"
            findings.append(settings.locate(area.path, what, Nearest(levels)(area.level)))
            continue
        names = list(_inside(area, [state for state, _ in placed], points))
        if not names:
            what = f"no state lies in this area of '{area.label}'"
            findings.append(settings.locate(area.path, what, _extent(points)))
        yield from ((area.label, name) for name in names)


def _inside(area: Area, states: list[State], points: NDArray[np.float64]) -> Iterator[str]:
    for state, is_in in zip(states, within(points, area.corners).tolist(), strict=True):
        if is_in and area.level in (None, state.level):
            yield state.name


def _point(state: State) -> tuple[float, float] | None:
    """Where a state is: its point, else the middle of its shape."""
    if state.at is not None or state.shape is None:
        return state.at
    corners = np.array(state.shape)
    x, y = corners.mean(axis=0).tolist()
    return x, y


def _extent(points: NDArray[np.float64]) -> str:
    if not len(points):
        return "its states have no coordinates: give their ids under 'labels'"
    (left, bottom), (right, top) = points.min(axis=0).tolist(), points.max(axis=0).tolist()
    return f"its states lie in x {left:g}..{right:g}, y {bottom:g}..{top:g}"


def within(points: NDArray[np.float64], corners: Corners) -> NDArray[np.bool_]:
    """Which points, rows of x and y, lie in a polygon or on its border.

    A point is inside where a ray from it crosses the border an odd number of times (M. Shimrat,
    Algorithm 112: Position of point relative to polygon, CACM 1962).

    >>> within(np.array([[1, 1], [2, 1], [3, 1]]), ((0, 0), (2, 0), (2, 2), (0, 2))).tolist()
    [True, True, False]
    """
    x, y = points[:, 0], points[:, 1]
    odd, border = np.zeros(len(points), np.bool_), np.zeros(len(points), np.bool_)
    for (x1, y1), (x2, y2) in zip(corners, (*corners[1:], corners[0]), strict=True):
        side = (x2 - x1) * (y - y1) - (y2 - y1) * (x - x1)
        near_x = (x >= min(x1, x2)) & (x <= max(x1, x2))
        near_y = (y >= min(y1, y2)) & (y <= max(y1, y2))
        border |= (np.abs(side) <= _ON_EDGE) & near_x & near_y
        crossed = (y1 > y) != (y2 > y)
        odd ^= crossed & ((side < 0) if y1 > y2 else (side > 0))
    return odd | border


def metadata_labels(metadata: Mapping[str, object]) -> set[str]:
    """The labels that free data of a node give: its name, its class, and what is true of it.

    >>> sorted(metadata_labels({"name": "dock 1", "charger": True, "tags": ["a"], "width": 2}))
    ['a', 'charger', 'dock 1']
    """
    found: set[str] = set()
    for key, value in metadata.items():
        if value is True:
            found.add(key)
        elif key.lower() in _NAMES:
            words = value if isinstance(value, list) else [value]
            found |= {word for word in words if isinstance(word, str) and word}
    return found


_NAMES = frozenset(("name", "class", "type", "label", "labels", "tag", "tags"))
