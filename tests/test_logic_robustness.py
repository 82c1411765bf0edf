"""Kinds of robustness: by hand, by their definitions, and by their laws."""

from __future__ import annotations

import math
import random
from dataclasses import replace

import numpy as np
import pytest
from hypothesis import example, given, settings
from hypothesis import strategies as st

import tsplan
from tests.seeds import quick, seeds
from tsplan import logic
from tsplan.logic import (
    FALSE,
    TRUE,
    Always,
    And,
    Eventually,
    Or,
    Release,
    SignalTrace,
    Until,
    holds,
    linear,
    negation,
    parse,
    positive,
    robustness,
    translate,
)
from tsplan.logic.evaluation import KINDS, margins
from tsplan.logic.predicate_ranges import predicate_ranges
from tsplan.logic.weights import factors
from tsplan.testing.formula_strategies import formulas, judged, trace_for

BOUNDS = dict.fromkeys("xyz", (-5, 5))
WEIGHTED = st.sampled_from(["product", "normalised"])
ALL = (And, Always, Release)  # which are as good as their worst part


def top(node, drawn):
    """The same node with weights."""
    count = node.high - node.low + 1 if hasattr(node, "low") else len(node.children)
    return replace(node, weights=[drawn.choice((0.2, 0.5, 1, 2, 3)) for _ in range(count)])


def weighted(language="wstl", extra=3):
    return judged(language, extra=extra).map(lambda case: case[1:])


def ones(count):
    return (1.0,) * count


class Book:
    """Values of formulas over signals by their definitions, step by step."""

    def __init__(self, kind, trace):
        self.kind, self.trace = kind, trace

    def values(self, formula):
        plain = translate(formula)
        steps = self.trace.steps - logic.horizon(formula)
        return [self.value(plain, step) for step in range(steps)]

    def value(self, node, time):
        if not node.children:
            return float(robustness(node, self.trace, self.kind, BOUNDS)[time])
        if hasattr(node, "low"):
            window = range(time + node.low, time + node.high + 1)
            there = [self.value(node.children[-1], step) for step in window]
            one = len(node.children) == 1
            return self.all(node, there) if one else self.switch(node, time, there)
        below = [self.value(child, time) for child in node.children]
        negative = [-value for value in below]
        if isinstance(node, logic.Not | logic.Whole):
            return (negative if isinstance(node, logic.Not) else below)[0]
        if isinstance(node, logic.Implies):
            return self.some([negative[0], below[1]])
        if isinstance(node, logic.Iff):
            return self.some([self.all(TRUE & TRUE, values) for values in (below, negative)])
        return self.all(node, below)

    def some(self, values):
        return self.all(TRUE | TRUE, values)

    def all(self, node, values):
        """The parts of a node, whose weights may be missing."""
        if self.kind == "agm":
            return self.mean(node, values, node.weights or ones(len(values)))
        return (min if isinstance(node, ALL) else max)(self.scaled(node, values))

    def scaled(self, node, values):
        if node.weights is None:
            return values
        pairs = zip(values, factors(type(node), node.weights, self.kind), strict=True)
        return [value * (by.satisfied if value >= 0 else by.violated) for value, by in pairs]

    def mean(self, node, values, weights):
        sign, total = 1 if isinstance(node, ALL) else -1, sum(weights)
        pairs = [(sign * v, weight / total) for v, weight in zip(values, weights, strict=True)]
        if all(value > 0 for value, _ in pairs):
            return sign * (math.prod((1 + value) ** share for value, share in pairs) - 1)
        return sign * sum(min(value, 0) * share for value, share in pairs)

    def switch(self, node, time, there):
        """The change-over from the left side, up to each step of the window, to the right there."""
        if self.kind != "agm":
            there = self.scaled(node, there)
        left = [self.value(node.left, time + step) for step in range(node.high)]
        before = [left[:step] for step in range(node.low, node.high + 1)]
        changes = [[*one, own] for one, own in zip(before, there, strict=True)]
        until = isinstance(node, Until)
        if self.kind == "agm":
            inner = TRUE & TRUE if until else TRUE | TRUE
            found = [self.mean(inner, change, ones(len(change))) for change in changes]
            return self.mean(node, found, node.weights or ones(len(found)))
        pick, best = (min, max) if until else (max, min)
        return best(map(pick, changes))


def close(one, other):
    return np.allclose(one, other, rtol=1e-9, atol=1e-12)


@pytest.mark.parametrize("kind", KINDS[1:])
@quick
@given(case=weighted())
def test_values_are_what_the_definitions_say(kind, case):
    formula, trace = case
    assert close(robustness(formula, trace, kind, BOUNDS), Book(kind, trace).values(formula))


@pytest.mark.long
@pytest.mark.parametrize("kind", KINDS[1:])
@settings(max_examples=3000, deadline=None)
@given(case=weighted())
def test_values_of_many_formulas(kind, case):
    test_values_are_what_the_definitions_say.hypothesis.inner_test(kind, case)


@pytest.mark.parametrize("kind", KINDS)
@quick
@given(case=weighted())
def test_signs_are_those_of_traditional_robustness(kind, case):
    formula, trace = case
    values, plain = robustness(formula, trace, kind, BOUNDS), robustness(formula, trace)
    assert np.array_equal(np.sign(values), np.sign(plain))
    assert np.all(holds(formula, trace)[values > 0])
    assert not np.any(holds(formula, trace)[values < 0])


@pytest.mark.parametrize("kind", KINDS)
@quick
@given(case=weighted())
def test_negation_is_negative_and_pushes_through(kind, case):
    formula, trace = case
    values = robustness(formula, trace, kind, BOUNDS)
    assert np.array_equal(robustness(~formula, trace, kind, BOUNDS), -values)
    if kind != "agm":  # in whose normal form `=` has two parts
        assert np.array_equal(robustness(negation(formula), trace, kind, BOUNDS), -values)
        assert np.array_equal(robustness(positive(formula), trace, kind, BOUNDS), values)


@pytest.mark.parametrize("kind", KINDS)
@quick
@given(case=weighted(), seed=seeds)
def test_de_morgan(kind, case, seed):
    formula, trace = case
    x, drawn = linear({"y": 1}, ">", 1), random.Random(seed)
    pairs = [
        (And((formula, ~formula, x)), Or((~formula, formula, ~x))),
        (formula.always(0, 1), (~formula).eventually(0, 1)),
        (x.until(formula, 0, 1), (~x).release(~formula, 0, 1)),
    ]
    for one, dual in pairs:
        weights = drawn.choice((None, top(one, drawn).weights))
        values = robustness(replace(one, weights=weights), trace, kind, BOUNDS)
        denied = robustness(replace(dual, weights=weights), trace, kind, BOUNDS)
        assert np.array_equal(denied, -values)


@quick
@given(st.data(), seeds)
def test_a_batch_is_judged_like_its_members(data, seed):
    formula = data.draw(formulas("wstl"))
    trace = trace_for("wstl", formula, seed, batch=(2, 3))
    for kind in KINDS:
        values = robustness(formula, trace, kind, BOUNDS)
        one = {name: array[1, 2] for name, array in trace.signals.items()}
        assert close(values[1, 2], robustness(formula, one, kind, BOUNDS))
        assert values.shape[:2] == (2, 3)


@pytest.mark.parametrize("kind", KINDS)
@quick
@given(case=weighted(), seed=seeds)
def test_more_of_what_is_asked_for_never_gives_less(kind, case, seed):
    formula, trace = case
    asked = {node: rising(node) for node in logic.walk(positive(formula)) if not node.children}
    rises = logic.substitute(positive(formula), asked)
    more = np.random.default_rng(seed).integers(0, 3, trace.steps)
    higher = {name: array + more for name, array in trace.signals.items()}
    greater = robustness(rises, higher, kind, BOUNDS)
    assert np.all(greater >= robustness(rises, trace, kind, BOUNDS) - 1e-12)


def rising(atom):
    return linear({"x": 1}, ">=", atom.bound) if isinstance(atom, logic.Linear) else atom


# --- means ---

PYTELO = "!(x < 10) && F[0,2] (y > 2) || G[1,3] (z <= 8) && G[4,6] (z > 8)"


def test_the_example_of_the_first_implementation():
    trace = {"x": [8, 8, 11, 11, 11, 1, 1], "y": [1, 3, 2, 2, 2, 0, 0], "z": [3, 9, 8, 9, 9, 9, 9]}
    bounds = {"x": (0, 20), "y": (0, 10), "z": (0, 10)}
    arrays = {name: np.array(values, dtype=float) for name, values in trace.items()}
    found = tsplan.robustness(parse(PYTELO, "stl"), arrays, kind="agm", bounds=bounds)
    assert found == pytest.approx([-0.0416333], abs=5e-8)


def of_values(build, *values):
    """What `build` makes of formulas that are worth these values."""
    parts = [linear({f"s{place}": 1}, ">=", 0) for place in range(len(values))]
    trace = {f"s{place}": np.array([value]) for place, value in enumerate(values)}
    return float(robustness(build(parts), trace, "agm", dict.fromkeys(trace, (0, 1)))[0])


@pytest.mark.parametrize(
    ("build", "values", "expected"),
    [
        (lambda p: (p[0] & p[1]) & p[2], (0.1, 0.9, 0.5), 0.47259),  # parts are not regrouped
        (lambda p: And(tuple(p)), (0.1, 0.9, 0.5), 0.46357),
        (lambda p: p[0] & p[1], (0.3, 1.0), math.sqrt(1.3 * 2) - 1),  # what is certain counts
        (lambda p: p[0] & TRUE, (0.3,), math.sqrt(1.3 * 2) - 1),
        (lambda p: p[0] & p[1], (-0.3, 1.0), -0.15),
        (lambda p: p[0] & p[1], (0.0, 0.9), 0.0),
        (lambda p: p[0] | p[1], (0.0, -0.9), 0.0),
        (lambda p: p[0] | p[1], (0.2, -0.9), 0.1),
        (lambda p: p[0] | p[1], (-0.2, -0.9), 1 - math.sqrt(1.2 * 1.9)),
        (lambda p: p[0] >> p[1], (0.2, 0.4), 0.2),
        (lambda p: p[0].iff(p[1]), (0.2, -0.4), -(math.sqrt(1.2 * 1.1) - 1)),
        (lambda p: p[0] & FALSE, (0.4,), -0.5),
        (lambda p: And(tuple(p), (1, 3)), (0.1, 0.9), 1.1**0.25 * 1.9**0.75 - 1),
        (lambda p: And(tuple(p), (1, 3)), (-0.4, 0.9), -0.1),
        (lambda p: Or(tuple(p), (1, 3)), (-0.4, 0.8), 0.6),
    ],
)
def test_means_by_hand(build, values, expected):
    assert of_values(build, *values) == pytest.approx(expected, abs=5e-6)


def test_means_of_windows_and_changeovers_by_hand():
    x, y = np.array([0.1, 0.9, 0.5, -0.2]), np.array([-0.5, 0.2, 0.8, 0.1])
    bounds = {"x": (0, 1), "y": (0, 1)}

    def of(text):
        return robustness(parse(text, "stl"), {"x": x, "y": y}, "agm", bounds)[0]

    assert of("G[0,2] x >= 0") == pytest.approx(0.46357, abs=5e-6)
    assert of("G[1,3] x >= 0") == pytest.approx(-0.2 / 3)
    assert of("F[1,3] x >= 0") == pytest.approx(1.4 / 3)
    # change over at 0: -0.5; at 1: 0.1 and 0.2; at 2: 0.1, 0.9 and 0.8
    late = (1.1 * 1.9 * 1.8) ** (1 / 3) - 1
    assert of("(x >= 0) U[0,2] (y >= 0)") == pytest.approx((math.sqrt(1.1 * 1.2) - 1 + late) / 3)
    assert of("(x >= 0) U[2,2] (y >= 0)") == pytest.approx(late)
    assert of("!((x >= 0) U[0,2] (y >= 0))") == -of("(x >= 0) U[0,2] (y >= 0)")
    assert of("(x < 0) R[0,2] (y < 0)") == -of("(x >= 0) U[0,2] (y >= 0)")


@quick
@example(
    (
        parse("(x >= 0 && F[1,4] x >= 0) U[0,0] x >= 0", "wstl"),
        SignalTrace({"x": np.array([4.0, 2.0, 0.0, -3.0])}),
    )
)  # what the left side looks at ends before the trace does, and is never asked
@given(weighted())
def test_means_lie_between_the_least_and_the_greatest_part(case):
    formula, trace = case
    for node, values in margins(positive(formula), trace, "agm", BOUNDS).items():
        assert np.all(np.abs(values) <= 1)
        if isinstance(node, And | Or) and values.size:  # else it looks past the end of the trace
            each = [robustness(child, trace, "agm", BOUNDS) for child in node.children]
            length = min([values.shape[-1], *(part.shape[-1] for part in each)])
            low, high = (pick.reduce([part[:length] for part in each]) for pick in EXTREMES)
            assert np.all(values[:length] >= low - 1e-12)
            assert np.all(values[:length] <= high + 1e-12)


EXTREMES = (np.minimum, np.maximum)


@quick
@given(weighted(extra=0), seeds)
def test_means_of_equal_parts_are_these(case, seed):
    formula, trace = case
    value = robustness(formula, trace, "agm", BOUNDS)
    drawn = random.Random(seed)
    for kind in (And, Or):
        for join in (kind((formula,) * 3), top(kind((formula,) * 3), drawn)):
            assert close(robustness(join, trace, "agm", BOUNDS), value)
    still = {name: np.repeat(array[:1], 9) for name, array in trace.signals.items()}
    x = linear({"x": 1, "y": 2}, ">", 1)
    for window in (x.always(0, 6), x.eventually(1, 5), x.until(x, 0, 4), x.release(x, 2, 4)):
        found = robustness(top(window, drawn), still, "agm", BOUNDS)
        assert close(found, robustness(x, still, "agm", BOUNDS)[0])


def test_long_windows_are_true_means():
    x = np.random.default_rng(4).uniform(0.1, 1, 400)
    atom = linear({"x": 1}, ">=", 0)
    found = robustness(atom.always(3, 203), {"x": x}, "agm", {"x": (0, 1)})
    each = [np.exp(np.mean(np.log1p(x[t + 3 : t + 204]))) - 1 for t in range(400 - 203)]
    assert np.allclose(found, each, rtol=1e-13)


def test_ranges_of_predicates():
    atom = linear({"x": 2, "y": -3}, ">=", 1)
    assert predicate_ranges(atom, {"x": (0, 1), "y": (-1, 1), "other": (5, 1)})[atom] == 8
    # the margin 2 of 4, of 1 and of a range without extent
    for ends, wanted in (((0, 4), 0.5), ((2, 3), 1.0), ((3, 3), 1.0)):
        x = {"x": np.array([3.0])}
        assert robustness(linear({"x": 1}, ">=", 1), x, "agm", {"x": ends}) == [wanted]
    flat = robustness(parse("2 > 3 || x = 1", "stl"), {"x": np.ones(1)}, "agm", {"x": (0, 1)})
    assert flat == [0.0]


def test_bounds_are_complained_of_all_at_once():
    formula = parse("x > 1 && y > 2 && z > 3 && w > 4", "stl")
    bounds = {"x": (0, 1), "y": (0, math.inf), "z": (2, 1)}
    with pytest.raises(tsplan.FormulaError) as caught:
        robustness(formula, {"x": np.ones(1)}, "agm", bounds)
    assert [finding.message for finding in caught.value.findings] == [
        "the bounds 0 to inf of the signal 'y' are not finite",
        "the bounds of the signal 'z' end before they begin",
        "the signal 'w' has no bounds, which its share of its range needs",
    ]


def test_what_has_no_such_robustness():
    counts = logic.CountTrace({None: np.ones((1, 1))}, {"a": [0]})
    with pytest.raises(ValueError, match="'agm' is of signals"):
        robustness(parse("a"), counts, "agm")
    with pytest.raises(ValueError, match=r"no robustness of the kind 'ag'; did you mean 'agm'\?"):
        robustness(parse("a"), counts, "ag")
    with pytest.raises(ValueError, match="normal form"):
        margins(~parse("a"), counts, "product")


# --- weights ---


@quick
@given(weighted())
def test_weights_of_one_are_none_under_product(case):
    formula, trace = case
    one = logic.fold(
        formula,
        lambda node, below: (
            replace(node.over(below), weights=1) if hasattr(node, "weights") else node.over(below)
        ),
    )
    assert np.array_equal(robustness(one, trace, "product"), robustness(formula, trace))


@quick
@given(weighted(), st.sampled_from([0.25, 4.0]))
def test_product_is_homogeneous_in_the_weights_of_a_node(case, factor):
    formula, trace = case
    x = linear({"x": 1}, ">=", 1)
    for node in (
        And((formula, x), (1, 3)),
        Or((formula, x), (2, 1)),
        formula.always(0, 2, (1, 2, 4)),
    ):
        more = replace(node, weights=[factor * weight for weight in node.weights])
        values = robustness(node, trace, "product")
        assert np.array_equal(robustness(more, trace, "product"), factor * values)


@quick
@given(weighted(), WEIGHTED)
def test_parts_may_change_places_with_their_weights(case, kind):
    formula, trace = case
    parts = (formula, linear({"x": 1}, ">=", 1), linear({"y": 1}, "<", 0))
    for order in ((2, 0, 1), (1, 0, 2)):
        for join in (And, Or):
            plain = join(parts, (0.2, 0.3, 7))
            moved = join([parts[at] for at in order], [plain.weights[at] for at in order])
            values = robustness(plain, trace, kind)
            assert np.array_equal(robustness(moved, trace, kind), values)


@quick
@given(weighted(), WEIGHTED)
def test_windows_are_changeovers_from_constants(case, kind):
    formula, trace = case
    for weights in ((1, 0.5, 3), None):
        some = robustness(formula.eventually(0, 2, weights), trace, kind)
        assert np.array_equal(robustness(TRUE.until(formula, 0, 2, weights), trace, kind), some)
        every = robustness(formula.always(0, 2, weights), trace, kind)
        assert np.array_equal(robustness(FALSE.release(formula, 0, 2, weights), trace, kind), every)


@quick
@given(weighted("wmtl"), WEIGHTED)
def test_weighted_counts(case, kind):
    formula, trace = case
    values = robustness(formula, trace, kind)
    assert np.array_equal(values >= 0, holds(formula, trace))
    assert close(values, Book(kind, trace).values(positive(formula)))
    assert np.array_equal(
        robustness(negation(formula), trace, kind), robustness(~formula, trace, kind)
    )


def test_factors_are_positive_however_unlike_the_weights_are():
    for kind in (And, Or):
        for pair in factors(kind, (1e9, 1e-9, 1e-9), "normalised"):
            assert 0 < min(pair) <= max(pair) <= 1
    assert factors(Always, (7.0,), "normalised") == factors(Eventually, (0.1,), "normalised")
    assert factors(Until, (1.0, 3.0), "normalised")[1] == (0.75, 0.25)
    assert factors(Release, (1.0, 3.0), "normalised")[1] == (0.25, 0.75)


def test_weighted_values_by_hand():
    x, y = linear({"x": 1}, ">=", 0), linear({"y": 1}, ">=", 0)
    trace = SignalTrace({"x": np.array([4.0, -2, 3]), "y": np.array([1.0, 6, -1])})
    for formula, product, normalised in (
        (And((x, y), (1, 3)), 3.0, 0.25),
        (Or((x, y), (1, 3)), 4.0, 1.0),
        (x.always(0, 2, (1, 1, 2)), -2.0, -0.5),
        (x.eventually(0, 2, (1, 1, 2)), 6.0, 1.5),
        (y.until(x, 1, 2, (1, 3)), 1.0, 1.0),
        (x.release(y, 0, 1, (1, 3)), 1.0, 0.75),
    ):
        assert robustness(formula, trace, "product")[0] == product
        assert robustness(formula, trace, "normalised")[0] == normalised
