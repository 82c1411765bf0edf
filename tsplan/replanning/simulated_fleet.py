"""Robots and structures that are late, get lost and find doors closed at random."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field
from hashlib import blake2b
from typing import TYPE_CHECKING

from tsplan.plans.worlds import Closed, OnEdge
from tsplan.replanning.robot_fleet import Assembly, MoveOrder, Order, RebuildOrder, Seen, Sighting

if TYPE_CHECKING:
    from tsplan.mission import Mission

_BYTES = 8
_LONGEST = 1000  # steps that one move is late at most, so that a chance of 1 ends, too


@dataclass(frozen=True, slots=True)
class Chances:
    """How likely is what may happen.

    Every move, and whatever is rebuilt, takes a step longer with the chance `delay`, and again and
    again. At every step each agent gets lost with the chance `loss`, and with the chance `close`
    one of the map's edges closes for good, in both directions. With a module its structure is lost.
    """

    delay: float = 0.0
    loss: float = 0.0
    close: float = 0.0


@dataclass(eq=False)
class SimulatedFleet:
    """A fleet by chance. What happens to whom when depends on the seed alone, not on the orders.

    So plans can be compared with the same luck.
    """

    mission: Mission
    chances: Chances
    seed: int
    _places: dict[str, str | OnEdge] = field(default_factory=dict, init=False)
    _shut: set[tuple[str, str]] = field(default_factory=set, init=False)
    _modules: dict[str, tuple[str, ...]] = field(default_factory=dict, init=False)

    def begin(
        self, step: int, places: Mapping[str, str | OnEdge], built: Sequence[Assembly] = ()
    ) -> None:
        """Put everybody to its place."""
        self._places = dict(places)
        self._modules = {each.structure: each.modules for each in built}

    def advance(self, step: int, orders: Sequence[Order]) -> Seen:
        """Carry out orders as far as edges are open."""
        for order in orders:
            if isinstance(order, RebuildOrder):
                self._rebuild(order, step)
            else:
                self._set_out(order, step)
        closed = self._closed(step + 1)
        seen: dict[str, Sighting] = {}
        for name, place in list(self._places.items()):
            if any(self._chance("loss", n, step) < self.chances.loss for n in self._who(name)):
                del self._places[name]
                seen[name] = None
            elif isinstance(place, str):
                seen[name] = place
            elif place.arrives <= step + 1:
                self._places[name] = seen[name] = place.target
            else:
                seen[name] = (place.source, place.target)
        return Seen(step + 1, seen, closed)

    def end(self) -> None:
        """Nothing is left to be done."""

    def _set_out(self, order: MoveOrder, step: int) -> None:
        name, source, target, arrives = order
        if self._places.get(name) == source and (source, target) not in self._shut:
            self._places[name] = OnEdge(source, target, arrives + self._late(name, step))

    def _rebuild(self, order: RebuildOrder, step: int) -> None:
        done = order.done + max(self._late(name, step) for name in order.parts)
        for name in order.parts:
            del self._places[name]
        for name, _, modules in order.made:
            self._modules[name] = modules
            self._places[name] = OnEdge(order.state, order.state, done)

    def _who(self, name: str) -> tuple[str, ...]:
        """The modules of a structure, or the robot itself: luck does not depend on structures."""
        return self._modules.get(name, (name,))

    def _late(self, name: str, step: int) -> int:
        name = min(self._who(name))
        steps = 0
        while steps < _LONGEST and self._chance("delay", name, step, steps) < self.chances.delay:
            steps += 1
        return steps

    def _closed(self, step: int) -> tuple[Closed, ...]:
        """The edge, both ways, that closes now."""
        if self._chance("close", step) >= self.chances.close:
            return ()
        pairs = [pair for pair, edge in self.mission.system.edges.items() if not edge.is_wait]
        if not pairs:
            return ()
        pair = pairs[int(self._chance("which", step) * len(pairs))]
        both = [ends for ends in (pair, pair[::-1]) if ends in self.mission.system.edges]
        new = [ends for ends in both if ends not in self._shut]
        self._shut.update(new)
        return tuple(Closed((source, target)) for source, target in new)

    def _chance(self, *of: object) -> float:
        """A number from 0 to below 1 for something that may happen."""
        digest = blake2b(repr((self.seed, *of)).encode(), digest_size=_BYTES).digest()
        return float(int.from_bytes(digest, "big") / 256**_BYTES)
