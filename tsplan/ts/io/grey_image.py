"""Pictures of grey dots as arrays: PGM by itself, others where matplotlib's pillow is installed.

PGM is read as https://netpbm.sourceforge.net/doc/pgm.html says, plain (P2) and raw (P5).
"""

from __future__ import annotations

import io
import pathlib
import re
import warnings
from typing import Any

import numpy as np
from numpy.typing import NDArray

from tsplan.document.files import read_bytes
from tsplan.document.kinds import kind_of_bytes
from tsplan.errors import Finding, InputError

LARGEST = 256 * 1024 * 1024  # bytes of a picture
MOST_DOTS = 50_000_000  # 350 m each way at 5 cm; more may be told by a file of a few bytes
_DIGITS = 9  # of a number in the head of a PGM picture
_KINDS = ("PNG", "BMP", "GIF", "JPEG", "PPM", "TIFF")
"""What pillow may open: pixels, and nothing that starts another program (as EPS does)."""

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
        from PIL import Image  # noqa: PLC0415 - comes with matplotlib
    except ImportError:
        kind = kind_of_bytes(raw) or "no PGM picture"
        remedy = "save it as PGM, or install tsplan[plot], which brings a reader for others"
        raise InputError([Finding(f"this is {kind}", remedy, str(path))]) from None
    try:
        return _opened(raw, Image)
    except Exception as error:  # noqa: BLE001 - pillow's readers of broken files raise of any kind
        raise InputError(
            [Finding(f"not a picture: {_words(error)}", "save it as PGM", str(path))]
        ) from None


def _opened(raw: bytes, pillow: Any) -> NDArray[np.float64]:
    """The dots of a picture that pillow reads, whose size is asked of its head first."""
    with warnings.catch_warnings():
        warnings.simplefilter("ignore")  # of sizes and of tags, which are judged here
        with pillow.open(io.BytesIO(raw), formats=_KINDS) as image:
            _refuse_size(*image.size)
            wide = image.mode.startswith("I")
            grey = np.asarray(image if wide else image.convert("L"), dtype=np.float64)
    return grey / (65535 if wide else 255)


def _words(error: Exception) -> str:
    """What is wrong, in the words of this reader where pillow's tell of its own insides."""
    name = type(error).__name__
    if name == "UnidentifiedImageError":
        return "it is none of " + ", ".join(_KINDS)
    if name == "DecompressionBombError":
        return f"its dots are more than {MOST_DOTS:,}"
    return " ".join(str(error).split()) or type(error).__name__


def _refuse_size(width: int, height: int) -> None:
    """Raise ValueError for a picture of more dots than a map has."""
    if width * height > MOST_DOTS:
        raise ValueError(f"its {width} x {height} dots are more than {MOST_DOTS:,}")


def _pgm(raw: bytes) -> NDArray[np.float64]:
    """The dots of a PGM picture; ValueError where it is broken."""
    at, numbers = 2, []
    for name in ("width", "height", "greatest value"):
        found = _TOKEN.match(raw, at)
        if found is None or not found[1].isdigit() or len(found[1]) > _DIGITS:
            raise ValueError(f"its {name} is missing")
        numbers.append(int(found[1]))
        at = found.end()
    width, height, most = numbers
    if not (width and height and 0 < most <= 65535):  # noqa: PLR2004 - two bytes
        raise ValueError(f"it is {width} x {height} with values up to {most}")
    _refuse_size(width, height)
    if raw[:2] == b"P2":
        words = re.sub(rb"#[^\n]*", b"", raw[at:]).split(None, width * height)
        dots = np.array(words[: width * height], dtype=np.float64)
    else:
        kind = np.dtype(">u2" if most >= _TWO_BYTES else "u1")
        whole = raw[at + 1 : at + 1 + width * height * kind.itemsize]
        dots = np.frombuffer(whole[: len(whole) // kind.itemsize * kind.itemsize], dtype=kind)
    if len(dots) < width * height:
        raise ValueError(f"it has {len(dots)} of its {width * height} dots")
    return dots.reshape(height, width).astype(np.float64) / most
