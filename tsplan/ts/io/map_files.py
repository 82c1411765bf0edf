"""Reading maps: one function for every format, which is recognised by its content."""

from __future__ import annotations

import pathlib
from collections.abc import Callable
from dataclasses import dataclass

from tsplan.document import Document, Path, read_document
from tsplan.document.kinds import MAP, misfit
from tsplan.errors import InputError, MapError
from tsplan.ts.io.lomap import is_lomap, read_lomap
from tsplan.ts.io.tsplan_yaml import read_own
from tsplan.ts.system import TransitionSystem


@dataclass(frozen=True, slots=True)
class MapFormat:
    """A format of maps: how to recognise it at a path of a document, and how to read it there."""

    name: str
    recognises: Callable[[Document, Path], bool]
    read: Callable[[Document, Path], TransitionSystem]


# the first that recognises a document reads it; the own format takes what no other does
FORMATS: tuple[MapFormat, ...] = (
    MapFormat("lomap", is_lomap, read_lomap),
    MapFormat("own", lambda document, path: True, read_own),  # noqa: ARG005 - a protocol
)


def map_from_document(document: Document, path: Path = ()) -> TransitionSystem:
    """The map at a path of a document, as for maps written inside a mission.

    Raises
    ------
    MapError
        Everything that is wrong with it, each with its place.

    """
    strange = misfit(document, path, MAP)
    if strange is not None:
        raise MapError([strange])
    chosen = next(item for item in FORMATS if item.recognises(document, path))
    return chosen.read(document, path)


def load_map(path: str | pathlib.Path) -> TransitionSystem:
    """The map in a file, in the own YAML format or in LOMAP's `!Ts` YAML.

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
