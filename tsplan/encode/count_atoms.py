"""Counting atoms as bounds on the number of agents in sets of states.

`sum` bounds the set of all states with the label; `min ... >=` and `max ... <=` bound each state on
its own (all of them must hold); `min ... <=` and `max ... >=` ask for one state (any of them).
"""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, field
from types import MappingProxyType

import numpy as np

from tsplan.encode.agent_classes import MapArrays
from tsplan.encode.atom_encoders import AtomEncoder, Atoms, Bound, Requirement, Site, Slack
from tsplan.encode.capability_mask import is_counted
from tsplan.encode.executions import ExecutionEncoder
from tsplan.encode.flow_network import Network
from tsplan.logic import Count, Execution, Formula, Known, walk
from tsplan.milp.model import Bools, Floats
from tsplan.mission import Resource
from tsplan.ts import TransitionSystem


@dataclass(frozen=True, eq=False)
class CountEncoder:
    """Reads counts tightened by `level`: availability at least `level`."""

    network: Network
    system: TransitionSystem
    arrays: MapArrays
    level: int = 0
    later: int = 0  # steps that agents may be later than the network says
    _most: dict[tuple[Site, str | None], Floats] = field(default_factory=dict)

    @property
    def grain(self) -> float:
        """Numbers of agents are whole, expected ones are not."""
        return 0.0 if self.network.expected else 1.0

    def requirement(self, atom: Count) -> Requirement:
        """The bounds an atom means."""
        upper = atom.relation == "<="
        if atom.relation not in (">=", "<=") or not isinstance(atom.bound, int):
            raise ValueError(f"'{atom}' is not in positive normal form")
        states = tuple(self.arrays.states_with(self.system, atom.label).tolist())
        sites = (states,) if atom.function == "sum" else tuple((state,) for state in states)
        amount = atom.bound - self.level if upper else atom.bound + self.level
        bounds = tuple(Bound(site, atom.capability, upper, amount) for site in sites)
        return Requirement(bounds, atom.function == "sum" or (atom.function == "max") == upper)

    def best(self, bound: Bound) -> Floats:
        """All agents that can have arrived are where a bound wants them, none where it does not."""
        if bound.upper:
            return np.full(self.network.horizon + 1, float(bound.amount))
        site = bound.states, bound.capability
        if site not in self._most:
            states = np.array(bound.states, dtype=np.int64)
            self._most[site] = self.network.best(states, bound.capability, later=self.later)
        return self._most[site] - bound.amount

    def worst(self, bound: Bound) -> None:
        """Nothing is known: agents may stay away from anywhere."""

    def slack(self, bound: Bound, step: int) -> Slack:
        """The agents there beyond a bound, or those that it leaves room for."""
        states = np.array(bound.states, dtype=np.int64)
        if bound.upper:
            at = np.array([step])
            _, columns, factors, present = self.network.possible_at(states, bound.capability, at)
            most = self.network.most(states, bound.capability, upper=True)[step]
            high = float(bound.amount - present)
            return Slack(columns, -factors, high, bound.amount - float(max(most, present)), high)
        columns, present = self.network.present(states, bound.capability, step)
        low = float(present - bound.amount)
        return Slack(columns, 1.0, low, low, low + self.network.agents(bound.capability))


@dataclass(frozen=True, eq=False)
class KnownEncoder:
    """Reads what is known of the past by its margin, of which `level` is wanted.

    It is as a bound on the agents at no state at all, of which there are none.
    """

    network: Network
    system: TransitionSystem
    arrays: MapArrays
    level: int = 0
    later: int = 0

    @property
    def grain(self) -> float:
        """Margins are whole, but what is compared with them may be an expected number."""
        return 0.0 if self.network.expected else 1.0

    def requirement(self, atom: Known) -> Requirement:
        """The bound an atom means."""
        return Requirement((Bound((), None, False, self.level - atom.margin),), every=True)

    def best(self, bound: Bound) -> Floats:
        """What is known to fail cannot hold, whatever may be hoped for of the rest."""
        margin = -float(bound.amount)
        return np.full(self.network.horizon + 1, margin if margin >= 0 else -np.inf)

    def worst(self, bound: Bound) -> Floats | None:
        """The same; where the availability is a column it must not be more than this."""
        return None if self.network.expected else self.best(bound)

    def slack(self, bound: Bound, _step: int) -> Slack:
        """The margin, without any column."""
        margin = -float(bound.amount)
        return Slack(np.empty(0, dtype=np.int64), 1.0, margin, margin, margin)


ENCODERS: Mapping[type[Formula], Callable[..., AtomEncoder]] = MappingProxyType(
    {Count: CountEncoder, Known: KnownEncoder}
)
"""The encoder of every class of atoms."""


def atoms_over(
    network: Network,
    system: TransitionSystem,
    arrays: MapArrays,
    level: int = 0,
    resources: Sequence[Resource] = (),
    *,
    later: int = 0,
) -> Atoms:
    """The encoders of all classes of atoms over the flows of a network.

    With `later` they tell what can hold at best where agents are later than they may be there.
    """
    made = {kind: make(network, system, arrays, level, later) for kind, make in ENCODERS.items()}
    made[Execution] = ExecutionEncoder(network, system, arrays, tuple(resources))
    return Atoms(made, network.horizon)


def watched_states(
    formula: Formula, ability: frozenset[str], system: TransitionSystem, arrays: MapArrays
) -> tuple[Bools, Bools]:
    """States at which a formula wants agents with these capabilities, and those where it limits."""
    wanted, limited = (np.zeros(len(arrays.names), dtype=np.bool_) for _ in range(2))
    for node in walk(formula):
        if isinstance(node, Count) and is_counted(node.capability, ability):
            states = arrays.states_with(system, node.label)
            (limited if node.relation == "<=" else wanted)[states] = True
    return wanted, limited
