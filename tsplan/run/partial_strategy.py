"""Planning missions that hold as far as possible: first what is to hold, then how.

What a plan can satisfy is settled first. Then everything that it satisfies becomes a demand, and
the mission's other objectives are pursued as in any mission; a partly satisfied mission begins
with the availability of what is satisfied.
"""

from __future__ import annotations

from collections import defaultdict
from collections.abc import Iterable, Sequence
from dataclasses import dataclass, replace
from fractions import Fraction
from functools import partial

from tsplan.clock import Clock
from tsplan.encode.encoded import Point, Setting
from tsplan.encode.expressions import Constraint
from tsplan.encode.model_objectives import Availability
from tsplan.encode.partial.partial_model import Wish, demand_of, everything, wish_of
from tsplan.encode.preparation import prepare
from tsplan.encode.read_back import counts_of
from tsplan.encode.switches import Switch
from tsplan.errors import Finding, MissionError
from tsplan.exact import exact
from tsplan.logic import Formula, conjunction, positive, simplify
from tsplan.logic.fraction import shares
from tsplan.logic.traces import CountTrace
from tsplan.logic.witness_steps import Pair, demanded, levels, occurrences, satisfied
from tsplan.mission import Mission
from tsplan.plans.plan import ObjectiveValue
from tsplan.run.maximise import Settled, Settling
from tsplan.search.lexicographic import Outcome
from tsplan.search.stages import Stages
from tsplan.stopping import StoppedBy

FIRST = frozenset({"satisfaction", "preferences"})
"""Objectives that say what is to hold."""

_TRIAL = 3.0  # seconds in which a plan for the whole formula is looked for first
_TRIED = 0.25  # of the time that is left, if that is less


def is_soft(mission: Mission) -> bool:
    """Whether some of a mission need not hold."""
    return mission.partial or bool(mission.prefer)


def prepare_soft(
    mission: Mission,
    constraints: Sequence[Constraint],
    switches: frozenset[Switch],
    *,
    clock: Clock | None = None,
) -> Setting:
    """The setting of everything that a mission asks for or prefers."""
    goal = everything(demand_of(mission), wishes_of(mission))
    return prepare(mission, constraints, switches, goal, clock=clock)


def wishes_of(mission: Mission) -> tuple[Wish, ...]:
    """What is to hold as far as possible."""
    if mission.partial:
        return (Wish(mission.tree(mission.formula), partial=True),)
    return tuple(wish_of(mission, preference) for preference in mission.prefer)


@dataclass(frozen=True, eq=False)
class Choice:
    """What was settled, what is to hold from now on, and what the first objective came to."""

    settled: Settled
    goal: Formula
    objective: ObjectiveValue


def plan_soft(stages: Stages) -> Outcome[Point]:
    """All objectives of a mission that is met as far as possible; `stages` are those of it all."""
    mission = stages.setting.mission
    first = first_of(mission)
    worth = partial(worth_of, stages.setting)
    settling = Settling(stages.setting, stages.effort, stages.clock, stages.tell, first, worth)
    tried = _whole(stages, settling) if mission.partial else None
    if tried is not None and tried.point is not None:
        whole = Settled(tried.point, (), True, False, None, tried.size)
        choice = Choice(whole, mission.goal, ObjectiveValue(first, 1.0, 1.0))
    else:
        refuted = tried is not None and tried.infeasible
        choice = _chosen(settling, stages.setting, refuted=refuted)
    settled = choice.settled
    if settled.point is None:
        why = settled.stopped_by
        return Outcome(None, (), False, settled.infeasible, why, settled.size)
    return _pursued(stages, choice, settled.point)


def _pursued(stages: Stages, choice: Choice, known: Point) -> Outcome[Point]:
    """The other objectives of plans for what is to hold, one of which is known."""
    mission, settled = stages.setting.mission, choice.settled
    names = tuple(objective.name for objective in stages.objectives)
    # of a team that does part of its formula, it is said how many agents that could do without
    implied = mission.partial and mission.swarm is None and "availability" not in names
    objectives = (Availability(), *stages.objectives) if implied else stages.objectives
    rest = replace(
        stages,
        setting=replace(stages.setting, goal=choice.goal),
        objectives=objectives,
        known=known.values[known.encoded.flows] if stages.tight else None,
    )
    outcome = rest.run()
    point = outcome.point or known
    others = outcome.reached[1:] if implied else outcome.reached
    told = tuple(_of_all_plans(rest.setting, item, point) for item in others)
    proven = settled.proven and outcome.proven and told == others
    why = _why_open(settled.stopped_by, outcome.stopped_by, refuted=outcome.infeasible)
    return Outcome(
        point=point,
        reached=(choice.objective, *(told or (ObjectiveValue(name, None, None) for name in names))),
        proven=proven,
        stopped_by=why if proven else why or StoppedBy.PRECISION,
        size=outcome.size,
        levels=settled.levels,
        notes=outcome.notes,
    )


def _of_all_plans(setting: Setting, reached: ObjectiveValue, point: Point) -> ObjectiveValue:
    """A value without its bound where the plan refutes it.

    Availability is bounded for the parts that were chosen to hold. A plan in which other parts
    hold as well may have more to spare at what holds best, and then nothing is known of all plans.
    """
    mission = setting.mission
    if not mission.partial or reached.name != "availability" or reached.bound is None:
        return reached
    tree = mission.tree(mission.formula)
    spare = shares(tree, counts_of(setting, tree, point))[tree][0].spare
    return replace(reached, bound=None) if spare > reached.bound else reached


def _why_open(
    settling: StoppedBy | None, rest: StoppedBy | None, *, refuted: bool
) -> StoppedBy | None:
    """What kept the first objective or the `rest` from being proven.

    `refuted` says that the rest was called impossible, and yet a plan is known.
    """
    return settling or rest or (StoppedBy.PRECISION if refuted else None)


def first_of(mission: Mission) -> str:
    """The objective that says what is to hold."""
    return "satisfaction" if mission.partial else "preferences"


def _trial(clock: Clock) -> Clock:
    """The time in which a plan for the whole formula is looked for."""
    left = clock.left
    return clock.within(_TRIAL if left is None else min(_TRIAL, _TRIED * left))


def _whole(stages: Stages, settling: Settling) -> Outcome[Point]:
    """A quick try for a plan that satisfies everything; it may be refuted, or stay open."""
    refuse_if_too_large(stages.setting.mission)
    stages.tell(settling.name, None, None, None)
    return Stages(
        setting=replace(stages.setting, goal=stages.setting.mission.goal),
        effort=stages.effort,
        objectives=(),
        clock=_trial(settling.clock),
        tell=_unheard,
    ).run()


def _unheard(*_: object) -> None:
    """A try's bounds are not those of the objective."""


def worth_of(setting: Setting, point: Point) -> float:
    """What the plan of a point comes to in the objective that says what is to hold."""
    mission = setting.mission
    wishes = wishes_of(mission)
    every = conjunction(wish.tree for wish in wishes)
    trace = counts_of(setting, every, point)
    fractions = [shares(wish.tree, trace)[wish.tree][0].fraction for wish in wishes]
    if mission.partial:
        return float(fractions[0])
    worths = (
        preference.weight * (fraction if preference.partial else int(fraction == 1))
        for preference, fraction in zip(mission.prefer, fractions, strict=True)
    )
    return float(sum(worths, Fraction(0)))


def _chosen(settling: Settling, setting: Setting, *, refuted: bool) -> Choice:
    """What is to hold; `refuted` says that not everything can."""
    if setting.mission.partial:
        return _satisfy(settling, setting, refuted=refuted)
    return _prefer(settling, setting)


def _satisfy(settling: Settling, setting: Setting, *, refuted: bool) -> Choice:
    """As much of the formula as can hold, in the mission's order."""
    mission = setting.mission
    (wish,) = wishes_of(mission)
    if mission.satisfaction == "weighted":
        whole = {0: [(0, Fraction(1))]}
        settled = settling.weights(conjunction([]), [wish], whole, refuted=refuted)
        value, bound = _summed(settled)
        settled = replace(settled, levels=())
    else:
        together = mission.satisfaction == "depth"
        settled = settling.depths(wish.tree, together=together, refuted=refuted)
        value, bound = None, None
    goal = conjunction([])
    if settled.point is not None:
        trace = counts_of(setting, wish.tree, settled.point)
        find = satisfied if mission.satisfaction == "weighted" else _topmost
        goal = simplify(positive(demanded(find(wish.tree, trace))))
    return Choice(settled, goal, ObjectiveValue("satisfaction", value, bound))


def _topmost(tree: Formula, trace: CountTrace) -> tuple[Pair, ...]:
    return levels(tree, trace).pairs


def _prefer(settling: Settling, setting: Setting) -> Choice:
    """As many of the preferred formulas as can hold beside what must."""
    mission = setting.mission
    wishes = wishes_of(mission)
    demand = demand_of(mission)
    wanted: dict[int, list[tuple[int, Fraction]]] = defaultdict(list)
    for number, preference in enumerate(mission.prefer):
        wanted[preference.level].append((number, preference.weight))
    settled = settling.weights(demand, wishes, wanted)
    value, bound = _summed(settled)
    if settled.point is not None:
        every = conjunction(wish.tree for wish in wishes)
        trace = counts_of(setting, every, settled.point)
        pairs = [pair for wish in wishes for pair in _met(wish, trace)]
        demand = simplify(conjunction([demand, positive(demanded(pairs))]))
    return Choice(settled, demand, ObjectiveValue("preferences", value, bound))


def _met(wish: Wish, trace: CountTrace) -> Iterable[Pair]:
    """What a plan meets of a wish."""
    if wish.partial:
        return satisfied(wish.tree, trace)
    held = shares(wish.tree, trace)[wish.tree][0].fraction == 1
    return [(wish.tree, 0)] if held else []


def _summed(settled: Settled) -> tuple[float | None, float | None]:
    """Value and bound of all levels together; the value of what is not proven stays open."""
    known = [exact(level.bound) for level in settled.levels if level.bound is not None]
    bound = float(sum(known)) if len(known) == len(settled.levels) else None
    value = float(sum(exact(level.value or 0.0) for level in settled.levels))
    return (value if settled.proven else None), bound


def refuse_if_too_large(mission: Mission) -> None:
    """MissionError for a formula with too many parts to be told apart by their depths."""
    if mission.satisfaction == "weighted":
        return
    try:
        occurrences(mission.tree(mission.formula))
    except ValueError as error:
        raise MissionError([Finding(str(error))]) from None
