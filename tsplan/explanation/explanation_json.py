"""Explanations as JSON, format `tsplan-explanation/1`."""

from __future__ import annotations

import json
from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    from tsplan.explanation.explanation import Explanation, Fact, Part

FORMAT = "tsplan-explanation/1"


def explanation_to_json(explanation: Explanation) -> str:
    """The document, indented, with a line break at its end."""
    data = {
        "format": FORMAT,
        "status": str(explanation.status),
        "facts": [_located(fact) for fact in explanation.facts],
        "conflicts": [
            {"minimal": item.minimal, "parts": [_located(part) for part in item.parts]}
            for item in explanation.conflicts
        ],
        "changes": [
            {
                "kind": item.kind,
                "text": item.text,
                "amount": item.amount,
                "proven": item.proven,
            }
            for item in explanation.changes
        ],
        "cut_short": dict(explanation.cut),
        "timings": dict(explanation.timings),
    }
    return json.dumps(data, indent=2, ensure_ascii=False, allow_nan=False) + "\n"


def _located(item: Fact | Part) -> dict[str, Any]:
    """Words with their kind and place; places that are not known are null."""
    place = item.place
    return {"kind": item.kind, "text": item.text, "line": place.line, "column": place.column}
