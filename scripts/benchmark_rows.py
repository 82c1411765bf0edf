"""The rows of a benchmark: one for each run, and what is told of them all."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from statistics import median

import numpy as np

CLOSE = 1e-3
"""Values this close count as equal: those of the encodings with a constant of 1000 are off by that
much, with a solver's tolerance of 1e-6. Values of other missions are whole or cents."""


@dataclass(frozen=True)
class Row:
    """One run."""

    family: str
    axis: str
    value: float
    seed: int
    encoding: str
    status: str
    seconds: float
    first_plan: float | None
    objective: Mapping[str, float | None]
    root_bound: float | None
    final_bound: float | None
    final_value: float | None
    columns: int
    integers: int
    rows: int
    extract: float
    cpu: float  # processor seconds of the whole run, and until the first plan
    first_cpu: float | None

    @property
    def values(self) -> str:
        """The values of the objectives in words."""
        return " ".join(
            f"{name}={'none' if value is None else format(value, '.10g')}"
            for name, value in self.objective.items()
        )

    @property
    def optimal(self) -> bool:
        """Whether the run ended with a proof: an optimum or infeasibility."""
        return self.status in ("optimal", "infeasible")


def table(rows: Sequence[Row]) -> str:
    """A Markdown table: one line per family, value and encoding."""
    lines = [
        (
            "| family | value | encoding | runs | proven | first plan median / worst | "
            "total median / quartiles / worst | root gap median | columns | rows |"
        ),
        "|---|---|---|---|---|---|---|---|---|---|",
    ]
    groups: dict[tuple[str, str, float, str], list[Row]] = {}
    for row in rows:
        groups.setdefault((row.family, row.axis, row.value, row.encoding), []).append(row)
    for (family, axis, value, encoding), members in groups.items():
        seconds = [row.seconds for row in members]
        firsts = [row.first_plan for row in members if row.first_plan is not None] or [float("nan")]
        low, high = np.percentile(seconds, [25, 75])
        lines.append(
            f"| {family} | {axis} {value:g} | {encoding} | {len(members)} "
            f"| {sum(row.optimal for row in members)} "
            f"| {median(firsts):.3f} / {max(firsts):.3f} "
            f"| {median(seconds):.2f} / {low:.2f}-{high:.2f} / {max(seconds):.2f} "
            f"| {_gap(members)} | {median(r.columns for r in members):.0f} "
            f"| {median(r.rows for r in members):.0f} |"
        )
    return "\n".join(lines)


def processor(rows: Sequence[Row]) -> str:
    """Processor seconds of each family and value, however busy the machine was."""
    groups: dict[tuple[str, str, float, str], list[Row]] = {}
    for row in rows:
        groups.setdefault((row.family, row.axis, row.value, row.encoding), []).append(row)
    lines = ["Processor seconds, median / worst:"]
    for (family, axis, value, encoding), members in groups.items():
        firsts = [row.first_cpu for row in members if row.first_cpu is not None] or [float("nan")]
        total = [row.cpu for row in members]
        lines.append(
            f"{family} {axis} {value:g} {encoding}: first plan {median(firsts):.1f} / "
            f"{max(firsts):.1f}, total {median(total):.1f} / {max(total):.1f}"
        )
    return "\n".join(lines)


def _gap(rows: Sequence[Row]) -> str:
    gaps = [
        abs(row.final_value - row.root_bound) / max(abs(row.final_value), 1e-9)
        for row in rows
        if row.final_value is not None and row.root_bound is not None
    ]
    return f"{100 * median(gaps):.1f} %" if gaps else "-"


def ratios(rows: Sequence[Row], own: str) -> str:
    """How much longer the other encodings took on the same missions, where both ended proven."""
    by_case: dict[tuple[str, str, float, int], dict[str, Row]] = {}
    for row in rows:
        by_case.setdefault((row.family, row.axis, row.value, row.seed), {})[row.encoding] = row
    others = {row.encoding: None for row in rows if row.encoding != own}
    found: dict[str, list[float]] = {name: [] for name in others}
    unequal, lines = [], []
    for key, runs in by_case.items():
        for name in others:
            if name not in runs or not (runs[name].optimal and runs[own].optimal):
                continue
            found[name].append(runs[name].seconds / runs[own].seconds)
            if not agree(runs[name], runs[own]):
                unequal.append(f"{key}: {runs[own].values} against {runs[name].values}")
    lines = [
        f"{name}/{own}: median {median(values):.1f}, {min(values):.1f} to {max(values):.1f} "
        f"over {len(values)} missions that both proved"
        for name, values in found.items()
        if values
    ]
    if len(others) > 1:
        proven = [runs for runs in by_case.values() if len(runs) > 1 and runs[own].optimal]
        lines += [_best_ratio(proven, own)] if proven else []
    return "\n".join(lines + [f"DIFFERENT {line}" for line in unequal])


def _best_ratio(cases: Sequence[Mapping[str, Row]], own: str) -> str:
    """How much longer the best of the other encodings took; its time limit if none had a proof."""
    values, at_least = [], 0
    for runs in cases:
        rest = [row for name, row in runs.items() if name != own]
        proven = [row.seconds for row in rest if row.optimal]
        at_least += not proven
        values.append(min(proven or [row.seconds for row in rest]) / runs[own].seconds)
    names = ", ".join(name for name in cases[0] if name != own)
    return (
        f"best of {names}/{own}: median {median(values):.1f}, {min(values):.1f} to "
        f"{max(values):.1f} over {len(values)} missions, with its time limit for the {at_least} "
        "that none of them proved"
    )


def agree(one: Row, other: Row) -> bool:
    """Whether two runs ended alike: same status, same values of the objectives that both name."""
    if one.status != other.status:
        return False
    pairs = [(value, other.objective.get(name, value)) for name, value in one.objective.items()]
    return all(
        mine == theirs or (None not in (mine, theirs) and abs(mine - theirs) <= CLOSE)
        for mine, theirs in pairs
    )


def plot(rows: Sequence[Row], path: str) -> None:
    """Seconds against the axis, total and first plan."""
    from matplotlib import pyplot as plt  # noqa: PLC0415 - an optional dependency

    figure, axes = plt.subplots(figsize=(5, 3.5), layout="constrained")
    for name, pick in (("total", lambda r: r.seconds), ("first plan", lambda r: r.first_plan)):
        values = sorted({row.value for row in rows})
        middle = [
            median(
                [pick(r) for r in rows if r.value == v and pick(r) is not None] or [float("nan")]
            )
            for v in values
        ]
        axes.plot(values, middle, marker="o", label=name)
    axes.set(xscale="log", yscale="log", xlabel=rows[0].axis, ylabel="seconds (median)")
    axes.legend()
    figure.savefig(path)
