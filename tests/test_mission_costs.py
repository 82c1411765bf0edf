"""Costs are exact, or refused at their place with the digits to drop."""

from __future__ import annotations

from fractions import Fraction

import pytest

import tsplan
from tsplan.errors import MapError, MissionError
from tsplan.mission import Group, load_mission
from tsplan.mission.read import mission_from_text
from tsplan.ts import Edge, State, TransitionSystem

TEXT = """\
format: tsplan-mission/1
map:
  waiting: true
  states: {{a: {{}}, b: {{labels: [goal]}}}}
  edges:
    - {{from: a, to: b, duration: 1, cost: {there}}}
    - {{from: b, to: a, duration: 2, cost: {back}}}
team: [{{class: cart, count: {count}, at: a}}]
spec: {{language: mtl, formula: "F[0,9] goal"}}
objective: [{objective}]
"""


def mission(there: str, back: str = "1", count: int = 1, objective: str = "cost") -> str:
    return TEXT.format(there=there, back=back, count=count, objective=objective)


def findings(text: str) -> list:
    with pytest.raises((MissionError, MapError)) as caught:
        mission_from_text(text)
    return [item for item in caught.value.findings if item.message.startswith("cost")]


def test_costs_that_can_be_told_apart_are_exact() -> None:
    plan = tsplan.plan(mission_from_text(mission("0.1", "0.2", count=3, objective="cost, travel")))
    assert (plan.status, plan.objective[0].value, plan.objective[0].bound) == ("optimal", 0.1, 0.1)
    assert mission_from_text(mission("900000000000000", "1")).horizon == 9


def test_digits_that_would_be_lost_are_refused_at_their_line() -> None:
    (finding,) = findings(mission("10000000000", "0.0000001", count=100))
    assert (finding.line, finding.column) == (7, 43)
    assert "0000001" in finding.message or "1e-07" in finding.message
    assert finding.remedy == "write at most 2 digits after the point"
    assert mission_from_text(mission("10000000000", "0.01", count=100))
    (finding,) = findings(mission("100000000000000", "0.5"))
    assert (finding.line, finding.remedy) == (7, "write no digits after the point")


def test_whole_costs_that_add_up_to_too_much_are_refused() -> None:
    (first,) = findings(mission("9000000000000001", "3", count=2))[:1]
    assert first.line == 6
    assert "drop the last 2 digits" in first.remedy
    one = findings(mission("9000000000000001", "3"))[0]
    assert "drop the last digit of all costs" in one.remedy
    assert len(findings(mission("9000000000000001", "3", count=2))) == 2
    assert mission_from_text(mission("9000000000000001", "3", objective="travel"))


def test_a_file_may_not_write_digits_that_are_not_kept() -> None:
    (finding,) = findings(mission("0.12345678901234567890"))
    assert (finding.line, finding.column) == (6, 43)
    assert finding.remedy == "write 0.12345678901234568"


def test_costs_in_another_file_are_found_there(tmp_path) -> None:
    (tmp_path / "map.yaml").write_text(
        "states: {a: {}, b: {labels: [goal]}}\nwaiting: true\nedges:\n"
        "  - {from: a, to: b, duration: 1, cost: 100000000000.5, both_ways: true}\n"
        "  - {from: b, to: b, duration: 1, cost: 0.00001}\n"
    )
    text = mission("1")
    begin, end = text.index("map:"), text.index("team:")
    path = tmp_path / "mission.yaml"
    path.write_text(f"{text[:begin]}map: map.yaml\n{text[end:]}")
    with pytest.raises(MissionError) as caught:
        load_mission(path)
    (finding,) = caught.value.findings
    assert str(finding).startswith(f"{tmp_path / 'map.yaml'}:5:")


def test_missions_made_in_python_name_the_edge() -> None:
    system = TransitionSystem.build(
        [State("a"), State("b", labels=frozenset({"goal"}))],
        [Edge("a", "b", 1, cost=1e15), Edge("a", "a", cost=0.25)],
    )
    assert system.cost_unit == Fraction(1, 4)
    with pytest.raises(MissionError, match="from 'a' to 'a' has digits"):
        tsplan.Mission.of(
            map=system,
            team=[Group.of("cart", {"a": 1})],
            formula="F[0,3] goal",
            language="mtl",
            objective=["cost"],
        )
