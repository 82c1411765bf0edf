"""Laws of formulas, on random ones: printing, negation, normal form, horizon, meaning."""

import itertools
import math

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from tests.seeds import languages, quick, seeds
from tsplan import logic
from tsplan.logic import (
    Always,
    And,
    Constant,
    Count,
    Eventually,
    Iff,
    Implies,
    Known,
    Limit,
    Linear,
    Not,
    Or,
    Release,
    Task,
    Until,
    Whole,
    holds,
    horizon,
    negation,
    parse,
    positive,
    robustness,
    simplify,
    translate,
)
from tsplan.testing.formula_strategies import ANYTHING, formulas, judged, signal_trace, trace_for

RELATIONS = {
    ">=": lambda value, bound: value >= bound,
    "<=": lambda value, bound: value <= bound,
    ">": lambda value, bound: value > bound,
    "<": lambda value, bound: value < bound,
    "=": lambda value, bound: value == bound,
    "!=": lambda value, bound: value != bound,
}


class Textbook:
    """Formulas by their definitions, step by step; remembers the last step that was read."""

    best, worst = staticmethod(max), staticmethod(min)

    def __init__(self, trace):
        self.trace = trace
        self.counted = isinstance(trace, logic.CountTrace)
        self.last = 0

    def constant(self, node):
        if isinstance(node, Known):
            return float(node.margin)
        return math.inf if node.value else -math.inf

    def negated(self, value):
        return -value - 1 if self.counted else -value

    def compared(self, relation, value, bound):
        strict = 1.0 if self.counted else 0.0
        above, below = value - bound, bound - value
        return {
            ">=": above,
            "<=": below,
            ">": above - strict,
            "<": below - strict,
            "=": min(above, below),
            "!=": max(above, below) - strict,
        }[relation]

    def measured(self, atom, time):
        if isinstance(atom, Linear):
            return sum(factor * self.trace.signals[name][time] for name, factor in atom.terms)
        here = [
            float(self.trace.counts[atom.capability][state, time])
            for state in self.trace.labels[atom.label]
        ]
        return {"sum": sum, "min": min, "max": max}[atom.function](here)

    def value(self, node, time):
        """The value at a step; every part is read, whether it matters or not."""
        if hasattr(node, "low"):
            return self.timed(node, time)
        below = [self.value(child, time) for child in node.children]
        denied = [self.negated(value) for value in below]
        self.last = max(self.last, time)
        match node:
            case Constant() | Known():
                found = self.constant(node)
            case Count() | Linear():
                found = self.compared(node.relation, self.measured(node, time), node.bound)
            case Not():
                found = denied[0]
            case Whole():
                found = below[0]
            case And():
                found = self.worst(below)
            case Or():
                found = self.best(below)
            case Implies():
                found = self.best([denied[0], below[1]])
            case Iff():
                found = self.best([self.worst(below), self.worst(denied)])
        return found

    def timed(self, node, time):
        steps = range(time + node.low, time + node.high + 1)
        outer, inner = self.best, self.worst
        if isinstance(node, Always | Release):
            outer, inner = inner, outer
        choices = []
        for step in steps:
            parts = [self.value(node.children[-1], step)]
            if len(node.children) > 1:
                parts += [self.value(node.left, before) for before in range(time, step)]
            choices.append(inner(parts))
        return outer(choices)


class Truth(Textbook):
    """The same with truth instead of robustness."""

    best, worst = staticmethod(any), staticmethod(all)

    def constant(self, node):
        return node.margin >= 0 if isinstance(node, Known) else node.value

    def negated(self, value):
        return not value

    def compared(self, relation, value, bound):
        return RELATIONS[relation](value, bound)


@quick
@given(st.data())
def test_a_printed_formula_parses_back_to_itself(data):
    language = data.draw(languages)
    formula = data.draw(formulas(language, words=ANYTHING))
    assert parse(str(formula), language) is formula


@quick
@given(judged())
def test_robustness_is_what_the_definitions_say(case):
    _, formula, trace = case
    plain = translate(formula)
    values = robustness(formula, trace)
    book = Textbook(trace)
    assert values.tolist() == [book.value(plain, time) for time in range(len(values))]


@quick
@given(judged())
def test_truth_is_what_the_definitions_say(case):
    _, formula, trace = case
    plain = translate(formula)
    values = holds(formula, trace)
    book = Truth(trace)
    assert values.dtype == np.bool_
    assert values.tolist() == [book.value(plain, time) for time in range(len(values))]


@quick
@given(judged())
def test_truth_and_robustness_agree(case):
    language, formula, trace = case
    true, values = holds(formula, trace), robustness(formula, trace)
    assert np.all(true[values > 0])
    assert not np.any(true[values < 0])
    if not language.endswith("stl"):
        assert np.array_equal(true, values >= 0)


@quick
@given(judged())
def test_negation_flips_truth_and_robustness(case):
    language, formula, trace = case
    plain = translate(formula)
    values = robustness(plain, trace)
    flipped = -values if language.endswith("stl") else -values - 1
    for denied in (negation(plain), ~formula):
        assert np.array_equal(robustness(denied, trace), flipped)
        assert np.array_equal(holds(denied, trace), ~holds(formula, trace))


@quick
@given(judged())
def test_the_normal_form_keeps_truth_and_robustness(case):
    _, formula, trace = case
    normal = positive(translate(formula))
    assert np.array_equal(robustness(normal, trace), robustness(formula, trace))
    assert np.array_equal(holds(normal, trace), holds(formula, trace))
    allowed = (And, Or, Always, Eventually, Until, Release, Constant, Count, Known, Linear)
    for node in logic.walk(normal):
        assert isinstance(node, allowed)
        if isinstance(node, Count):
            assert node.relation in (">=", "<=")
        if isinstance(node, Linear):
            assert node.relation in (">=", "<=", ">", "<")


@quick
@given(judged())
def test_negating_twice_is_the_normal_form(case):
    _, formula, trace = case
    twice = negation(negation(translate(formula)))
    assert np.array_equal(robustness(twice, trace), robustness(formula, trace))


@quick
@given(judged(extra=4))
def test_simplifying_keeps_robustness_and_never_looks_further(case):
    _, formula, trace = case
    simple = simplify(formula)
    assert horizon(simple) <= horizon(formula)
    values = robustness(formula, trace)
    assert np.array_equal(robustness(simple, trace)[: len(values)], values)
    assert simplify(simple) is simple


@quick
@given(judged(extra=0), seeds)
def test_the_horizon_is_sufficient_and_tight(case, seed):
    language, formula, trace = case
    plain = translate(formula)
    book = Textbook(trace)
    value = book.value(plain, 0)
    assert book.last == horizon(formula) == horizon(plain)
    assert robustness(formula, trace).tolist() == [value]
    if horizon(formula):
        short = trace_for(language, formula, seed, extra=-1)
        with pytest.raises(ValueError, match="1 more are needed"):
            robustness(formula, short)


@quick
@given(judged("catl"))
def test_translating_tasks_keeps_their_meaning(case):
    _, formula, trace = case
    plain = translate(formula)
    assert not any(isinstance(node, Task | Limit) for node in logic.walk(plain))
    for node in logic.walk(formula):
        if isinstance(node, Task):
            assert staffed(node, trace, node.left + 1) == holds(node, trace).tolist()
            if node.left:
                short = holds(translate(node, interval="half-open"), trace).tolist()
                assert staffed(node, trace, node.left) == short
        if isinstance(node, Limit):
            assert limited(node, trace) == holds(node, trace).tolist()
    assert np.array_equal(robustness(plain, trace), robustness(formula, trace))


def staffed(task, trace, lasting):
    """Directly from the words: every state with the label, every need, every step of the task."""
    steps = trace.steps - lasting + 1
    return [
        all(
            trace.counts[name][state, step] >= number
            for name, number in task.needs
            for state in trace.labels[task.label]
            for step in range(start, start + lasting)
        )
        for start in range(steps)
    ]


def limited(limit, trace):
    needs = limit.needs or ((None, 0),)
    return [
        all(
            trace.counts[name][state, step] <= number
            for name, number in needs
            for state in trace.labels[limit.label]
        )
        for step in range(trace.steps)
    ]


@quick
@given(st.data())
def test_a_batch_is_judged_like_its_members(data):
    language = data.draw(languages)
    formula = data.draw(formulas(language))
    trace = trace_for(language, formula, data.draw(seeds), batch=(2, 3))
    values = robustness(formula, trace)
    assert values.shape[:2] == (2, 3)
    for place in itertools.product(range(2), range(3)):
        if language.endswith("stl"):
            one = logic.SignalTrace({name: array[place] for name, array in trace.signals.items()})
        else:
            one = logic.CountTrace(
                {name: array[place] for name, array in trace.counts.items()}, trace.labels
            )
        assert np.array_equal(values[place], robustness(formula, one))


@quick
@given(st.data())
def test_substituting_a_part_by_itself_changes_nothing(data):
    formula = data.draw(formulas(data.draw(languages)))
    part = data.draw(st.sampled_from(list(logic.walk(formula))))
    assert logic.substitute(formula, {part: part}) is formula
    assert logic.substitute(formula, {formula: part}) is part


@quick
@given(st.data(), st.integers(0, 12))
def test_resolved_percentages_mean_the_exact_share(data, total):
    formula = data.draw(formulas("mtl", words=ANYTHING, leaves=3))
    resolved = logic.resolve_percent(formula, lambda _: total)
    for node in logic.walk(resolved):
        assert not (isinstance(node, Count) and isinstance(node.bound, logic.Percent))
    for node in logic.walk(formula):
        if isinstance(node, Count) and isinstance(node.bound, logic.Percent):
            whole = logic.resolve_percent(node, lambda _: total)
            for number in range(total + 1):
                wanted = RELATIONS[node.relation](number, node.bound.of(total))
                if isinstance(whole, Constant):
                    assert whole.value == wanted
                else:
                    assert RELATIONS[whole.relation](number, whole.bound) == wanted


@pytest.mark.long
@given(judged())
@settings(max_examples=3000, deadline=None)
def test_robustness_on_many_formulas(case):
    test_robustness_is_what_the_definitions_say.hypothesis.inner_test(case)


@pytest.mark.long
@given(st.data())
@settings(max_examples=3000, deadline=None)
def test_printing_many_formulas(data):
    test_a_printed_formula_parses_back_to_itself.hypothesis.inner_test(data)


def test_signals_agree_with_numpy_on_a_long_window():
    trace = signal_trace(1, 500)
    formula = parse("F[3,170] (x > 1) && G[0,99] (y <= 4)", language="stl")
    x, y = trace.signals["x"] - 1, 4 - trace.signals["y"]
    some = [max(x[t + 3 : t + 171]) for t in range(500 - 170)]
    wanted = [min([value, *y[t : t + 100]]) for t, value in enumerate(some)]
    assert robustness(formula, trace).tolist() == wanted
