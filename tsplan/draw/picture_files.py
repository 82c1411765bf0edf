"""Pictures as files: PNG, and SVG and PDF, which stay sharp at any size."""

from __future__ import annotations

import io
from collections.abc import Callable
from pathlib import Path
from typing import Any

from tsplan.document.files import write_whole
from tsplan.draw.matplotlib_loading import lacking, library, tell_lost
from tsplan.errors import Finding, InputError

RESOLUTION = 150
"""Dots per inch of PNG files."""

KINDS = ("png", "svg", "pdf")

# text as text with the names of its fonts, and the same ids in equal pictures
_STYLE = {"svg.fonttype": "none", "svg.hashsalt": "tsplan"}


def save_picture(
    picture: Any,
    path: str | Path,
    *,
    dpi: float = RESOLUTION,
    tell: Callable[[str], object] | None = None,
) -> None:
    """Write a picture to a file of the kind that its name ends with, PNG without an ending.

    `picture` is a figure, or what `plot` returns; `dpi` are the dots per inch of a PNG file.

    The file is written whole or not at all, and without the date, so that equal pictures are equal
    files where matplotlib allows it. The text of an SVG file stays text. Letters that no font could
    draw are named in one sentence to `tell`, without it as MissingLettersWarning. Raises InputError
    for another ending or a place that cannot be written.
    """
    place = Path(path)
    figure = picture[0] if isinstance(picture, tuple) else picture
    write_whole(place, content(figure, kind_of(place), dpi, tell, place))


def kind_of(path: Path) -> str:
    """The kind of picture a file name asks for; InputError if it is none that is written."""
    kind = path.suffix.lstrip(".").lower() or "png"
    if kind not in KINDS:
        what = f"pictures cannot be written as '.{kind}'"
        raise InputError([Finding(what, "use .png, .svg or .pdf", str(path))])
    return kind


def content(
    figure: Any,
    kind: str,
    resolution: float = RESOLUTION,
    tell: Callable[[str], object] | None = None,
    place: Path | None = None,
) -> bytes:
    """A figure in the bytes of a file, which may be named; `tell` as for `save`."""
    metadata = {"png": {}, "svg": {"Date": None}, "pdf": {"CreationDate": None}}[kind]
    stream = io.BytesIO()
    with lacking() as letters, library("style").context(_STYLE):
        figure.savefig(stream, format=kind, dpi=resolution, metadata=metadata)
    lost = letters if kind != "svg" else ()
    tell_lost(lost, "an .svg file keeps its text as text", tell, place or "")
    return stream.getvalue()
