"""Progression: what remains of a formula is worth on the rest what the formula is on the whole."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from tests.seeds import quick, seeds
from tsplan import logic
from tsplan.errors import FormulaError
from tsplan.logic import CountTrace, Formula, Known, SignalTrace, holds, parse, progress, robustness
from tsplan.logic.dominance import Dominance
from tsplan.logic.progression import still_executed
from tsplan.logic.traces import Trace
from tsplan.testing.formula_strategies import formulas, judged, trace_for

PLAIN = ("mtl", "catl", "stl")


def cut(trace: Trace, steps: slice) -> Trace:
    """Some of the steps of a trace."""
    if isinstance(trace, SignalTrace):
        return SignalTrace({name: values[..., steps] for name, values in trace.signals.items()})
    parts = {
        part: {name: values[..., steps] for name, values in getattr(trace, part).items()}
        for part in ("counts", "most", "executions")
    }
    return replace(trace, **parts)


def judged_first(formula: Formula, trace: Trace) -> tuple[float, bool]:
    """Robustness and truth at the first step; what is long enough for the formula is known."""
    return float(robustness(formula, trace)[0]), bool(holds(formula, trace)[0])


@st.composite
def cases(draw):
    _, formula, trace = draw(judged(draw(st.sampled_from(PLAIN)), extra=4))
    return formula, trace, draw(st.integers(0, trace.steps - 1))


@quick
@given(cases())
def test_the_remainder_is_worth_on_the_rest_what_the_formula_is_on_the_whole(case):
    formula, trace, now = case
    rest = progress(formula, cut(trace, slice(now)))
    assert judged_first(rest, cut(trace, slice(now, None))) == judged_first(formula, trace)


@quick
@given(cases(), st.data())
def test_progress_in_two_goes_is_progress_in_one(case, data):
    formula, trace, now = case
    first = data.draw(st.integers(0, now))
    between = progress(progress(formula, cut(trace, slice(first))), cut(trace, slice(first, now)))
    rest = cut(trace, slice(now, None))
    at_once = progress(formula, cut(trace, slice(now)))
    assert judged_first(between, rest) == judged_first(at_once, rest)


@quick
@given(st.data(), seeds)
def test_it_is_so_where_bounds_from_above_have_counts_of_their_own(data, seed):
    formula = data.draw(formulas("mtl"))
    trace = trace_for("mtl", formula, seed)
    most = {name: values + 1 for name, values in trace.counts.items()}
    trace = replace(trace, most=most)
    now = data.draw(st.integers(0, trace.steps - 1))
    rest = progress(formula, cut(trace, slice(now)))
    assert judged_first(rest, cut(trace, slice(now, None))) == judged_first(formula, trace)


def test_the_border_of_signals_keeps_its_truth():
    past = {"x": np.array([3.0, 3.0])}
    for text, known in (("F[0,3] x > 3", "0 > 0"), ("F[0,3] x >= 3", "0 >= 0")):
        left = parse(text, "stl").child
        rest = progress(parse(text, "stl"), past)
        assert rest is parse(known, "stl") | left.eventually(0, 1)
        assert judged_first(rest, SignalTrace({"x": np.zeros(2)})) == (0.0, ">=" in known)
    assert progress(parse("!(x > 3)", "stl"), past) is parse("0 >= 0", "stl")


@pytest.mark.long
@settings(max_examples=4000, deadline=None)
@given(cases())
def test_the_law_on_many(case):
    formula, trace, now = case
    rest = progress(formula, cut(trace, slice(now)))
    assert judged_first(rest, cut(trace, slice(now, None))) == judged_first(formula, trace)


# --- the form of the remainder ------------------------------------------------------------------


def counted(*numbers: int) -> CountTrace:
    """So many agents at the one state, labelled a, step by step."""
    return CountTrace({None: np.array([numbers])}, {"a": np.array([0])})


@pytest.mark.parametrize(
    ("text", "remainder"),
    [
        ("a", "known(1)"),
        ("!a", "known(-2)"),
        ("F[0,9] sum(a) >= 5", "known(-2) || F[0,6] sum(a) >= 5"),
        ("F[5,9] a", "F[2,6] a"),
        ("G[0,1] a", "known(1)"),
        ("G[0,2] a", "known(0)"),
        ("G[1,4] a", "known(0) && G[0,1] a"),
        ("F[0,1] a && G[3,4] a", "known(2) && G[0,1] a"),
        ("F[0,4] G[0,1] a", "known(1) || F[0,1] G[0,1] a"),
        ("a U[0,5] sum(a) >= 4", "known(-1) || (known(0) && (a U[0,2] sum(a) >= 4))"),
        ("true U[3,5] a", "F[0,2] a"),
        ("(sum(a) <= 2) R[0,5] a", "known(0)"),
        ("F[0,9] false", "false"),
        ("G[0,9] (a || true)", "true"),
        (  # of the three windows that have begun the second is no stricter than the first
            "G[0,2] F[0,5] sum(a) >= 4",
            "(known(-1) || F[0,2] sum(a) >= 4) && (known(-3) || F[0,4] sum(a) >= 4)",
        ),
    ],
)
def test_the_remainder_is_as_short_as_can_be(text, remainder):
    assert progress(parse(text), counted(2, 3, 1)) is logic.simplify(parse(remainder))


def test_windows_in_windows_grow_with_the_margins_that_differ_and_no_more():
    formula = parse("G[20,40] F[0,10] a")
    for most in (1, 2, 3):
        random = np.random.default_rng(most)
        for now in range(20, 51):
            rest = progress(formula, counted(*random.integers(0, most + 1, now).tolist()))
            parts = rest.children if isinstance(rest, logic.And) else (rest,)
            assert len(parts) <= most + 3


def test_what_looks_far_ahead_is_progressed_at_once():
    text = "G[0,300] F[0,60] (G[0,20] a && F[0,40] sum(a) >= 2)"
    random = np.random.default_rng(1)
    rest = progress(parse(text), counted(*random.integers(0, 3, 150).tolist()))
    assert len(list(logic.walk(rest))) < 3000


def test_nothing_is_progressed_by_nothing():
    formula = parse("F[0,3] a && a")
    assert progress(formula, counted()) is formula


def test_what_cannot_be_progressed_is_refused():
    with pytest.raises(ValueError, match="has weights"):
        progress(parse("F[0,1]^2 a", "wmtl"), counted(1))
    with pytest.raises(ValueError, match="batch"):
        progress(parse("a"), CountTrace({None: np.ones((2, 1, 3))}, {"a": np.array([0])}))
    with pytest.raises(ValueError, match="percentage"):
        progress(parse("sum(a) >= 30%"), counted(1))
    with pytest.raises(ValueError, match="expected numbers"):
        progress(parse("a"), CountTrace({None: np.array([[0.5]])}, {"a": np.array([0])}))
    with pytest.raises(ValueError, match="about agents"):
        robustness(Known(1), SignalTrace({"x": np.zeros(1)}))


# --- executions ---------------------------------------------------------------------------------


def test_a_task_that_has_begun_is_what_is_left_of_it():
    text = "T(3,a,{(c,1)},{(oil,1),(drill,2)})"
    begun = parse(f"begun({text},2)", "catl")
    assert begun == replace(parse(text, "catl"), begun=2)
    assert (logic.horizon(begun), begun.left) == (1, 1)
    done = [n for n in logic.walk(logic.translate(parse(text, "catl"))) if n.children == ()][-1]
    going_on = still_executed(done, 2, {"oil"})
    wanted = logic.And((parse("G[0,1] min(a,c) >= 1"), going_on))
    assert logic.translate(begun, consumed={"oil"}) == wanted
    assert still_executed(still_executed(done, 1), 1, {"oil"}) == going_on
    spent = logic.translate(parse("begun(T(3,a,{(c,1)},{(oil,1)}),3)", "catl"), consumed={"oil"})
    assert spent == parse("G[0,0] min(a,c) >= 1")


@pytest.mark.parametrize("steps", ["0", "4", "1.5", "-1"])
def test_no_task_has_begun_when_it_is_over_or_not_yet(steps):
    with pytest.raises(FormulaError, match="1:22"):
        parse(f"begun(T(3,a,{{(c,1)}}),{steps})", "catl")


def test_executions_go_on_come_to_an_end_or_have_not_been():
    task = parse("T(2,a,{(c,1)},{(oil,1),(drill,2)})", "catl")
    begun = {str(task): np.array([[False, True, False, False, False, False]])}
    ones = {None: np.ones((1, 6), dtype=int), "c": np.ones((1, 6), dtype=int)}
    whole = CountTrace(ones, {"a": np.array([0])}, begun)
    late = logic.translate(parse(f"G[1,1] {task}", "catl"))
    for now in range(1, 6):
        rest = progress(late, cut(whole, slice(now)), consumed={"oil"})
        left = [node for node in logic.walk(rest) if isinstance(node, logic.Execution)]
        if now == 1 or now > 3:
            assert [node.last for node in left] == ([2] if now == 1 else [])
            continue
        (going_on,) = left
        assert (going_on.last, going_on.resources) == (3 - now, (("drill", 2.0),))
        assert going_on.needs == (("c", 1),)
        here = cut(whole, slice(now, None))
        assert not holds(rest, here)[0]
        told = {going_on.task: np.eye(1, here.steps, dtype=bool)}
        assert holds(rest, replace(here, executions={**here.executions, **told}))[0]
    never = progress(logic.translate(parse(f"{task}", "catl")), cut(whole, slice(2)))
    assert never is logic.FALSE


# --- what never decides -------------------------------------------------------------------------


@st.composite
def akin(draw: st.DrawFn) -> tuple[Formula, Formula]:
    """Two formulas that are put together from the same few parts."""
    leaves = [parse(text) for text in ("a", "sum(a) >= 2", "min(b,c) <= 1", "known(0)", "known(1)")]

    def windows(below: st.SearchStrategy[Formula]) -> st.SearchStrategy[Formula]:
        low = draw(st.integers(0, 1))
        ends = st.integers(low, 2)
        some, both = st.tuples(ends, below), st.tuples(below, below)
        return st.one_of(
            some.map(lambda part: part[1].eventually(low, part[0])),
            some.map(lambda part: part[1].always(low, part[0])),
            both.map(logic.And),
            both.map(logic.Or),
            both.map(lambda sides: sides[0].until(sides[1], low, 2)),
            both.map(lambda sides: sides[0].release(sides[1], low, 2)),
            below.map(logic.Not),
            below.map(logic.Whole),
        )

    made = st.recursive(st.sampled_from(leaves), windows, max_leaves=3)
    return draw(made), draw(made)


@quick
@given(akin(), seeds)
def test_what_is_at_most_another_formula_is_so_on_every_trace(pair, seed):
    lesser, other = pair
    both = logic.Or(pair)
    if Dominance().at_most(lesser, other):
        trace = trace_for("mtl", both, seed, extra=20)
        assert (
            robustness(both, trace) == robustness(other, trace)[: trace.steps - logic.horizon(both)]
        ).all()


def test_how_often_shapes_tell_is_not_never():
    pairs = [
        ("G[0,5] a", "G[1,3] a"),
        ("F[1,2] (a && b)", "F[0,4] a"),
        ("G[0,3] a", "F[2,7] a"),
        ("a", "b U[0,3] a"),
        ("b R[0,3] a", "a"),
        ("a U[1,2] b", "a U[0,3] (b || a)"),
        ("!F[0,4] a", "!F[1,2] (a && b)"),
        ("sum(a) >= 4", "sum(a) >= 2"),
        ("max(a) <= 1", "max(a) <= 2"),
        ("all(a, b)", "b"),
        ("known(-1)", "known(0) || a"),
        ("known(0) && a || known(-1)", "known(0)"),
    ]
    for lesser, other in ((parse(one), parse(two)) for one, two in pairs):
        assert Dominance().at_most(lesser, other), f"{lesser} is at most {other}"
        assert not Dominance().at_most(other, lesser)
