"""The words of missions: format, languages, readings of tasks, who serves them, what holds."""

from __future__ import annotations

from typing import Literal, TypeAlias

Language: TypeAlias = Literal["catl", "mtl", "stl", "wmtl"]
TaskInterval: TypeAlias = Literal["closed", "half-open"]
Dynamics: TypeAlias = Literal["certain", "expected"]
PolicyKind: TypeAlias = Literal["randomised", "deterministic"]
Booking: TypeAlias = Literal["shared", "per-label", "exclusive"]
Order: TypeAlias = Literal["weighted", "hierarchical", "depth"]

FORMAT = "tsplan-mission/1"
LANGUAGES: tuple[Language, ...] = ("catl", "mtl", "stl", "wmtl")
TASK_INTERVALS: tuple[TaskInterval, ...] = ("closed", "half-open")
BOOKINGS: tuple[Booking, ...] = ("shared", "per-label", "exclusive")
ORDERS: tuple[Order, ...] = ("weighted", "hierarchical", "depth")
WHO = ("team", "swarm", "swarms")
"""The keys of a mission file that say who acts."""


def default_language(*, team: bool) -> Language:
    """The language of a formula where none is named: with a team, or of swarms alone."""
    return "catl" if team else "mtl"
