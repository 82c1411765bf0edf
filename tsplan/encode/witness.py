"""The tight encoding of a formula: one direction, one witness per eventuality.

The formula is in positive normal form and its root must hold, so only "literal = 1 implies the
sub-formula" is needed. Nodes are visited parents first; at each node the literals under which it
is required at each step are gathered, exclusive ones are added up, and the requirement is handed
to its children. What arrives at the atoms is a list of demands: at this step, under this literal,
at least (at most) so many agents here.

* and, G hand their literal down and add nothing.
* or, F, U, R choose one witness (`Choices.choose`). Exactly one is no loss.
* F required at several steps under one literal (F under G) shares its witnesses between the
  windows instead: each window holds at least one. A *chained* encoding asks for the fewest
  witnesses that can cover the windows, one choice each, in order and close enough together. That
  leaves plans out, so it only serves to find a first plan.
"""

from __future__ import annotations

from collections import defaultdict
from collections.abc import Callable, Iterable, Mapping, Sequence
from dataclasses import dataclass, field
from functools import singledispatchmethod
from typing import TypeAlias

import numpy as np

from tsplan.encode.atoms import Bound, Requirement
from tsplan.encode.literals import ALWAYS, Choices, Literal, Timed
from tsplan.encode.outlook import Outlook
from tsplan.logic import (
    Always,
    And,
    Constant,
    Count,
    Eventually,
    Formula,
    Or,
    Release,
    Until,
    walk_all,
)
from tsplan.milp.model import Draft, Ints

Request: TypeAlias = tuple[Formula, int, Literal]
"""A formula that must hold at a step where a literal is 1."""


@dataclass(frozen=True, slots=True)
class Demand:
    """`bound` must hold at `step` where `literal` is 1."""

    bound: Bound
    step: int
    literal: Literal


@dataclass(frozen=True, slots=True)
class Cover:
    """At least one of `columns` is 1 where `literal` is 1 (an eventuality under an always)."""

    columns: tuple[int, ...]
    literal: Literal


@dataclass(eq=False)
class Witnesses:
    """What a formula asks of the agents, as demands under literals."""

    choices: Choices
    demands: list[Demand] = field(default_factory=list)
    covers: list[Cover] = field(default_factory=list)


class WitnessEncoder:
    """Hands requirements from the root of a formula down to its atoms."""

    def __init__(
        self,
        draft: Draft,
        outlook: Outlook,
        requirement: Callable[[Count], Requirement],
        *,
        share: bool = True,
        chain: bool = False,
    ) -> None:
        self._shares = share
        self._chains = chain
        self._outlook = outlook
        self._requirement = requirement
        self._requests: dict[Formula, dict[int, list[Literal]]] = defaultdict(
            lambda: defaultdict(list)
        )
        self.result = Witnesses(Choices(draft))
        self._choices = self.result.choices

    @property
    def choices(self) -> Choices:
        """The literals of this encoder, to ask for more under literals of their own."""
        return self._choices

    @property
    def outlook(self) -> Outlook:
        """What can hold at best."""
        return self._outlook

    def encode(self, root: Formula) -> Witnesses:
        """Require `root` at step 0 and return the demands."""
        return self.encode_all([(root, 0, ALWAYS)])

    def encode_all(self, requests: Sequence[Request]) -> Witnesses:
        """Require each formula at its step where its literal is 1, and return the demands."""
        for node, step, literal in requests:
            self._ask(node, step, literal)
        order = list(walk_all(dict.fromkeys(node for node, _, _ in requests)))
        for node in reversed(order):
            asked = self._requests.pop(node, None)
            if asked is not None:
                merged = {
                    step: self._choices.merged(literals) for step, literals in sorted(asked.items())
                }
                self._pass_on(node, merged)
        return self.result

    def _ask(self, node: Formula, step: int, literal: Literal) -> None:
        if self._outlook.possible(node, step):
            self._requests[node][step].append(literal)
        else:
            self._choices.refute(literal, "impossible")

    @singledispatchmethod
    def _pass_on(self, node: Formula, requests: Mapping[int, list[Literal]]) -> None:
        raise TypeError(f"no tight encoding is registered for {type(node).__name__}")

    @_pass_on.register
    def _(self, node: Constant, requests: Mapping[int, list[Literal]]) -> None:
        """True asks for nothing; false was refuted when it was asked for."""

    @_pass_on.register
    def _(self, node: Count, requests: Mapping[int, list[Literal]]) -> None:
        needed = self._requirement(node)
        for step, literal in _each(requests):
            if needed.every:
                self._demand(needed.bounds, step, literal)
            else:
                able = [b for b in needed.bounds if self._outlook.within_reach(b, step)]
                options = self._options(literal, [step] * len(able), "some state")
                for bound, option in zip(able, options, strict=True):
                    self._demand((bound,), step, option)

    def _demand(self, bounds: Iterable[Bound], step: int, literal: Literal) -> None:
        self.result.demands += [Demand(bound, step, literal) for bound in bounds]

    @_pass_on.register
    def _(self, node: And, requests: Mapping[int, list[Literal]]) -> None:
        for step, literal in _each(requests):
            for child in node.children:
                self._ask(child, step, literal)

    @_pass_on.register
    def _(self, node: Always, requests: Mapping[int, list[Literal]]) -> None:
        for step, literal in _each(requests):
            for later in range(step + node.low, step + node.high + 1):
                self._ask(node.child, later, literal)

    @_pass_on.register
    def _(self, node: Or, requests: Mapping[int, list[Literal]]) -> None:
        for step, literal in _each(requests):
            able = [child for child in node.children if self._outlook.possible(child, step)]
            options = self._options(literal, [step] * len(able), "or")
            for child, option in zip(able, options, strict=True):
                self._ask(child, step, option)

    @_pass_on.register
    def _(self, node: Eventually, requests: Mapping[int, list[Literal]]) -> None:
        by_literal: dict[Literal, list[int]] = defaultdict(list)
        for step, literal in _each(requests):
            by_literal[literal].append(step)
        repeated = {
            key: steps for key, steps in by_literal.items() if self._shares and len(steps) > 1
        }
        if self._chains:
            for literal, steps in repeated.items():
                self._chain(node, literal, steps)
        elif repeated:
            self._share(node, repeated)
        for literal, steps in by_literal.items():
            for step in () if literal in repeated else steps:
                times = self._times(node, step)
                options = self._options(literal, times, "eventually")
                for time, option in zip(times, options, strict=True):
                    self._ask(node.child, time, option)

    def _share(self, node: Eventually, repeated: Mapping[Literal, list[int]]) -> None:
        """Witnesses shared between windows: a free column per step at which the child may hold."""
        windows = [
            (literal, self._times(node, step))
            for literal, steps in repeated.items()
            for step in steps
        ]
        times = sorted({time for _, window in windows for time in window})
        column = dict(zip(times, self._choices.free(times).tolist(), strict=True))
        for literal, window in windows:
            members = tuple(column[time] for time in window)
            self._choices.cover(_ints(members), literal, "eventually")
            self.result.covers.append(Cover(members, literal))
        for time in times:
            self._ask(node.child, time, (column[time],))

    def _chain(self, node: Eventually, literal: Literal, steps: Sequence[int]) -> None:
        """As few witnesses as can cover the windows of all steps, each no later than it must be."""
        length = node.high - node.low + 1
        begin, end = min(steps) + node.low, max(steps) + node.low
        links = -(-(end - begin + 1) // length)
        former: Timed | None = None
        for link in range(links):
            earliest = max(begin, end - (links - 1 - link) * length)
            latest = min(end + length - 1, begin + (link + 1) * length - 1)
            span = range(earliest, latest + 1)
            times = [time for time in span if self._outlook.possible(node.child, time)]
            if not times:
                self._choices.refute(literal, "chain")
                return
            columns = self._choices.choose(literal, times, "chain")
            if former is not None:
                self._choices.follow(former, (columns, times), length, "chain")
            former = (columns, times)
            for time, column in zip(times, columns.tolist(), strict=True):
                self._ask(node.child, time, (column,))

    def _times(self, node: Eventually, step: int) -> list[int]:
        span = range(step + node.low, step + node.high + 1)
        return [time for time in span if self._outlook.possible(node.child, time)]

    @_pass_on.register
    def _(self, node: Until, requests: Mapping[int, list[Literal]]) -> None:
        for step, literal in _each(requests):
            times = []
            for time in range(step, step + node.high + 1):
                if time >= step + node.low and self._outlook.possible(node.right, time):
                    times.append(time)
                if not self._outlook.possible(node.left, time):
                    break
            options = self._options(literal, times, "until")
            for time, option in zip(times, options, strict=True):
                self._ask(node.right, time, option)
            for time in range(step, max(times, default=step)):
                later = [option for at, option in zip(times, options, strict=True) if at > time]
                self._ask(node.left, time, _union(later))

    @_pass_on.register
    def _(self, node: Release, requests: Mapping[int, list[Literal]]) -> None:
        for step, literal in _each(requests):
            first, last = step + node.low, step + node.high
            times: list[int] = []
            endless = True
            for time in range(step, last):
                if time >= first and not self._outlook.possible(node.right, time):
                    endless = False
                    break
                if self._outlook.possible(node.left, time):
                    times.append(time)
            never = [last] if endless and self._outlook.possible(node.right, last) else []
            options = self._options(literal, times + never, "release")
            for time, option in zip(times, options, strict=False):
                self._ask(node.left, time, option)
            for time in range(first, last + 1):
                held = [o for at, o in zip(times + never, options, strict=True) if at >= time]
                if held:
                    self._ask(node.right, time, _union(held))

    def _options(self, literal: Literal, steps: Sequence[int], kind: str) -> list[Literal]:
        """One literal per option, by the steps they begin; a single one needs no column."""
        if not steps:
            self._choices.refute(literal, kind)
            return []
        if len(steps) == 1:
            return [literal]
        return [(column,) for column in self._choices.choose(literal, steps, kind).tolist()]


def _each(requests: Mapping[int, list[Literal]]) -> Iterable[tuple[int, Literal]]:
    for step, literals in requests.items():
        for literal in literals:
            yield step, literal


def _union(literals: Iterable[Literal]) -> Literal:
    """The sum of options of one choice; all of them being `ALWAYS` means always."""
    return tuple(sorted({column for literal in literals for column in literal}))


def _ints(columns: tuple[int, ...]) -> Ints:
    return np.array(columns, dtype=np.int64)
