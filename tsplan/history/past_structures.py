"""What structures of modules have done until a step, and what is being made of them then.

A structure is told of by its own id or by one of its modules.
"""

from __future__ import annotations

from collections.abc import Container, Iterable, Iterator
from dataclasses import replace
from functools import partial
from typing import TYPE_CHECKING, NamedTuple

from tsplan.errors import Finding, PlanError
from tsplan.history.told_paths import told_of, told_path, until
from tsplan.plans.bundles import Bundle
from tsplan.plans.structures import Rebuilt, Structure
from tsplan.plans.worlds import World

if TYPE_CHECKING:
    from tsplan.history.changed_map import Maps, Pace
    from tsplan.mission import Mission
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

    def under_way(self, step: int) -> tuple[Rebuilt, ...]:
        """What has begun to be rebuilt before a step and is not over before it."""
        first = {each.id: each.first for each in self.structures}
        return tuple(
            each
            for each in self.rebuilt
            if each.step < step and all(first[name] >= step for name in each.made)
        )

    def _begun(self, world: World) -> Built:
        """The same without what cannot have begun, since a world tells of what was to go in."""
        told = set(told_of(world))
        off = [each for each in self.under_way(world.step) if told.intersection(each.parts)]
        parts = {name for each in off for name in each.parts}
        made = {name for each in off for name in each.made}
        structures = (
            _staying(each, world.step) if each.id in parts else each
            for each in self.structures
            if each.id not in made
        )
        return Built(tuple(structures), tuple(each for each in self.rebuilt if each not in off))

    def really(self, world: World, maps: Maps) -> Built:
        """The same as a world says that it was.

        Where it tells of a structure by its id that should have gone into another by then, that has
        not begun to be made: its parts are still there. Raises PlanError for what it says of
        structures and cannot be.
        """
        begun = self._begun(world)
        findings: list[Finding] = [*begun.strange(world)]
        found: list[Structure] = []
        born = {name for each in begun.rebuilt for name in each.made}
        for each in begun.structures:
            over = each.last < world.step
            mine = [] if over else [n for n in told_of(world) if n in (each.id, *each.modules)]
            if len(mine) > 1:
                what = f"structure {each.id} is told of as {' and as '.join(mine)}"
                findings.append(Finding(what, "say it once"))
            try:
                seen = _seen(each, mine[0], world, maps, born=each.id in born) if mine else each
            except PlanError as error:
                findings += error.findings
                continue
            if seen is not None:
                found.append(seen)
        if findings:
            raise PlanError(findings)
        return Built(tuple(found), tuple(_come_out(begun.rebuilt, {each.id for each in found})))

    def strange(self, world: World) -> Iterator[Finding]:
        """Structures of which a world tells that have become others before."""
        lives = {each.id: each for each in self.structures}
        into = {name: each for each in self.rebuilt for name in each.parts}
        for name in told_of(world):
            if name in lives and lives[name].last < world.step and name in into:
                became = " and ".join(into[name].made) or "others"
                what = f"structure {name} has become {became} at step {into[name].step}"
                yield Finding(what, "tell of what it is now")

    def by(self, horizon: int) -> Built:
        """The same but for what is so late that it does not come to be by the end of a plan."""
        found = tuple(each for each in self.structures if each.first <= horizon)
        return Built(found, tuple(_come_out(self.rebuilt, {each.id for each in found})))


def _come_out(rebuilt: Iterable[Rebuilt], there: Container[str]) -> Iterator[Rebuilt]:
    """What is rebuilt, as far as structures come out; where all are lost, nothing was."""
    for each in rebuilt:
        made = tuple(name for name in each.made if name in there)
        if made or not each.made:
            yield replace(each, made=made)


def _seen(each: Structure, name: str, world: World, maps: Maps, *, born: bool) -> Structure | None:
    """A structure until the step of a world, as that says of a name; None if it never was.

    One that is `born` of others may come to be later than planned, as it may come to its first
    state.
    """
    before = path_of(each)
    path = told_path(
        world, maps, name, replace(before, coming=before.stays[0][2]) if born else before
    )
    if not path.stays and path.heading is None:
        return None
    if born and not path.stays:
        if name in world.moved:
            what = f"{name} is being rebuilt at step {world.step}"
            raise PlanError([Finding(what, "say at which state it is, or that it is late")])
        first, state = each.first + world.late[name], each.stays[0][2]
        return _made(replace(each, first=first, stays=((first, first, state),)))
    there = path.heading or path.stays[-1][1] == world.step
    return replace(
        each,
        stays=path.stays,
        heading=path.heading,
        first=path.stays[0][0] if born else each.first,
        last=world.step if there else world.step - 1,
    )


def _until(each: Structure, step: int) -> Structure:
    """A structure until a step."""
    path = until(path_of(each), step)
    return replace(each, stays=path.stays, heading=path.heading, last=min(each.last, step))


def _made(each: Structure) -> Structure:
    """A structure that is still being made, as it will be first."""
    stays = ((each.first, each.first, each.stays[0][2]),)
    return replace(each, stays=stays, last=each.first, heading=None)


def _staying(each: Structure, step: int) -> Structure:
    """A structure that stays on where it was until a step."""
    *before, (first, _, state) = each.stays
    return replace(each, stays=(*before, (first, step, state)), last=step)


def path_of(each: Structure) -> Bundle:
    """The path of a structure."""
    own = each.class_name, each.capabilities, each.stays, each.heading
    return Bundle(*own, coming=each.coming)


def structure_pace(mission: Mission, each: Structure) -> Pace:
    """How long edges take a structure."""
    shape = mission.modular.of[each.configuration]
    return partial(shape.steps, class_name=each.class_name)
