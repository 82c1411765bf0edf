"""Names of states in formulas: a name that is no label stands for the state that is called so.

This is settled once, when a mission is made: the state gets its own name as a label, in the
mission's map alone. Whatever reads the mission afterwards (encoding, check, reasons, pictures)
finds a label like any other.
"""

from __future__ import annotations

from dataclasses import replace
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from collections.abc import Iterable

    from tsplan.logic import Formula
    from tsplan.ts import TransitionSystem


def with_named_places(system: TransitionSystem, formulas: Iterable[Formula]) -> TransitionSystem:
    """The map in which every state that a formula names has its name as a label.

    A name that some state has as a label means that label. The same map where nothing changes.

    >>> from tsplan.logic import parse
    >>> from tsplan.ts import Edge, State, TransitionSystem
    >>> yard = TransitionSystem.build([State("dock"), State("gate")], [Edge("dock", "gate")])
    >>> with_named_places(yard, [parse("F[0,2] gate")]).labels
    mappingproxy({'gate': ('gate',)})
    """
    from tsplan.logic.symbols import labels  # noqa: PLC0415  (the parser is slow to import)

    named = {
        name
        for formula in formulas
        for name in labels(formula)
        if name not in system.labels and name in system.states
    }
    if not named:
        return system
    states = {
        name: replace(state, labels=state.labels | {name}) if name in named else state
        for name, state in system.states.items()
    }
    return replace(system, states=states)
