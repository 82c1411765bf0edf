"""What Open-RMF asks of a request for a robot, restated from its public schemas.

The keys, types and alternatives are those of robot_task_request and task_request in rmf_api_msgs,
and of compose, go_to_place, payload_transfer, perform_action and place in rmf_fleet_adapter, for
the parts that are used here; the descriptions of activities are bound to their categories.
"""

from __future__ import annotations

from typing import Any

Schema = dict[str, Any]


def record(needed: Schema, optional: Schema | None = None) -> Schema:
    """An object with some keys, those of the first kind always there, and no others."""
    return {
        "type": "object",
        "properties": {**needed, **(optional or {})},
        "required": list(needed),
        "additionalProperties": False,  # stricter than RMF, so that a misspelt key is found
    }


def activity(category: str, description: Schema) -> Schema:
    return record({"category": {"const": category}, "description": description})


TEXT, WHOLE = {"type": "string"}, {"type": "integer"}
WAYPOINT = {"oneOf": [TEXT, {**WHOLE, "minimum": 0}]}
PLACE = {"oneOf": [WAYPOINT, record({"waypoint": WAYPOINT}, {"orientation": {"type": "number"}})]}
COMPONENT = record({"sku": TEXT, "quantity": {**WHOLE, "minimum": 0}}, {"compartment": TEXT})
TRANSFER = record(
    {"place": PLACE, "payload": {"oneOf": [COMPONENT, {"type": "array", "items": COMPONENT}]}},
    {"handler": TEXT},
)
ACTION = record(
    {"category": TEXT, "description": {}},
    {
        "unix_millis_action_duration_estimate": WHOLE,
        "use_tool_sink": {"type": "boolean"},
        "expected_finish_location": PLACE,
    },
)
ACTIVITY = {
    "oneOf": [
        activity("go_to_place", {"oneOf": [PLACE, record({"place": PLACE})]}),
        activity("pickup", TRANSFER),
        activity("dropoff", TRANSFER),
        activity("perform_action", ACTION),
    ]
}
PHASES = {"type": "array", "items": record({"activity": ACTIVITY}), "minItems": 1}
COMPOSE = record({"phases": PHASES}, {"category": TEXT, "detail": TEXT})
TASK_REQUEST = record(
    {"category": {"const": "compose"}, "description": COMPOSE},
    {
        "unix_millis_earliest_start_time": WHOLE,
        "unix_millis_request_time": WHOLE,
        "priority": {"type": "object"},
        "labels": {"type": "array", "items": TEXT},
        "requester": TEXT,
        "fleet_name": TEXT,
    },
)
ROBOT_TASK_REQUEST: Schema = {
    "$schema": "https://json-schema.org/draft/2020-12/schema",
    **record(
        {
            "type": {"const": "robot_task_request"},
            "robot": TEXT,
            "fleet": TEXT,
            "request": TASK_REQUEST,
        }
    ),
}
