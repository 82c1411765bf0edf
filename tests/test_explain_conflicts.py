"""Conflicts and changes of random missions, checked one by one by what did not find them."""

from __future__ import annotations

from dataclasses import dataclass, replace
from random import Random

import pytest

import tsplan
from tests.explaining import check_conflict, check_explanation, elements, plain
from tests.joint_plans import small_enough
from tests.seeds import sampled, seed_blocks
from tsplan.explanation import SoftConstraint, explain
from tsplan.explanation.whynot.conflicts import Finder
from tsplan.explanation.whynot.relaxing import relaxed
from tsplan.mission import Group, Mission
from tsplan.testing import random_mission, random_swarm_mission, random_task_mission
from tsplan.ts import Edge, State, TransitionSystem

ROW = TransitionSystem.build(
    [State("p", labels={"A"}), State("q", labels={"B"}), State("r", labels={"C"})],
    [
        *(Edge(name, name, 1) for name in "pqr"),
        *(Edge(*pair, 1) for pair in ("pq", "qp")),
        *(Edge(*pair, 2) for pair in ("qr", "rq")),
    ],
)


def row(formula: str | list[str], **others: object) -> Mission:
    """Two agents at one end of a row of three states; the other end is three steps away."""
    given = {"team": [Group.of("a", {"p": 2}, ["see"])], "language": "mtl", **others}
    return Mission.of(map=ROW, formula=formula, **given)


def texts(mission: Mission) -> list[list[str]]:
    made = explain(mission, conflicts=5)
    return [[part.text for part in conflict.parts] for conflict in made.conflicts]


@pytest.mark.parametrize("seed", sampled(range(3), range(1, 2)))
def test_tasks(seed: int) -> None:
    check_explanation(random_task_mission(seed + 200), conflicts=2)


@pytest.mark.parametrize("seed", range(4))
def test_counts(seed: int) -> None:
    check_explanation(random_mission(seed + 500, states=4, most_agents=4, steps=6))


@pytest.mark.parametrize(
    "seeds", seed_blocks(range(60_000, 60_001), [*range(60_000, 60_012), *range(61_000, 61_400)], 6)
)
def test_swarms(seeds: list[int]) -> None:
    for seed in seeds:
        check_explanation(random_swarm_mission(seed, fits=small_enough), conflicts=2)


@pytest.mark.long
@pytest.mark.parametrize("block", range(40))
def test_many_tasks(block: int) -> None:
    found = [
        check_explanation(random_task_mission(seed), conflicts=2)
        for seed in range(1000 + 10 * block, 1010 + 10 * block)
    ]
    assert sum(made.status == "explained" for made in found) >= 5


@pytest.mark.long
@pytest.mark.parametrize("block", range(40))
def test_many_counts(block: int) -> None:
    for seed in range(7000 + 10 * block, 7010 + 10 * block):
        check_explanation(random_mission(seed, states=4, most_agents=4, steps=8), conflicts=2)


@pytest.mark.parametrize("seed", sampled([200, 1389], []))
def test_tasks_that_went_wrong(seed: int) -> None:
    """A robot that cannot wait needs others in its place; a program that HiGHS cannot solve."""
    check_explanation(random_task_mission(seed), conflicts=2)


@pytest.mark.parametrize("seed", [7088])
def test_counts_that_went_wrong(seed: int) -> None:
    """A window of one step, whose left side looks further ahead than the mission."""
    check_explanation(random_mission(seed, states=4, most_agents=4, steps=8), conflicts=2)


def test_a_part_that_cannot_hold_alone() -> None:
    mission = row("F[0,4] A && (F[0,9] false)")
    assert texts(mission) == [["F[0,9] false"]]


def test_what_is_said_of_the_team_and_its_start() -> None:
    assert texts(row("F[0,4] sum(A) >= 3 && F[0,2] B")) == [
        ["F[0,4] sum(A) >= 3", "the team has 2 agents of class a"]
    ]
    assert texts(row("F[0,2] C")) == [["F[0,2] C", "the agents of class a start at 'p'"]]


def test_a_capacity_is_named() -> None:
    states = [replace(s, capacity=1) if s.name == "q" else s for s in ROW.states.values()]
    system = TransitionSystem.build(states, ROW.edges.values())
    mission = replace(row("F[0,3] sum(C) >= 2"), system=system)
    ((*_, last),) = texts(mission)
    assert last == "state 'q' holds at most 1"


def test_several_different_conflicts() -> None:
    mission = row("F[0,2] C && F[0,4] sum(A) >= 3 && G[1,2] sum(B) >= 2 && G[2,3] A")
    made = explain(mission, conflicts=5)
    assert len(made.conflicts) >= 3
    assert len({elements(conflict) for conflict in made.conflicts}) == len(made.conflicts)
    for conflict in made.conflicts:
        check_conflict(mission, conflict)


def test_one_need_of_a_task_is_named_alone() -> None:
    text = "F[0,4] T(1, C, {(see, 2), (lift, 1)})"
    mission = row(text, language="catl")
    assert texts(mission) == [[f"(lift, 1) in {text}"]]


def test_parts_stand_where_they_were_written() -> None:
    text = "F[0,4] A &&\n  (F[0,2] C || false)"
    ((first, *_),) = [conflict.parts for conflict in explain(row(text)).conflicts]
    assert (first.place.line, first.place.column) == (2, 4)
    assert text.splitlines()[1][3:].startswith(first.text.split(" in ")[0][:6])


@pytest.mark.long
def test_a_team_without_a_number_is_one_with_any_number() -> None:
    """Leaving out how many there are is as good as the best number of them."""
    for seed in range(12):
        mission = plain(random_task_mission(300 + seed))
        entry = mission.team[0]
        room = mission.system.states[entry.starts[0][0]].capacity
        most = 7 if room is None else room - sum(n for g in mission.team for s, n in g.starts) + 1
        many = [replace(mission, team=(_grown(entry, n), *mission.team[1:])) for n in range(most)]
        some = any(tsplan.plan(item, encoding="reference").has_paths for item in many)
        alone = tsplan.plan(relaxed(mission, [SoftConstraint("team", (0,))]))
        assert alone.has_paths or not some, seed
        if len(entry.starts) == 1 and not alone.has_paths:
            assert not some


def _grown(group: Group, more: int) -> Group:
    """A group with more agents at its first start."""
    (first, count), *rest = group.starts
    return Group(group.class_name, group.capabilities, ((first, count + more), *rest))


def test_time_that_is_too_short_is_admitted() -> None:
    mission = random_task_mission(7)
    made = explain(mission, time_limit=0.001)
    assert made.status in ("explained", "no_answer")
    assert all(not conflict.minimal or conflict.parts for conflict in made.conflicts)


# --- deletion ----------------------------------------------------------------------------------


def test_deletion_finds_the_conflict_that_names_late_parts_last() -> None:
    """One part at a time from the end on, by definition; whatever sets are impossible."""
    for seed in range(200):
        rng = Random(seed)
        parts = [SoftConstraint("formula", ((), number)) for number in range(rng.randint(1, 20))]
        bad = [frozenset(rng.sample(parts, rng.randint(1, len(parts)))) for _ in range(3)]
        known = Known(tuple(parts), tuple(bad))
        kept = list(parts)
        for part in reversed(parts):
            rest = frozenset(kept) - {part}
            if any(some <= rest for some in bad):
                kept.remove(part)
        core = Finder(known).within(frozenset(parts))  # type: ignore[arg-type]  # what it asks of
        assert core is not None
        assert core.minimal
        assert core.constraints == frozenset(kept)


@dataclass
class Known:
    """An oracle of parts of which some sets are impossible, and its own subject."""

    parts: tuple[SoftConstraint, ...]
    bad: tuple[frozenset[SoftConstraint], ...]
    groups: tuple[tuple[SoftConstraint, ...], ...] = ()

    @property
    def subject(self) -> Known:
        return self

    @property
    def bounds(self) -> tuple[SoftConstraint, ...]:
        return self.parts

    def refuses(self) -> bool:
        return False

    def without(self, gone: frozenset[SoftConstraint]) -> bool:
        return not any(some <= frozenset(self.parts) - gone for some in self.bad)
