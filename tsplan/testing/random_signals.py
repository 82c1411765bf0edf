"""Small random missions over signals: free ones, integrators, and linear systems.

The same seed gives the same mission. Bounds, thresholds and factors are halves, so that much of
what is possible lies just on a border; many missions cannot be met.
"""

from __future__ import annotations

from random import Random

from tsplan.logic import horizon, linear, parse
from tsplan.signals.aims import Aim
from tsplan.signals.linear_system import Dynamics, Limit, Range, System
from tsplan.signals.signal_mission import SignalMission
from tsplan.signals.signal_parts import SignalLanguage
from tsplan.testing.random_missions import random_formula

_WEIGHTS = (0.2, 0.5, 1.0, 2.0, 3.0)
_RELATIONS = (">=", ">=", ">=", "<=", "<=", "<=", ">", "<", "!=", "=")
_AIMS: tuple[tuple[dict[str, float], ...], ...] = (
    *(({"robustness": 1.0},),) * 6,
    ({"robustness": 1.0, "state_effort": 0.1, "control_effort": 0.1},),
    ({"robustness": 2.0, "control_effort": 0.5},),
    ({"robustness": 1.0}, {"control_effort": 1.0}),
    ({"state_effort": 1.0},),
    (),
)


def random_signal_mission(
    seed: int, *, language: SignalLanguage = "stl", steps: int = 6
) -> SignalMission:
    """A mission over one or two signals and at most as many controls, of at most `steps` steps.

    >>> mission = random_signal_mission(3)
    >>> len(mission.system.signals) <= 2, mission.horizon <= 6
    (True, True)
    """
    random = Random(f"{language} {seed}")
    system = random_system(random)

    def atom(random: Random) -> str:
        return random_predicate(random, system)

    def weights(random: Random, count: int) -> str:
        if language == "stl" or random.random() < 0.3:
            return ""
        return f"^[{', '.join(str(random.choice(_WEIGHTS)) for _ in range(count))}]"

    while True:
        text = random_formula(random, random.randint(1, 3), atom, weights)
        formula = parse(text, language)
        last = max(horizon(formula) + random.choice((0, 0, 0, 1, 2)), 1)  # 1: there are controls
        if last <= steps:
            break
    aims = tuple(Aim(tuple(terms.items())) for terms in random.choice(_AIMS))
    return SignalMission(
        system,
        formula,
        last,
        aims,
        weighting=random.choice(("product", "normalised")),
        language=language,
        text=text,
        name=f"{language} {seed}",
    )


def random_system(random: Random) -> System:
    """Signals that move freely, add up their controls, or follow one another.

    >>> sorted(random_system(Random(1)).signals)
    ['x', 'y']
    """
    names = ("x", "y") if random.random() < 0.6 else ("x",)
    signals = {name: _random_range(random, 2, 5) for name in names}
    initial = {name: begin for name in names if (begin := _random_begin(random, signals[name]))}
    kind = random.choice(("free", "integrator", "linear"))
    if kind == "free":
        return System(signals, initial=initial)
    count = len(names)
    controls = {f"u{name}": _random_range(random, 0.5, 2) for name in names}
    one = tuple(tuple(float(row == column) for column in range(count)) for row in range(count))
    drift = tuple(random.choice((0.0, 0.0, 0.0, 0.5, -1.0)) for _ in names)
    a, b = one, one
    if kind == "linear" and count > 1:
        a = random.choice((((1.0, 1.0), (0.0, 1.0)), ((0.5, 1.0), (-1.0, 0.5))))
        if random.random() < 0.5:
            controls, b = {"ux": controls["ux"]}, ((0.5,), (1.0,))
    limits = (_random_limit(random, [*controls]),) if random.random() < 0.25 else ()
    return System(signals, controls, Dynamics(a, b, drift), initial, limits)


def random_predicate(random: Random, system: System) -> str:
    """The text of a comparison of one signal or two, a control now and then.

    >>> random_predicate(Random(1), System({"x": (0, 5)}))
    'x >= 0.5'
    """
    names = [*system.signals]
    if system.controls and random.random() < 0.1:
        names = [*system.controls]
    chosen = random.sample(names, random.randint(1, len(names)))
    terms = {name: random.choice((1.0, 1.0, 1.0, -1.0, 2.0, 0.5)) for name in chosen}
    return str(linear(terms, random.choice(_RELATIONS), random.randint(-6, 8) / 2))


def _random_range(random: Random, least: float, most: float) -> Range:
    """Two ends, each at a distance of so much from 0."""
    low, high = (random.randint(int(2 * least), int(2 * most)) / 2 for _ in range(2))
    return -low, high


def _random_begin(random: Random, ends: Range) -> Range | None:
    """A point or an interval in which a signal begins, or that it is free."""
    kind = random.random()
    if kind < 0.2:
        return None
    low, high = ends
    first = random.randint(int(2 * low), int(2 * high)) / 2
    return first, (first if kind < 0.8 else min(first + 1, high))


def _random_limit(random: Random, controls: list[str]) -> Limit:
    """That the controls together are at most so large, or a signal and a control."""
    bound = random.choice((0.5, 1.0, 1.5, 2.0))
    if random.random() < 0.6:
        return Limit((), tuple((1.0, ((name, 1.0),)) for name in controls), bound)
    return Limit(
        (("x", random.choice((1.0, -0.5))),), ((2.0, (("x", 1.0), (controls[0], 1.0))),), 6
    )
