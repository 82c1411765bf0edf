"""Parts of a goal that must all hold, which teams of their own can see to.

Where nothing is bounded from above, what several teams do holds together: agents that are added
break nothing. So a conjunction can be planned part by part, each with some of the agents. That
leaves out plans in which agents serve parts of several teams.
"""

from __future__ import annotations

from collections import Counter
from collections.abc import Sequence
from dataclasses import dataclass, replace

from tsplan.encode.atom_encoders import Atoms, Bound
from tsplan.encode.encoded import Setting
from tsplan.encode.map_reduction import whole
from tsplan.encode.preparation import on_reduced_maps
from tsplan.logic import Always, And, Formula, conjunction
from tsplan.logic.time_horizon import lookahead
from tsplan.milp.model import Ints


@dataclass(frozen=True, eq=False)
class GoalPart:
    """One part: the states at which it counts agents, and how many of each capability it needs.

    Needs are what its atoms ask for when all of those joined by `and` are needed at once; at step
    `latest` some of its agents must be there at last.
    """

    goal: Formula
    states: tuple[int, ...]
    needs: Counter[str | None]
    latest: int


def parts_of(setting: Setting) -> tuple[GoalPart, ...]:
    """The parts of a setting's goal, or none where teams could get in each other's way."""
    apart = setting.monotone and setting.formula_alone
    if not apart or not isinstance(setting.goal, And):
        return ()
    atoms = setting.atoms(setting.unrolled())
    found = []
    for goal in setting.goal.children:
        states: set[int] = set()
        needs = _needs(goal, atoms, states)
        found.append(GoalPart(goal, tuple(sorted(states)), needs, _latest(goal)))
    return tuple(found) if all(part.states for part in found) else ()


def _needs(node: Formula, atoms: Atoms, states: set[int]) -> Counter[str | None]:
    """What a formula needs at once; the states at which it counts are added to `states`."""
    found: Counter[str | None] = Counter()
    if node in atoms:
        _, needed = atoms.of(node)
        for bound in needed.bounds:
            if isinstance(bound, Bound) and not bound.upper:
                states.update(bound.states)
                one = Counter({bound.capability: bound.amount})
                found = found + one if needed.every else found | one
        return found
    for child in node.children:
        needs = _needs(child, atoms, states)
        found = found + needs if isinstance(node, And) else found | needs
    return found


def _latest(node: Formula) -> int:
    """The step at which some agents must be there at last, where a formula holds at step 0."""
    begins = [
        _latest(child) + (low if isinstance(node, Always) else high)
        for child, (low, high) in zip(node.children, lookahead(node), strict=True)
    ]
    return (min if isinstance(node, And) else max)(begins, default=0)


def of_team(setting: Setting, parts: Sequence[GoalPart], starts: Sequence[Ints]) -> Setting:
    """The setting of some parts for a team of so many agents of each class at each state.

    Its classes move on the reduced maps of the whole, so that their moves are edges of these.
    """
    classes = tuple(
        replace(item, graph=replace(base.graph, start=start))
        for item, base, start in zip(setting.classes, setting.reduced, starts, strict=True)
    )
    goal = conjunction([part.goal for part in parts])
    maps = tuple(whole(item.graph) for item in classes)
    return on_reduced_maps(replace(setting, goal=goal, classes=classes, reduced=maps))
