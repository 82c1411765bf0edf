"""States as cells of a grid, by rows from the top and columns from the left."""

from __future__ import annotations

import re
from collections.abc import Iterable, Mapping
from itertools import pairwise
from typing import TypeAlias

from tsplan.errors import Finding, PlanError
from tsplan.ts import TransitionSystem
from tsplan.ts.builders import Cell
from tsplan.ts.state_places import own_place

Cells: TypeAlias = Mapping[str, Cell]
"""The row and the column of each state."""

OTHERS = "export as csv, geojson or graphml"
"""What to do with a plan that is on no grid."""

_NAME = re.compile(r"r(\d{1,9})c(\d{1,9})")  # as `tsplan.ts.builders.cell_name` makes them
_OFF = 1e-6  # of a cell: by which a middle may miss its place; coordinates are rounded decimals


def grid_cells(system: TransitionSystem) -> Cells | None:
    """The cells of all states of a map; None for a map that is no grid.

    States that are called as cells are, `r3c10`, are at these. Else the coordinates tell: the
    topmost states are in row 0, and the leftmost ones in column 0.
    """
    cells = _by_name(system.states) or _by_place(system)
    apart = cells is not None and len(set(cells.values())) == len(cells)
    return cells if apart else None


def refuse_no_grid(system: TransitionSystem) -> Cells:
    """The cells of a map; PlanError for one that is no grid."""
    cells = grid_cells(system)
    if cells is None:
        what = "the map is no grid: its states are neither called as cells (r3c10) nor lie on one"
        raise PlanError([Finding(what, OTHERS)])
    return cells


def _by_name(names: Iterable[str]) -> Cells | None:
    cells = {}
    for name in names:
        match = _NAME.fullmatch(name)
        if match is None:
            return None
        cells[name] = int(match[1]), int(match[2])
    return cells


def _by_place(system: TransitionSystem) -> Cells | None:
    """Cells by coordinates; neighbours in rows and columns are equally far from each other."""
    places = {name: own_place(state) for name, state in system.states.items()}
    known = {name: place for name, place in places.items() if place is not None}
    if len(known) < len(places):
        return None
    lines = [sorted({place[axis] for place in known.values()}) for axis in (0, 1)]
    extent = max(line[-1] - line[0] for line in lines)
    gaps = (two - one for line in lines for one, two in pairwise(line))
    side = min((gap for gap in gaps if gap > _OFF * extent), default=1.0)
    left, top = lines[0][0], lines[1][-1]
    cells: dict[str, Cell] = {}
    for name, (x, y) in known.items():
        across, down = (x - left) / side, (top - y) / side
        cell = round(down), round(across)
        if max(abs(down - cell[0]), abs(across - cell[1])) > _OFF:
            return None
        cells[name] = cell
    return cells
