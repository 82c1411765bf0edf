"""Pictures as files: PNG, and SVG and PDF, which stay sharp at any size."""

from __future__ import annotations

import io
from pathlib import Path
from typing import Any

from tsplan.errors import Finding, InputError
from tsplan.results.planfile import write_whole

RESOLUTION = 150
"""Dots per inch of PNG files."""

KINDS = ("png", "svg", "pdf")


def save(figure: Any, path: str | Path, *, resolution: float = RESOLUTION) -> None:
    """Write a figure to a file of the kind that its name ends with, PNG without an ending.

    The file is written whole or not at all, and without the date, so that equal pictures are equal
    files where matplotlib allows it. Raises InputError for another ending or a place that cannot be
    written.
    """
    place = Path(path)
    write_whole(place, content(figure, kind_of(place), resolution))


def kind_of(path: Path) -> str:
    """The kind of picture a file name asks for; InputError if it is none that is written."""
    kind = path.suffix.lstrip(".").lower() or "png"
    if kind not in KINDS:
        what = f"pictures cannot be written as '.{kind}'"
        raise InputError([Finding(what, "use .png, .svg or .pdf", str(path))])
    return kind


def content(figure: Any, kind: str, resolution: float = RESOLUTION) -> bytes:
    """A figure in the bytes of a file."""
    metadata = {"png": {}, "svg": {"Date": None}, "pdf": {"CreationDate": None}}[kind]
    stream = io.BytesIO()
    figure.savefig(stream, format=kind, dpi=resolution, metadata=metadata)
    return stream.getvalue()
