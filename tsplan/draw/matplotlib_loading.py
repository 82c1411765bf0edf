"""Matplotlib, loaded late and whatever the environment says; in words where it is missing."""

from __future__ import annotations

import os
import re
import sys
import warnings
from collections.abc import Callable, Collection, Iterator
from contextlib import contextmanager, suppress
from importlib import import_module
from typing import Any

from tsplan.errors import TsplanError

_BACKEND = "MPLBACKEND"
_GLYPH = re.compile(r"Glyph (\d+) .*missing from ")
_MOST_LETTERS = 8


class PlotUnavailableError(TsplanError, RuntimeError):
    """Drawing needs matplotlib, which is not installed."""


class MissingLettersWarning(UserWarning):
    """A picture has letters that no font could draw."""


def library(name: str) -> Any:
    """A module of matplotlib; raises PlotUnavailableError with the remedy where it is missing."""
    try:
        if "matplotlib" not in sys.modules:
            _load()
        return import_module(f"matplotlib.{name}")
    except ImportError:
        raise PlotUnavailableError(
            "drawing needs matplotlib, which is not installed; pip install 'tsplan[plot]'"
        ) from None


def _load() -> None:
    """Import matplotlib without the backend of the environment.

    Pictures need none, and a name that a notebook has left there, or a wrong one, would keep
    matplotlib from being imported at all. Pyplot still gets it where it can be used.
    """
    wish = os.environ.pop(_BACKEND, None)
    try:
        matplotlib = import_module("matplotlib")
    finally:
        if wish is not None:
            os.environ[_BACKEND] = wish
    if wish is not None:
        with suppress(ValueError):
            matplotlib.rcParams["backend"] = wish


@contextmanager
def lacking() -> Iterator[dict[str, None]]:
    """The letters that no font turns out to have meanwhile, in place of a warning for each."""
    letters: dict[str, None] = {}
    with warnings.catch_warnings(record=True) as caught:
        warnings.filterwarnings("always", message=_GLYPH.pattern)
        yield letters
    for item in caught:
        found = _GLYPH.match(str(item.message))
        if found:
            letters[chr(int(found[1]))] = None
        else:
            warnings.warn_explicit(item.message, item.category, item.filename, item.lineno)


def tell_lost(
    letters: Collection[str], remedy: str, tell: Callable[[str], object] | None, place: object = ""
) -> None:
    """Say in one sentence which letters were drawn as boxes, if any, and what to do about it.

    Without somebody to `tell`, it is a MissingLettersWarning. `place` is the file it is about.
    """
    if not letters:
        return
    shown = ", ".join(f"'{letter}'" for letter in list(letters)[:_MOST_LETTERS])
    more = f" and {len(letters) - _MOST_LETTERS} more" if len(letters) > _MOST_LETTERS else ""
    words = f"no font here has the letters {shown}{more}: they are boxes; {remedy}"
    words = f"{place}: {words}" if place else words
    if tell is None:
        warnings.warn(words, MissingLettersWarning, stacklevel=3)
    else:
        tell(words)
