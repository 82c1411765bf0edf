"""Two published encodings of STL over linear systems, rebuilt to be measured against.

Both unroll the formula into a tree, once for every step at which a part is looked at, and ask for
`a.y(t) - b + 1000 (1 - z) >= rho` at a predicate, with one number z for each place in the tree.

`stlpy` is the program of stlpy's `GurobiMICPSolver` (C. Belta and S. Sadraddini, "Formal Methods
for Control Synthesis: An Optimization Perspective", Annual Review of Control, Robotics, and
Autonomous Systems 2019): z is binary at predicates; at "and" no more than each part's, at "or" no
more than their sum.

`sos1` has fewer binaries (V. Kurtz and H. Lin, "Mixed-Integer Programming for Signal Temporal Logic
with Fewer Binary Variables", L-CSS 2022): none but at "or", where the parts' numbers and 1 - z add
up to 1 and all but one of them are 0, said by the binary digits of which one it is.

They are kinder than the originals in that signals have their bounds on columns and outputs no
columns of their own. Until and release are those of tsplan.
"""

from __future__ import annotations

import math
import time
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, field, replace
from types import MappingProxyType
from typing import Any, TypeAlias

import numpy as np

from tsplan.logic import (
    Always,
    And,
    Eventually,
    Formula,
    Linear,
    Or,
    Release,
    SignalTrace,
    Until,
    positive,
    robustness,
)
from tsplan.milp.model import INFINITY, Block, Draft, Floats, Ints, Model, Terms
from tsplan.milp.solution import Options, Solution, Status, Watcher
from tsplan.milp.solver import Solver, solver
from tsplan.plans.outcomes import MissionRef, ModelSize, ObjectiveValue
from tsplan.plans.outcomes import Status as PlanStatus
from tsplan.signals.aims import Aim
from tsplan.signals.linear_system import System
from tsplan.signals.linear_system import Terms as Named
from tsplan.signals.signal_mission import SignalMission
from tsplan.signals.trajectory import Trajectory
from tsplan.stopping import StoppedBy

BIG = 1000.0
"""The constant by which a predicate is switched off, as published."""

TOLERANCE = 1e-6
"""The solver's own; by as much, relative to it, may a later aim worsen an earlier one."""


@dataclass(frozen=True)
class Leaf:
    """`factor * e >= factor * c` of a predicate `e >= c` or `e <= c`, at a step."""

    atom: Linear
    step: int

    @property
    def factor(self) -> float:
        """1, or -1 for a predicate that bounds from above."""
        return 1.0 if self.atom.relation in (">=", ">") else -1.0


@dataclass(frozen=True)
class Join:
    """Any of some trees, or all of them."""

    any: bool
    parts: tuple[Tree, ...]


Tree: TypeAlias = Leaf | Join


def unrolled(node: Formula, step: int = 0) -> Tree:
    """The tree of a formula in positive normal form, looked at from a step on."""
    match node:
        case Linear():
            return Leaf(node, step)
        case And() | Or():
            parts = [unrolled(child, step) for child in node.children]
        case Always() | Eventually():
            parts = [unrolled(node.child, step + k) for k in range(node.low, node.high + 1)]
        case Until() | Release():
            parts = [_change(node, step, k) for k in range(node.low, node.high + 1)]
        case _:
            raise ValueError(f"'{node}' cannot be unrolled")
    return Join(isinstance(node, Or | Eventually | Until), tuple(parts))


def _change(node: Until | Release, step: int, after: int) -> Join:
    """What an until asks for all of, and a release for any of, to change over at one step."""
    before = [unrolled(node.left, step + k) for k in range(after)]
    return Join(isinstance(node, Release), (*before, unrolled(node.right, step + after)))


class Motion:
    """The columns of a system over the steps of a horizon, and the rows of its dynamics."""

    def __init__(self, draft: Draft, system: System, steps: int) -> None:
        self.draft = draft
        self.system = system
        self.columns: dict[str, Ints] = {}
        for name, (low, high) in system.signals.items():
            lower, upper = np.full(steps + 1, low, float), np.full(steps + 1, high, float)
            lower[0], upper[0] = system.begins(name)
            self.columns[name] = draft.columns(steps + 1, lower, upper)
        for name, (low, high) in system.controls.items():
            self.columns[name] = draft.columns(steps, low, high)
        if system.dynamics is not None:
            self._move(steps)
        for limit in system.limits:
            named = [limit.terms, *(inner for _, inner in limit.absolute)]
            steered = any(name in system.controls for part in named for name, _ in part)
            for step in range(steps + (not steered)):
                terms = self.terms(limit.terms, step)
                terms += [(0, self.size(inner, step), by) for by, inner in limit.absolute]
                draft.sums(*terms, lower=-INFINITY, upper=limit.bound, kind="limit")

    def _move(self, steps: int) -> None:
        assert self.system.dynamics is not None
        a, b, d = self.system.dynamics.arrays
        now = [*self.system.signals]
        for row, name in enumerate(now):
            factors = zip([*now, *self.system.controls], [*a[row], *b[row]], strict=True)
            terms = [
                (range(steps), self.columns[other][:steps], factor)
                for other, factor in factors
                if factor
            ]
            after = self.columns[name][1:]
            self.draft.define(after, *terms, constant=np.full(steps, d[row]), kind="dynamics")

    def terms(self, named: Named, step: int, factor: float = 1.0) -> list[Terms]:
        """A linear expression at a step as the entries of one row; the last controls are held."""
        found = ((self.columns[name], by) for name, by in named)
        return [(0, own[min(step, len(own) - 1)], factor * by) for own, by in found]

    def size(self, named: Named, step: int) -> int:
        """A new column, at least the absolute value of an expression at a step."""
        (column,) = self.draft.columns(1)
        for sign in (1.0, -1.0):
            self.draft.sums((0, column, 1.0), *self.terms(named, step, sign), kind="size")
        return int(column)

    def sought(self, aim: Aim, rho: int) -> list[tuple[int, float]]:
        """The columns of an aim, with the factors by which their sum is minimised."""
        made = []
        for term, weight in aim.weights:
            if term == "robustness":
                made.append((rho, -weight))
                continue
            every = self.system.signals if term == "state_effort" else self.system.controls
            for name, factor in aim.efforts.get(term, dict.fromkeys(every, 1.0)).items():
                steps = range(len(self.columns[name]))
                made += [(self.size(((name, 1.0),), step), weight * factor) for step in steps]
        return made


@dataclass(frozen=True, eq=False)
class Pieces:
    """What an encoding is made from."""

    draft: Draft
    motion: Motion
    rho: int
    rows: Block = field(default_factory=lambda: Block("formula"))

    def switched(self, leaf: Leaf, z: int) -> None:
        """The row of a predicate that is switched off where a column is 0."""
        terms = self.motion.terms(leaf.atom.terms, leaf.step, leaf.factor)
        terms += [(0, self.rho, -1.0), (0, z, -BIG)]
        self.rows.add(*terms, lower=leaf.factor * leaf.atom.bound - BIG)

    def free(self, count: int) -> Ints:
        """Columns without bounds."""
        return self.draft.columns(count, -INFINITY)

    def beneath(self, z: int, others: Ints) -> None:
        """Rows by which one column is no more than each of others."""
        each = range(len(others))
        self.rows.add((each, others, 1.0), (each, z, -1.0), lower=np.zeros(len(others)))


def with_binaries(pieces: Pieces, tree: Tree, z: int) -> None:
    """A binary for every predicate, one number for every other place."""
    if isinstance(tree, Leaf):
        (binary,) = pieces.draft.columns(1, upper=1.0, integer=True)
        pieces.draft.sums((0, z, 1.0), (0, binary, -1.0), lower=0, upper=0, kind="binary")
        pieces.switched(tree, z)
        return
    below = pieces.free(len(tree.parts))
    if tree.any:
        pieces.rows.add((0, below, 1.0), (0, z, -1.0), lower=0.0)
    else:
        pieces.beneath(z, below)
    for part, own in zip(tree.parts, below, strict=True):
        with_binaries(pieces, part, int(own))


def with_digits(pieces: Pieces, tree: Tree, z: int) -> None:
    """Binary digits for every choice, in the order of the Gray code."""
    if isinstance(tree, Leaf):
        pieces.switched(tree, z)
        return
    if tree.any:
        below = _chosen(pieces, len(tree.parts), z)
    else:
        below = pieces.free(len(tree.parts))
        pieces.beneath(z, below)
    for part, own in zip(tree.parts, below, strict=True):
        with_digits(pieces, part, int(own))


def _chosen(pieces: Pieces, count: int, z: int) -> Ints:
    """Columns of which one is 1 and the others are 0 where z is 1; all are 0 where z is 0."""
    draft, rows = pieces.draft, pieces.rows
    shares = draft.columns(count + 1, upper=1.0)
    draft.sums((0, shares, 1.0), lower=1, upper=1, kind="one")
    draft.sums((0, [z, shares[0]], 1.0), lower=1, upper=1, kind="none")
    code = np.arange(count + 1) ^ (np.arange(count + 1) >> 1)
    for digit, column in enumerate(
        draft.columns(math.ceil(math.log2(count + 1)), 0, 1, integer=True)
    ):
        one = (code >> digit & 1).astype(bool)
        rows.add((0, column, 1.0), (0, shares[one], -1.0), lower=0.0)
        rows.add((0, column, -1.0), (0, shares[~one], -1.0), lower=-1.0)
    return shares[1:]


Place: TypeAlias = Callable[[Pieces, Tree, int], None]
"""How an encoding says that what a tree asks for holds where a column is 1."""

ENCODINGS: Mapping[str, Place] = MappingProxyType({"stlpy": with_binaries, "sos1": with_digits})


@dataclass(frozen=True, eq=False)
class Program:
    """An encoded mission, what is minimised in it one after the other, and its columns by name."""

    model: Model
    vectors: tuple[Floats, ...]
    columns: Mapping[str, Ints]

    @classmethod
    def of(cls, mission: SignalMission, motion: Motion, rho: int) -> Program:
        """The program of what has been drafted, with the aims of a mission."""
        sought = [motion.sought(aim, rho) for aim in mission.objective]
        model = motion.draft.build()
        vectors = []
        for terms in sought or [[]]:
            vectors.append(np.zeros(model.size.columns))
            for column, factor in terms:
                vectors[-1][column] += factor
        return cls(model, tuple(vectors), motion.columns)

    def trace(self, point: Floats) -> SignalTrace:
        """The signals at a point, and the controls, of which the last is held."""
        longest = max(len(columns) for columns in self.columns.values())
        return SignalTrace(
            {
                name: np.pad(point[columns], (0, longest - len(columns)), "edge")
                for name, columns in self.columns.items()
                if len(columns)
            }
        )

    def solved(
        self, solver: Solver, options: Options, watch: Watcher | None = None
    ) -> list[Solution]:
        """The end of each stage, up to the first that is not solved to its end."""
        model, found = self.model, []
        began = time.perf_counter()
        for vector in self.vectors:
            left = options.time_limit and options.time_limit - (time.perf_counter() - began)
            found.append(
                solver.solve(model.with_objective(vector), replace(options, time_limit=left), watch)
            )
            best = found[-1].objective
            if best is None or not claimed(found[-1]):
                break
            model = model.with_row(
                vector, -INFINITY, best + TOLERANCE * max(1.0, abs(best)), "kept"
            )
        return found


def encoded(mission: SignalMission, encoding: str) -> Program:
    """The program of a mission without weights that has to hold, by one of the ENCODINGS."""
    draft = Draft()
    motion = Motion(draft, mission.system, mission.horizon)
    rho, root = (int(draft.columns(1, low)[0]) for low in (0.0, 1.0))
    draft.sums((0, root, 1.0), lower=1, upper=1, kind="root")
    pieces = Pieces(draft, motion, rho)
    ENCODINGS[encoding](pieces, unrolled(positive(mission.formula)), root)
    pieces.rows.write(draft)
    return Program.of(mission, motion, rho)


def trajectory(
    mission: SignalMission, encoding: str, options: Options, watch: Watcher | None = None
) -> Trajectory:
    """What HiGHS makes of a mission by one of the ENCODINGS, with the values that it claims.

    What it calls optimal counts as proven, though its bound is off by its tolerance times the
    constant; as verified if the formula is as robust on the signals as is claimed, but for that.
    """
    program = encoded(mission, encoding)
    stages = program.solved(solver("highs"), options, watch)
    values = [
        _value(aim, stage)
        for aim, stage in zip(mission.objective, stages, strict=False)
        if stage.objective is not None
    ]
    points = [stage.values for stage in stages if stage.values is not None]
    size = program.model.size
    return Trajectory(
        _status(stages),
        MissionRef(mission.name, mission.digest),
        mission.horizon,
        None if claimed(stages[-1]) else stages[-1].stopped_by,
        tuple(values),
        size=ModelSize(size.columns, size.integers, size.rows, size.nonzeros),
        **(_found(mission, program, points[-1], values) if points else {}),
    )


def _found(
    mission: SignalMission, program: Program, point: Floats, values: Sequence[ObjectiveValue]
) -> dict[str, Any]:
    """The signals at a point, and how robust the formula is on them."""
    margin = float(robustness(mission.formula, program.trace(point))[0])
    said = next((item.value for item in values if item.name == "robustness"), None)
    rows = {name: tuple(point[columns].tolist()) for name, columns in program.columns.items()}
    return {
        "robustness": margin,
        "verified": margin >= (said or 0.0) - BIG * TOLERANCE,
        "signals": {name: rows[name] for name in mission.system.signals},
        "controls": {name: rows[name] for name in mission.system.controls},
    }


def claimed(stage: Solution) -> bool:
    """Whether the solver says that nothing is better, be its own bound short of that."""
    return stage.status is Status.OPTIMAL or stage.stopped_by is StoppedBy.PRECISION


def _status(stages: Sequence[Solution]) -> PlanStatus:
    """What is known of a mission after its stages."""
    if claimed(stages[-1]):
        return PlanStatus.OPTIMAL
    if any(stage.values is not None for stage in stages):
        return PlanStatus.FEASIBLE
    known = stages[-1].status is Status.INFEASIBLE
    return PlanStatus.INFEASIBLE if known else PlanStatus.NO_PLAN_FOUND


def _value(aim: Aim, stage: Solution) -> ObjectiveValue:
    """What a stage found and proved, in the aim's own sense."""
    sign = -1.0 if aim.rises else 1.0
    value, bound = (None if one is None else sign * one for one in (stage.objective, stage.bound))
    return ObjectiveValue(aim.name, value, bound)
