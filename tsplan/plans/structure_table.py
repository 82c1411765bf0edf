"""The structures of a plan in words: who they are made of, when and where, and what is rebuilt."""

from __future__ import annotations

from typing import TYPE_CHECKING, NamedTuple

from tsplan.plans.bundles import Bundle
from tsplan.words import many

if TYPE_CHECKING:
    from collections.abc import Sequence

    from tsplan.plans.plan import Plan
    from tsplan.plans.structures import Rebuilt, Structure


class Alike(NamedTuple):
    """Structures of one configuration on one path."""

    ids: tuple[str, ...]
    modules: tuple[str, ...]
    path: Bundle


def alike(structures: Sequence[Structure]) -> list[Alike]:
    """Structures put together where they do the same, in order of first appearance.

    >>> from tsplan.plans.structures import Structure
    >>> common = "m", "pair", frozenset()
    >>> one = Structure("pair-1", *common, ("m-1", "m-2"), 0, 4, ((0, 4, "p"),))
    >>> two = Structure("pair-2", *common, ("m-3", "m-4"), 0, 4, ((0, 4, "p"),))
    >>> [(row.ids, len(row.modules)) for row in alike([one, two])]
    [(('pair-1', 'pair-2'), 4)]
    """
    found: dict[tuple[object, ...], list[Structure]] = {}
    for each in structures:
        key = (each.class_name, each.configuration, each.stays, each.heading, each.coming)
        found.setdefault(key, []).append(each)
    return [
        Alike(
            tuple(each.id for each in mine),
            tuple(module for each in mine for module in each.modules),
            _path(mine[0]),
        )
        for mine in found.values()
    ]


def _path(each: Structure) -> Bundle:
    own = each.configuration, each.capabilities, each.stays, each.heading
    return Bundle(*own, coming=each.coming)


def moved(plan: Plan) -> list[Structure]:
    """The structures that ever move or are built; those that others are made of are told there."""
    return [each for each in plan.structures if each.first or _moves(each)]


def idle_lines(plan: Plan) -> list[str]:
    """How many structures stay where they start, and are never rebuilt."""
    counts: dict[str, int] = {}
    for each in plan.structures:
        if not each.first and not _moves(each) and each.last == plan.horizon:
            counts[each.configuration] = counts.get(each.configuration, 0) + 1
    told = ", ".join(f"{count} {name}" for name, count in counts.items())
    return [f"  never moved or rebuilt: {told}"] if told else []


def rebuilt_line(plan: Plan, each: Rebuilt, parts: str, made: str) -> str:
    """What is rebuilt, by the names of what goes in and comes out, which is empty if not done."""
    verb = "becomes" if len(each.parts) == 1 else "become"
    where = f"step {each.step} at {each.state}: {parts}"
    if not each.made:
        is_ = "is" if len(each.parts) == 1 else "are"
        return f"{where} {is_} rebuilt, which is not done by step {plan.horizon}"
    done = next(body.first for body in plan.structures if body.id == each.made[0])
    return f"{where} {verb} {made}, done at step {done}"


def structures_checked(plan: Plan) -> list[str]:
    """What was found to hold of the structures of an accepted plan."""
    modules = {module for each in plan.structures for module in each.modules}
    if not modules:
        return []
    what = f"{many(len(plan.structures), 'structure')} of {many(len(modules), 'module')}"
    lines = [f"{what}: each module is in one at every step at which it is not rebuilt"]
    if plan.rebuilt:
        rebuilt = many(len(plan.rebuilt), "reconfiguration")
        lines.append(f"{rebuilt} by the rules of the mission, where and as long as these say")
    return lines


def _moves(each: Structure) -> bool:
    rests = len({state for _, _, state in each.stays}) < 2  # noqa: PLR2004  (it is at one state)
    return not rests or each.heading is not None or each.coming is not None
