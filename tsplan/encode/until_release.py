"""Until and release: one side gives way to the other at a step that is chosen.

For a single request the step is one choice among those of its window, and the side that must last
until then is asked of every option for as long as it takes. Where that would be many columns,

* requests that exclude each other choose one step for all of them (`Asker.relayed`), and what must
  last is asked of the running total of those that have begun and not ended;
* requests of one column at many steps (under an always) share their steps, as eventualities do.
"""

from __future__ import annotations

from collections.abc import Iterable, Sequence

import numpy as np

from tsplan.encode.encoder_rules import Asker, sorted_out
from tsplan.encode.running_sums import RunningSums
from tsplan.encode.selection import Selection
from tsplan.encode.step_runs import Span, steps_of
from tsplan.logic import Release, Until
from tsplan.milp.model import Ints

_COPIES = 4  # columns of single choices for each of a common one
_FEW = 2000  # columns of single choices that are never too many: they make the tighter model


def until(asker: Asker, node: Until, spans: Sequence[Span]) -> None:
    """Require an until: the right side at a step of the window, the left side before it."""
    rest: list[Span] = []
    for family, again in _groups(asker, spans):
        lost = [asker.optimistic.first_impossible(node.left, span.first) for span in family]
        begun = np.array([span.first for span in family])
        window = np.stack([begun + node.low, np.minimum(begun + node.high, lost)], axis=1)
        if _few(window) or len(family) == 1:
            rest += family
        elif again:
            _shared_until(asker, node, family, window)
        else:
            _relayed_until(asker, node, family, window)
    for step, _, selection in rest:
        last = min(step + node.high, asker.optimistic.first_impossible(node.left, step))
        times = asker.times(node.right, [(step + node.low, last)])
        for time, option in zip(times, asker.options(selection, times, "until"), strict=True):
            asker.ask(node.right, Span(time, time, option))
            if time > step:
                asker.ask(node.left, Span(step, time - 1, option))


def _groups(asker: Asker, spans: Sequence[Span]) -> list[tuple[list[Span], bool]]:
    """Requests of single steps: families that exclude each other, and of columns that ask again."""
    once, again = sorted_out(spans)
    single = []
    for family in asker.families(once):
        merged: dict[int, Selection] = {}
        for step, _, selection in family:
            merged[step] = merged.get(step, ()) + selection
        single.append((_at(merged.items()), False))
    repeated = _at(asker.choices.by_step([span for runs in again.values() for span in runs]))
    return [*single, *([(repeated, True)] if repeated else [])]


def _at(requests: Iterable[tuple[int, Selection]]) -> list[Span]:
    return [Span(step, step, selection) for step, selection in requests]


def _few(window: Ints) -> bool:
    """Whether a choice for each window is no more than a few for each step."""
    length = np.maximum(window[:, 1] - window[:, 0] + 1, 0)
    copies = int(length.sum())
    return copies <= _FEW or copies <= _COPIES * int(window.max() - window.min() + 1)


def _relayed_until(asker: Asker, node: Until, family: Sequence[Span], window: Ints) -> None:
    """One change-over for a family; who has begun and not changed needs the left side."""
    times = asker.times(node.right, window.tolist())
    chosen = asker.relayed(family, window, times, "until")
    asker.ask_at(node.right, chosen)
    for span in _between(asker, [(span.first, span.selection) for span in family], chosen):
        asker.ask(node.left, span)


def _between(
    asker: Asker,
    begun: Sequence[tuple[int, Selection]],
    ended: Sequence[tuple[int, Selection]],
) -> list[Span]:
    """Selections of those that have begun and not ended, and how long each is that."""
    if not ended:
        return []
    entries = [(step, column, 1) for step, selection in begun for column in selection]
    entries += [(step, column, -1) for step, selection in ended for column in selection]
    step, column, sign = np.array(entries).T
    above = [column for _, selection in begun for column in selection]
    return asker.choices.running(RunningSums(step, column, sign), above)


def _shared_until(asker: Asker, node: Until, family: Sequence[Span], window: Ints) -> None:
    """Change-overs for all requests: the first in a window ends every request that waits for one.

    Who waits at a step is a column of its own: whose window begins there, or who waited at the step
    before, and finds no change-over.
    """
    requests = [(span.first, span.selection) for span in family]
    changes = asker.shared(node.right, requests, window, "until")
    asked: dict[int, list[Selection]] = {}
    for step, selection in requests:
        if node.low:
            asker.ask(node.left, Span(step, step + node.low - 1, selection))
        asked.setdefault(step + node.low, []).append(selection)
    waiting = asker.choices.waiting(asked, changes, "until")
    asker.ask_at(node.left, [(step, (column,)) for step, column in waiting])


def release(asker: Asker, node: Release, spans: Sequence[Span]) -> None:
    """Require a release: the right side throughout the window, or up to a step of the left side."""
    rest: list[Span] = []
    for family, again in _groups(asker, spans):
        begun = np.array([span.first for span in family])
        window = np.stack([begun, begun + node.high], axis=1)
        if _few(window) or len(family) == 1 or again:
            rest += family
        else:
            _relayed_release(asker, node, family, window)
    for step, _, selection in rest:
        first, last = step + node.low, step + node.high
        held = min(last, asker.optimistic.first_impossible(node.right, first))
        times = asker.times(node.left, [(step, held - 1)])
        never = [last] if asker.optimistic.possible_throughout(node.right, first, last) else []
        options = asker.options(selection, times + never, "release")
        asker.ask_at(node.left, zip(times, options, strict=False))
        for time, option in zip(times + never, options, strict=True):
            if time >= first:
                asker.ask(node.right, Span(first, time, option))


def _relayed_release(asker: Asker, node: Release, family: Sequence[Span], window: Ints) -> None:
    """One end for a family: before the right side is needed, or after it has been held for a while.

    Held ends are releases by the left side, or the last step of a window without one.
    """
    late = _not_released_early(asker, node, family, window) if node.low else family
    lost = [asker.optimistic.first_impossible(node.right, s.first + node.low) - 1 for s in late]
    held = np.stack([window[:, 0] + node.low, np.minimum(window[:, 1], lost)], axis=1)
    unreleased: dict[int, Selection] = {}
    for span, end in zip(late, window[:, 1].tolist(), strict=True):
        unreleased[end] = unreleased.get(end, ()) + span.selection
    latest = int(window[:, 1].max())  # a release at the very end of a window changes nothing
    runs = [(low, high) for low, high in held.tolist() if low <= high]
    able = {time for time in asker.times(node.left, runs) if time < latest}
    times = sorted(able | (set(steps_of(runs).tolist()) & unreleased.keys()))
    chosen = asker.relayed(late, held, times, "release")
    for time, option in chosen:
        released = option
        if time in unreleased:
            steps = [time] * (2 if time in able else 1)
            *both, kept = asker.options(option, steps, "release")
            asker.choices.cover(np.array(unreleased[time], dtype=np.int64), kept, "release")
            released = both[0] if both else ()
        if released:
            asker.ask(node.left, Span(time, time, released))
    begun = [(span.first + node.low, span.selection) for span in late]
    for span in _between(asker, begun, [(time + 1, option) for time, option in chosen]):
        asker.ask(node.right, span)


def _not_released_early(
    asker: Asker, node: Release, family: Sequence[Span], window: Ints
) -> list[Span]:
    """Let some be released before the right side is needed; selections of those that are not."""
    early, late = [], []
    for first, last, selection in family:
        options = asker.options(selection, [first, first + node.low], "release")
        early.append(Span(first, last, options[0]))
        late.append(Span(first, last, options[1]))
    before = np.stack([window[:, 0], window[:, 0] + node.low - 1], axis=1)
    times = asker.times(node.left, before.tolist())
    asker.ask_at(node.left, asker.relayed(early, before, times, "release"))
    return late
