"""The fraction of a formula as a linear expression over indicators, to be maximised.

Every node is asked for under literals, as in `tsplan.encode.witness`, but what comes back is not a
duty: it is a sum of columns that is at most the node's fraction where the literal is 1, and 0
where it is not. `and` and `G` take the mean of what comes back; `or`, `F` and `U` choose one
witness and pass its literal down, so of alternatives only one counts. Whatever is all or nothing
(an atom, an eventuality of atoms) has an indicator of its own, under which it must hold, and the
tight encoding of that stands behind it.

* Literals that exclude each other are added up before a node is passed on. What the merged literal
  is worth is then shared out between those who asked.
* A node that is asked for under many literals which do not exclude each other is valued once, under
  none of them, so that formulas that share their parts stay small.
* An eventuality that is asked for at several steps under one literal (F under G) does not hand its
  witnesses down: the child is valued once at each step, and each window picks from these values.
"""

from __future__ import annotations

from collections import defaultdict
from collections.abc import Callable, Iterable, Mapping, Sequence
from fractions import Fraction
from functools import singledispatchmethod
from typing import TypeAlias

from tsplan.encode.partial.linear import Ledger, Sum
from tsplan.encode.selection import ALWAYS, Choices, Literal, exclusive
from tsplan.encode.witness import Request
from tsplan.logic import (
    Always,
    And,
    Constant,
    Count,
    Eventually,
    Formula,
    Or,
    Until,
    positive,
    walk,
)
from tsplan.milp.model import Draft

Key: TypeAlias = tuple[Formula, int, Literal]
Asked: TypeAlias = Mapping[int, Sequence[Literal]]

_ONE = Fraction(1)
_MOST_GROUPS = 4  # of literals under which a node is valued at one step


class FractionEncoder:
    """Values one tree; `requests` are the duties its indicators stand for.

    `hopeful(node, step)` is False only where a node's fraction is 0 in every plan.
    """

    def __init__(
        self, draft: Draft, choices: Choices, hopeful: Callable[[Formula, int], bool]
    ) -> None:
        self._draft = draft
        self._choices = choices
        self._hopeful = hopeful
        self._ledger = Ledger()
        self._asked: dict[Formula, dict[int, dict[Literal, None]]] = defaultdict(
            lambda: defaultdict(dict)
        )
        self.requests: list[Request] = []

    def encode(self, tree: Formula) -> Sum:
        """What is at most the fraction of a tree at step 0, and equal to it at its greatest."""
        top = self._ask(tree, 0, ALWAYS)
        for node in reversed(list(walk(tree))):
            asked = self._asked.pop(node, None)
            if asked is not None:
                groups = {
                    step: self._grouped(node, step, tuple(asked[step])) for step in sorted(asked)
                }
                self._value(node, groups)
        worth = self._ledger.resolve()
        self._ledger.write(self._draft, worth)
        return worth[top[0]] if top else Sum()

    def _ask(self, node: Formula, step: int, literal: Literal) -> list[Key]:
        """The key of a node's value; none where it is worth nothing."""
        if not self._hopeful(node, step):
            return []
        self._asked[node][step][literal] = None
        return [(node, step, literal)]

    def _grouped(self, node: Formula, step: int, literals: Sequence[Literal]) -> list[Literal]:
        """Literals with exclusive ones added up; what the sum is worth is shared out."""
        groups: list[list[Literal]] = []
        for literal in literals:
            lineage = self._choices.lineage(literal)
            for group in groups:
                if all(exclusive(self._choices.lineage(other), lineage) for other in group):
                    group.append(literal)
                    break
            else:
                groups.append([literal])
        if len(groups) > _MOST_GROUPS or (ALWAYS in literals and len(groups) > 1):
            self._share_freely(node, step, literals)
            return [ALWAYS]
        merged = []
        for group in groups:
            union = tuple(sorted({column for literal in group for column in literal}))
            merged.append(union if len(group) > 1 else group[0])
            if len(group) > 1:
                self._share_out(node, step, group, union)
        return list(dict.fromkeys(merged))

    def _share_freely(self, node: Formula, step: int, literals: Sequence[Literal]) -> None:
        """Literals that do not exclude each other: the node is valued once, whatever they are."""
        for literal in literals:
            if literal != ALWAYS:
                columns = self._draft.columns(1, upper=1.0).tolist()
                self._ledger.enter((node, step, literal), Sum.of(columns))
                self._ledger.tie(columns, Sum.of(literal))
                self._ledger.tie(columns, Sum(), [(node, step, ALWAYS)])

    def _share_out(
        self, node: Formula, step: int, group: Sequence[Literal], union: Literal
    ) -> None:
        columns = self._draft.columns(len(group), upper=1.0).tolist()
        for column, literal in zip(columns, group, strict=True):
            self._ledger.enter((node, step, literal), Sum.of([column]))
            self._ledger.tie([column], Sum.of(literal))
        self._ledger.tie(columns, Sum(), [(node, step, union)])

    @singledispatchmethod
    def _value(self, node: Formula, asked: Asked) -> None:
        raise TypeError(f"no partial encoding is registered for {type(node).__name__}")

    @_value.register
    def _(self, node: Constant, asked: Asked) -> None:
        for step, literal in _each(asked):
            held = Sum.of(literal) if literal else Sum({}, _ONE)
            self._ledger.enter((node, step, literal), held)

    @_value.register
    def _(self, node: Count, asked: Asked) -> None:
        for step, literal in _each(asked):
            self._enter_whole(node, literal, [(node, step)], step)

    @_value.register
    def _(self, node: And, asked: Asked) -> None:
        for step, literal in _each(asked):
            self._mean(node, step, literal, [(child, step) for child in node.children])

    @_value.register
    def _(self, node: Always, asked: Asked) -> None:
        for step, literal in _each(asked):
            window = range(step + node.low, step + node.high + 1)
            self._mean(node, step, literal, [(node.child, later) for later in window])

    def _mean(
        self,
        node: Formula,
        step: int,
        literal: Literal,
        parts: Sequence[tuple[Formula, int]],
    ) -> None:
        each = Fraction(1, len(parts))
        keys = [key for part in parts for key in self._ask(*part, literal)]
        self._ledger.enter((node, step, literal), Sum(), [(key, each) for key in keys])

    @_value.register
    def _(self, node: Or, asked: Asked) -> None:
        for step, literal in _each(asked):
            options = [(child, step) for child in node.children if self._hopeful(child, step)]
            self._best(node, step, literal, options)

    @_value.register
    def _(self, node: Eventually, asked: Asked) -> None:
        windows: dict[Literal, list[int]] = defaultdict(list)
        for step, literal in _each(asked):
            windows[literal].append(step)
        for literal, steps in windows.items():
            if len(steps) > 1:
                self._pick(node, literal, steps)
            else:
                options = [(node.child, time) for time in self._times(node, steps[0])]
                self._best(node, steps[0], literal, options)

    def _times(self, node: Eventually, step: int) -> list[int]:
        window = range(step + node.low, step + node.high + 1)
        return [time for time in window if self._hopeful(node.child, time)]

    def _best(
        self,
        node: Formula,
        step: int,
        literal: Literal,
        options: Sequence[tuple[Formula, int]],
    ) -> None:
        """The value of the one option that is chosen."""
        if all(is_whole(child) for child, _ in options):
            self._enter_whole(node, literal, options, step)
            return
        if len(options) == 1:
            chosen: list[Literal] = [literal]
        else:
            columns = self._choices.optional(literal, [time for _, time in options], "best")
            chosen = [(column,) for column in columns.tolist()]
        pairs = zip(options, chosen, strict=True)
        keys = [key for option, under in pairs for key in self._ask(*option, under)]
        self._ledger.enter((node, step, literal), Sum(), [(key, _ONE) for key in keys])

    def _enter_whole(
        self,
        node: Formula,
        literal: Literal,
        options: Sequence[tuple[Formula, int]],
        step: int,
    ) -> None:
        """Options that are all or nothing: the indicator of the one chosen is the value."""
        times = [time for _, time in options]
        if len(options) == 1 and not literal:
            columns = self._choices.free(times)
        else:
            columns = self._choices.optional(literal, times, "part")
        for (child, time), column in zip(options, columns.tolist(), strict=True):
            self.requests.append((positive(child), time, (column,)))
        self._ledger.enter((node, step, literal), Sum.of(columns.tolist()))

    def _pick(self, node: Eventually, literal: Literal, steps: Sequence[int]) -> None:
        """Windows of one literal: each picks from what the child is worth at its steps."""
        times = {step: self._times(node, step) for step in steps}
        keys = {
            time: self._ask(node.child, time, literal)
            for time in sorted({time for window in times.values() for time in window})
        }
        for step, window in times.items():
            if is_whole(node.child):
                columns = self._draft.columns(1, upper=1.0).tolist()
                self._ledger.tie(columns, Sum(), [key for time in window for key in keys[time]])
                if literal:
                    self._ledger.tie(columns, Sum.of(literal))
            else:
                options = self._choices.optional(literal, window, "window").tolist()
                columns = self._draft.columns(len(window), upper=1.0).tolist()
                for time, option, column in zip(window, options, columns, strict=True):
                    self._ledger.tie([column], Sum.of([option]))
                    self._ledger.tie([column], Sum(), keys[time])
            self._ledger.enter((node, step, literal), Sum.of(columns))

    @_value.register
    def _(self, node: Until, asked: Asked) -> None:
        for step, literal in _each(asked):
            self._until(node, step, literal)

    def _until(self, node: Until, step: int, literal: Literal) -> None:
        """One switch step; the left side's value at a step is shared out between later switches."""
        switches = list(range(step + node.low, step + node.high + 1))
        chosen = self._choices.optional(literal, switches, "switch").tolist()
        parts = [
            (key, Fraction(1, switch - step + 1))
            for switch, column in zip(switches, chosen, strict=True)
            for key in self._ask(node.right, switch, (column,))
        ]
        own: dict[int, Fraction] = {}
        for time in range(step, step + node.high):
            later = [
                (switch, column)
                for switch, column in zip(switches, chosen, strict=True)
                if switch > time
            ]
            keys = self._ask(node.left, time, tuple(column for _, column in later))
            if not keys:
                continue
            columns = self._draft.columns(len(later), upper=1.0).tolist()
            self._ledger.tie(columns, Sum(), keys)
            for (switch, option), column in zip(later, columns, strict=True):
                self._ledger.tie([column], Sum.of([option]))
                own[column] = Fraction(1, switch - step + 1)
        self._ledger.enter((node, step, literal), Sum(own), parts)


def is_whole(node: Formula) -> bool:
    """Whether a node's fraction can only be 0 or 1."""
    while isinstance(node, Eventually):
        node = node.child
    if isinstance(node, Or):
        return all(is_whole(child) for child in node.children)
    return isinstance(node, Count | Constant)


def _each(asked: Asked) -> Iterable[tuple[int, Literal]]:
    for step, literals in asked.items():
        for literal in literals:
            yield step, literal
