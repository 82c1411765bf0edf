"""Hypothesis strategies for formulas of every language, and random traces to judge them on."""

from __future__ import annotations

from dataclasses import dataclass
from fractions import Fraction
from typing import cast

import numpy as np
from hypothesis import strategies as st

from tsplan import logic
from tsplan.logic import CountTrace, Formula, Language, SignalTrace
from tsplan.logic.atoms import FUNCTIONS, RELATIONS
from tsplan.logic.traces import Values
from tsplan.logic.weight_values import Weight, Weights

STATES = 4
PLACES = {"a": (0,), "b": (1, 2), "depot": (0, 2, 3)}
"""The states with each label in a random trace of counts."""

_TROUBLE = (
    "a",
    "b1",
    "_x",
    *"FGURXTL",
    "F1",
    "sum",
    "min",
    "max",
    "known",
    "one",
    "in",
    "TRUE",
    "true",
)
_ANY_NAME = st.one_of(
    st.sampled_from(_TROUBLE), st.text(alphabet='ab_1 ."\\-äF(', min_size=1, max_size=5)
)
_KNOWN_MARGINS = st.integers(-3, 3).map(logic.Known)


@dataclass(frozen=True)
class Vocabulary:
    """The names that formulas may use. With `anything`, any names and numbers that can be written.

    Those of KNOWN are the ones that random traces know.
    """

    labels: tuple[str, ...] = tuple(PLACES)
    capabilities: tuple[str, ...] = ("c", "fly")
    signals: tuple[str, ...] = ("x", "y", "z")
    anything: bool = False

    def names(self, known: tuple[str, ...]) -> st.SearchStrategy[str]:
        """Some of the names of one kind; there may be none."""
        if self.anything:
            return _ANY_NAME
        return st.sampled_from(known) if known else st.nothing()


KNOWN = Vocabulary()
ANYTHING = Vocabulary(anything=True)


def formulas(
    language: Language = "mtl", words: Vocabulary = KNOWN, *, leaves: int = 8
) -> st.SearchStrategy[Formula]:
    """Formulas of a language with at most `leaves` atoms, over the names of a vocabulary.

    >>> from hypothesis import HealthCheck, given, settings
    >>> @settings(max_examples=5, deadline=None, database=None, suppress_health_check=HealthCheck)
    ... @given(formulas("catl", ANYTHING))
    ... def reading_undoes_printing(formula):
    ...     assert logic.parse(str(formula), "catl") is formula
    >>> reading_undoes_printing()
    """
    numbers = _weights(words) if language.startswith("w") else st.none()
    return st.recursive(
        atoms(language, words), lambda below: _operators(below, numbers), max_leaves=leaves
    )


def atoms(language: Language, words: Vocabulary = KNOWN) -> st.SearchStrategy[Formula]:
    """Atoms of a language, and now and then a constant."""
    constants = st.sampled_from([logic.TRUE, logic.FALSE])
    if language.endswith("stl"):
        return st.one_of(_linear(words), _linear(words), constants)
    if language == "catl":
        return st.one_of(_tasks(words), _limits(words), _counts(words), constants, _KNOWN_MARGINS)
    return st.one_of(_counts(words), _counts(words), constants, _KNOWN_MARGINS)


@st.composite
def intervals(draw: st.DrawFn, longest: int = 3) -> tuple[int, int]:
    """The two ends of a window of at most `longest` steps, which starts as early."""
    low = draw(st.integers(0, longest))
    return low, low + draw(st.integers(0, longest))


@st.composite
def _counts(draw: st.DrawFn, words: Vocabulary) -> Formula:
    label = draw(words.names(words.labels))
    capability = draw(st.none() | words.names(words.capabilities))
    bound: int | logic.Percent = draw(st.integers(-3, 6))
    if words.anything and draw(st.booleans()):
        bound = logic.Percent(Fraction(draw(st.integers(0, 1000)), 10))
    function, relation = draw(st.sampled_from(FUNCTIONS)), draw(st.sampled_from(RELATIONS))
    return logic.Count(function, label, capability, relation, bound)


@st.composite
def _linear(draw: st.DrawFn, words: Vocabulary) -> Formula:
    numbers: st.SearchStrategy[float] = st.integers(-4, 4).map(float)
    if words.anything:
        numbers = st.floats(allow_nan=False, allow_infinity=False, width=32)
    pairs = st.tuples(words.names(words.signals), numbers)
    terms = draw(st.lists(pairs, max_size=3, unique_by=lambda term: term[0]))
    return logic.Linear(tuple(terms), draw(st.sampled_from(RELATIONS)), draw(numbers))


@st.composite
def _needs(draw: st.DrawFn, words: Vocabulary, least: int = 0) -> tuple[tuple[str, int], ...]:
    pairs = st.tuples(words.names(words.capabilities), st.integers(0, 4))
    return tuple(draw(st.lists(pairs, min_size=least, max_size=2, unique_by=lambda pair: pair[0])))


@st.composite
def _tasks(draw: st.DrawFn, words: Vocabulary) -> Formula:
    label, duration = draw(words.names(words.labels)), draw(st.integers(0, 3))
    resources = st.dictionaries(_ANY_NAME, st.floats(0, 1e6), max_size=2 if words.anything else 0)
    amounts = tuple(draw(resources).items())
    return logic.Task(duration, label, draw(_needs(words, 1)), amounts, draw(_begun(duration)))


def _begun(duration: int) -> st.SearchStrategy[int]:
    """How long ago a task has begun; most begin now."""
    return st.just(0) | st.integers(0, duration)


@st.composite
def _limits(draw: st.DrawFn, words: Vocabulary) -> Formula:
    return logic.Limit(draw(words.names(words.labels)), draw(_needs(words)))


def _weights(words: Vocabulary) -> st.SearchStrategy[Weight | None]:
    """Weights for any parts or steps, and now and then none."""
    number: st.SearchStrategy[float] = st.integers(1, 8).map(lambda eighths: eighths / 4)
    if words.anything:
        number = st.floats(0, exclude_min=True, allow_infinity=False)
    lasting = st.lists(number, min_size=1, max_size=4)
    return st.none() | lasting.map(lambda cycle: lambda index: cycle[index % len(cycle)])


@st.composite
def _operators(
    draw: st.DrawFn, below: st.SearchStrategy[Formula], numbers: st.SearchStrategy[Weight | None]
) -> Formula:
    kind = draw(st.integers(0, 7))
    if kind == 0:
        return draw(st.sampled_from([logic.Not, logic.Not, logic.Whole]))(draw(below))
    weights = cast("Weights", draw(numbers))  # nodes turn functions into numbers
    if kind in (1, 2):
        parts = tuple(draw(st.lists(below, min_size=2, max_size=3)))
        return logic.And(parts, weights) if kind == 1 else logic.Or(parts, weights)
    if kind == 3:  # noqa: PLR2004  (the numbers of operators mean nothing)
        return draw(below) >> draw(below)
    if kind == 4:  # noqa: PLR2004
        return draw(below).iff(draw(below))
    low, high = draw(intervals())
    if kind == 5:  # noqa: PLR2004
        window = draw(st.sampled_from([logic.Eventually, logic.Always]))
        return window(low, high, draw(below), weights)
    switch = draw(st.sampled_from([logic.Until, logic.Release]))
    return switch(low, high, draw(below), draw(below), weights)


def count_trace(seed: int, steps: int, batch: tuple[int, ...] = ()) -> CountTrace:
    """Random counts of agents over PLACES; every capability counts at most all agents there."""
    random = np.random.default_rng(seed)
    counts: dict[str | None, Values] = {None: random.integers(0, 4, (*batch, STATES, steps))}
    for name in KNOWN.capabilities:
        counts[name] = random.integers(0, counts[None] + 1)
    return CountTrace(counts, {label: np.array(states) for label, states in PLACES.items()})


def signal_trace(seed: int, steps: int, batch: tuple[int, ...] = ()) -> SignalTrace:
    """Random signals of whole numbers, so that no rounding hides a difference."""
    random = np.random.default_rng(seed)
    drawn = {name: random.integers(-5, 6, (*batch, steps)).astype(float) for name in KNOWN.signals}
    return SignalTrace(drawn)


def trace_for(
    language: Language,
    formula: Formula,
    seed: int,
    *,
    extra: int = 3,
    batch: tuple[int, ...] = (),
) -> CountTrace | SignalTrace:
    """A random trace on which a formula can be judged at `1 + extra` steps.

    >>> trace_for("mtl", logic.parse("F[0,5] a"), seed=1, extra=0).steps
    6
    """
    steps = logic.horizon(formula) + 1 + extra
    make = signal_trace if language.endswith("stl") else count_trace
    return make(seed, steps, batch)


@st.composite
def judged(
    draw: st.DrawFn, language: Language | None = None, *, extra: int = 3
) -> tuple[Language, Formula, CountTrace | SignalTrace]:
    """A language, one of its formulas, and a trace for it: what laws of meaning are tested on."""
    chosen = draw(st.sampled_from(logic.LANGUAGES)) if language is None else language
    formula = draw(formulas(chosen))
    seed = draw(st.integers(0, 2**32 - 1))
    return chosen, formula, trace_for(chosen, formula, seed, extra=extra)
