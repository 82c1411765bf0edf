"""Map files of every format: each is recognised by its content, and written by its name.

A format is one module with three functions, and its line in `FORMATS`.
"""

from __future__ import annotations

import pathlib
from collections.abc import Callable
from dataclasses import dataclass

from tsplan.document import Document, Path, read_document
from tsplan.document.files import write_whole
from tsplan.document.kinds import MAP
from tsplan.document.pause import collector_paused
from tsplan.errors import InputError, MapError
from tsplan.ts.io.lomap import is_lomap, lomap_to_yaml, read_lomap
from tsplan.ts.io.tsplan_yaml import map_to_yaml, read_own
from tsplan.ts.system import TransitionSystem


@dataclass(frozen=True, slots=True)
class MapFormat:
    """A format of maps: how to recognise it at a path of a document, read it there, and write it.

    What `read` puts into the system's `extras` under the format's name is there for `write`.
    """

    name: str
    recognises: Callable[[Document, Path], bool]
    read: Callable[[Document, Path], TransitionSystem]
    write: Callable[[TransitionSystem], str]


FORMATS: tuple[MapFormat, ...] = (
    MapFormat("lomap", is_lomap, read_lomap, lomap_to_yaml),
    MapFormat("tsplan", lambda document, path: True, read_own, map_to_yaml),  # noqa: ARG005 - any
)
"""The first that recognises a document reads it; the own format takes what no other does."""


@collector_paused()
def map_from_document(document: Document, path: Path = ()) -> TransitionSystem:
    """The map at a path of a document, as for maps written inside a mission.

    Raises
    ------
    MapError
        Everything that is wrong with it, each with its place.

    """
    fault = document.misfit(path, MAP)
    if fault is not None:
        raise MapError([fault])
    return next(form for form in FORMATS if form.recognises(document, path)).read(document, path)


def load_map(path: str | pathlib.Path) -> TransitionSystem:
    """The map in a file, in the own YAML format or another of `FORMATS`, such as LOMAP's.

    Raises
    ------
    MapError
        The file cannot be read, or everything that is wrong with the map, each with its place.

    """
    try:
        document = read_document(path)
    except InputError as error:
        raise MapError(error.findings) from None
    return map_from_document(document)


def map_text(system: TransitionSystem) -> str:
    """A map as a text in the format that it was read from; in the own one for all others."""
    name = FORMATS[-1].name if system.extras is None else system.extras.format
    return next((form for form in FORMATS if form.name == name), FORMATS[-1]).write(system)


def save_map(system: TransitionSystem, path: str | pathlib.Path) -> None:
    """Write a map to a file, whole or not at all, as `map_text` says.

    Raises
    ------
    MapError
        The place cannot be written.

    """
    write_whole(pathlib.Path(path), map_text(system).encode(), MapError)
