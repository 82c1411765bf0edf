"""Amounts in mission files, whole ones without a point."""

from __future__ import annotations

from typing import Any

from tsplan.limits import is_finite
from tsplan.mission.resources import Amounts, Carries


def shortest(amount: float) -> float:
    """A whole amount without a point.

    >>> shortest(2.0), shortest(0.5)
    (2, 0.5)
    """
    return int(amount) if is_finite(amount) and amount == int(amount) else amount


def amounts_entry(pairs: Amounts) -> dict[str, float]:
    """Names with their amounts."""
    return {name: shortest(amount) for name, amount in pairs}


def carries_entry(carries: Carries) -> dict[str, Any]:
    """The key that says what one robot or structure carries, if it carries anything."""
    if carries == ():
        return {}
    return {"carries": amounts_entry(carries) if isinstance(carries, tuple) else shortest(carries)}
