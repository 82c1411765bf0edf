"""Signals: trajectories of linear systems that satisfy a formula over real numbers.

Names are loaded when they are first used: they need NumPy.
"""

from typing import TYPE_CHECKING

from tsplan.lazy_names import lazily

if TYPE_CHECKING:
    from tsplan.signals.integrators import double_integrator, free_signals, single_integrator
    from tsplan.signals.linear_system import Dynamics, System
    from tsplan.signals.region import Region

__all__ = [
    "Dynamics",
    "Region",
    "System",
    "double_integrator",
    "free_signals",
    "single_integrator",
]

__getattr__, __dir__ = lazily(
    __name__,
    {
        "signals.integrators": ("double_integrator", "free_signals", "single_integrator"),
        "signals.linear_system": ("Dynamics", "System"),
        "signals.region": ("Region",),
    },
)
