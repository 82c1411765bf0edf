"""Pictures of grey dots as arrays: PGM by itself, others where matplotlib's pillow is installed.

PGM is read as https://netpbm.sourceforge.net/doc/pgm.html says, plain (P2) and raw (P5).
"""

from __future__ import annotations

import io
import pathlib
import re

import numpy as np
from numpy.typing import NDArray

from tsplan.document.files import read_bytes
from tsplan.document.kinds import kind_of_bytes
from tsplan.errors import Finding, InputError

LARGEST = 256 * 1024 * 1024  # bytes of a picture
_TWO_BYTES = 256  # a greatest value from here on takes two bytes a dot
_TOKEN = re.compile(rb"(?:\s|#[^\n]*\n)*(\S+)")


def read_grey(path: pathlib.Path) -> NDArray[np.float64]:
    """The dots of a picture, row by row from the top, from 0 (black) to 1 (white).

    Raises
    ------
    InputError
        The file cannot be read, is broken, or is of a kind that needs pillow.

    """
    raw = read_bytes(path, most=LARGEST)
    if raw[:2] in (b"P2", b"P5"):
        try:
            return _pgm(raw)
        except ValueError as error:
            raise InputError(
                [Finding(f"not a whole PGM picture: {error}", "", str(path))]
            ) from None
    try:
        from PIL import Image, UnidentifiedImageError  # noqa: PLC0415 - comes with matplotlib
    except ImportError:
        kind = kind_of_bytes(raw) or "no PGM picture"
        remedy = "save it as PGM, or install tsplan[plot], which brings a reader for others"
        raise InputError([Finding(f"this is {kind}", remedy, str(path))]) from None
    try:
        with Image.open(io.BytesIO(raw)) as image:
            wide = image.mode.startswith("I")
            grey = np.asarray(image if wide else image.convert("L"), dtype=np.float64)
    except (UnidentifiedImageError, OSError, ValueError, SyntaxError) as error:
        raise InputError(
            [Finding(f"not a picture: {error}", "save it as PGM", str(path))]
        ) from None
    return grey / (65535 if wide else 255)


def _pgm(raw: bytes) -> NDArray[np.float64]:
    """The dots of a PGM picture; ValueError where it is broken."""
    at, numbers = 2, []
    for name in ("width", "height", "greatest value"):
        found = _TOKEN.match(raw, at)
        if found is None or not found[1].isdigit():
            raise ValueError(f"its {name} is missing")
        numbers.append(int(found[1]))
        at = found.end()
    width, height, most = numbers
    if not (width and height and 0 < most <= 65535):  # noqa: PLR2004 - two bytes
        raise ValueError(f"it is {width} x {height} with values up to {most}")
    if raw[:2] == b"P2":
        words = re.sub(rb"#[^\n]*", b"", raw[at:]).split()
        dots = np.array(words[: width * height], dtype=np.float64)
    else:
        kind = np.dtype(">u2" if most >= _TWO_BYTES else "u1")
        whole = raw[at + 1 : at + 1 + width * height * kind.itemsize]
        dots = np.frombuffer(whole[: len(whole) // kind.itemsize * kind.itemsize], dtype=kind)
    if len(dots) < width * height:
        raise ValueError(f"it has {len(dots)} of its {width * height} dots")
    return dots.reshape(height, width).astype(np.float64) / most
