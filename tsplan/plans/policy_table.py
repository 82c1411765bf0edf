"""The policies of a plan as a table: what to do where, and how many are expected to be there."""

from __future__ import annotations

from typing import TYPE_CHECKING

from tsplan.words import number, visible

if TYPE_CHECKING:
    from collections.abc import Iterator, Sequence

    from rich.console import RenderableType

    from tsplan.plans.plan import Plan
    from tsplan.plans.policies import Policy

MOST_ROWS = 40
"""States and steps that are listed; the rest is only counted."""

_FEW = 0.005  # of an agent: who is expected so rarely is not listed
_ROUND = 0.995  # a share from which on an action is named without it


def policy_table(plan: Plan) -> list[RenderableType]:
    """One row for each class, state and run of steps with the same choice, while there is room."""
    from rich.table import Table  # noqa: PLC0415  (slow to import)
    from rich.text import Text  # noqa: PLC0415

    table = Table(box=None, pad_edge=False, show_edge=False, padding=(0, 1))
    for heading in ("class", "steps", "state", "expected"):
        table.add_column(heading, overflow="fold")
    table.add_column("action", overflow="fold", ratio=1)
    rows = [row for policy in plan.policies for row in _rows(policy)]
    for row in rows[:MOST_ROWS]:
        table.add_row(*(Text(visible(cell)) for cell in row))
    if len(rows) <= MOST_ROWS:
        return [table]
    rest = f"  ... and {len(rows) - MOST_ROWS:,} more rows; the JSON plan has them all"
    return [table, rest]


def _rows(policy: Policy) -> Iterator[tuple[str, ...]]:
    """What is done where agents are expected, in the order of the steps at which that begins."""
    open_: dict[str, list[tuple[int, str, float]]] = {}
    runs: list[tuple[int, int, str, float, float, str]] = []
    taken = sorted(policy.taken.items(), key=lambda item: (item[0][0], item[0][1]))
    for (state, step), actions in taken:
        agents = policy.expected[state][step] if state in policy.expected else 0.0
        if agents < _FEW:
            continue
        words = action_words(actions)
        run = open_.setdefault(state, [])
        if run and (run[-1][0] != step - 1 or run[-1][1] != words):
            runs.append(_run(state, run))
            run.clear()
        run.append((step, words, agents))
    runs += [_run(state, run) for state, run in open_.items()]
    for first, last, state, least, most, words in sorted(runs):
        steps = f"{first}" if first == last else f"{first}-{last}"
        low, high = number(round(least, 2)), number(round(most, 2))
        yield policy.class_name, steps, state, low if low == high else f"{low}-{high}", words


def _run(
    state: str, run: Sequence[tuple[int, str, float]]
) -> tuple[int, int, str, float, float, str]:
    numbers = [agents for _, _, agents in run]
    return run[0][0], run[-1][0], state, min(numbers), max(numbers), run[0][1]


def action_words(actions: Sequence[tuple[str, float]]) -> str:
    """What is done at a state, the likeliest action first.

    >>> action_words([("wait", 0.25), ("go", 0.75)]), action_words([("go", 1.0)])
    ('go 75 %, wait 25 %', 'go')
    """
    ordered = sorted(actions, key=lambda pair: -pair[1])
    name, chance = ordered[0]
    if chance >= _ROUND:
        return name
    return ", ".join(f"{name} {100 * chance:.0f} %" for name, chance in ordered)
