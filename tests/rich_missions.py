"""Random missions with everything mixed: cargo, structures of modules, bookings, risk."""

from __future__ import annotations

from itertools import pairwise
from random import Random
from typing import Any

from tests.module_missions import RULES, SHAPES
from tsplan import Mission
from tsplan.ts import Edge, State, TransitionSystem


def random_rich_mission(seed: int) -> Mission:
    """A mission of a few robots and modules that carry things, and are perhaps booked for tasks."""
    random = Random(seed)
    names = [f"s{number}" for number in range(random.randint(2, 4))]
    labels = {name: random.choice(["a", "b"]) for name in names} | {names[0]: "a", names[-1]: "b"}
    system = _map(random, labels)
    resources = _resources(random, names)
    horizon = random.randint(5, 8)
    modules = random.random() < 0.7
    booking = random.choice(["shared", "shared", "per-label", "exclusive"])
    objective = _objective(random, resources=bool(resources), modules=modules)
    free = [name for name, state in system.states.items() if state.capacity is None]
    team = _team(random, free, resources, modules=modules)
    if modules:
        team += _blocks(Random(f"blocks {seed}"), names[0])
    return Mission.of(
        map=system,
        team=team,
        resources=resources,
        formula=_formula(random, horizon, [item["name"] for item in resources], booking),
        booking=booking,
        objective=objective,
        horizon=horizon,
        **(_modular(random, resources) if modules else {}),
    )


def _map(random: Random, labels: dict[str, str]) -> TransitionSystem:
    """A chain of states, some of which hold few, some edges of which are dear, slow or risky."""
    edges = {(name, name): 1 for name in labels}
    for source, target in pairwise(labels):
        edges[source, target] = random.choice([1, 1, 1, 2])
        edges[target, source] = random.choice([1, 1, 2])
    return TransitionSystem.build(
        [
            State(name, frozenset({label}), capacity=random.choice([None, None, None, 3]))
            if number
            else State(name, frozenset({label}))
            for number, (name, label) in enumerate(labels.items())
        ],
        [
            Edge(
                *ends,
                duration,
                cost=random.choice([None, None, 0.5, 3]),
                success=1 if ends[0] == ends[1] else random.choice([1, 1, 0.9]),
            )
            for ends, duration in edges.items()
        ],
    )


def _resources(random: Random, names: list[str]) -> list[dict[str, Any]]:
    made = [
        {"name": "brick", "at": {random.choice(names): random.randint(1, 4)}, "indivisible": True},
        {
            "name": "drill",
            "at": {random.choice(names): random.randint(1, 2)},
            "indivisible": True,
            "consumed": False,
        },
    ]
    return random.sample(made, random.choice([0, 1, 1, 2]))


def _carries(random: Random, resources: list[dict[str, Any]]) -> dict[str, Any]:
    if not resources or random.random() < 0.2:
        return {}
    if random.random() < 0.4:
        return {"carries": random.randint(1, 3)}
    return {"carries": {item["name"]: random.randint(1, 2) for item in resources}}


def _team(
    random: Random, names: list[str], resources: list[dict[str, Any]], *, modules: bool
) -> list[dict[str, Any]]:
    team: list[dict[str, Any]] = [
        {
            "class": f"cart{number}",
            "count": random.randint(1, 2),
            "at": random.choice(names),
            "capabilities": random.choice([["u"], ["v"], ["u", "v"]]),
            **_carries(random, resources),
        }
        for number in range(random.randint(0 if modules else 1, 2))
    ]
    if modules:
        kind = random.choice(["one", "one", "duo"])
        count = random.randint(2, 4) if kind == "one" else random.choice([2, 4])
        team.append({"class": "cube", "count": count, "at": names[0], "configuration": kind})
    return team


def _blocks(random: Random, state: str) -> list[dict[str, Any]]:
    """Perhaps modules of another class, which are in no structure with the others."""
    if random.random() < 0.7:
        return []
    able = random.choice([[], ["v"]])
    count = random.randint(1, 3)
    made = {"class": "block", "count": count, "at": state, "capabilities": able}
    return [{**made, "configuration": "one"}]


def _modular(random: Random, resources: list[dict[str, Any]]) -> dict[str, Any]:
    shapes = {
        name: {
            **shape,
            "cost": random.choice([1, 1, 2]),
            "duration": random.choice([1, 1, 1.5]),
            **_carries(random, resources),
        }
        for name, shape in SHAPES.items()
    }
    rules = [
        {**rule, "duration": random.choice([1, 1, 2]), "cost": random.choice([0, 1.5])}
        for rule in random.sample(RULES, random.randint(2, 5))
    ]
    worth = {"a": {"one": 1, "trio": 2}, "b": {"duo": 1.5, "trio": 0.5}}
    return {"configurations": shapes, "reconfigure": rules, "performance": worth}


def _formula(random: Random, horizon: int, resources: list[str], booking: str) -> str:
    def task() -> str:
        asked = random.sample("uv", random.choice([1, 1, 2]))
        needs = ", ".join(f"({who}, {random.choice([1, 1, 1, 1, 2])})" for who in asked)
        some = random.sample(resources, min(len(resources), random.choice([0, 1, 1])))
        used = ", ".join(f"({name}, 1)" for name in some)
        more = f", {{{used}}}" if used else ""
        return f"T({random.randint(0, 1)}, {random.choice('ab')}, {{{needs}}}{more})"

    def part() -> str:
        last = random.choice([random.randint(1, horizon - 2), horizon - 2])
        first = random.randint(0, last)
        option = random.choice(["F", "F", "F", "G", "U", "count", "limit"])
        if option == "G" and last - first > 1:
            return f"G[{first},{first + 1}] F[0,{last - first - 1}] {task()}"
        if option == "U":
            return f"(sum(a) >= 1) U[{first},{last}] {task()}"
        if option == "count":
            return f"F[{first},{last}] sum({random.choice('ab')}, v) >= {random.randint(1, 2)}"
        if option == "limit":
            return f"G[{first},{last}] sum({random.choice('ab')}) <= {random.randint(2, 4)}"
        return f"F[{first},{last}] {task()}"

    parts = [part() for _ in range(random.choice([1, 2, 2, 3]))]
    if booking != "shared":
        parts.append(f"F[0,{horizon - 2}] {task()}")
    return f" {random.choice(['&&', '&&', '&&', '||'])} ".join(f"({each})" for each in parts)


def _objective(random: Random, *, resources: bool, modules: bool) -> list[str]:
    named = ["availability", "travel", "cost", "risk", "makespan", "agents"]
    named += ["haulage", "reserve"] if resources else []
    named += ["energy", "performance"] if modules else []
    return random.sample(named, random.choice([1, 2, 3]))
