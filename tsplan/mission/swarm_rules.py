"""What is said of swarms in a mission, and what does not fit about it."""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterator, Sequence
from typing import TYPE_CHECKING, Any

from tsplan.mission.findings import Entry, Place, Problem
from tsplan.mission.mission import SwarmBounds, SwarmRules

if TYPE_CHECKING:
    from tsplan.mission.mission import Group

KINDS = ("team", "swarm", "swarms")
ONE_SWARM = "swarm"  # the class of a swarm that has no name of its own


def kind_problems(data: Any) -> list[Problem]:
    """Whether a mission file has a team or swarms, or both, and one spelling of its swarms."""
    if not isinstance(data, dict):
        return []
    given = [kind for kind in KINDS if kind in data]
    if not given:
        remedy = "add 'team: ...', or 'swarm: ...' for a swarm that may split"
        return [Problem((), "'team' is missing", remedy)]
    problems = []
    if "swarm" in given and "swarms" in given:
        what = "the mission has 'swarms' beside 'swarm'"
        problems.append(Problem(("swarms",), what, "keep one of them"))
    return problems + list(_misplaced(data, given))


def _misplaced(data: dict[str, Any], given: Sequence[str]) -> Iterator[Problem]:
    """Keys at the top that belong to another kind of mission or into an entry."""
    swarmless = given == ["team"]
    if "margin" in data and swarmless:
        what = "'margin' is head-room for a swarm, and this mission has a team"
        yield Problem(("margin",), what, "remove it, or describe a swarm")
    if "max_subswarms" in data and swarmless:
        what = "'max_subswarms' bounds swarms, and this mission has a team"
        yield Problem(("max_subswarms",), what, "remove it, or describe a swarm")
    if "max_subswarms" in data and "swarm" in given and "swarms" not in given:
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


def swarm_problems(entries: Sequence[Entry], rules: SwarmRules) -> list[Problem]:
    """Names that repeat, rules without a swarm, and what makes every plan impossible (warnings)."""
    problems = []
    classes = Counter(group.class_name for _, group in entries)
    if not rules.each or not rules.each.keys() <= classes.keys():
        remedy = f"give bounds for {', '.join(sorted(classes)) or 'none'}"
        return [Problem(("swarm",), "the rules are not about the swarms", remedy)]
    robots = {group.class_name for place, group in entries if place[0] == "team"}
    swarms = [(place, group) for place, group in entries if place[0] != "team"]
    for place, group in swarms:
        name = group.class_name
        if name in robots:
            what = f"a class of the team is called '{name}', as the swarm is"
            problems.append(Problem((*place, "name"), what, "give each a name of its own"))
        elif classes[name] > 1:
            what = f"several swarms are called '{name}'"
            problems.append(Problem((*place, "name"), what, "give each a name of its own"))
        problems += _impossible(group, rules.each[name], place)
    begin = sum(len(group.starts) for _, group in swarms)
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
