"""What agents carry, those in a row that carry the same as one row however many they are."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping
from dataclasses import dataclass, field
from typing import Annotated, Any, NamedTuple, Self, TypeAlias

from pydantic import (
    AfterValidator,
    Field,
    GetCoreSchemaHandler,
    GetPydanticSchema,
    model_validator,
)
from pydantic_core.core_schema import CoreSchema, no_info_after_validator_function

from tsplan.name_runs import Names, Run, joined_runs
from tsplan.plans.agent_entries import MOST_LISTED, Counted, sound
from tsplan.plans.records import OPTIONAL, Record, Whole, Word, as_json, json_lines
from tsplan.plans.supplies import Cargo, Loads
from tsplan.plans.unfolded import Unfolded


class CargoRow(NamedTuple):
    """Each of the agents `names` carries an amount along the edge that it enters at a step."""

    names: Run
    step: int
    resource: str
    amount: float

    def continued(self, after: CargoRow) -> CargoRow | None:
        """Both rows as one, if the agents of the other follow and carry the same."""
        both = self.names.continued(after.names) if self[1:] == after[1:] else None
        return None if both is None else self._replace(names=both)


@dataclass(frozen=True, eq=False, repr=False)
class CargoRows(Unfolded[Cargo]):
    """The cargo of a plan, equal to any sequence of the same cargo; `order` has its rows.

    >>> cargo = CargoRows.of([Cargo("cart-1", 3, "brick", 2.0), Cargo("cart-2", 3, "brick", 2.0)])
    >>> len(cargo), cargo[1].agent, len(cargo.order)
    (2, 'cart-2', 1)
    """

    order: tuple[CargoRow, ...] = ()

    @classmethod
    def of(cls, cargo: Iterable[Cargo]) -> CargoRows:
        """The cargo of any sequence."""
        if isinstance(cargo, CargoRows):
            return cargo
        return cls.joined(CargoRow(Run.of(c.agent), c.step, c.resource, c.amount) for c in cargo)

    @classmethod
    def joined(cls, rows: Iterable[CargoRow]) -> CargoRows:
        """The same in as few rows as follow each other."""
        return cls(tuple(joined_runs(rows)))

    def made(self, row: CargoRow, name: str) -> Cargo:
        """What one agent of a row carries."""
        return Cargo(name, *row[1:])


AgentLoads: TypeAlias = Mapping[int, "list[CargoRow]"]
"""What is carried along the edges that are entered at each step."""


def loads_of(cargo: Iterable[Cargo]) -> AgentLoads:
    """What agents carry along the edges that they enter at each step with some load.

    >>> loads_of([Cargo("truck-1", 3, "brick", 2.0)])[3][0].amount
    2.0
    """
    found: dict[int, list[CargoRow]] = {}
    for row in CargoRows.of(cargo).order:
        found.setdefault(row.step, []).append(row)
    return found


def carried_by(agents: Names, step: int, loads: AgentLoads) -> Loads:
    """What some agents carry together along the edge that they enter at a step.

    >>> cargo = [Cargo(f"truck-{n}", 3, "brick", 2.0) for n in range(5)]
    >>> carried_by(Names.of(["truck-1", "truck-4", "cart-1"]), 3, loads_of(cargo))
    {'brick': 4.0}
    """
    total: Loads = {}
    for row in loads.get(step, ()):
        if count := agents.among(row.names):
            total[row.resource] = total.get(row.resource, 0.0) + count * row.amount
    return total


@dataclass(frozen=True, slots=True)
class _Entry(Record):
    """What an agent carries, or each of several agents."""

    step: Whole
    resource: Word
    amount: Annotated[float, Field(gt=0, allow_inf_nan=False)]
    agent: Word | None = field(default=None, metadata=OPTIONAL)
    agents: Annotated[Counted, AfterValidator(sound)] | None = field(
        default=None, metadata=OPTIONAL
    )

    @model_validator(mode="after")
    def _named(self) -> Self:
        if (self.agent is None) == (self.agents is None):
            raise ValueError("cargo has an agent or agents, one of both")
        return self

    @property
    def row(self) -> CargoRow:
        """The same as a row."""
        names = Run.of(str(self.agent)) if self.agents is None else Run(*self.agents)
        return CargoRow(names, self.step, self.resource, self.amount)


def _read(_: Any, handler: GetCoreSchemaHandler) -> CoreSchema:
    listed = handler.generate_schema(tuple[_Entry, ...])
    return no_info_after_validator_function(
        lambda entries: CargoRows.joined(entry.row for entry in entries), listed
    )


READ_CARGO = GetPydanticSchema(_read)
"""How the cargo of a plan is read: from entries, with findings at their places there."""


def cargo_json(cargo: CargoRows, *, each: bool = False) -> str:
    """The cargo in JSON, that of every agent by itself if it is little or with `each`."""
    if each or len(cargo) <= MOST_LISTED:
        return json_lines(map(as_json, cargo))
    return json_lines(_rows(cargo))


def _rows(cargo: CargoRows) -> Iterator[str]:
    for row in cargo.order:
        names = row.names
        if names.size == 1:
            yield as_json(cargo.made(row, names.name()))
            continue
        tail = as_json(cargo.made(row, "")).removeprefix('{"agent": ""')
        yield f'{{"agents": {as_json(tuple(names))}{tail}'
