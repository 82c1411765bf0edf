"""What has to fit together in a mission: team and map, formula and map, objective, horizon.

Every check returns problems that name their place as a path in a mission file or as a node of
the formula; who reads a file turns them into findings with lines and columns.
"""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass, replace
from typing import TYPE_CHECKING

from tsplan.errors import FormulaError, Nearest, nearest
from tsplan.limits import MOST_ROBOTS, MOST_STEPS
from tsplan.mission.costs import cost_problems
from tsplan.mission.findings import FORMULA, Entry, Place, Problem, preferred
from tsplan.mission.magnitudes import number_problems
from tsplan.mission.mission import SwarmRules, TaskInterval
from tsplan.mission.objectives import OBJECTIVES, objectives_for
from tsplan.mission.swarm_rules import ONE_SWARM, swarm_problems

if TYPE_CHECKING:
    from tsplan.logic import Formula
    from tsplan.logic.text_spans import Way
    from tsplan.mission.mission import Group, Mission, Preference
    from tsplan.ts import TransitionSystem

LABEL: Way = ("label",)


def problems_of(mission: Mission) -> list[Problem]:
    """Everything that does not fit together in a mission."""
    numbers = number_problems(mission)
    if numbers:
        return numbers  # with numbers that are none, nothing else can be judged
    return [
        *objective_problems(mission.objective, mission.swarm),
        *wish_problems(mission.objective, mission.prefer, mission.swarm),
        *team_problems(entries_of(mission), mission.system, mission.swarm),
        *map_problems(mission.system, mission.team),
        *cost_problems(mission.system, mission.team, mission.horizon, mission.objective),
        *formula_problems(mission.formula, mission.system, mission.team, mission.swarm),
        *horizon_problems(mission.formula, mission.task_interval, mission.horizon),
        *(
            problem
            for number, wish in enumerate(mission.prefer)
            for problem in preferred_problems(wish, number, mission)
        ),
    ]


def preferred_problems(wish: Preference, number: int, mission: Mission) -> list[Problem]:
    """What does not fit in a preferred formula of a mission."""
    found = [
        *formula_problems(wish.formula, mission.system, mission.team, mission.swarm),
        *horizon_problems(wish.formula, mission.task_interval, mission.horizon),
    ]
    return moved(found, preferred(number))


def moved(problems: Iterable[Problem], place: Place) -> list[Problem]:
    """Problems of a formula that stands elsewhere than the mission's own."""
    return [replace(item, path=place) if item.path == FORMULA else item for item in problems]


def wish_problems(
    objective: Sequence[str], prefer: Sequence[Preference], swarm: SwarmRules | None
) -> list[Problem]:
    """Objectives about what holds that are out of place, and preferences of one name."""
    problems = []
    for place, name in enumerate(objective):
        path: Place = ("objective", place)
        if place and name in OBJECTIVES and OBJECTIVES[name].first:
            what = f"'{name}' comes after other objectives"
            problems.append(Problem(path, what, "name it first: it is settled first"))
        if name == "preferences" and not prefer:
            what = "'preferences' are an objective and none are there"
            problems.append(Problem(path, what, "add 'prefer: [...]' to the spec"))
        if name == "satisfaction" and swarm is not None and swarm.margin:
            what = "a margin is head-room of what must hold, and nothing must hold wholly"
            problems.append(Problem(path, what, "remove 'margin', or write it into the counts"))
        if name == "satisfaction" and prefer:
            what = "what must hold cannot hold in part"
            remedy = "remove 'satisfaction', and prefer with 'partial: true' what may"
            problems.append(Problem(path, what, remedy))
    names = [wish.name for wish in prefer]
    for number, name in enumerate(names):
        if name in names[:number]:
            path = ("spec", "prefer", number, "name")
            problems.append(Problem(path, f"two preferences are called '{name}'", "rename one"))
    return problems


def objective_problems(objective: Sequence[str], swarm: SwarmRules | None) -> list[Problem]:
    """Unknown and repeated objectives, and those of swarms where there is none."""
    known = objectives_for(swarms=swarm is not None)
    problems = []
    for place, name in enumerate(objective):
        path = ("objective", place)
        if name in OBJECTIVES and name not in known:
            what = f"objective '{name}' is for swarms, and this mission is for a team"
            problems.append(Problem(path, what, f"use {', '.join(known)}"))
        elif name not in known:
            problems.append(Problem(path, f"unknown objective '{name}'", nearest(name, known)))
        elif name in objective[:place]:
            problems.append(Problem(path, f"objective '{name}' is named twice", "remove one"))
    return problems


def team_problems(
    entries: Sequence[Entry], system: TransitionSystem | None, swarm: SwarmRules | None
) -> list[Problem]:
    """Counts, classes and start states; without a map, only what does not need it."""
    problems: list[Problem] = []
    if not entries:
        problems.append(Problem(("team",), "the team is empty", "add at least one robot"))
    closest = Nearest(() if system is None else system.states)
    for place, group in entries:
        if not group.starts:
            problems.append(Problem((*place, "at"), "no start state", "say where the robots start"))
        for state, count in group.starts:
            if count < 1:
                problems.append(
                    Problem(
                        (*place, "at", state),
                        f"{count} robots at '{state}'",
                        "a count is a whole number of at least 1",
                    )
                )
            if system is not None:
                problems += _start_problems(system, group, (*place, "at", state), closest)
    size = sum(group.count for _, group in entries)
    if size > MOST_ROBOTS:
        path, remedy = entries[0][0][:1], f"at most {MOST_ROBOTS:,} are planned"
        problems.append(Problem(path, f"a team of {size:,} robots", remedy))
    if system is not None:
        problems += _crowds(entries, system)
    problems += _differing([entry for entry in entries if entry[0][0] == "team"])
    return problems + ([] if swarm is None else swarm_problems(entries, swarm))


def entries_of(mission: Mission) -> list[Entry]:
    """The groups of a mission with the places that a mission file has for them."""
    swarms = () if mission.swarm is None else mission.swarm.each
    made: dict[str, list[Entry]] = {"team": [], "swarms": []}
    for group in mission.team:
        kind = "swarms" if group.class_name in swarms else "team"
        made[kind].append(((kind, len(made[kind])), group))
    if [group.class_name for _, group in made["swarms"]] == [ONE_SWARM]:
        made["swarms"] = [(("swarm",), group) for _, group in made["swarms"]]
    return made["team"] + made["swarms"]


def _start_problems(
    system: TransitionSystem, group: Group, path: Place, closest: Nearest
) -> list[Problem]:
    state = str(path[-1])
    if state not in system.states:
        return [Problem(path, f"the map has no state '{state}'", closest(state))]
    missing = sorted(system.states[state].needs - group.capabilities)
    if not missing:
        return []
    needed = ", ".join(missing)
    return [
        Problem(
            path,
            f"class '{group.class_name}' may not be at '{state}', which needs {needed}",
            "start elsewhere"
            + (f" or give the class the capability {needed}" if path[0] == "team" else ""),
        )
    ]


def _crowds(entries: Sequence[Entry], system: TransitionSystem) -> list[Problem]:
    """States at which more robots start than fit."""
    starting: Counter[str] = Counter()
    last: dict[str, Place] = {}
    for place, group in entries:
        for state, count in group.starts:
            starting[state] += count
            last[state] = (*place, "at", state)
    problems = []
    for state, count in starting.items():
        capacity = system.states[state].capacity if state in system.states else None
        if capacity is not None and count > capacity:
            problems.append(
                Problem(
                    last[state],
                    f"{count} robots start at '{state}', which holds {capacity}",
                    "start some of them elsewhere or raise the state's capacity",
                )
            )
    return problems


def _differing(entries: Sequence[Entry]) -> list[Problem]:
    """Entries of one class that differ in their capabilities (a warning)."""
    first: dict[str, Group] = {}
    problems = []
    for place, group in entries:
        known = first.setdefault(group.class_name, group)
        if known.capabilities != group.capabilities:
            problems.append(
                Problem(
                    (*place, "capabilities"),
                    f"class '{group.class_name}' has other capabilities here than in an earlier "
                    "entry",
                    "both are kept apart; give them different class names if that is meant",
                    serious=False,
                )
            )
    return problems


def map_problems(system: TransitionSystem, team: Sequence[Group]) -> list[Problem]:
    """Durations and costs that the map gives to classes the team does not have (warnings)."""
    classes = {group.class_name for group in team} | {"default"}
    unknown: dict[str, str] = {}
    for edge in system.edges.values():
        if isinstance(edge.duration, Mapping):
            for name in edge.duration:
                if name not in classes:
                    unknown.setdefault(name, f"{edge.source} to {edge.target}")
    return [
        Problem(
            ("map",),
            f"the map gives a duration to class '{name}' (edge {where}), which the team lacks",
            nearest(name, classes - {"default"}),
            serious=False,
        )
        for name, where in unknown.items()
    ]


def formula_problems(
    formula: Formula,
    system: TransitionSystem | None,
    team: Iterable[Group] | None,
    swarm: SwarmRules | None,
) -> list[Problem]:
    """Labels, capabilities and kinds of atoms, as far as map and team are known."""
    from tsplan import logic  # noqa: PLC0415  (the parser is slow to import)

    places = Nearest(() if system is None else {*system.labels, *system.states})
    names = None if team is None else _Names.of(team, swarm)
    problems: list[Problem] = []
    for node in logic.walk(formula):
        problems += _refused(node)
        problems += _percentages(node) if swarm is None and team is not None else []
        if isinstance(node, logic.Count | logic.Task | logic.Limit):
            problems += [] if system is None else _unplaced(node, node.label, system, places)
            problems += [] if names is None else names.problems(node)
    return problems


def _unplaced(
    node: Formula, label: str, system: TransitionSystem, closest: Nearest
) -> list[Problem]:
    """A label of no state, or (a warning) one that is the name of a state without it."""
    state = system.states.get(label)
    if label not in system.labels and state is None:
        what = f"no state of the map has the label '{label}'"
        return [Problem(FORMULA, what, closest(label), node=node, way=LABEL)]
    if state is None or label not in system.labels or label in state.labels:
        return []
    carriers = ", ".join(system.labels[label][:3])
    what = f"'{label}' is the label of {carriers}, and also the name of a state without it"
    remedy = "the label is meant; give the state a label of its own to count there"
    return [Problem(FORMULA, what, remedy, serious=False, node=node, way=LABEL)]


@dataclass(frozen=True)
class _Names:
    """What atoms may name: capabilities, and the classes of robots and swarms."""

    capabilities: frozenset[str]
    classes: Mapping[str, frozenset[str]]  # with their capabilities
    robots: bool  # whether there are robots beside swarms, or nothing else
    single: bool  # whether there is nothing but a swarm without a name of its own
    closest: Nearest

    @classmethod
    def of(cls, team: Iterable[Group], swarm: SwarmRules | None) -> _Names:
        classes: dict[str, frozenset[str]] = {}
        for group in team:
            able = classes.get(group.class_name, frozenset())
            classes[group.class_name] = able | group.capabilities
        known: frozenset[str] = frozenset().union(*classes.values())
        robots = swarm is None or not classes.keys() <= swarm.each.keys()
        single = not robots and classes.keys() == {ONE_SWARM}
        return cls(known, classes, robots, single, Nearest(known.union(classes)))

    def problems(self, node: Formula) -> list[Problem]:
        """The names in an atom that nobody has, and those of which one meaning is lost."""
        return [
            self._stranger(node, way, name)
            for way, name in _capabilities(node)
            if name not in self.classes.get(name, self.capabilities)
        ]

    def _stranger(self, node: Formula, way: Way, name: str) -> Problem:
        """A capability that nobody has, or (a warning) one that is the name of other robots."""
        if name in self.capabilities:
            what = f"'{name}' is a capability, and also the name of a class without it"
            remedy = "the capability is meant; call the class something else to count it"
            return Problem(FORMULA, what, remedy, serious=False, node=node, way=way)
        remedy = self.closest(name)
        if self.single:
            remedy = f"leave '{name}' out: the one swarm has no name"
        if not self.robots:
            return Problem(FORMULA, f"there is no swarm '{name}'", remedy, node=node, way=way)
        what = f"no robot has the capability '{name}', so it always counts 0"
        return Problem(FORMULA, what, remedy, serious=False, node=node, way=way)


def _capabilities(node: Formula) -> list[tuple[Way, str]]:
    """The capabilities that an atom itself names, in order, and where."""
    from tsplan import logic  # noqa: PLC0415  (the parser is slow to import)

    if isinstance(node, logic.Task | logic.Limit):
        return [(("needs", number, 0), name) for number, (name, _) in enumerate(node.needs)]
    if isinstance(node, logic.Count) and node.capability is not None:
        return [(("capability",), node.capability)]
    return []


def _refused(node: Formula) -> list[Problem]:
    """Atoms that have a meaning elsewhere but not for a team."""
    from tsplan import logic  # noqa: PLC0415  (the parser is slow to import)

    if isinstance(node, logic.Linear):
        return [
            Problem(
                FORMULA,
                f"'{node}' speaks about signals, and a team has only counts of robots",
                "write what is to be counted, for example sum(A) >= 2 for a label A",
                node=node,
            )
        ]
    if isinstance(node, logic.Task) and node.resources:
        return [
            Problem(
                FORMULA,
                f"'{node}' asks for resources, which are not planned",
                "remove the last braces of the task",
                node=node,
            )
        ]
    return []


def _percentages(node: Formula) -> list[Problem]:
    """Shares of a team, which has none."""
    from tsplan import logic  # noqa: PLC0415  (the parser is slow to import)

    if isinstance(node, logic.Count) and isinstance(node.bound, logic.Percent):
        return [
            Problem(
                FORMULA,
                f"'{node}' asks for a percentage, which only a swarm has",
                "write the number of robots",
                node=node,
            )
        ]
    return []


def horizon_problems(
    formula: Formula, task_interval: TaskInterval, horizon: int | None
) -> list[Problem]:
    """A horizon that is too short to judge the formula."""
    own, problems = formula_horizon(formula, task_interval)
    if own is not None and max(own, horizon or 0) > MOST_STEPS:
        path = FORMULA if own > MOST_STEPS else ("horizon",)
        steps = max(own, horizon or 0)
        problems.append(
            Problem(path, f"a horizon of {steps:,} steps", f"at most {MOST_STEPS:,} are planned")
        )
    elif horizon is not None and own is not None and horizon < own:
        problems.append(
            Problem(
                ("horizon",),
                f"the horizon {horizon} is shorter than the formula's, {own}",
                f"set it to at least {own} or leave it out",
            )
        )
    return problems


def formula_horizon(
    formula: Formula, task_interval: TaskInterval
) -> tuple[int | None, list[Problem]]:
    """The last step the formula speaks about, or why it has no meaning in this interval."""
    from tsplan import logic  # noqa: PLC0415  (the parser is slow to import)

    if task_interval == "half-open":
        empty = [
            Problem(
                FORMULA,
                f"'{node}' is empty when tasks are half-open",
                "give the task a duration of at least 1",
                node=node,
            )
            for node in logic.walk(formula)
            if isinstance(node, logic.Task) and node.duration < 1
        ]
        if empty:
            return None, empty
    try:
        plain = logic.translate(formula, interval=task_interval)
    except FormulaError:
        return None, []  # `formula_problems` names what cannot be translated
    return logic.horizon(plain), []
