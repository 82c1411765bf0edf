"""The tight encoding of a formula: one direction, one witness per eventuality.

The formula is in positive normal form and its root must hold, so only "selection = 1 implies the
sub-formula" is needed. Nodes are visited parents first; at each node the selections under which it
is required, each over runs of steps, are gathered, exclusive ones are added up where a choice is
made, and the requirement is handed to its children. What arrives at the atoms is a list of demands:
from this step to that, under this selection, at least (at most) so many agents here.

* and, G hand their selection down and add nothing.
* or, F, U, R choose one witness (`SelectionColumns.choose`). Exactly one is no loss.
* F, U required at several steps under selections that exclude each other choose one witness for all
  of them (`SelectionColumns.relay`): eventualities in a row have a column for each step, not for
  each pair.
* F of one agent somewhere needs no witness: the agent is there at the window's beginning or comes.
* A *blocked* encoding chooses between plain options (predicates, or predicates throughout) once
  for every block of steps, and lets eventualities begin at every so many steps only. That leaves
  plans out too.
* F required at several steps under one selection (F under G) shares its witnesses between the
  windows instead: each window holds at least one. A *chained* encoding asks for the fewest
  witnesses that can cover the windows, one choice each, in order and close enough together. That
  leaves plans out, so it only serves to find a first plan.
"""

from __future__ import annotations

from collections import defaultdict
from collections.abc import Sequence
from dataclasses import dataclass
from functools import singledispatchmethod
from typing import TypeAlias

import numpy as np

from tsplan.encode.atom_encoders import Executed
from tsplan.encode.encoder_rules import Asker, Cover, Demand, Witnesses, sorted_out
from tsplan.encode.robustness_bound import OptimisticBound
from tsplan.encode.selection import ALWAYS, Selection, SelectionColumns, Timed
from tsplan.encode.step_runs import Span, joined
from tsplan.encode.until_release import release, until
from tsplan.logic import (
    Always,
    And,
    Constant,
    Eventually,
    Formula,
    Or,
    Release,
    Until,
    walk_all,
)
from tsplan.milp.model import Draft, Ints

__all__ = ["Cover", "Demand", "Request", "WitnessEncoder", "WitnessRules", "Witnesses"]

Request: TypeAlias = tuple[Formula, int, Selection]
"""A formula that must hold at a step where a selection is 1."""

_CHAINS = 8  # chains of one eventuality; for more parents its witnesses are shared all the same


@dataclass(frozen=True)
class WitnessRules:
    """How choices are encoded: see this module's text for each."""

    share: bool = True
    chain: bool = False
    visits: bool = False
    block: int = 1
    stride: int = 1


class WitnessEncoder(Asker):
    """Hands requirements from the root of a formula down to its atoms."""

    def __init__(
        self, draft: Draft, optimistic: OptimisticBound, rules: WitnessRules = WitnessRules()
    ) -> None:
        super().__init__(SelectionColumns(draft), optimistic, rules.stride)
        self._rules = rules
        self._atoms = optimistic.atoms
        self.result = Witnesses(self.choices)

    def encode(self, root: Formula) -> Witnesses:
        """Require `root` at step 0 and return the demands."""
        return self.encode_all([(root, 0, ALWAYS)])

    def encode_all(self, requests: Sequence[Request]) -> Witnesses:
        """Require each formula at its step where its selection is 1, and return the demands."""
        for node, step, selection in requests:
            self.ask(node, Span(step, step, selection))
        order = list(walk_all(dict.fromkeys(node for node, _, _ in requests)))
        for node in reversed(order):
            spans = self.asked(node)
            if spans:
                (self._demand if node in self._atoms else self._pass_on)(node, spans)
        return self.result

    def _demand(self, node: Formula, spans: list[Span]) -> None:
        """Make demands of what is required of an atom."""
        encoder, needed = self._atoms.of(node)
        if needed.every:
            of_agents = not isinstance(needed.bounds[0], Executed)
            made = self.result.demands if of_agents else self.result.executions
            for span in spans:
                made += [Demand(bound, *span) for bound in needed.bounds]
            return
        best = [(bound, encoder.best(bound)) for bound in needed.bounds]
        for step, selection in self.choices.by_step(spans):
            able = [bound for bound, most in best if self.optimistic.within_reach(most, step)]
            options = self.options(selection, [step] * len(able), "some state")
            for bound, option in zip(able, options, strict=True):
                self.result.demands.append(Demand(bound, step, step, option))

    @singledispatchmethod
    def _pass_on(self, node: Formula, spans: list[Span]) -> None:
        raise TypeError(f"no tight encoding is registered for {type(node).__name__}")

    @_pass_on.register
    def _(self, node: Constant, spans: list[Span]) -> None:
        """True asks for nothing; false was refuted when it was asked for."""

    @_pass_on.register
    def _(self, node: And, spans: list[Span]) -> None:
        for span in spans:
            for child in node.children:
                self.ask(child, span)

    @_pass_on.register
    def _(self, node: Always, spans: list[Span]) -> None:
        for first, last, selection in spans:
            self.ask(node.child, Span(first + node.low, last + node.high, selection))

    @_pass_on.register
    def _(self, node: Or, spans: list[Span]) -> None:
        asked: dict[tuple[int, Selection], list[int]] = defaultdict(list)
        length = self._rules.block if all(map(_plain, node.children)) else 1
        for step, selection in self.choices.by_step(spans):
            asked[step // length, selection].append(step)
        for (_, selection), steps in asked.items():
            able = [c for c in node.children if any(self.optimistic.possible(c, s) for s in steps)]
            options = self.options(selection, [steps[0]] * len(able), "or")
            for child, option in zip(able, options, strict=True):
                for step in steps:
                    self.ask(child, Span(step, step, option))

    @_pass_on.register
    def _(self, node: Eventually, spans: list[Span]) -> None:
        once, again = sorted_out(spans)
        repeated = [span for runs in again.values() for span in runs]
        if self._rules.chain and len(again) <= _CHAINS:
            for selection, runs in again.items():
                self._chain(node, selection, runs)
        elif (self._rules.share or self._rules.chain) and again:
            self._share(node, repeated)
        elif again:
            for step, selection in self.choices.by_step([*once, *repeated]):
                times = self.times(node.child, [(step + node.low, step + node.high)])
                options = self.options(selection, times, "eventually")
                self.ask_at(node.child, zip(times, options, strict=True))
            return
        for family in self.families(once):
            window = np.array([(s.first + node.low, s.first + node.high) for s in family])
            if not self._visited(node.child, family, window):
                times = self.times(node.child, window.tolist())
                self.ask_at(node.child, self.relayed(family, window, times, "eventually"))

    def _visited(self, child: Formula, family: Sequence[Span], window: Ints) -> bool:
        """Require one agent to be somewhere in a window, if that is all that is wanted."""
        if not self._rules.visits or child not in self._atoms or (window != window[0]).any():
            return False
        bound = self._atoms.of(child)[1].visit
        if bound is not None:
            selection = tuple(column for span in family for column in span.selection)
            first, last = window[0].tolist()
            self.result.visits.append(Demand(bound, first, last, selection))
        return bound is not None

    def _share(self, node: Eventually, spans: list[Span]) -> None:
        """Witnesses shared between windows: a free column per step at which the child may hold."""
        asked = self.choices.by_step(joined(spans))
        window = np.array([(step + node.low, step + node.high) for step, _ in asked])
        shared = self.shared(node.child, asked, window, "eventually")
        times, columns = np.array(list(shared.items()), dtype=np.int64).reshape(-1, 2).T
        begin = np.searchsorted(times, window[:, 0], side="left").tolist()
        end = np.searchsorted(times, window[:, 1], side="right").tolist()
        selections = [selection for _, selection in asked]
        self.result.covers += [
            Cover(columns, *place) for place in zip(begin, end, selections, strict=True)
        ]

    def _chain(self, node: Eventually, selection: Selection, runs: Sequence[Span]) -> None:
        """As few witnesses as can cover the windows of all steps, each no later than it must be."""
        length = node.high - node.low + 1
        begin = min(span.first for span in runs) + node.low
        end = max(span.last for span in runs) + node.low
        links = -(-(end - begin + 1) // length)
        former: Timed | None = None
        for link in range(links):
            earliest = max(begin, end - (links - 1 - link) * length)
            latest = min(end + length - 1, begin + (link + 1) * length - 1)
            times = self.times(node.child, [(earliest, latest)])
            if not times:
                self.choices.refute(selection, "chain")
                return
            columns = self.choices.choose(selection, times, "chain")
            if former is not None:
                self.choices.follow(former, (columns, times), length, "chain")
            former = (columns, times)
            self.ask_at(
                node.child, [(t, (c,)) for t, c in zip(times, columns.tolist(), strict=True)]
            )

    @_pass_on.register
    def _(self, node: Until, spans: list[Span]) -> None:
        until(self, node, spans)

    @_pass_on.register
    def _(self, node: Release, spans: list[Span]) -> None:
        release(self, node, spans)


def _plain(node: Formula) -> bool:
    """Whether a formula is a predicate, or one throughout: nothing is chosen below it."""
    return not (node.child if isinstance(node, Always) else node).children
