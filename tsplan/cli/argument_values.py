"""Values of options: read from their words, with a complaint about what cannot be."""

from __future__ import annotations

import argparse
from collections.abc import Callable
from math import inf
from typing import Any

from tsplan.limits import DIGITS, LARGEST, OPTIONS, Range

MOST_FRAMES = 50  # a second; players of GIFs show no more
MOST_JOBS = 1000  # processes side by side
LEAST_SIDE, MOST_SIDE = 200, 4000  # dots of a moving picture
LEAST_SHEET, MOST_SHEET = 2, 100  # inches of a picture
MOST_DOTS = 1200  # per inch


def names(text: str) -> list[str]:
    """Names with commas between them."""
    found = [name for part in text.split(",") if (name := part.strip())]
    if not found:
        raise argparse.ArgumentTypeError(f"'{clipped(text)}' names nobody")
    return found


def clipped(text: str) -> str:
    """A text of a bearable length."""
    return text if len(text) <= DIGITS else f"{text[:DIGITS]}..."


def reader(allowed: Range) -> Callable[[str], Any]:
    """A reader of numbers in a range."""
    kind, what = (int, "a whole number") if allowed.whole else (float, "a number")

    def read(text: str) -> Any:
        try:
            value = kind(text)
        except ValueError:
            raise argparse.ArgumentTypeError(f"'{clipped(text)}' is not {what}") from None
        words = allowed.complaint(value)
        if words is not None:
            raise argparse.ArgumentTypeError(words)
        return value

    return read


def amplitude(text: str) -> tuple[str, float]:
    """A number for all signals, by no name, or for the one that is named before it."""
    name, _, value = text.rpartition("=")
    most: float = reader(Range(0, LARGEST))(value)
    return name.strip(), most


def speed(text: str) -> tuple[str, float]:
    """Metres a second for all classes, by no name, or for the one that is named before them."""
    name, _, value = text.rpartition("=")
    metres: float = positive(value)
    return name.strip(), metres


def size(text: str) -> tuple[int, int]:
    """Width and height in dots."""
    width, cross, height = text.lower().partition("x")
    if not cross:
        raise argparse.ArgumentTypeError(f"'{text}' is not WIDTHxHEIGHT, as in 960x600")
    side = reader(Range(LEAST_SIDE, LARGEST, whole=True))
    size = side(width), side(height)
    if max(size) > MOST_SIDE:
        raise argparse.ArgumentTypeError(f"'{text}' is larger than {MOST_SIDE}x{MOST_SIDE}")
    return size


def sheet(text: str) -> tuple[float, float]:
    """Width and height in inches."""
    width, cross, height = text.lower().partition("x")
    if not cross:
        raise argparse.ArgumentTypeError(f"'{clipped(text)}' is not WIDTHxHEIGHT, as in 7x4.5")
    side = reader(Range(LEAST_SHEET, MOST_SHEET))
    return side(width), side(height)


def ends(text: str) -> tuple[str, tuple[float, float]]:
    """A name, and the least and the greatest value that it has."""
    name, _, both = text.rpartition("=")
    low, colon, high = both.partition(":")
    if not (name and colon):
        raise argparse.ArgumentTypeError(f"'{clipped(text)}' is not NAME=LOW:HIGH, as in x=0:10")
    return name, (any_number(low), any_number(high))


any_number = reader(Range(-inf, inf))
positive = reader(OPTIONS["time_limit"])
share = reader(OPTIONS["gap"])
chance = reader(OPTIONS["probability"])
count = reader(Range(1, LARGEST, whole=True))
whole = reader(Range(0, LARGEST, whole=True))
jobs = reader(Range(1, MOST_JOBS, whole=True))
threads = reader(OPTIONS["threads"])
seed = reader(OPTIONS["seed"])
runs = reader(OPTIONS["runs"])
moment = reader(Range(0, LARGEST))
dots = reader(Range(1, MOST_DOTS))
frames = reader(Range(1, MOST_FRAMES, whole=True))
