"""Whether the team fits together: counts, starts, names, bounds of swarms, classes of the map."""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterator, Mapping, Sequence
from typing import TypeAlias

from tsplan.errors import Nearest, nearest
from tsplan.limits import MOST_ROBOTS, MOST_STEPS, Range
from tsplan.mission.configurations import ModuleRules
from tsplan.mission.findings import Entry, Fault, Place
from tsplan.mission.team import ONE_SWARM, Group, SwarmBounds, SwarmRules, UnderWay
from tsplan.ts import TransitionSystem
from tsplan.ts.closures import closed_at


def entries_of(team: Sequence[Group], swarm: SwarmRules | None) -> list[Entry]:
    """The groups of a team with the places that a mission file has for them."""
    swarms = {} if swarm is None else swarm.each
    made: dict[str, list[Entry]] = {"team": [], "swarms": []}
    for group in team:
        kind = "swarms" if group.class_name in swarms else "team"
        made[kind].append(((kind, len(made[kind])), group))
    if [group.class_name for _, group in made["swarms"]] == [ONE_SWARM]:
        made["swarms"] = [(("swarm",), group) for _, group in made["swarms"]]
    return made["team"] + made["swarms"]


def team_faults(
    entries: Sequence[Entry],
    system: TransitionSystem | None,
    swarm: SwarmRules | None,
    modular: ModuleRules,
) -> Iterator[Fault]:
    """Counts, classes and start states; without a map, only what does not need it."""
    if not entries:
        yield Fault(("team",), "the team is empty", "add at least one robot")
    for place, group in entries:
        if not group.starts and not group.coming:
            yield Fault((*place, "at"), "no start state", "say where the robots start")
        for state, count in group.starts:
            if count < 1:
                what, remedy = f"{count} robots at '{state}'", "a count is a whole number from 1"
                yield Fault((*place, "at", state), what, remedy)
        yield from _under_way_faults(place, modular.structures(group), system)
    size = sum(group.count for _, group in entries)
    if size > MOST_ROBOTS:
        path, remedy = entries[0][0][:1], f"at most {MOST_ROBOTS:,} are planned"
        yield Fault(path, f"a team of {size:,} robots", remedy)
    if system is not None:
        acting = [(place, modular.structures(group)) for place, group in entries]
        yield from _start_faults(acting, system)
    yield from _class_faults([entry for entry in entries if entry[0][0] == "team"])
    if swarm is not None:
        yield from _swarm_faults(entries, swarm)


def _under_way_faults(
    place: Place, group: Group, system: TransitionSystem | None
) -> Iterator[Fault]:
    """Starts on edges: numbers, steps of arrival, and states that are none."""
    for start, count in group.coming:
        path = (*place, "at", start.label)
        if count < 1:
            what, remedy = f"{count} robots {start.words}", "a count is a whole number from 1"
            yield Fault(path, what, remedy)
        if words := _STEP.complaint(start.arrives):
            what = f"the robots {start.words} arrive at step {start.arrives}: {words}"
            yield Fault(path, what, "write a step from 1, or start them at the state")
        if system is not None:
            yield from _begun_on_map(group, start, path, system)


def _begun_on_map(
    group: Group, start: UnderWay, path: Place, system: TransitionSystem
) -> Iterator[Fault]:
    """A start on an edge whose states are none, or where the class may not come to the end."""
    if system.actions:
        what = f"robots start {start.words}, and the moves of the map are uncertain"
        yield Fault(path, what, "start them at a state")
    for name in dict.fromkeys((start.origin, start.target)):
        if name not in system.states:
            yield Fault(path, f"the map has no state '{name}'", nearest(name, system.states))
    if start.target not in system.states:
        return
    state = system.states[start.target]
    if closed_at(state.closed, start.arrives, start.arrives):
        what = f"robots come to '{start.target}' at step {start.arrives}, when it is closed"
        yield Fault(path, what, "let them arrive when it is open, or open it then")
    if missing := ", ".join(sorted(state.needs - group.capabilities)):
        what = f"class '{group.class_name}' comes to '{start.target}', which needs {missing}"
        yield Fault(path, what, f"give the class the capability {missing}")


_STEP = Range(1, MOST_STEPS, whole=True)


def _start_faults(entries: Sequence[Entry], system: TransitionSystem) -> Iterator[Fault]:
    """Start states that are none, that a class may not be at, or where more start than fit."""
    closest = Nearest(system.states)
    starting: Counter[_Where] = Counter()
    last: dict[_Where, Place] = {}
    for place, group in entries:
        for name, count in group.starts:
            path = (*place, "at", name)
            state = system.states.get(name)
            starting[name] += count
            last[name] = path
            if state is None:
                yield Fault(path, f"the map has no state '{name}'", closest(name))
            elif closed_at(state.closed, 0, 0):
                what = f"'{name}' is closed at step 0, and {count} robots start there"
                yield Fault(path, what, "start elsewhere or open it then")
            elif missing := ", ".join(sorted(state.needs - group.capabilities)):
                what = f"class '{group.class_name}' may not be at '{name}', which needs {missing}"
                yield Fault(
                    path, what, f"start elsewhere or give the class the capability {missing}"
                )
    for place, group in entries:
        for start, count in group.coming:
            way = start.origin, start.target
            starting[way] += count
            last[way] = (*place, "at", start.label)
    for members, capacity, words, which in _bounded(system):
        inside = [where for where in members if starting[where]]
        count = sum(starting[where] for where in inside)
        if count > capacity:
            what = f"{count} robots start {words}, which holds {capacity}"
            remedy = f"start some of them elsewhere or raise the {which}'s capacity"
            yield Fault(last[inside[-1]], what, remedy)


_Where: TypeAlias = "str | tuple[str, str]"
"""A state, or an edge by its ends."""


def _bounded(system: TransitionSystem) -> Iterator[tuple[list[_Where], int, str, str]]:
    """Places that hold so many robots together, in words, and what kind of place that is."""
    for name, state in system.states.items():
        if state.capacity is not None:
            yield [name], state.capacity, f"at '{name}'", "state"
    for capacity, pairs in system.capacity_groups:
        source, target = pairs[0]
        yield [*pairs], capacity, f"on the edge from '{source}' to '{target}'", "edge"
    for zone, parts in system.zone_parts.items():
        yield [*parts.states, *parts.edges], system.zones[zone], f"in the zone '{zone}'", "zone"


def _class_faults(entries: Sequence[Entry]) -> Iterator[Fault]:
    """Entries of one class that differ in their capabilities (a warning)."""
    first: dict[str, Group] = {}
    for place, group in entries:
        known = first.setdefault(group.class_name, group)
        if known.capabilities != group.capabilities:
            what = (
                f"class '{group.class_name}' has other capabilities here than in an earlier entry"
            )
            remedy = "both are kept apart; give them different class names if that is meant"
            yield Fault((*place, "capabilities"), what, remedy, serious=False)


def map_faults(system: TransitionSystem, team: Sequence[Group]) -> Iterator[Fault]:
    """Durations and costs that the map gives to classes the team does not have (warnings)."""
    classes = {group.class_name for group in team} | {"default"}
    unknown: dict[str, str] = {}
    for edge in system.edges.values():
        if isinstance(edge.duration, Mapping):
            for name in edge.duration:
                if name not in classes:
                    unknown.setdefault(name, f"{edge.source} to {edge.target}")
    for name, where in unknown.items():
        what = f"the map gives a duration to class '{name}' (edge {where}), which the team lacks"
        yield Fault(("map",), what, nearest(name, classes - {"default"}), serious=False)


# --- swarms ----------------------------------------------------------------------------------


def _swarm_faults(entries: Sequence[Entry], rules: SwarmRules) -> Iterator[Fault]:
    """Names that repeat, rules without a swarm, and what makes every plan impossible (warnings)."""
    classes = Counter(group.class_name for _, group in entries)
    if not rules.each or not rules.each.keys() <= classes.keys():
        remedy = f"give bounds for {', '.join(sorted(classes)) or 'none'}"
        yield Fault(("swarm",), "the rules are not about the swarms", remedy)
        return
    robots = {group.class_name for place, group in entries if place[0] == "team"}
    swarms = [(place, group) for place, group in entries if place[0] != "team"]
    for place, group in swarms:
        name = group.class_name
        if classes[name] > 1:
            what = f"several swarms are called '{name}'"
            if name in robots:
                what = f"a class of the team is called '{name}', as the swarm is"
            yield Fault((*place, "name"), what, "give each a name of its own")
        yield from _impossible(group, rules.each[name], place)
    begin = sum(len(group.starts) + len(group.coming) for _, group in swarms)
    if rules.together is not None and begin > rules.together:
        what = f"the swarms start in {begin} places, and together only {rules.together} are allowed"
        yield Fault(("max_subswarms",), what, _HOPELESS, serious=False)


_HOPELESS = "no plan is possible; raise the bound or start together"


def _impossible(group: Group, bounds: SwarmBounds, place: Place) -> Iterator[Fault]:
    """Bounds that the start already breaks."""
    most, least = bounds.most, bounds.least
    if least > group.count:
        what = f"a sub-swarm needs {least:,} agents, and there are {group.count:,} in all"
        remedy = "no plan is possible; lower the bound"
        yield Fault((*place, "min_subswarm"), what, remedy, serious=False)
        return
    for state, count in group.starts:
        if 0 < count < least:
            what = f"{count:,} agents start at '{state}', and a sub-swarm needs {least:,}"
            remedy = "no plan is possible; lower 'min_subswarm' or start together"
            yield Fault((*place, "at", state), what, remedy, serious=False)
    for start, count in group.coming:
        if 0 < count < least:
            what = f"{count:,} agents start {start.words}, and a sub-swarm needs {least:,}"
            remedy = "no plan is possible; lower 'min_subswarm' or start together"
            yield Fault((*place, "at", start.label), what, remedy, serious=False)
    begun = len(group.starts) + len(group.coming)
    if most is not None and begun > most:
        what = f"the swarm starts in {begun} places, and only {most} are allowed"
        yield Fault((*place, "max_subswarms"), what, _HOPELESS, serious=False)
