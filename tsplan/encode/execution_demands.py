"""Columns of executions for what a formula asks for: all that it may, or what is demanded of it."""

from __future__ import annotations

from collections import defaultdict
from collections.abc import Sequence
from dataclasses import replace

import numpy as np

from tsplan.encode.atom_encoders import AtomEncoder, Atoms, Executed
from tsplan.encode.encoder_rules import Demand
from tsplan.encode.executions import (
    ExecutionEncoder,
    Executions,
    Timed,
    beyond,
    execution_columns,
)
from tsplan.encode.flow_network import Network
from tsplan.encode.selection import Selection, SelectionColumns
from tsplan.encode.step_runs import Span
from tsplan.logic import Execution, Formula, walk
from tsplan.milp.model import Draft


def executed_columns(
    goal: Formula, atoms: Atoms, network: Network, draft: Draft
) -> tuple[Atoms, Executions]:
    """Columns of all executions that a formula may ask for, and the atoms that know them.

    Where one is 1 the task has the agents that it needs.
    """
    encoder = atoms.encoders.get(Execution)
    assert isinstance(encoder, ExecutionEncoder)
    spans = {
        bound: (0, network.horizon - node.last)
        for node in walk(goal)
        if isinstance(node, Execution)
        for bound in encoder.requirement(node).bounds
    }
    columns = execution_columns(spans, draft)
    for bound, timed in columns.items():
        for capability, number in bound.task.needs:
            for step, column in enumerate(timed.columns.tolist()):
                for time in range(step, step + bound.task.last + 1):
                    here, fixed = network.present(np.array([bound.state]), capability, time)
                    terms = (0, here, 1.0), (0, [column], -float(number))
                    draft.sums(*terms, lower=-fixed, kind="staff")
    most = float(beyond(goal, network.agents(None)) + 1)
    known = replace(encoder, columns=columns, most=most)
    encoders: dict[type[Formula], AtomEncoder] = {**atoms.encoders, Execution: known}
    return replace(atoms, encoders=encoders), columns


def demanded_columns(
    demands: Sequence[Demand],
    choices: SelectionColumns,
    draft: Draft,
    free: Executions | None = None,
) -> Executions:
    """Columns of the executions that are demanded, 1 where they are.

    With columns of executions that are `free` to be made, at least what is demanded is.
    """
    asked: dict[Executed, list[Span]] = defaultdict(list)
    for need in demands:
        asked[need.bound].append(Span(need.first, need.last, need.selection))
    spans = {
        bound: (min(s.first for s in found), max(s.last for s in found))
        for bound, found in asked.items()
    }
    columns = execution_columns(spans, draft) if free is None else free
    for bound, found in asked.items():
        timed = columns[bound]
        asking: dict[int, list[Selection]] = {step: [] for step in range(*_span(timed))}
        for step, selection in choices.by_step(found):
            asking[step].append(selection)
        for step, selections in asking.items():
            own = (0, timed.columns[step - timed.first : step - timed.first + 1], 1.0)
            for selection in selections:
                one = 0.0 if selection else 1.0
                draft.sums(own, (0, selection, -1.0), lower=one, kind="executed")
            if free is None and all(selections):  # nobody asks for it in any case
                anybody = tuple({column for selection in selections for column in selection})
                draft.sums(own, (0, anybody, -1.0), lower=-np.inf, upper=0.0, kind="executed")
    return columns


def _span(timed: Timed) -> tuple[int, int]:
    return timed.first, timed.last + 1
