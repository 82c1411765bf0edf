"""Whether sub-swarms keep their bounds, and whether a plan names those that its moves make."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Sequence
from typing import TYPE_CHECKING, NamedTuple, TypeAlias

if TYPE_CHECKING:
    from tsplan.checking.traffic import Traffic
    from tsplan.plans.subswarms import SubSwarm


class GroupPlace(NamedTuple):
    """A sub-swarm at one step: whose, where, and how many agents."""

    swarm: str
    place: str
    size: int

    @property
    def words(self) -> str:
        """The sub-swarm in a sentence."""
        return f"sub-swarm of {self.size} agents of {self.swarm} {self.place}"


Table: TypeAlias = "list[list[GroupPlace]]"
_Key: TypeAlias = "tuple[str, str, int, int]"


def _table(groups: Iterable[SubSwarm], horizon: int) -> Table:
    """The sub-swarms at every step 0..horizon."""
    table: Table = [[] for _ in range(horizon + 1)]
    for group in groups:
        since = "" if group.edge is None else f" since step {group.first - 1}"
        for step in range(group.first, min(group.last, horizon) + 1):
            table[step].append(GroupPlace(group.swarm, f"{group.place}{since}", group.size))
    return [sorted(row) for row in table]


def broken_bounds(traffic: Traffic) -> Iterator[str]:
    """Steps at which there are too many sub-swarms, or too small ones."""
    rules = traffic.mission.swarm
    if rules is None:
        return
    for step, row in enumerate(_table(traffic.groups, traffic.horizon)):
        for swarm, bounds in rules.each.items():
            mine = [entry for entry in row if entry.swarm == swarm]
            if bounds.most is not None and len(mine) > bounds.most:
                listed = ", ".join(f"{entry.size} {entry.place}" for entry in mine)
                yield (
                    f"{swarm} is in {len(mine)} sub-swarms at step {step}, and max_subswarms is "
                    f"{bounds.most}: {listed}"
                )
            for entry in mine:
                if entry.size < bounds.least:
                    yield (
                        f"the sub-swarm of {swarm} {entry.place} has {entry.size} agents at step "
                        f"{step}, and min_subswarm is {bounds.least}"
                    )
        if rules.together is not None and len(row) > rules.together:
            yield (
                f"the swarms together are in {len(row)} sub-swarms at step {step}, and "
                f"max_subswarms is {rules.together}"
            )


def misnamed(named: Sequence[SubSwarm], traffic: Traffic) -> Iterator[str]:
    """Steps at which the sub-swarms that a plan names are not those that its moves make."""
    if not named:
        return
    true = _table(traffic.groups, traffic.horizon)
    for step, (row, other) in enumerate(zip(true, _table(named, traffic.horizon), strict=True)):
        for entry in sorted(set(other) - set(row)):
            yield f"the plan names a {entry.words} at step {step}, which its moves do not make"
        for entry in sorted(set(row) - set(other)):
            yield f"the plan names no {entry.words} at step {step}, which its moves make"


def unrelated(named: Sequence[SubSwarm], traffic: Traffic) -> Iterator[str]:
    """Sub-swarms whose steps or relatives are not what the moves make of them."""
    true = dict(_relatives(traffic.groups))
    for group, (key, others) in zip(named, _relatives(named), strict=True):
        if true.get(key) != others:
            yield (
                f"sub-swarm {group.id} {group.place} from step {group.first} to {group.last} has "
                "other steps, parents or children by the moves"
            )


def _relatives(groups: Sequence[SubSwarm]) -> list[tuple[_Key, tuple[frozenset[_Key | None], ...]]]:
    """What each sub-swarm comes from and becomes, with all of them told apart by where they are."""
    key: dict[str, _Key] = {g.id: (g.swarm, g.place, g.first, g.last) for g in groups}
    return [
        (key[g.id], tuple(frozenset(map(key.get, ids)) for ids in (g.parents, g.children)))
        for g in groups
    ]
