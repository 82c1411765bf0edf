"""What is said of swarms in a mission, and what does not fit about it."""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterator, Sequence
from fractions import Fraction
from typing import TYPE_CHECKING, Any

from tsplan.mission.findings import Place, Problem
from tsplan.mission.mission import SwarmBounds, SwarmRules

if TYPE_CHECKING:
    from tsplan.mission.mission import Group
    from tsplan.mission.mission_schema import Swarm

KINDS = ("team", "swarm", "swarms")


def swarm_rules(
    names: Sequence[str],
    entries: Sequence[Swarm],
    together: int | None,
    margin: Fraction | int,
) -> SwarmRules:
    """The rules of the swarms of a mission file, in their order."""
    each = {
        name: SwarmBounds(entry.max_subswarms, entry.min_subswarm)
        for name, entry in zip(names, entries, strict=True)
    }
    return SwarmRules(each, together, margin)


def kind_problems(data: Any) -> list[Problem]:
    """Whether a mission file is for one of a team, a swarm and several swarms, and consistently."""
    if not isinstance(data, dict):
        return []
    given = [kind for kind in KINDS if kind in data]
    if not given:
        remedy = "add 'team: ...', or 'swarm: ...' for a swarm that may split"
        return [Problem((), "'team' is missing", remedy)]
    problems = [
        Problem((kind,), f"the mission has '{kind}' beside '{given[0]}'", "keep one of them")
        for kind in given[1:]
    ]
    return problems + list(_misplaced(data, given))


def _misplaced(data: dict[str, Any], given: Sequence[str]) -> Iterator[Problem]:
    """Keys at the top that belong to another kind of mission or into an entry."""
    if "margin" in data and given == ["team"]:
        what = "'margin' is head-room for a swarm, and this mission has a team"
        yield Problem(("margin",), what, "remove it, or describe a swarm")
    if "max_subswarms" in data and given == ["team"]:
        what = "'max_subswarms' bounds swarms, and this mission has a team"
        yield Problem(("max_subswarms",), what, "remove it, or describe a swarm")
    if "max_subswarms" in data and given == ["swarm"]:
        what = "'max_subswarms' stands here only to bound several swarms together"
        yield Problem(("max_subswarms",), what, "write it inside 'swarm'")
    if "min_subswarm" in data:
        what = "'min_subswarm' is a bound of one swarm"
        yield Problem(("min_subswarm",), what, "write it inside the swarm")


def total_problems(size: int, starts: Sequence[tuple[str, int]], path: Place) -> list[Problem]:
    """A size that is not what the start states hold."""
    total = sum(count for _, count in starts)
    if total == size:
        return []
    what = f"the size is {size:,} and the start states hold {total:,}"
    return [Problem((*path, "size"), what, f"write {total} or correct the start states")]


def swarm_problems(
    team: Sequence[Group], places: Sequence[Place], rules: SwarmRules
) -> list[Problem]:
    """Names that repeat, rules without a swarm, and what makes every plan impossible (warnings)."""
    problems = []
    times = Counter(group.class_name for group in team)
    for place, group in zip(places, team, strict=True):
        if times[group.class_name] > 1:
            what = f"several swarms are called '{group.class_name}'"
            problems.append(Problem((*place, "name"), what, "give each a name of its own"))
    if set(rules.each) != set(times):
        remedy = f"give bounds for {', '.join(sorted(times)) or 'none'}"
        problems.append(Problem(("swarm",), "the rules are not about the swarms", remedy))
        return problems
    for place, group in zip(places, team, strict=True):
        problems += _impossible(group, rules.each[group.class_name], place)
    begin = sum(len(group.starts) for group in team)
    if rules.together is not None and begin > rules.together:
        what = f"the swarms start in {begin} places, and together only {rules.together} are allowed"
        problems.append(Problem(("max_subswarms",), what, _HOPELESS, serious=False))
    return problems


_HOPELESS = "no plan is possible; raise the bound or start together"


def _impossible(group: Group, bounds: SwarmBounds, place: Place) -> list[Problem]:
    """Bounds that the start already breaks."""
    problems = []
    most, least = bounds.most, bounds.least
    if least > group.count:
        what = f"a sub-swarm needs {least:,} agents, and there are {group.count:,} in all"
        remedy = "no plan is possible; lower the bound"
        return [Problem((*place, "min_subswarm"), what, remedy, serious=False)]
    for state, count in group.starts:
        if 0 < count < least:
            what = f"{count:,} agents start at '{state}', and a sub-swarm needs {least:,}"
            remedy = "no plan is possible; lower 'min_subswarm' or start together"
            problems.append(Problem((*place, "at", state), what, remedy, serious=False))
    if most is not None and len(group.starts) > most:
        what = f"the swarm starts in {len(group.starts)} places, and only {most} are allowed"
        problems.append(Problem((*place, "max_subswarms"), what, _HOPELESS, serious=False))
    return problems
