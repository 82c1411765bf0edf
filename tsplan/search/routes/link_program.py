"""The least cost of all agents where every errand has a step at which it begins.

Then it is known which links can be made (`search.routes.links`), and what is left is a small
program: who goes on from an errand has come to it, and as many come as are needed. It has a row
for every errand of a class instead of one for every state at every step, so it is solved in a
thousandth of a second. Its flows are those of a plan in which nobody is relieved.
"""

from __future__ import annotations

from dataclasses import dataclass
from functools import cached_property

import numpy as np

from tsplan.encode.flow_network import Network
from tsplan.milp.model import INFINITY, Bools, Draft, Floats, Ints, Model
from tsplan.search.routes.errands import Errand
from tsplan.search.routes.links import Links

_LITTLE = 1e-6


@dataclass(frozen=True, eq=False)
class LinkProgram:
    """The program of some links; what is lacking at errands costs more than any two links."""

    network: Network
    errands: tuple[Errand, ...]
    links: Links

    @cached_property
    def model(self) -> Model:
        """A column for each link, and one for what is lacking of each errand."""
        links, count = self.links, len(self.links.group)
        draft = Draft()
        draft.columns(count, integer=True)
        lacking = draft.columns(len(self.errands), integer=True)
        every, number = np.arange(count), len(self.errands)
        come = links.group * number + links.target
        gone = np.flatnonzero(links.source < number)
        left = links.group[gone] * number + links.source[gone]
        passed, row = np.unique(np.concatenate([come, left]), return_inverse=True)
        draft.sums(
            (row[:count], every, 1.0),
            (row[count:], gone, -1.0),
            lower=np.zeros(len(passed)),
            kind="who goes on has come",
        )
        draft.sums(
            (links.target, every, 1.0),
            (np.arange(number), lacking, 1.0),
            lower=np.array([float(each.amount) for each in self.errands]),
            kind="errands",
        )
        begun = np.flatnonzero(links.source >= number)
        draft.sums(
            (links.source[begun] - number, begun, 1.0),
            lower=-INFINITY,
            upper=np.array([float(agents) for _, _, agents in links.starts]),
            kind="starts",
        )
        dear = 2.0 * float(links.price.max(initial=0)) + 1.0
        price = np.append(links.price.astype(np.float64), np.full(number, dear))
        return draft.build().with_objective(price)

    def open(self, begins: Ints) -> Bools:
        """Which columns may be used where stays begin at these steps."""
        return np.append(self.links.able(begins), np.ones(len(self.errands), dtype=np.bool_))

    def held(self, begins: Ints) -> Model:
        """The model of plans in which stays begin at these steps."""
        upper = np.where(self.links.able(begins), INFINITY, 0.0)
        upper = np.append(upper, np.zeros(len(self.errands)))
        return self.model.with_bounds(self.model.lower, upper)

    def whole(self, values: Floats) -> bool:
        """Whether values of the columns are whole agents of whom none is lacking."""
        lacking = values[len(self.links.group) :]
        return bool(np.abs(values - np.round(values)).max() < _LITTLE and not lacking.round().any())

    # --- flows -----------------------------------------------------------------------------------

    def flows(self, values: Floats, begins: Ints, count: int) -> Floats | None:
        """So many columns of the network in which agents make links, and stay where they end.

        All leave an errand as soon as it is over. None where a move is not possible at its step.
        """
        found = np.zeros(count)
        used = np.round(values[: len(self.links.group)])
        shape = self.network.horizon + 1
        for group, item in enumerate(self.network.classes):
            change = np.zeros((len(item.graph.start), shape))
            change[:, 0] += item.graph.start
            for link in np.flatnonzero((self.links.group == group) & (used > 0)).tolist():
                if not self._moved(link, float(used[link]), begins, found, change):
                    return None
            if not self._stood(group, np.cumsum(change, axis=1), found):
                return None
        return found

    def _moved(self, link: int, agents: float, begins: Ints, found: Floats, change: Floats) -> bool:
        """Let agents make a link: those who stand are others at steps that `change`."""
        links, group = self.links, int(self.links.group[link])
        item, source = self.network.classes[group], int(links.source[link])
        node = int(self.errands[links.target[link]].states[0])
        begun = source >= len(self.errands)
        if begun:
            origin, step = links.starts[source - len(self.errands)][1], 0
        else:
            errand = self.errands[source]
            origin, step = int(errand.states[0]), int(begins[source]) + errand.stay - 1
        if origin == node:
            return True
        change[origin, step] -= agents
        for edge in links.ways[group][links.way[link]].path(item.graph.tail, origin, node):
            if not item.first[edge] <= step <= item.last[edge]:
                return False
            found[item.offset[edge] + step - item.first[edge]] += agents
            step += int(item.graph.duration[edge])
        change[node, step] += agents
        return True

    def _stood(self, group: int, standing: Floats, found: Floats) -> bool:
        """Let those stand who do at each node and step."""
        item = self.network.classes[group]
        wait = np.full(len(item.graph.start), -1)
        waits = np.flatnonzero(item.graph.wait & (item.graph.duration == 1))
        wait[item.graph.tail[waits]] = waits
        nodes, steps = np.nonzero(standing[:, :-1])
        edges = wait[nodes]
        in_time = (item.first[edges] <= steps) & (steps <= item.last[edges])
        if (standing < 0).any() or (edges < 0).any() or not in_time.all():
            return False
        found[item.offset[edges] + steps - item.first[edges]] += standing[nodes, steps]
        return True
