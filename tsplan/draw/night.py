"""Pictures on a dark ground: every colour of a finished figure mirrored in its lightness.

What is light becomes dark and what is dark light, by one falling line; hues stay. So text can still
be read on what it stands on, and nothing has to be drawn in another way. Bright areas of a hue
would drown in the ground, so these stay a little above it. Colours are taken to CIELAB and back;
those that a screen cannot show lose as much of their chroma as it takes.

Source: CIE 15:2018, Colorimetry (L*, a*, b* under D65); the primaries are those of sRGB, IEC
61966-2-1.
"""

from __future__ import annotations

import math
from collections.abc import Iterable, Iterator
from functools import lru_cache
from typing import Any

import numpy as np
import numpy.typing as npt

from tsplan.draw.matplotlib_loading import library

Floats = npt.NDArray[np.float64]

GROUND = 8.0
"""Lightness of the ground, which is white in a light picture."""

_ABOVE = 26.0  # by which full hues stay lighter than the ground
_FULL = 60.0  # chroma of a full hue
_BRIGHTEST = 95.0  # of what is black in a light picture
_TO_XYZ = np.array(
    [
        [0.4124564, 0.3575761, 0.1804375],
        [0.2126729, 0.7151522, 0.0721750],
        [0.0193339, 0.1191920, 0.9503041],
    ]
)
_FROM_XYZ = np.linalg.inv(_TO_XYZ)
_WHITE = _TO_XYZ.sum(axis=1)
_EDGE, _SLOPE = (6 / 29) ** 3, (29 / 6) ** 2 / 3  # where the cube root becomes a line
_ROUNDED = 1e-6  # by which rounding may make a part of a colour exceed 0..1
_ROUNDS = 12  # halvings of the chroma that a screen can show


def darkened(figure: Any) -> Any:
    """The same figure on a dark ground; all its artists are painted anew, and it is returned."""
    for artist in _artists(figure):
        _repaint(artist)
    return figure


@lru_cache(maxsize=4096)
def mirrored(red: float, green: float, blue: float) -> tuple[float, float, float]:
    """A colour, in parts of 0..1, with its lightness mirrored.

    >>> [round(part, 2) for part in mirrored(1.0, 1.0, 1.0)]
    [0.09, 0.09, 0.09]
    >>> [round(part, 2) for part in mirrored(0.0, 0.0, 0.0)]
    [0.94, 0.94, 0.94]
    """
    lightness, *chroma = _lab(np.array([red, green, blue])).tolist()
    least = GROUND + _ABOVE * min(1.0, math.hypot(*chroma) / _FULL)
    light = max(least, _BRIGHTEST - (_BRIGHTEST - GROUND) / 100 * lightness)
    low, high = 0.0, 1.0
    made = _rgb(np.array([light, *chroma]))
    if _unshown(made):
        for _ in range(_ROUNDS):
            middle = (low + high) / 2
            made = _rgb(np.array([light, *(part * middle for part in chroma)]))
            low, high = (low, middle) if _unshown(made) else (middle, high)
        made = _rgb(np.array([light, *(part * low for part in chroma)]))
    red, green, blue = np.clip(made, 0.0, 1.0).tolist()
    return red, green, blue


def _unshown(rgb: Floats) -> bool:
    return bool((np.abs(rgb - 0.5) > 0.5 + _ROUNDED).any())


def _lab(rgb: Floats) -> Floats:
    linear = np.where(rgb <= 0.04045, rgb / 12.92, ((rgb + 0.055) / 1.055) ** 2.4)  # noqa: PLR2004
    share = _TO_XYZ @ linear / _WHITE
    x, y, z = np.where(share > _EDGE, np.cbrt(share), _SLOPE * share + 4 / 29)
    return np.array([116 * y - 16, 500 * (x - y), 200 * (y - z)])


def _rgb(lab: Floats) -> Floats:
    y = (lab[0] + 16) / 116
    roots = np.array([y + lab[1] / 500, y, y - lab[2] / 200])
    share = np.where(roots > 6 / 29, roots**3, (roots - 4 / 29) / _SLOPE)
    linear = _FROM_XYZ @ (share * _WHITE)
    bent = 1.055 * np.maximum(linear, 0.0031308) ** (1 / 2.4) - 0.055
    return np.asarray(np.where(linear <= 0.0031308, 12.92 * linear, bent))  # noqa: PLR2004 (sRGB)


def _artists(figure: Any) -> Iterator[Any]:
    """Every artist of a figure once, also the boxes behind texts, which are no children."""
    seen: set[int] = set()
    for artist in figure.findobj():
        box = artist.get_bbox_patch() if hasattr(artist, "get_bbox_patch") else None
        for one in (artist, box):
            if one is not None and id(one) not in seen:
                seen.add(id(one))
                yield one


def _repaint(artist: Any) -> None:
    """Mirror the colours of one artist."""
    if isinstance(artist, library("collections").Collection):
        faces, edges = artist.get_facecolor(), artist.get_edgecolor()
        artist.set_facecolor(_all(faces))
        if len(edges):
            artist.set_edgecolor(_all(edges))
    elif isinstance(artist, library("patches").Patch):
        face, edge = artist.get_facecolor(), artist.get_edgecolor()
        artist.set_facecolor(_one(face))
        artist.set_edgecolor(_one(edge))  # hatches have the colour of the edge
    elif isinstance(artist, library("lines").Line2D):
        face, edge = artist.get_markerfacecolor(), artist.get_markeredgecolor()
        artist.set_color(_one(artist.get_color()))
        artist.set_markerfacecolor(_one(face))
        artist.set_markeredgecolor(_one(edge))
    elif isinstance(artist, library("text").Text):
        artist.set_color(_one(artist.get_color()))


def _all(colours: Iterable[Any]) -> list[tuple[float, ...]]:
    return [_one(colour) for colour in colours]


def _one(colour: Any) -> Any:
    """A colour in any form of matplotlib's, mirrored, its opacity kept; no colour stays none."""
    if isinstance(colour, str) and colour in ("none", "auto"):
        return colour
    *parts, opacity = library("colors").to_rgba(colour)
    if not opacity:
        return "none"
    return (*mirrored(*(round(float(part), 4) for part in parts)), float(opacity))
