"""What the monitor is made of, against progression and evaluation."""

from __future__ import annotations

from random import Random

import numpy as np
from hypothesis import given
from hypothesis import strategies as st

from tests.seeds import quick, seeds
from tests.test_progression import cut
from tsplan.logic import (
    FALSE,
    TRUE,
    Count,
    CountTrace,
    Known,
    horizon,
    parse,
    positive,
    progress,
    robustness,
    simplify,
    substitute,
    walk,
)
from tsplan.logic.evaluation import margins
from tsplan.logic.settled import settled
from tsplan.monitoring.decisions import FAILS, HOLDS, OPEN, Decisions
from tsplan.monitoring.lateness_runs import LatenessRuns
from tsplan.monitoring.margin_network import MarginNetwork
from tsplan.testing.formula_strategies import count_trace, formulas, judged


@quick
@given(judged("mtl", extra=1))
def test_what_is_decided_is_what_progression_leaves_settled(case):
    """By truth: a margin may still change of what holds for certain."""
    _, formula, trace = case
    goal = simplify(positive(formula))
    decisions = Decisions([goal])
    truths = {atom: m >= 0 for atom, m in margins(goal, trace).items() if isinstance(atom, Count)}
    for now in range(trace.steps):
        for atom, held in truths.items():
            decisions.note(atom, now, now, HOLDS if held[now] else FAILS)
        decisions.settle()
        rest = progress(goal, cut(trace, slice(now + 1)))
        known = settled(simplify(by_truth(rest)))
        assert decisions.truth(goal) == (OPEN if known is None else HOLDS if known.holds else FAILS)


def by_truth(formula):
    """The formula with true and false in place of known margins."""
    known = [node for node in walk(formula) if isinstance(node, Known)]
    return substitute(formula, {node: TRUE if node.margin >= 0 else FALSE for node in known})


def both_rows(values):
    return np.stack([values, -values])


@quick
@given(st.lists(formulas("mtl", leaves=5), min_size=1, max_size=3), seeds)
def test_margins_that_change_are_those_that_are_evaluated(given_formulas, seed):
    goals = list(dict.fromkeys(simplify(positive(formula)) for formula in given_formulas))
    steps = max(map(horizon, goals)) + 1
    trace, random = count_trace(seed, steps), Random(seed)
    network = MarginNetwork(goals)
    atoms = {node for goal in goals for node in walk(goal) if not node.children}
    for _ in range(4):
        for atom in atoms:
            network.tell(atom, 0, both_rows(robustness(atom, trace)))
        network.settle()
        for goal in goals:
            assert network.value(goal)[0] == robustness(goal, trace)[0]
        step = random.randrange(steps)
        for name, counts in trace.counts.items():
            counts[:, step : step + 3] += random.choice([0, 1]) if name is None else 0


def test_a_long_window_is_looked_at_by_blocks():
    formula, random = parse("G[0,999] (sum(a) >= 2)"), np.random.default_rng(3)
    counts = random.integers(5, 50, (1, 1000))
    trace = CountTrace({None: counts}, {"a": np.array([0])})
    network, atom = MarginNetwork([formula]), parse("sum(a) >= 2")
    network.tell(atom, 0, both_rows(counts[0] - 2.0))
    for _ in range(60):
        network.settle()
        assert network.value(formula)[0] == robustness(formula, trace)[0]
        first = int(random.integers(0, 1000))
        counts[0, first : first + 90] += random.integers(-4, 5)
        network.tell(atom, first, both_rows(counts[0, first : first + 90] - 2.0))


@quick
@given(st.lists(st.booleans(), min_size=1, max_size=12), st.data())
def test_runs_are_those_of_the_truths_as_they_are_by_then(truths, data):
    held = np.array(truths)
    runs = LatenessRuns(held)
    found = np.full(held.size, np.nan)
    first, values = runs.refresh(0, held, 0)
    found[first : first + values.size] = values
    for now in range(held.size):
        if data.draw(st.booleans()):
            begin = data.draw(st.integers(now, held.size - 1))
            end = data.draw(st.integers(begin + 1, held.size))
            held[begin:end] = data.draw(
                st.lists(st.booleans(), min_size=end - begin, max_size=end - begin)
            )
            first, values = runs.refresh(begin, held[begin:end], now)
            found[first : first + values.size] = values
        begun = runs.begun(now)
        if begun is not None:
            first, values = begun
            found[first : first + values.size] = values
        assert found.tolist() == [spare(held, step, now) for step in range(held.size)]


def spare(held, step, now):
    """By how many steps what an atom is at a step can be late, by trying."""
    if not held[step]:
        return -np.inf
    for late in range(1, step - now + 1):
        if not held[step - late]:
            return late - 1
    return np.inf
