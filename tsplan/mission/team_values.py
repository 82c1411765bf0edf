"""Teams as Python code writes them: in full, or in one of several short forms."""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from typing import Any, TypeAlias

from tsplan.errors import Finding, MissionError
from tsplan.limits import clipped
from tsplan.mission.team import Group

Member: TypeAlias = "Group | Mapping[str, Any] | tuple[Any, ...]"
TeamValues: TypeAlias = "Iterable[Member] | Mapping[str, Mapping[str, Any] | tuple[Any, ...]]"
_MOST = 5  # what `Group.of` takes


def team_members(team: TeamValues) -> list[Group | Mapping[str, Any]]:
    """The members of a team as groups and entries of a mission file.

    Raises MissionError for what is none, all at once.

    >>> team_members({"cart": {"at": {"q1": 2}, "capabilities": ["lift"]}})
    [{'class': 'cart', 'at': {'q1': 2}, 'capabilities': ['lift']}]
    >>> team_members({"cart": {"q1": 2}}) == team_members([("cart", {"q1": 2})])
    True
    """
    if isinstance(team, str) or not isinstance(team, Iterable):
        raise MissionError([Finding(f"the team is {clipped(team)}", _REMEDY)])
    given = [_named(*pair) for pair in team.items()] if isinstance(team, Mapping) else list(team)
    made: list[Group | Mapping[str, Any]] = []
    findings: list[Finding] = []
    for member in given:
        try:
            made.append(_member(member))
        except MissionError as error:
            findings += error.findings
    if findings:
        raise MissionError(findings)
    return made


_REMEDY = 'write it as in {"cart": {"at": {"q1": 2}}}, as ("cart", {"q1": 2}) or as a Group'


def _named(name: str, value: Any) -> Any:
    """A member by the name of its class and what a mapping has for it."""
    if isinstance(value, tuple):
        return (name, *value)
    if not isinstance(value, Mapping):
        return (name, value)
    if "at" not in value:
        return (name, value)  # the starts alone
    if value.get("class", name) != name:
        return (name, value["class"])
    return {"class": name, **value}


def _member(member: Any) -> Group | Mapping[str, Any]:
    if isinstance(member, Group | Mapping):
        return member
    if not isinstance(member, tuple) or not member:
        raise MissionError([Finding(f"a member of the team is {clipped(member)}", _REMEDY)])
    name, *rest = member
    starts = isinstance(rest[0], Mapping) if rest else False
    if not starts or len(member) > _MOST or not isinstance(name, str):
        said = ", ".join(map(clipped, rest)) or "nothing"
        what = f"what is said of the robots of class {clipped(name)} is {said}"
        raise MissionError([Finding(what, _REMEDY)])
    try:
        return Group.of(name, *rest)
    except (TypeError, ValueError) as error:
        what = f"the robots of class {clipped(name)} make no group: {error}"
        raise MissionError([Finding(what, _REMEDY)]) from None
