"""From a point of a model of expected numbers to the policies of its classes.

The probability of an action at a state and step is its share in all that are expected to act there,
x(s,a,k) / sum of x(s,.,k): the policy that has the point as its occupation measure (E. Altman,
"Constrained Markov Decision Processes", 1999, theorem 3.2).
"""

from __future__ import annotations

from collections import defaultdict
from collections.abc import Iterator, Mapping
from typing import TypeAlias

from tsplan.encode.agent_classes import AgentClass, usable_actions
from tsplan.encode.class_columns import ClassColumns
from tsplan.encode.encoded import Point, Setting
from tsplan.plans.policies import Choice, Policy
from tsplan.ts import Action

Acting: TypeAlias = dict[tuple[str, int], list[tuple[Action, float]]]
"""How many agents are expected to take which actions, at every state and step."""

_NOISE = 1e-9  # parts of an agent that are no more than what solvers forgive
_SHARE = 1e-7  # of those at a state: what solvers forgive may look like an action


def policies_of(setting: Setting, point: Point) -> Iterator[Policy]:
    """A policy for every class of the team, in the team's order."""
    made: dict[tuple[str, frozenset[str]], list[int]] = defaultdict(list)
    for number, group in enumerate(setting.mission.team):
        made[group.class_name, group.capabilities].append(number)
    classes = {n: place for place, item in enumerate(setting.classes) for n in item.groups}
    acting = [
        _acting(setting, item, columns, point)
        for item, columns in zip(setting.classes, point.encoded.network.classes, strict=True)
    ]
    for (name, able), groups in made.items():
        starts = {state for n in groups for state, _ in setting.mission.team[n].starts}
        actions = usable_actions(setting.mission.system, able)
        choices = _followed(acting[classes[groups[0]]], starts, actions, setting)
        yield Policy(name, able, tuple(sorted(choices)))


def _acting(setting: Setting, item: AgentClass, columns: ClassColumns, point: Point) -> Acting:
    """What the agents of a class are expected to do by the values of a point."""
    able = setting.mission.team[item.groups[0]].capabilities
    actions = usable_actions(setting.mission.system, able)
    found: Acting = defaultdict(list)
    edge, step, column = columns.unrolled()
    for place, when, number in zip(
        edge.tolist(), step.tolist(), point.values[column].tolist(), strict=True
    ):
        if place < len(actions) and number > _NOISE:
            found[actions[place].state, when].append((actions[place], number))
    return found


def _followed(
    acting: Acting, starts: set[str], actions: tuple[Action, ...], setting: Setting
) -> Iterator[Choice]:
    """The choices wherever agents can come by them, from their starts on.

    Where the point has next to nobody, any action will do: one that stays is preferred.
    """
    default: dict[str, Action] = {}
    for action in actions:
        known = default.setdefault(action.state, action)
        if action.is_wait and not known.is_wait:
            default[action.state] = action
    rules = setting.mission.expected
    single = rules is not None and rules.deterministic
    reached: dict[int, set[str]] = defaultdict(set)
    reached[0] |= starts
    for step in range(setting.horizon):
        for state in reached.pop(step, set()):
            chosen = _shares(acting.get((state, step), []), single=single)
            for action, share in (chosen or {default[state]: 1.0}).items():
                yield Choice(step, state, action.name, share)
                reached[step + action.duration] |= {target for target, _ in action.possible}


def _shares(found: list[tuple[Action, float]], *, single: bool) -> Mapping[Action, float]:
    """The share of each action, those of mere noise left out."""
    total = sum(number for _, number in found)
    kept = [(action, number) for action, number in found if number > _SHARE * total]
    if single and kept:
        kept = [max(kept, key=lambda pair: pair[1])]
    total = sum(number for _, number in kept)
    return {action: number / total for action, number in kept}
