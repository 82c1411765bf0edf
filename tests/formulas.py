"""Random formulas and traces for tests, as hypothesis strategies.

`formulas(language)` draws formulas whose names the traces know, with `plain=False` any formula of
the language. `trace_for` makes a random trace that is long enough for a formula, `judged` both.
"""

from __future__ import annotations

from fractions import Fraction

import numpy as np
from hypothesis import settings
from hypothesis import strategies as st

from tsplan import logic
from tsplan.logic import CountTrace, SignalTrace

LABELS = ("a", "b", "depot")
CAPABILITIES = (None, "c", "fly")
SIGNALS = ("x", "y", "z")
STATES = 4
PLACES = {"a": [0], "b": [1, 2], "depot": [0, 2, 3]}

_odd = st.text(alphabet='ab_1 ."\\-äF(', min_size=1, max_size=5)
_words = st.sampled_from(
    ["a", "b1", "_x", "F", "G", "U", "R", "X", "T", "L", "F1", "sum", "min", "max", "TRUE", "true"]
)
odd_names = st.one_of(_words, _odd)
relations = st.sampled_from(logic.atoms.RELATIONS)


def whole_numbers(low=-3, high=6):
    return st.integers(low, high)


@st.composite
def intervals(draw, longest=3):
    low = draw(st.integers(0, longest))
    return low, low + draw(st.integers(0, longest))


@st.composite
def counts(draw, plain=True, percent=False):
    label = draw(st.sampled_from(LABELS) if plain else odd_names)
    capability = draw(st.sampled_from(CAPABILITIES) if plain else st.none() | odd_names)
    bound = draw(whole_numbers())
    if percent and draw(st.booleans()):
        bound = logic.Percent(Fraction(draw(st.integers(0, 1000)), 10))
    function = draw(st.sampled_from(logic.atoms.FUNCTIONS))
    return logic.Count(function, label, capability, draw(relations), bound)


@st.composite
def predicates(draw, plain=True):
    names = st.sampled_from(SIGNALS) if plain else odd_names
    numbers = st.integers(-4, 4).map(float)
    if not plain:
        numbers = st.floats(allow_nan=False, allow_infinity=False, width=32)
    terms = draw(st.lists(st.tuples(names, numbers), max_size=3, unique_by=lambda term: term[0]))
    return logic.Linear(tuple(terms), draw(relations), draw(numbers))


@st.composite
def needs(draw, plain=True, least=0):
    names = st.sampled_from([name for name in CAPABILITIES if name]) if plain else odd_names
    pairs = st.tuples(names, st.integers(0, 4))
    return tuple(draw(st.lists(pairs, min_size=least, max_size=2, unique_by=lambda pair: pair[0])))


@st.composite
def tasks(draw, plain=True, least_duration=0):
    label = draw(st.sampled_from(LABELS) if plain else odd_names)
    duration = draw(st.integers(least_duration, 3))
    resources = ()
    if not plain:
        resources = tuple(draw(st.dictionaries(odd_names, st.floats(0, 1e6), max_size=2)).items())
    return logic.Task(duration, label, draw(needs(plain, least=1)), resources)


@st.composite
def limits(draw, plain=True):
    label = draw(st.sampled_from(LABELS) if plain else odd_names)
    return logic.Limit(label, draw(needs(plain)))


def atoms(language, *, plain=True):
    constants = st.sampled_from([logic.TRUE, logic.FALSE])
    if language == "stl":
        return st.one_of(predicates(plain), predicates(plain), constants)
    kinds = [counts(plain, percent=not plain), constants]
    if language == "catl":
        kinds = [tasks(plain), limits(plain), *kinds]
    return st.one_of(*kinds)


@st.composite
def _operators(draw, below):
    kind = draw(st.integers(0, 7))
    if kind == 0:
        return ~draw(below)
    if kind in (1, 2):
        parts = tuple(draw(st.lists(below, min_size=2, max_size=3)))
        return logic.And(parts) if kind == 1 else logic.Or(parts)
    if kind == 3:
        return draw(below) >> draw(below)
    if kind == 4:
        return draw(below).iff(draw(below))
    low, high = draw(intervals())
    if kind == 5:
        window = draw(st.sampled_from([logic.Eventually, logic.Always]))
        return window(low, high, draw(below))
    switch = draw(st.sampled_from([logic.Until, logic.Release]))
    return switch(low, high, draw(below), draw(below))


def formulas(language="mtl", *, plain=True, leaves=8):
    """Formulas of a language; `plain` ones only use the names and numbers the traces know."""
    return st.recursive(atoms(language, plain=plain), _operators, max_leaves=leaves)


def count_trace(seed, steps, batch=()):
    """Counts of agents; every capability at most counts all agents there."""
    random = np.random.default_rng(seed)
    everyone = random.integers(0, 4, (*batch, STATES, steps))
    counted = {name: random.integers(0, everyone + 1) for name in CAPABILITIES if name}
    places = {label: np.array(states) for label, states in PLACES.items()}
    return CountTrace({None: everyone, **counted}, places)


def signal_trace(seed, steps, batch=()):
    """Whole-numbered signals, so that no rounding hides a difference."""
    random = np.random.default_rng(seed)
    drawn = {name: random.integers(-5, 6, (*batch, steps)).astype(float) for name in SIGNALS}
    return SignalTrace(drawn)


def trace_for(language, formula, seed, *, extra=3, batch=()):
    """A random trace on which a formula can be judged at `1 + extra` steps."""
    steps = logic.horizon(formula) + 1 + extra
    make = signal_trace if language == "stl" else count_trace
    return make(seed, steps, batch)


quick = settings(max_examples=50, deadline=None)
seeds = st.integers(0, 2**32 - 1)
languages = st.sampled_from(logic.LANGUAGES)


@st.composite
def judged(draw, language=None, *, extra=3):
    """A language, one of its plain formulas, and a trace for it."""
    chosen = language or draw(languages)
    formula = draw(formulas(chosen))
    return chosen, formula, trace_for(chosen, formula, draw(seeds), extra=extra)
