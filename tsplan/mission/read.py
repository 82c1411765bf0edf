"""Reading missions from files and texts."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path

from tsplan.document import Document, parse_document, read_document
from tsplan.errors import InputError, MissionError
from tsplan.mission.mission import Mission
from tsplan.mission.mission_draft import parts_from_document


def load_mission(path: str | Path) -> Mission:
    """Read a mission file and the map it names.

    Raises MissionError with everything that is wrong with the file, its map and its formula.
    """
    return mission_from_document(lambda: read_document(path), Path(path).parent)


def mission_from_text(text: str, source: str = "mission", folder: str | Path = ".") -> Mission:
    """Read a mission from its text; maps are looked for in `folder`. Raises MissionError."""
    return mission_from_document(lambda: parse_document(text, source), Path(folder))


def mission_from_document(document: Callable[[], Document], folder: Path) -> Mission:
    """The mission of a document that is read when it is called. Raises MissionError."""
    try:
        return Mission(**vars(parts_from_document(document(), folder)))
    except InputError as error:
        raise MissionError(error.findings) from None
