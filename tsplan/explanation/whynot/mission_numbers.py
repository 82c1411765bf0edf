"""The numbers of a mission that can be changed: where each stands, how it is read and put.

All of them are reached alike, whether they stand in the formula, the team, the map or the bounds of
its swarms, so that what searches for a smallest change knows numbers alone.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Mapping
from dataclasses import dataclass, replace
from fractions import Fraction
from types import MappingProxyType
from typing import TYPE_CHECKING, Any, Literal, NamedTuple, TypeAlias

from tsplan.exact import exact
from tsplan.explanation.whynot.amount_numbers import carried, put_carried, put_stock, stock
from tsplan.explanation.whynot.occurrences import Way, amounts_of, exchanged, node_at
from tsplan.explanation.whynot.posed_mission import own_of, with_own
from tsplan.explanation.whynot.reconfiguration_edits import ACCESS as REBUILDING
from tsplan.explanation.whynot.signal_numbers import ACCESS
from tsplan.logic import Count, Formula, Percent, horizon, translate
from tsplan.logic.text import number_text
from tsplan.ts import Edge, TransitionSystem
from tsplan.ts.waits import with_waits, without_wait
from tsplan.words import many

if TYPE_CHECKING:
    from tsplan.explanation.change_kinds import ChangeKind
    from tsplan.mission import Mission, SwarmRules

Value: TypeAlias = float | Fraction | Percent
Pair: TypeAlias = tuple[str, str]

MOST_STEPS = 60
"""Steps by which a deadline of a short mission is extended at most."""

NumberKind: TypeAlias = Literal[
    "formula",
    "agents",
    "stock",
    "carries",
    "booking",
    "capacity",
    "zone",
    "edge",
    "rebuild",
    "site",
    "closed",
    "wait",
    "swarm",
    "side",
    "begin",
    "limit",
    "last",
    "own",
]

MARGIN = ("", "margin")
"""The key of the head-room that every demand is kept away from."""

TOGETHER = ("", "most")
"""The key of the bound on the sub-swarms of all swarms together."""


class Number(NamedTuple):
    """A place in a mission that holds a number.

    The key says which of its kind: of a `formula`, the way to a sub-formula and its field or the
    place of a need; of `agents`, the entry of the team and a state; of a `stock`, the resource and
    a state; of what an entry `carries`, its number and the resource, which is empty for one hold;
    of a `capacity`, a state or the two ends of an edge; of a `zone`, its name; of an `edge`, whose
    duration is meant, these ends; of what is `closed` for a time (1) or not (0), a state or the two
    ends of an edge; of a bound of a `swarm`, its name and which one; of a `wait`, the
    state where there is one (1) or none (0), or nothing for all states at once; of steps to
    `rebuild` structures, the number of the reconfiguration; of a `site` of it, this and the state
    where it can be done (1) or not (0), or nothing more for all states; of `booking`, which is 1
    where agents are booked and 0 where they are shared, nothing; of an `own` constraint, its
    number and which of its ends, or `kept`, which is 1 while it bounds anything. Over signals: of a
    `side` of the bounds of a signal or control, and of where it may `begin`, its name and which end
    (0, 1); of a
    `limit`, its number; of the `last` step of the mission, nothing.
    """

    kind: NumberKind
    key: tuple[Any, ...]

    def get(self, mission: Any) -> Any:
        """The number that stands there now; None where there is no bound."""
        return _ACCESS[self.kind][0](mission, *self.key)

    def put(self, mission: Any, value: Any) -> Any:
        """The mission with another number there; MissionError where that does not fit together."""
        return _ACCESS[self.kind][1](mission, value, *self.key)


def moved(value: Any, steps: int | Fraction) -> Any:
    """A number so many steps further: hundredths of a share, which stay between 0 % and 100 %.

    What a float is written as is moved, not its nearest binary number.

    >>> str(moved(Percent(Fraction(30)), 5)), moved(Fraction(1, 4), -50), moved(3, -1)
    ('35%', Fraction(0, 1), 2)
    >>> moved(0.3, Fraction(-1, 10))
    0.2
    """
    if isinstance(value, Percent):
        return Percent(min(max(value.value + steps, Fraction(0)), Fraction(100)))
    if isinstance(value, Fraction):
        return max(value + Fraction(steps, 100), Fraction(0))
    return float(exact(value) + steps) if isinstance(steps, Fraction) else value + steps


def value_text(value: Any) -> str:
    """A number in words; a share as a percentage."""
    if isinstance(value, float):
        return number_text(value)
    return f"{number_text(float(100 * value))}%" if isinstance(value, Fraction) else str(value)


@dataclass(frozen=True, slots=True)
class Edit:
    """A number of the mission to be moved by 1, 2, ... up to `most`, in steps of `unit`.

    It grows, or shrinks with `sense` -1. `now` is the number as people are told it, `text` what is
    said of the change: `{new}` stands for the new number, `{agents}` for it as one of agents, and
    `{steps}`, `{added}` and `{amount}` for the amount of the change; `text_at_most` is said of the
    largest.
    """

    number: Number
    kind: ChangeKind
    most: int
    text: str
    now: Value = 0
    sense: int = 1
    text_at_most: str = ""
    unit: int | Fraction = 1

    @property
    def whole(self) -> bool:
        """Whether it moves in steps between which there is nothing: agents, pieces, structures."""
        return isinstance(self.unit, int)

    def applied(self, mission: Any, amount: int) -> Any:
        """The mission after the change; MissionError where it would not fit together."""
        now = self.number.get(mission)
        new = moved(now, self.sense * self.unit * amount)
        return self.number.put(mission, new) if amount else mission

    def words(self, amount: int) -> str:
        """The change in words."""
        new = moved(self.now, self.sense * self.unit * amount)
        text = self.text_at_most if self.text_at_most and amount == self.most else self.text
        return text.format(
            new=value_text(new),
            agents=many(new, "agent") if isinstance(new, int) else value_text(new),
            steps=many(amount, "step"),
            added=many(int(self.unit * amount), "agent"),
            amount=number_text(float(self.unit * amount)),
        )


def literal(text: str) -> str:
    """A text in which nothing is filled in."""
    return text.replace("{", "{{").replace("}", "}}")


# --- the formula -------------------------------------------------------------------------------


def with_node(mission: Any, way: Way, node: Formula) -> Any:
    """The mission with another node in its formula, its horizon extended where that needs it."""
    formula = exchanged(mission.formula, {way: node})
    tasks = getattr(mission, "task_interval", None)  # which missions over signals have not
    own = horizon(translate(formula, interval=tasks) if tasks else formula)
    longest = max(mission.horizon, own)
    return replace(mission, formula=formula, text=str(formula), horizon=longest, warnings=())


def _in_formula(mission: Mission, way: Way, field: str | int) -> Any:
    node: Any = node_at(mission.formula, way)
    if isinstance(field, str):
        return getattr(node, field)
    if field >= len(node.needs) and amounts_of(node):
        return node.resources[field - len(node.needs)][1]
    return node.needs[field][1] if node.needs else 0  # a limit without needs lets nobody be there


def _put_in_formula(mission: Any, value: Any, way: Way, field: str | int) -> Any:
    node: Any = node_at(mission.formula, way)
    if isinstance(field, str):
        changed = {field: value, **_weights(node, field)}
        return with_node(mission, way, replace(node, **changed))
    if field >= len(node.needs) and amounts_of(node):
        amounts = list(node.resources)
        place = field - len(node.needs)
        amounts[place] = (amounts[place][0], value)
        return with_node(mission, way, replace(node, resources=tuple(amounts)))
    if not node.needs:
        return with_node(mission, way, Count("max", node.label, None, "<=", value))
    needs = list(node.needs)
    needs[field] = (needs[field][0], value)
    return with_node(mission, way, replace(node, needs=tuple(needs)))


def _weights(node: Any, field: str) -> dict[str, Any]:
    """The weights of a window whose end moves: steps beyond it weigh as much as the nearest."""
    weights = getattr(node, "weights", None)
    if weights is None or field not in ("low", "high"):
        return {}
    return {"weights": lambda step: weights[min(max(step, node.low), node.high) - node.low]}


# --- the team ----------------------------------------------------------------------------------


def _agents(mission: Mission, entry: int, state: str) -> int:
    return dict(mission.team[entry].starts).get(state, 0)


def _put_agents(mission: Mission, value: int, entry: int, state: str) -> Mission:
    """A larger entry, or one entry more if the state is a new one."""
    team = list(mission.team)
    group = team[entry]
    starts = dict(group.starts)
    new = {**starts, state: value} if state in starts else {state: value}
    made = replace(group, starts=tuple(new.items()))
    if state not in starts:
        made = replace(made, coming=())
    team[entry:] = [made, *team[entry + 1 :]] if state in starts else [*team[entry:], made]
    return replace(mission, team=tuple(team), warnings=())


def _booked(mission: Mission) -> int:
    return int(mission.books)


def _put_booked(mission: Mission, value: int) -> Mission:
    """Agents that are shared, or booked as they are."""
    booking = mission.booking if value else "shared"
    return replace(mission, booking=booking, warnings=())


# --- the map -----------------------------------------------------------------------------------


def remapped(
    system: TransitionSystem, names: Iterable[str | Pair], change: Callable[[Any], Any]
) -> TransitionSystem:
    """The map with states, by name, and edges, by their ends, changed.

    Where both directions of an edge were written as one, both are changed.
    """
    chosen = set(names)
    shared = {pair for pair, edge in system.edges.items() if pair in chosen and edge.both_ways}
    chosen |= {pair[::-1] for pair in shared}
    states = [change(item) if item.name in chosen else item for item in system.states.values()]
    edges = [change(item) if item.pair in chosen else item for item in system.edges.values()]
    return system.rebuilt(states, edges)


def _on_map(mission: Mission, *ends: str) -> Any:
    """A state by its name, or an edge by its ends."""
    system = mission.system
    return system.states[ends[0]] if len(ends) == 1 else system.edges[ends[0], ends[1]]


def _put_on_map(mission: Mission, ends: Any, change: Callable[[Any], Any]) -> Mission:
    system = remapped(mission.system, [ends[0] if len(ends) == 1 else ends], change)
    return replace(mission, system=system, warnings=())


def _capacity(mission: Mission, *ends: str) -> Any:
    return _on_map(mission, *ends).capacity


def _put_capacity(mission: Mission, value: int, *ends: str) -> Mission:
    return _put_on_map(mission, ends, lambda item: replace(item, capacity=value))


def _room(mission: Mission, zone: str) -> int:
    return mission.system.zones[zone]


def _put_room(mission: Mission, value: int, zone: str) -> Mission:
    zones = {**mission.system.zones, zone: value}
    return replace(mission, system=replace(mission.system, zones=zones), warnings=())


def _duration(mission: Mission, *ends: str) -> Any:
    """Steps that an edge takes, of its slowest class."""
    duration = _on_map(mission, *ends).duration
    return max(duration.values()) if isinstance(duration, Mapping) else duration


def _closed(mission: Mission, *ends: str) -> int:
    return int(bool(_on_map(mission, *ends).closed))


def _put_closed(mission: Mission, value: int, *ends: str) -> Mission:
    """The map where a state or an edge is never closed, in both directions if it goes both ways."""
    return _put_on_map(mission, ends, lambda part: part if value else replace(part, closed=()))


def _put_duration(mission: Mission, value: int, *ends: str) -> Mission:
    """The edge by as many steps quicker for all classes, but takes one at least."""
    less = _duration(mission, *ends) - value

    def quicker(edge: Edge) -> Edge:
        if isinstance(edge.duration, Mapping):
            each = {name: max(steps - less, 1) for name, steps in edge.duration.items()}
            return replace(edge, duration=each)
        return replace(edge, duration=max(edge.duration - less, 1))

    return _put_on_map(mission, ends, quicker)


def _waits(mission: Mission, *state: str) -> int:
    return int(not {*without_wait(mission.system)} & {*(state or mission.system.states)})


def _put_waits(mission: Mission, value: int, *state: str) -> Mission:
    """Edges from states to themselves where there are none yet; none is ever taken away."""
    wanted = state or tuple(mission.system.states)
    missing = [name for name in without_wait(mission.system) if value and name in wanted]
    return replace(mission, system=with_waits(mission.system, missing), warnings=())


# --- bounds of swarms --------------------------------------------------------------------------


def _bound(mission: Mission, name: str, which: str) -> Any:
    rules = mission.swarm
    if rules is None or not name:
        return rules and (rules.margin if which == "margin" else rules.together)
    return getattr(rules.each[name], which)


def with_bound(rules: SwarmRules, value: Any, name: str, which: str) -> SwarmRules:
    """The rules with another number of sub-swarms, least size, or head-room."""
    if not name:
        return replace(rules, **{"margin" if which == "margin" else "together": value})
    bounds = replace(rules.each[name], **{which: value})
    return replace(rules, each={**rules.each, name: bounds})


def _put_bound(mission: Mission, value: Any, name: str, which: str) -> Mission:
    rules = mission.swarm and with_bound(mission.swarm, value, name, which)
    return replace(mission, swarm=rules, warnings=())


# --- own constraints ----------------------------------------------------------------------------


def _own(mission: Mission, number: int, end: str) -> Any:
    item = own_of(mission)[number]
    return int(item.bounds) if end == "kept" else getattr(item, end)


def _put_own(mission: Mission, value: Any, number: int, end: str) -> Mission:
    every = list(own_of(mission))
    item = every[number]
    if end == "kept":
        every[number] = item if value else item.unbounded()
    else:
        every[number] = replace(item, **{end: value})
    return with_own(mission, every)


_ACCESS: Mapping[str, tuple[Callable[..., Any], Callable[..., Mission]]] = MappingProxyType(
    {
        "formula": (_in_formula, _put_in_formula),
        "agents": (_agents, _put_agents),
        "stock": (stock, put_stock),
        "carries": (carried, put_carried),
        "booking": (_booked, _put_booked),
        "capacity": (_capacity, _put_capacity),
        "zone": (_room, _put_room),
        "edge": (_duration, _put_duration),
        "closed": (_closed, _put_closed),
        "wait": (_waits, _put_waits),
        **REBUILDING,
        "swarm": (_bound, _put_bound),
        "own": (_own, _put_own),
        **ACCESS,
    }
)
