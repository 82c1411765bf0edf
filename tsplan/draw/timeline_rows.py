"""The rows of a timeline: agents, paths, groups, and those who never move folded into one row."""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterable, Sequence
from dataclasses import dataclass, replace

from tsplan.draw.tracks import Stop, Track, by_class, single
from tsplan.plans.plan import Plan
from tsplan.plans.summary import names

MOST_AGENTS = 24
"""Agents up to which each has a row of its own."""

MOST_PATHS = 60
"""Different paths up to which each has a row; beyond, each class has one band."""

_SAID = 3  # states that are named of those who never move


@dataclass(frozen=True)
class Row:
    """What a row shows: where its agents are, and where they were to be if that is known, too."""

    shown: Track
    planned: Track | None = None


def rows_of(plan: Plan, moving: Sequence[Track]) -> tuple[Track, ...]:
    """The rows, class by class; none for a team with too many paths.

    Up to `MOST_AGENTS` agents each has a row. Of more, each path has one, movers first, and those
    of a class who never move are folded into one.
    """
    if sum(len(track.ids) or 1 for track in moving) <= MOST_AGENTS:
        alone = tuple(single(moving))
        order = {name: place for place, name in enumerate(by_class(moving))}
        place = {agent.id: place for place, agent in enumerate(plan.agents)}
        return tuple(
            sorted(alone, key=lambda t: (order[t.class_name], place.get(t.name, len(place))))
        )
    rows = folded(path_rows(moving), plan.horizon)
    return rows if len(rows) <= MOST_PATHS else ()


def path_rows(moving: Sequence[Track]) -> tuple[Track, ...]:
    """A row for each track, named by its first agents and their number."""
    return tuple(
        replace(track, name=f"{track.short} ({track.count})") if len(track.ids) > 1 else track
        for track in moving
    )


def folded(rows: Iterable[Track], horizon: int) -> tuple[Track, ...]:
    """The rows of each class with those that move first, and the others as one."""
    made: list[Track] = []
    for group in by_class(rows).values():
        idle = [track for track in group if is_idle(track)]
        made += (track for track in group if not is_idle(track))
        made += [_fold(idle, horizon)] if len(idle) > 1 else idle
    return tuple(made)


def is_idle(track: Track) -> bool:
    """Whether agents stay where they are from the beginning to the end."""
    return bool(track.ids) and not track.moves and not track.lives and not track.modules


def _fold(idle: Sequence[Track], horizon: int) -> Track:
    """One row for several tracks that never move; its stop says how many are where."""
    there: Counter[str] = Counter()
    for track in idle:
        there[track.stops[0].state] += track.count
    most = [f"{count:,} at {state}" for state, count in there.most_common(_SAID)]
    more = [f"and {len(there) - _SAID} more states"] if len(there) > _SAID else []
    ids = tuple(name for track in idle for name in track.ids)
    stop = Stop(0, horizon, ", ".join([*most, *more]))
    name = f"{len(ids):,} idle {idle[0].class_name}"
    return replace(idle[0], count=len(ids), name=name, ids=ids, stops=(stop,))


def paired(rows: Sequence[Track], planned: Sequence[Track]) -> tuple[Row, ...]:
    """Each row with where its agents were to be; a row of agents with several plans is split."""
    plan_of = {name: track for track in planned for name in track.ids}
    bare = {track.name: track for track in planned if not track.ids}
    made = []
    for row in rows:
        if not row.ids:
            made.append(Row(row, bare.get(row.name)))
            continue
        parts: dict[int, list[str]] = {}
        for name in row.ids:
            parts.setdefault(id(plan_of.get(name)), []).append(name)
        for ids in parts.values():
            whole = len(parts) == 1
            label = row.name if whole else names(ids, most=1)
            made.append(
                Row(replace(row, ids=tuple(ids), count=len(ids), name=label), plan_of.get(ids[0]))
            )
    return tuple(made)
