"""The fraction of a formula as a linear expression over indicators, to be maximised.

Every node is asked for under selections, as in `tsplan.encode.witness`, but what comes back is not
a duty: it is a sum of columns that is at most the node's fraction where the selection is 1, and 0
where it is not. `and` and `G` take the mean of what comes back; `or`, `F` and `U` choose one
witness and pass its selection down, so of alternatives only one counts. Whatever is all or nothing
(an atom, an eventuality of atoms) has an indicator of its own, under which it must hold, and the
tight encoding of that stands behind it.

* Selections that exclude each other are added up before a node is passed on. What the merged one is
  worth is then shared out between those who asked.
* A node that is asked for under many selections which do not exclude each other is valued once,
  under none of them, so that formulas that share their parts stay small.
* An eventuality that is asked for at several steps under one selection (F under G) does not hand
  its witnesses down: the child is valued once at each step, and each window picks from these.
"""

from __future__ import annotations

from collections import defaultdict
from collections.abc import Callable, Iterable, Mapping, Sequence
from fractions import Fraction
from functools import singledispatchmethod
from typing import TypeAlias

import numpy as np

from tsplan.encode.expressions import Expression
from tsplan.encode.selection import ALWAYS, Selection, SelectionColumns, exclusive
from tsplan.encode.witness import Request
from tsplan.logic import (
    Always,
    And,
    Constant,
    Count,
    Eventually,
    Formula,
    Linear,
    Or,
    Until,
    positive,
    walk,
)
from tsplan.milp.model import Draft, Terms

Key: TypeAlias = tuple[Formula, int, Selection]
"""A node that is valued at a step under a selection."""

Asked: TypeAlias = Sequence[tuple[int, Selection]]

_ONE = Fraction(1)
_MOST_GROUPS = 4  # of selections under which a node is valued at one step


class _Values:
    """What each key is worth, as a sum of columns and of other keys, and rows that bound columns.

    Keys are entered before the keys they are made of.
    """

    def __init__(self, draft: Draft) -> None:
        self._draft = draft
        self._parts: dict[Key, tuple[Expression, Sequence[tuple[Key, Fraction]]]] = {}
        self._bounds: list[tuple[Sequence[int], Sequence[int], Sequence[Key]]] = []

    def enter(
        self,
        key: Key,
        own: Expression | Iterable[int] = (),
        others: Iterable[tuple[Key, Fraction]] = (),
    ) -> None:
        """A key is worth `own` (columns stand for their sum) and the other keys times factors."""
        own = own if isinstance(own, Expression) else Expression.sum_of(own)
        self._parts[key] = (own, tuple(others))

    def columns(
        self, count: int, most: Sequence[int] = (), keys: Sequence[Key] | None = None
    ) -> list[int]:
        """New columns from 0 to 1; with `keys` bounded as by `bound`."""
        columns: list[int] = self._draft.columns(count, upper=1.0).tolist()
        if keys is not None:
            self.bound(columns, most, keys)
        return columns

    def bound(self, columns: Sequence[int], most: Sequence[int], keys: Sequence[Key] = ()) -> None:
        """The columns together are at most the columns `most` and what the keys are worth."""
        self._bounds.append((columns, most, keys))

    def write(self) -> Mapping[Key, Expression]:
        """Write the rows of all bounds; what every key is worth in columns."""
        worth: dict[Key, Expression] = {}
        for key, (own, others) in reversed(self._parts.items()):
            parts = [(worth[other], factor) for other, factor in others]
            worth[key] = Expression.total([(own, _ONE), *parts]) if parts else own
        terms: list[Terms] = []
        lower: list[float] = []
        for row, (columns, most, keys) in enumerate(self._bounds):
            total = Expression.total((worth[key], _ONE) for key in keys)
            terms += [(row, most, 1.0), (row, columns, -1.0)]
            terms += [(row, column, float(factor)) for column, factor in total.terms]
            lower.append(-float(total.constant))
        if lower:
            self._draft.sums(*terms, lower=np.array(lower), kind="fraction")
        return worth


class FractionEncoder:
    """Values one tree; `requests` are the duties its indicators stand for.

    `hopeful(node, step)` is False only where a node's fraction is 0 in every plan.
    """

    def __init__(
        self, draft: Draft, choices: SelectionColumns, hopeful: Callable[[Formula, int], bool]
    ) -> None:
        self._choices = choices
        self._hopeful = hopeful
        self._values = _Values(draft)
        self._asked: dict[Formula, dict[int, dict[Selection, None]]] = defaultdict(
            lambda: defaultdict(dict)
        )
        self.requests: list[Request] = []

    def encode(self, tree: Formula) -> Expression:
        """What is at most the fraction of a tree at step 0, and equal to it at its greatest."""
        top = self._ask(tree, 0, ALWAYS)
        for node in reversed(list(walk(tree))):
            asked = self._asked.pop(node, {})
            groups = [
                (step, selection)
                for step in sorted(asked)
                for selection in self._grouped(node, step, tuple(asked[step]))
            ]
            if groups:
                self._value(node, groups)
        worth = self._values.write()
        return worth[top[0]] if top else Expression()

    def _ask(self, node: Formula, step: int, selection: Selection) -> list[Key]:
        """The key of a node's value; none where it is worth nothing."""
        if not self._hopeful(node, step):
            return []
        self._asked[node][step][selection] = None
        return [(node, step, selection)]

    def _grouped(
        self, node: Formula, step: int, selections: Sequence[Selection]
    ) -> list[Selection]:
        """Selections with exclusive ones added up; what the sum is worth is shared out."""
        groups: list[list[Selection]] = []
        for selection in selections:
            ancestry = self._choices.ancestry(selection)
            for group in groups:
                if all(exclusive(self._choices.ancestry(other), ancestry) for other in group):
                    group.append(selection)
                    break
            else:
                groups.append([selection])
        if len(groups) > _MOST_GROUPS or (ALWAYS in selections and len(groups) > 1):
            # the node is valued once, whatever those who ask are
            for selection in selections:
                if selection != ALWAYS:
                    columns = self._values.columns(1, selection, ())
                    self._values.bound(columns, (), [(node, step, ALWAYS)])
                    self._values.enter((node, step, selection), columns)
            return [ALWAYS]
        merged: list[Selection] = []
        for group in groups:
            union = tuple(sorted({column for selection in group for column in selection}))
            merged.append(union if len(group) > 1 else group[0])
            if len(group) > 1:
                shares = self._values.columns(len(group), (), [(node, step, union)])
                for column, selection in zip(shares, group, strict=True):
                    self._values.enter((node, step, selection), [column])
                    self._values.bound([column], selection)
        return list(dict.fromkeys(merged))

    @singledispatchmethod
    def _value(self, node: Formula, asked: Asked) -> None:
        raise TypeError(f"no partial encoding is registered for {type(node).__name__}")

    @_value.register
    def _(self, node: Constant, asked: Asked) -> None:
        for step, selection in asked:
            always: Expression = Expression((), _ONE)
            self._values.enter((node, step, selection), selection or always)

    @_value.register
    def _(self, node: Count | Linear, asked: Asked) -> None:
        for step, selection in asked:
            self._enter_whole((node, step, selection), [(node, step)])

    @_value.register
    def _(self, node: And, asked: Asked) -> None:
        for step, selection in asked:
            self._mean((node, step, selection), [(child, step) for child in node.children])

    @_value.register
    def _(self, node: Always, asked: Asked) -> None:
        for step, selection in asked:
            window = range(step + node.low, step + node.high + 1)
            self._mean((node, step, selection), [(node.child, later) for later in window])

    def _mean(self, key: Key, parts: Sequence[tuple[Formula, int]]) -> None:
        each = Fraction(1, len(parts))
        below = [part for place in parts for part in self._ask(*place, key[2])]
        self._values.enter(key, (), [(part, each) for part in below])

    @_value.register
    def _(self, node: Or, asked: Asked) -> None:
        for step, selection in asked:
            options = [(child, step) for child in node.children if self._hopeful(child, step)]
            self._best((node, step, selection), options)

    @_value.register
    def _(self, node: Eventually, asked: Asked) -> None:
        windows: dict[Selection, dict[int, list[int]]] = defaultdict(dict)
        for step, selection in asked:
            times = range(step + node.low, step + node.high + 1)
            windows[selection][step] = [time for time in times if self._hopeful(node.child, time)]
        for selection, found in windows.items():
            if len(found) > 1:
                self._pick(node, selection, found)
            else:
                ((step, window),) = found.items()
                self._best((node, step, selection), [(node.child, time) for time in window])

    def _best(self, key: Key, options: Sequence[tuple[Formula, int]]) -> None:
        """The value of the one option that is chosen."""
        if all(is_whole(child) for child, _ in options):
            self._enter_whole(key, options)
            return
        chosen = [key[2]]
        if len(options) > 1:
            chosen = [(column,) for column in self._choose(key[2], options, "best")]
        pairs = zip(options, chosen, strict=True)
        below = [part for option, under in pairs for part in self._ask(*option, under)]
        self._values.enter(key, (), [(part, _ONE) for part in below])

    def _choose(
        self, selection: Selection, options: Sequence[tuple[Formula, int]], kind: str
    ) -> list[int]:
        """Columns of which at most one is 1 where the selection is; one for each option."""
        times = [time for _, time in options]
        columns: list[int] = self._choices.choose(selection, times, kind, exactly=False).tolist()
        return columns

    def _enter_whole(self, key: Key, options: Sequence[tuple[Formula, int]]) -> None:
        """Options that are all or nothing: the indicator of the one chosen is the value."""
        if len(options) == 1 and not key[2]:
            columns = self._choices.free([options[0][1]]).tolist()
        else:
            columns = self._choose(key[2], options, "part")
        for (child, time), column in zip(options, columns, strict=True):
            self.requests.append((positive(child), time, (column,)))
        self._values.enter(key, columns)

    def _pick(
        self, node: Eventually, selection: Selection, windows: Mapping[int, Sequence[int]]
    ) -> None:
        """Windows of one selection: each picks from what the child is worth at its steps."""
        child, values = node.child, self._values
        keys = {
            time: self._ask(child, time, selection)
            for time in sorted({time for window in windows.values() for time in window})
        }
        for step, window in windows.items():
            if is_whole(child):
                columns = values.columns(1, (), [key for time in window for key in keys[time]])
                if selection:
                    values.bound(columns, selection)
            else:
                options = self._choose(selection, [(child, time) for time in window], "window")
                columns = values.columns(len(window))
                for time, option, column in zip(window, options, columns, strict=True):
                    values.bound([column], [option])
                    values.bound([column], (), keys[time])
            values.enter((node, step, selection), columns)

    @_value.register
    def _(self, node: Until, asked: Asked) -> None:
        for step, selection in asked:
            self._until(node, step, selection)

    def _until(self, node: Until, step: int, selection: Selection) -> None:
        """One change step; the left side's value at a step is shared out between later changes."""
        window = range(step + node.low, step + node.high + 1)
        options = self._choose(selection, [(node.right, time) for time in window], "switch")
        changes = [
            (change, column, Fraction(1, change - step + 1))
            for change, column in zip(window, options, strict=True)
        ]
        parts = [
            (key, share)
            for change, column, share in changes
            for key in self._ask(node.right, change, (column,))
        ]
        own: list[tuple[int, Fraction]] = []
        for time in range(step, step + node.high):
            later = [(option, share) for change, option, share in changes if change > time]
            keys = self._ask(node.left, time, tuple(option for option, _ in later))
            if not keys:
                continue
            columns = self._values.columns(len(later), (), keys)
            for (option, share), column in zip(later, columns, strict=True):
                self._values.bound([column], [option])
                own.append((column, share))
        self._values.enter((node, step, selection), Expression(tuple(own)), parts)


def is_whole(node: Formula) -> bool:
    """Whether a node's fraction can only be 0 or 1."""
    while isinstance(node, Eventually):
        node = node.child
    if isinstance(node, Or):
        return all(is_whole(child) for child in node.children)
    return isinstance(node, Count | Linear | Constant)
