"""Random small missions with every operator, for differential tests."""

from __future__ import annotations

from random import Random

from tsplan import Mission
from tsplan.errors import MissionError
from tsplan.logic import Formula, horizon, parse
from tsplan.mission import Group
from tsplan.ts import Edge, State, TransitionSystem

CAPABILITIES = ["u", "v"]
LABELS = ["a", "b", "c"]


def random_map(random: Random, states: int, *, strange: bool) -> TransitionSystem:
    """A map with several labels per state; `strange` ones lack waits and have capacities and
    needs."""
    names = [f"s{number}" for number in range(states)]
    made = []
    for name in names:
        labels = [label for label in LABELS if random.random() < 0.35]
        capacity = random.choice([None, None, 1, 2]) if strange else None
        needs = ["u"] if strange and random.random() < 0.1 else []
        made.append(
            State(name, labels=frozenset(labels), capacity=capacity, needs=frozenset(needs))
        )
    for label in LABELS:
        if not any(label in state.labels for state in made):
            place = random.randrange(states)
            old = made[place]
            made[place] = State(
                old.name, labels=old.labels | {label}, capacity=old.capacity, needs=old.needs
            )
    edges = []
    for source in names:
        if not strange or random.random() < 0.8:
            wait = 1 if not strange or random.random() < 0.8 else 2
            edges.append(Edge(source, source, wait))
        for target in names:
            if source != target and random.random() < 0.5:
                capacity = random.choice([None, None, 1]) if strange else None
                cost = random.choice([None, None, 0.5, 4.0]) if strange else None
                length = random.randint(1, 3)
                duration = (
                    {"k0": length, "default": 4 - length}
                    if strange and random.random() < 0.2
                    else length
                )
                edges.append(Edge(source, target, duration, capacity=capacity, cost=cost))
    return TransitionSystem.build(made, edges)


def random_text(random: Random, depth: int) -> str:
    """A formula over the labels and capabilities, with negation, limits and all operators."""
    if depth == 0 or random.random() < 0.2:
        return random_atom(random)
    inner = random_text(random, depth - 1)
    low = random.randint(0, 2)
    window = f"[{low},{low + random.randint(0, 3)}]"
    kind = random.choice(["F", "G", "F", "G", "U", "R", "and", "or", "and", "not", "implies"])
    if kind in "FG":
        return f"{kind}{window} ({inner})"
    if kind == "not":
        return f"!({inner})"
    other = random_text(random, depth - 1)
    if kind in "UR":
        return f"({other}) {kind}{window} ({inner})"
    sign = {"and": "&&", "or": "||", "implies": "=>"}[kind]
    return f"({other}) {sign} ({inner})"


def random_atom(random: Random) -> str:
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


def random_mission(seed: int, *, states: int = 5, most_agents: int = 6, steps: int = 12) -> Mission:
    """A mission that fits together; its horizon is at most `steps`."""
    random = Random(seed)
    while True:
        system = random_map(random, random.randint(2, states), strange=random.random() < 0.4)
        text = random_text(random, random.randint(1, 3))
        formula: Formula = parse(text, language="mtl")
        if horizon(formula) > steps:
            continue
        names = list(system.states)
        team = []
        left = random.randint(1, most_agents)
        while left > 0:
            count = random.randint(1, left)
            left -= count
            capabilities = {name for name in CAPABILITIES if random.random() < 0.6}
            team.append(Group.of(f"k{len(team)}", {random.choice(names): count}, capabilities))
        objective = random.choice(
            [
                ["travel"],
                ["availability"],
                ["availability", "travel"],
                ["cost"],
                ["makespan", "travel"],
                ["agents", "travel"],
                ["availability", "agents", "makespan"],
                ["travel", "makespan"],
            ]
        )
        try:
            return Mission.of(
                map=system,
                team=team,
                formula=text,
                language="mtl",
                objective=objective,
                name=f"random {seed}",
            )
        except MissionError:
            continue  # a start over a state's capacity, or where a class may not be
