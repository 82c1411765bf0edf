"""The weights of a mission's formulas, as files, Python values and missions have them."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Mapping
from typing import Any

from tsplan.document import Document
from tsplan.document.fields import complaint, shown
from tsplan.document.flow_style import short
from tsplan.limits import is_number
from tsplan.logic.weight_values import Weight


class Recorded:
    """A function of weights that remembers what it answered, so that it can be written down."""

    def __init__(self, function: Callable[[int], float]) -> None:
        self.values: dict[int, float] = {}
        self._function = function

    def __call__(self, index: int) -> float:
        """The weight of a part or step."""
        self.values[index] = self._function(index)
        return self.values[index]


def weights_of_entry(value: Any) -> Any:
    """The weights that stand in a file: one number, a list, or numbers by part or step.

    Keys are texts in files.
    """
    if isinstance(value, list):
        return [_weight(one) for one in value]
    if not isinstance(value, dict):
        return _weight(value)
    for key in value:
        if not (key.isascii() and key.isdigit()):
            remedy = "write its number, as in {3: 0.5, 4: 0.2}"
            raise complaint(f"{shown(key)} is no step or part", remedy)
    return {int(key): _weight(one) for key, one in value.items()}


def _weight(value: Any) -> float:
    if not is_number(value) or value <= 0:
        raise complaint(f"{shown(value)} is no weight", "write a number above 0")
    return float(value)


def weights_in(document: Document, read: Mapping[str, Weight] | None) -> Mapping[str, Weight]:
    """The weights of a document as they were read; where they are wrong, 1 in their place.

    So what else is wrong with a formula that names them can be told, too.
    """
    if read is not None:
        return read
    spec = document.data.get("spec") if isinstance(document.data, dict) else None
    given = spec.get("weights") if isinstance(spec, dict) else None
    return dict.fromkeys(given, 1.0) if isinstance(given, dict) else {}


def entries_of(weights: Mapping[str, Weight]) -> tuple[dict[str, Any], dict[str, Recorded]]:
    """What a file has for weights, and those that are functions, which no file has."""
    functions = {name: Recorded(weight) for name, weight in weights.items() if callable(weight)}
    return {n: _entry(weight) for n, weight in weights.items() if n not in functions}, functions


def _entry(weight: Any) -> Any:
    if isinstance(weight, Mapping):
        return {str(index): short(weight[index]) for index in sorted(weight)}
    if isinstance(weight, Iterable) and not isinstance(weight, str):
        return [short(value) for value in weight]
    return short(weight)


def settled(weights: Mapping[str, Weight]) -> dict[str, Weight]:
    """Weights without functions: what these have answered is in their place."""
    return {
        name: {index: float(value) for index, value in weight.values.items()}
        if isinstance(weight, Recorded)
        else weight
        for name, weight in weights.items()
    }
