"""Meaning on traces: small examples worked out by hand, wrong traces, and windows."""

import numpy as np
import pytest

from tsplan import logic
from tsplan.logic import CountTrace, SignalTrace, holds, parse, robustness
from tsplan.logic.windows import switched, windowed

# three states over five steps; a: the first two, b: the third
EVERYONE = np.array([[2, 1, 0, 0, 1], [1, 1, 1, 0, 0], [0, 1, 2, 3, 2]])
FLYING = np.array([[1, 0, 0, 0, 1], [0, 1, 1, 0, 0], [0, 0, 0, 1, 0]])
PLACES = {"a": np.array([0, 1]), "b": np.array([2])}
TRACE = CountTrace({None: EVERYONE, "fly": FLYING}, PLACES)


@pytest.mark.parametrize(
    ("text", "values"),
    [
        ("sum(a) >= 2", [1, 0, -1, -2, -1]),
        ("sum(a) > 2", [0, -1, -2, -3, -2]),
        ("sum(a) <= 1", [-2, -1, 0, 1, 0]),
        ("sum(a) < 1", [-3, -2, -1, 0, -1]),
        ("sum(a) = 2", [-1, 0, -1, -2, -1]),
        ("sum(a) != 2", [0, -1, 0, 1, 0]),
        ("min(a) >= 1", [0, 0, -1, -1, -1]),
        ("min(a) <= 0", [-1, -1, 0, 0, 0]),
        ("max(a) <= 1", [-1, 0, 0, 1, 0]),
        ("max(a) >= 1", [1, 0, 0, -1, 0]),
        ("sum(a,fly) >= 1", [0, 0, 0, -1, 0]),
        ("sum(a,swim) >= 1", [-1, -1, -1, -1, -1]),
        ("a", [2, 1, 0, -1, 0]),
        ("!a", [-3, -2, -1, 0, -1]),
        ("F[1,2] (sum(b) >= 2)", [0, 1, 1]),
        ("G[0,1] a", [1, 0, -1, -1]),
        ("a U[1,2] (sum(b) >= 2)", [0, 0, 0]),
        ("a U[3,3] (sum(b) >= 3)", [0, -1]),
        ("(sum(b) >= 2) R[0,2] a", [0, 0, 0]),
        ("true", [np.inf] * 5),
        ("a && false", [-np.inf] * 5),
    ],
)
def test_availability_by_hand(text, values):
    assert robustness(parse(text), TRACE).tolist() == values


def test_a_task_staffs_every_state_at_all_its_steps():
    assert robustness(parse("T(1,a,{(fly,0)})", "catl"), TRACE).tolist() == [0, 0, 0, 0]
    counts = np.array([[2, 2, 2, 0], [3, 1, 1, 1]])
    trace = CountTrace({None: counts, "c": counts}, {"a": np.array([0, 1])})
    task = parse("T(2,a,{(c,1)})", "catl")
    assert robustness(task, trace).tolist() == [0, -1]
    assert robustness(logic.translate(task, interval="half-open"), trace).tolist() == [0, 0, -1]


def test_a_limit_bounds_the_fullest_of_several_states():
    counts = np.array([[0, 0], [3, 1]])
    trace = CountTrace({None: counts, "c": counts}, {"a": np.array([0, 1])})
    assert robustness(parse("L(a,{(c,2)})", "catl"), trace).tolist() == [-1, 1]
    assert robustness(parse("L(a,{})", "catl"), trace).tolist() == [-3, -1]


def test_until_away_from_the_first_step_looks_from_there():
    counts = np.array([[0, 0, 1, 1, 0], [1, 0, 0, 0, 1]])
    trace = CountTrace({None: counts}, {"a": np.array([0]), "b": np.array([1])})
    assert holds(parse("F[2,2] (a U[0,2] b)"), trace).tolist() == [True]
    assert holds(parse("a U[0,2] b"), trace).tolist() == [True, False, True]


def test_until_excludes_the_step_of_the_right_side():
    counts = np.array([[1, 0], [0, 1]])
    trace = CountTrace({None: counts}, {"a": np.array([0]), "b": np.array([1])})
    assert holds(parse("a U[1,1] b"), trace).tolist() == [True]
    assert holds(parse("a U[1,1] (a && b)"), trace).tolist() == [False]


def test_horizon_zero_and_a_trace_of_one_step():
    trace = CountTrace({None: np.array([[1]])}, {"a": np.array([0])})
    assert robustness(parse("a"), trace).tolist() == [0.0]
    assert robustness(parse("F[0,0] !a"), trace).tolist() == [-1.0]
    assert robustness(parse("true"), trace).tolist() == [np.inf]


def test_signals():
    trace = SignalTrace({"x": np.array([0.0, 2.0, 5.0]), "y": np.array([1.0, 1.0, -1.0])})
    assert robustness(parse("2*x - y >= 1", "stl"), trace).tolist() == [-2.0, 2.0, 10.0]
    assert robustness(parse("!(x > 2)", "stl"), trace).tolist() == [2.0, 0.0, -3.0]
    assert robustness(parse("x != 2", "stl"), trace).tolist() == [2.0, 0.0, 3.0]
    assert robustness(parse("3 > 2", "stl"), trace).tolist() == [1.0, 1.0, 1.0]
    # strict and other relations agree in robustness; truth tells them apart on the border
    assert holds(parse("x > 2", "stl"), trace).tolist() == [False, False, True]
    assert holds(parse("x >= 2", "stl"), trace).tolist() == [False, True, True]


def test_batches_of_constants_have_their_shape():
    trace = SignalTrace({"x": np.zeros((4, 2, 6))})
    assert robustness(parse("F[0,2] true", "stl"), trace).shape == (4, 2, 4)
    assert holds(parse("x > 1 || true", "stl"), trace).shape == (4, 2, 6)


@pytest.mark.parametrize(
    ("text", "language", "trace", "message"),
    [
        ("F[0,5] a", "mtl", TRACE, "looks 5 steps ahead, the trace has only 5; 1 more"),
        ("bb", "mtl", TRACE, "no state has the label 'bb'; did you mean 'b'"),
        ("x > 2", "stl", TRACE, "compares signals"),
        ("a", "mtl", SignalTrace({"x": np.zeros(3)}), "counts agents"),
        ("xx > 2", "stl", SignalTrace({"x1": np.zeros(3)}), "no signal 'xx'"),
        ("sum(a) > 30%", "mtl", TRACE, "percentage"),
        ("a", "mtl", CountTrace({"fly": FLYING}, PLACES), "all agents"),
    ],
)
def test_traces_that_do_not_fit_are_refused(text, language, trace, message):
    with pytest.raises(ValueError, match=message):
        robustness(parse(text, language), trace)


@pytest.mark.parametrize(
    "make",
    [
        lambda: CountTrace({}, PLACES),
        lambda: CountTrace({None: np.zeros(4)}, PLACES),
        lambda: CountTrace({None: EVERYONE, "fly": FLYING[:, 1:]}, PLACES),
        lambda: SignalTrace({}),
        lambda: SignalTrace({"x": np.float64(1)}),
        lambda: SignalTrace({"x": np.zeros(3), "y": np.zeros(4)}),
    ],
)
def test_traces_of_unlike_arrays_are_refused(make):
    with pytest.raises(ValueError, match=r"trace|shape"):
        make()


def test_windows_of_every_length():
    values = np.random.default_rng(5).integers(0, 100, 40)
    for low in range(4):
        for high in range(low, 36):
            least = [values[t + low : t + high + 1].min() for t in range(40 - high)]
            assert windowed(values, low, high, np.minimum).tolist() == least


def test_changeovers_of_every_length():
    left, right = np.random.default_rng(6).integers(0, 100, (2, 24))
    for low in range(5):
        for high in range(low, 20):
            wanted = [
                max(min([right[s], *left[t:s]]) for s in range(t + low, t + high + 1))
                for t in range(24 - high)
            ]
            assert switched((left, right), (low, high), np.maximum, np.minimum).tolist() == wanted
