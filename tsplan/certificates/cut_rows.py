"""Whether the cuts of a certificate are cuts of its mission: told from the mission alone.

An arrival cut is made anew from the columns that it names. A cut of visitors says that whoever
serves a demand comes in along one of its edges, or begins behind them: it is true if no way from
any other start to the demand goes without these edges, which a walk back from the demand finds out.
"""

from __future__ import annotations

from collections import defaultdict
from collections.abc import Mapping
from dataclasses import dataclass, field
from functools import cached_property

import numpy as np

from tsplan.certificates.checker import Number, Row
from tsplan.encode.arrival_cuts import cut_terms
from tsplan.encode.encoded import Encoded
from tsplan.encode.visitor_cuts import Visits
from tsplan.milp.model import Ints


@dataclass(frozen=True, eq=False)
class CutRows:
    """Tells true cuts of one encoded mission."""

    encoded: Encoded
    _ways: dict[str | None, _Ways] = field(default_factory=dict, init=False)

    def true(self, kind: str, row: Row) -> bool:
        """Whether a row of a kind holds for every plan."""
        if row.sense != "G":
            return False
        if kind == "arrival":
            return self._arrival(row)
        return kind == "visitors" and self._visitors(row)

    # --- arrivals --------------------------------------------------------------------------------

    def _arrival(self, row: Row) -> bool:
        """Whether it is the cut of some window of a family."""
        if row.side > 0:
            return False
        for number in {n for column in row.terms for n in self._arrivals.get(column, ())}:
            site, family = self.encoded.families[number]
            places = {int(site.arrived[k]): k + site.first for k in range(len(site.arrived))}
            named = [(places[c], f) for c, f in row.terms.items() if c in places]
            ends = sorted(step for step, _ in named)
            if len(ends) != 2:  # noqa: PLR2004  (the beginning of a window and its end)
                continue
            low, high = np.searchsorted(family.steps, ends)
            found = family.steps[np.minimum([low, high], len(family.steps) - 1)].tolist()
            if found == ends and self._window(number, int(low), int(high)) == dict(row.terms):
                return True
        return False

    def _window(self, number: int, low: int, high: int) -> Mapping[int, Number]:
        site, family = self.encoded.families[number]
        _, columns, factors = cut_terms(site, family, np.array([low]), np.array([high]))
        found: dict[int, Number] = defaultdict(int)
        for column, factor in zip(columns.tolist(), factors.tolist(), strict=True):
            found[column] += int(factor) if factor.is_integer() else factor
        return {column: factor for column, factor in found.items() if factor}

    @cached_property
    def _arrivals(self) -> Mapping[int, list[int]]:
        """The families of each column of arrivals that can have cuts of their own."""
        found: dict[int, list[int]] = defaultdict(list)
        for number, (site, family) in enumerate(self.encoded.families):
            if family.consecutive:
                for column in site.arrived.tolist():
                    found[column].append(number)
        return found

    # --- visitors --------------------------------------------------------------------------------

    def _visitors(self, row: Row) -> bool:
        """Whether it is a cut of some demands of different agents."""
        for one in self.encoded.visits:
            ways = self._ways_of(one.capability)
            crossing = {c for c, f in row.terms.items() if f == 1 and c in ways.flows}
            asked = {c: -f for c, f in row.terms.items() if c not in crossing}
            if self._serves(ways, one, crossing, asked, row.side):
                return True
        return False

    def _serves(
        self,
        ways: _Ways,
        one: Visits,
        crossing: set[int],
        asked: Mapping[int, Number],
        side: Number,
    ) -> bool:
        """Whether what is asked for by some parts of a demand has to cross, or begins inside."""
        part, members, amount = (item.tolist() for item in np.broadcast_arrays(*one.terms))
        for together in (True, False):
            some = set(range(len(one.first)))
            if not together:
                some = {p for p, c, a in zip(part, members, amount, strict=True) if c in asked}
                some |= set(range(len(one.first))) if not asked else set()
            allowed: dict[int, Number] = defaultdict(int)
            for p, column, number in zip(part, members, amount, strict=True):
                allowed[column] += int(number) if p in some else 0
            if any(number > allowed.get(column, 0) for column, number in asked.items()):
                continue
            where = sorted(some)
            if together:
                spans = [(int(one.first.min()), int(one.last.max()))]
            else:
                spans = [(int(one.first[p]), int(one.last[p])) for p in where]
            begun = ways.behind(np.array(one.states), spans, crossing)
            if side <= int(one.constant[where].sum()) - begun:
                return True
        return False

    def _ways_of(self, capability: str | None) -> _Ways:
        if capability not in self._ways:
            self._ways[capability] = _Ways(self.encoded, capability)
        return self._ways[capability]


class _Ways:
    """The ways of all agents with a capability, to be walked back."""

    def __init__(self, encoded: Encoded, capability: str | None) -> None:
        network = encoded.network
        self._classes = network.having(capability)
        self._before: dict[tuple[int, int, int], list[tuple[int, int, int, int]]] = defaultdict(
            list
        )
        self.flows: set[int] = set()
        for number, item in enumerate(self._classes):
            edge, step, column = item.unrolled()
            graph = item.graph
            ends = (step + graph.duration[edge]).tolist()
            tails, heads = graph.tail[edge].tolist(), graph.head[edge].tolist()
            self.flows.update(column.tolist())
            for tail, head, begin, end, flow in zip(
                tails, heads, step.tolist(), ends, column.tolist(), strict=True
            ):
                self._before[number, head, end].append((number, tail, begin, flow))

    def behind(self, states: Ints, spans: list[tuple[int, int]], crossing: set[int]) -> int:
        """How many agents begin where they reach the states in some span without crossing."""
        reached = {
            (number, node, step)
            for number, item in enumerate(self._classes)
            for node in item.graph.nodes(states).tolist()
            for first, last in spans
            for step in range(first, last + 1)
        }
        waiting = list(reached)
        while waiting:
            for number, tail, begin, flow in self._before.get(waiting.pop(), ()):
                node = number, tail, begin
                if flow not in crossing and node not in reached:
                    reached.add(node)
                    waiting.append(node)
        starts = ((number, node) for number, node, step in reached if step == 0)
        return sum(int(self._classes[number].graph.start[node]) for number, node in starts)
