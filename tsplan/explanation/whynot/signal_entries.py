"""What entries of a mission file over signals have to say after a change."""

from __future__ import annotations

from collections.abc import Iterator
from typing import TYPE_CHECKING

from tsplan.document.flow_style import flow, short
from tsplan.explanation.whynot.signal_constraints import SignalWording, signal_bounds, system_side
from tsplan.signals.system_entries import starts_entry

if TYPE_CHECKING:
    from tsplan.document import Path
    from tsplan.explanation.explanation import SoftConstraint
    from tsplan.signals.signal_mission import SignalMission

FIELDS = ("system", "horizon", "objective", "prefer", "satisfaction", "weighting", "regions")
"""What two missions must agree on to be the same, beside the formula."""


def entries(original: SignalMission, changed: SignalMission) -> Iterator[tuple[Path, str]]:
    """Bounds, starts, limits and the horizon that differ, with where they stand."""
    wording = SignalWording(original)
    for bound in signal_bounds(original):
        text, path = _text(changed, bound), wording.path(bound)
        if text != _text(original, bound) and path is not None:
            yield path, text
    assert original.origin is not None
    if original.origin.data.get("horizon") is not None and original.horizon != changed.horizon:
        yield ("horizon",), str(changed.horizon)


def _text(mission: SignalMission, bound: SoftConstraint) -> str:
    """What a file says of a bound."""
    kind, (key, *which) = bound
    if kind == "limit":
        return flow(str(mission.system.limits[key]))
    if kind == "start":
        return flow(starts_entry({key: mission.system.initial[key]})[key])
    return flow(short(system_side(mission.system, key)[which[0]]))
