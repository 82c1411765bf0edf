"""What a mission says of a map in a file of another program: speeds, labels, areas.

map: {file: nav.geojson, step: 2.0, speed: {cart: 0.5, default: 1}, labels: {dock: [3, 17]}}
"""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass, field
from types import MappingProxyType
from typing import Annotated, Any, NamedTuple, TypeAlias

from pydantic import BaseModel, BeforeValidator, ConfigDict, Field

from tsplan.document import Document, Path, validated
from tsplan.document.fields import Natural, Number, Point, Truth, Word, complaint, shown
from tsplan.document.written import Written
from tsplan.errors import Finding, MapError
from tsplan.ts.ride_durations import Speed
from tsplan.ts.validity import CORNERS

STEP, SPEED = 1.0, 1.0
"""Seconds of a step, and metres a second, where nothing is said."""

Corners: TypeAlias = tuple[tuple[float, float], ...]
Locate: TypeAlias = Callable[[Path, str, str], Finding]


class Area(NamedTuple):
    """A polygon whose states get a label; of one level alone where there are several."""

    label: str
    corners: Corners
    level: str | None
    path: Path


def _unplaced(path: Path, message: str, remedy: str) -> Finding:
    return Finding(f"{path[0]}: {message}" if path else message, remedy)


@dataclass(frozen=True)
class MapSettings:
    """How a map is read: the seconds of a `step`, the `speed`, and the side of a `cell` in metres.

    What is None is not said. `capacity` is that of every state, and of every edge with its reverse,
    which has none of its own. `labels` have ids of the file, or names of states, with their places;
    `locate` gives what is wrong with something said here its place.
    """

    step: float | None = None
    speed: Speed | None = None
    cell: float | None = None
    waiting: bool | None = None
    capacity: int | None = None
    labels: Mapping[str, tuple[tuple[str | int, Path], ...]] = field(default_factory=dict)
    areas: tuple[Area, ...] = ()
    locate: Locate = _unplaced

    @property
    def seconds(self) -> float:
        """The seconds of a step."""
        return STEP if self.step is None else self.step

    @property
    def pace(self) -> Speed:
        """The speed, by class where classes differ."""
        return SPEED if self.speed is None else self.speed

    def refuse(self, name: str, message: str, remedy: str) -> MapError:
        """The error that something is said here that has no place."""
        return MapError([self.locate((name,), message, remedy)])


PLAIN = MapSettings()
"""Nothing is said."""


def _ids(value: Any) -> Any:
    """One id, or a list of them."""
    listed = value if isinstance(value, list) else [value]
    for each in listed:
        if isinstance(each, bool) or not isinstance(each, str | int):
            raise complaint(f"{shown(each)} is no id of a state", "write them as in [3, 17]")
    return listed


def _polygon(value: Any) -> Any:
    """An area may be a list of corners alone; several areas are a list of mappings."""
    if isinstance(value, list) and all(isinstance(part, dict) for part in value):
        return value
    return [{"shape": value} if isinstance(value, list) else value]


class _AreaEntry(BaseModel):
    model_config = ConfigDict(extra="forbid", defer_build=True)
    shape: Annotated[list[Point], Field(min_length=CORNERS)]
    level: Word | None = None


_Above = Annotated[Number, Field(gt=0)]


def _speeds(value: Any) -> Any:
    for each in value.values() if isinstance(value, dict) else [value]:
        if isinstance(each, bool) or not isinstance(each, int | float) or not each > 0:
            raise complaint(f"{shown(each)} is no speed above 0", "write metres a second")
    if value == {}:
        raise complaint("no class is listed", "write it as {class: metres a second}")
    return value


_Ids = Annotated[Any, BeforeValidator(_ids), Written(str | int | list[str | int])]
_Areas = Annotated[
    list[_AreaEntry],
    BeforeValidator(_polygon),
    Written(list[Point] | _AreaEntry | list[_AreaEntry]),
]
_Speed = Annotated[Any, BeforeValidator(_speeds), Written(_Above | dict[str, _Above])]


class MapReference(BaseModel):
    """A map file of another program, and what is said of reading it."""

    model_config = ConfigDict(extra="forbid", defer_build=True)
    file: Word
    step: _Above | None = None
    speed: _Speed = None
    cell: _Above | None = None
    waiting: Truth | None = None
    capacity: Natural | None = None
    labels: dict[Word, _Ids] = {}
    areas: dict[Word, _Areas] = {}


def read_settings(document: Document, path: Path) -> tuple[str, MapSettings]:
    """The name of the file at a path of a document, and what is said there of reading it.

    Raises MapError with all that is wrong.
    """
    entry, findings = validated(document, MapReference, path)
    if entry is None:
        raise MapError(findings)

    def locate(below: Path, message: str, remedy: str) -> Finding:
        return document.finding((*path, *below), message, remedy)

    return entry.file, MapSettings(
        entry.step,
        entry.speed,
        entry.cell,
        entry.waiting,
        entry.capacity,
        MappingProxyType(
            {
                label: tuple((each, ("labels", label, n)) for n, each in enumerate(ids))
                for label, ids in entry.labels.items()
            }
        ),
        tuple(
            Area(label, tuple(part.shape), part.level, ("areas", label, number))
            for label, parts in entry.areas.items()
            for number, part in enumerate(parts)
        ),
        locate,
    )


def is_reference(given: Any) -> bool:
    """Whether a mission's map is a file with settings, and no map that is written there."""
    return isinstance(given, dict) and "file" in given and "states" not in given
