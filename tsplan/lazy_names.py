"""Names of a module that are loaded when they are first used: some are slow to import."""

from __future__ import annotations

import sys
from collections.abc import Callable, Iterable, Mapping
from importlib import import_module


def lazily(
    module: str, homes: Mapping[str, Iterable[str]]
) -> tuple[Callable[[str], object], Callable[[], list[str]]]:
    """A module's `__getattr__` and `__dir__`, by the names that other modules have for it.

    Those are named from `tsplan` on, as in "mission.read".
    """
    home = {name: f"tsplan.{place}" for place, names in homes.items() for name in names}

    def load(name: str) -> object:
        if name not in home:
            raise AttributeError(f"module '{module}' has no attribute '{name}'")
        value: object = getattr(import_module(home[name]), name)
        setattr(sys.modules[module], name, value)
        return value

    return load, lambda: sorted({*vars(sys.modules[module]), *home})
