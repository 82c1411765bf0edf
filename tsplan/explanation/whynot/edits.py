"""Ways to make a mission easier step by step, each by moving one of its numbers.

Which may help against a conflict: those that touch one of its parts.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping
from itertools import pairwise
from math import ceil
from types import MappingProxyType
from typing import TYPE_CHECKING, Any

from tsplan.explanation.explanation import SoftConstraint
from tsplan.explanation.part_words import closed_words, ends_words, own_title, room_of, room_words
from tsplan.explanation.whynot.amount_edits import (
    lower_amount,
    more_carried,
    more_stock,
    stocked,
)
from tsplan.explanation.whynot.mission_numbers import (
    MARGIN,
    MOST_STEPS,
    TOGETHER,
    Edit,
    Number,
    Value,
    literal,
)
from tsplan.explanation.whynot.occurrences import (
    Occurrence,
    Way,
    counts_of,
    node_at,
    nodes_along,
    occurrences,
    separable,
)
from tsplan.explanation.whynot.posed_mission import own_of
from tsplan.explanation.whynot.reconfiguration_edits import numbers_of
from tsplan.explanation.whynot.relaxing import modules_of, useful_number
from tsplan.explanation.whynot.soft_constraints import (
    BOOKING,
    WAITING,
    occurrence_of,
    of_occurrence,
)
from tsplan.logic import Eventually, Percent, Task, Until
from tsplan.logic import labels as labels_of
from tsplan.run.own_terms import reach
from tsplan.ts.waits import without_wait

if TYPE_CHECKING:
    from tsplan.explanation.explanation import PartKind
    from tsplan.explanation.whynot.context import Context
    from tsplan.mission import Mission
    from tsplan.signals.result_check import AnyMission
    from tsplan.ts.closures import Closed

MOST_PLACES = 6
"""States at which more robots are tried, for each entry of the team, and at which waits are."""

MOST_EDGES = 12
"""Edges that are tried, those on quickest ways first."""

_BEYOND = {">=": 0, ">": 1, "<=": 0, "<": -1}
"""What a relation adds to its bound: `> 2` asks for 3 agents, `< 2` allows 1."""


def touched(mission: Mission, number: Number) -> frozenset[SoftConstraint]:
    """What an edit of a number weakens at most.

    If the mission cannot be met even without that, the edit does not help.
    """
    kind, key = number
    if kind == "formula":
        way, field = key
        parts = occurrences(mission.formula, way)
        if isinstance(field, int) and separable(node_at(mission.formula, way)):
            parts = (Occurrence(way, field),)
        return frozenset(map(of_occurrence, parts))
    if kind == "agents":
        kinds: tuple[PartKind, ...] = ("team", "start") if number.get(mission) == 0 else ("team",)
        return frozenset(SoftConstraint(name, key[:1]) for name in kinds)
    if kind in ("stock", "carries", "own"):
        return frozenset({SoftConstraint(kind, key[:1])})
    if kind in ("wait", "booking"):
        return frozenset({WAITING if kind == "wait" else BOOKING})
    part = SoftConstraint(kind if kind in ("capacity", "zone") else "swarm", key)
    return frozenset() if kind in ("edge", "rebuild", "site", "closed") else frozenset({part})


def rank(mission: Mission, number: Number) -> int:
    """More agents of one entry are only tried where those of a smaller rank do not help.

    They are added where it starts (0), where others do (1), or elsewhere (2).
    """
    if number.kind != "agents" or number.get(mission):
        return 0
    return 1 if any(number.key[1] in dict(group.starts) for group in mission.team) else 2


def candidates(context: Context, conflict: frozenset[SoftConstraint]) -> list[Edit]:
    """Everything that can be tried against one conflict, each once."""
    found: dict[Edit, None] = {}
    for constraint in sorted(conflict, key=repr):
        found.update(dict.fromkeys(_against(context, constraint, conflict)))
    if context.mission.modular:
        found.update(dict.fromkeys(_rebuilding(context.mission, conflict)))
    return [edit for edit in found if edit.most > 0]


def _against(
    context: Context, constraint: SoftConstraint, conflict: frozenset[SoftConstraint]
) -> Iterator[Edit]:
    kind, key = constraint
    match kind:
        case "formula":
            yield from _in_formula(context, occurrence_of(constraint))
            yield from _openings(context.mission)
        case "team" | "start":
            yield from _more_agents(context, key[0], conflict)
            if kind == "start":
                yield from _quicker_edges(context, key[0], conflict)
        case "own" | "carries" | "stock":
            yield from _OF_ONE[kind](context.mission, key[0])
        case "booking":
            yield _shared_agents(context.mission)
        case "waiting":
            yield from _waits(context, conflict)
        case "swarm":
            yield _looser_bound(context.mission, key)
        case "capacity" | "zone":
            yield _more_capacity(context.mission, Number(kind, key))


# --- the formula -------------------------------------------------------------------------------


def _in_formula(context: Context, part: Occurrence) -> Iterator[Edit]:
    """Edits of a part of the formula, the least intrusive first, and of the deadlines above it."""
    mission = context.mission
    was = literal(context.wording.whole(part.way))
    above = [way for way, _ in nodes_along(mission.formula, part.way[:-1])]
    yield from deadline(mission, part.way, was)
    yield from _counted(mission, part, was)
    yield from _shorter_task(mission, part.way, was)
    for way in above:
        yield from deadline(mission, way, was)


def deadline(mission: AnyMission, way: Way, was: str) -> Iterator[Edit]:
    """The end of the window of an eventuality or an until, moved later."""
    node = node_at(mission.formula, way)
    if isinstance(node, Eventually | Until):
        most = max(mission.horizon, MOST_STEPS)
        text = f"extend the deadline {node.high} to {{new}} ({{steps}} later) in {was}"
        yield Edit(Number("formula", (way, "high")), "extend_deadline", most, text, node.high)


def _shorter_task(mission: Mission, way: Way, was: str) -> Iterator[Edit]:
    """A task that lasts less long."""
    node = node_at(mission.formula, way)
    if isinstance(node, Task):
        most = node.left - (mission.task_interval == "half-open")
        text = f"shorten the task from {node.duration} to {{new}} steps in {was}"
        number = Number("formula", (way, "duration"))
        yield Edit(number, "shorten_task", most, text, node.duration, -1)


def _counted(mission: Mission, part: Occurrence, was: str) -> Iterator[Edit]:
    """Fewer agents asked for, or more allowed; of a percentage, hundredths."""
    node = node_at(mission.formula, part.way)
    counts = counts_of(node)
    if (part.need or 0) >= len(counts):
        yield from lower_amount(mission, part, was)
        return
    if counts[part.need or 0].relation not in _BEYOND:
        return
    count = counts[part.need or 0]
    asks, label, who = count.relation in (">=", ">"), literal(count.label), count.capability
    number = Number("formula", (part.way, "bound" if node is count else part.need or 0))
    now: Value
    if isinstance(count.bound, Percent):
        now, counted_for = count.bound, ""
        most = ceil(now.value if asks else 100 - now.value)
    else:
        now = count.bound + _BEYOND[count.relation]
        counted_for = literal(f" with {who}" if who else "")
        most = now if asks else mission.size - max(now, 0)
    change = f"at '{label}' from {now} to {{agents}}{counted_for} in {was}"
    if asks:
        nobody = f"ask for no {literal(who or 'agents')} at '{label}' in {was}"
        yield Edit(number, "lower_need", most, f"lower the need {change}", now, -1, nobody)
    else:
        yield Edit(number, "loosen_limit", most, f"loosen the limit {change}", now)


# --- the team and the map ----------------------------------------------------------------------


def _more_agents(
    context: Context, entry: int, conflict: frozenset[SoftConstraint]
) -> Iterator[Edit]:
    """More robots like those of one entry of the team, where it starts or elsewhere."""
    mission = context.mission
    group = mission.team[entry]
    modules = modules_of(mission, group)
    most = useful_number(mission, entry) // modules
    own = [state for state, *_ in group.begins]
    others = [state for other in mission.team for state, *_ in other.begins]
    lying = stocked(mission) if group.carries else []
    open_ = [
        state
        for state in dict.fromkeys([*own, *others, *lying, *_states_of(mission, conflict)])
        if mission.system.states[state].needs <= mission.modular.structures(group).capabilities
    ]
    for state in open_[:MOST_PLACES]:
        text = f"add {{added}} of class {literal(group.class_name)} at '{literal(state)}'"
        yield Edit(Number("agents", (entry, state)), "add_agents", most, text, unit=modules)


def _rebuilding(mission: Mission, conflict: frozenset[SoftConstraint]) -> Iterator[Edit]:
    """Quicker reconfigurations, and more places for them: where modules start or are needed."""
    starts = (state for group in mission.team for state, *_ in group.begins)
    wanted = (*starts, *_states_of(mission, conflict))
    for kind, key, most, text, now in numbers_of(mission, wanted):
        sense = -1 if kind == "rebuild" else 1
        number = Number("rebuild" if kind == "rebuild" else "site", key)
        yield Edit(number, "reconfigure", most, text, now, sense)


def _shared_agents(mission: Mission) -> Edit:
    """Agents count for everything that is asked at their state."""
    text = f"let agents serve several tasks at once (`booking: shared`, not {mission.booking})"
    return Edit(Number("booking", ()), "share_agents", 1, text, 1, -1)


def _more_capacity(mission: Mission, number: Number) -> Edit:
    """More room at a state, on an edge (in both directions where they share it) or in a zone."""
    now = number.get(mission)
    text = f"raise the capacity of {literal(room_words(number))} from {now} to {{new}}"
    return Edit(number, "loosen_limit" if len(number.key) == 1 else "edge", mission.size, text, now)


def _quicker_edges(
    context: Context, entry: int, conflict: frozenset[SoftConstraint]
) -> Iterator[Edit]:
    """Edges on the quickest ways from where robots start to where the conflict needs them."""
    mission = context.mission
    pools = mission.modular.pools(mission.team)
    shapes = next((pool.shapes for pool in pools if entry in pool.groups), ())
    group = mission.team[entry]
    kinds = [mission.modular.shaped(group, shape) for shape in shapes] or [group]
    pairs: dict[tuple[str, str], None] = {}
    targets = list(dict.fromkeys(_states_of(mission, conflict)))
    lying = stocked(mission) if any(kind.carries for kind in kinds) else []
    for origin in dict.fromkeys([*(state for state, *_ in group.begins), *lying, *targets]):
        for target in targets:
            for kind in kinds:
                pairs.update(dict.fromkeys(pairwise(context.way(kind, origin, target))))
    for pair in list(pairs)[:MOST_EDGES]:
        number = Number("edge", pair)
        longest = number.get(mission)
        alike = isinstance(mission.system.edges[pair].duration, int)
        was = f" (now {longest})" if alike else ""
        text = f"cross {literal(ends_words(pair))}{was} in {{steps}} less"
        yield Edit(number, "edge", longest - 1, text, longest, -1)


def _openings(mission: Mission) -> Iterator[Edit]:
    """States and edges that are closed for a time, never closed; those first that close first."""
    system = mission.system
    places: list[tuple[Closed, tuple[str, ...]]] = [
        (state.closed, (state.name,)) for state in system.states.values() if state.closed
    ]
    places += [
        (edge.closed, edge.pair)
        for edge in system.edges.values()
        if edge.closed and not (edge.both_ways and edge.source > edge.target)
    ]
    soon = sorted(each for each in places if each[0][0][0] <= mission.horizon)
    for closed, ends in soon[:MOST_EDGES]:
        text = literal(f"open {ends_words(ends)}, which is closed {closed_words(closed)}")
        yield Edit(Number("closed", ends), "edge", 1, text, 1, -1)


def _waits(context: Context, conflict: frozenset[SoftConstraint]) -> Iterator[Edit]:
    """Waits at single states: where the conflict needs somebody, at ends, at starts; and at all."""
    mission = context.mission
    missing = without_wait(mission.system)
    ends = (name for name in missing if not mission.system.leaving(name))
    starts = (state for group in mission.team for state, *_ in group.begins)
    ordered = dict.fromkeys([*_states_of(mission, conflict), *ends, *starts, *missing])
    for state in [name for name in ordered if name in set(missing)][:MOST_PLACES]:
        text = literal(f"let agents wait at '{state}' (an edge from '{state}' to itself)")
        yield Edit(Number("wait", (state,)), "waiting", 1, text)
    text = "let agents wait at every state (`waiting: true` in the map)"
    yield Edit(Number("wait", ()), "waiting", 1, text)


def _looser_own(mission: Mission, number: int) -> Iterator[Edit]:
    """An own constraint with other bounds, of real numbers without any alone; and without it."""
    item = own_of(mission)[number]
    title, about = literal(own_title(item)), literal(item.sum)
    least, most = reach(item, mission.size)
    if all(term.whole for term, _ in item.terms):
        if item.lower is not None:
            text = f"ask for {about} >= {{new}} (now {item.lower}) in {title}"
            lower = Number("own", (number, "lower"))
            far = int(item.lower - least)
            yield Edit(lower, "loosen_constraint", far, text, item.lower, -1)
        if item.upper is not None:
            text = f"allow {about} <= {{new}} (now {item.upper}) in {title}"
            far = int(most - item.upper)
            yield Edit(Number("own", (number, "upper")), "loosen_constraint", far, text, item.upper)
    text = f"drop {title}: {literal(str(item))}"
    yield Edit(Number("own", (number, "kept")), "drop_constraint", 1, text, 1, -1)


def _states_of(mission: Mission, conflict: frozenset[SoftConstraint]) -> Iterator[str]:
    """The states that the needs of a conflict speak about; limits need nobody."""
    for constraint in sorted(conflict, key=repr):
        if constraint.kind == "formula":
            node = node_at(mission.formula, occurrence_of(constraint).way)
            if not any(count.relation == "<=" for count in counts_of(node)):
                for label in sorted(labels_of(node)):
                    yield from mission.system.labels[label]


# --- bounds of swarms --------------------------------------------------------------------------


def _looser_bound(mission: Mission, key: tuple[str, str]) -> Edit:
    """More sub-swarms, smaller ones, or less head-room (in agents, or hundredths of the swarm)."""
    assert mission.swarm is not None
    number = Number("swarm", key)
    now = number.get(mission)
    name, which = key
    if key == MARGIN:
        new = "{agents}" if isinstance(now, int) else "{new}"
        most = now if isinstance(now, int) else ceil(100 * now)
        text = f"lower the margin from {room_of(now)} to {new}"
        return Edit(number, "lower_need", most, text, now, -1)
    whose = f" of swarm '{literal(name)}'" if len(mission.swarm.each) > 1 else ""
    if which == "least":
        text = f"lower min_subswarm{whose} from {now} to {{new}}"
        return Edit(number, "loosen_limit", now - 1, text, now, -1)
    whose = " of all swarms together" if key == TOGETHER else whose
    most = swarm_size(mission, name) - (now or 0)
    text = f"raise max_subswarms{whose} from {now} to {{new}}"
    return Edit(number, "more_subswarms", most, text, now)


_OF_ONE: Mapping[PartKind, Callable[[Mission, Any], Iterator[Edit]]] = MappingProxyType(
    {"own": _looser_own, "carries": more_carried, "stock": more_stock}
)
"""Ways to make one thing of a mission easier, which is told by its number or name."""


def swarm_size(mission: Mission, name: str) -> int:
    """The agents of a swarm; of all swarms together for the empty name."""
    assert mission.swarm is not None
    names = {name} if name else set(mission.swarm.each)
    return sum(group.count for group in mission.team if group.class_name in names)
