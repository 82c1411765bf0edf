"""Settling what is to hold: the best that a plan can satisfy, level by level."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, field, replace
from fractions import Fraction
from math import floor, lcm
from typing import TypeAlias

import numpy as np

from tsplan.clock import Clock
from tsplan.encode.encoded import Point, Setting
from tsplan.encode.expressions import Expression
from tsplan.encode.partial.partial_model import PartialModel, Valued, Wish, claimed, valued
from tsplan.encode.switches import Switch
from tsplan.exact import exact
from tsplan.logic import Formula
from tsplan.logic.witness_steps import occurrences
from tsplan.milp.model import Floats
from tsplan.milp.target import Target
from tsplan.plans.outcomes import CERTIFIED, ObjectiveValue
from tsplan.search.clique_cuts import with_clique_cuts
from tsplan.search.effort import Effort
from tsplan.search.lexicographic import Found, Tell
from tsplan.search.neighbourhood import Improving
from tsplan.search.scaling import aim_at, below, by_depth, chunks
from tsplan.search.search import Search
from tsplan.stopping import StoppedBy

Rivals: TypeAlias = Callable[[Setting, Formula], PartialModel]
"""Makes the model of all plans for a demand that reach what was settled."""

_PART = 0.8  # of the time limit that settling may take
_PATIENCE = 30.0  # seconds before the general solver takes over


@dataclass(frozen=True, eq=False)
class Settled:
    """The best point known, what is proven of each level, and what ended the search.

    All of it may be `certified`, and `rests` on something, as with `Found`. `rivals` are the plans
    that reach as much as the point, whatever parts hold in them.
    """

    point: Point | None
    levels: tuple[ObjectiveValue, ...]
    proven: bool
    infeasible: bool
    stopped_by: StoppedBy | None
    size: tuple[int, int, int, int]
    rivals: Rivals | None = None
    certified: bool = False
    rests: frozenset[str] = frozenset()

    def told(self, name: str, value: float | None, bound: float | None) -> ObjectiveValue:
        """The objective as which all levels are told, with who vouches for its bound."""
        if not self.certified or bound is None:
            return ObjectiveValue(name, value, bound)
        return ObjectiveValue(name, value, bound, CERTIFIED, tuple(sorted(self.rests)))


@dataclass(eq=False)
class Settling:
    """Searches the plans of one setting for what holds at best.

    `name` is what the objective is called, `worth` what a point comes to in it by its moves.
    """

    setting: Setting
    effort: Effort
    clock: Clock
    tell: Tell[Point]
    name: str
    worth: Callable[[Point], float]
    _point: Point | None = field(default=None, init=False)
    _levels: list[ObjectiveValue] = field(default_factory=list, init=False)
    _proven: bool = field(default=True, init=False)
    _certified: bool = field(default=True, init=False)
    _rests: frozenset[str] = field(default=frozenset(), init=False)
    _stopped: StoppedBy | None = field(default=None, init=False)
    _size: tuple[int, int, int, int] = field(default=(0, 0, 0, 0), init=False)

    def __post_init__(self) -> None:
        left = self.clock.left
        if left is not None:
            self.clock = self.clock.within(_PART * left)

    # --- weights -----------------------------------------------------------------------------

    def weights(
        self,
        demand: Formula,
        wishes: Sequence[Wish],
        levels: Mapping[int, Sequence[tuple[int, Fraction]]],
        *,
        refuted: bool = False,
    ) -> Settled:
        """Maximise the weighted worth of wishes, the highest level first.

        `levels` has the numbers of wishes and their weights. `refuted` says that no plan reaches
        everything at the first of them.
        """
        with self.clock.timed("build"):
            model = valued(self.setting, demand, wishes)
        best: dict[int, Fraction] = {}
        for level in sorted(levels, reverse=True):
            most = _total(levels[level])
            aim = _worth(model, wishes, levels[level])
            if refuted and not self._levels:
                model = replace(model, encoded=below(model.encoded, aim, most))
            others = sum((_total(levels[lower]) for lower in levels if lower < level), Fraction(0))
            found = self._best(model, aim, self._bounded(others))
            certain = self._noted(found)
            if found.objective is None:
                return self._settled(infeasible=found.proven)
            reached = min(aim.own(found.objective if certain else found.bound), float(most))
            self._levels.append(ObjectiveValue(str(level), aim.own(found.objective), reached))
            best[level] = exact(aim.own(found.objective))
            model = model.having(aim.kept(model.encoded.model, found.objective, "kept"))

        def rivals(setting: Setting, demand: Formula) -> PartialModel:
            model = valued(setting, demand, wishes)
            for level, value in best.items():
                aim = _worth(model, wishes, levels[level])
                model = model.having(aim.kept(model.encoded.model, aim.of_own(value), "kept"))
            return model

        return self._settled(rivals)

    def _bounded(self, others: Fraction) -> Callable[[float], float | None]:
        """A bound on all levels from one on the present level; `others` is all that may follow."""
        known = [level.bound for level in self._levels]

        def bounded(own: float) -> float | None:
            parts = [exact(bound) for bound in known if bound is not None]
            if len(parts) < len(known) or not np.isfinite(own):
                return None
            return float(sum(parts, exact(own) + others))

        return bounded

    # --- depths ------------------------------------------------------------------------------

    def depths(self, tree: Formula, *, together: bool, refuted: bool) -> Settled:
        """Maximise how many pairs hold at each depth without an ancestor, depth by depth.

        `together` settles several depths in one go where exact weights allow it. `refuted` says
        that the whole tree holds in no plan.
        """
        deepest = max(occurrence.depth for occurrence in occurrences(tree))
        every = claimed(self.setting, tree, deepest).claims.by_depth
        counts = [len(columns) for columns in every]
        counts[0] = 0 if refuted else counts[0]
        known: dict[int, tuple[float, float]] = {0: (0.0, 0.0)} if refuted else {}
        bounds: dict[int, float | None] = {d: 0.0 for d, n in enumerate(counts) if not n}
        for chunk in chunks(counts, together=together) or [(0,)]:  # some plan is needed
            with self.clock.timed("build"):
                model = claimed(self.setting, tree, chunk[-1])
            columns = model.encoded.model.size.columns
            aim = by_depth([model.claims.by_depth[depth] for depth in chunk], columns)
            found = self._best(model.with_claims(known), aim, lambda _: None)
            surest, certain = self._proven, self._noted(found)
            if found.values is None:
                return self._settled(infeasible=found.proven)
            made = {d: float(found.values[model.claims.by_depth[d]].round().sum()) for d in chunk}
            known |= {d: (n, n if surest and certain else np.inf) for d, n in made.items()}
            if not surest:
                bounds |= dict.fromkeys(chunk)
            elif certain:
                bounds |= made
            else:
                unit = -aim.vector.min()
                first = min(floor(-found.bound / unit), counts[chunk[0]])
                bounds |= {**dict.fromkeys(chunk), chunk[0]: float(first)}
        values = {depth: known.get(depth, (0.0, 0.0))[0] for depth in range(len(counts))}
        self._levels = [ObjectiveValue(str(d), value, bounds.get(d)) for d, value in values.items()]

        def rivals(setting: Setting, _demand: Formula) -> PartialModel:
            return claimed(setting, tree, deepest).with_claims(
                {d: (n, n) for d, n in values.items()}
            )

        return self._settled(rivals)

    # --- search ------------------------------------------------------------------------------

    def _best(
        self,
        model: PartialModel,
        aim: Target,
        bounded: Callable[[float], float | None],
    ) -> Found:
        """Search for the best point; `bounded` makes a bound of the objective from the aim's."""
        encoded = with_clique_cuts(model.encoded, aim.vector, model.conflicts, self.clock)
        best: float | None = None

        def report(values: Floats | None, _value: float | None, bound: float | None) -> None:
            nonlocal best
            point = None if values is None else Point(encoded, values, tight=True)
            if point is not None:
                self._point = point
                best = self.worth(point)
            told = None if bound is None else bounded(aim.own(bound))
            if point is not None or told is not None:
                self.tell(self.name, point, best, told)

        size = encoded.model.size
        self._size = (size.columns, size.integers, size.rows, size.nonzeros)
        effort = replace(self.effort, switches=self.effort.switches - {Switch.CONTINUOUS})
        search = Search(encoded, aim, effort, self.clock, report)
        search.patience = _PATIENCE
        former = None
        if self._point is not None:
            former = search.adopt(self._point.values[self._point.encoded.flows])
        start = Improving(encoded, aim, self.effort, self.clock).best(former)
        return search.minimise(start)

    def _noted(self, found: Found) -> bool:
        """Whether a search was carried to its end; if not, nothing after it is certain."""
        certain = found.proven and found.stopped_by is None
        self._proven = self._proven and certain
        self._certified = self._certified and found.certified
        self._rests |= found.rests
        self._stopped = self._stopped or found.stopped_by
        return certain

    def _settled(self, rivals: Rivals | None = None, *, infeasible: bool = False) -> Settled:
        proven = self._proven and self._point is not None
        stopped = None
        if not proven and not infeasible:
            stopped = self._stopped or self.clock.stopped_by or StoppedBy.PRECISION
        levels = tuple(self._levels)
        none = infeasible and self._point is None
        made = Settled(self._point, levels, proven, none, stopped, self._size, rivals)
        return replace(made, certified=self._certified, rests=self._rests)


def _worth(
    model: Valued, wishes: Sequence[Wish], entries: Sequence[tuple[int, Fraction]]
) -> Target:
    """The weighted worth of some wishes, as a target."""
    total = Expression.total((model.worth[number], weight) for number, weight in entries)
    units = lcm(*(wishes[n].denominator * weight.denominator for n, weight in entries))
    return aim_at(total, units, model.encoded.model.size.columns)


def _total(entries: Sequence[tuple[int, Fraction]]) -> Fraction:
    """What the wishes of a level are worth together."""
    return sum((weight for _, weight in entries), Fraction(0))
