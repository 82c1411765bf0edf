"""Plain values as the one JSON text that equal values share, to be compared or hashed."""

from __future__ import annotations

import json
from typing import Any

_WIDEST = 1e16  # from here on a float may stand for several whole numbers


def canonical(value: Any) -> str:
    """The same text for values that mean the same: keys sorted, whole numbers without a point.

    >>> canonical({"b": 2.0, "a": (True, None)})
    '{"a":[true,null],"b":2}'
    """
    return json.dumps(_plain(value), sort_keys=True, separators=(",", ":"), default=str)


def _plain(value: Any) -> Any:
    if isinstance(value, dict):
        return {str(key): _plain(item) for key, item in value.items()}
    if isinstance(value, list | tuple):
        return [_plain(item) for item in value]
    if isinstance(value, float) and value.is_integer() and abs(value) < _WIDEST:
        return int(value)
    return value
