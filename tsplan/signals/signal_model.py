"""From a system and a formula to a model: dynamics, limits, the formula's choices and predicates.

The columns of the signals and controls come first, in the order of `System.names` and of the steps,
then that of the robustness. A control has no column for the last step: the one before is held.
"""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass, field, replace
from typing import NamedTuple

import numpy as np

from tsplan.clock import Clock
from tsplan.encode.atom_encoders import Atoms
from tsplan.encode.expressions import Expression
from tsplan.encode.memory import Watch
from tsplan.encode.partial.depth_claims import claim
from tsplan.encode.partial.partial_model import Wish, wished
from tsplan.encode.reference import ReferenceEncoder
from tsplan.encode.robustness_bound import OptimisticBound
from tsplan.encode.selection import ALWAYS, SelectionColumns
from tsplan.encode.switches import ALL_SWITCHES, Switch
from tsplan.encode.witness import Demand, Request, WitnessEncoder, Witnesses, WitnessRules
from tsplan.logic import Formula, Linear, conjunction, positive, simplify, walk
from tsplan.logic.fraction import shares
from tsplan.logic.traces import SignalTrace
from tsplan.logic.witness_steps import Pair, demanded, levels, occurrences, satisfied
from tsplan.milp.model import INFINITY, Draft, Floats, Ints, Model
from tsplan.milp.model import Terms as Entries
from tsplan.signals.linear_system import Limit, System, Terms
from tsplan.signals.predicate_rows import PredicateRows
from tsplan.signals.predicates import HalfSpace, LinearEncoder, jointly
from tsplan.signals.reach import Reach

_RULES = WitnessRules()


class OwnRow(NamedTuple):
    """A user's own row: factors of values of signals at steps, between two bounds."""

    terms: tuple[tuple[str, int, float], ...]
    low: float
    high: float


@dataclass(frozen=True, eq=False)
class Soft:
    """What is to hold as far as possible beside what must: wishes, by how much of them holds.

    With `depths` there is one wish, of which is counted what holds at each depth of its tree.
    """

    demand: Formula
    wishes: tuple[Wish, ...]
    depths: bool = False


@dataclass(frozen=True, eq=False)
class SignalSetting:
    """What every model of a problem over signals is made of.

    `goal` is in positive normal form, without weights. `efforts` are the sums of absolute values
    that an objective weighs: for each, the factor of every signal or control in it. `own` are
    a user's own rows. Where not all must hold, `soft` says what should, and `goal` has all of that.
    """

    reach: Reach
    goal: Formula
    efforts: tuple[tuple[tuple[str, float], ...], ...] = ()
    own: tuple[OwnRow, ...] = ()
    soft: Soft | None = None
    switches: frozenset[Switch] = ALL_SWITCHES
    clock: Clock = field(default_factory=Clock)

    @property
    def system(self) -> System:
        """The system whose signals are planned."""
        return self.reach.system

    def atoms(self, columns: Ints, least: float, most: float, *, forgiving: bool = True) -> Atoms:
        """The predicates, of which a robustness from `least` to `most` is wanted."""
        encoder = LinearEncoder(self.reach, columns, least, most, forgiving)
        return Atoms({Linear: encoder}, self.reach.horizon, jointly)

    @property
    def whole(self) -> SignalSetting:
        """The setting in which everything must hold that should."""
        if self.soft is None:
            return self
        every = conjunction([self.soft.demand, *(wish.whole for wish in self.soft.wishes)])
        return replace(self, goal=simplify(every), soft=None)

    def held(self, trace: SignalTrace) -> Formula:
        """What holds on a trace and is to be kept: all that must, and of what should what does."""
        if self.soft is None:
            return self.goal
        pairs: list[Pair] = []
        for wish in self.soft.wishes:
            if self.soft.depths:
                pairs += levels(wish.tree, trace).pairs
            elif wish.partial or shares(wish.tree, trace)[wish.tree][0].fraction == 1:
                pairs += satisfied(wish.tree, trace)
        return simplify(conjunction([self.soft.demand, positive(demanded(pairs))]))

    @property
    def ideal(self) -> float:
        """A bound on the robustness of every trajectory: the optimistic one of the formula."""
        none = np.empty((0, self.reach.horizon + 1), dtype=np.int64)
        atoms = self.atoms(none, 0.0, INFINITY, forgiving=False)
        if self.soft is None:
            return OptimisticBound(self.goal, atoms).best(self.goal, 0)
        demanded = OptimisticBound(self.soft.demand, atoms).best(self.soft.demand, 0)
        each = (float(atoms.best(node).max()) for node in walk(self.goal) if node in atoms)
        return min(demanded, max(each, default=0.0))


@dataclass(frozen=True, eq=False)
class SignalModel:
    """A model and what its columns mean.

    `columns` are those of the signals and controls (names, T+1). `rho` is the column of the
    robustness, -1 where the model asks for `level`. `efforts` has the columns of absolute values
    of each effort, with their factors. `worth` is what each wish is worth, and `claims` are the
    columns of what holds at each depth of the tree of a wish. In a `chosen` model all choices are
    made.
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
        return SignalModel(model, self._columns, self._rho, self._level[1], efforts)

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
        system, steps = self._setting.system, self._setting.reach.horizon
        count = len(system.signals)
        if system.dynamics is not None and steps:
            a, b, d = system.dynamics.arrays
            now, after = self._columns[:, :steps], self._columns[:count, 1:]
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

    def _limit(self, limit: Limit) -> None:
        """A limit at every step; one on controls at those at which there is one."""
        of = [limit.terms, *(terms for _, terms in limit.absolute)]
        last = self._last(name for terms in of for name, _ in terms)
        every = np.arange(last)
        parts: list[Entries] = [self._sum(limit.terms, last)]
        for factor, terms in limit.absolute:
            size = self._draft.columns(last)
            self._sized(size, terms, last)
            parts.append((every, size, factor))
        self._draft.sums(*parts, lower=-INFINITY, upper=limit.bound, count=last, kind="limit")

    def _own(self, row: OwnRow) -> None:
        """A user's own row."""
        place = self._place()
        columns = [int(self._columns[place[name], step]) for name, step, _ in row.terms]
        factors = [factor for _, _, factor in row.terms]
        self._draft.sums((0, columns, factors), lower=row.low, upper=row.high, kind="own")

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

    def _sized(self, size: Ints, terms: Terms, last: int) -> None:
        """Let columns be at least the absolute value of a sum at the steps before `last`."""
        every = np.arange(last)
        index, columns, factors = self._sum(terms, last)
        for sign in (1.0, -1.0):
            self._draft.sums(
                (every, size, 1.0), (index, columns, sign * factors), count=last, kind="size"
            )

    def _sum(self, terms: Terms, last: int) -> tuple[Ints, Ints, Floats]:
        """A sum at the steps before `last`, as a row for each."""
        place = self._place()
        rows = [place[name] for name, _ in terms]
        index = np.tile(np.arange(last), len(rows))
        factors = np.repeat([factor for _, factor in terms], last)
        return index, self._columns[rows, :last].ravel(), factors

    def _place(self) -> dict[str, int]:
        return {name: row for row, name in enumerate(self._setting.system.names)}

    def _last(self, names: Iterable[str]) -> int:
        """At how many steps all of some signals and controls are there."""
        steered = any(name in self._setting.system.controls for name in names)
        return self._setting.reach.horizon + (0 if steered else 1)
