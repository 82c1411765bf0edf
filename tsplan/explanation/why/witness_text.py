"""The evidence for a formula in words, as an indented tree."""

from __future__ import annotations

import math
from collections.abc import Iterable, Mapping
from types import MappingProxyType
from typing import TYPE_CHECKING

import numpy as np

from tsplan.explanation.why.requirements import runs
from tsplan.logic.atoms import Count
from tsplan.logic.nodes import Always, Eventually, Formula, Release, Until
from tsplan.logic.text import Operand, layout, text_of
from tsplan.plans.summary import names
from tsplan.words import number

if TYPE_CHECKING:
    from tsplan.explanation.why.witness_tree import Presence, WitnessNode
    from tsplan.logic.time_horizon import Span

MOST_LINES = 2000
"""Nodes that are printed; a formula that repeats itself can have many more."""

_LONGEST = 60  # characters of a formula in one line
_RUNS = 4
_STATES = 4


def tree_text(top: WitnessNode) -> str:
    """The tree, one node a line: what it is, when it holds, its availability and its choice.

    Nodes are indented by two columns for each level.
    """
    rows: list[tuple[str, str]] = []
    rest = 0
    for depth, node in top.walk():
        if len(rows) >= MOST_LINES:
            rest += 1
            if rest > MOST_LINES:
                break
            continue
        rows.append(("  " * depth + title(node), verdict(node)))
    width = min(max(len(left) for left, _ in rows), _LONGEST)
    lines = [f"{left:<{width}}  {right}".rstrip() for left, right in rows]
    if rest:
        more = f"more than {MOST_LINES}" if rest > MOST_LINES else str(rest)
        lines.append(f"... and {more} further nodes")
    return "\n".join(lines)


def title(node: WitnessNode) -> str:
    """A node without what is below it, and what an atom means where its text alone does not say."""
    text = operator_text(node.formula)
    if not node.formula.children and node.meaning is not node.formula and not node.children:
        return f"{text} (that is {node.meaning})"
    return text


def operator_text(formula: Formula) -> str:
    """The text of a node's operator alone; of an atom or task, its whole text.

    >>> from tsplan.logic import parse
    >>> operator_text(parse("F[0,3] a")), operator_text(parse("sum(a) > 2"))
    ('F[0,3]', 'sum(a) > 2')
    """
    if not formula.children:
        return text_of(formula, _LONGEST)
    parts = layout(formula).parts
    signs = dict.fromkeys(part.strip() for part in parts if not isinstance(part, Operand))
    return " ".join(sign for sign in signs if sign)


def verdict(node: WitnessNode) -> str:
    """What is said about a node: whether it holds, where, how well, and what it rests on."""
    if not node.steps:
        return "not needed"
    worst = node.worst or 0.0
    level = ("unbounded" if worst > 0 else "impossible") if math.isinf(worst) else number(worst)
    words = [_held(node), f"availability {level}"]
    if node.witness_steps:
        words.append(_choice(node))
    if node.counts:
        least, most = min(node.counts), max(node.counts)
        words += [f"count {least}" if least == most else f"count {least}..{most}", *_who(node)]
    text = ", ".join(words)
    return text if node.needed else f"(not needed: {text})"


def run_words(spans: Iterable[Span], most: int | None = None) -> str:
    """Runs of steps in words, `most` of them at most.

    >>> run_words([(1, 3), (7, 7)])
    '1..3, 7'
    """
    said = [str(first) if first == last else f"{first}..{last}" for first, last in spans]
    return ", ".join(said if most is None or len(said) <= most else [*said[:most], "..."])


def _at(steps: Iterable[int]) -> str:
    """Steps in words; only the first few runs of them."""
    return run_words(runs(np.array(sorted(set(steps)), dtype=np.int64)), _RUNS)


def _held(node: WitnessNode) -> str:
    where = f"at {_at(node.steps)}"
    if node.holds:
        return f"holds {where}"
    failing = [s for s, value in zip(node.steps, node.availability, strict=True) if value < 0]
    if len(failing) == len(node.steps):
        return f"fails {where}"
    return f"holds {where} but for {_at(failing)}"


def _choice(node: WitnessNode) -> str:
    """The steps that a temporal operator rests on."""
    steps = [step for step in node.witness_steps if step is not None]
    if not steps:
        return "held all through" if isinstance(node.formula, Release) else "never given up"
    words = _RESTS.get(type(node.formula), ("step", "step"))
    return f"{words[0 if node.holds else 1]} {_at(steps)}"


_RESTS: Mapping[type[Formula], tuple[str, str]] = MappingProxyType(
    {
        Eventually: ("met at", "closest at"),
        Always: ("tightest at", "tightest at"),
        Until: ("right side at", "left side ends at"),
        Release: ("released at", "right side fails at"),
    }
)
"""What the witness steps are, where an operator holds and where it fails."""


def _who(node: WitnessNode) -> list[str]:
    """Who stands there at the tightest step; empty states count where every state does."""
    everywhere = isinstance(node.meaning, Count) and node.meaning.function == "min"
    there = [presence for presence in node.present if presence.count or everywhere]
    if not there:
        return []
    shown = "; ".join(_presence(presence) for presence in there[:_STATES])
    more = f"; {len(there) - _STATES} more states" if len(there) > _STATES else ""
    return [f"at step {node.tightest}: {shown}{more}"]


def _presence(presence: Presence) -> str:
    if not presence.ids:
        who = f"{presence.count:,} agents" if presence.count else "nobody"
        return f"{who} at {presence.state}"
    more = presence.count - len(presence.ids)
    rest = f" and {more:,} more" if more else ""
    return f"{names(presence.ids)}{rest} at {presence.state}"
