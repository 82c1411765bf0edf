"""Pictures as SVG text, for notebooks: no matplotlib, and every word is escaped."""

from __future__ import annotations

import re
from collections.abc import Iterable
from html import escape

from tsplan.draw.palette import TRAVEL_STRIPE
from tsplan.words import visible

FONT = 11.0
"""Pixels of ordinary text."""

_UNFIT = re.compile("[\ufffe\uffff]")  # what XML cannot hold beside control characters
_LETTER = 0.6  # usual width of a letter, of the font's size
_WIDE = 0x1100  # from here on letters may be twice as wide


def words(text: str) -> str:
    """A text as the content of an element or attribute: nothing of it is markup or hidden.

    >>> words('<script>"hm"</script>')
    '&lt;script&gt;&quot;hm&quot;&lt;/script&gt;'
    """
    return escape(_UNFIT.sub("\ufffd", visible(text)), quote=True)


def element(name: str, content: str = "", /, **attributes: object) -> str:
    """An element; underscores in the names of attributes become hyphens.

    `content` is markup already, values of attributes are escaped.

    >>> element("rect", x=1.25, stroke_width=2)
    '<rect x="1.2" stroke-width="2"/>'
    """
    listed = "".join(
        f' {key.rstrip("_").replace("_", "-")}="{_value(value)}"'
        for key, value in attributes.items()
        if value is not None
    )
    return f"<{name}{listed}>{content}</{name}>" if content else f"<{name}{listed}/>"


def text(content: str, x: float, y: float, size: float = FONT, **attributes: object) -> str:
    """A text at a point, escaped."""
    return element("text", words(content), x=x, y=y, font_size=size, **attributes)


def picture(parts: Iterable[str], width: float, height: float, title: str) -> str:
    """A whole picture on white, with a title that is read aloud and shown by browsers."""
    ground = element("rect", width=width, height=height, fill="#ffffff")
    return element(
        "svg",
        element("title", words(title)) + ground + "".join(parts),
        xmlns="http://www.w3.org/2000/svg",
        viewBox=f"0 0 {width:.0f} {height:.0f}",
        width=round(width),
        height=round(height),
        style="max-width:100%;height:auto",
        font_family="DejaVu Sans, Verdana, sans-serif",
        fill="#222222",
    )


def stripes() -> str:
    """The definition of the hatch of travel; use it as `fill="url(#tsplan-way)"`."""
    line = element("path", d="M0 6L6 0", stroke=TRAVEL_STRIPE, stroke_width=1)
    pattern = element(
        "pattern", line, id="tsplan-way", width=6, height=6, patternUnits="userSpaceOnUse"
    )
    return element("defs", pattern)


def width_of(content: str, size: float = FONT) -> float:
    """About how wide a text is, in pixels."""
    return sum(size * (1.0 if ord(letter) >= _WIDE else _LETTER) for letter in content)


def _value(value: object) -> str:
    if isinstance(value, float):
        return f"{value:.1f}".rstrip("0").rstrip(".") or "0"
    return words(str(value))
