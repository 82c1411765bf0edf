"""What a controller is given at a step, checked before anything happens."""

from __future__ import annotations

from collections.abc import Collection, Mapping
from numbers import Real
from reprlib import repr as clipped
from typing import Any

import numpy as np

from tsplan.errors import Finding, InputError
from tsplan.limits import MOST_SECONDS, Range, is_finite
from tsplan.milp.model import Floats
from tsplan.parameters import finite

_DEADLINES = Range(0, MOST_SECONDS)


def seconds(deadline: object) -> float:
    """A deadline as a number; InputError for what is none."""
    words = _DEADLINES.complaint(deadline)
    if words:
        raise InputError([Finding(f"deadline: {words}", "give seconds, or leave it out")])
    return float(finite(deadline))


def complaints(values: object, names: Collection[str], kind: str) -> list[Finding]:
    """What keeps values from being one finite number for each name."""
    if not isinstance(values, Mapping):
        remedy = f"give a number for each of {', '.join(names)}"
        return [Finding(f"{clipped(values)} has no {kind}s by name", remedy)]
    given: Mapping[Any, Any] = values
    found = [Finding(f"{kind} {name} has no value") for name in names if name not in given]
    for name, value in given.items():
        if name not in names:
            remedy = f"the system has {', '.join(names)}"
            found.append(Finding(f"the system has no {kind} {clipped(name)}", remedy))
        elif isinstance(value, bool) or not (isinstance(value, Real) and is_finite(value)):
            found.append(Finding(f"{kind} {name} is {clipped(value)}, which is no finite number"))
    return found


def column(values: Mapping[str, float], names: Collection[str]) -> Floats:
    """Values in the order of names, as a column."""
    return np.array([float(values[name]) for name in names]).reshape(-1, 1)
