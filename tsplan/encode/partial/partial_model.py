"""The models of missions that hold as far as possible."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Mapping, Sequence
from dataclasses import dataclass, replace
from fractions import Fraction
from typing import Self

import numpy as np

from tsplan.encode.assemble import assembled
from tsplan.encode.encoded import Encoded, Setting
from tsplan.encode.expressions import Expression
from tsplan.encode.flow_network import Network
from tsplan.encode.partial.conflict_graph import ConflictGraph, team_rows
from tsplan.encode.partial.depth_claims import Claims, claim
from tsplan.encode.partial.fraction_terms import FractionEncoder
from tsplan.encode.robustness_bound import OptimisticBound
from tsplan.encode.selection import ALWAYS
from tsplan.encode.witness import Demand, Request, WitnessEncoder, Witnesses
from tsplan.logic import Formula, conjunction, positive, simplify
from tsplan.logic.fraction import NOTHING, WHOLE, Shares, denominator, shares, shares_of
from tsplan.logic.traces import Trace
from tsplan.logic.witness_steps import Pair, demanded, levels, occurrences, satisfied
from tsplan.milp.model import Draft, Model
from tsplan.mission import Mission, Preference


@dataclass(frozen=True, eq=False)
class Wish:
    """A tree that should hold, as a whole or as far as possible."""

    tree: Formula
    partial: bool

    @property
    def whole(self) -> Formula:
        """The formula that holds where all of the tree does."""
        return simplify(positive(self.tree))

    def worth(self, trace: Trace) -> Fraction:
        """What the wish is worth: by how much it is met, with its weights, or whether it is."""
        share = shares(self.tree, trace, weighted=self.partial)[self.tree][0].fraction
        return share if self.partial else Fraction(share == 1)

    def met(self, trace: Trace) -> tuple[Pair, ...]:
        """What holds of the wish; wherever that does, the wish is worth as much."""
        if self.partial:
            return satisfied(self.tree, trace)
        return ((self.tree, 0),) if self.worth(trace) else ()

    @property
    def denominator(self) -> int:
        """What the wish is worth is a multiple of one over this."""
        return denominator(self.tree) if self.partial else 1


def wish_of(mission: Mission, preference: Preference) -> Wish:
    """A preference as a wish."""
    return Wish(mission.tree(preference.formula), preference.partial)


def holding(demand: Formula, wishes: Iterable[tuple[Wish, Trace]], *, depths: bool) -> Formula:
    """What is to be kept of what holds: all of a demand, and of each wish what does on its trace.

    With `depths` that is what holds at every depth of its tree.
    """
    pairs: list[Pair] = []
    for wish, trace in wishes:
        pairs += levels(wish.tree, trace).pairs if depths else wish.met(trace)
    return simplify(conjunction([demand, positive(demanded(pairs))]))


def everything(demand: Formula, wishes: Sequence[Wish]) -> Formula:
    """A positive formula that has all sub-formulas that may be asked for."""
    return conjunction([demand, *(positive(w.tree) if w.partial else w.whole for w in wishes)])


@dataclass(frozen=True, eq=False)
class PartialModel:
    """A model in which not everything need hold, and what excludes each other in it."""

    encoded: Encoded
    conflicts: ConflictGraph

    def having(self, model: Model) -> Self:
        """The same with more rows."""
        return replace(self, encoded=replace(self.encoded, model=model))


@dataclass(frozen=True, eq=False)
class Valued(PartialModel):
    """A model and what each wish is worth in it."""

    worth: tuple[Expression, ...]


def valued(setting: Setting, demand: Formula, wishes: Sequence[Wish]) -> Valued:
    """The model in which `demand` holds and every wish is worth its fraction, or 1 as a whole."""
    worth: list[Expression] = []
    demands: list[Demand] = []

    def ask(encoder: WitnessEncoder, draft: Draft, network: Network) -> Witnesses:
        requests, found = wished(wishes, encoder, draft, setting.horizon)
        worth.extend(found)
        witnesses = encoder.encode_all([(demand, 0, ALWAYS), *requests])
        team_rows(witnesses.stepwise, network, draft)
        demands.extend(witnesses.stepwise)
        return witnesses

    encoded = assembled(setting, ask, optional=True)
    return Valued(encoded, _conflicts(encoded, demands), tuple(worth))


def wished(
    wishes: Sequence[Wish], encoder: WitnessEncoder, draft: Draft, horizon: int
) -> tuple[list[Request], list[Expression]]:
    """What wishes require under selections of their own, and what each is worth by these."""
    requests: list[Request] = []
    worth: list[Expression] = []
    for wish in wishes:
        if wish.partial:
            hope = hopes(wish.tree, encoder.optimistic, horizon)
            parts = FractionEncoder(draft, encoder.choices, hope)
            worth.append(parts.encode(wish.tree))
            requests += parts.requests
        else:
            (column,) = encoder.choices.free([0]).tolist()
            worth.append(Expression.sum_of([column]))
            requests.append((wish.whole, 0, (column,)))
    return requests, worth


@dataclass(frozen=True, eq=False)
class Claimed(PartialModel):
    """A model and the claims in it."""

    claims: Claims

    def with_claims(self, counts: Mapping[int, tuple[float, float]]) -> Self:
        """Between so many and so many claims at some depths."""
        model = self.encoded.model
        for depth, (least, most) in counts.items():
            vector = np.zeros(model.size.columns)
            vector[self.claims.by_depth[depth]] = 1.0
            if vector.any() or least > 0:
                model = model.with_row(vector, least, most, "kept")
        return self.having(model)


def claimed(setting: Setting, tree: Formula, deepest: int) -> Claimed:
    """The model of all plans with claims at the places of a tree down to a depth."""
    found: list[Claims] = []
    demands: list[Demand] = []
    everywhere = occurrences(tree)

    def ask(encoder: WitnessEncoder, draft: Draft, network: Network) -> Witnesses:
        made = claim(everywhere, deepest, encoder.choices, draft, encoder.optimistic.possible)
        found.append(made)
        witnesses = encoder.encode_all(made.requests)
        team_rows(witnesses.stepwise, network, draft)
        demands.extend(witnesses.stepwise)
        return witnesses

    encoded = assembled(setting, ask, optional=True)
    return Claimed(encoded, _conflicts(encoded, demands), found[0])


def _conflicts(encoded: Encoded, demands: Sequence[Demand]) -> ConflictGraph:
    return ConflictGraph(demands, encoded.network, encoded.model.size.columns)


def hopes(
    tree: Formula, optimistic: OptimisticBound, horizon: int
) -> Callable[[Formula, int], bool]:
    """Which fractions may be more than 0, every atom judged on its own."""

    def atom(node: Formula) -> Shares:
        plain = positive(node)
        able = (optimistic.possible(plain, step) for step in range(horizon + 1))
        return tuple(WHOLE if so else NOTHING for so in able)

    best = shares_of(tree, atom)
    return lambda node, step: best[node][step].fraction > 0
