"""How often formulas held in the runs of a trial, and how long planning again took."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

from tsplan.draw.matplotlib_loading import library
from tsplan.errors import Finding, InputError

if TYPE_CHECKING:
    from tsplan.frequency import Frequency
    from tsplan.replanning.execution_trial import Trial

_KEPT, _REPLANNED = "#8a8a8a", "#2f5f9e"
_BINS = 20  # of the seconds at most


def draw_trial(trial: Trial) -> tuple[Any, list[Any]]:
    """The shares of the runs in which the formula held, and the seconds of planning again.

    A line over each share is its interval at 95 %. Returns the figure and its axes. Raises
    InputError without any run, PlotUnavailableError without matplotlib.
    """
    if not trial.runs:
        raise InputError([Finding("there is no run to draw", "let some runs end first")])
    figure = library("figure").Figure(figsize=(8.4, 3.6), layout="constrained")
    shares, times = figure.subplots(1, 2)
    bars = [("as planned", trial.kept, _KEPT)]
    if trial.replanned is not None:
        bars.append(("planned again", trial.replanned, _REPLANNED))
    for place, (_, frequency, colour) in enumerate(bars):
        _draw_share(shares, place, frequency, colour)
    shares.set_xticks(range(len(bars)), [name for name, _, _ in bars])
    shares.set_xlim(-0.6, 1.6)
    shares.set_ylim(0, 1)
    shares.set_ylabel(f"share of {len(trial.runs):,} runs in which the formula held")
    if trial.seconds:
        times.hist(trial.seconds, bins=min(_BINS, len(trial.seconds)), color=_REPLANNED)
    else:
        times.text(0.5, 0.5, "never planned again", ha="center", transform=times.transAxes)
    times.set_xlabel("seconds of planning again")
    times.set_ylabel("times")
    for ax in (shares, times):
        ax.spines[["top", "right"]].set_visible(False)
    return figure, [shares, times]


def _draw_share(ax: Any, place: int, frequency: Frequency, colour: str) -> None:
    """A bar, its interval and the number of runs."""
    ax.bar(place, frequency.rate, width=0.7, color=colour)
    ax.plot([place, place], [frequency.low, frequency.high], color="black", linewidth=1.2)
    ax.text(place + 0.06, min(frequency.rate + 0.02, 0.95), f"{frequency.times}", fontsize=9)
