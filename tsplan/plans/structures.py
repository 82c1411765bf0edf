"""Structures of modules in a plan: what they are made of, how long they live, where they are."""

from __future__ import annotations

from collections import Counter, defaultdict
from collections.abc import Iterable, Iterator
from dataclasses import dataclass, field
from typing import Annotated, NamedTuple, Self

from pydantic import Field, model_validator

from tsplan.parameters import step_within
from tsplan.plans.agent_plans import Stay, joined, state_in, stays_somewhere
from tsplan.plans.presence import Presence
from tsplan.plans.records import OPTIONAL, Record, Whole, Word


@dataclass(frozen=True, slots=True)
class Structure(Record):
    """Modules that are one body of a configuration from step `first` to step `last`.

    It stays and moves as an agent does, and counts once for each of its capabilities. `heading` is
    the state it is on its way to at the horizon, and `coming` the state it left before step 0 when
    its first stay begins later: where that is the same, it is being rebuilt there until then.
    """

    id: Word
    class_name: Word
    configuration: Word
    capabilities: frozenset[Word]
    modules: Annotated[tuple[Word, ...], Field(min_length=1)]
    first: Whole
    last: Whole
    stays: tuple[Stay, ...]
    heading: Word | None = field(default=None, metadata=OPTIONAL)
    coming: Word | None = field(default=None, metadata=OPTIONAL)

    @model_validator(mode="after")
    def _somewhere(self) -> Self:
        """Asked of what a file says alone."""
        stays_somewhere(self.stays, self.coming, self.heading)
        return self

    def state_at(self, step: int) -> str | None:
        """The structure's state at a step; None while it travels or is not there.

        Raises InputError for what is no step.
        """
        return state_in(self.stays, step_within(step, None))


@dataclass(frozen=True, slots=True)
class Rebuilt(Record):
    """Structures at a state that become others there: a reconfiguration that begins at a step.

    `rule` is the place of the reconfiguration in the mission's list, `parts` and `made` the ids of
    the structures that go in and come out; those that would come out after the horizon are none.
    """

    step: Whole
    state: Word
    rule: Whole
    parts: Annotated[tuple[Word, ...], Field(min_length=1)]
    made: tuple[Word, ...] = ()


class ModulePath(NamedTuple):
    """Where a module is: at which states, in which structures, and where it is heading.

    `coming` is where it was before, if it starts under way.
    """

    stays: tuple[Stay, ...]
    structures: tuple[tuple[int, int, str], ...]
    heading: str | None
    coming: str | None = None


def module_paths(structures: Iterable[Structure]) -> dict[str, ModulePath]:
    """The path of every module, by its id, as the structures that it is part of make it.

    >>> first = Structure("a-1", "m", "a", frozenset(), ("m-1",), 0, 2, ((0, 2, "p"),))
    >>> later = Structure("b-1", "m", "b", frozenset(), ("m-1",), 4, 5, ((4, 4, "p"),), "q")
    >>> path = module_paths([later, first])["m-1"]
    >>> path.stays, path.structures, path.heading
    (((0, 2, 'p'), (4, 4, 'p')), ((0, 2, 'a-1'), (4, 5, 'b-1')), 'q')
    """
    lives: dict[str, list[Structure]] = defaultdict(list)
    for structure in structures:
        for module in structure.modules:
            lives[module].append(structure)
    found = {}
    for module, mine in lives.items():
        mine.sort(key=lambda each: each.first)
        found[module] = ModulePath(
            tuple(joined(stay for each in mine for stay in each.stays)),
            tuple((each.first, each.last, each.id) for each in mine),
            mine[-1].heading,
            mine[0].coming,
        )
    return found


def of_structures(structures: Iterable[Structure]) -> Iterator[Presence]:
    """Where structures stay, those at one state at the same time as one."""
    counts: Counter[tuple[str, int, int, frozenset[str]]] = Counter()
    for each in structures:
        counts.update((state, first, last, each.capabilities) for first, last, state in each.stays)
    for (state, first, last, able), count in counts.items():
        yield Presence(state, first, last, count, able)
