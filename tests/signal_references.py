"""Two plain programs for missions over signals, slow and easy to believe.

Nothing in them is shared with the planner but formulas and arrays. Both take the formula in
positive normal form, on which robustness only grows with that of every part: so it is enough to say
that a value is no more than it should be, since the root's is wanted as great as can be.
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import NamedTuple

from scripts.signal_encodings import Motion, Program, claimed
from tsplan.logic import (
    Always,
    And,
    Constant,
    Eventually,
    Formula,
    Linear,
    Or,
    Release,
    SignalTrace,
    Until,
    positive,
    walk,
)
from tsplan.logic.traversal import fold_all
from tsplan.milp.model import INFINITY, Draft, Terms
from tsplan.milp.solution import Options
from tsplan.milp.solver import solver
from tsplan.signals.aims import Aim
from tsplan.signals.signal_mission import SignalMission

STRICT = 1e-5
"""By how much a strict predicate has to be beyond its bound, relative to what margins can be."""

CLOSE = 5e-3
"""Values this close count as equal: what STRICT makes of sums, and less than halves make."""

ROBUST = Aim((("robustness", 1.0),))

OPTIONS = Options(time_limit=60.0, threads=1)

Part = tuple[Formula, int]


def parts_of(node: Formula, step: int) -> list[list[Part]]:
    """What `or`, F and U hold by any of, and `and`, G and R by all of: lists of parts.

    In each list all parts must hold for the former, and one for the latter.
    """
    if isinstance(node, And | Or):
        return [[(child, step)] for child in node.children]
    if isinstance(node, Always | Eventually):
        return [[(node.child, step + k)] for k in range(node.low, node.high + 1)]
    assert isinstance(node, Until | Release)
    return [
        [(node.right, step + k), *((node.left, step + j) for j in range(k))]
        for k in range(node.low, node.high + 1)
    ]


def wants_all(node: Formula) -> bool:
    """Whether all lists of parts must hold, rather than one."""
    return isinstance(node, And | Always | Release)


def largest(mission: SignalMission, formula: Formula) -> float:
    """No predicate has a margin beyond this."""
    ends = {**mission.system.signals, **mission.system.controls}
    sizes = [
        sum(abs(by) * max(map(abs, ends[name])) for name, by in atom.terms) + abs(atom.bound)
        for atom in walk(formula)
        if isinstance(atom, Linear)
    ]
    return max(sizes, default=0.0) + 1.0


class Answer(NamedTuple):
    """What a program ends with: the value of every objective that it came to, and signals."""

    values: tuple[float, ...]
    trace: SignalTrace | None


def answer(program: Program) -> Answer:
    stages = program.solved(solver("highs"), OPTIONS)
    found = [stage for stage in stages if stage.objective is not None]
    assert len(found) in (0, len(stages))
    assert not found or claimed(found[-1])
    trace = program.trace(found[-1].values) if found else None
    return Answer(tuple(stage.objective for stage in found), trace)


class _Reference:
    """A column for every sub-formula and step.

    A strict predicate has to be beyond its bound by `strict`, relative to what margins can be.
    """

    def __init__(self, mission: SignalMission, strict: float) -> None:
        self.mission = mission
        self.strict = strict
        self.formula = positive(mission.formula)
        self.most = largest(mission, self.formula)
        self.draft = Draft()
        self.motion = Motion(self.draft, mission.system, mission.horizon)
        self.known: dict[Part, int] = {}

    def column(self, low: float, high: float, *, integer: bool = False) -> int:
        return int(self.draft.columns(1, low, high, integer=integer)[0])

    def row(
        self, *terms: tuple[int, float], low: float = -INFINITY, high: float = INFINITY
    ) -> None:
        entries: list[Terms] = [(0, column, by) for column, by in terms]
        self.draft.sums(*entries, lower=low, upper=high, kind="reference")

    def margin(self, atom: Linear, step: int) -> tuple[list[tuple[int, float]], float]:
        """The margin of a predicate at a step: terms, less a number."""
        sign = 1.0 if atom.relation in (">=", ">") else -1.0
        terms = self.motion.terms(atom.terms, step, sign)
        beyond = self.strict * self.most if atom.relation in (">", "<") else 0.0
        return [(int(column), float(by)) for _, column, by in terms], sign * atom.bound + beyond


class TwoSided(_Reference):
    """A binary for every sub-formula and step: 1 if its robustness is at least rho, else 0.

    That of the root is 1, and rho is at least `least`.
    """

    def __init__(self, mission: SignalMission, least: float = 0.0, strict: float = STRICT) -> None:
        super().__init__(mission, strict)
        self.rho = self.column(least, self.most)
        self.row((self.binary((self.formula, 0)), 1.0), low=1.0)
        self.program = Program.of(mission, self.motion, self.rho)

    def binary(self, part: Part) -> int:
        if part not in self.known:
            node, step = part
            if isinstance(node, Constant):
                made = self.column(node.value, node.value, integer=True)
            elif isinstance(node, Linear):
                made = self.predicate(node, step)
            else:
                every = wants_all(node)
                inner = [
                    self.joined([self.binary(part) for part in parts], every=not every)
                    for parts in parts_of(node, step)
                ]
                made = self.joined(inner, every=every)
            self.known[part] = made
        return self.known[part]

    def predicate(self, atom: Linear, step: int) -> int:
        z, big = self.column(0, 1, integer=True), 2 * self.most
        terms, bound = self.margin(atom, step)
        self.row(*terms, (self.rho, -1.0), (z, -big), low=bound - big)  # z is 1: at least rho
        self.row(*terms, (self.rho, -1.0), (z, -big), high=bound)  # z is 0: at most rho
        return z

    def joined(self, inner: Sequence[int], *, every: bool) -> int:
        if len(inner) == 1:
            return inner[0]
        z = self.column(0, 1, integer=True)
        for other in inner:
            sign = 1.0 if every else -1.0
            self.row((other, sign), (z, -sign), low=0.0)
        rest = [(other, -1.0) for other in inner]
        if every:
            self.row((z, 1.0), *rest, low=1.0 - len(inner))
        else:
            self.row((z, 1.0), *rest, high=0.0)
        return z


class PerNode(_Reference):
    """A column for the weighted robustness of every sub-formula and step, the root's at least that.

    A part that is multiplied by its sign has a binary for the sign, the greatest of some parts one
    for which of them it is.
    """

    def __init__(self, mission: SignalMission, least: float = 0.0, strict: float = STRICT) -> None:
        super().__init__(mission, strict)
        sizes = fold_all(self.formula, self.size)
        self.big = max(sizes.values())  # all values are between -big and big
        root = self.value((self.formula, 0))
        self.row((root, 1.0), low=least)
        self.program = Program.of(mission, self.motion, root)

    def size(self, node: Formula, below: tuple[float, ...]) -> float:
        if not below:
            return self.most
        return max(below) * max(1.0, *(max(pair) for pair in self.factors(node)))

    def factors(self, node: Formula) -> list[tuple[float, float]]:
        """By what the first of each list of parts is multiplied if it is satisfied, and if not."""
        weights = getattr(node, "weights", None)
        if weights is None:
            return [(1.0, 1.0)] * len(parts_of(node, 0))
        if self.mission.weighting == "product":
            return [(by, by) for by in weights]
        if len(weights) == 1:
            return [(0.5, 0.5)]
        shares = [by / sum(weights) for by in weights]
        return [(1 - by, by) if wants_all(node) else (by, 1 - by) for by in shares]

    def value(self, part: Part) -> int:
        if part not in self.known:
            node, step = part
            if isinstance(node, Constant):
                made = self.column(*[self.big if node.value else -self.big] * 2)
            elif isinstance(node, Linear):
                terms, bound = self.margin(node, step)
                made = self.column(-self.big, self.big)
                self.row((made, -1.0), *terms, low=bound, high=bound)
            else:
                made = self.chosen(node, step)
            self.known[part] = made
        return self.known[part]

    def chosen(self, node: Formula, step: int) -> int:
        every = wants_all(node)
        inner = []
        for (first, *rest), factors in zip(parts_of(node, step), self.factors(node), strict=True):
            values = [self.scaled(self.value(first), *factors), *map(self.value, rest)]
            inner.append(self.greatest(values) if every else self.least(values))
        return self.least(inner) if every else self.greatest(inner)

    def scaled(self, part: int, above: float, below: float) -> int:
        """At most `above` times a part that is at least 0, `below` times one that is at most 0."""
        if above == below == 1.0:
            return part
        made = self.column(-self.big, self.big)
        if above <= below:  # the lesser of the two products, whatever the sign
            self.row((made, 1.0), (part, -above), high=0.0)
            self.row((made, 1.0), (part, -below), high=0.0)
            return made
        sign, big = self.column(0, 1, integer=True), self.big
        self.row((part, 1.0), (sign, -big), low=-big, high=0.0)
        self.row((made, 1.0), (part, -above), (sign, 2 * big), high=2 * big)
        self.row((made, 1.0), (part, -below), (sign, -2 * big), high=0.0)
        return made

    def least(self, parts: Sequence[int]) -> int:
        if len(parts) == 1:
            return parts[0]
        made = self.column(-self.big, self.big)
        for part in parts:
            self.row((made, 1.0), (part, -1.0), high=0.0)
        return made

    def greatest(self, parts: Sequence[int]) -> int:
        if len(parts) == 1:
            return parts[0]
        made, big = self.column(-self.big, self.big), self.big
        which = [self.column(0, 1, integer=True) for _ in parts]
        self.row(*((one, 1.0) for one in which), low=1.0, high=1.0)
        for part, one in zip(parts, which, strict=True):
            self.row((made, 1.0), (part, -1.0), (one, 2 * big), high=2 * big)
        return made
