"""Missions over signals written to files: what is read back is the same mission."""

from __future__ import annotations

from dataclasses import replace
from random import Random

import pytest
from hypothesis import given
from hypothesis import strategies as st

from tests.seeds import quick
from tests.test_signal_missions import MISSION, SEVERAL, WEIGHTED, changed
from tsplan import SignalMission, load_signal_mission
from tsplan.errors import FormulaError, MissionError
from tsplan.logic import linear, parse
from tsplan.logic.text import quoted
from tsplan.mission import Preference, SolverChoice
from tsplan.signals import Region, System
from tsplan.signals.aims import Aim
from tsplan.signals.linear_system import Limit
from tsplan.signals.signal_expressions import expression, expression_text, limits
from tsplan.signals.signal_files import signal_mission_from_text
from tsplan.testing.random_signals import random_signal_mission, random_system

NAMES = ("x", "in", "F", "1st", "Ä b", 'q"', "no")
NUMBERS = st.floats(-1e6, 1e6, allow_subnormal=False) | st.integers(-9, 9).map(float)
TERMS = st.dictionaries(st.sampled_from(NAMES), NUMBERS.filter(bool), max_size=3).map(
    lambda factors: tuple(sorted(factors.items()))
)


def alike(mission: SignalMission) -> str:
    text = mission.to_yaml()
    read = signal_mission_from_text(text)
    assert read == mission
    assert read.formula is mission.formula
    assert list(read.system.names) == list(mission.system.names)
    assert read.to_yaml() == text
    return text


@quick
@given(st.integers(0, 10**6), st.sampled_from(["stl", "wstl"]))
def test_random_missions_are_read_as_they_were(seed, language):
    mission = random_signal_mission(seed, language=language)
    # its parts have no texts of their own before it was read
    alike(replace(mission, parts=signal_mission_from_text(mission.to_yaml()).parts))


def random_robots(seed: int) -> SignalMission:
    """Several robots with everything that a file can say of them."""
    random = Random(f"robots {seed}")
    while True:
        base = random_system(random)
        names = list(base.signals)
        copies = {"a": {"initial": {}}, "b c": {"initial": {names[0]: (-1, 0.5)}}, "d": None}
        try:
            return SignalMission.of(
                system=base,
                outputs={"lead": f"2*{names[-1]} - 0.1", "apart": f'a_{names[0]} - "b c_x"'},
                limits=[*map(str, base.limits), f"|a_{names[0]} - d_{names[0]} + 3| <= 7.5"],
                regions={"here": {names[0]: (-1, 1)}, "there": Region(a_x=(-1, 2), d_x=(0, 1))},
                copies=dict(list(copies.items())[: random.choice((3, 3, 3))]),
                must='F[0,3] in("b c", here) && G[0,2] out(there) && a_lead <= 9 + apart',
                prefer=[Preference(parse("F[0,1] d_x >= 0", "stl"), partial=True)],
                objective=[{"robustness": 1, "state_effort": {names[0]: 0.3}}, "state_effort"],
                horizon=random.choice((None, 7)),
                solver=random.choice((None, {"seed": 3})),
                name=random.choice(("", "no", "ä: 'b' #d")),
            )
        except MissionError as error:
            assert "outside of its bounds" in str(error)  # noqa: PT017
            continue


@quick
@given(st.integers(0, 10**6))
def test_several_robots_are_read_as_they_were(seed):
    assert "copies:" in alike(random_robots(seed))


@pytest.mark.parametrize(
    "text",
    [
        MISSION,
        SEVERAL,
        changed(*WEIGHTED),
        changed("{min: 0, max: 9, initial: 0}", "{max: 9, initial: [-.inf, 3]}", "F[0,9] in", "in"),
        changed(*WEIGHTED, "[1, 2, 0.5]", "{0: 1, 1: 2, 2: 0.5}"),
        changed("{robustness: 1, control_effort: 0.1}", "[satisfaction: depth, robustness]"),
        changed("{robustness: 1, control_effort: 0.1}", "[]"),
        changed('"F[0,9] in(goal) && G[0,9] gap <= 9"', "[in(goal), 'gap <= 9 || x <= 3', true]"),
        changed("v: [-1, 1]", "v: {}", "gap <= 9", "v >= 0 && u <= gap && u <= 0.1"),
    ],
)
def test_files_are_read_as_they_were(text):
    alike(signal_mission_from_text(text))


def test_a_file_is_written(tmp_path):
    mission = signal_mission_from_text(MISSION)
    mission.save(tmp_path / "mission.yaml")
    assert load_signal_mission(tmp_path / "mission.yaml") == mission
    assert (tmp_path / "mission.yaml").read_text() == (
        "format: tsplan-signals/1\n"
        "name: reach\n"
        "signals:\n  x: {min: 0, max: 9, initial: 0}\n  v: [-1, 1]\n"
        "controls:\n  u: [-0.5, 0.5]\n"
        "dynamics:\n  A: [[1, 1], [0, 1]]\n  B: [[0], [1]]\n"
        'outputs:\n  gap: "-v + x"\n'
        'limits: ["|u| + |v| <= 1.2"]\n'
        "regions:\n  goal: {x: [7, 8]}\n"
        'spec:\n  language: stl\n  formula: "F[0,9] in(goal) && G[0,9] gap <= 9"\n'
        "objective: [{robustness: 1, control_effort: 0.1}]\n"
        "horizon: 10\n"
    )
    with pytest.raises(MissionError, match="cannot write"):
        mission.save(tmp_path / "none" / "mission.yaml")


def test_missions_without_a_text_are_written():
    formula = linear({"Ä b": 0.1}, ">", 1 / 3).eventually(0, 3) & linear({"x": 1}, "<=", 2)
    system = System(
        {"Ä b": (-1e-7, 3), "x": (0, 1e19)},
        limits=(Limit((("x", -1.0),), ((0.1, (("Ä b", 1 / 7), ("x", -1.0))),), 1 / 3),),
    )
    aim = Aim((("state_effort", 1.0),), {"state_effort": {"x": 1 / 9}})
    alike(SignalMission(system, formula, 5, (aim,), solver=SolverChoice(threads=2)))


@quick
@given(TERMS, NUMBERS)
def test_sums_are_read_as_they_were(terms, constant):
    assert expression(expression_text(terms, constant)) == (terms, constant)


@quick
@given(TERMS, st.lists(st.tuples(NUMBERS.map(abs).filter(bool), TERMS), max_size=3), NUMBERS)
def test_limits_are_read_as_they_were(terms, absolute, bound):
    # the sum between bars has a positive first factor, as its opposite is as large
    sized = tuple((f, tuple((n, abs(each)) for n, each in some)) for f, some in absolute if some)
    limit = Limit(terms, sized, bound)
    assert limits(str(limit)) == (limit,)


VALUES = st.fixed_dictionaries(dict.fromkeys("xyz", st.integers(-4, 4)))


@quick
@given(
    st.lists(st.tuples(st.sampled_from([0.5, 1, 2]), TERMS.map(lambda t: t[:2])), max_size=2),
    st.sampled_from("xyz"),
    st.integers(-5, 5),
    st.sampled_from(["<=", ">=", "="]),
    VALUES,
)
def test_limits_hold_where_their_text_does(absolute, plain, bound, relation, values):
    """A limit is split into several and turned round; what it allows stays the same."""
    shifts = (3, -2)
    sums = [
        (f, f"{quoted('x')} - 2*z + {shift}")
        for (f, _), shift in zip(absolute, shifts, strict=False)
    ]
    left = " + ".join([*(f"{f}*|{text}|" for f, text in sums), plain])
    sizes = [
        f * abs(values["x"] - 2 * values["z"] + shift)
        for (f, _), shift in zip(absolute, shifts, strict=False)
    ]
    total = sum(sizes) + values[plain]
    text = f"{left} {relation} {bound}"
    if sizes and relation != "<=":
        with pytest.raises(FormulaError, match="not convex"):
            limits(text)
        return
    expected = {"<=": total <= bound, ">=": total >= bound, "=": total == bound}[relation]
    assert all(keeps(limit, values) for limit in limits(text)) == expected


def keeps(limit: Limit, values: dict[str, float]) -> bool:
    """Whether a limit holds."""

    def worth(terms) -> float:
        return sum(factor * values[name] for name, factor in terms)

    sizes = sum(factor * abs(worth(terms)) for factor, terms in limit.absolute)
    return worth(limit.terms) + sizes <= limit.bound


def test_weights_of_functions_are_written_by_step():
    mission = SignalMission.of(
        signals={"x": (0, 9)},
        formula="F[2,4]^w x >= 3 && G[0,2]^w x <= 8 && F[0,1]^v x >= 1",
        weights={"w": lambda step: step + 0.5, "v": [1, 2]},
    )
    text = alike(mission)
    assert '{v: [1, 2], w: {"0": 0.5, "1": 1.5, "2": 2.5, "3": 3.5, "4": 4.5}}' in text
