"""Systems that are often used: signals that move freely, single and double integrators.

The integrators go on by Euler's explicit rule, `p += step * v` and `v += step * u`, in which a
control acts on the position a step later; with a step of 1 that is the double integrator of most
benchmarks of STL synthesis (stlpy's among them). Another rule is written as matrices.
"""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence
from types import MappingProxyType
from typing import Literal, TypeAlias

from tsplan.signals.linear_system import Dynamics, Range, System

Model: TypeAlias = Literal["single-integrator", "double-integrator"]
Rows: TypeAlias = "dict[str, dict[str, float]]"

MODELS: Mapping[Model, int] = MappingProxyType({"single-integrator": 1, "double-integrator": 2})
"""How often a control is summed up until it is a position."""


def model_rows(model: Model, axes: Iterable[str], step: float) -> tuple[Rows, Rows]:
    """How every signal goes on: its factors of the signals, and of the controls.

    The signals of an axis `x` are `x` and, of a double integrator, `vx`; its control is `ux`.
    """
    a: Rows = {}
    b: Rows = {}
    for axis in axes:
        chain = (axis, f"v{axis}")[: MODELS[model]]
        for place, name in enumerate(chain):
            after = chain[place + 1 : place + 2]
            a[name] = {name: 1.0, **dict.fromkeys(after, step)}
            b[name] = {} if after else {f"u{axis}": step}
    return a, b


def matrices(
    rows: tuple[Rows, Rows],
    signals: Sequence[str],
    controls: Sequence[str],
    d: Sequence[float] = (),
) -> Dynamics:
    """The dynamics of rows by name, in the order of the signals and controls."""
    a, b = (
        tuple(tuple(part.get(row, {}).get(name, 0.0) for name in names) for row in signals)
        for part, names in zip(rows, (signals, controls), strict=True)
    )
    return Dynamics(a, b, tuple(d) or (0.0,) * len(signals))


def free_signals(**signals: Range) -> System:
    """Signals that move freely between bounds, from any value to any other at each step.

    >>> free_signals(s1=(0, 10), s2=(0, 10)).names
    ('s1', 's2')
    """
    return System(signals)


def single_integrator(
    axes: Sequence[str], *, position: Range, speed: float, step: float = 1.0
) -> System:
    """A robot whose speed is steered: `p += step * u` along every axis.

    Positions lie in `position`; the controls are `ux` for an axis `x`, between `speed` and its
    opposite.

    >>> robot = single_integrator(("x", "y"), position=(0, 10), speed=1)
    >>> robot.names
    ('x', 'y', 'ux', 'uy')
    """
    controls = {f"u{axis}": (-speed, speed) for axis in axes}
    signals = dict.fromkeys(axes, position)
    dynamics = matrices(model_rows("single-integrator", axes, step), (*signals,), (*controls,))
    return System(signals, controls, dynamics)


def double_integrator(
    axes: Sequence[str], *, position: Range, speed: float, push: float, step: float = 1.0
) -> System:
    """A robot whose acceleration is steered: `p += step * v`, `v += step * u` along every axis.

    Positions lie in `position`; the speeds are `vx` for an axis `x`, up to `speed` in both
    directions, and begin at 0; the controls are `ux`, up to `push`.

    >>> robot = double_integrator(("x", "y"), position=(0, 10), speed=1, push=0.5)
    >>> robot.names
    ('x', 'y', 'vx', 'vy', 'ux', 'uy')
    >>> import numpy as np
    >>> robot.simulated([1, 2, 0, 0], np.array([[0.5, 0.0], [0.0, 0.0]])).tolist()[0]
    [1.0, 1.0, 1.5]
    """
    speeds = {f"v{axis}": (-speed, speed) for axis in axes}
    controls = {f"u{axis}": (-push, push) for axis in axes}
    signals = {**dict.fromkeys(axes, position), **speeds}
    dynamics = matrices(model_rows("double-integrator", axes, step), (*signals,), (*controls,))
    return System(signals, controls, dynamics, dict.fromkeys(speeds, (0.0, 0.0)))
