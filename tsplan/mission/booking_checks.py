"""Whether agents can be booked for tasks as a mission asks, and whether that says anything."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Sequence
from dataclasses import dataclass

from tsplan import logic
from tsplan.errors import nearest
from tsplan.logic import Formula
from tsplan.mission.findings import Fault, Place
from tsplan.mission.vocabulary import BOOKINGS

_PLACE: Place = ("booking",)


@dataclass(frozen=True)
class Booked:
    """How agents are booked, and what there is beside that in a mission."""

    booking: str
    swarms: bool
    delay: int
    expected: bool


def booking_faults(
    booked: Booked, objective: Sequence[str], formulas: Iterable[Formula]
) -> Iterator[Fault]:
    """What agents cannot be booked together with, and (a warning) a booking that says nothing."""
    booking = booked.booking
    if booking not in BOOKINGS:
        what = f"'{booking}' is no way to book agents"
        yield Fault(_PLACE, what, nearest(str(booking), BOOKINGS))
        return
    if booking == "shared":
        return
    if booked.swarms:
        what = "agents are booked one by one, and those of swarms move in groups"
        yield Fault(_PLACE, what, "describe the agents as a team, or write 'booking: shared'")
    if booked.expected:
        what = "agents are booked one by one, and the mission asks for expected numbers"
        yield Fault(_PLACE, what, "write 'booking: shared', or drop 'dynamics'")
    aims: Iterator[Place] = (
        ("objective", n) for n, name in enumerate(objective) if name == "delay"
    )
    path = ("delay",) if booked.delay else next(aims, None)
    if path is not None:
        what = "agents are booked for tasks where they are on time, and these may be late"
        yield Fault(path, what, "plan without delay, or write 'booking: shared'")
    known = tuple(formulas)
    if known and not any(isinstance(node, logic.Task) for node in logic.walk_all(known)):
        what = f"no task is in the formula, so 'booking: {booking}' says nothing"
        yield Fault(_PLACE, what, "remove it, or write what agents serve as T(..)", serious=False)
