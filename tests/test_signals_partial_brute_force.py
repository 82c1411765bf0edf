"""Formulas over signals met in part, and preferences, against all signals on small grids.

What holds depends on which predicates hold when, so a value for each of their cells is enough where
signals move freely. An integrator whose bounds and thresholds are whole, and none of them strict,
can do with whole numbers what it can do at all: the constraints are of differences. No formula here
has strict comparisons, equations or negations.
"""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import replace
from fractions import Fraction
from itertools import product
from random import Random

import numpy as np
import pytest

import tsplan
from tests.seeds import seed_blocks
from tsplan.logic import Formula, Linear, SignalTrace, holds, horizon, parse, walk_all
from tsplan.logic.fraction import fraction, tree_of
from tsplan.logic.witness_steps import levels
from tsplan.mission import Preference
from tsplan.signals import System, free_signals, single_integrator
from tsplan.signals.signal_mission import SignalMission
from tsplan.signals.trajectory import Trajectory
from tsplan.testing.random_missions import random_formula, wholly

ORDERS = ("weighted", "hierarchical", "depth")
CELLS = (-0.5, 0.0, 0.5, 1.0, 1.5)
"""A value on, between and beyond the thresholds 0 and 1."""

WHOLE = (0.0, 1.0, 2.0, 3.0)
STEPS = {"free": 3, "pair": 1, "integrator": 4}


def system_of(kind: str) -> System:
    ends = (CELLS[0], CELLS[-1])
    if kind == "integrator":
        made = single_integrator(("x",), position=(WHOLE[0], WHOLE[-1]), speed=1)
        return replace(made, initial={"x": (1.0, 1.0)})
    return free_signals(x=ends) if kind == "free" else free_signals(x=ends, y=ends)


def every(kind: str) -> SignalTrace:
    """All signals that the grid allows, as one batch."""
    steps = STEPS[kind] + 1
    if kind == "integrator":
        moves = np.array([*product((-1.0, 0.0, 1.0), repeat=steps - 1)])
        paths = 1.0 + np.hstack([np.zeros((len(moves), 1)), np.cumsum(moves, axis=1)])
        within = (paths >= WHOLE[0]).all(axis=1) & (paths <= WHOLE[-1]).all(axis=1)
        return SignalTrace({"x": paths[within]})
    names = ("x", "y") if kind == "pair" else ("x",)
    values = np.array([*product(CELLS, repeat=steps * len(names))])
    rows = values.reshape(len(values), len(names), steps)
    return SignalTrace({name: rows[:, place] for place, name in enumerate(names)})


def random_atom(random: Random, kind: str) -> str:
    bound = random.choice(WHOLE) if kind == "integrator" else random.randint(0, 1)
    name = random.choice("xy" if kind == "pair" else "x")
    return f"{name} {random.choice(('<=', '>='))} {bound:g}"


def random_text(random: Random, kind: str, depth: int) -> str:
    """A formula that fits, without negations, which make comparisons strict."""
    while True:
        text = random_formula(random, depth, lambda one: random_atom(one, kind))
        if "!" not in text and "=>" not in text and horizon(parse(text, "stl")) <= STEPS[kind]:
            return text


def distinct(kind: str, formulas: Sequence[Formula]) -> Iterator[SignalTrace]:
    """One of all signals for every way in which predicates hold at the steps."""
    traces = every(kind)
    atoms = {node for node in walk_all(map(tree_of, formulas)) if isinstance(node, Linear)}
    truth = np.concatenate([holds(atom, traces) for atom in sorted(atoms, key=str)], axis=-1)
    _, places = np.unique(truth, axis=0, return_index=True)
    for place in places:
        yield SignalTrace({name: row[place] for name, row in traces.signals.items()})


def proven(made: Trajectory, name: str) -> float:
    (item,) = (item for item in made.objective if item.name == name)
    assert item.value == pytest.approx(item.bound)
    return item.value


def in_part(seed: int, *, wholes: bool = False) -> str:
    """As much of a random formula holds as can, by one of the orders."""
    random = Random(f"in part {seed}")
    kind, order = random.choice((*STEPS,)), ORDERS[seed % 3]
    parts = [random_text(random, kind, 2) for _ in range(random.randint(2, 3))]
    if wholes:
        parts = [str(wholly(random, parse(part, "stl"))) for part in parts]
    text = " && ".join(f"({part})" for part in parts)
    mission = SignalMission.of(
        system=system_of(kind),
        formula=text,
        horizon=STEPS[kind],
        objective=[{"satisfaction": order}],
    )
    formula, tree = mission.formula, tree_of(mission.formula)
    made = tsplan.synthesise(mission, threads=1)
    assert (made.status, made.verified) == ("optimal", True), (seed, text, made.notes)
    traces = [*distinct(kind, [formula])]
    best = max(fraction(formula, trace) for trace in traces)
    if order == "weighted":
        assert proven(made, "satisfaction") == pytest.approx(float(best)), (seed, text)
        assert made.fraction == pytest.approx(float(best))
    else:
        most = max(levels(tree, trace).counts for trace in traces)
        assert tuple(item.value for item in made.depths) == most, (seed, text)
        assert best < 1 or made.fraction == 1
    return "whole" if best == 1 else "part"


def gains(wishes: Sequence[Preference], trace: SignalTrace) -> tuple[Fraction, ...]:
    """What is gained at each level, the highest first."""
    by_level: Mapping[int, Fraction] = Counter()
    for wish in wishes:
        worth = fraction(wish.formula, trace)
        by_level[wish.level] += wish.weight * (worth if wish.partial else worth // 1)
    return tuple(by_level[level] for level in sorted(by_level, reverse=True))


def preferring(seed: int) -> str:
    """Random preferences are met as far as they can be where a random formula holds."""
    random = Random(f"prefer {seed}")
    kind = random.choice((*STEPS,))
    prefer = [
        Preference(
            parse(random_text(random, kind, random.randint(0, 2)), "stl"),
            name=f"wish {number}",
            weight=Fraction(random.choice(("1", "2", "3", "0.5", "0.3"))),
            level=random.choice((0, 0, 1)),
            partial=random.random() < 0.4,
        )
        for number in range(random.randint(1, 4))
    ]
    mission = SignalMission.of(
        system=system_of(kind),
        must=random_text(random, kind, 1),
        prefer=prefer,
        horizon=STEPS[kind],
        objective=["preferences"],
    )
    made = tsplan.synthesise(mission, threads=1)
    formulas = [mission.formula, *(wish.formula for wish in prefer)]
    found = [
        gains(prefer, trace)
        for trace in distinct(kind, formulas)
        if holds(mission.formula, trace)[0]
    ]
    said = (seed, mission.text, [str(wish.formula) for wish in prefer], made.notes)
    if not found:
        assert made.status == "infeasible", said
        return "infeasible"
    assert (made.status, made.verified) == ("optimal", True), said
    best = max(found)
    assert gains(prefer, made.trace()) == best, said
    assert proven(made, "preferences") == pytest.approx(float(sum(best))), said
    return "all" if sum(best) == sum(wish.weight for wish in prefer) else "some"


@pytest.mark.parametrize("seeds", seed_blocks(range(100, 103), range(100, 1000), 15))
def test_as_much_of_a_formula_holds_as_can(seeds: list[int]) -> None:
    seen = Counter(map(in_part, seeds))
    assert min(seen["part"], seen["whole"]) >= min(2, len(seeds) // 5), seen


@pytest.mark.parametrize("seeds", seed_blocks(range(100, 103), range(100, 1000), 15))
def test_as_much_holds_as_can_where_parts_count_as_a_whole(seeds: list[int]) -> None:
    seen = Counter(in_part(seed, wholes=True) for seed in seeds)
    assert min(seen["part"], seen["whole"]) >= 1, seen


@pytest.mark.parametrize("seeds", seed_blocks(range(100, 102), range(100, 1000), 15))
def test_preferences_are_met_as_far_as_they_can_be(seeds: list[int]) -> None:
    seen = Counter(map(preferring, seeds))
    assert min(seen["some"], seen["all"]) >= min(2, len(seeds) // 5), seen
