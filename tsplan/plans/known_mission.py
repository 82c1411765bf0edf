"""Results that know the mission they were made for, as long as they stay in memory."""

from __future__ import annotations

from copy import copy
from typing import Any, Generic, Self, TypeVar

from tsplan.errors import Finding, InputError

MissionT = TypeVar("MissionT")
_KEPT = "_mission"  # beside the fields: no part of what is compared, changed or written


class OfMission(Generic[MissionT]):
    """A frozen dataclass that may know its mission, which is no part of its value.

    What was planned knows it, and what was read from a file does not.
    """

    def with_mission(self, mission: MissionT) -> Self:
        """The same result, which knows its mission as long as it is not changed or written.

        Its pictures, pages, reasons and values are then of this mission unless another one is
        named.
        """
        made = copy(self)
        object.__setattr__(made, _KEPT, mission)
        return made

    def __getstate__(self) -> dict[str, Any]:
        """What is sent to other processes: not the mission, which they have."""
        return {name: value for name, value in self.__dict__.items() if name != _KEPT}

    def known_mission(self, given: MissionT | None = None) -> MissionT | None:
        """The mission that is given, or else the one that is known."""
        return given if given is not None else self.__dict__.get(_KEPT)

    def needed_mission(self, given: MissionT | None, method: str) -> MissionT:
        """The same for a `method` that needs it; InputError where there is none."""
        mission = self.known_mission(given)
        if mission is None:
            noun = type(self).__name__.lower()
            what = f"the {noun} does not know its mission, as files do not have it"
            raise InputError([Finding(what, f"give the mission: {noun}.{method}(mission)")])
        return mission
