"""Maps on which agents cannot wait: named as the cause, and mended."""

from __future__ import annotations

from dataclasses import replace
from random import Random

import pytest

import tsplan
from tests.explaining import check_explanation
from tests.seeds import sampled
from tsplan.cli import main
from tsplan.explanation import explain
from tsplan.explanation.whynot.context import Context
from tsplan.explanation.whynot.fact_finders import facts_of
from tsplan.mission import Group, Mission
from tsplan.testing import random_mission
from tsplan.ts import Edge, State, TransitionSystem
from tsplan.ts.map_lint import lint
from tsplan.ts.waits import longest_ways

CHAIN = TransitionSystem.build(
    [State(name, labels={name.upper()}) for name in "pqr"], [Edge("p", "q", 2), Edge("q", "r")]
)
CIRCLE = TransitionSystem.build(
    [State(name, labels={name.upper()}) for name in "pqr"],
    [Edge("p", "q"), Edge("q", "p"), Edge("q", "r", 2), Edge("r", "q"), Edge("p", "p")],
)


def mission(system: TransitionSystem, formula: str, count: int = 1, **others: object) -> Mission:
    team = [Group.of("a", {"p": count}, ["see"])]
    return Mission.of(map=system, team=team, formula=formula, language="mtl", **others)


def test_whoever_cannot_go_on_is_a_fact_of_its_own() -> None:
    made = check_explanation(mission(CHAIN, "F[0,6] R"))
    (fact,) = made.facts
    assert fact.kind == "waiting"
    assert fact.text == (
        "1 agent of class a that starts at 'p' can be nowhere after step 3: its longest way ends "
        "at 'r', and nobody can wait at 'r'; the mission lasts 6 steps"
    )
    words = [part.text for part in made.conflicts[0].parts]
    assert "nobody can wait at 'p', 'q', 'r': no edge leads from there to itself" in words
    assert [change.text for change in made.changes] == [
        "let agents wait at 'p' (an edge from 'p' to itself)",
        "let agents wait at 'q' (an edge from 'q' to itself)",
        "let agents wait at 'r' (an edge from 'r' to itself)",
        "let agents wait at every state (`waiting: true` in the map)",
    ]


def test_a_short_mission_may_end_where_nobody_can_wait() -> None:
    assert tsplan.plan(mission(CHAIN, "F[0,3] R")).status == "optimal"
    assert not list(facts_of(Context(mission(CHAIN, "F[0,3] R"))))


def test_staying_where_nobody_can_wait_is_a_fact_unless_others_take_turns() -> None:
    made = check_explanation(mission(CIRCLE, "F[0,8] G[0,2] R", 2))
    assert [fact.kind for fact in made.facts] == ["waiting"]
    assert made.facts[0].text == (
        "1 agent must be at 'r' (R) for 3 steps on end, and nobody can wait there: together the "
        "agents can be there 2 times at most, 3 are needed"
    )
    assert "let agents wait at 'r' (an edge from 'r' to itself)" in {c.text for c in made.changes}
    assert tsplan.plan(mission(CIRCLE, "F[0,8] G[0,2] R", 3)).status == "optimal"


@pytest.mark.long
def test_waiting_at_several_states_is_found_together() -> None:
    made = check_explanation(mission(CIRCLE, "F[2,6] G[0,3] Q && F[9,12] G[0,3] R"))
    assert "let agents wait at every state (`waiting: true` in the map)" in {
        change.text for change in made.changes
    }


def test_the_swarm_of_a_map_without_waits() -> None:
    thin = Mission.of(map=CHAIN, swarm={"size": 4, "at": {"p": 4}}, formula="F[0,6] sum(R) >= 1")
    made = check_explanation(thin)
    assert made.facts[0].kind == "waiting"
    assert {part.kind for part in made.conflicts[0].parts} == {"waiting"}
    assert made.changes


def moving(seed: int) -> Mission:
    """A random mission on a map with few waits."""
    random = Random(seed)
    made = random_mission(seed, states=4, most_agents=3, steps=6)
    edges = [e for e in made.system.edges.values() if not e.is_wait or random.random() < 0.3]
    return replace(made, system=TransitionSystem.build(made.system.states.values(), edges))


@pytest.mark.parametrize("seed", sampled([*range(6), *range(1000, 1200)], range(1)))
def test_random_missions_without_some_waits(seed: int) -> None:
    check_explanation(moving(seed), conflicts=2)


def test_longest_ways() -> None:
    moves = [(edge, edge.duration) for edge in CHAIN.edges.values()]
    assert longest_ways(moves) == {"p": (3, "r"), "q": (1, "r")}
    ways = longest_ways([(edge, edge.duration) for edge in CIRCLE.edges.values()])
    assert {length for length, _ in ways.values()} == {float("inf")}


def test_lint_says_where_nobody_can_wait() -> None:
    assert "nobody can wait at 'q', 'r': agents have to move on at once" in [
        finding.message for finding in lint(CIRCLE)
    ]
    assert "nobody can wait" not in str(
        lint(TransitionSystem.build([State("p")], [Edge("p", "p")]))
    )


TEXT = """format: tsplan-mission/1
map:
  waiting: false  # as the conveyor has it
  states: {in: {labels: [in]}, out: {labels: [out]}}
  edges: [[in, out, 2]]
team: [{class: tray, count: 2, at: in}]
spec: {language: mtl, formula: "F[0,9] sum(out) >= 2"}
"""


@pytest.mark.parametrize("fix", sampled(["1", "2", "3"], ["1"]))
def test_the_mended_mission_is_written_and_has_a_plan(fix: str, tmp_path, capsys) -> None:
    (tmp_path / "m.yaml").write_text(TEXT)
    target = tmp_path / "fixed.yaml"
    assert main(["explain", str(tmp_path / "m.yaml"), "--fix", fix, "-o", str(target)]) == 0
    out = capsys.readouterr().out
    assert "nobody can wait at 'in', 'out'" in out
    assert tsplan.plan(tsplan.load_mission(target)).status == "optimal"
    assert explain(tsplan.load_mission(tmp_path / "m.yaml")).facts
