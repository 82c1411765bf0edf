"""What the page shows of a trajectory, as plain JSON data."""

from __future__ import annotations

from collections.abc import Iterable
from typing import TYPE_CHECKING

import numpy as np

from tsplan.draw.palette import HUES, paints
from tsplan.draw.plane_map import (
    Axes,
    Place,
    frame_of_plane,
    of_robot,
    paths_of,
    places_of,
    plane_of,
    robots_in,
)
from tsplan.logic import Linear
from tsplan.plans.summary import objective_line, outcome
from tsplan.signals.motion_check import refuse_misfit
from tsplan.viewer.formula_rows import Atom, Part, signal_rows, with_wishes
from tsplan.viewer.page_data import Json, fact_words, part_data

if TYPE_CHECKING:
    from tsplan.signals.signal_mission import SignalMission
    from tsplan.signals.trajectory import Trajectory


def signal_page_data(mission: SignalMission, trajectory: Trajectory) -> Json:
    """Everything the page needs to know; raises PlanError for a trajectory that does not fit."""
    refuse_misfit(trajectory, mission)
    several = len(trajectory.signals) > 1
    plane = plane_of(trajectory, mission) if several else ("", "")
    places = places_of(mission, plane) if several else ()
    paths = paths_of(trajectory, mission, plane) if several else {}
    colours = paints(paths)
    return {
        "title": trajectory.mission.name or mission.name or "signals",
        "outcome": outcome(trajectory, "trajectory"),
        "facts": [
            {"text": fact_words(item), "about": objective_line(item, noun="trajectory")}
            for item in trajectory.objective
        ],
        "horizon": trajectory.horizon,
        "classes": [
            {"name": name, "capabilities": [], "agents": None, "color": paint.colour, "mark": place}
            for place, (name, paint) in enumerate(colours.items())
        ],
        "signals": [
            {"name": name, "values": list(row), "control": kind is trajectory.controls}
            for kind in (trajectory.signals, trajectory.controls)
            for name, row in kind.items()
            if row
        ],
        "plane": None
        if not several
        else {
            "axes": list(plane),
            "frame": list(frame_of_plane(paths, places, mission, plane)),
            "places": _places(places),
            "paths": [path.T.tolist() for path in paths.values()],
        },
        "formula": [
            part_data(part, {place.name: n for n, place in enumerate(places)})
            for part in signal_parts(mission, trajectory, places, plane)
        ],
    }


def _places(places: tuple[Place, ...]) -> list[Json]:
    """The regions; sides that go on for ever are null."""
    colours = paints((place.name for place in places if place.wanted), HUES[::-1])
    return [
        {
            "name": place.name,
            "sides": [side if np.isfinite(side) else None for side in place.sides],
            "wanted": place.wanted,
            "color": colours[place.name].colour if place.wanted else None,
        }
        for place in places
    ]


def signal_parts(
    mission: SignalMission, trajectory: Trajectory, places: tuple[Place, ...], plane: Axes
) -> tuple[Part, ...]:
    """The rows of a mission's formula for a trajectory, then of what it prefers.

    A row has the names of the places in the plane that it speaks of.
    """
    trace = trajectory.trace()
    sides = [
        [
            {
                (((axis, 1.0),), end)
                for axis, ends in of_robot(region, robot).items()
                for end in ends
            }
            for region in map(mission.regions.__getitem__, place.regions)
            for robot in robots_in([*mission.system.signals], plane)
        ]
        for place in places
    ]

    def spoken_of(atoms: Iterable[Atom]) -> tuple[str, ...]:
        """The regions of which a part has every side."""
        used = {(atom.terms, atom.bound) for atom in atoms if isinstance(atom, Linear)}
        return tuple(
            place.name
            for place, every in zip(places, sides, strict=True)
            if any(own <= used for own in every)
        )

    texts = {part: text for text, part in mission.parts}
    return with_wishes(
        lambda formula: signal_rows(formula, trace, spoken_of, texts),
        mission.formula,
        ((wish.name, wish.formula) for wish in mission.prefer),
    )
