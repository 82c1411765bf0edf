"""Scenes for planning over signals: robots in the plane, and small examples with known answers.

The scenes of double integrators, `p(k+1) = p + v` and `v(k+1) = v + u`, have the numbers of the
public benchmarks of stlpy (V. Kurtz and H. Lin, "Mixed-Integer Programming for Signal Temporal
Logic with Fewer Binary Variables", L-CSS 2022), `puzzle` those of a scene of D. Sun et al.,
"Multi-agent Motion Planning from Signal Temporal Logic Specifications", RA-L 2022, one step a
second. `trajectory` and `lti` are examples of G. A. Cardona and C.-I. Vasile's PyTeLo.

A scene is asked for by a text such as `door:T=50,n=4`; what is left out is as in its function. The
`effort` of the controls is sought `after` robustness, or weighed against it by a number.
"""

from __future__ import annotations

import inspect
from collections.abc import Callable, Mapping, Sequence
from dataclasses import replace
from types import MappingProxyType

import numpy as np

from tsplan.logic import Formula, conjunction, disjunction
from tsplan.logic.weights import Weighting
from tsplan.signals import Region, System, double_integrator, free_signals
from tsplan.signals.signal_mission import SignalMission

Box = tuple[float, float, float, float]
"""From and to along x, from and to along y."""

_PLANE: Box = (0, 10, 0, 10)


def region(box: Box) -> Region:
    """A box as a region of the plane."""
    return Region(x=box[:2], y=box[2:])


def robot(start: tuple[float, float], u: float, *, plane: Box = _PLANE, speed: float = 1) -> System:
    """A double integrator in the plane, from rest, pushed by at most `u` along each axis."""
    made = double_integrator(("x", "y"), position=(0, 0), speed=speed, push=u)
    begins = {"x": (start[0], start[0]), "y": (start[1], start[1]), **made.initial}
    return replace(made, signals={**made.signals, "x": plane[:2], "y": plane[2:]}, initial=begins)


def reach_avoid(
    T: int = 10,  # noqa: N803  (as the papers say)
    u: float = 0.5,
    effort: str = "",
) -> SignalMission:
    """A goal behind an obstacle."""
    formula = _avoiding(T, (3, 5, 4, 6)) & _reaching(T, (7, 8, 8, 9))
    return _mission(robot((1, 2), u), formula, T, objective=_with_effort(effort))


def either_or(
    T: int = 20,  # noqa: N803
    u: float = 0.5,
    dwell: int = 5,
    effort: str = "",
) -> SignalMission:
    """A goal, and before or after it one of two places for some steps."""
    places = ((1, 2, 6, 7), (7, 8, 4.5, 5.5))
    stay = disjunction(region(box).inside().always(0, dwell) for box in places)
    formula = conjunction(
        [
            stay.eventually(0, T - dwell),
            _avoiding(T, (3, 5, 4, 6)),
            _reaching(T, (7, 8, 8, 9)),
        ]
    )
    return _mission(robot((2, 2), u), formula, T, objective=_with_effort(effort))


def narrow(T: int = 25, u: float = 0.5, effort: str = "") -> SignalMission:  # noqa: N803
    """One of two goals, through passages."""
    walls = ((2, 5, 4, 6), (5.5, 9, 3.8, 5.7), (4.6, 8, 0.5, 3.5), (2.2, 4.4, 6.4, 11))
    goals = ((7, 8, 8, 9), (9.5, 10.5, 1.5, 2.5))
    formula = _reaching(T, *goals) & _avoiding(T, *walls)
    return _mission(robot((3, 3.6), u), formula, T, objective=_with_effort(effort))


def door(T: int = 25, u: float = 0.5, n: int = 2) -> SignalMission:  # noqa: N803
    """A goal at the end of a corridor with `n` doors, each closed until its key is fetched."""
    walls = (
        (8, 15.01, -0.01, 4),
        (8, 15.01, 6, 10.01),
        (3.5, 5, -0.01, 2.5),
        (-0.01, 2.5, 4, 6),
        (3.5, 5, 7.5, 10.01),
    )
    spans = ((12.8, 14), (11.5, 12.7), (10.2, 11.4), (8.9, 10.1))
    doors = [(*span, 3.99, 6.01) for span in spans]
    keys = ((1, 2, 1, 2), (1, 2, 8, 9), (6, 7, 8, 9), (6, 7, 1, 2))
    locks = [
        region(one).outside().until(region(key).inside(), 0, T)
        for one, key in zip(doors[:n], keys[:n], strict=True)
    ]
    formula = conjunction([_avoiding(T, *walls), *locks, _reaching(T, (14.1, 14.9, 4.1, 5.9))])
    return _mission(robot((6, 1), u, plane=(0, 15, 0, 10), speed=2), formula, T)


def many_target(
    T: int = 25,  # noqa: N803
    u: float = 0.5,
    groups: int = 5,
    each: int = 2,
    seed: int = 0,
) -> SignalMission:
    """One target of every group, past an obstacle; all drawn at random."""
    random = np.random.RandomState(seed)
    wall = _drawn(random, 2)
    targets = [[_drawn(random, 1) for _ in range(each)] for _ in range(groups)]
    parts = [_avoiding(T, wall), *(_reaching(T, *group) for group in targets)]
    return _mission(robot((5, 2), u), conjunction(parts), T)


def stepping(
    T: int = 15,  # noqa: N803
    u: float = 0.5,
    n: int = 15,
    seed: int = 1,
) -> SignalMission:
    """On one of `n` stones at every step, on the last of them at some; all drawn at random."""
    random = np.random.RandomState(seed)
    stones = [_drawn(random, 1) for _ in range(n)]
    anywhere = disjunction(region(stone).inside() for stone in stones)
    return _mission(robot((2, 1.3), u), anywhere.always(0, T) & _reaching(T, stones[-1]), T)


def puzzle(T: int = 30, speed: float = 3) -> SignalMission:  # noqa: N803
    """Rooms whose five doors are closed until their keys are fetched; every way stays clear.

    Any plan will do. Walls and doors are thicker by 0.4, keys and the goal smaller by 0.1 on all
    sides, as the authors' script makes them for the size of the robot and how far off it may be.
    """
    outer = ((0, 0, 0, 8), (8, 8, 0, 8), (0, 8, 0, 0), (0, 8, 8, 8))
    inner = ((0, 7, 6, 6), (2, 2, 1, 4), (2, 4, 4, 4), (4, 4, 4, 6), (6, 6, 0, 5))
    doors = ((2, 2, 0, 1), (6, 6, 5, 6), (6, 8, 2, 2), (0, 2, 4, 4), (7, 8, 6, 6))
    keys = ((5, 1), (3, 3), (1, 1), (7, 1), (3, 5))
    clear = conjunction(_thick(wall).clear() for wall in outer + inner)
    parts: list[Formula] = [clear.always(0, T - 1)]
    parts += [
        _thick(one)
        .clear()
        .until(Region(x=(x - 0.45, x + 0.45), y=(y - 0.45, y + 0.45)).inside(), 0, T)
        for one, (x, y) in zip(doors, keys, strict=True)
    ]
    formula = conjunction([*parts, _reaching(T, (0.6, 1.4, 6.6, 7.4))])
    speeds = {"vx": [-speed, speed], "vy": [-speed, speed]}
    return SignalMission.of(
        signals={
            "x": {"min": 0, "max": 8, "initial": 4.5},
            "y": {"min": 0, "max": 8, "initial": 2},
        },
        controls=speeds,
        dynamics={"A": [[1, 0], [0, 1]], "B": [[1, 0], [0, 1]]},
        limits=[f"|vx| + |vy| <= {speed}"],
        formula=formula,
        objective=[],
        horizon=T,
    )


def trajectory() -> SignalMission:
    """Two signals that move freely, with a choice early and one late."""
    text = "(G[1,5] s1 >= 7 || G[1,5] s2 <= 2) && (F[5,10] s1 <= 3 || F[5,10] s2 >= 8)"
    return _mission(free_signals(s1=(0, 10), s2=(0, 10)), text, 10, start={"s1": 0, "s2": 0})


def weighted(late: str = "F", weighting: Weighting = "product") -> SignalMission:
    """The same with weights, and `late` the operator over the later steps, F or G.

    The authors' paper has F and one weight less than steps, so the last counts twice here; their
    script has G, and weights of its own.
    """
    one, other = {
        "F": ("0.1, 0.2, 0.3, 0.4, 0.5, 0.5", "0.5, 0.4, 0.3, 0.2, 0.1, 0.1"),
        "G": ("0.5, 0.5, 0.4, 0.3, 0.2, 0.1",) * 2,
    }[late]
    early = (
        "G[1,5]^[0.1, 0.2, 0.3, 0.4, 0.5] s1 >= 7"
        " ||^[0.2, 0.8] G[1,5]^[0.5, 0.4, 0.3, 0.2, 0.1] s2 <= 2"
    )
    then = f"{late}[5,10]^[{one}] s1 <= 3 ||^[0.2, 0.8] {late}[5,10]^[{other}] s2 >= 8"
    return SignalMission.of(
        system=free_signals(s1=(0, 10), s2=(0, 10)),
        start={"s1": 0, "s2": 0},
        formula=f"({early}) &&^[0.5, 0.5] ({then})",
        language="wstl",
        weighting=weighting,
        objective=["robustness"],
        horizon=10,
    )


def lti(
    robustness: float = 1, states: float = 0, controls: float = 0, most: float = 0
) -> SignalMission:
    """A linear system with efforts against robustness; `most` limits |u1| + |u2| if it is not 0."""
    weights = {"robustness": robustness, "state_effort": states, "control_effort": controls}
    return SignalMission.of(
        signals={name: {"min": -9, "max": 9, "initial": 0} for name in ("s1", "s2")},
        controls={"u1": [-5, 5], "u2": [-5, 5]},
        dynamics={"A": [[1, 1], [0, 1]], "B": [[1, 0], [0, 1]]},
        limits=[f"|u1| + |u2| <= {most}"] if most else None,
        formula="G[3,5] s1 >= 3 && G[9,10] s2 >= 2",
        objective={name: by for name, by in weights.items() if by},
        horizon=10,
    )


SCENES: Mapping[str, Callable[..., SignalMission]] = MappingProxyType(
    {
        "trajectory": trajectory,
        "weighted": weighted,
        "lti": lti,
        "reach-avoid": reach_avoid,
        "either-or": either_or,
        "narrow": narrow,
        "many-target": many_target,
        "door": door,
        "stepping": stepping,
        "puzzle": puzzle,
    }
)

QUICK = (
    "trajectory",
    "weighted",
    "lti:states=0.1,controls=0.1",
    "lti:robustness=0,states=0.1,controls=0.1",
    "reach-avoid",
    "either-or:T=20",
    "narrow:T=25",
    "many-target:T=15",
    "many-target:T=25",
    "door:T=15,n=1",
)
"""Scenes of a second or less each, but for the two other encodings."""

GOALS = (
    *QUICK[:4],
    "either-or:T=20",
    *(f"either-or:T={steps},u=0.2" for steps in (100, 105, 200)),
    *(f"narrow:T={steps},u=0.2" for steps in (50, 75, 200)),
    *(f"many-target:T={steps},u=0.2" for steps in (30, 50, 100, 25)),
    *("door:T=25", "door:T=50", "door:T=100,n=4", "stepping"),
    *("door:T=50,n=4", "puzzle", "narrow:T=25,effort=after"),
)
"""Scenes of all sizes, the last three without a proof so far."""


def scene(text: str) -> SignalMission:
    """The mission of a text such as `narrow` or `door:T=50,n=4`.

    Raises ValueError for a scene or a number that there is not.
    """
    family, _, numbers = text.partition(":")
    if family not in SCENES:
        raise ValueError(f"there is no scene '{family}', only {', '.join(SCENES)}")
    known = inspect.signature(SCENES[family]).parameters
    given = dict(item.split("=", 1) for item in numbers.split(",") if item)
    for name in given:
        if name not in known:
            raise ValueError(f"{family} has no '{name}', only {', '.join(known)}")
    return SCENES[family](**{name: _value(text, known[name]) for name, text in given.items()})


def _value(text: str, parameter: inspect.Parameter) -> str | int | float:
    """A text as what a parameter has by default: a word, a whole number, or any number."""
    if isinstance(parameter.default, str):
        return text
    return int(text) if isinstance(parameter.default, int) and text.isdecimal() else float(text)


def _mission(
    system: System,
    formula: Formula | str,
    steps: int,
    *,
    start: Mapping[str, float] | None = None,
    objective: Sequence[str] | Mapping[str, float] = ("robustness",),
) -> SignalMission:
    return SignalMission.of(
        system=system, start=start, formula=formula, objective=objective, horizon=steps
    )


def _with_effort(effort: str) -> Sequence[str] | Mapping[str, float]:
    if effort == "after":
        return ["robustness", "control_effort"]
    return {"robustness": 1, "control_effort": float(effort)} if effort else ["robustness"]


def _avoiding(steps: int, *boxes: Box) -> Formula:
    return conjunction(region(box).outside() for box in boxes).always(0, steps)


def _reaching(steps: int, *boxes: Box) -> Formula:
    return disjunction(region(box).inside() for box in boxes).eventually(0, steps)


def _drawn(random: np.random.RandomState, size: float) -> Box:
    """A square that begins within [0,9] along both axes."""
    x, y = random.uniform(0, 9), random.uniform(0, 9)
    return x, x + size, y, y + size


def _thick(line: Box) -> Region:
    """The region of a wall: 0.2 thick, and 0.4 more on every side."""
    x, y = (0.5 if low == high else 0.4 for low, high in (line[:2], line[2:]))
    return region((line[0] - x, line[1] + x, line[2] - y, line[3] + y))
