"""Where robots start, as mission files say it: at states, on edges, or some here and some there.

`q1` is a state, `{q1: 2, q2: 5}` says how many start at each of several, `{from: q1, to: q2,
arrives: 3}` is an edge on which they are until they come to its end at that step, and a list has
any of these.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from typing import Annotated, Any, TypeAlias

from pydantic import (
    BaseModel,
    Field,
    GetCoreSchemaHandler,
    GetPydanticSchema,
)
from pydantic_core.core_schema import (
    CoreSchema,
    chain_schema,
    no_info_after_validator_function,
    no_info_before_validator_function,
    no_info_wrap_validator_function,
)

from tsplan.document import Document
from tsplan.document.fields import complaint, shown
from tsplan.document.written import Written
from tsplan.limits import MOST_STEPS
from tsplan.mission.amount_entries import amounts_entry
from tsplan.mission.entry_fields import CLOSED, Amount, Count, Name, is_name
from tsplan.mission.findings import Place
from tsplan.mission.team import Group, UnderWay


class UnderWayEntry(BaseModel):
    """Robots that start on an edge, and when they come to its end."""

    model_config = CLOSED

    origin: Name = Field(alias="from")
    target: Name = Field(alias="to")
    arrives: Annotated[int, Field(strict=True, ge=1, le=MOST_STEPS)]
    count: Count | None = None
    carrying: dict[Name, Amount] = {}

    @property
    def start(self) -> UnderWay:
        """The start that it stands for."""
        return UnderWay(self.origin, self.target, self.arrives, tuple(self.carrying.items()))


StartEntry: TypeAlias = UnderWayEntry | dict[str, int] | str
"""One start, or several states with the numbers of those that start there."""


def _is_edge(value: Any) -> bool:
    """Whether a mapping is an edge; else its keys are states."""
    return isinstance(value, dict) and {"from", "to"} <= value.keys()


def _only(asked: Callable[[Any], bool], kind: Any, handler: GetCoreSchemaHandler) -> CoreSchema:
    """What is asked for is read as a kind, and everything else left as it is."""

    def read(value: Any, inner: Callable[[Any], Any]) -> Any:
        return inner(value) if asked(value) else value

    return no_info_wrap_validator_function(read, handler.generate_schema(kind))


def _known(value: Any) -> Any:
    if not is_name(value) and not isinstance(value, dict):
        remedy = "write a state, states with numbers, or {from: ..., to: ..., arrives: 3}"
        raise complaint(f"{shown(value)} is no start", remedy)
    return value


def _start(_: Any, handler: GetCoreSchemaHandler) -> CoreSchema:
    """How one start is read; a union of kinds would name them in the places of findings."""
    counts = _only(lambda v: isinstance(v, dict) and not _is_edge(v), dict[Name, Count], handler)
    kinds = [_only(_is_edge, UnderWayEntry, handler), counts, _only(is_name, Name, handler)]
    return no_info_before_validator_function(_known, chain_schema(kinds))


_One = Annotated[StartEntry, GetPydanticSchema(_start)]


def _starts(_: Any, handler: GetCoreSchemaHandler) -> CoreSchema:
    """How one start or a list of them is read: as a list."""
    some = Annotated[list[_One], Field(min_length=1)]
    kinds = [
        _only(lambda value: not isinstance(value, list), _One, handler),
        _only(lambda value: isinstance(value, list), some, handler),
    ]
    return no_info_after_validator_function(
        lambda value: value if isinstance(value, list) else [value], chain_schema(kinds)
    )


_Written: TypeAlias = Name | dict[Name, Count] | UnderWayEntry
Starts = Annotated[
    list[StartEntry],
    GetPydanticSchema(_starts),
    Written(_Written | Annotated[list[_Written], Field(min_length=1)]),
]
"""Where robots start: a list of StartEntry."""


def starts_of(
    given: Sequence[StartEntry], document: Document, path: Place, count: int | None
) -> list[tuple[str | UnderWay, int]]:
    """Where robots start, as a document has it at a path; states are named as they are written.

    One start that says no number is of `count` robots.
    """
    listed = isinstance(document.at(path), list)
    starts: list[tuple[str | UnderWay, int | None]] = []
    for number, entry in enumerate(given):
        if isinstance(entry, UnderWayEntry):
            starts.append((entry.start, entry.count))
        elif isinstance(entry, dict):
            starts += entry.items()
        else:
            written = document.text((*path, number) if listed else path)
            starts.append((written or entry, None))
    alone = count if len(starts) == 1 else None
    return [(start, own or alone or 1) for start, own in starts]


def start_path(given: Any, start: str | int) -> Place:
    """Where in what is given as `at` a start stands: the steps that lead there.

    The start is a state, or the label of an edge (see `UnderWay.label`).
    """
    if not isinstance(given, list):
        return () if not isinstance(given, dict) or _is_edge(given) else (start,)
    for number, entry in enumerate(given):
        if _is_edge(entry):
            if f"{entry['from']} to {entry['to']} at {entry.get('arrives')}" == start:
                return (number,)
        elif isinstance(entry, dict):
            if str(start) in map(str, entry):
                return number, start
        elif str(entry) == start:
            return (number,)
    return ()


def starts_entry(group: Group) -> Any:
    """What a file has as `at`, with all numbers of robots in it."""
    ways: list[Any] = [_way_entry(*each) for each in group.coming]
    if not ways:
        return dict(group.starts)
    every = [dict(group.starts), *ways] if group.starts else ways
    return every[0] if len(every) == 1 else every


def _way_entry(start: UnderWay, count: int) -> dict[str, Any]:
    ends = {"from": start.origin, "to": start.target, "arrives": start.arrives, "count": count}
    load = {"carrying": amounts_entry(start.carrying)} if start.carrying else {}
    return {**ends, **load}
