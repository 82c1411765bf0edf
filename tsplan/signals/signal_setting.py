"""What every model of a problem over signals is made of."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field, replace
from typing import NamedTuple

import numpy as np

from tsplan.clock import Clock
from tsplan.encode.atom_encoders import Atoms
from tsplan.encode.partial.partial_model import Wish, holding
from tsplan.encode.robustness_bound import OptimisticBound
from tsplan.encode.switches import ALL_SWITCHES, Switch
from tsplan.logic import Formula, Linear, conjunction, simplify, substitute, walk
from tsplan.logic.traces import SignalTrace
from tsplan.milp.model import INFINITY, Ints
from tsplan.signals.equalities import loosened
from tsplan.signals.linear_system import System
from tsplan.signals.predicates import LinearEncoder, jointly
from tsplan.signals.reach import Past, Reach


class OwnRow(NamedTuple):
    """A user's own row: factors of values of signals at steps, between two bounds."""

    terms: tuple[tuple[str, int, float], ...]
    low: float
    high: float

    def settled(self, system: System, past: Past | None) -> bool:
        """Whether all that it is about is past."""
        if past is None:
            return False
        return all(step < past.step + (name in system.signals) for name, step, _ in self.terms)


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
    Up to `beyond`, bounds of signals, limits and rows that name one, and the formula may be missed.
    """

    reach: Reach
    goal: Formula
    efforts: tuple[tuple[tuple[str, float], ...], ...] = ()
    own: tuple[OwnRow, ...] = ()
    soft: Soft | None = None
    switches: frozenset[Switch] = ALL_SWITCHES
    beyond: float = 0.0
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
        wishes = ((wish, trace) for wish in self.soft.wishes)
        return holding(self.soft.demand, wishes, depths=self.soft.depths)

    def meant(self, trace: SignalTrace) -> tuple[Formula, Mapping[Formula, Formula]]:
        """The same for a solver, which takes what is all but met for met.

        In what is kept other comparisons stand for some, which are those that are given with it.
        """
        if self.soft is None:
            return self.goal, {}
        every = conjunction(wish.tree for wish in self.soft.wishes)
        loose = loosened(every, self.system)
        instead = {node: other for other, node in loose.items()}
        wishes = [replace(w, tree=substitute(w.tree, instead)) for w in self.soft.wishes]
        return replace(self, soft=replace(self.soft, wishes=tuple(wishes))).held(trace), loose

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
