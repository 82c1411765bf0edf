"""What a plan does with resources: what lies where, what is hauled, and what tasks use.

Amounts are the decimal numbers that files write, added up exactly. What may be parted comes from
solvers' arithmetic, so there a stock may fall short by `FORGIVEN` of all there is; whole pieces are
counted exactly.
"""

from __future__ import annotations

import math
from collections import defaultdict
from dataclasses import dataclass, field
from fractions import Fraction
from functools import cached_property
from typing import TYPE_CHECKING, NamedTuple

from tsplan.exact import digits, exact
from tsplan.plans.supplies import StockHistory

if TYPE_CHECKING:
    from collections.abc import Iterator, Mapping, Sequence

    from tsplan.logic import Execution
    from tsplan.mission import Resource
    from tsplan.name_runs import Run

FORGIVEN = Fraction(1, 10**5)
"""Of all there is of a resource: solvers forgive 1e-6 in each of the steps that add up."""

_NOTHING = Fraction(0)


def forgiven_of(resource: Resource) -> Fraction:
    """By how much a stock of a resource may fall short."""
    return _NOTHING if resource.indivisible else FORGIVEN * max(Fraction(1), resource.total)


class Haul(NamedTuple):
    """An amount that leaves a state at step `left` and is at another at `come`.

    `agents` carry it together, the same amount each.
    """

    agents: Run
    resource: str
    source: str
    target: str
    left: int
    come: int
    amount: Fraction


class Use(NamedTuple):
    """A task that is executed at a state from step `first` to `last`; `done` if that is its end."""

    task: Execution
    state: str
    first: int
    last: int
    done: bool = True

    def needs(self, resource: str) -> Fraction:
        """How much of a resource it needs."""
        return exact(dict(self.task.resources).get(resource, 0.0))


@dataclass(frozen=True)
class Ledger:
    """What a plan does with the resources of a mission.

    What was `found` to lie somewhere, by resource, state and step, is there whatever was planned.
    """

    resources: tuple[Resource, ...] = ()
    horizon: int = 0
    hauls: tuple[Haul, ...] = ()
    uses: tuple[Use, ...] = ()
    found: Mapping[tuple[str, str, int], Fraction] = field(default_factory=dict)

    @cached_property
    def _moved(self) -> tuple[Mapping[tuple[str, str, int], Fraction], ...]:
        """By resource, state and step: what comes, what is carried away, what is used up."""
        come: dict[tuple[str, str, int], Fraction] = defaultdict(Fraction)
        left: dict[tuple[str, str, int], Fraction] = defaultdict(Fraction)
        spent: dict[tuple[str, str, int], Fraction] = defaultdict(Fraction)
        for haul in self.hauls:
            left[haul.resource, haul.source, haul.left] += haul.amount
            come[haul.resource, haul.target, haul.come] += haul.amount
        for resource in self.resources:
            for state, step, amount in resource.sources:
                come[resource.name, state, step] += exact(amount)
            for use in self.uses if resource.consumed else ():
                spent[resource.name, use.state, use.first] += use.needs(resource.name)
        return come, left, spent

    @cached_property
    def lying(self) -> Mapping[tuple[str, str], tuple[Fraction, ...]]:
        """What lies there at every step, before anything is used up or carried away then."""
        come, left, spent = self._moved
        every = (*come, *left, *spent, *self.found)
        places = dict.fromkeys((name, state) for name, state, _ in every)
        found = {}
        for name, state in places:
            here, amounts = _NOTHING, []
            for step in range(self.horizon + 1):
                here += come.get((name, state, step), _NOTHING)
                here = self.found.get((name, state, step), here)
                amounts.append(here)
                here -= left.get((name, state, step), _NOTHING)
                here -= spent.get((name, state, step), _NOTHING)
            found[name, state] = tuple(amounts)
        return found

    def at(self, resource: str, state: str, step: int) -> Fraction:
        """What lies of a resource at a state at a step."""
        amounts = self.lying.get((resource, state))
        return _NOTHING if amounts is None else amounts[step]

    def staying(self, resource: str, state: str, step: int) -> Fraction:
        """What stays there after a step, once everything is used up and carried away then."""
        _, left, spent = self._moved
        node = (resource, state, step)
        return self.at(*node) - left.get(node, _NOTHING) - spent.get(node, _NOTHING)

    @cached_property
    def histories(self) -> tuple[StockHistory, ...]:
        """The stocks as a plan says them."""
        order = {resource.name: number for number, resource in enumerate(self.resources)}
        return tuple(
            StockHistory(name, state, changes(amounts))
            for (name, state), amounts in sorted(
                self.lying.items(), key=lambda item: (order[item[0][0]], item[0][1])
            )
            if any(amounts)
        )

    def asked(self, resource: Resource, state: str, step: int) -> Fraction:
        """What the executions there need at a step: what they use up then, or the tools in use."""
        needs = (
            use.needs(resource.name)
            for use in self.uses
            if use.state == state
            and use.first <= step <= (use.first if resource.consumed else use.last)
        )
        return sum(needs, _NOTHING)

    @property
    def haulage(self) -> Fraction:
        """Amounts times the steps they are moved."""
        return sum((haul.amount * (haul.come - haul.left) for haul in self.hauls), _NOTHING)

    @property
    def reserve(self) -> Fraction | float:
        """The least amount left at any execution beside what is needed; infinite without any."""
        left = (
            self.at(resource.name, use.state, use.first)
            - self.asked(resource, use.state, use.first)
            for resource in self.resources
            for use in self.uses
            if use.needs(resource.name)
        )
        return min(left, default=math.inf)

    def shortages(self) -> Iterator[str]:
        """Where more is used or carried away than there is."""
        _, left, spent = self._moved
        for resource in self.resources:
            name = resource.name
            forgiven = forgiven_of(resource)
            nodes = {node[1:] for node in (*left, *spent) if node[0] == name}
            if not resource.consumed:
                busy = (use for use in self.uses if use.needs(name))
                nodes |= {(u.state, step) for u in busy for step in range(u.first, u.last + 1)}
            for state, step in sorted(nodes, key=lambda node: (node[1], node[0])):
                if step > self.horizon:
                    continue
                here = self.at(name, state, step)
                away = left.get((name, state, step), _NOTHING)
                needed = self.asked(resource, state, step)
                wanted = away + needed if resource.consumed else max(away, needed)
                if wanted > here + forgiven:
                    yield (
                        f"{digits(wanted)} of {name} are used or carried away at {state} at step "
                        f"{step}, and {digits(here)} lie there"
                    )


def changes(amounts: Sequence[Fraction]) -> tuple[tuple[int, float], ...]:
    """The steps from which another amount lies there."""
    found: list[tuple[int, float]] = []
    for step, amount in enumerate(amounts):
        if not found or found[-1][1] != float(max(amount, _NOTHING)):
            found.append((step, float(max(amount, _NOTHING))))
    return tuple(found)
