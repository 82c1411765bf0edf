"""Random small CaTL missions, tight enough that many of them cannot be met."""

from __future__ import annotations

from random import Random

from tests.random_missions import CAPABILITIES, LABELS, random_map
from tsplan import Mission
from tsplan.errors import MissionError
from tsplan.mission import Group

PARTS = ("F", "F", "F", "G", "GF", "U", "or", "and")


def random_tasks(seed: int, *, states: int = 5) -> Mission:
    """A mission of a few tasks and limits on a map with waits everywhere, or a strange one."""
    random = Random(f"tasks {seed}")
    while True:
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
        parts = [random_part(random) for _ in range(random.randint(1, 3))]
        try:
            return Mission.of(
                map=system,
                team=team,
                formula=parts if len(parts) > 1 and random.random() < 0.3 else " && ".join(parts),
                language="catl",
                objective=["travel"],
                task_interval=random.choice(["closed", "closed", "half-open"]),
                name=f"tasks {seed}",
            )
        except MissionError:
            continue  # a start over a state's capacity, or where a class may not be


def random_part(random: Random) -> str:
    """One conjunct, in parentheses."""
    low = random.randint(0, 4)
    window = f"[{low},{low + random.randint(0, 4)}]"
    one, two = random_task(random), random_task(random)
    kind = random.choice(PARTS)
    texts = {
        "F": f"F{window} {one}",
        "G": f"G{window} {random_limit(random)}",
        "GF": f"G[0,{random.randint(1, 3)}] F[0,{random.randint(0, 3)}] {one}",
        "U": f"{random_limit(random)} U{window} {one}",
        "or": f"F{window} ({one} || {two})",
        "and": f"F{window} ({one} && {two})",
    }
    return f"({texts[kind]})"


def random_task(random: Random) -> str:
    """A task with one or two needs."""
    duration = random.randint(1, 2)
    names = random.sample(CAPABILITIES, random.randint(1, 2))
    needs = ", ".join(f"({name}, {random.randint(1, 2)})" for name in names)
    return f"T({duration}, {random.choice(LABELS)}, {{{needs}}})"


def random_limit(random: Random) -> str:
    """A limit on one capability, or on everybody."""
    if random.random() < 0.3:
        return f"L({random.choice(LABELS)}, {{}})"
    return (
        f"L({random.choice(LABELS)}, {{({random.choice(CAPABILITIES)}, {random.randint(0, 1)})}})"
    )
