"""Synthesis against two plain programs on random systems and formulas, and by every solver."""

from __future__ import annotations

from collections import Counter
from collections.abc import Sequence
from dataclasses import replace

import pytest

from tests.seeds import seed_blocks
from tests.signal_references import CLOSE, ROBUST, PerNode, TwoSided, answer
from tsplan.errors import SolverUnavailableError
from tsplan.logic import Linear, robustness, walk
from tsplan.milp.solver import solver
from tsplan.signals.signal_mission import SignalMission
from tsplan.signals.synthesiser import synthesise_mission
from tsplan.signals.trajectory import Trajectory
from tsplan.stopping import StoppedBy
from tsplan.testing import random_signal_mission

LIMIT = 60.0
NEAR = 1e-4
"""By how much an equation may miss: 1e-6 of its range, which is 50 at most, times a weight."""


def plain(mission: SignalMission, **options: float) -> tuple[float, ...] | None:
    """The values of the objectives, each in its own sense, by the reference for the language."""
    kind = TwoSided if mission.language == "stl" else PerNode
    found = answer(kind(mission, **options).program)
    if found.trace is None:
        return None
    signs = [-1.0 if aim.rises else 1.0 for aim in mission.objective]
    return tuple(sign * value for sign, value in zip(signs, found.values, strict=False))


def on_border(mission: SignalMission) -> bool:
    """Whether the most robust trajectory has a robustness of 0, if strictness is left aside."""
    best = plain(replace(mission, objective=(ROBUST,)), strict=0.0)
    return best is not None and best[0] <= CLOSE


def values(mission: SignalMission, made: Trajectory) -> tuple[float, ...]:
    """The proven values of the objectives, without those of the terms of a sum."""
    found = {item.name: item for item in made.objective}
    for aim in mission.objective:
        item = found[aim.name]
        assert item.value == pytest.approx(item.bound, abs=CLOSE)
    return tuple(found[aim.name].value for aim in mission.objective)


def no_worse(mission: SignalMission, made: Trajectory, known: tuple[float, ...]) -> bool:
    """Whether the first value that differs from the reference's is better, not worse."""
    for aim, mine, other in zip(mission.objective, values(mission, made), known, strict=True):
        if mine != pytest.approx(other, abs=CLOSE):
            return (mine > other) == aim.rises
    return True


def judge(mission: SignalMission, made: Trajectory) -> str:
    """Compare what synthesis ended with to what the reference says."""
    known = plain(mission)
    said = (mission.name, mission.text, known, made.objective, made.notes)
    if not made.has_signals:
        assert known is None, said
        if made.stopped_by is StoppedBy.PRECISION:
            assert on_border(mission), said
            return "too close"
        assert made.status == "infeasible", said
        return "infeasible"
    # the least effort beyond a border is nowhere, and its trajectory not known to be the best
    strict = made.stopped_by is StoppedBy.PRECISION
    assert (made.status, made.verified) == ("feasible" if strict else "optimal", True), said
    margin = robustness(mission.formula, made.trace(), kind=mission.weighting)[0]
    assert margin >= -NEAR, said
    assert margin == pytest.approx(made.robustness, abs=NEAR), said
    if known is not None and values(mission, made) == pytest.approx(known, abs=CLOSE):
        return "found"
    # equations hold within a millionth for synthesis, by which a strict border can be crossed
    assert any(
        isinstance(atom, Linear) and atom.relation in ("=", "!=") for atom in walk(mission.formula)
    ), said
    assert known is None or no_worse(mission, made, known), said
    return "too close"


def judged(seeds: Sequence[int], language: str, **options: str) -> Counter[str]:
    """How often synthesis ended in which way."""
    missions = [random_signal_mission(seed, language=language) for seed in seeds]
    return Counter(
        judge(mission, synthesise_mission(mission, time_limit=LIMIT, threads=1, **options))
        for mission in missions
    )


@pytest.mark.parametrize("language", ["stl", "wstl"])
@pytest.mark.parametrize("seeds", seed_blocks(range(12), range(10_000), 100))
def test_synthesis_finds_what_the_reference_finds(seeds: list[int], language: str) -> None:
    seen = judged(seeds, language)
    assert min(seen["found"], seen["infeasible"]) >= len(seeds) * 15 // 100, seen
    assert seen["too close"] <= 6, seen


@pytest.mark.parametrize("language", ["stl", "wstl"])
@pytest.mark.parametrize("seeds", seed_blocks(range(20_000, 20_005), range(20_000, 20_500), 20))
def test_the_plain_encoding_finds_it_too(seeds: list[int], language: str) -> None:
    assert judged(seeds, language, encoding="reference")["found"] >= len(seeds) // 4


@pytest.mark.parametrize("name", ["gurobi", "pulp:PULP_CBC_CMD"])
@pytest.mark.parametrize("seeds", seed_blocks(range(30_000, 30_003), range(30_000, 30_065), 5))
def test_solvers_agree(seeds: list[int], name: str) -> None:
    try:
        solver(name)
    except SolverUnavailableError as error:
        pytest.skip(str(error))
    assert judged(seeds, "wstl", solver=name)["found"] >= 1
