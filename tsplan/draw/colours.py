"""Colours as numbers: reading names, and how light a colour looks."""

from __future__ import annotations

import re
from importlib.resources import files
from types import MappingProxyType
from typing import TypeAlias

Rgb: TypeAlias = tuple[int, int, int]

_HEX = re.compile(r"#([0-9a-f]{3}|[0-9a-f]{6})\Z")
_MOST = 255
_DARK = 49.6  # lightness at which black and white are read equally well on a colour

_WORDS = (files("tsplan.draw") / "css_colours.txt").read_text(encoding="utf-8")

NAMED = MappingProxyType(
    {word: f"#{value}" for word, value in re.findall(r"([a-z]+) ([0-9a-f]{6})", _WORDS)}
)
"""The colour words of CSS (level 4) with their values."""


def colour_of(word: str | None) -> str | None:
    """A colour word or `#rgb`/`#rrggbb` as `#rrggbb`; None for anything else.

    Nothing but this form ever comes out, so it may stand in SVG and HTML as it is.

    >>> colour_of("Tan"), colour_of("#0af"), colour_of("red;}")
    ('#d2b48c', '#00aaff', None)
    """
    if word is None:
        return None
    text = word.strip().lower()
    if text in NAMED:
        return NAMED[text]
    match = _HEX.match(text)
    if match is None:
        return None
    digits = match.group(1)
    return "#" + (digits if len(digits) > 3 else "".join(d + d for d in digits))  # noqa: PLR2004  (#rgb)


def rgb(colour: str) -> Rgb:
    """The three parts of `#rrggbb`, 0..255."""
    return int(colour[1:3], 16), int(colour[3:5], 16), int(colour[5:7], 16)


def lightness(colour: str) -> float:
    """How light a colour looks, from 0 (black) to 100 (white): L* of CIELAB.

    >>> round(lightness("#ffffff")), round(lightness("#808080"))
    (100, 54)
    """
    parts = (part / _MOST for part in rgb(colour))
    linear = (p / 12.92 if p <= 0.04045 else ((p + 0.055) / 1.055) ** 2.4 for p in parts)  # noqa: PLR2004  (sRGB)
    y = sum(weight * part for weight, part in zip((0.2126, 0.7152, 0.0722), linear, strict=True))
    return 116 * y ** (1 / 3) - 16 if y > 216 / 24389 else y * 24389 / 27


def ink_on(colour: str) -> str:
    """Black or white, whichever is read better on a colour.

    >>> ink_on("#ffd700"), ink_on("#00008b")
    ('#000000', '#ffffff')
    """
    return "#ffffff" if lightness(colour) < _DARK else "#000000"


def mixed(colour: str, other: str, share: float) -> str:
    """A colour with a share (0..1) of another one mixed in.

    >>> mixed("#ff0000", "#ffffff", 0.5)
    '#ff8080'
    """
    parts = (round(a + (b - a) * share) for a, b in zip(rgb(colour), rgb(other), strict=True))
    return "#" + "".join(f"{part:02x}" for part in parts)
