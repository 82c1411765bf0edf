"""What formulas are judged on of what has happened: who was counted where."""

from __future__ import annotations

from collections.abc import Iterable
from typing import TYPE_CHECKING

from tsplan.logic.symbols import capabilities
from tsplan.plans.count_traces import count_trace
from tsplan.plans.presence import Presence, of_bundles, state_counts
from tsplan.plans.supplies import execution_tables

if TYPE_CHECKING:
    from tsplan.logic import CountTrace, Formula
    from tsplan.plans.bundles import Agents
    from tsplan.plans.supplies import ExecutedTask
    from tsplan.ts import TransitionSystem


def path_trace(
    system: TransitionSystem,
    formula: Formula,
    agents: Agents,
    last: int,
    *,
    others: Iterable[Presence] = (),
    executions: Iterable[ExecutedTask] = (),
) -> CountTrace:
    """The counts that a formula is about at the steps 0..last, by the paths of agents.

    `others` are those beside them, such as swarms, and `executions` the tasks that are executed.
    """
    present = (*of_bundles(agents.bundles), *others)
    states = tuple(system.states)
    named = (None, *sorted({name for name in capabilities(formula) if name is not None}))
    done = execution_tables(executions, states, last)
    counts = {name: state_counts(present, states, last, name) for name in named}
    return count_trace(system, counts, done)
