"""What could hold at best: an optimistic robustness of every sub-formula at every step.

Each atom is judged on its own. The result bounds the true availability from above, so a sub-formula
whose bound is below the wanted level cannot hold and needs no columns; the root's bounds the
mission's availability.
"""

from __future__ import annotations

import numpy as np

from tsplan.encode.atom_encoders import Atoms
from tsplan.encode.step_runs import union
from tsplan.logic import And, Formula, walk
from tsplan.logic.evaluation import Reading, value
from tsplan.logic.traces import CountTrace
from tsplan.milp.model import Floats, Ints


class OptimisticBound:
    """Optimistic robustness of the nodes of one formula; nothing is ruled out by a trusting one."""

    def __init__(self, root: Formula, atoms: Atoms, *, trusting: bool = False) -> None:
        self.atoms = atoms
        self._trusting = trusting
        self._impossible: dict[Formula, Ints] = {}
        self._values: dict[Formula, Floats] = {}
        true = np.full(atoms.horizon + 1, np.inf)
        trace = CountTrace(
            {None: true.reshape(1, -1)}, {}
        )  # of no places: atoms are not read there
        reading = Reading(trace, true, -true, {}, np.negative)
        certain: dict[Formula, Floats] = {}
        for values, read in ((self._values, atoms.best), (certain, atoms.worst)):
            for node in walk(root):
                if node in atoms:
                    values[node] = read(node)
                    continue
                past = np.full(getattr(node, "high", 0), -np.inf)  # past the end nothing holds
                below = [np.concatenate([values[child], past]) for child in node.children]
                values[node] = value(node, tuple(below), reading)
                if isinstance(node, And) and atoms.joint is not None:
                    values[node] = np.minimum(values[node], atoms.joint(node, atoms))
        self._open = {n: np.flatnonzero(v < 0) for n, v in certain.items() if (v >= 0).any()}

    def best(self, node: Formula, step: int) -> float:
        """Upper bound on the robustness of `node` at `step`, relative to the wanted level."""
        return float(self._values[node][step])

    def possible(self, node: Formula, step: int) -> bool:
        """False only if `node` can hold at `step` in no plan; if trusting, only if it is false."""
        best = self.best(node, step)
        return best > -np.inf if self._trusting else best >= 0

    def possible_throughout(self, node: Formula, first: int, last: int) -> bool:
        """Whether `possible` at all of the steps `first .. last`."""
        return self.first_impossible(node, first) > last

    def uncertain(self, node: Formula, first: int, last: int) -> list[tuple[int, int]]:
        """The runs of steps in `first .. last` at which it is not sure that `node` holds."""
        if node not in self._open:
            return [(first, last)]
        steps = self._open[node]
        within = steps[np.searchsorted(steps, first) : np.searchsorted(steps, last, side="right")]
        return union((step, step) for step in within.tolist())

    def first_impossible(self, node: Formula, step: int) -> int:
        """The first step from `step` on at which `node` is not `possible`; past the end if none."""
        if node not in self._impossible:
            values = self._values[node]
            never = values == -np.inf if self._trusting else values < 0
            self._impossible[node] = np.flatnonzero(never)
        steps = self._impossible[node]
        place = int(np.searchsorted(steps, step))
        return int(steps[place]) if place < len(steps) else self.atoms.horizon + 1

    def within_reach(self, best: Floats, step: int) -> bool:
        """False only if a bound that is this at best can hold at `step` in no plan."""
        return self._trusting or bool(best[step] >= 0)
