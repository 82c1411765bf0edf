"""Small random missions with every operator: of teams, of tasks, of swarms, and of both.

The same seed gives the same mission. Missions are small enough for the reference encoding, with few
agents and steps most of them also for an enumeration of all joint plans; many have no plan.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace
from random import Random
from typing import Any

from tsplan.errors import Finding, MissionError
from tsplan.logic import Formula, Whole, fold, horizon, parse
from tsplan.mission import Group, Mission
from tsplan.ts import Edge, State, TransitionSystem

CAPABILITIES = ("u", "v")
LABELS = ("a", "b", "c")
SWARM = "w"
"""The name of the swarm of a mixed mission, by which its atoms count it."""

_WHOLE = 0.4  # how likely a part counts as a whole
_MOST_TRIES = 1000  # a mission takes about three; where so many do not do, none can be made
_TEAM_OBJECTIVES = (
    ("travel",),
    ("availability",),
    ("availability", "travel"),
    ("cost",),
    ("makespan", "travel"),
    ("agents", "travel"),
    ("availability", "agents", "makespan"),
    ("travel", "makespan"),
)
_SWARM_OBJECTIVES = (
    ("splits", "travel"),
    ("splits",),
    ("travel", "splits"),
    ("moves", "splits"),
    ("balance", "splits"),
    ("splits", "balance", "travel"),
    ("makespan", "splits"),
    (),
)
_MIXED_OBJECTIVES = (
    *_TEAM_OBJECTIVES,
    *_SWARM_OBJECTIVES,
    ("availability", "splits"),
    ("availability", "travel", "splits"),
    ("splits", "availability"),
    ("agents", "splits"),
    ("cost", "moves"),
    ("balance", "agents", "travel"),
)


def random_mission(
    seed: int, *, states: int = 5, most_agents: int = 6, steps: int = 12, mixed: bool = False
) -> Mission:
    """A mission of a team on at most `states` states, whose horizon is at most `steps`.

    A `mixed` one also has a swarm of two to four agents, which atoms count by its name.

    >>> mission = random_mission(3, states=4, most_agents=3)
    >>> len(mission.system.states) <= 4, 1 <= mission.size <= 3, mission.horizon <= 12
    (True, True, True)
    """
    random = Random(seed)

    def draw() -> Mission | None:
        system = random_map(random, random.randint(2, states), strange=random.random() < 0.4)
        text = random_formula(random, random.randint(1, 3))
        if horizon(parse(text, language="mtl")) > steps:
            return None
        names = list(system.states)
        team = _random_team(random, names, most_agents)
        objective = random.choice(_MIXED_OBJECTIVES if mixed else _TEAM_OBJECTIVES)
        swarms = [_random_swarm(random, SWARM, names, random.randint(2, 4))] if mixed else None
        return Mission.of(
            map=system,
            team=team,
            swarms=swarms,
            formula=_with_swarm(random, text) if mixed else text,
            language="mtl",
            objective=objective,
            name=f"random {seed}",
        )

    return _first(draw)


def random_task_mission(seed: int, *, states: int = 5) -> Mission:
    """A mission of a few CaTL tasks and limits, tight enough that many have no plan.

    >>> random_task_mission(7).language
    'catl'
    """
    random = Random(f"tasks {seed}")

    def draw() -> Mission:
        system = random_map(random, random.randint(3, states), strange=random.random() < 0.3)
        names = list(system.states)
        team = [
            Group.of(
                f"k{number}",
                {random.choice(names): random.randint(1, 3)},
                {name for name in CAPABILITIES if random.random() < 0.7},
            )
            for number in range(random.randint(1, 2))
        ]
        parts = [_random_conjunct(random) for _ in range(random.randint(1, 3))]
        return Mission.of(
            map=system,
            team=team,
            formula=parts if len(parts) > 1 and random.random() < 0.3 else " && ".join(parts),
            language="catl",
            objective=["travel"],
            task_interval=random.choice(["closed", "closed", "half-open"]),
            name=f"tasks {seed}",
        )

    return _first(draw)


def random_swarm_mission(seed: int, *, fits: Callable[[Mission], bool] = lambda _: True) -> Mission:
    """A mission of one or two swarms of a few agents on two to four states.

    Missions are drawn until one `fits`, as where only small ones can be enumerated.

    >>> mission = random_swarm_mission(5, fits=lambda mission: mission.size <= 4)
    >>> mission.swarm is not None, mission.size <= 4
    (True, True)
    """
    random = Random(seed)

    def draw() -> Mission | None:
        system = random_map(random, random.randint(2, 4), strange=random.random() < 0.3)
        many = random.random() < 0.3
        text = random_formula(random, 3) if many else random_division(random)
        names = ["u", "v"] if random.random() < 0.4 else ["u"]
        if len(names) == 1:
            text = without_capabilities(text)
        steps = random.randint(2, 5)
        if horizon(parse(text, language="mtl")) > steps:
            return None
        most = 4 if len(names) == 1 else 2
        states = list(system.states)
        swarms = [_random_swarm(random, name, states, None, most) for name in names]
        single = {key: value for key, value in swarms[0].items() if key != "name"}
        objective = random.choice(_SWARM_OBJECTIVES)
        together = random.choice([None, 2, 3]) if len(names) > 1 else None
        return Mission.of(
            map=system,
            swarm=single if len(names) == 1 else None,
            swarms=swarms if len(names) > 1 else None,
            max_subswarms=together,
            formula=text,
            objective=objective,
            horizon=steps,
        )

    return _first(lambda: made if (made := draw()) is not None and fits(made) else None)


def random_map(random: Random, states: int, *, strange: bool) -> TransitionSystem:
    """A map with every label of LABELS; `strange` ones lack waits and have capacities and needs."""
    names = [f"s{number}" for number in range(states)]
    made = {}
    for name in names:
        labels = [label for label in LABELS if random.random() < 0.35]
        capacity = random.choice([None, None, 1, 2]) if strange else None
        needs = ["u"] if strange and random.random() < 0.1 else []
        made[name] = State(name, frozenset(labels), capacity=capacity, needs=frozenset(needs))
    for label in LABELS:
        if not any(label in state.labels for state in made.values()):
            old = made[names[random.randrange(states)]]
            made[old.name] = replace(old, labels=old.labels | {label})
    edges = []
    for source in names:
        if not strange or random.random() < 0.8:
            wait = 1 if not strange or random.random() < 0.8 else 2
            edges.append(Edge(source, source, wait))
        edges += [
            _random_edge(random, source, target, strange=strange)
            for target in names
            if source != target and random.random() < 0.5
        ]
    return TransitionSystem.build(made.values(), edges)


def _random_edge(random: Random, source: str, target: str, *, strange: bool) -> Edge:
    """An edge of one to three steps; a strange one may have a capacity, a cost and two speeds."""
    capacity = random.choice([None, None, 1]) if strange else None
    cost = random.choice([None, None, 0.5, 4.0]) if strange else None
    length = random.randint(1, 3)
    by_class = {"k0": length, "default": 4 - length}
    duration = by_class if strange and random.random() < 0.2 else length
    return Edge(source, target, duration, capacity=capacity, cost=cost)


def random_formula(
    random: Random,
    depth: int,
    atom: Callable[[Random], str] | None = None,
    weights: Callable[[Random, int], str] = lambda _random, _count: "",
) -> str:
    """The text of a formula with all operators, of atoms that count LABELS and CAPABILITIES.

    Others are made by `atom`, and `weights` gives what is written behind an operator of so many
    parts or steps.

    >>> random_formula(Random(4), 2)
    '(G[0,2] (max(a,u) <= 0)) && (a)'
    """
    if depth == 0 or random.random() < 0.2:
        return (atom or _random_atom)(random)
    inner = random_formula(random, depth - 1, atom, weights)
    low = random.randint(0, 2)
    high = low + random.randint(0, 3)
    kind = random.choice(["F", "G", "F", "G", "U", "R", "and", "or", "and", "not", "implies"])
    window = f"[{low},{high}]" + (weights(random, high - low + 1) if kind in "FGUR" else "")
    if kind in "FG":
        return f"{kind}{window} ({inner})"
    if kind == "not":
        return f"!({inner})"
    other = random_formula(random, depth - 1, atom, weights)
    if kind in "UR":
        return f"({other}) {kind}{window} ({inner})"
    if kind == "implies":
        return f"({other}) => ({inner})"
    return f"({other}) {'&&' if kind == 'and' else '||'}{weights(random, 2)} ({inner})"


def wholly(random: Random, formula: Formula) -> Formula:
    """The formula, some of whose parts count as a whole or not at all.

    >>> print(wholly(Random(3), parse("F[0,2] (a && b) || G[0,2] c")))
    F[0,2] all(a, b) || all[0,2] c
    """

    def made(node: Formula, below: tuple[Formula, ...]) -> Formula:
        over = node.over(below)
        return Whole(over) if below and random.random() < _WHOLE else over

    return fold(formula, made)


def random_division(random: Random) -> str:
    """A formula that wants agents at two labels at once, and something else now and then."""
    one, other = random.sample(LABELS, 2)
    need = random.choice(["", "", f"sum({other},u) >= 2 && "])
    low = random.randint(1, 3)
    both = f"F[{low},{low + random.randint(0, 2)}] ({need}{one} && {other})"
    return both if random.random() < 0.5 else f"{both} && ({random_formula(random, 1)})"


def without_capabilities(text: str) -> str:
    """A random formula whose atoms count all agents: a swarm alone has no name to count by."""
    return text.replace(",v", "").replace(",u", "")


def _random_atom(random: Random) -> str:
    """A count, a bare label, or a constant now and then."""
    if random.random() < 0.03:
        return random.choice(["true", "false"])
    label = random.choice(LABELS)
    kind = random.random()
    if kind < 0.2:
        return label
    function = random.choice(["sum", "min", "max"])
    who = random.choice(["", ",u", ",v"])
    relation = random.choice([">=", ">=", "<=", ">", "<", "=", "!="])
    return f"{function}({label}{who}) {relation} {random.randint(0, 2)}"


def _random_conjunct(random: Random) -> str:
    """A task or two, or a limit, in a window; in parentheses."""
    low = random.randint(0, 4)
    window = f"[{low},{low + random.randint(0, 4)}]"
    one, two = _random_task(random), _random_task(random)
    kind = random.choice(("F", "F", "F", "G", "GF", "U", "or", "and"))
    texts = {
        "F": f"F{window} {one}",
        "G": f"G{window} {_random_limit(random)}",
        "GF": f"G[0,{random.randint(1, 3)}] F[0,{random.randint(0, 3)}] {one}",
        "U": f"{_random_limit(random)} U{window} {one}",
        "or": f"F{window} ({one} || {two})",
        "and": f"F{window} ({one} && {two})",
    }
    return f"({texts[kind]})"


def _random_task(random: Random) -> str:
    """A task with one or two needs."""
    duration = random.randint(1, 2)
    names = random.sample(CAPABILITIES, random.randint(1, 2))
    needs = ", ".join(f"({name}, {random.randint(1, 2)})" for name in names)
    return f"T({duration}, {random.choice(LABELS)}, {{{needs}}})"


def _random_limit(random: Random) -> str:
    """A limit on one capability, or on everybody."""
    if random.random() < 0.3:
        return f"L({random.choice(LABELS)}, {{}})"
    return (
        f"L({random.choice(LABELS)}, {{({random.choice(CAPABILITIES)}, {random.randint(0, 1)})}})"
    )


def _random_team(random: Random, states: list[str], most_agents: int) -> list[Group]:
    """Classes `k0`, `k1`, ... of together at most so many agents, each at one state."""
    team: list[Group] = []
    left = random.randint(1, most_agents)
    while left > 0:
        count = random.randint(1, left)
        left -= count
        capabilities = {name for name in CAPABILITIES if random.random() < 0.6}
        team.append(Group.of(f"k{len(team)}", {random.choice(states): count}, capabilities))
    return team


def _random_swarm(
    random: Random, name: str, states: list[str], size: int | None, most: int = 4
) -> dict[str, Any]:
    """A swarm of so many agents at one state, or of a few at one or two."""
    at = {random.choice(states): size or random.randint(1, most)}
    if size is None and random.random() < 0.3:
        at[random.choice(states)] = 1
    return {
        "name": name,
        "size": sum(at.values()),
        "at": at,
        "max_subswarms": random.choice([None, 1, 2, 3]),
        "min_subswarm": random.choice([1, 1, 2]),
    }


def _with_swarm(random: Random, text: str) -> str:
    """A random formula, some of whose atoms count the swarm instead of what they counted."""
    parts = text.split(",u")
    return parts[0] + "".join(random.choice([",u", f",{SWARM}"]) + part for part in parts[1:])


def _first(draw: Callable[[], Mission | None]) -> Mission:
    """The first mission that is one: starts may be over a capacity, or where a class may not be."""
    refused: tuple[Finding, ...] = ()
    for _ in range(_MOST_TRIES):
        try:
            made = draw()
        except MissionError as error:
            refused = error.findings
            continue
        if made is not None:
            return made
    what = f"none of {_MOST_TRIES} missions that were drawn fits"
    raise MissionError([Finding(what, "allow more of them"), *refused])
