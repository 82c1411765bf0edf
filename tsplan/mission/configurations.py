"""Modular robots: the configurations of their structures, and how one becomes another.

A module is in exactly one place and one structure at a time. A structure is made of modules of one
class, and counts once for each capability of its configuration and of its modules. While it is
rebuilt it counts nowhere, at no state.

The idea: "Planning for Modular Aerial Robotic Tools with Temporal Logic Constraints", CDC 2022; the
model is this project's own.
"""

from __future__ import annotations

from collections import Counter
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field, replace
from fractions import Fraction
from math import ceil, inf, lcm
from types import MappingProxyType
from typing import TYPE_CHECKING, TypeAlias

from tsplan.exact import exact
from tsplan.mission.resources import Amounts, Carries, merged
from tsplan.words import nfc

if TYPE_CHECKING:
    from tsplan.mission.team import Group
    from tsplan.ts import Edge

Parts: TypeAlias = "tuple[tuple[str, int], ...]"
"""Configurations, with how many structures of each."""


@dataclass(frozen=True, slots=True)
class Configuration:
    """A shape of structures: of how many modules it is made and what it can do.

    `cost` and `duration` are factors on those of every edge that a structure enters; durations are
    rounded up, and waiting takes as long as ever. `carries` is what one structure carries at most.
    """

    name: str
    modules: int
    capabilities: frozenset[str] = frozenset()
    cost: float = 1.0
    duration: float = 1.0
    carries: Carries = ()

    def __post_init__(self) -> None:
        """Bring names into the form in which they are compared."""
        object.__setattr__(self, "name", nfc(self.name))
        object.__setattr__(self, "capabilities", frozenset(map(nfc, self.capabilities)))
        if isinstance(self.carries, tuple):
            object.__setattr__(self, "carries", merged(self.carries))

    def steps(self, edge: Edge, class_name: str) -> int | None:
        """Steps that a structure of modules of a class needs for an edge; None if it cannot.

        >>> from tsplan.ts import Edge
        >>> Configuration("line", 3, duration=1.5).steps(Edge("a", "b", 3), "module")
        5
        """
        steps = edge.duration_for(class_name)
        if steps is None or edge.is_wait:
            return steps
        return ceil(exact(self.duration) * steps)

    def price(self, edge: Edge, class_name: str) -> Fraction:
        """What one use of an edge that a structure may use costs, exactly."""
        return exact(self.cost) * exact(edge.cost_for(class_name))


@dataclass(frozen=True, slots=True)
class Reconfiguration:
    """Structures at one state that become others there, in `duration` steps.

    `parts` are how many of each configuration go in, `made` how many come out. `at` are the states
    or labels where it can be done; without any it can be done everywhere.
    """

    parts: Parts
    made: Parts
    duration: int = 1
    cost: float = 0.0
    at: tuple[str, ...] = ()

    def __post_init__(self) -> None:
        """Bring names into the form in which they are compared; name every configuration once."""
        for name in ("parts", "made"):
            pairs = tuple((nfc(each), count) for each, count in getattr(self, name))
            object.__setattr__(self, name, _summed(pairs))
        object.__setattr__(self, "at", tuple(map(nfc, self.at)))


@dataclass(frozen=True, slots=True)
class Pool:
    """Modules that can be in one structure: of one class with the same capabilities.

    `groups` are their places in the team, `count` how many there are in all, and `shapes` what
    their structures can be.
    """

    groups: tuple[int, ...]
    count: int
    shapes: tuple[Configuration, ...]


@dataclass(frozen=True)
class ModuleRules:
    """What modular robots can become: configurations, reconfigurations, how well they do tasks.

    `performance` has, for labels at which tasks are asked for, what each configuration is worth
    that does one there.
    """

    configurations: tuple[Configuration, ...] = ()
    reconfigurations: tuple[Reconfiguration, ...] = ()
    performance: tuple[tuple[str, Amounts], ...] = ()
    of: Mapping[str, Configuration] = field(init=False, repr=False, compare=False)

    def __post_init__(self) -> None:
        """Find configurations by their names; bring names into the form they are compared in."""
        object.__setattr__(self, "of", {each.name: each for each in self.configurations})
        pairs = tuple((nfc(label), merged(worth)) for label, worth in self.performance)
        object.__setattr__(self, "performance", pairs)

    def __bool__(self) -> bool:
        return bool(self.configurations or self.reconfigurations or self.performance)

    @property
    def sizes(self) -> dict[str, int]:
        """Of how many modules a structure of each configuration is made, where that is a number."""
        every = ((each.name, each.modules) for each in self.configurations)
        return {name: size for name, size in every if type(size) is int and size > 0}

    def modules(self, parts: Parts) -> int:
        """Of how many modules some structures are made."""
        return sum(self.of[name].modules * count for name, count in parts)

    def structures(self, group: Group) -> Group:
        """A group as it acts at first: modules in their structures, robots as they are.

        >>> from tsplan.mission import Group
        >>> rules = ModuleRules((Configuration("pair", 2, frozenset({"lift"})),))
        >>> rules.structures(Group.of("cube", {"dock": 6}, configuration="pair"))
        Group(class_name='cube', capabilities=frozenset({'lift'}), starts=(('dock', 3),))
        """
        shape = self.of.get(group.configuration or "")
        if shape is None:
            return group
        return replace(
            self.shaped(group, shape),
            starts=tuple((state, count // shape.modules) for state, count in group.starts),
            coming=tuple((way, count // shape.modules) for way, count in group.coming),
        )

    def shaped(self, group: Group, shape: Configuration) -> Group:
        """A group whose members could act as structures of a configuration."""
        return replace(
            group,
            capabilities=group.capabilities | shape.capabilities,
            carries=shape.carries,
        )

    def pools(self, team: Sequence[Group], *, enough: bool = False) -> tuple[Pool, ...]:
        """The modules of a team that can be in one structure, in the order of the team.

        With `enough`, their shapes are those that they could have if there were modules enough.
        """
        found: dict[tuple[str, frozenset[str]], list[int]] = {}
        for number, group in enumerate(team):
            if group.configuration in self.of:
                found.setdefault((group.class_name, group.capabilities), []).append(number)
        made = []
        for members in found.values():
            count = sum(team[number].count for number in members)
            names = {str(team[number].configuration) for number in members}
            made.append(Pool(tuple(members), count, self._shapes(names, inf if enough else count)))
        return tuple(made)

    def _shapes(self, names: set[str], count: float) -> tuple[Configuration, ...]:
        """What structures can become by the rules, where there are so many modules."""
        found, before = set(names), 0
        while len(found) > before:
            before = len(found)
            for rule in self.reconfigurations:
                if all(name in found for name, _ in rule.parts):
                    found.update(name for name, _ in rule.made if name in self.of)
        return tuple(
            each for each in self.configurations if each.name in found and each.modules <= count
        )

    def able(self, group: Group, pool: Pool, capability: str | None) -> tuple[Configuration, ...]:
        """The shapes in which the modules of a pool, like those of a group, have a capability."""
        return tuple(
            shape
            for shape in pool.shapes
            if capability is None or capability in group.capabilities | shape.capabilities
        )

    def most(
        self,
        team: Sequence[Group],
        capability: str | None,
        *,
        lost: Mapping[int, int] = MappingProxyType({}),
    ) -> int:
        """How many structures can have a capability at once, at most; any at all for None.

        `lost` says how many modules are, by the place of their group in the team.

        >>> from tsplan.mission import Group
        >>> rules = ModuleRules((Configuration("pair", 2, frozenset({"lift"})),))
        >>> rules.most([Group.of("cube", {"dock": 6}, configuration="pair")], "lift")
        3
        """
        found = 0
        for pool in self.pools(team):
            shapes = self.able(team[pool.groups[0]], pool, capability)
            left = pool.count - sum(lost.get(number, 0) for number in pool.groups)
            found += left // min(shape.modules for shape in shapes) if shapes else 0
        return found

    def possible(self, team: Sequence[Group]) -> tuple[Group, ...]:
        """The groups of a team with the abilities of everything that modules can become."""
        shapes = {number: pool.shapes for pool in self.pools(team) for number in pool.groups}
        return tuple(
            made
            for number, group in enumerate(team)
            for made in (
                [group]
                if number not in shapes
                else [self.shaped(group, shape) for shape in shapes[number]]
            )
        )


def counted_parts(
    given: Mapping[str, int] | str, other: Mapping[str, int] | str, modules: Mapping[str, int]
) -> Parts:
    """One side of a reconfiguration; where both are single names, as many as have equal modules.

    >>> counted_parts("single", "line", {"single": 1, "line": 3})
    (('single', 3),)
    >>> counted_parts({"line": 1, "single": 1}, "ring", {"single": 1, "line": 3, "ring": 4})
    (('line', 1), ('single', 1))
    """
    if not isinstance(given, str):
        return tuple(given.items())
    if not isinstance(other, str) or not {given, other} <= modules.keys():
        return ((given, 1),)
    together = lcm(modules[given], modules[other])
    whole = together in (modules[given], modules[other])  # one is made of some of the other
    return ((given, together // modules[given] if whole else 1),)


def _summed(parts: Parts) -> Parts:
    """Every configuration once, in the order in which they come."""
    if not all(type(count) is int for _, count in parts):
        return parts  # the checks tell of others
    total: Counter[str] = Counter()
    for name, count in parts:
        total[name] += count
    return tuple(total.items())
