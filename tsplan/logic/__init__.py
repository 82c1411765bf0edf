"""Formulas over teams and signals: nodes, texts, normal forms, horizon, meaning on traces.

The languages share one tree: `mtl` counts agents at labels, `catl` adds tasks and limits, `stl`
compares real signals, `wmtl` and `wstl` add weights. `parse` reads a text, `str` writes it again.
"""

from __future__ import annotations

from typing import TYPE_CHECKING

from tsplan.lazy_names import lazily
from tsplan.logic import layouts  # noqa: F401  (formulas can be printed once it is loaded)
from tsplan.logic.atoms import (
    Count,
    Execution,
    Function,
    Known,
    Limit,
    Linear,
    Percent,
    Relation,
    Task,
    at_least,
    at_most,
    each_at_least,
    each_at_most,
    limit,
    linear,
    task,
)
from tsplan.logic.catl import resolve_percent, translate
from tsplan.logic.derived import all_of, all_steps, one_of, one_step
from tsplan.logic.margin import tighten
from tsplan.logic.nodes import (
    FALSE,
    TRUE,
    Always,
    And,
    Constant,
    Eventually,
    Formula,
    Iff,
    Implies,
    Not,
    Or,
    Pair,
    Release,
    Several,
    Switch,
    Until,
    Whole,
    Window,
    conjunction,
    disjunction,
)
from tsplan.logic.normal_form import negation, positive
from tsplan.logic.parsing import LANGUAGES, Language, parse, parse_with_places
from tsplan.logic.simplification import simplify
from tsplan.logic.symbols import capabilities, labels, variables
from tsplan.logic.time_horizon import horizon
from tsplan.logic.traversal import fold, substitute, walk, walk_all

if TYPE_CHECKING:
    from tsplan.logic.evaluation import CountTrace, SignalTrace, holds, robustness
    from tsplan.logic.progression import progress

__all__ = [
    "FALSE",
    "LANGUAGES",
    "TRUE",
    "Always",
    "And",
    "Constant",
    "Count",
    "CountTrace",
    "Eventually",
    "Execution",
    "Formula",
    "Function",
    "Iff",
    "Implies",
    "Known",
    "Language",
    "Limit",
    "Linear",
    "Not",
    "Or",
    "Pair",
    "Percent",
    "Relation",
    "Release",
    "Several",
    "SignalTrace",
    "Switch",
    "Task",
    "Until",
    "Whole",
    "Window",
    "all_of",
    "all_steps",
    "at_least",
    "at_most",
    "capabilities",
    "conjunction",
    "disjunction",
    "each_at_least",
    "each_at_most",
    "fold",
    "holds",
    "horizon",
    "labels",
    "limit",
    "linear",
    "negation",
    "one_of",
    "one_step",
    "parse",
    "parse_with_places",
    "positive",
    "progress",
    "resolve_percent",
    "robustness",
    "simplify",
    "substitute",
    "task",
    "tighten",
    "translate",
    "variables",
    "walk",
    "walk_all",
]

# they need NumPy
__getattr__, __dir__ = lazily(
    __name__,
    {
        "logic.evaluation": ("CountTrace", "SignalTrace", "holds", "robustness"),
        "logic.progression": ("progress",),
    },
)
