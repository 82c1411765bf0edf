"""Numbers that are none, too small or too large: findings with their places, everywhere alike."""

from __future__ import annotations

import math
import sys
from dataclasses import replace
from fractions import Fraction

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

import tsplan
from tests.seeds import quick
from tsplan import Edge, Group, Mission, SolverChoice, State, TransitionSystem, parse
from tsplan.cli import main
from tsplan.document import parse_document
from tsplan.errors import MOST_TOLD, InputError, MapError, MissionError
from tsplan.logic import CountTrace, holds
from tsplan.mission import Preference, SwarmBounds, SwarmRules, mission_from_text
from tsplan.plans.outcomes import ObjectiveValue
from tsplan.ts.builders import grid
from tsplan.ts.io.lomap import lomap_to_yaml
from tsplan.ts.io.map_files import map_from_document
from tsplan.ts.io.tsplan_yaml import map_to_yaml

LARGE = ("1" + "0" * 39, "1" + "0" * 400, "1e30", "1e300", "1e400", ".inf", ".nan", "-1", "x")
MISSION = """\
format: tsplan-mission/1
map:
  waiting: true
  states: {a: {labels: [a], capacity: 5}, b: {labels: [b]}}
  edges:
  - {from: a, to: b, duration: 2, cost: 3, capacity: 4}
team:
- {class: r, count: 2, at: a}
- {class: s, at: {a: 1}}
spec:
  language: catl
  must: F[0,4] b
  prefer: [{formula: a, weight: 6, level: 7}]
horizon: 8
solver: {time_limit: 9, gap: 0.1, threads: 11, seed: 12}
"""
SWARM = """\
format: tsplan-mission/1
map: {waiting: true, states: {a: {labels: [a]}}}
swarms: [{name: u, size: 2, at: {a: 2}, max_subswarms: 3, min_subswarm: 1}]
max_subswarms: 4
margin: 5%
spec: F[0,1] a
"""
FIELDS = (
    "capacity: 5",
    "duration: 2",
    "cost: 3",
    "capacity: 4",
    "count: 2",
    "{a: 1}",
    "weight: 6",
    "level: 7",
    "horizon: 8",
    "time_limit: 9",
    "gap: 0.1",
    "threads: 11",
    "seed: 12",
)
SWARM_FIELDS = (
    "size: 2",
    "{a: 2}",
    "max_subswarms: 3",
    "min_subswarm: 1",
    "max_subswarms: 4",
    "margin: 5%",
)


def refused_at(text, old, value):
    """A mission with another value is refused in the line of that value."""
    assert old in text
    key = old.strip("{}").partition(":")[0]
    brace = "{" if old.startswith("{") else ""
    new = f"{brace}{key}: {value}" + ("}" if brace else "")
    line = text[: text.index(old)].count("\n") + 1
    with pytest.raises(MissionError) as caught:
        mission_from_text(text.replace(old, new, 1), "m")
    assert line in {finding.line for finding in caught.value.findings}, caught.value
    assert len(str(caught.value)) < 2000


@pytest.mark.parametrize("value", LARGE)
@pytest.mark.parametrize("old", FIELDS)
def test_numbers_of_a_mission_are_refused_at_their_place(old, value):
    refused_at(MISSION, old, value)


@pytest.mark.parametrize("value", [*LARGE, "1e30%", "9" * 50 + "%", "101%"])
@pytest.mark.parametrize("old", SWARM_FIELDS)
def test_numbers_of_a_swarm_are_refused_at_their_place(old, value):
    refused_at(SWARM, old, value)


def test_the_missions_stand_as_they_are():
    assert mission_from_text(MISSION)
    assert mission_from_text(SWARM)


@pytest.mark.parametrize("cost", ["1e20", "3.0e+20", "1" + "0" * 20])
def test_a_cost_that_solvers_take_for_infinity_is_refused(cost):
    with pytest.raises(MissionError, match=r"m:6:41: cost: .*e\+20 is not below 1e\+20"):
        mission_from_text(MISSION.replace("cost: 3", f"cost: {cost}"), "m")
    edge = f"[a, a, {{weight: 1, tsplan: {{cost: {cost}}}}}]"
    lomap = f"!Ts\ngraph:\n  nodes: {{a: {{}}}}\n  edges: [{edge}]"
    with pytest.raises(MapError, match="is not below"):
        map_from_document(parse_document(lomap, "f"))
    assert mission_from_text(MISSION.replace("cost: 3", "cost: 9.0e+19"))


def test_weights_of_lomap_are_durations():
    for weight in ("1000001", "1e300", ".inf", "-1", "1.5"):
        text = f"!Ts\ngraph:\n  nodes: {{a: {{}}}}\n  edges:\n  - [a, a, {{weight: {weight}}}]"
        with pytest.raises(MapError, match="f:5:21: duration"):
            map_from_document(parse_document(text, "f"))


@pytest.mark.parametrize(
    ("text", "language"),
    [
        ("sum(a) >= 1e9999999999999999999", "mtl"),
        ("sum(a) >= 1" + "0" * 15, "mtl"),
        ("sum(a) >= 1e9999999999999999999%", "mtl"),
        ("F[0,1e9999999999999999999] a", "mtl"),
        ("F[0,1" + "0" * 5000 + "] a", "mtl"),
        ("T(1e9999999999999999999,a,{(c,1)})", "catl"),
        ("T(1,a,{(c,1e9999999999999999999)})", "catl"),
        ("T(1,a,{(c,1)},{(r,1e400)})", "catl"),
        ("T(1,a,{(c,1)},{(r,1e9999999999999999999)})", "catl"),
        ("1e9999999999999999999*x >= 1", "stl"),
        ("x >= 1e-9999999999999999999", "stl"),
        ("*".join(["1e300"] * 200) + "*x >= 1", "stl"),
    ],
)
def test_numbers_of_formulas_are_bounded(text, language):
    with pytest.raises(tsplan.FormulaError) as caught:
        parse(text, language)
    assert all(finding.line == 1 for finding in caught.value.findings)


OPTIONS = [
    ("time_limit", value) for value in (0, -1, math.nan, math.inf, 1e300, 10**400, "x", True)
]
OPTIONS += [("gap", value) for value in (-1, math.nan, math.inf, 1e300, "x")]
OPTIONS += [("threads", value) for value in (0, -1, 1.5, 2**31, "x")]
OPTIONS += [("seed", value) for value in (-1, 1.5, 2**31, 10**30, "x")]


@pytest.mark.parametrize(("name", "value"), OPTIONS)
def test_options_are_bounded_alike_in_python_and_on_the_command_line(name, value, tmp_path, capsys):
    mission = mission_from_text(MISSION)
    with pytest.raises(InputError, match=f"^{name}: "):
        tsplan.plan(mission, **{name: value})
    with pytest.raises(InputError, match=f"solver.{name}: "):
        _with_choice(mission, name, value)
    if name == "time_limit":
        with pytest.raises(InputError, match=r"^time_limit: "):
            tsplan.explain(mission, time_limit=value)
    if value is True:
        return
    (tmp_path / "m.yaml").write_text(MISSION)
    option = f"--{name.replace('_', '-')}={value}"
    assert main(["plan", str(tmp_path / "m.yaml"), option]) == 2
    assert "argument --" in capsys.readouterr().err


def _with_choice(mission, name, value):
    """The mission with another choice for the solver, by the constructor."""
    return Mission(
        mission.name,
        mission.system,
        mission.team,
        mission.language,
        mission.text,
        mission.formula,
        mission.horizon,
        solver=SolverChoice(**{name: value}),
    )


@pytest.mark.parametrize(
    "change",
    [
        {"horizon": -1},
        {"horizon": 10**7},
        {"horizon": 1.5},
        {"horizon": "x"},
        {"team": (Group("r", frozenset(), (("a", 10**39),)),)},
        {"team": (Group("r", frozenset(), (("a", 1.5),)),)},
        {"team": (Group("r", frozenset(), (("a", "x"),)),)},
        {"prefer": (Preference(parse("a"), "a", Fraction(-1)),)},
        {"prefer": (Preference(parse("a"), "a", Fraction(10**30)),)},
        {"prefer": (Preference(parse("a"), "a", level=-1),)},
        {"swarm": SwarmRules({"r": SwarmBounds(0)})},
        {"swarm": SwarmRules({"r": SwarmBounds(None, 10**30)})},
        {"swarm": SwarmRules({"r": SwarmBounds()}, together=1.5)},
        {"swarm": SwarmRules({"r": SwarmBounds()}, margin=Fraction(3, 2))},
        {"swarm": SwarmRules({"r": SwarmBounds()}, margin=-1)},
    ],
)
def test_the_constructor_of_missions_keeps_the_same_limits(change):
    given = mission_from_text(MISSION)
    parts = {
        "name": "",
        "system": given.system,
        "team": (Group.of("r", {"a": 2}),),
        "language": "mtl",
        "text": "b",
        "formula": parse("b"),
        "horizon": 8,
        "objective": (),
    }
    assert Mission(**parts)
    with pytest.raises(MissionError):
        Mission(**(parts | change))


def test_runs_and_seeds_of_simulations_are_bounded():
    mission = mission_from_text(SWARM.replace("F[0,1] a", "F[0,1] sum(a) >= 1"))
    plan = tsplan.plan(mission)
    for options in ({"runs": 10**30}, {"seed": -1}, {"seed": 10**30}):
        with pytest.raises(InputError, match=r"is (above|below)"):
            tsplan.simulate(mission, plan, **options)


def test_edges_built_in_python_keep_the_same_limits():
    for edge in (
        Edge("a", "a", 10**7),
        Edge("a", "a", {"r": 10**7}),
        Edge("a", "a", 1, cost=1e20),
        Edge("a", "a", 1, cost=10**400),
        Edge("a", "a", 1, cost=math.nan),
        Edge("a", "a", 1, capacity=10**16),
    ):
        with pytest.raises(MapError):
            TransitionSystem.build([State("a")], [edge])
    with pytest.raises(MapError):
        TransitionSystem.build([State("a", capacity=10**16)], [])
    with pytest.raises(MapError, match="capacity: a number of hundreds of digits is more than"):
        TransitionSystem.build([State("a", capacity=10**400)], [])
    with pytest.raises(MapError):
        TransitionSystem.build([State("a", at=(10**400, 0))], [])


ENDLESS = [10**400, -(10**400), 10**5000]  # beyond floats, and beyond what Python writes


@pytest.mark.parametrize("value", ENDLESS, ids=["large", "negative", "unwritten"])
def test_numbers_beyond_all_are_findings_wherever_python_gives_them(value):
    system = grid(1, 2, labels={(0, 1): "b"})
    parts = {"map": system, "formula": "F[0,3] b", "language": "mtl"}
    team = [{"class": "r", "at": "r0c0"}]
    mission = Mission.of(**parts, team=team, objective=["travel"])
    problem = tsplan.Problem(mission)
    here = problem.count("b", step=1)
    for ask in (
        lambda: TransitionSystem.build([State("a", capacity=value)], []),
        lambda: TransitionSystem.build([State("a", at=(value, 0))], []),
        lambda: TransitionSystem.build([State("a")], [Edge("a", "a", value)]),
        lambda: TransitionSystem.build([State("a")], [Edge("a", "a", 1, cost=value)]),
        lambda: TransitionSystem.build([State("a")], [Edge("a", "a", 1, capacity=value)]),
        lambda: Mission.of(**parts, team=[{"class": "r", "count": value, "at": "r0c0"}]),
        lambda: Mission.of(**parts, team=team, horizon=value),
        lambda: Mission.of(**parts, swarm={"size": value, "at": "r0c0"}),
        lambda: replace(mission, horizon=value),
        lambda: tsplan.plan(mission, time_limit=value),
        lambda: tsplan.plan(mission, gap=Fraction(value, 3)),
        lambda: tsplan.plan(mission, seed=value),
        lambda: problem.count("b", step=value),
        lambda: problem.minimise(here + value),
        lambda: problem.maximise(value * here),
        lambda: problem.encode(value),
    ):
        with pytest.raises(InputError) as caught:
            ask()
        assert len(str(caught.value)) < 400
    plan = tsplan.plan(mission)
    claimed = replace(plan, objective=(ObjectiveValue("travel", value, 1),))
    assert "the plan claims travel" in str(tsplan.check(mission, claimed).findings[0])
    assert claimed._repr_html_()
    with pytest.raises(ValueError, match="beyond"):
        holds(parse("a"), CountTrace({None: [[value]]}, {"a": np.array([0])}))


# --- what is written can be read again ---

reals = st.floats(allow_nan=False, allow_infinity=False)
names = st.text(st.characters(exclude_categories=["Cs"]), min_size=1, max_size=4)
points = st.tuples(reals, reals)
states = st.builds(
    State,
    name=names,
    labels=st.frozensets(names, max_size=2),
    at=st.none() | points,
    shape=st.none() | st.lists(points, min_size=3, max_size=4).map(tuple),
    color=st.none() | names,
    capacity=st.none() | st.integers(0, 10**15 - 1),
    needs=st.frozensets(names, max_size=1),
)


@st.composite
def maps(draw):
    made = draw(st.lists(states, min_size=1, max_size=3, unique_by=lambda state: state.name))
    pairs = draw(st.sets(st.tuples(st.sampled_from(made), st.sampled_from(made)), max_size=4))
    steps = st.integers(1, 10**6)
    edges = [
        Edge(
            source.name,
            target.name,
            draw(steps | st.dictionaries(names, steps, min_size=1, max_size=2)),
            draw(st.none() | st.floats(0, 1e20, exclude_max=True)),
            draw(st.none() | st.integers(0, 10**15 - 1)),
            draw(st.frozensets(names, max_size=1)),
        )
        for source, target in pairs
    ]
    return TransitionSystem.build(made, edges, draw(st.just("") | names))


@quick
@given(maps())
def test_a_map_that_is_written_is_read_again(system):
    assert map_from_document(parse_document(map_to_yaml(system), "f")) == system


@quick
@given(maps())
def test_a_map_that_is_written_for_lomap_is_read_again(system):
    again = map_from_document(parse_document(lomap_to_yaml(system), "f"))
    assert set(again.states) == set(system.states)
    assert {s.name: (s.at, s.shape, s.capacity) for s in again.states.values()} == {
        s.name: (s.at, s.shape, s.capacity) for s in system.states.values()
    }
    assert dict(again.edges) == dict(system.edges)


@pytest.mark.parametrize("value", [1e300, -1e300, 1e16, 123456789012345678.0, 5e-324, 10**50])
def test_large_and_small_coordinates_are_read_again(value):
    system = TransitionSystem.build([State("a", at=(value, 0.5))], [])
    again = map_from_document(parse_document(map_to_yaml(system), "f"))
    assert again.states["a"].at == (float(value), 0.5)


# --- long texts ---


def calls(text, language):
    """How many functions are called while a text is read."""
    count = 0

    def note(_frame, event, _argument):
        nonlocal count
        count += event in ("call", "c_call")

    sys.setprofile(note)
    try:
        parse(text, language)
    except InputError:
        pass
    finally:
        sys.setprofile(None)
    return count


@pytest.mark.parametrize(
    ("make", "language"),
    [
        (lambda n: " + ".join(f"x{i}" for i in range(n)) + " >= 1", "stl"),
        (lambda n: " - ".join(f"{i}*x{i}" for i in range(1, n)) + " >= 1", "stl"),
        (lambda n: " + ".join(f"x{i}" for i in range(n)) + " >= 3 &", "stl"),
        (lambda n: "T(1,a,{" + ",".join(f"(c{i},1)" for i in range(n)) + "})", "catl"),
        (lambda n: "? " * n + "a", "mtl"),
    ],
)
def test_reading_takes_time_linear_in_the_text(make, language):
    parse("a", language if language != "stl" else "mtl")
    calls(make(20), language)  # what is loaded once
    assert calls(make(400), language) < 2.6 * calls(make(200), language)


def test_findings_are_told_up_to_a_number_and_messages_up_to_a_length():
    with pytest.raises(InputError) as caught:
        parse("? " * 20_000 + "a")
    lines = str(caught.value).splitlines()
    assert len(caught.value.findings) == 20_000
    assert len(lines) == MOST_TOLD + 1
    assert lines[-1] == "and 19,900 more findings; correct these first"
    with pytest.raises(InputError) as caught:
        mission_from_text(MISSION.replace("F[0,4] b", "F[0,4] " + "b" * 100_000))
    assert len(str(caught.value)) < 2000
    with pytest.raises(InputError) as caught:
        mission_from_text(MISSION.replace("F[0,4] b", "'" + "? " * 20_000 + "b'"), "m")
    assert len(str(caught.value).splitlines()) == MOST_TOLD + 1


def test_the_command_line_tells_no_more(capsys):
    assert main(["parse", "? " * 5_000 + "a", "--language", "mtl"]) == 2
    assert len(capsys.readouterr().err.splitlines()) == MOST_TOLD + 1
