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

from tsplan.encode.build import Setting, prepare
from tsplan.encode.constraints import Constraint
from tsplan.encode.ideas import Idea
from tsplan.encode.partial.model import Wish, demand_of, everything, wish_of
from tsplan.encode.partial.settling import Settled, Settling
from tsplan.encode.readout import Measure, counts_of, moves_of
from tsplan.encode.stages import Outcome, Point, Reached, Stages
from tsplan.errors import Finding, MissionError
from tsplan.logic import Formula, conjunction, positive, simplify
from tsplan.logic.fraction import shares, tree_of
from tsplan.logic.fulfilment import Pair, demanded, levels, satisfied, spots
from tsplan.logic.traces import CountTrace
from tsplan.mission import Mission

_FIRST = frozenset({"satisfaction", "preferences"})


def is_soft(mission: Mission) -> bool:
    """Whether some of a mission need not hold."""
    return mission.partial or bool(mission.prefer)


def prepare_soft(
    mission: Mission, constraints: Sequence[Constraint], ideas: frozenset[Idea]
) -> Setting:
    """The setting of everything that a mission asks for or prefers."""
    return prepare(mission, constraints, ideas, everything(demand_of(mission), wishes_of(mission)))


def wishes_of(mission: Mission) -> tuple[Wish, ...]:
    """What is to hold as far as possible."""
    if mission.partial:
        return (Wish(tree_of(mission.formula, mission.task_interval), partial=True),)
    return tuple(wish_of(mission, preference) for preference in mission.prefer)


@dataclass(frozen=True, eq=False)
class _Choice:
    """What was settled, what is to hold from now on, and the flows of a plan for that."""

    settled: Settled
    goal: Formula
    objective: Reached


def plan_soft(stages: Stages) -> Outcome:
    """All objectives of a mission that is met as far as possible; `stages` are those of it all."""
    mission = stages.setting.mission
    first = "satisfaction" if mission.partial else "preferences"
    settling = Settling(stages.setting, stages.effort, stages.clock, stages.tell, first)
    choose = _satisfy if mission.partial else _prefer
    choice = choose(settling, mission)
    settled = choice.settled
    if settled.point is None:
        why = settled.stopped_by
        return Outcome(None, (), False, settled.infeasible, why, settled.size)
    names = tuple(name for name in stages.objective if name not in _FIRST)
    implied = mission.partial and "availability" not in names
    setting = replace(stages.setting, goal=choice.goal)
    rest = replace(
        stages,
        setting=setting,
        measure=Measure(setting),
        objective=("availability", *names) if implied else names,
        known=settled.point.values[settled.point.encoded.flows] if stages.tight else None,
    )
    outcome = rest.run()
    others = outcome.reached[1:] if implied else outcome.reached
    return Outcome(
        point=outcome.point or settled.point,
        reached=(choice.objective, *(others or (Reached(name, None, None) for name in names))),
        proven=settled.proven and outcome.proven,
        infeasible=False,
        stopped_by=settled.stopped_by or outcome.stopped_by,
        size=outcome.size,
        levels=settled.levels,
    )


def _satisfy(settling: Settling, mission: Mission) -> _Choice:
    """As much of the formula as can hold, in the mission's order."""
    (wish,) = wishes_of(mission)
    if mission.satisfaction != "weighted":
        _refuse_if_too_large(wish.tree)
    tried = settling.whole(mission.goal)
    if tried.point is not None:
        all_of_it = Settled(tried.point, (), True, False, None, tried.size)
        return _Choice(all_of_it, mission.goal, Reached("satisfaction", 1.0, 1.0))
    if mission.satisfaction == "weighted":
        whole = {0: [(0, Fraction(1))]}
        settled = settling.weights(conjunction([]), [wish], whole, refuted=tried.infeasible)
        value, bound = _summed(settled)
        settled = replace(settled, levels=())
    else:
        together = mission.satisfaction == "depth"
        settled = settling.depths(wish.tree, together=together, refuted=tried.infeasible)
        value, bound = None, None
    goal = conjunction([])
    if settled.point is not None:
        trace = _trace(settling.setting, wish.tree, settled.point)
        find = satisfied if mission.satisfaction == "weighted" else _topmost
        goal = simplify(positive(demanded(find(wish.tree, trace))))
    return _Choice(settled, goal, Reached("satisfaction", value, bound))


def _topmost(tree: Formula, trace: CountTrace) -> tuple[Pair, ...]:
    return levels(tree, trace).pairs


def _prefer(settling: Settling, mission: Mission) -> _Choice:
    """As many of the preferred formulas as can hold beside what must."""
    wishes = wishes_of(mission)
    demand = demand_of(mission)
    wanted: dict[int, list[tuple[int, Fraction]]] = defaultdict(list)
    for number, preference in enumerate(mission.prefer):
        wanted[preference.level].append((number, preference.weight))
    settled = settling.weights(demand, wishes, wanted)
    value, bound = _summed(settled)
    if settled.point is not None:
        every = conjunction(wish.tree for wish in wishes)
        trace = _trace(settling.setting, every, settled.point)
        pairs = [pair for wish in wishes for pair in _met(wish, trace)]
        demand = simplify(conjunction([demand, positive(demanded(pairs))]))
    return _Choice(settled, demand, Reached("preferences", value, bound))


def _met(wish: Wish, trace: CountTrace) -> Iterable[Pair]:
    """What a plan meets of a wish."""
    if wish.partial:
        return satisfied(wish.tree, trace)
    held = shares(wish.tree, trace)[wish.tree][0].fraction == 1
    return [(wish.tree, 0)] if held else []


def _summed(settled: Settled) -> tuple[float | None, float | None]:
    """Value and bound of all levels together; the value of what is not proven stays open."""
    known = [level.bound for level in settled.levels if level.bound is not None]
    bound = sum(known) if len(known) == len(settled.levels) else None
    value = sum(level.value or 0.0 for level in settled.levels)
    return (value if settled.proven else None), bound


def _trace(setting: Setting, formula: Formula, point: Point) -> CountTrace:
    moves = moves_of(setting, point.encoded, point.values, reduced=point.tight)
    return counts_of(setting, formula, moves)


def _refuse_if_too_large(tree: Formula) -> None:
    try:
        spots(tree)
    except ValueError as error:
        raise MissionError([Finding(str(error))]) from None
