"""How large numbers may be, wherever they come from: files, formulas, options, Python values.

The limits keep all arithmetic exact: sums of what is counted, over all agents and steps, stay far
below 2^53, up to which floats tell whole numbers apart, and every single number fits the 32-bit
options of the solvers.
"""

from __future__ import annotations

import math
from collections.abc import Mapping
from dataclasses import dataclass
from numbers import Integral, Real
from reprlib import repr as shortened
from types import MappingProxyType
from typing import Any

MOST_STEPS = 1_000_000
"""Steps up to the horizon, and of one move."""

MOST_ROBOTS = 10_000_000
"""Robots in a team; whoever asks for each one gets them, so a misprint must not fill the memory."""

MOST_COST = 1e20
"""The cost of an edge is below this: solvers take it for infinity."""

LARGEST = 10**15 - 1
"""Any other whole number, such as a capacity or a number of agents in a formula."""

MOST_LETTERS = 2_000_000
"""Characters of a formula: reading takes some 20 microseconds and 0.7 kB for each."""

DIGITS = 40
"""Digits of a whole number that are read as one; longer ones mean nothing here."""

LEAST_WEIGHT, MOST_WEIGHT = 1e-9, 1e9
"""The weight of a preference: wider apart, one would not count beside another."""

MOST_SECONDS = 2_000_000
"""Seconds of a time limit, some 23 days: waiting is counted in 31 bits of milliseconds."""

MOST_GAP = 1_000_000
MOST_THREADS = 1024
MOST_SEED = 1_999_999_999
MOST_RUNS = 1_000_000_000


def is_finite(value: Any) -> bool:
    """Whether a number is one that a float can hold: no NaN, not infinite, and not beyond."""
    try:
        return math.isfinite(value)
    except OverflowError:
        return False


def clipped(value: Any) -> str:
    """A value in a message, short; also a number of which Python does not write the digits.

    >>> clipped("a" * 100), clipped(10**5000)
    ("'aaaaaaaaaaaa...aaaaaaaaaaaaa'", 'a number of thousands of digits')
    """
    try:
        return shortened(value)
    except ValueError:
        return "a number of thousands of digits"


def is_number(value: Any) -> bool:
    """Whether a value is a finite int or float, and no truth value.

    >>> is_number(2.5), is_number(True), is_number(float("inf"))
    (True, False, False)
    """
    return isinstance(value, int | float) and not isinstance(value, bool) and is_finite(value)


@dataclass(frozen=True, slots=True)
class Range:
    """The numbers that an option may have: `least` to `most`.

    Both are included, unless the number has to be `above` or `below` them.

    >>> Range(1, 8, whole=True).complaint("0"), Range(0, 1).complaint(0.5)
    ("'0' is not a whole number", None)
    >>> Range(1, 8, whole=True).complaint(9)
    '9 is above 8'
    """

    least: float
    most: float
    whole: bool = False
    above: bool = False
    below: bool = False

    def complaint(self, value: Any) -> str | None:
        """What is wrong with a value, in words; None if nothing is."""
        kind, words = (Integral, "a whole number") if self.whole else (Real, "a finite number")
        if isinstance(value, bool) or not isinstance(value, kind) or not is_finite(value):
            return f"{_shown(value)} is not {words}"
        number: Any = value
        if number < self.least:
            return f"{_shown(value)} is below {self.least:,}"
        if self.above and number == self.least:
            return f"{_shown(value)} is not above {self.least:,}"
        if self.below and number == self.most:
            return f"{_shown(value)} is not below {self.most:,}"
        return f"{_shown(value)} is above {self.most:,}" if number > self.most else None


def _shown(value: Any) -> str:
    """A value in a message, short."""
    long = isinstance(value, Integral) and abs(value) >= 10**DIGITS
    text = "the number" if long else clipped(value)
    return text if len(text) <= DIGITS else f"{text[:DIGITS]}..."


OPTIONS: Mapping[str, Range] = MappingProxyType(
    {
        "time_limit": Range(0, MOST_SECONDS, above=True),
        "gap": Range(0, MOST_GAP),
        "threads": Range(1, MOST_THREADS, whole=True),
        "seed": Range(0, MOST_SEED, whole=True),
        "runs": Range(1, MOST_RUNS, whole=True),
        "probability": Range(0, 1, above=True, below=True),
    }
)
"""The numbers that commands and functions take, by their names."""


def complaints(options: Mapping[str, Any]) -> dict[str, str]:
    """What is wrong with the numbers among some options; None leaves one to its default.

    >>> complaints({"time_limit": -1.0, "seed": None, "solver": "highs"})
    {'time_limit': '-1.0 is below 0'}
    """
    return {
        name: words
        for name, value in options.items()
        if name in OPTIONS and value is not None
        if (words := OPTIONS[name].complaint(value)) is not None
    }
