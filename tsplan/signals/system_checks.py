"""Whether a system fits together: ranges, where signals begin, sizes of matrices, names."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from math import inf, isfinite, isnan

from tsplan.errors import Nearest
from tsplan.logic.text import number_text
from tsplan.mission.findings import Fault, Place
from tsplan.signals.linear_system import Dynamics, Range, System
from tsplan.signals.signal_schema import LARGEST_VALUE
from tsplan.words import many

_LISTED = 6  # names in a message


def system_faults(system: System) -> list[Fault]:
    """Everything that does not fit together in a system.

    The places are those that a file has for its parts.
    """
    faults = [*_range_faults(system), *start_faults(system), *_name_faults(system)]
    if not system.signals:
        faults.append(Fault(("signals",), "there are no signals", "add at least one"))
    if system.dynamics is not None:
        faults += _dynamics_faults(system, system.dynamics)
    elif system.controls:
        what = "there are controls and no dynamics, so they steer nothing"
        faults.append(Fault(("controls",), what, "add 'dynamics', or make them signals"))
    return [*faults, *_expression_faults(system)]


def _range_faults(system: System) -> Iterator[Fault]:
    for kind, ranges in (("signals", system.signals), ("controls", system.controls)):
        for name, ends in ranges.items():
            words = _range_complaint(ends)
            if words is not None:
                yield Fault((kind, name), f"{name}: {words}", "write the smaller end first")


def _range_complaint(ends: Range) -> str | None:
    """What is wrong with a range; None if nothing is."""
    low, high = ends
    if isnan(low) or isnan(high) or low == inf or high == -inf:
        return f"{_shown(ends)} is no range"
    if any(isfinite(end) and abs(end) >= LARGEST_VALUE for end in ends):
        return f"an end of {_shown(ends)} is as good as infinite"
    return None if low <= high else f"the range {_shown(ends)} ends before it begins"


def _shown(ends: Range) -> str:
    return " to ".join(number_text(end) if isfinite(end) else str(end) for end in ends)


def start_faults(system: System) -> Iterator[Fault]:
    """Beginnings of no signal, that are no range, or outside of the bounds."""
    closest = Nearest(system.signals)
    for name, ends in system.initial.items():
        path: Place = ("signals", name, "initial")
        words = _range_complaint(ends)
        if name not in system.signals:
            yield Fault(path, f"there is no signal '{name}'", closest(name))
        elif words is not None:
            yield Fault(path, f"initial: {words}", "write the smaller end first")
        elif not (system.signals[name][0] <= ends[0] and ends[1] <= system.signals[name][1]):
            begins = number_text(ends[0]) if ends[0] == ends[1] else _shown(ends)
            what = (
                f"'{name}' begins at {begins}, outside of its bounds {_shown(system.signals[name])}"
            )
            yield Fault(path, what, "begin inside, or widen the bounds")


def _name_faults(system: System) -> Iterator[Fault]:
    """Names of two meanings."""
    for kind, taken in (
        ("controls", {"signal": system.signals}),
        ("outputs", {"signal": system.signals, "control": system.controls}),
    ):
        for name in getattr(system, kind):
            for other, names in taken.items():
                if name in names:
                    what = f"'{name}' is the name of a {other}, too"
                    yield Fault((kind, name), what, "call it something else")


def _dynamics_faults(system: System, dynamics: Dynamics) -> Iterator[Fault]:
    """Matrices of another size than the signals and controls ask for."""
    signals, controls = tuple(system.signals), tuple(system.controls)
    for key, rows, columns in (("A", dynamics.a, signals), ("B", dynamics.b, controls)):
        kind = "signal" if key == "A" else "control"
        if len(rows) != len(signals):
            what = f"{key} has {many(len(rows), 'row')} and there {_are(signals, 'signal')}"
            yield Fault(("dynamics", key), what, "write one row for each signal")
            continue
        for number, row in enumerate(rows):
            path = ("dynamics", key, number)
            if len(row) != len(columns):
                what = (
                    f"row {number + 1} of {key} has {many(len(row), 'number')} and there "
                    f"{_are(columns, kind)}"
                )
                yield Fault(path, what, f"write one number for each {kind}")
            elif not all(isfinite(value) and abs(value) < LARGEST_VALUE for value in row):
                what = f"row {number + 1} of {key} has a number that is as good as infinite"
                yield Fault(path, what, "use other units")
    if len(dynamics.d) != len(signals):
        what = f"D has {many(len(dynamics.d), 'number')} and there {_are(signals, 'signal')}"
        yield Fault(("dynamics", "D"), what, "write one number for each signal")
    elif not all(map(isfinite, dynamics.d)):
        yield Fault(("dynamics", "D"), "D has a number that is not finite", "use other units")


def _are(names: Sequence[str], kind: str) -> str:
    """How many of a kind there are, and which."""
    if not names:
        return f"are no {kind}s"
    listed = ", ".join([*names[:_LISTED], *(["..."] if len(names) > _LISTED else [])])
    return f"{'is' if len(names) == 1 else 'are'} {many(len(names), kind)} ({listed})"


def _expression_faults(system: System) -> Iterator[Fault]:
    """Outputs and limits over what is no signal or control, and limits that are not convex."""
    closest = Nearest(system.names)
    known = frozenset(system.names)
    for output, (terms, _) in system.outputs.items():
        for name in dict.fromkeys(name for name, _ in terms if name not in known):
            what = f"there is no signal or control '{name}'"
            yield Fault(("outputs", output), what, closest(name))
    for number, limit in enumerate(system.limits):
        path = ("limits", number)
        for name in dict.fromkeys(name for name in limit.names if name not in known):
            yield Fault(path, f"there is no signal or control '{name}'", closest(name))
        if any(factor <= 0 for factor, _ in limit.absolute):
            what = f"'{limit}' is not convex: a factor of an absolute value is not positive"
            yield Fault(path, what, "ask for it in the formula")
