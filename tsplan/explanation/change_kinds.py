"""The kinds of changes that an explanation may offer, in the order in which equal ones are said."""

from __future__ import annotations

from typing import Literal, TypeAlias, get_args

ChangeKind: TypeAlias = Literal[
    "extend_deadline",
    "start_sooner",
    "shorten_window",
    "loosen_limit",
    "loosen_bound",
    "loosen_constraint",
    "drop_constraint",
    "more_subswarms",
    "shorten_task",
    "share_agents",
    "waiting",
    "edge",
    "reconfigure",
    "add_agents",
    "carry_more",
    "add_stock",
    "lower_need",
    "move_threshold",
    "widen_start",
    "shorten_mission",
]
ORDER: tuple[ChangeKind, ...] = get_args(ChangeKind)
"""Changes of equal amounts are ranked in this order."""
