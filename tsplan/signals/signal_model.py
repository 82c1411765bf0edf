"""From a system and a formula to a model: dynamics, limits, the formula's choices and predicates.

The columns of the signals and controls come first, in the order of `System.names` and of the steps,
then that of the robustness. A control has no column for the last step: the one before is held.
"""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass, field, replace

import numpy as np

from tsplan.encode.atom_encoders import Atoms
from tsplan.encode.expressions import Expression
from tsplan.encode.memory import Watch
from tsplan.encode.partial.depth_claims import claim
from tsplan.encode.partial.partial_model import wished
from tsplan.encode.reference import ReferenceEncoder
from tsplan.encode.robustness_bound import OptimisticBound
from tsplan.encode.selection import ALWAYS, SelectionColumns
from tsplan.encode.switches import Switch
from tsplan.encode.witness import Demand, Request, WitnessEncoder, Witnesses, WitnessRules
from tsplan.logic import Formula, Linear
from tsplan.logic.witness_steps import occurrences
from tsplan.milp.model import INFINITY, Draft, Floats, Ints, Model
from tsplan.milp.model import Terms as Entries
from tsplan.signals.linear_system import Limit, Terms
from tsplan.signals.predicate_rows import PredicateRows
from tsplan.signals.predicates import HalfSpace, LinearEncoder
from tsplan.signals.signal_setting import OwnRow, SignalSetting, Soft

_RULES = WitnessRules()


@dataclass(frozen=True, eq=False)
class SignalModel:
    """A model and what its columns mean.

    `columns` are those of the signals and controls (names, T+1). `rho` is the column of the
    robustness, -1 where the model asks for `level`. `efforts` has the columns of absolute values
    of each effort, with their factors. `worth` is what each wish is worth, and `claims` are the
    columns of what holds at each depth of the tree of a wish. In a `chosen` model all choices are
    made. `missed` are the columns of what may be missed, of the amount by which it is.
    """

    model: Model
    columns: Ints
    rho: int
    level: float
    efforts: tuple[tuple[Ints, Floats], ...] = ()
    refuted: bool = False
    worth: tuple[Expression, ...] = ()
    claims: tuple[Ints, ...] = ()
    chosen: bool = False
    missed: Ints = field(default_factory=lambda: np.empty(0, dtype=np.int64))

    @classmethod
    def given(cls, rows: Floats) -> SignalModel:
        """A model of nothing but the columns of the signals and controls, for a point of `rows`."""
        columns = np.arange(rows.size).reshape(rows.shape)
        return cls(Draft().build(), columns, rho=-1, level=0.0)


def signal_model(
    setting: SignalSetting,
    level: tuple[float, float],
    rules: WitnessRules = _RULES,
) -> SignalModel:
    """The tight model of trajectories with a robustness in `level`; of one number, exactly that."""
    return _Making(setting, level).tight(rules)


def reference_model(setting: SignalSetting, level: tuple[float, float]) -> SignalModel:
    """The plain model with a column for every (sub-formula, step), tied in both directions."""
    return _Making(setting, level).reference()


def chosen_model(
    setting: SignalSetting, level: tuple[float, float], owed: Mapping[Formula, Iterable[int]]
) -> SignalModel:
    """The model in which predicates hold at the steps that are named for them: without choices.

    Other formulas that something is named for are passed over.
    """
    return _Making(setting, level).chosen(owed)


class _Making:
    """One model in the making."""

    def __init__(self, setting: SignalSetting, level: tuple[float, float]) -> None:
        self._setting = setting
        self._level = level
        self._draft = Draft(Watch(setting.clock))
        self._columns = self._laid()
        least, most = level
        self._rho = -1
        self._missed = [np.empty(0, dtype=np.int64)]
        if least < most:
            self._rho = int(self._draft.columns(1, lower=least, upper=most)[0])

    def tight(self, rules: WitnessRules) -> SignalModel:
        self._dynamics()
        atoms = self._setting.atoms(self._columns, *self._level)
        switches = self._setting.switches
        trusting = Switch.OUTLOOK not in switches
        optimistic = OptimisticBound(self._setting.goal, atoms, trusting=trusting)
        rules = replace(rules, share=Switch.SHARING in switches)
        encoder = WitnessEncoder(self._draft, optimistic, rules)
        soft = self._setting.soft
        worth: tuple[Expression, ...] = ()
        claims: tuple[Ints, ...] = ()
        if soft is None:
            witnesses = encoder.encode(self._setting.goal)
        else:
            requests, worth, claims = self._wished(soft, encoder)
            witnesses = encoder.encode_all([(soft.demand, 0, ALWAYS), *requests])
        self._predicates(atoms, witnesses)
        refuted = witnesses.choices.refuted
        return replace(self._made(), refuted=refuted, worth=worth, claims=claims)

    def _wished(
        self, soft: Soft, encoder: WitnessEncoder
    ) -> tuple[Sequence[Request], tuple[Expression, ...], tuple[Ints, ...]]:
        """What wishes require under selections of their own, and what these are worth."""
        if not soft.depths:
            horizon = self._setting.reach.horizon
            requests, worth = wished(soft.wishes, encoder, self._draft, horizon)
            return requests, tuple(worth), ()
        places = occurrences(soft.wishes[0].tree)
        deepest = max(place.depth for place in places)
        possible = encoder.optimistic.possible
        made = claim(places, deepest, encoder.choices, self._draft, possible)
        return made.requests, (), made.by_depth

    def chosen(self, owed: Mapping[Formula, Iterable[int]]) -> SignalModel:
        self._dynamics()
        atoms = self._setting.atoms(self._columns, *self._level)
        demands = [
            Demand(HalfSpace.of(node), step, step, ALWAYS)
            for node, steps in owed.items()
            if isinstance(node, Linear)
            for step in steps
        ]
        self._predicates(atoms, Witnesses(SelectionColumns(self._draft), demands))
        return replace(self._made(), chosen=True)

    def _predicates(self, atoms: Atoms, witnesses: Witnesses) -> None:
        linear = atoms.encoders[Linear]
        assert isinstance(linear, LinearEncoder)
        merged = Switch.FAMILIES in self._setting.switches
        PredicateRows(linear, self._rho, merged=merged).write(witnesses, self._draft)

    def reference(self) -> SignalModel:
        self._dynamics()
        if self._rho < 0:
            self._rho = int(self._draft.columns(1, *self._level)[0])
        atoms = self._setting.atoms(self._columns, *self._level)
        ReferenceEncoder(self._draft, atoms, (self._rho, *self._level)).encode(self._setting.goal)
        return self._made()

    def _made(self) -> SignalModel:
        efforts = tuple(self._effort(effort) for effort in self._setting.efforts)
        model = self._draft.build()
        missed = np.concatenate(self._missed)
        return SignalModel(model, self._columns, self._rho, self._level[1], efforts, missed=missed)

    def _laid(self) -> Ints:
        """Columns of signals for the steps 0..T, of controls for 0..T-1."""
        reach, count = self._setting.reach, len(self._setting.system.signals)
        rows = []
        for row, (low, high) in enumerate(zip(reach.low, reach.high, strict=True)):
            last = len(low) if row < count else max(len(low) - 1, 1)
            columns = self._draft.columns(last, lower=low[:last], upper=high[:last])
            rows.append(np.append(columns, columns[-1:])[: len(low)])
        return np.array(rows, dtype=np.int64).reshape(len(rows), reach.horizon + 1)

    def _dynamics(self) -> None:
        """How the signals go on, and what limits them at every step."""
        system, first = self._setting.system, self._setting.reach.now
        count, steps = len(system.signals), self._setting.reach.horizon - first
        if system.dynamics is not None and steps:
            a, b, d = system.dynamics.arrays
            now, after = self._columns[:, first:-1], self._columns[:count, first + 1 :]
            which, of = np.nonzero(np.hstack([a, b]))
            factors = np.hstack([a, b])[which, of]
            rows = np.arange(count * steps).reshape(count, steps)
            self._draft.define(
                after.ravel(),
                (rows[which].ravel(), now[of].ravel(), np.repeat(factors, steps)),
                constant=np.repeat(d, steps),
                kind="dynamics",
            )
        for limit in system.limits:
            self._limit(limit)
        for row in self._setting.own:
            self._own(row)
        if self._setting.beyond:
            self._bounds()

    def _limit(self, limit: Limit) -> None:
        """A limit at every step to come; one on controls at those at which there is one."""
        last = self._last(limit.names)
        first = self._first(limit.names)
        every = np.arange(max(last - first, 0))
        parts: list[Entries] = [self._sum(limit.terms, last, first)]
        for factor, terms in limit.absolute:
            size = self._draft.columns(len(every))
            self._sized(size, terms, last, first)
            parts.append((every, size, factor))
        if not set(limit.names) <= self._setting.system.controls.keys():
            parts += self._leave(len(every), -1.0)
        self._draft.sums(*parts, lower=-INFINITY, upper=limit.bound, count=len(every), kind="limit")

    def _own(self, row: OwnRow) -> None:
        """A user's own row, unless all of it is past."""
        if row.settled(self._setting.system, self._setting.reach.past):
            return
        place = self._place()
        columns = [int(self._columns[place[name], step]) for name, step, _ in row.terms]
        factors = [factor for _, _, factor in row.terms]
        sides = [(row.low, row.high, 0.0)]
        if self._setting.beyond:
            sides = [(row.low, INFINITY, 1.0), (-INFINITY, row.high, -1.0)]
        for low, high, sign in sides:
            parts = self._leave(1, sign)
            self._draft.sums((0, columns, factors), *parts, lower=low, upper=high, kind="own")

    def _bounds(self) -> None:
        """Bounds that may be missed: those of the signals to come, and the least robustness."""
        reach, bounds = self._setting.reach, self._setting.system.signals.values()
        count = reach.horizon + 1 - reach.ahead
        for row, ends in enumerate(bounds):
            own: Entries = (np.arange(count), self._columns[row, reach.ahead :], 1.0)
            for end, sign in zip(ends, (1.0, -1.0), strict=True):
                low, high = (end, INFINITY) if sign > 0 else (-INFINITY, end)
                if np.isfinite(end):
                    self._draft.sums(
                        own,
                        *self._leave(count, sign),
                        lower=low,
                        upper=high,
                        count=count,
                        kind="bound",
                    )
        if self._rho >= 0:
            self._draft.sums((0, [self._rho], 1.0), *self._leave(1, 1.0), kind="bound")

    def _leave(self, count: int, sign: float) -> list[Entries]:
        """What lets rows be missed, each by an amount of its own."""
        if not self._setting.beyond:
            return []
        columns = self._draft.columns(count, upper=self._setting.beyond)
        self._missed.append(columns)
        return [(np.arange(count), columns, sign)]

    def _effort(self, effort: tuple[tuple[str, float], ...]) -> tuple[Ints, Floats]:
        """Columns for the absolute values of signals and controls at every step they have."""
        columns, factors = [np.empty(0, dtype=np.int64)], [np.empty(0)]
        for name, factor in effort:
            last = self._last([name])
            size = self._draft.columns(last)
            self._sized(size, ((name, 1.0),), last)
            columns.append(size)
            factors.append(np.full(last, factor))
        return np.concatenate(columns), np.concatenate(factors)

    def _sized(self, size: Ints, terms: Terms, last: int, first: int = 0) -> None:
        """Let columns be at least the absolute value of a sum at the steps `first` to `last`."""
        index, columns, factors = self._sum(terms, last, first)
        for sign in (1.0, -1.0):
            self._draft.sums(
                (np.arange(len(size)), size, 1.0),
                (index, columns, sign * factors),
                count=len(size),
                kind="size",
            )

    def _sum(self, terms: Terms, last: int, first: int = 0) -> tuple[Ints, Ints, Floats]:
        """A sum at the steps from `first` to before `last`, as a row for each."""
        place = self._place()
        rows = [place[name] for name, _ in terms]
        count = max(last - first, 0)
        index = np.tile(np.arange(count), len(rows))
        factors = np.repeat([factor for _, factor in terms], count)
        return index, self._columns[rows, first:last].ravel(), factors

    def _place(self) -> dict[str, int]:
        return {name: row for row, name in enumerate(self._setting.system.names)}

    def _first(self, names: Iterable[str]) -> int:
        """The first step at which not all of some signals and controls are known."""
        steered = any(name in self._setting.system.controls for name in names)
        return self._setting.reach.now if steered else self._setting.reach.ahead

    def _last(self, names: Iterable[str]) -> int:
        """At how many steps all of some signals and controls are there."""
        steered = any(name in self._setting.system.controls for name in names)
        return self._setting.reach.horizon + (0 if steered else 1)
