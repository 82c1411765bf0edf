"""New folders: a small mission that works, its map, and schemas for editors."""

from __future__ import annotations

from collections.abc import Mapping
from pathlib import Path

from tsplan.document.files import write_whole
from tsplan.errors import Finding, InputError
from tsplan.starting.file_schemas import schema_text

TEMPLATES = Path(__file__).parent / "templates"
SCHEMAS = ".tsplan"
"""The folder beside missions in which the schemas are that their first lines name."""


def files_of_kind(kind: str) -> dict[Path, bytes]:
    """The files of a new folder of a kind, one of the folders in `TEMPLATES`, by their names."""
    return {
        Path(path.name): path.read_bytes() for path in sorted((TEMPLATES / kind).glob("*.yaml"))
    }


def schema_files(*kinds: str) -> dict[Path, bytes]:
    """The schemas of some kinds of files by their places in the folder of a mission."""
    return {Path(SCHEMAS, f"{kind}.schema.json"): schema_text(kind).encode() for kind in kinds}


def write_new(
    folder: Path, files: Mapping[Path, bytes], again: Mapping[Path, bytes] | None = None
) -> None:
    """Write new files below a folder, which is made where it is missing.

    Those of `again` may be there and are written over. Raises InputError, before anything is
    written, with every file that is there already and says something else, and if a place cannot
    be written.
    """
    there = [folder / name for name, content in files.items() if _other(folder / name, content)]
    if there:
        what, remedy = "this file is there already", "choose another folder, or move it away"
        raise InputError(Finding(what, remedy, str(path)) for path in there)
    for name, content in {**(again or {}), **files}.items():
        path = folder / name
        _make(path.parent)
        write_whole(path, content)


def _other(path: Path, content: bytes) -> bool:
    """Whether something is at a place that would be lost."""
    return path.exists() and not (path.is_file() and path.read_bytes() == content)


def _make(folder: Path) -> None:
    try:
        folder.mkdir(parents=True, exist_ok=True)
    except (OSError, ValueError) as error:
        why = (error.strerror if isinstance(error, OSError) else None) or str(error)
        what = f"the folder cannot be made: {why}"
        raise InputError([Finding(what, "choose another folder", str(folder))]) from None
