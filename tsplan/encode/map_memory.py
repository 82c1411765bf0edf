"""What is worked out of a map and kept for the next problem on it."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from functools import lru_cache, wraps
from typing import Any, Concatenate, ParamSpec, TypeVar

from tsplan.ts import TransitionSystem

_Others = ParamSpec("_Others")
_Made = TypeVar("_Made")
_Function = Callable[Concatenate[TransitionSystem, _Others], _Made]


@dataclass(frozen=True, eq=False)
class _InOrder:
    """A map that is another one where its states and edges come in another order.

    Maps are equal in any order; arrays of them are not.
    """

    system: TransitionSystem

    def __eq__(self, other: object) -> bool:
        if not isinstance(other, _InOrder):
            return NotImplemented
        mine, theirs = self.system, other.system
        return mine is theirs or (_order(mine) == _order(theirs) and mine == theirs)

    def __hash__(self) -> int:
        return hash(self.system)


def _order(system: TransitionSystem) -> tuple[list[Any], ...]:
    return list(system.states), list(system.edges), list(system.zones)


def kept(most: int) -> Callable[[_Function[_Others, _Made]], _Function[_Others, _Made]]:
    """A function of a map, and perhaps of more, whose last results are kept.

    >>> from tsplan.ts import Edge, State
    >>> states, edges = [State("p"), State("q")], [Edge("p", "q"), Edge("q", "p")]
    >>> one = TransitionSystem.build(states, edges)
    >>> other = TransitionSystem.build(states, edges[::-1])
    >>> ends = kept(4)(lambda system: [edge.target for edge in system.edges.values()])
    >>> one == other, ends(one), ends(other), ends(one) is ends(one)
    (True, ['q', 'p'], ['p', 'q'], True)
    """

    def keeping(make: _Function[_Others, _Made]) -> _Function[_Others, _Made]:
        def of_key(key: _InOrder, *others: _Others.args, **named: _Others.kwargs) -> _Made:
            return make(key.system, *others, **named)

        memory: Any = lru_cache(most)(of_key)

        @wraps(make)
        def found(
            system: TransitionSystem, /, *others: _Others.args, **named: _Others.kwargs
        ) -> _Made:
            made: _Made = memory(_InOrder(system), *others, **named)
            return made

        return found

    return keeping
