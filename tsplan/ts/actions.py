"""Actions whose outcome is a matter of chance: what makes a map a Markov decision process.

An agent at a state takes one of the state's actions; where it arrives is drawn by the action's
probabilities, independently of everything else. The edges of such a map follow from its actions:
one leads wherever some action may lead.
"""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass
from fractions import Fraction
from typing import Any, TypeAlias

from tsplan.errors import Finding, Nearest
from tsplan.exact import digits, exact
from tsplan.limits import MOST_COST, MOST_STEPS, is_number
from tsplan.ts.edges import Edge, State
from tsplan.words import nfc

ActionKey: TypeAlias = tuple[str, str]
"""A state and the name of one of its actions."""

WAIT = "wait"
"""The name of the actions that are added where agents may wait."""

ROUNDING = Fraction(1, 10**9)
"""By which probabilities may miss 1 in all: thirds have no end as decimal numbers."""


@dataclass(frozen=True)
class Action:
    """What an agent at `state` may do, and how likely it then arrives where.

    Taken at step k, it ends at step k + duration, wherever it leads. `cost` is per use; without
    one, it costs its duration, and nothing where the agent stays for sure.

    >>> slide = Action("ice", "go", {"shore": 0.75, "ice": 0.25})
    >>> slide.outcomes, slide.is_wait, slide.price
    ((('shore', 0.75), ('ice', 0.25)), False, 1.0)
    """

    state: str
    name: str
    outcomes: tuple[tuple[str, float], ...]
    duration: int = 1
    cost: float | None = None

    def __post_init__(self) -> None:
        """Bring names into the form in which they are compared; outcomes may be a mapping."""
        given: Any = self.outcomes
        pairs = given.items() if isinstance(given, Mapping) else given
        outcomes = tuple((_spelled(state), chance) for state, chance in pairs)
        object.__setattr__(self, "state", _spelled(self.state))
        object.__setattr__(self, "name", _spelled(self.name))
        object.__setattr__(self, "outcomes", outcomes)

    @property
    def key(self) -> ActionKey:
        """The state and the name, by which a map finds the action."""
        return self.state, self.name

    @property
    def possible(self) -> tuple[tuple[str, float], ...]:
        """The outcomes that can come about."""
        return tuple(pair for pair in self.outcomes if pair[1] > 0)

    @property
    def is_wait(self) -> bool:
        """Whether the agent is sure to be where it was afterwards."""
        return all(state == self.state for state, _ in self.possible)

    @property
    def aim(self) -> str:
        """The likeliest state that is another one; its own where there is none."""
        others = [pair for pair in self.possible if pair[0] != self.state]
        return max(others, key=lambda pair: pair[1])[0] if others else self.state

    @property
    def edge(self) -> Edge:
        """The action as an edge to its `aim`, which stands for it where edges are told of."""
        return Edge(self.state, self.aim, self.duration, self.price)

    @property
    def price(self) -> float:
        """The cost of one use."""
        if self.cost is not None:
            return self.cost
        return 0.0 if self.is_wait else float(self.duration)


@dataclass(frozen=True, slots=True)
class ActionFlaw:
    """One thing wrong with an action; `path` leads to it from the action's entry."""

    action: Action
    path: tuple[str, ...]
    message: str
    remedy: str

    def finding(self) -> Finding:
        """The flaw without a place, as for maps built in Python."""
        return Finding(self.message, self.remedy)


def edges_of(actions: Iterable[Action]) -> Iterator[Edge]:
    """An edge for every pair of states that some action may lead between, as quick as that is."""
    quickest: dict[tuple[str, str], int] = {}
    for action in actions:
        for target, _ in action.possible:
            pair = action.state, target
            quickest[pair] = min(action.duration, quickest.get(pair, action.duration))
    for (source, target), duration in quickest.items():
        yield Edge(source, target, duration)


def missing_stays(states: Iterable[State], actions: Iterable[Action]) -> list[Action]:
    """An action of waiting for every state at which none lets an agent stay for sure."""
    waiting = {action.state for action in actions if action.is_wait}
    names = [state.name for state in states if state.name not in waiting]
    return [Action(name, WAIT, ((name, 1.0),)) for name in names]


def action_flaws(states: Sequence[State], actions: Sequence[Action]) -> Iterator[ActionFlaw]:
    """Everything that keeps actions from being those of a map with these states."""
    names = [str(state.name) for state in states]
    closest, known = Nearest(names), frozenset(names)
    times = Counter(action.key for action in actions)
    for action in actions:
        if action.state not in known:
            message = f"no state is called '{action.state}'"
            yield ActionFlaw(action, (), message, closest(str(action.state)))
        for path, message, remedy in _flaws(action, known, closest):
            yield ActionFlaw(action, path, message, remedy)
        if times[action.key] > 1:
            message = f"'{action.state}' has two actions called '{action.name}'"
            yield ActionFlaw(action, (), message, "rename one")
            times[action.key] = 0
    idle = known - {action.state for action in actions}
    for action in actions:
        for state, _ in action.possible:
            if state in idle:
                message = f"'{action.name}' may lead to '{state}', which has no action"
                remedy = f"give it one, such as {state}: {{{WAIT}: {{{state}: 1}}}}"
                yield ActionFlaw(action, (state,), message, remedy)
                idle -= {state}


def _flaws(
    action: Action, known: frozenset[str], closest: Nearest
) -> Iterator[tuple[tuple[str, ...], str, str]]:
    where = f"'{action.name}' at '{action.state}'"
    if not isinstance(action.name, str) or not action.name:
        yield (), f"{action.name!r} is no name of an action", "use text of at least one character"
    chances = [chance for _, chance in action.outcomes]
    for state, chance in action.outcomes:
        if state not in known:
            yield (state,), f"{where} leads to '{state}', which is no state", closest(str(state))
        if not is_number(chance) or not 0 <= chance <= 1:
            message = f"{where} leads to '{state}' with {chance}, which is no probability"
            yield (state,), message, "write a number from 0 to 1"
    if all(is_number(chance) and 0 <= chance <= 1 for chance in chances):
        total = sum(map(exact, chances), Fraction(0))
        if abs(total - 1) > ROUNDING:
            message = f"the probabilities of {where} add up to {digits(total)}"
            yield (), message, "they must add up to 1: name every outcome"
    if len({state for state, _ in action.outcomes}) < len(chances):
        yield (), f"{where} names an outcome twice", "add the probabilities up"
    if type(action.duration) is not int or not 1 <= action.duration <= MOST_STEPS:
        message = f"{where} takes {action.duration} steps"
        yield ("duration",), message, f"durations are whole numbers from 1 to {MOST_STEPS:,}"
    cost: Any = action.cost
    if cost is not None and (not is_number(cost) or not 0 <= cost < MOST_COST):
        message = f"{where} costs {cost}"
        yield ("cost",), message, "write a number of at least 0, such as 2.5"


def _spelled(name: Any) -> Any:
    return nfc(name) if isinstance(name, str) else name
