"""Ways to change a formula step by step, each making it weaker the further it goes."""

from __future__ import annotations

from dataclasses import dataclass, replace
from fractions import Fraction
from math import ceil
from typing import TYPE_CHECKING, Protocol

from tsplan.explanation.agent_numbers import agents
from tsplan.explanation.whynot.occurrences import Leaf, exchanged, node_at
from tsplan.logic import (
    Count,
    Eventually,
    Formula,
    Limit,
    Percent,
    Task,
    Until,
    horizon,
    translate,
)

if TYPE_CHECKING:
    from tsplan.explanation.explanation import ChangeKind
    from tsplan.mission import Mission

MOST_STEPS = 60
"""Steps by which a deadline of a short mission is extended at most."""


class Dimension(Protocol):
    """One way to change a mission, by 1, 2, ... up to `most`."""

    @property
    def kind(self) -> ChangeKind:
        """What is changed."""
        ...

    @property
    def most(self) -> int:
        """The largest change that makes sense."""
        ...

    def applied(self, mission: Mission, amount: int) -> Mission:
        """The mission after the change; MissionError where it would not fit together."""
        ...

    def words(self, mission: Mission, amount: int) -> str:
        """The change in words."""
        ...


def edited(mission: Mission, leaf: Leaf, node: Formula) -> Mission:
    """The mission with another node in its formula, its horizon extended where that needs it."""
    formula = exchanged(mission.formula, {leaf.way: node})
    own = horizon(translate(formula, interval=mission.task_interval))
    longest = max(mission.horizon, own)
    return replace(mission, formula=formula, text=str(formula), horizon=longest, warnings=())


@dataclass(frozen=True)
class Deadline:
    """A later end of the window of an `F` or `U`; `was` is the requirement it belongs to."""

    leaf: Leaf
    was: str
    most: int
    kind: ChangeKind = "extend_deadline"

    @classmethod
    def of(cls, mission: Mission, leaf: Leaf, was: str) -> Deadline | None:
        """The deadline of a node; None where it has none."""
        node = node_at(mission.formula, leaf.way)
        if not isinstance(node, Eventually | Until):
            return None
        return cls(Leaf(leaf.way), was, max(mission.horizon, MOST_STEPS))

    def applied(self, mission: Mission, amount: int) -> Mission:
        """The mission with the later deadline."""
        node = self._node(mission)
        return edited(mission, self.leaf, replace(node, high=node.high + amount))

    def words(self, mission: Mission, amount: int) -> str:
        """The deadline, from when to when."""
        end = self._node(mission).high
        late = f"{amount} step{'s' if amount > 1 else ''} later"
        return f"extend the deadline {end} to {end + amount} ({late}) in {self.was}"

    def _node(self, mission: Mission) -> Eventually | Until:
        node = node_at(mission.formula, self.leaf.way)
        assert isinstance(node, Eventually | Until)
        return node


@dataclass(frozen=True)
class Duration:
    """A task that lasts less long."""

    leaf: Leaf
    was: str
    most: int
    kind: ChangeKind = "shorten_task"

    @classmethod
    def of(cls, mission: Mission, leaf: Leaf, was: str) -> Duration | None:
        """The duration of a node; None where it has none that can be shortened."""
        node = node_at(mission.formula, leaf.way)
        least = int(mission.task_interval == "half-open")
        if not isinstance(node, Task) or node.duration <= least:
            return None
        return cls(Leaf(leaf.way), was, node.duration - least)

    def applied(self, mission: Mission, amount: int) -> Mission:
        """The mission with the shorter task."""
        node = self._node(mission)
        return edited(mission, self.leaf, replace(node, duration=node.duration - amount))

    def words(self, mission: Mission, amount: int) -> str:
        """The duration, from what to what."""
        now = self._node(mission).duration
        return f"shorten the task from {now} to {now - amount} steps in {self.was}"

    def _node(self, mission: Mission) -> Task:
        node = node_at(mission.formula, self.leaf.way)
        assert isinstance(node, Task)
        return node


@dataclass(frozen=True)
class LowerNeed:
    """Fewer agents asked for by a task's need or a count; of a percentage, fewer hundredths."""

    leaf: Leaf
    was: str
    most: int
    kind: ChangeKind = "lower_need"

    @classmethod
    def of(cls, mission: Mission, leaf: Leaf, was: str) -> LowerNeed | None:
        """The number that a leaf asks for; None where it asks for nobody."""
        node = node_at(mission.formula, leaf.way)
        if isinstance(node, Task):
            asked = node.needs[leaf.pair or 0][1]
        elif isinstance(node, Count) and node.relation in _ASKING and isinstance(node.bound, int):
            asked = node.bound + _ASKING[node.relation]
        elif isinstance(node, Count) and node.relation in _ASKING and _shares(node):
            asked = ceil(_share(node))
        else:
            return None
        return cls(leaf, was, asked) if asked > 0 else None

    def applied(self, mission: Mission, amount: int) -> Mission:
        """The mission that asks for fewer agents."""
        return edited(mission, self.leaf, _counting(mission, self.leaf, -amount))

    def words(self, mission: Mission, amount: int) -> str:
        """The need, from what to what."""
        label, who = _subject(mission, self.leaf)
        if amount == self.most:
            return f"ask for no {who or 'agents'} at '{label}' in {self.was}"
        now, less = str(self.most), agents(self.most - amount, who)
        share = node_at(mission.formula, self.leaf.way)
        if isinstance(share, Count) and _shares(share):
            now, less = str(share.bound), str(_moved(share.bound, -amount))
        return f"lower the need at '{label}' from {now} to {less} in {self.was}"


@dataclass(frozen=True)
class LooserLimit:
    """More agents allowed by a limit or a count; of a percentage, more hundredths."""

    leaf: Leaf
    was: str
    now: int
    most: int
    kind: ChangeKind = "loosen_limit"

    @classmethod
    def of(cls, mission: Mission, leaf: Leaf, was: str) -> LooserLimit | None:
        """The number that a leaf allows; None where it limits nothing."""
        node = node_at(mission.formula, leaf.way)
        if isinstance(node, Limit):
            allowed = node.needs[leaf.pair or 0][1] if node.needs else 0
        elif isinstance(node, Count) and node.relation in _ALLOWING and isinstance(node.bound, int):
            allowed = node.bound + _ALLOWING[node.relation]
        elif isinstance(node, Count) and node.relation in _ALLOWING and _shares(node):
            most = ceil(100 - _share(node))
            return cls(leaf, was, 0, most) if most > 0 else None
        else:
            return None
        most = mission.size - max(allowed, 0)
        return cls(leaf, was, allowed, most) if most > 0 else None

    def applied(self, mission: Mission, amount: int) -> Mission:
        """The mission that allows more agents."""
        return edited(mission, self.leaf, _counting(mission, self.leaf, amount))

    def words(self, mission: Mission, amount: int) -> str:
        """The limit, from what to what."""
        label, who = _subject(mission, self.leaf)
        now, more = str(self.now), agents(self.now + amount, who)
        share = node_at(mission.formula, self.leaf.way)
        if isinstance(share, Count) and _shares(share):
            now, more = str(share.bound), str(_moved(share.bound, amount))
        return f"loosen the limit at '{label}' from {now} to {more} in {self.was}"


_ASKING = {">=": 0, ">": 1}
"""Relations that ask for agents, with how many more than the bound."""

_ALLOWING = {"<=": 0, "<": -1}
"""Relations that limit agents, with how many more than the bound are allowed."""


def _counting(mission: Mission, leaf: Leaf, more: int) -> Formula:
    """An atom with a number of agents that is larger by `more`."""
    node = node_at(mission.formula, leaf.way)
    if isinstance(node, Count):
        return replace(node, bound=_moved(node.bound, more))
    assert isinstance(node, Task | Limit)
    if not node.needs:  # nobody at all may be there
        return Count("max", node.label, None, "<=", more)
    needs = list(node.needs)
    name, number = needs[leaf.pair or 0]
    needs[leaf.pair or 0] = (name, number + more)
    return replace(node, needs=tuple(needs))


def _shares(node: Count) -> bool:
    """Whether a count is compared with a percentage."""
    return isinstance(node.bound, Percent)


def _share(node: Count) -> Fraction:
    assert isinstance(node.bound, Percent)
    return node.bound.value


def _moved(bound: int | Percent, more: int) -> int | Percent:
    """A bound larger by `more`: agents, or hundredths, which stay between 0 % and 100 %."""
    if isinstance(bound, Percent):
        return Percent(min(max(bound.value + more, Fraction(0)), Fraction(100)))
    return bound + more


def _subject(mission: Mission, leaf: Leaf) -> tuple[str, str | None]:
    """The label and the capability that an atom counts."""
    node = node_at(mission.formula, leaf.way)
    if isinstance(node, Count):
        return node.label, node.capability
    assert isinstance(node, Task | Limit)
    return node.label, node.needs[leaf.pair or 0][0] if node.needs else None


FORMULA_DIMENSIONS = (Deadline, LooserLimit, LowerNeed, Duration)
"""What of a formula can be changed, the least intrusive first."""
