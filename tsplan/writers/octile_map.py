"""The grid that a plan is on as a map of the MovingAI benchmarks, which PlanViz shows it on.

The format is described at https://movingai.com/benchmarks/formats.html: four lines of words, then a
line for every row from the top, with `.` for a cell that is free and `@` for one that is not.
"""

from __future__ import annotations

from collections import defaultdict
from collections.abc import Iterator

from tsplan.errors import Finding, PlanError
from tsplan.writers.grid_cells import refuse_no_grid
from tsplan.writers.handover import Handover

_MOST_CELLS = 10**8  # in the whole rectangle, free or not: a file of a tenth of a gigabyte


def write(handover: Handover) -> Iterator[str]:
    """The grid of the plan's map, the states being the free cells.

    Raises
    ------
    PlanError
        The map is no grid, or its states are so far apart that the file would be huge.

    """
    cells = refuse_no_grid(handover.system)
    free: dict[int, list[int]] = defaultdict(list)
    for row, column in cells.values():
        free[row].append(column)
    height, width = max(free) + 1, max(column for _, column in cells.values()) + 1
    if height * width > _MOST_CELLS:
        what = f"the grid has {height:,} rows and {width:,} columns, of which few are used"
        raise PlanError([Finding(what, "count rows and columns from 0 on where they begin")])
    yield f"type octile\nheight {height}\nwidth {width}\nmap\n"
    for row in range(height):
        line = bytearray(b"@" * width)
        for column in free.get(row, ()):
            line[column : column + 1] = b"."
        yield line.decode("ascii") + "\n"
