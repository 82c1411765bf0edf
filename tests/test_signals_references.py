"""The plain programs that synthesis is judged by: they agree, and the evaluator with them.

The rebuilt encodings that it is measured against are judged by them in turn.
"""

from __future__ import annotations

from collections import Counter
from dataclasses import replace

import pytest

from scripts import signal_encodings, signal_scenes
from tests.seeds import seed_blocks
from tests.signal_references import CLOSE, OPTIONS, ROBUST, PerNode, TwoSided, answer
from tsplan.logic import parse, robustness
from tsplan.signals.signal_mission import SignalMission
from tsplan.testing.random_signals import random_signal_mission


def weighed(seed: int) -> str:
    """The second reference alone, of formulas that need not hold, and the evaluator."""
    mission = replace(random_signal_mission(seed, language="wstl"), objective=(ROBUST,))
    found = answer(PerNode(mission, -1000.0).program)
    if found.trace is None:
        return "nowhere"
    margin = robustness(mission.formula, found.trace, kind=mission.weighting)[0]
    assert margin == pytest.approx(-found.values[0], abs=CLOSE), mission.text
    assert (margin < -CLOSE) <= (not answer(TwoSided(mission).program).values)
    return "satisfied" if margin >= 0 else "violated"


def compare(mission: SignalMission) -> str:
    """Ask both references, and the evaluator about what they answer."""
    answers = [answer(kind(mission).program) for kind in (TwoSided, PerNode)]
    one, other = (found.values for found in answers)
    assert one == pytest.approx(other, abs=CLOSE), mission.text
    if not one:
        return "infeasible"
    for found in answers:
        margin = robustness(mission.formula, found.trace)[0]
        assert margin >= -1e-6
        if mission.objective and mission.objective[0] == ROBUST:
            assert margin == pytest.approx(-found.values[0], abs=CLOSE)
    return "optimal"


@pytest.mark.parametrize("seeds", seed_blocks(range(20), range(2000), 100))
def test_they_agree(seeds: list[int]) -> None:
    seen = Counter(compare(random_signal_mission(seed)) for seed in seeds)
    assert min(seen["optimal"], seen["infeasible"]) >= len(seeds) // 5, seen


@pytest.mark.parametrize("seeds", seed_blocks(range(13), range(1000), 50))
def test_weighted_values_are_those_of_the_evaluator(seeds: list[int]) -> None:
    seen = Counter(map(weighed, seeds))
    assert min(seen["satisfied"], seen["violated"]) >= len(seeds) // 5, seen


def test_a_seed_gives_the_same_mission_and_missions_are_of_all_kinds() -> None:
    made = [random_signal_mission(seed) for seed in range(60)]
    assert [random_signal_mission(seed) for seed in range(60)] == made
    kinds = Counter(
        None if moves is None else moves.a
        for moves in (mission.system.dynamics for mission in made)
    )
    assert len(kinds) == 5  # free, one or two integrators, two other systems
    assert min(kinds.values()) >= 2
    assert sum(bool(mission.system.limits) for mission in made) >= 5
    assert len({mission.objective for mission in made}) == 6


WEIGHTED = {
    "weighted": 0.08,
    "weighted:late=G": 0.03,
    "weighted:weighting=normalised": 0.2,
    "weighted:late=G,weighting=normalised": 0.225,
}


@pytest.mark.parametrize("scene", WEIGHTED)
def test_weights_of_the_published_example(scene: str) -> None:
    (least,) = answer(PerNode(signal_scenes.scene(scene)).program).values
    assert -least == pytest.approx(WEIGHTED[scene], abs=1e-6)


def test_what_is_not_satisfied_has_a_value_too() -> None:
    mission = replace(random_signal_mission(1), objective=(ROBUST,))
    system = signal_scenes.scene("trajectory").system
    for text, value in {"s1 >= 12 || s2 <= -1": -1.0, "s1 <= -2 && G[0,1] s2 >= 3": -3.0}.items():
        asked = replace(mission, system=system, formula=parse(text, "stl"), horizon=1)
        for kind in (TwoSided, PerNode):
            assert answer(kind(asked).program).values == ()
            assert answer(kind(asked, -20.0).program).values == pytest.approx([-value])


def rebuilt(mission: SignalMission, encoding: str) -> None:
    """One of the published encodings finds what the reference finds, and so does the evaluator."""
    asked = replace(mission, objective=(ROBUST,))
    known = answer(TwoSided(asked).program).values
    made = signal_encodings.trajectory(asked, encoding, OPTIONS)
    if not known and made.has_signals:  # strict predicates are as good as others in them
        assert made.robustness == pytest.approx(0.0, abs=CLOSE)
        return
    assert made.status == ("optimal" if known else "infeasible")
    if known:
        assert made.verified
        assert made.objective[0].value == pytest.approx(-known[0], abs=CLOSE)
        assert made.robustness == pytest.approx(-known[0], abs=CLOSE)


@pytest.mark.parametrize("encoding", signal_encodings.ENCODINGS)
@pytest.mark.parametrize("seeds", seed_blocks(range(3000, 3010), range(3000, 4000), 40))
def test_rebuilt_encodings_agree_with_them(encoding: str, seeds: list[int]) -> None:
    for seed in seeds:
        rebuilt(random_signal_mission(seed), encoding)
