"""Planning missions that hold as far as possible: first what is to hold, then how.

What a plan can satisfy is settled first. Then everything that it satisfies becomes a demand, and
the mission's other objectives are pursued as in any mission; a partly satisfied mission begins
with the availability of what is satisfied.
"""

from __future__ import annotations

from collections import defaultdict
from collections.abc import Callable, Sequence
from dataclasses import dataclass, replace
from fractions import Fraction
from functools import partial
from operator import mul

from tsplan.clock import Clock
from tsplan.encode.encoded import Point, Setting
from tsplan.encode.expressions import Constraint
from tsplan.encode.model_objectives import Availability
from tsplan.encode.partial.partial_model import PartialModel, Wish, everything, holding, wish_of
from tsplan.encode.preparation import prepare
from tsplan.encode.read_back import counts_of
from tsplan.encode.switches import Switch
from tsplan.errors import Finding, MissionError
from tsplan.exact import exact
from tsplan.logic import Formula, conjunction, positive, simplify
from tsplan.logic.margin import shifted, tighten
from tsplan.logic.witness_steps import is_settled, occurrences
from tsplan.mission import Mission
from tsplan.plans.outcomes import CERTIFIED, ObjectiveValue
from tsplan.run.chosen_parts import ChosenParts
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


def demand_of(mission: Mission, level: int = 0) -> Formula:
    """What must hold in any case, in positive normal form.

    With `level` agents to spare where every atom asks for so many more than it says here; a margin
    is kept all the same.
    """
    if mission.partial:
        return conjunction([])
    if mission.swarm is None or not level:
        return mission.goal
    written = positive(mission.counted)
    return simplify(shifted(tighten(written, mission.having, mission.swarm.spare, level), -level))


def wishes_of(mission: Mission) -> tuple[Wish, ...]:
    """What is to hold as far as possible."""
    if mission.partial:
        return (Wish(mission.tree(mission.formula), partial=True),)
    return tuple(wish_of(mission, preference) for preference in mission.prefer)


@dataclass(frozen=True, eq=False)
class Choice:
    """What was settled, what of the wishes is to hold from now on, and the first objective."""

    settled: Settled
    held: Formula
    objective: ObjectiveValue


def plan_soft(stages: Stages) -> Outcome[Point]:
    """All objectives of a mission that is met as far as possible; `stages` are those of it all."""
    mission = stages.setting.mission
    first = first_of(mission)
    worth = partial(worth_of, stages.setting)
    settling = Settling(stages.setting, stages.effort, stages.clock, stages.tell, first, worth)
    tried = _whole(stages, settling) if mission.partial and _tells_whole(mission) else None
    if tried is not None and tried.point is not None:
        whole = Settled(tried.point, (), True, False, None, tried.size)
        choice = Choice(whole, mission.goal, ObjectiveValue(first, 1.0, 1.0, CERTIFIED))
    else:
        refuted = tried is not None and tried.infeasible
        choice = _chosen(settling, stages.setting, refuted=refuted)
    settled = choice.settled
    if settled.point is None:
        why = settled.stopped_by
        made = Outcome[Point](None, (), False, settled.infeasible, why, settled.size)
        return replace(made, certified=settled.certified, rests=settled.rests)
    return _pursued(stages, choice, settled.point)


def _pursued(stages: Stages, choice: Choice, known: Point) -> Outcome[Point]:
    """The other objectives of plans for what is to hold, one of which is known."""
    mission, settled = stages.setting.mission, choice.settled
    names = tuple(objective.name for objective in stages.objectives)
    # of a team that does part of its formula, it is said how many agents that could do without
    implied = mission.partial and mission.swarm is None and "availability" not in names
    objectives = (Availability(), *stages.objectives) if implied else stages.objectives
    while True:
        rest = ChosenParts(
            setting=_demanding(stages.setting, choice.held),
            objectives=objectives,
            effort=stages.effort,
            clock=stages.clock,
            tell=stages.tell,
            tight=stages.tight,
            known=known.values[known.encoded.flows] if stages.tight else None,
            rivals=None if implied else _rivals(stages.setting, settled),
        )
        outcome = rest.run()
        if rest.better is None:
            break
        known = rest.better
        choice = replace(choice, held=_held(stages.setting, known))
    point = outcome.point or known
    told = outcome.reached[1:] if implied else outcome.reached
    if not settled.proven:  # then availability may be more where more holds
        told = tuple(replace(i, bound=None) if i.name == "availability" else i for i in told)
    why = _why_open(settled.stopped_by, outcome.stopped_by, refuted=outcome.infeasible)
    return Outcome(
        point=point,
        reached=(choice.objective, *(told or (ObjectiveValue(name, None, None) for name in names))),
        proven=settled.proven and outcome.proven,
        stopped_by=why,
        size=outcome.size,
        levels=settled.levels,
        notes=outcome.notes,
    )


def _rivals(setting: Setting, settled: Settled) -> Callable[[int], PartialModel] | None:
    """Makes the model of all plans that reach what was settled, with so many agents to spare."""
    made, mission = settled.rivals, setting.mission
    if made is None or not settled.proven:
        return None

    def rivals(level: int) -> PartialModel:
        demand = demand_of(mission, level)
        goal = everything(demand, wishes_of(mission))
        return made(replace(setting, goal=goal).at(level), demand)

    return rivals


def _demanding(setting: Setting, held: Formula) -> Setting:
    """The setting of plans in which what must hold does, and what was chosen beside it."""
    mission = setting.mission
    demanding = replace(setting, goal=simplify(conjunction([demand_of(mission), held])))
    if mission.swarm is None or not mission.swarm.margin:
        return demanding
    return replace(demanding, plain=positive(mission.counted), beside=held)


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


def _tells_whole(mission: Mission) -> bool:
    """Whether no plan for the whole formula can be worth less than another."""
    return mission.satisfaction != "weighted" or is_settled(mission.tree(mission.formula))


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
    worths = [wish.worth(trace) for wish in wishes]
    weights = [Fraction(1)] if mission.partial else [wish.weight for wish in mission.prefer]
    return float(sum(map(mul, weights, worths), Fraction(0)))


def _chosen(settling: Settling, setting: Setting, *, refuted: bool) -> Choice:
    """What is to hold; `refuted` says that not everything can."""
    if setting.mission.partial:
        settled, objective = _satisfied(settling, setting.mission, refuted=refuted)
    else:
        settled, objective = _preferred(settling, setting.mission)
    held = conjunction([]) if settled.point is None else _held(setting, settled.point)
    return Choice(settled, held, objective)


def _satisfied(
    settling: Settling, mission: Mission, *, refuted: bool
) -> tuple[Settled, ObjectiveValue]:
    """As much of the formula as can hold, in the mission's order."""
    (wish,) = wishes_of(mission)
    if mission.satisfaction == "weighted":
        whole = {0: [(0, Fraction(1))]}
        settled = settling.weights(conjunction([]), [wish], whole, refuted=refuted)
        value, bound = _summed(settled)
        return replace(settled, levels=()), settled.told("satisfaction", value, bound)
    together = mission.satisfaction == "depth"
    settled = settling.depths(wish.tree, together=together, refuted=refuted)
    return settled, settled.told("satisfaction", None, None)


def _preferred(settling: Settling, mission: Mission) -> tuple[Settled, ObjectiveValue]:
    """As many of the preferred formulas as can hold beside what must."""
    wanted: dict[int, list[tuple[int, Fraction]]] = defaultdict(list)
    for number, preference in enumerate(mission.prefer):
        wanted[preference.level].append((number, preference.weight))
    settled = settling.weights(demand_of(mission), wishes_of(mission), wanted)
    return settled, settled.told("preferences", *_summed(settled))


def _held(setting: Setting, point: Point) -> Formula:
    """What the plan of a point satisfies of the wishes."""
    mission = setting.mission
    depths = mission.partial and mission.satisfaction != "weighted"
    wishes = ((wish, counts_of(setting, wish.tree, point)) for wish in wishes_of(mission))
    return holding(conjunction([]), wishes, depths=depths)


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
