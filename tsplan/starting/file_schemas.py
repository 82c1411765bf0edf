"""JSON Schemas of the files, made from the models that read them."""

from __future__ import annotations

import json
from collections.abc import Mapping
from math import isfinite
from typing import Any

from pydantic import TypeAdapter
from pydantic.json_schema import GenerateJsonSchema

from tsplan.mission.mission_schema import MissionFile
from tsplan.plans.plan import Plan
from tsplan.plans.plan_text import PLANS, TRAJECTORIES
from tsplan.replanning.world_schema import WorldFile
from tsplan.signals.signal_schema import SignalFile
from tsplan.signals.trajectory import Trajectory
from tsplan.starting.key_words import KEY_WORDS
from tsplan.sweeps.sweep_schema import SweepFile
from tsplan.ts.io.tsplan_yaml import MapFile

SCHEMAS: Mapping[str, Any] = {
    "mission": MissionFile,
    "map": MapFile,
    "signals": SignalFile,
    "sweep": SweepFile,
    "world": WorldFile,
    "plan": Plan,
    "trajectory": Trajectory,
}
"""The kinds of files, and what reads each."""

# read before the fields are, which do not have it
_MARKS = {"plan": PLANS.mark, "trajectory": TRAJECTORIES.mark}


class _Untitled(GenerateJsonSchema):
    """Leaves out titles that only repeat the key."""

    def field_title_should_be_set(self, schema: Any) -> bool:
        return False


def file_schema(kind: str) -> dict[str, Any]:
    """The JSON Schema (2020-12) of files of a kind, one of `SCHEMAS`.

    What it refuses the reader refuses, too; the reader sees more, such as names that are not on
    the map. Raises KeyError for another kind.

    >>> file_schema("map")["required"]
    ['states']
    """
    made = TypeAdapter(SCHEMAS[kind]).json_schema(schema_generator=_Untitled)
    models = {SCHEMAS[kind].__name__: made, **made.get("$defs", {})}
    for name, model in models.items():
        model.pop("title", None)
        for key, words in KEY_WORDS.get(name, {}).items():
            model["properties"][key]["description"] = words
    if kind in _MARKS:
        made["properties"] = {"format": {"const": _MARKS[kind]}, **made["properties"]}
        made["required"] = ["format", *made["required"]]
    dialect = "https://json-schema.org/draft/2020-12/schema"
    content: dict[str, Any] = _spelled(made)
    return {"$schema": dialect, "title": f"tsplan {kind}", **content}


def schema_text(kind: str) -> str:
    """The same as text."""
    return json.dumps(file_schema(kind), indent=1, allow_nan=False) + "\n"


_LIMITS = {
    "ge": "minimum",
    "gt": "exclusiveMinimum",
    "le": "maximum",
    "lt": "exclusiveMaximum",
}
"""What pydantic calls the limits of numbers that a validator looks at before."""


def _spelled(value: Any) -> Any:
    """A schema in words of JSON Schema alone, without defaults that JSON cannot say."""
    if isinstance(value, list):
        return [_spelled(item) for item in value]
    if not isinstance(value, dict):
        return value
    return {
        _LIMITS.get(key, key) if isinstance(item, int | float) else key: _spelled(item)
        for key, item in value.items()
        if not (key == "default" and isinstance(item, float) and not isfinite(item))
    }
