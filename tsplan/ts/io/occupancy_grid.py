"""Occupancy grids of ROS's map_server: YAML beside a picture, as a grid of larger cells.

What a dot means is as in https://wiki.ros.org/map_server: its occupancy is its darkness, or its
brightness with `negate`; above `occupied_thresh` it is occupied, below `free_thresh` free, and
unknown between. A cell is a state where all its dots are free.
"""

from __future__ import annotations

import math
import pathlib
from typing import Annotated

import numpy as np
from numpy.typing import NDArray
from pydantic import BaseModel, ConfigDict, Field

from tsplan.document import Document, Path
from tsplan.document.fields import Number, Word
from tsplan.document.files import beside
from tsplan.errors import InputError, MapError
from tsplan.ts.builders import cell_name
from tsplan.ts.edges import State
from tsplan.ts.io.graph_draft import GraphDraft
from tsplan.ts.io.grey_image import MOST_DOTS, read_grey
from tsplan.ts.io.map_settings import MapSettings
from tsplan.ts.ride_durations import Ride
from tsplan.ts.system import TransitionSystem

CELL = 1.0
"""Metres of the side of a cell, where nothing is said."""

MOST_CELLS = 1_000_000
_KEYS = {"image", "resolution", "origin"}
_STEPS = ((0, 1), (1, 0), (0, -1), (-1, 0))


class _File(BaseModel):
    model_config = ConfigDict(extra="ignore", defer_build=True)
    image: Word
    resolution: Annotated[Number, Field(gt=0)]
    origin: Annotated[list[Number], Field(min_length=2, max_length=3)]
    occupied_thresh: Annotated[Number, Field(ge=0, le=1)] = 0.65
    free_thresh: Annotated[Number, Field(ge=0, le=1)] = 0.196
    negate: bool | int = 0
    mode: str = "trinary"


def is_occupancy(document: Document, path: Path) -> bool:
    """Whether what stands at a path names a picture, its resolution and its origin."""
    data = document.at(path)
    return isinstance(data, dict) and data.keys() >= _KEYS


def read_occupancy(document: Document, path: Path, settings: MapSettings) -> TransitionSystem:
    """A grid of the free cells of a picture, of the side that the settings say.

    Cells lie from the lower left corner on, where the origin is, and are called by rows from above:
    `r2c10` is in the third. What is left of the picture above and on the right is no cell.
    Raises MapError with all that is wrong.
    """
    draft = GraphDraft(document, path, settings=settings)
    file = draft.part(_File, path)
    if file is None:
        raise MapError(draft.findings)
    if file.mode == "raw":  # the dots are occupancies, and no thresholds apply
        what = "mode: dots of the mode 'raw' are not read"
        raise MapError([document.finding((*path, "mode"), what, "save the map as 'trinary'")])
    picture = beside(pathlib.Path(document.source).parent, file.image)
    try:
        grey = read_grey(picture)
    except InputError as error:
        for found in error.findings:
            message = f"the picture '{file.image}': {found.message}"
            draft.refuse((*path, "image"), message, found.remedy)
        raise MapError(draft.findings) from None
    side = CELL if settings.cell is None else settings.cell
    if side / file.resolution > MOST_DOTS:
        what = f"a cell of {side:g} m has more than {MOST_DOTS:,} dots of {file.resolution:g} m"
        raise MapError([document.finding((*path, "resolution"), what, "choose a smaller cell")])
    dots = max(1, round(side / file.resolution))
    side = round(dots * file.resolution, 9)
    free = _free_cells(grey, file, dots)
    if free.size > MOST_CELLS:
        what = f"{free.size:,} cells of {side:g} m are more than {MOST_CELLS:,}"
        raise MapError([document.finding((*path, "resolution"), what, "choose a larger cell")])
    draft.note(
        (*path, "image"),
        f"{free.shape[0]} x {free.shape[1]} cells of {side:g} m ({dots} x {dots} dots), "
        f"{int(free.sum())} of them free in all their dots",
    )
    _add_cells(draft, free, side, file.origin)
    return draft.finished("", frame="map")


def _free_cells(grey: NDArray[np.float64], file: _File, dots: int) -> NDArray[np.bool_]:
    """Which cells are free, rows from above; those that the picture has only in part are not."""
    occupancy = grey if file.negate else 1 - grey
    free = occupancy < file.free_thresh
    rows, columns = free.shape[0] // dots, free.shape[1] // dots
    whole = free[free.shape[0] - rows * dots :, : columns * dots]
    return np.asarray(whole.reshape(rows, dots, columns, dots).all(axis=(1, 3)))


def _add_cells(
    draft: GraphDraft, free: NDArray[np.bool_], side: float, origin: list[float]
) -> None:
    """A state for every free cell, and moves to the four next ones."""
    turn = origin[2] if len(origin) > 2 else 0.0  # noqa: PLR2004 - x, y and an angle
    across, up = math.cos(turn), math.sin(turn)
    where = (*draft.path, "image")
    for row, column in np.argwhere(free).tolist():
        x, y = (column + 0.5) * side, (free.shape[0] - row - 0.5) * side
        at = origin[0] + across * x - up * y, origin[1] + up * x + across * y
        number = row * free.shape[1] + column
        state = State(cell_name(row, column), at=at, origin=number)
        draft.add_node((row, column), state, where)
    ride = Ride(length=side)
    for row, column in np.argwhere(free).tolist():
        for down, right in _STEPS:
            there = (row + down, column + right)
            if 0 <= there[0] < free.shape[0] and 0 <= there[1] < free.shape[1] and free[there]:
                draft.add_ride((cell_name(row, column), cell_name(*there)), ride, where)
