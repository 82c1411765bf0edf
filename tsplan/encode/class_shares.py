"""How many agents of each class serve a task: whole numbers that flows of parts would get around.

Once the witnesses are whole, flows are fractional where classes share tasks: of three tasks that
three classes serve in pairs, two and a half agents of each class do half of every one, in a
thousand ways as to time. What decides is one number for each class and task, added as a
whole column: no more agents of a class serve a task than are there when its first witness may
begin, or come until its last one ends, and together they are as many as it needs of each
capability. Every plan has such numbers (the most that are there at one step), so nothing is lost.
"""

from __future__ import annotations

from collections import defaultdict
from collections.abc import Iterable, Sequence
from dataclasses import dataclass

import numpy as np
from scipy import sparse

from tsplan.encode.atom_encoders import Site
from tsplan.encode.class_columns import ClassColumns
from tsplan.encode.encoder_rules import Demand, Witnesses
from tsplan.encode.flow_network import Network
from tsplan.encode.selection import Selection
from tsplan.milp.model import Draft, Floats, Ints, Model

_CHOSEN = 0.5  # values of columns that are 0 or 1


@dataclass(frozen=True)
class Served:
    """One of `columns` is 1 where `asked` is, and then a place needs agents at steps of its own.

    `begins` are the steps at which each column needs them first, `last` the last step of all;
    `amounts` what all of them need at least.
    """

    states: Site
    columns: tuple[int, ...]
    asked: Selection
    begins: tuple[int, ...]
    last: int
    amounts: tuple[tuple[str | None, int], ...]


def served_by(witnesses: Witnesses) -> tuple[Served, ...]:
    """What choices ask for, and covers of windows that have no step in common."""
    needs: dict[int, list[Demand]] = defaultdict(list)
    for need in witnesses.demands:
        if not need.bound.upper and need.bound.amount > 0 and need.bound.states:
            for column in need.selection:
                needs[column].append(need)
    asked = [(parent, columns.tolist()) for parent, columns in witnesses.choices.exact]
    ends: dict[tuple[int, Selection], int] = {}
    for cover in witnesses.covers:
        key = id(cover.columns), cover.selection
        if cover.begin >= ends.get(key, 0):
            ends[key] = cover.end
            asked.append((cover.selection, cover.columns[cover.begin : cover.end].tolist()))
    return tuple(served for parent, columns in asked for served in _places(parent, columns, needs))


def _places(
    asked: Selection, columns: Sequence[int], needs: dict[int, list[Demand]]
) -> Iterable[Served]:
    """The places at which all of some columns need agents."""
    of = [
        {site: [n for n in needs[c] if n.bound.states == site] for site in _sites(needs.get(c, ()))}
        for c in columns
    ]
    if not of:
        return
    for site in set.intersection(*(set(places) for places in of)):
        mine = [places[site] for places in of]
        amounts = {}
        for capability in {need.bound.capability for need in mine[0]}:
            most = [
                max((n.bound.amount for n in each if n.bound.capability == capability), default=0)
                for each in mine
            ]
            amounts[capability] = min(most)
        yield Served(
            site,
            tuple(columns),
            asked,
            tuple(min(need.first for need in each) for each in mine),
            max(need.last for each in mine for need in each),
            tuple(amounts.items()),
        )


def _sites(needs: Iterable[Demand]) -> list[Site]:
    return list(dict.fromkeys(need.bound.states for need in needs))


def with_shares(
    tasks: Iterable[Served], network: Network, model: Model, values: Floats | None
) -> tuple[Model, Floats | None]:
    """A model with whole columns of shares behind its own, and a point of it from one of these."""
    draft = Draft()
    draft.columns(model.size.columns)
    shares: list[float] = []
    for task in tasks:
        columns = _share_rows(task, network, draft)
        for number, item in enumerate(network.classes):
            if number in columns and values is not None:
                shares.append(_share(task, item, network.horizon, values))
    more = draft.build()
    count = more.size.columns - model.size.columns
    wide = sparse.csr_array(
        (model.matrix.data, model.matrix.indices, model.matrix.indptr),
        shape=(model.matrix.shape[0], more.size.columns),
    )
    own = slice(model.size.columns, None)
    extended = Model(
        objective=np.append(model.objective, np.zeros(count)),
        lower=np.append(model.lower, more.lower[own]),
        upper=np.append(model.upper, more.upper[own]),
        integer=np.append(model.integer, more.integer[own]),
        matrix=sparse.csr_array(sparse.vstack([wide, more.matrix], format="csr")),
        row_lower=np.append(model.row_lower, more.row_lower),
        row_upper=np.append(model.row_upper, more.row_upper),
        tags=model.tags,
        offset=model.offset,
    )
    return extended, None if values is None else np.append(values, shares)


def _share_rows(task: Served, network: Network, draft: Draft) -> dict[int, int]:
    """The columns of one task by the numbers of classes, and what is known of them."""
    able = {
        number
        for capability, _ in task.amounts
        for number in np.flatnonzero(network.counted(capability).any(axis=1)).tolist()
    }
    first = min(task.begins)
    states, steps = np.array(task.states), np.arange(first + 1, task.last + 1)
    columns: dict[int, int] = {}
    for number in sorted(able):
        item = network.classes[number]
        (column,) = draft.columns(1, upper=float(item.graph.agents), integer=True).tolist()
        columns[number] = column
        come = [
            _present(item, states, first, network.horizon),
            item.between(states, np.array([first]))[1],  # on their way from one to the other
            item.entering(states, steps)[1],
        ]
        draft.sums(*((0, some, 1.0) for some in come), (0, column, -1.0), kind="share")
    for capability, amount in task.amounts:
        having = np.asarray(network.counted(capability).any(axis=1))
        mine = [column for number, column in columns.items() if having[number]]
        # of nothing asked for, agents serve what they like
        lower = 0.0 if task.asked else float(amount)
        draft.sums((0, mine, 1.0), (0, task.asked, -float(amount)), lower=lower, kind="share")
    return columns


def _present(item: ClassColumns, states: Ints, step: int, horizon: int) -> Ints:
    """Columns whose sum is how many of a class are at some states at a step."""
    at = np.array([step])
    return (item.arriving if step == horizon else item.leaving)(states, at)[1]


def _share(task: Served, item: ClassColumns, horizon: int, values: Floats) -> float:
    """How many of a class are there when the first witness of a task begins."""
    chosen = [b for c, b in zip(task.columns, task.begins, strict=True) if values[c] > _CHOSEN]
    if not chosen:
        return 0.0
    there = _present(item, np.array(task.states), min(chosen), horizon)
    return float(np.round(values[there].sum()))
