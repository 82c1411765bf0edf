"""Missions from Python values: they are written down as a mission file and read like one.

So the checks, their words and the defaults are those of files, and nothing is said twice.
"""

from __future__ import annotations

import json
import re
from collections import Counter
from dataclasses import asdict, is_dataclass, replace
from numbers import Integral, Real
from pathlib import Path
from typing import TYPE_CHECKING, Any

from tsplan.errors import Finding, InputError, MissionError
from tsplan.mission.mission import Group, Preference
from tsplan.mission.read import mission_from_document

if TYPE_CHECKING:
    from collections.abc import Mapping

    from tsplan.mission.mission import Mission

_SOURCE = "mission"
_PAIR = re.compile(r"\\u(d[89ab]..)\\u(d[c-f]..)")  # how JSON writes a character above U+FFFF


def mission_from_values(values: Mapping[str, Any]) -> Mission:
    """A mission from the keys of a mission file, whose map and groups may be Python objects.

    Raises MissionError; its findings name no lines, since there is no file.
    """
    from tsplan.document import parse_document  # noqa: PLC0415  (the reader is slow to import)
    from tsplan.ts import TransitionSystem  # noqa: PLC0415  (networkx is slow to import)
    from tsplan.ts.io.tsplan_yaml import map_to_yaml  # noqa: PLC0415

    given = values["map"]
    if not isinstance(given, TransitionSystem | str | Path):
        what = f"the map is a value of type '{type(given).__name__}'"
        raise MissionError([Finding(what, "give a TransitionSystem or the path of a map file")])
    system = given if isinstance(given, TransitionSystem) else None
    written = {
        "format": "tsplan-mission/1",
        **{key: value for key, value in values.items() if value is not None},
        "map": map_to_yaml(system) if system is not None else str(given),
        "spec": _spec(values["spec"]),
    }
    if values.get("team") is not None:
        written["team"] = [_member(group) for group in values["team"]]
    text = json.dumps(written, default=_plain)
    try:
        document = parse_document(_PAIR.sub(_whole, text), _SOURCE)
        made = mission_from_document(document, Path(), system)
        return replace(made, origin=None)  # nobody has seen that document
    except InputError as error:
        raise MissionError(_without_lines(finding) for finding in error.findings) from None


def _whole(pair: re.Match[str]) -> str:
    """A pair of surrogates as the one escape that YAML knows for it."""
    high, low = int(pair[1], 16), int(pair[2], 16)
    return f"\\U{0x10000 + ((high - 0xD800) << 10) + (low - 0xDC00):08x}"


def _member(group: Any) -> Any:
    """An entry of the team as a file writes it."""
    if not isinstance(group, Group):
        return group
    starts: Counter[str] = Counter()
    for state, count in group.starts:
        starts[state] += count
    return {
        "class": group.class_name,
        "at": dict(starts),
        "capabilities": sorted(group.capabilities),
    }


def _spec(spec: Mapping[str, Any]) -> dict[str, Any]:
    """The formulas as a file writes them."""
    if "prefer" not in spec:
        return dict(spec)
    return {**spec, "prefer": [_wish(wish) for wish in spec["prefer"]]}


def _wish(wish: Any) -> Any:
    if not isinstance(wish, Preference):
        return wish
    written = {"formula": wish.formula, "weight": wish.weight, "level": wish.level}
    name = {"name": wish.name} if wish.name else {}
    return {**written, **name, "partial": wish.partial}


def _plain(value: Any) -> Any:
    """What JSON does not know: numpy's numbers, sets, dataclasses, formulas."""
    if isinstance(value, Integral):
        return int(value)
    if isinstance(value, Real):
        return float(value)
    if isinstance(value, set | frozenset):
        return sorted(value)
    if is_dataclass(value) and not isinstance(value, type) and hasattr(value, "time_limit"):
        return asdict(value)
    return str(value)


def _without_lines(finding: Finding) -> Finding:
    if finding.source != _SOURCE:
        return finding
    return replace(finding, line=None, column=None)
