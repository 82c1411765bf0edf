"""The mission over signals: a system, a formula, and what to optimise."""

from __future__ import annotations

from dataclasses import dataclass

from tsplan.signals.signal_parts import SignalParts


@dataclass(frozen=True)
class SignalMission(SignalParts):
    """A system, a formula over its signals, and what to optimise.

    `formula` speaks of signals and controls alone: outputs and regions are replaced in it, weights
    are on its nodes. `horizon` is the last step, at least the formula's own. `objective` is one aim
    after the other; without any, every satisfying trajectory is as good as another. `satisfaction`
    is the order in which a formula may hold in part (None: it must hold), `prefer` has formulas
    that are met as far as possible besides. `regions` are kept for pictures, `parts` the texts of
    what the formula joins at its top, with their formulas. Where there are several robots, `copies`
    has their names: the signals of `a` begin with `a_`. `digest` is the SHA-256 of the text,
    `warnings` are what looks odd in it; a mission that was read from a file keeps its document as
    `origin`, for places in it.
    """
