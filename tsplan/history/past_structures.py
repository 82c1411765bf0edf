"""What structures of modules have done until a step, and what is being made of them then.

A structure is told of by its own id or by one of its modules.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import replace
from typing import TYPE_CHECKING, NamedTuple

from tsplan.errors import Finding, PlanError
from tsplan.history.told_paths import told_of, told_path, until
from tsplan.plans.bundles import Bundle
from tsplan.plans.structures import Rebuilt, Structure
from tsplan.plans.worlds import World

if TYPE_CHECKING:
    from tsplan.history.changed_map import Maps
    from tsplan.plans.plan import Plan


class Built(NamedTuple):
    """The structures that there have been until a step, or are being made, and how they came."""

    structures: tuple[Structure, ...] = ()
    rebuilt: tuple[Rebuilt, ...] = ()

    @classmethod
    def of(cls, plan: Plan, step: int) -> Built:
        """Those of a plan as it stands."""
        rebuilt = tuple(each for each in plan.rebuilt if each.step < step)
        coming = {name for each in rebuilt for name in each.made}
        return cls(
            tuple(
                _until(each, step) if each.first <= step else _made(each)
                for each in plan.structures
                if each.first <= step or each.id in coming
            ),
            rebuilt,
        )

    def really(self, world: World, maps: Maps) -> Built:
        """The same as a world says that it was.

        Raises PlanError for what it says of structures and cannot be.
        """
        findings: list[Finding] = []
        found = []
        for each in self.structures:
            if not each.first <= world.step <= each.last:
                findings += _rebuilt_then(each, world)
                found.append(each)
                continue
            mine = [name for name in told_of(world) if name in (each.id, *each.modules)]
            if len(mine) > 1:
                what = f"structure {each.id} is told of as {' and as '.join(mine)}"
                findings.append(Finding(what, "say it once"))
            try:
                path = told_path(world, maps, mine[0], path_of(each)) if mine else path_of(each)
            except PlanError as error:
                findings += error.findings
                continue
            there = path.heading or (path.stays and path.stays[-1][1] == world.step)
            last = world.step if there else world.step - 1
            if path.stays or path.heading:
                found.append(replace(each, stays=path.stays, heading=path.heading, last=last))
        if findings:
            raise PlanError(findings)
        known = {each.id for each in found}
        rebuilt = (
            replace(each, made=tuple(name for name in each.made if name in known))
            for each in self.rebuilt
        )
        return Built(tuple(found), tuple(rebuilt))


def _until(each: Structure, step: int) -> Structure:
    """A structure until a step."""
    path = until(path_of(each), step)
    return replace(each, stays=path.stays, heading=path.heading, last=min(each.last, step))


def _made(each: Structure) -> Structure:
    """A structure that is still being made, as it will be first."""
    stays = ((each.first, each.first, each.stays[0][2]),)
    return replace(each, stays=stays, last=each.first, heading=None)


def path_of(each: Structure) -> Bundle:
    """The path of a structure."""
    own = each.class_name, each.capabilities, each.stays, each.heading
    return Bundle(*own, coming=each.coming)


def _rebuilt_then(each: Structure, world: World) -> Iterator[Finding]:
    """That modules are told of which are being rebuilt."""
    if each.first <= world.step:
        return
    for name in told_of(world):
        if name in (each.id, *each.modules):
            what = f"{name} is being rebuilt at step {world.step}"
            yield Finding(what, "say what becomes of it when that is done")
