"""The fraction of a formula as a linear expression over indicators, to be maximised.

Every node is asked for under selections, as in `tsplan.encode.witness`, but what comes back is not
a duty: it is a sum of columns that is at most the node's fraction where the selection is 1, and 0
where it is not. `and` and `G` take the mean of what comes back; `or`, `F` and `U` choose one
witness and pass its selection down, so of alternatives only one counts. With weights, what comes
back is multiplied by the part's portion, and the sum is a preference. Whatever is all or nothing
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
from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from fractions import Fraction
from functools import singledispatchmethod
from typing import NamedTuple, TypeAlias

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
    Known,
    Linear,
    Or,
    Until,
    Whole,
    positive,
    walk,
)
from tsplan.logic.fraction import is_even, portions
from tsplan.milp.model import Draft, Terms

Key: TypeAlias = tuple[Formula, int, Selection]
"""A node that is valued at a step under a selection."""

Asked: TypeAlias = Sequence[tuple[int, Selection]]

_ONE = Fraction(1)
_MOST_GROUPS = 4  # of selections under which a node is valued at one step


class _Part(NamedTuple):
    """A part or an alternative of a node: what is judged when, and what it counts."""

    node: Formula
    step: int
    portion: Fraction = _ONE


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
    def _(self, node: Count | Linear | Known | Whole, asked: Asked) -> None:
        for step, selection in asked:
            self._enter_whole((node, step, selection), [_Part(node, step)])

    @_value.register
    def _(self, node: And | Always, asked: Asked) -> None:
        each = portions(node)
        for step, selection in asked:
            below = [
                (found, part.portion)
                for part in _parts(node, step, each)
                for found in self._ask(part.node, part.step, selection)
            ]
            self._values.enter((node, step, selection), (), below)

    @_value.register
    def _(self, node: Or, asked: Asked) -> None:
        each = portions(node)
        for step, selection in asked:
            self._best((node, step, selection), self._options(node, step, each))

    @_value.register
    def _(self, node: Eventually, asked: Asked) -> None:
        windows: dict[Selection, dict[int, list[_Part]]] = defaultdict(dict)
        each = portions(node)
        for step, selection in asked:
            windows[selection][step] = self._options(node, step, each)
        for selection, found in windows.items():
            if len(found) > 1:
                self._pick(node, selection, found)
            else:
                ((step, window),) = found.items()
                self._best((node, step, selection), window)

    def _options(self, node: Or | Eventually, step: int, each: Sequence[Fraction]) -> list[_Part]:
        """The alternatives that may be worth something."""
        return [part for part in _parts(node, step, each) if self._hopeful(part.node, part.step)]

    def _best(self, key: Key, options: Sequence[_Part]) -> None:
        """The value of the one option that is chosen."""
        if all(is_whole(option.node) for option in options):
            self._enter_whole(key, options)
            return
        chosen = [key[2]]
        if len(options) > 1:
            times = [option.step for option in options]
            chosen = [(column,) for column in self._choose(key[2], times, "best")]
        below = [
            (found, option.portion)
            for option, under in zip(options, chosen, strict=True)
            for found in self._ask(option.node, option.step, under)
        ]
        self._values.enter(key, (), below)

    def _choose(self, selection: Selection, times: Sequence[int], kind: str) -> list[int]:
        """Columns of which at most one is 1 where the selection is; one for each option."""
        columns: list[int] = self._choices.choose(selection, times, kind, exactly=False).tolist()
        return columns

    def _enter_whole(self, key: Key, options: Sequence[_Part]) -> None:
        """Options that are all or nothing: the value is the portion of the one chosen."""
        times = [option.step for option in options]
        if len(options) == 1 and not key[2]:
            columns = self._choices.free(times).tolist()
        else:
            columns = self._choose(key[2], times, "part")
        for option, column in zip(options, columns, strict=True):
            self.requests.append((positive(option.node), option.step, (column,)))
        self._values.enter(key, _chosen(columns, options))

    def _pick(
        self, node: Eventually, selection: Selection, windows: Mapping[int, Sequence[_Part]]
    ) -> None:
        """Windows of one selection: each picks from what the child is worth at its steps."""
        child, values = node.child, self._values
        keys = {
            time: self._ask(child, time, selection)
            for time in sorted({option.step for window in windows.values() for option in window})
        }
        for step, window in windows.items():
            times = [option.step for option in window]
            if is_whole(child) and is_even(node):
                columns = values.columns(1, (), [key for time in times for key in keys[time]])
                if selection:
                    values.bound(columns, selection)
                values.enter((node, step, selection), columns)
                continue
            chosen = self._choose(selection, times, "window")
            columns = values.columns(len(window))
            for time, option, column in zip(times, chosen, columns, strict=True):
                values.bound([column], [option])
                values.bound([column], (), keys[time])
            values.enter((node, step, selection), _chosen(columns, window))

    @_value.register
    def _(self, node: Until, asked: Asked) -> None:
        each = [by / (switch + 1) for switch, by in enumerate(portions(node), start=node.low)]
        for step, selection in asked:
            self._until((node, step, selection), node, each)

    def _until(self, key: Key, node: Until, each: Sequence[Fraction]) -> None:
        """One change step; the left side's value at a step is shared out between later changes.

        `each` is what any of its parts counts at each change.
        """
        _, step, selection = key
        window = range(step + node.low, step + node.high + 1)
        options = self._choose(selection, window, "switch")
        changes = list(zip(window, options, each, strict=True))
        parts = [
            (found, share)
            for change, column, share in changes
            for found in self._ask(node.right, change, (column,))
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
        self._values.enter(key, Expression(tuple(own)), parts)


def _parts(
    node: And | Or | Always | Eventually, step: int, each: Sequence[Fraction]
) -> Iterator[_Part]:
    """What a node is made of at a step, with their portions."""
    if isinstance(node, And | Or):
        for child, portion in zip(node.children, each, strict=True):
            yield _Part(child, step, portion)
        return
    for place, portion in enumerate(each, start=step + node.low):
        yield _Part(node.child, place, portion)


def _chosen(columns: Iterable[int], options: Iterable[_Part]) -> Expression:
    """The portion of the option whose column is 1."""
    portions_of = (option.portion for option in options)
    return Expression(tuple(zip(columns, portions_of, strict=True)))


def is_whole(node: Formula) -> bool:
    """Whether a node's fraction, or with weights its preference, can only be 0 or 1."""
    while isinstance(node, Eventually) and is_even(node):
        node = node.child
    if isinstance(node, Or) and is_even(node):
        return all(is_whole(child) for child in node.children)
    return isinstance(node, Count | Linear | Known | Constant | Whole)
