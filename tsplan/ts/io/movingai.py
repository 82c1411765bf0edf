"""Grid maps of the MovingAI benchmarks, and of the League of Robot Runners, which are such maps.

The characters are those of https://movingai.com/benchmarks/formats.html: `.` and `G` are free, `S`
is a swamp, `W` water, which cannot be entered from land; `@`, `O` and `T` are blocked. In maps of
the League `E` is where goods arrive and `S` where they are worked on. Robots move to one of the
four next cells; the first cell is the upper left one.
"""

from __future__ import annotations

import re
from collections.abc import Iterator

from tsplan.document import Document, Path
from tsplan.document.document import document_of
from tsplan.document.yaml_nodes import Node
from tsplan.errors import clipped
from tsplan.limits import DIGITS
from tsplan.ts.builders import cell_name
from tsplan.ts.edges import State
from tsplan.ts.io.graph_draft import GraphDraft
from tsplan.ts.io.map_settings import MapSettings
from tsplan.ts.ride_durations import Ride
from tsplan.ts.system import TransitionSystem

TAG = "!octile"
_BEGINNING = re.compile(r"\s*type \w+[ \t]*\r?\n(?:(?:height|width) [^\n]*\n){2}map[ \t]*\r?\n")
_FREE, _BLOCKED, _WATER = frozenset(".GSEW"), frozenset("@OT"), "W"
_STEPS = ((0, 1), (1, 0), (0, -1), (-1, 0))


def open_grid(text: str, source: str) -> Document | None:
    """A grid map as a document with the places of its rows; None for any other text."""
    if _BEGINNING.match(text) is None:
        return None
    offset, rows, fields, keys = 0, Node([], 1, 1, 0, 0, children=[]), {}, {}
    inside = False
    for number, line in enumerate(text.split("\n"), start=1):
        shown = line.rstrip("\r")
        node = Node(shown, number, 1, offset, offset + len(shown), text=shown)
        if inside:
            rows.value.append(shown)
            assert isinstance(rows.children, list)
            rows.children.append(node)
        elif shown.strip() == "map":
            inside, rows.line = True, number
            fields["map"], keys["map"] = rows, (number, 1)
        elif shown.strip():
            key, _, value = shown.strip().partition(" ")
            column = shown.find(value) + 1
            fields[key] = Node(value, number, column, offset, offset + len(shown), text=value)
            keys[key] = (number, 1)
        offset += len(line) + 1
    while rows.value and not rows.value[-1].strip():
        rows.value.pop()
        assert isinstance(rows.children, list)
        rows.children.pop()
    values = {key: node.value for key, node in fields.items()}
    root = Node(values, 1, 1, 0, len(text), TAG, children=fields, keys=keys)
    return document_of(root, text, source)


def is_grid(document: Document, path: Path) -> bool:
    """Whether a document was made by `open_grid`."""
    return document.node(path).tag == TAG


def _cells(document: Document, path: Path, draft: GraphDraft) -> Iterator[tuple[int, int, str]]:
    """Row, column and character of every cell; what is wrong with the grid is kept."""
    sizes = {}
    for key in ("height", "width"):
        if key not in document.at(path):
            draft.refuse(path, f"'{key}' is missing", f"add '{key} ...'")
            continue
        text = str(document.at((*path, key)))
        if not (text.isascii() and text.isdigit() and len(text) <= DIGITS):
            what = f"{key}: '{clipped(text)}' is no whole number"
            draft.refuse((*path, key), what, "count the cells")
        else:
            sizes[key] = int(text)
    rows = document.at((*path, "map"))
    if "height" in sizes and len(rows) != sizes["height"]:
        what = f"the map has {len(rows)} rows, and its height is {sizes['height']}"
        draft.refuse((*path, "height"), what, "correct one of them")
    for number, row in enumerate(rows):
        where = (*path, "map", number)
        if "width" in sizes and len(row) != sizes["width"]:
            what = f"this row has {len(row)} cells, and the width is {sizes['width']}"
            draft.refuse(where, what, "correct one of them")
        for column, char in enumerate(row):
            if char not in _FREE | _BLOCKED:
                what = f"'{char}' (column {column + 1}) is no kind of cell"
                draft.refuse(where, what, "known: . G S W E are cells, @ O T are blocked")
            elif char in _FREE:
                yield number, column, char


def read_grid(document: Document, path: Path, settings: MapSettings) -> TransitionSystem:
    """A grid map: a state for every cell that is not blocked, called as `builders.grid` does.

    A cell is a metre wide, or as the settings say; its id is its number, row by row.
    Raises MapError with all that is wrong.
    """
    draft = GraphDraft(document, path, settings=settings)
    side = 1.0 if settings.cell is None else settings.cell
    cells = {(row, column): char for row, column, char in _cells(document, path, draft)}
    league = "E" in cells.values()
    swamp = "service" if league else "swamp"
    label = {"S": swamp, "W": "water", "E": "emitter"}
    rows = document.at((*path, "map"))
    for (row, column), char in cells.items():
        labels = frozenset({label[char]}) if char in label else frozenset[str]()
        at = (column + 0.5) * side, (row + 0.5) * side
        origin = row * len(rows[0]) + column
        state = State(cell_name(row, column), labels, at, origin=origin)
        draft.add_node((row, column), state, (*path, "map", row))
    ride = Ride(length=side)
    for (row, column), char in cells.items():
        for down, right in _STEPS:
            there = (row + down, column + right)
            if there in cells and (cells[there] == _WATER) == (char == _WATER):
                ends = cell_name(row, column), cell_name(*there)
                draft.add_ride(ends, ride, (*path, "map", row))
    kind = document.at((*path, "type"))
    if kind == "octile":
        draft.note((*path, "type"), "robots move in four directions: diagonal moves are not used")
    water = sum(char == _WATER for char in cells.values())
    if 0 < water < len(cells):
        draft.note((*path, "map"), f"{water} cells of water cannot be entered from land")
    return draft.finished("")
