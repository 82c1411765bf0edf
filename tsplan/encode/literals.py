"""Literals of the tight encoding, and which of them can never be true together.

A *choice* is a set of 0/1 columns of which exactly one is 1 where its parent literal is. A
*literal* is a sum of columns that exclude each other, so it is 0 or 1 itself; the empty literal
stands for "always". Two columns exclude each other when, somewhere up their ancestry, they
descend from different options of one choice.
"""

from __future__ import annotations

from collections import defaultdict
from collections.abc import Iterable, Sequence
from collections.abc import Set as AbstractSet
from typing import TypeAlias

import numpy as np

from tsplan.milp.model import Draft, Ints

Literal: TypeAlias = tuple[int, ...]
ALWAYS: Literal = ()
Lineage: TypeAlias = dict[int, frozenset[int]]
Timed: TypeAlias = tuple[Ints, Sequence[int]]  # columns of a choice and the steps they stand for


class Choices:
    """Makes indicator columns in a draft and remembers their ancestry."""

    def __init__(self, draft: Draft) -> None:
        self._draft = draft
        self._lineage: dict[int, Lineage] = {}
        self._free: set[int] = set()
        self._count = 0
        self.columns: list[int] = []
        self.steps: list[int] = []
        self.groups: list[Ints] = []
        self.refuted = False

    def choose(self, parent: Literal, steps: Sequence[int], kind: str) -> Ints:
        """Columns of which exactly one is 1 where `parent` is 1, and none elsewhere.

        There is one for each of `steps`: when what the option stands for begins.
        """
        options = len(steps)
        columns = self._draft.columns(options, upper=1.0, integer=True)
        index = np.zeros(options + len(parent), dtype=np.int64)
        values = np.concatenate([np.ones(options), -np.ones(len(parent))])
        total = 0.0 if parent else 1.0
        self._draft.rows(
            index,
            np.concatenate([columns, _array(parent)]),
            values,
            lower=total,
            upper=total,
            kind=kind,
        )
        above = self.lineage(parent)
        for column in columns.tolist():
            self._lineage[column] = {**above, self._count: frozenset((column,))}
        self._count += 1
        self.columns += columns.tolist()
        self.steps += steps
        self.groups.append(columns)
        return columns

    def optional(self, parent: Literal, steps: Sequence[int], kind: str) -> Ints:
        """Columns of which at most one is 1 where `parent` is 1, and none elsewhere."""
        options = len(steps)
        columns = self._draft.columns(options, upper=1.0, integer=True)
        self._draft.rows(
            np.zeros(options + len(parent), dtype=np.int64),
            np.concatenate([columns, _array(parent)]),
            np.concatenate([np.ones(options), -np.ones(len(parent))]),
            lower=-np.inf,
            upper=0.0 if parent else 1.0,
            kind=kind,
        )
        above = self.lineage(parent)
        for column in columns.tolist():
            self._lineage[column] = {**above, self._count: frozenset((column,))}
        self._count += 1
        self.columns += columns.tolist()
        self.steps += steps
        if options > 1:
            self.groups.append(columns)
        return columns

    def free(self, steps: Sequence[int]) -> Ints:
        """Columns that exclude nothing: each may be 1 whenever its own sub-formula holds."""
        columns = self._draft.columns(len(steps), upper=1.0, integer=True)
        for column in columns.tolist():
            self._lineage[column] = {self._count: frozenset((column,))}
            self._free.add(column)
            self._count += 1
        self.columns += columns.tolist()
        self.steps += steps
        return columns

    def cover(self, columns: Ints, parent: Literal, kind: str) -> None:
        """At least one of `columns` is 1 where `parent` is 1."""
        index = np.zeros(len(columns) + len(parent), dtype=np.int64)
        values = np.concatenate([np.ones(len(columns)), -np.ones(len(parent))])
        lower = 0.0 if parent else 1.0
        self._draft.rows(
            index,
            np.concatenate([columns, _array(parent)]),
            values,
            lower=lower,
            upper=np.inf,
            kind=kind,
        )

    def follow(self, before: Timed, after: Timed, gap: int, kind: str) -> None:
        """The witness of `after` comes at most `gap` steps later than that of `before`."""
        (earlier, first), (later, second) = before, after
        for place, step in enumerate(first):
            done = later[np.asarray(second) <= step + gap]
            begun = earlier[: place + 1]
            self._draft.rows(
                np.zeros(len(done) + len(begun), dtype=np.int64),
                np.concatenate([done, begun]),
                np.concatenate([np.ones(len(done)), -np.ones(len(begun))]),
                lower=0.0,
                upper=np.inf,
                kind=kind,
            )

    def refute(self, literal: Literal, kind: str) -> None:
        """The literal cannot be 1; an impossible `ALWAYS` refutes the whole problem."""
        if not literal:
            self.refuted = True
            return
        zeros = np.zeros(len(literal), dtype=np.int64)
        self._draft.rows(zeros, _array(literal), 1.0, lower=0.0, upper=0.0, kind=kind)

    def lineage(self, literal: Literal) -> Lineage:
        """Choices that all columns of a literal descend from, with the options they came by."""
        if not literal:
            return {}
        first, *others = (self._lineage[column] for column in literal)
        common = dict(first)
        for other in others:
            common = {key: common[key] | other[key] for key in common.keys() & other.keys()}
        return common

    def ancestors(self, column: int) -> set[int]:
        """Other columns that are 1 wherever `column` is."""
        above = self._lineage[column].values()
        return {option for options in above if len(options) == 1 for option in options} - {column}

    def families(self, columns: Iterable[int]) -> list[list[int]]:
        """Partition columns, greedily and in order, into families that exclude each other."""
        families: list[_Family] = []
        alone: list[list[int]] = []
        for column in sorted(set(columns)):
            lineage = self._lineage[column]
            if column in self._free:  # excludes nothing, so it is a family of its own
                alone.append([column])
                continue
            for family in families:
                near = family.near(lineage)
                if all(exclusive(self._lineage[member], lineage) for member in near):
                    family.add(column, lineage)
                    break
            else:
                families.append(_Family(column, lineage))
        return [family.members for family in families] + alone

    def merged(self, literals: Iterable[Literal]) -> list[Literal]:
        """Fewer literals that say the same: exclusive ones are added up.

        The result may overlap only where the same column was asked for twice.
        """
        unique = set(literals)
        if ALWAYS in unique:
            return [ALWAYS]
        if len(unique) == 1:
            return list(unique)
        columns = {column for literal in unique for column in literal}
        return [tuple(family) for family in self.families(columns)]


def _array(literal: Literal) -> Ints:
    return np.array(literal, dtype=np.int64)


def exclusive(first: Lineage, second: Lineage) -> bool:
    """Whether two lineages diverge at some choice."""
    return any(first[key].isdisjoint(second[key]) for key in first.keys() & second.keys())


class _Family:
    """Columns that exclude each other, found again by the options they descend from."""

    def __init__(self, column: int, lineage: Lineage) -> None:
        self.members: list[int] = []
        self._shared: AbstractSet[int] = lineage.keys()
        self._by_option: dict[int, dict[int, list[int]]] = defaultdict(lambda: defaultdict(list))
        self.add(column, lineage)

    def add(self, column: int, lineage: Lineage) -> None:
        """Take in a column that all members exclude."""
        self.members.append(column)
        self._shared = self._shared & lineage.keys()
        for key, options in lineage.items():
            for option in options:
                self._by_option[key][option].append(column)

    def near(self, lineage: Lineage) -> Sequence[int]:
        """Members among which all are that `lineage` may not exclude: the fewest found at once.

        Members that went another way at a choice which all of them came by are excluded for sure.
        """
        fewest: Sequence[int] = self.members
        for key in self._shared & lineage.keys():
            found = self._by_option[key]
            members = [member for option in lineage[key] for member in found.get(option, ())]
            if len(members) < len(fewest):
                fewest = members
        return fewest
