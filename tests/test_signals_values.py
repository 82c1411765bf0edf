"""Scenes whose best values are known, by published figures or by several encodings alike."""

from __future__ import annotations

from collections.abc import Mapping

import pytest

import tsplan
from scripts import signal_encodings, signal_scenes
from tests.seeds import sampled
from tsplan.milp.solution import Options

Values = Mapping[str, float] | None
"""The value of every objective in order; None for a scene that has no trajectory."""

CONSTANT = signal_encodings.BIG * signal_encodings.TOLERANCE
"""By how much a value of the rebuilt encodings may be off."""

TOLERANCE = 2e-6
"""Published values have seven digits at most, a later objective may worsen an earlier by 1e-6."""

QUICK: Mapping[str, Values] = {
    "trajectory": {"robustness": 3.0},
    "lti": {"robustness": 6.0},
    "lti:states=0.1,controls=0.1": {"J": -2.1},
    "lti:robustness=0,states=0.1,controls=0.1": {"J": -2.3},
    "lti:states=0.1": {"J": 0.3},
    "lti:controls=0.1": {"J": 3.4},
    "lti:states=0.01,controls=0.01": {"J": 5.09},
    "lti:most=1": {"robustness": 1.0},
    "lti:states=0.1,controls=0.1,most=1": {"J": -3.2},
    "reach-avoid": {"robustness": 0.5},
    "either-or:T=12,dwell=3": None,
}

SLOW: Mapping[str, Values] = {
    "narrow": {"robustness": 0.4},
    "door:T=15,n=1": {"robustness": 0.10625},
    "either-or:T=20": {"robustness": 0.5},
    "many-target:T=15": {"robustness": 0.2782603},
    "narrow:T=50,u=0.2": {"robustness": 0.4},
    "narrow:T=75,u=0.2": {"robustness": 0.4},
}

OPTIONS = Options(time_limit=300.0, threads=2)


@pytest.mark.parametrize("encoding", signal_encodings.ENCODINGS)
@pytest.mark.parametrize(
    "scene", sampled([*QUICK, *SLOW], [name for name in QUICK if "," not in name])
)
def test_the_rebuilt_encodings_find_them(scene: str, encoding: str) -> None:
    made = signal_encodings.trajectory(signal_scenes.scene(scene), encoding, OPTIONS)
    known = {**QUICK, **SLOW}[scene]
    assert made.status == ("infeasible" if known is None else "optimal")
    assert {item.name: item.value for item in made.objective} == pytest.approx(
        known or {}, abs=CONSTANT
    )


def test_a_scene_is_what_its_text_says() -> None:
    door = signal_scenes.scene("door:T=30,n=1,u=0.25")
    assert (door.horizon, door.system.controls["ux"]) == (30, (-0.25, 0.25))
    assert door.text.count("U[0,30]") == 1
    for wrong in ("window", "door:k=2"):
        with pytest.raises(ValueError, match=r"window|'k'"):
            signal_scenes.scene(wrong)


EFFORTS: Mapping[str, Values] = {
    "weighted": {"robustness": 0.08},
    "weighted:late=G": {"robustness": 0.03},
    "weighted:weighting=normalised": {"robustness": 0.2},
    "weighted:late=G,weighting=normalised": {"robustness": 0.225},
    "reach-avoid:effort=after": {"robustness": 0.5, "control_effort": 2.5},
    "reach-avoid:effort=0.1": {"J": 0.25},
    "either-or:T=20,effort=0.1": {"J": 0.2254762},
}

LARGE: Mapping[str, Values] = {
    "either-or:T=20,effort=after": {"robustness": 0.5, "control_effort": 2.745238},
    "either-or:T=100,u=0.2": {"robustness": 0.5},
    "either-or:T=200,u=0.2": {"robustness": 0.5},
    "narrow:T=200,u=0.2": {"robustness": 0.4},
    "many-target": {"robustness": 0.5},
    "many-target:T=30,u=0.2": {"robustness": 0.5},
    "many-target:T=100,u=0.2": {"robustness": 0.5},
    "many-target:T=25,u=0.2": {"robustness": 0.4630236},
    "door": {"robustness": 0.4},
    "door:T=50": {"robustness": 0.4},
    "door:T=100,n=4": {"robustness": 0.4},
    "stepping": {"robustness": 0.0527173},
}

DEFAULT = [*QUICK, *SLOW, *EFFORTS]
LONGER = ("either-or:T=20,effort=0.1", "door:T=15,n=1", "many-target:T=15", "narrow:T=75,u=0.2")


@pytest.mark.parametrize(
    "scene", sampled([*DEFAULT, *LARGE], [name for name in DEFAULT if name not in LONGER])
)
def test_synthesis_proves_them(scene: str) -> None:
    mission = signal_scenes.scene(scene)
    made = tsplan.synthesise(mission, time_limit=300.0, threads=2)
    known = {**QUICK, **SLOW, **EFFORTS, **LARGE}[scene]
    assert made.status == ("infeasible" if known is None else "optimal")
    aims = {aim.name for aim in mission.objective}
    found = {item.name: item.value for item in made.objective if item.name in aims}
    assert found == pytest.approx(known or {}, abs=TOLERANCE)
    assert made.verified == (known is not None)
