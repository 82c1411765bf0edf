"""Map files of every format: each is recognised by its content, and written by its name.

A format is one module with two functions, or three, and its line in `FORMATS`. Packages beside this
one add theirs as entry points of the group `tsplan.map_readers`, each naming a `MapFormat`.
"""

from __future__ import annotations

import pathlib
from collections.abc import Callable
from dataclasses import dataclass, replace
from functools import lru_cache
from importlib.metadata import entry_points

from tsplan.document import Document, Path, parse_document
from tsplan.document.document import LARGEST_FILE
from tsplan.document.files import read_text, write_whole
from tsplan.document.kinds import MAP, is_of_ours, kind_of_data
from tsplan.document.pause import collector_paused
from tsplan.errors import Finding, InputError, MapError
from tsplan.ts.io.graphml import open_graphml
from tsplan.ts.io.label_areas import labelled
from tsplan.ts.io.lif import is_layout, read_layout
from tsplan.ts.io.lomap import is_lomap, lomap_to_yaml, read_lomap
from tsplan.ts.io.ltl_automaton import is_state_models, read_state_models
from tsplan.ts.io.map_settings import PLAIN, MapSettings
from tsplan.ts.io.movingai import is_grid, open_grid, read_grid
from tsplan.ts.io.nav2_geojson import is_route_graph, read_route_graph
from tsplan.ts.io.node_link import is_node_link, read_node_link
from tsplan.ts.io.occupancy_grid import is_occupancy, read_occupancy
from tsplan.ts.io.rmf_graph import is_rmf_graph, read_rmf_graph
from tsplan.ts.io.tsplan_yaml import map_to_yaml, read_own
from tsplan.ts.system import TransitionSystem
from tsplan.ts.waits import with_waits, without_wait

GROUP = "tsplan.map_readers"
"""The entry points by which other packages add formats."""


@dataclass(frozen=True, slots=True)
class MapFormat:
    """A format of maps: how to recognise it at a path of a document, read it there, and write it.

    What `read` puts into the system's `extras` under the format's name is there for `write`; maps
    of a format without that are written in the own one. `opens` makes a document of a text that is
    neither YAML nor JSON, and None of a text of another format. `uses` are the settings that mean
    something where the format has lengths: `speed`, `cell`, `waiting`.
    """

    name: str
    recognises: Callable[[Document, Path], bool]
    read: Callable[[Document, Path, MapSettings], TransitionSystem]
    write: Callable[[TransitionSystem], str] | None = None
    opens: Callable[[str, str], Document | None] | None = None
    uses: frozenset[str] = frozenset()


_GRAPH = frozenset({"speed", "waiting"})
_GRID = _GRAPH | {"cell"}

FORMATS: tuple[MapFormat, ...] = (
    MapFormat("nav2", is_route_graph, read_route_graph, uses=_GRAPH),
    MapFormat("rmf", is_rmf_graph, read_rmf_graph, uses=_GRAPH),
    MapFormat("movingai", is_grid, read_grid, opens=open_grid, uses=_GRID),
    MapFormat("occupancy", is_occupancy, read_occupancy, uses=_GRID),
    MapFormat("lif", is_layout, read_layout, uses=_GRAPH),
    MapFormat("ltl_automaton", is_state_models, read_state_models, uses=frozenset({"waiting"})),
    MapFormat("node_link", is_node_link, read_node_link, opens=open_graphml, uses=_GRAPH),
    MapFormat("lomap", is_lomap, lambda d, p, s: read_lomap(d, p), lomap_to_yaml),  # noqa: ARG005
    MapFormat(
        "tsplan",
        lambda document, path: True,  # noqa: ARG005 - whatever it is
        lambda document, path, settings: read_own(document, path),  # noqa: ARG005
        map_to_yaml,
    ),
)
"""The first that recognises a document reads it; the own format takes what no other does."""


@lru_cache(maxsize=1)
def added_formats() -> tuple[MapFormat, ...]:
    """The formats that other packages add.

    Raises MapError for one that cannot be loaded or is none.
    """
    found = []
    for point in entry_points(group=GROUP):
        try:
            form = point.load()
        except Exception as error:
            what = f"the map reader '{point.name}' cannot be loaded: {error}"
            raise MapError([Finding(what, "correct or remove the package")]) from error
        if not isinstance(form, MapFormat):
            what = f"the map reader '{point.name}' is no MapFormat"
            raise MapError([Finding(what, "correct or remove the package")])
        found.append(form)
    return tuple(found)


def map_document(path: str | pathlib.Path) -> Document:
    """The document of a file that may be a map of any format.

    Raises InputError where it cannot be read or is broken.
    """
    return map_document_of(read_text(path, most=LARGEST_FILE), str(path))


def map_document_of(text: str, source: str) -> Document:
    """The document of a text that may be a map of any format; InputError where it is broken."""
    for form in (*FORMATS, *added_formats()):
        document = None if form.opens is None else form.opens(text, source)
        if document is not None:
            return document
    return parse_document(text, source)


@collector_paused()
def map_from_document(
    document: Document, path: Path = (), settings: MapSettings = PLAIN
) -> TransitionSystem:
    """The map at a path of a document, as for maps written inside a mission.

    Raises
    ------
    MapError
        Everything that is wrong with it, each with its place.

    """
    form = format_of(document, path)
    said = [
        ("speed", settings.speed is not None),
        ("cell", settings.cell is not None),
        ("waiting", settings.waiting is False),
    ]
    useless = [
        settings.locate((name,), f"'{name}' has no meaning for maps of this format", "remove it")
        for name, given in said
        if given and name not in form.uses
    ]
    if useless:
        raise MapError(useless)
    system = form.read(document, path, settings)
    if settings.step is not None:
        system = replace(system, step_seconds=settings.step)
    if settings.waiting:
        system = with_waits(system, without_wait(system))
    if settings.capacity is not None:
        system = _crowded(system, settings.capacity)
    return labelled(system, settings)


def _crowded(system: TransitionSystem, capacity: int) -> TransitionSystem:
    """The map with a capacity wherever there is none; an edge and its reverse share theirs."""
    states = (
        state if state.capacity is not None else replace(state, capacity=capacity)
        for state in system.states.values()
    )
    edges = []
    for edge in system.edges.values():
        if edge.capacity is None and edge.zone is None and not edge.is_wait:
            back = system.edges.get(edge.pair[::-1])
            both = edge.both_ways or back == edge.reverse()
            edges.append(replace(edge, capacity=capacity, both_ways=both))
        else:
            edges.append(edge)
    return system.rebuilt(states, edges)


def format_of(document: Document, path: Path = ()) -> MapFormat:
    """The format of the map at a path; MapError for what is known to be none."""
    *known, own = FORMATS
    fault = document.misfit(path, MAP)
    if fault is not None and is_of_ours(kind_of_data(document.at(path)) or ""):
        raise MapError([fault])
    found = next((form for form in known if form.recognises(document, path)), None)
    if found is None and fault is None and kind_of_data(document.at(path)) == MAP:
        return own
    found = found or next((f for f in added_formats() if f.recognises(document, path)), None)
    if found is None and fault is not None:
        raise MapError([fault])
    return found or own


def is_map(document: Document) -> bool:
    """Whether a document holds a map of some format, by its content."""
    try:
        return format_of(document, ()) is not FORMATS[-1] or kind_of_data(document.data) == MAP
    except MapError:
        return False


def load_map(path: str | pathlib.Path, settings: MapSettings = PLAIN) -> TransitionSystem:
    """The map in a file, in the own YAML format or another of `FORMATS`, such as LOMAP's.

    Raises
    ------
    MapError
        The file cannot be read, or everything that is wrong with the map, each with its place.

    """
    try:
        document = map_document(path)
    except InputError as error:
        raise MapError(error.findings) from None
    return map_from_document(document, (), settings)


def map_text(system: TransitionSystem) -> str:
    """A map as a text in the format that it was read from; in the own one for all others."""
    name = FORMATS[-1].name if system.extras is None else system.extras.format
    write = next((form.write for form in FORMATS if form.name == name), None)
    return (write or map_to_yaml)(system)


def save_map(system: TransitionSystem, path: str | pathlib.Path) -> None:
    """Write a map to a file, whole or not at all, as `map_text` says.

    Raises
    ------
    MapError
        The place cannot be written.

    """
    write_whole(pathlib.Path(path), map_text(system).encode(), MapError)
