"""Families of benchmark missions, made from a seed.

`grid` and `decomposition` follow the recipes of the published CaTL studies; their maps and teams
are drawn anew here from a seed. `scaling` is the project's own: random tasks on larger maps.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass, replace
from random import Random

from tsplan import Mission
from tsplan.mission import Group
from tsplan.ts import Edge, State, TransitionSystem

GRID_FORMULA = (
    "F[0,20] T(1,green,{(IR,2),(Vis,2)}) && G[20,40] F[0,10] T(1,blue,{(UV,1),(Mo,2)})"
    " && F[5,25] T(2,yellow,{(UV,2),(Vis,2)}) && F[3,18] T(2,orange,{(Vis,2)})"
    " && F[20,30] T(2,orange,{(Vis,2)})"
)
DECOMPOSITION_FORMULA = (
    "F[0,10](T(3,A,{(C1,2)}) || T(3,B,{(C1,2),(C2,2)}))"
    " && F[20,40](T(3,C,{(C2,1)}) U[5,10] (T(3,A,{(C1,1),(C2,1)}) && T(3,B,{(C1,1),(C2,1)})))"
)


@dataclass(frozen=True)
class Case:
    """One mission of a family, with the values of the axes it lies on."""

    family: str
    axis: str
    value: float
    seed: int
    mission: Mission


def grid_map(rows: int, columns: int, labels: Sequence[str], random: Random) -> TransitionSystem:
    """A grid with durations 1..3 drawn for each direction, waits, and each label at one state."""
    names = [f"q{row}_{column}" for row in range(rows) for column in range(columns)]
    places = random.sample(names, len(labels))
    label_of = dict(zip(places, labels, strict=True))
    states = [
        State(name, labels=frozenset({label_of[name]} if name in label_of else ()))
        for name in names
    ]
    edges = [Edge(name, name, 1) for name in names]
    for row in range(rows):
        for column in range(columns):
            here = names[row * columns + column]
            for down, right in ((0, 1), (1, 0)):
                if row + down < rows and column + right < columns:
                    there = names[(row + down) * columns + column + right]
                    edges.append(Edge(here, there, random.randint(1, 3)))
                    edges.append(Edge(there, here, random.randint(1, 3)))
    return TransitionSystem.build(states, edges, name=f"grid {rows}x{columns}")


def grid(size: int, seed: int, agents: int = 20, objective: Sequence[str] = ("travel",)) -> Mission:
    """The published grid family: four classes of two capabilities, five tasks, horizon 51."""
    random = Random(f"grid {size} {seed}")
    system = grid_map(size, size, ["green", "yellow", "orange", "blue"], random)
    names = ["UV", "Mo", "Vis", "IR"]
    team = []
    for number, capability in enumerate(names):
        other = random.choice([name for name in names if name != capability])
        start = random.choice(list(system.states))
        team.append(Group.of(f"class{number}", {start: agents // 4}, {capability, other}))
    return mission(f"grid {size} seed {seed}", system, team, GRID_FORMULA, objective)


def decomposition(
    agents: int, seed: int, objective: Sequence[str] = ("availability", "travel")
) -> Mission:
    """The published decomposition formula on a 5x5 grid with three classes of one capability."""
    random = Random(f"decomposition {agents} {seed}")
    system = grid_map(5, 5, ["A", "B", "C"], random)
    names = list(system.states)
    team = []
    for number, capability in enumerate(["C1", "C2", "C3"]):
        count = agents // 3 + (number < agents % 3)
        starts: dict[str, int] = {}
        for _ in range(count):
            place = random.choice(names)
            starts[place] = starts.get(place, 0) + 1
        team.append(Group.of(f"class{number}", starts, {capability}))
    text = DECOMPOSITION_FORMULA
    return mission(f"decomposition {agents} seed {seed}", system, team, text, objective)


def swarm(
    states: int, horizon: int, agents: int, seed: int, objective: Sequence[str] = ("splits",)
) -> Mission:
    """A swarm of four sub-swarms at most, on a grid, with six eventualities.

    Two want agents at two labels at once, two want 40 % of the swarm at one label, and two want
    a label held for three steps.
    """
    random = Random(f"swarm {states} {horizon} {seed}")
    rows = max(row for row in range(1, int(states**0.5) + 1) if states % row == 0)
    labels = [f"l{number}" for number in range(8)]
    system = grid_map(rows, states // rows, labels, random)
    parts = []
    for kind in ("pair", "share", "hold") * 2:
        one, other = random.sample(labels, 2)
        begin = random.randint(horizon // 4, horizon - 14)
        wanted = {
            "pair": f"({one} && {other})",
            "share": f"sum({one}) >= 40%",
            "hold": f"G[0,2] {one}",
        }[kind]
        parts.append(f"F[{begin},{begin + 10}] {wanted}")
    start = random.choice(list(system.states))
    return Mission.of(
        map=system,
        swarm={
            "size": agents,
            "at": {start: agents},
            "max_subswarms": 4,
            "min_subswarm": max(agents // 20, 1),
        },
        formula=" && ".join(parts),
        horizon=horizon,
        objective=objective,
        name=f"swarm {states} states seed {seed}",
    )


def partial(order: str, seed: int, objective: Sequence[str] = ()) -> Mission:
    """Six tasks for 14 agents in nine regions, each once or always in [0,20], planned by `order`.

    Half are always wanted, from step 0 on, when nobody is there yet: not all of it can hold, and
    what agents hold in one place they do not in another.
    """
    random = Random(f"partial {seed}")
    labels = [f"l{number}" for number in range(6)]
    system = grid_map(3, 3, labels, random)
    able = ["UV", "Vis", "IR"]
    parts = []
    for number, label in enumerate(labels):
        needs = [f"({name},{random.randint(1, 3)})" for name in random.sample(able, 1 + number % 2)]
        task = f"T({random.randint(1, 3)},{label},{{{','.join(needs)}}})"
        parts.append(f"{'G' if number < len(labels) // 2 else 'F'}[0,20] {task}")
    team = [
        Group.of(f"class{number}", {random.choice(list(system.states)): count}, able_to)
        for number, (count, able_to) in enumerate(
            [(5, {"UV", "Vis"}), (5, {"Vis", "IR"}), (4, {"IR", "UV"})]
        )
    ]
    return Mission.of(
        map=system,
        team=team,
        formula=" && ".join(parts),
        objective=[{"satisfaction": order}, *objective],
        name=f"partial {order} seed {seed}",
    )


@dataclass(frozen=True)
class Works:
    """The sizes of a mission with resources."""

    map: int = 10
    agents: int = 100
    resources: int = 10
    tasks: int = 8
    horizon: int = 60
    classes: int = 5


def resources(works: Works, seed: int, objective: Sequence[str] = ("travel",)) -> Mission:
    """Building sites on a grid that want robots and materials, some of them one after the other.

    Every fifth resource is a tool, every third can be parted. Classes carry in compartments, in one
    hold, or both kinds of robots are among them; there is twice as much of what is used up as all
    tasks want, and of every tool twice as much as the one task that wants most of it.
    """
    random = Random(f"resources {works} {seed}")
    labels = [f"l{number}" for number in range(works.tasks)]
    system = grid_map(works.map, works.map, labels, random)
    names = [f"r{number}" for number in range(works.resources)]
    tools = {name for number, name in enumerate(names) if number % 5 == 4}
    parted = {name for number, name in enumerate(names) if number % 3 == 1} - tools
    wanted: dict[str, list[int]] = {name: [] for name in names}
    parts = []
    for number, label in enumerate(labels):
        amounts = []
        for name in random.sample(names, min(random.randint(2, 3), len(names))):
            wanted[name].append(1 if name in tools else random.randint(1, 6))
            amounts.append(f"({name},{wanted[name][-1]})")
        need = random.randint(1, max(works.agents // 20, 1))
        staff = f"(c{random.randrange(3)},{need})"
        task = f"T({random.randint(1, 3)},{label},{{{staff}}},{{{','.join(amounts)}}})"
        middle, last = works.horizon // 2, works.horizon - 4
        # sites come in pairs: of every second pair the second site waits for the first
        window = (f"[0,{last}]", f"[0,{middle}]", f"[{middle},{last}]", f"[0,{last}]")[number % 4]
        parts.append(f"F{window} {task}")
    states = list(system.states)
    stocks = []
    for name in names:
        half = max(wanted[name], default=1) if name in tools else sum(wanted[name])
        stocks.append(
            {
                "name": name,
                "at": dict.fromkeys(random.sample(states, 2), half or 1),
                "indivisible": name not in parted,
                "consumed": name not in tools,
            }
        )
    team = []
    for number in range(works.classes):
        count = works.agents // works.classes + (number < works.agents % works.classes)
        able = {f"c{number % 3}", f"c{random.randrange(3)}"}
        carries: object = random.randint(2, 6)
        if number % 2:
            carries = {name: random.randint(1, 3) for name in names}
        team.append(Group.of(f"class{number}", {random.choice(states): count}, able, carries))
    return Mission.of(
        map=system,
        team=team,
        resources=stocks,
        formula=" && ".join(parts),
        language="catl",
        objective=tuple(objective),
        horizon=works.horizon,
        name=f"resources {works.map}x{works.map} {works.agents} agents seed {seed}",
    )


_SHAPES = {
    "single": {"modules": 1, "capabilities": ["look"]},
    "line": {"modules": 3, "capabilities": ["lift"], "cost": 2.0, "duration": 1.5},
    "ring": {"modules": 4, "capabilities": ["lift", "drill"], "cost": 2.5, "duration": 1.5},
    "tower": {"modules": 6, "capabilities": ["reach"], "cost": 4.0, "duration": 2.0},
}
_RULES = [
    {"from": "single", "to": "line", "duration": 2, "cost": 3},
    {"from": "line", "to": "single", "duration": 1, "cost": 1},
    {"from": {"line": 1, "single": 1}, "to": "ring", "duration": 3, "cost": 4},
    {"from": "ring", "to": {"line": 1, "single": 1}, "duration": 1, "cost": 1},
    {"from": {"line": 2}, "to": "tower", "duration": 3, "cost": 5},
    {"from": "tower", "to": {"line": 2}, "duration": 1, "cost": 1},
]


def modules(count: int, docks: int, seed: int, objective: Sequence[str] = ("travel",)) -> Mission:
    """Modular robots of four configurations on a 5x4 grid: three tasks in 40 steps.

    Structures are rebuilt at so many docks, at the first of which all modules begin, or anywhere
    without a dock.
    """
    random = Random(f"modules {count} {docks} {seed}")
    sites = ["wall", "mast", "yard"]
    system = grid_map(5, 4, [*sites, "dock0", *(f"dock{n}" for n in range(1, docks))], random)
    (start, *_) = system.labels["dock0"]
    where = {"at": [f"dock{number}" for number in range(docks)]} if docks else {}
    needs = random.sample(["(lift,1)", "(lift,2)", "(drill,1)", "(reach,1)", "(look,3)"], 3)
    windows = random.sample(["F[0,36]", "F[0,24]", "F[10,30]", "G[20,26] F[0,8]"], 3)
    parts = [
        f"{window} T({random.randint(1, 3)},{site},{{{need}}})"
        for window, site, need in zip(windows, sites, needs, strict=True)
    ]
    return Mission.of(
        map=system,
        team=[{"class": "module", "count": count, "at": start, "configuration": "single"}],
        configurations=_SHAPES,
        reconfigure=[{**rule, **where} for rule in _RULES],
        formula=" && ".join(parts),
        language="catl",
        objective=tuple(objective),
        horizon=40,
        name=f"modules {count} docks {docks} seed {seed}",
    )


@dataclass(frozen=True)
class Scale:
    """The axes of the scaling family and where they rest when another one moves."""

    agents: int = 800
    map: int = 20
    horizon: int = 100
    tasks: int = 10
    classes: int = 8


AXES = {
    "agents": (20, 200, 2_000, 20_000, 200_000, 1_000_000),
    "map": (5, 10, 20, 50, 100, 200),
    "horizon": (50, 100, 200, 300, 500),
    "tasks": (5, 10, 20, 40, 100),
    "classes": (2, 4, 8, 12),
}


def scaling(scale: Scale, seed: int, objective: Sequence[str] = ("travel",)) -> Mission:
    """Random tasks `F[a,b] T(d, label, {(capability, m)})` with windows of 10 to 30 steps."""
    random = Random(f"scaling {scale} {seed}")
    labels = [f"l{number}" for number in range(min(scale.tasks, scale.map * scale.map, 40))]
    system = grid_map(scale.map, scale.map, labels, random)
    names = [f"c{number}" for number in range(max(scale.classes // 2, 2))]
    states = list(system.states)
    each = scale.agents // scale.classes
    team = []
    for number in range(scale.classes):
        own = names[number % len(names)]
        other = random.choice([name for name in names if name != own])
        team.append(Group.of(f"class{number}", {random.choice(states): each}, {own, other}))
    parts = []
    reach = min(6 * scale.map, scale.horizon // 2)
    for _ in range(scale.tasks):
        duration = random.randint(1, 4)
        width = random.randint(10, 30)
        begin = random.randint(
            min(reach, scale.horizon - width - duration), scale.horizon - width - duration
        )
        need = random.randint(1, max(1, min(25, each // 4)))
        label, capability = random.choice(labels), random.choice(names)
        end = begin + width
        parts.append(f"F[{begin},{end}] T({duration},{label},{{({capability},{need})}})")
    text = " && ".join(parts)
    return mission(f"{scale} seed {seed}", system, team, text, objective)


def scaled(axis: str, value: int) -> Scale:
    """The resting scale with one axis moved."""
    return replace(Scale(), **{axis: value})


def mission(
    name: str, system: TransitionSystem, team: Sequence[Group], text: str, objective: Sequence[str]
) -> Mission:
    """A CaTL mission from its parts."""
    return Mission.of(
        map=system, team=team, formula=text, language="catl", objective=tuple(objective), name=name
    )


def axis_cases(axis: str, seeds: Sequence[int], objective: Sequence[str]) -> Iterator[Case]:
    """The scaling family along one axis."""
    for value in AXES[axis]:
        for seed in seeds:
            made = scaling(scaled(axis, value), seed, objective)
            yield Case("scaling", axis, value, seed, made)
