"""A plan in words and one table, for people."""

from __future__ import annotations

import io
import math
from textwrap import shorten
from typing import TYPE_CHECKING

from tsplan.limits import is_finite
from tsplan.name_runs import Names
from tsplan.plans.bundles import Bundle
from tsplan.plans.cargo_rows import CargoRows
from tsplan.plans.outcomes import ObjectiveValue, Outcome, Status
from tsplan.plans.plan import Plan
from tsplan.plans.policy_table import policy_table
from tsplan.plans.split_history import timeline
from tsplan.plans.structure_table import alike, idle_lines, moved, rebuilt_line
from tsplan.plans.world_words import world_line
from tsplan.stopping import StoppedBy
from tsplan.words import number, visible

if TYPE_CHECKING:
    from collections.abc import Iterable, Iterator, Sequence
    from fractions import Fraction

    from rich.console import Console, RenderableType

    from tsplan.plans.satisfaction import Node

WIDTH = 120
"""Columns of a summary where there is no terminal to ask."""

MOST_PATHS = 40
"""Distinct paths that are listed; the rest is only counted."""

MOST_PARTS = 40
"""Parts of a formula that are listed with how much of them holds."""

_LONGEST = 80  # letters of a part of a formula
_LIMITS = {
    StoppedBy.TIME_LIMIT: "at the time limit",
    StoppedBy.GAP: "within the accepted gap",
    StoppedBy.INTERRUPT: "when interrupted",
    StoppedBy.MEMORY: "out of memory",
    StoppedBy.PRECISION: "at the limits of the solver's arithmetic",
    StoppedBy.WINDOW: "with the last window",
}


def print_summary(plan: Plan, console: Console) -> None:
    """Print outcome, objectives and paths of a plan."""
    print_parts(summary(plan), console)


def plan_words(plan: Plan) -> str:
    """The summary as one text, of `WIDTH` columns."""
    return text_of(summary(plan))


def text_of(parts: Iterable[RenderableType]) -> str:
    """Lines and tables as one text, of `WIDTH` columns, without a line break at its end."""
    from rich.console import Console  # noqa: PLC0415  (slow to import)

    stream = io.StringIO()
    console = Console(file=stream, width=WIDTH, color_system=None, force_jupyter=False)
    print_parts(parts, console)
    return stream.getvalue().rstrip("\n")


def print_parts(parts: Iterable[RenderableType], console: Console) -> None:
    """Print lines and tables as they are: nothing in them is read as a mark of rich."""
    for part in parts:
        if isinstance(part, str):
            console.out(part, highlight=False)
            continue
        with console.capture() as text:
            console.print(part, highlight=False, markup=False)
        for line in text.get().splitlines() or [""]:
            console.out(line.rstrip(), highlight=False)


def summary(plan: Plan) -> list[RenderableType]:
    """The lines of a plan's summary, and the table of its paths."""
    title = f"{plan.mission.name or 'mission'}: {outcome(plan)}"
    lines: list[str] = [title, *(f"  {note}" for note in plan.notes)]
    lines += [f"  {world_line(world)}" for world in plan.replanned[-_WORLDS:]]
    if plan.has_paths:
        endless = infinite_word(plan)
        lines += [f"  from step {plan.replanned[-1].step} on:"] if plan.replanned else []
        lines += [f"  {objective_line(item, endless)}" for item in plan.objective]
        if all(item.name != "availability" for item in plan.objective):
            lines.append(f"  availability {number(plan.availability, endless)}")
        lines += proof_lines(plan.objective)
        lines += [f"  {name} = {value}" for name, value in plan.variables.items()]
        lines += supply_lines(plan)
        lines += [late_line(plan.delay)] if plan.delay else []
        lines += ["", *satisfaction_lines(plan)] if plan.satisfaction or plan.preferences else []
        robots = [*_table(plan), ""] if plan.robots or plan.structures else []
        structures = [*_rebuilt(plan), ""] if plan.structures else []
        events = [*_events(plan), ""] if plan.groups else []
        policies = [*policy_table(plan), ""] if plan.policies else []
        return [*seen([*lines, ""]), *robots, *structures, *events, *policies, *_work(plan)]
    if plan.proof is not None:
        lines.append(f"  {plan.proof}{_resting(plan.rests)}")
    return [*seen(lines), *_work(plan)]


_WORLDS = 5  # the last times that a plan was made again that are told


def proof_lines(objective: Iterable[ObjectiveValue]) -> list[str]:
    """Who vouches for which of the bounds: certified, or by which solver."""
    told: dict[str, list[str]] = {}
    for item in objective:
        if item.proof is not None:
            told.setdefault(f"{item.proof}{_resting(item.rests)}", []).append(item.name)
    return [f"  bound of {', '.join(items)}: {words}" for words, items in told.items()]


def _resting(rests: Iterable[str]) -> str:
    """What a certified answer rests on beside the model of the mission."""
    words = ", ".join(rests)
    return f", resting on {words}" if words else ""


def seen(lines: Iterable[str]) -> Iterator[str]:
    """Lines as they are shown: a name with a control character acts on nothing."""
    return (visible(line) for line in lines)


def outcome(result: Outcome, noun: str = "plan") -> str:
    """What is known of a plan, or of what else was looked for, in words."""
    judged = "accepted by the independent check" if result.verified else "not checked"
    stop = "" if result.stopped_by is None else f", search ended {_LIMITS[result.stopped_by]}"
    words = {
        Status.OPTIMAL: f"optimal {noun} ({judged})",
        Status.FEASIBLE: f"{noun}, optimality open{stop} ({judged})",
        Status.INFEASIBLE: f"infeasible: it is proven that no {noun} satisfies the mission",
        Status.NO_PLAN_FOUND: f"no {noun} found{stop}; whether there is one stays open",
        Status.ERROR: f"failed{stop}",
    }
    return words[result.status]


def infinite_word(plan: Plan) -> str:
    """What an availability without a number is: nothing can fail, or nothing has to hold.

    A formula that does not hold, or of which no part is met, has no robots to spare.
    """
    satisfaction = plan.satisfaction
    whole = satisfaction is None or satisfaction.fraction == 1
    some = not plan.preferences or any(item.met for item in plan.preferences)
    return "unbounded" if whole and some else "open"


def objective_line(item: ObjectiveValue, infinite: str = "unbounded", noun: str = "plan") -> str:
    """One objective: its value, and what is proven about it; `infinite` is one without a number."""
    value = number(item.value, infinite)
    if item.value is None or not is_finite(item.value):
        return f"{item.name} {value}"
    if item.name == "risk":
        value += f", all moves succeed with probability {math.exp(-item.value):.4g}"
    if item.bound is None or not is_finite(item.bound):
        return f"{item.name} {value}"
    if math.isclose(item.value, item.bound, rel_tol=1e-9, abs_tol=1e-9):
        return f"{item.name} {value} (proven: no {noun} does better)"
    side = "at most" if item.bound > item.value else "at least"
    gap = abs(item.value - item.bound) / max(1.0, abs(item.value))
    return f"{item.name} {value} (any {noun} has {side} {number(item.bound)}; gap {gap:.1%})"


def supply_lines(plan: Plan) -> list[str]:
    """Which tasks are executed where and when, and what is carried for that."""
    lines = [
        f"  executed at {item.state} at step {item.step}: {shorten(item.task, _LONGEST)}"
        + ("" if item.given_up is None else f", given up at step {item.given_up}")
        for item in plan.executions[:MOST_PARTS]
    ]
    if rest := len(plan.executions) - len(lines):
        lines.append(f"  ... and {rest} further executions")
    loads: dict[str, float] = {}
    for row in CargoRows.of(plan.cargo).order:
        loads[row.resource] = loads.get(row.resource, 0.0) + row.names.size * row.amount
    if loads:
        told = ", ".join(f"{name} {number(amount)}" for name, amount in loads.items())
        lines.append(f"  carried along edges, summed up: {told}")
    return lines


def late_line(delay: int) -> str:
    """How late agents may be."""
    return f"  holds with every agent up to {delay} step{'' if delay == 1 else 's'} late"


def satisfaction_lines(plan: Plan) -> list[str]:
    """What holds of a mission that need not hold as a whole, and when."""
    lines = []
    if plan.satisfaction is not None:
        satisfaction = plan.satisfaction
        by = "" if satisfaction.preference is None else f", preference {satisfaction.preference}"
        lines.append(f"  satisfied: {satisfaction.fraction}{by} ({satisfaction.order})")
        if satisfaction.depths:
            counts = ", ".join(
                f"{item.value} at depth {item.depth}" for item in satisfaction.depths
            )
            lines.append(f"  by depth: {counts}")
        lines += _node_lines(satisfaction.nodes)
    for item in plan.preferences:
        gain = f"weight {number(float(item.weight))}, level {item.level}"
        by = "" if item.preference is None else f", preference {item.preference}"
        lines.append(f"  {item.name}: {_share(item.fraction)}{by} ({gain})")
        lines += _node_lines(item.nodes) if item.partial and not item.met else []
    return lines


def _node_lines(nodes: Sequence[Node]) -> list[str]:
    """The parts that hold and do not lie in one that does, and what they lie in."""
    lines: list[str] = []
    inside: int | None = None  # the depth of a part that is told as one
    for node in nodes:
        if inside is not None and node.depth > inside:
            continue
        inside = node.depth if node.met or not node.fraction or not node.counted else None
        first, last = node.steps
        when = f"step {first}" if first == last else f"steps {first}-{last}"
        other = "" if node.counted else ", another part stands for it"
        indent = "    " + "  " * node.depth
        text = shorten(node.text, _LONGEST, placeholder=" ...")
        lines.append(f"{indent}{_share(node.fraction)}: {text} ({when}{other})")
    if len(lines) > MOST_PARTS:
        rest = len(lines) - MOST_PARTS
        return [*lines[:MOST_PARTS], f"    ... and {rest:,} more parts; the JSON plan has them all"]
    return lines


def _share(fraction: Fraction) -> str:
    if fraction == 1:
        return "met"
    return f"{fraction} met" if fraction else "not met"


def path_words(bundle: Bundle) -> str:
    """A path as text: each state with its steps, `q1:0-4, q2:5`, and where it is heading.

    >>> path_words(Bundle("a", frozenset(), ((0, 4, "q1"), (5, 5, "q2")), "q3"))
    'q1:0-4, q2:5, then on the way to q3'
    >>> path_words(Bundle("a", frozenset(), ((2, 5, "q2"),), None, coming="q1"))
    'on the way from q1, q2:2-5'
    """
    if not bundle.stays:
        return f"on the way from {bundle.coming} to {bundle.heading}"
    stays = [f"on the way from {bundle.coming}"] if bundle.coming is not None else []
    stays += [
        f"{state}:{first}" if first == last else f"{state}:{first}-{last}"
        for first, last, state in bundle.stays
    ]
    if bundle.heading is not None:
        stays.append(f"then on the way to {bundle.heading}")
    return ", ".join(stays)


def names(ids: Sequence[str], most: int = 3) -> str:
    """Agents' names, with runs of numbers joined and the rest counted.

    >>> names(["a-1", "a-2", "a-3", "a-7"])
    'a-1..3, a-7'
    """
    runs = Names.of(ids).runs
    shown = [f"{run.name()}..{run.last}" if run.size > 1 else run.name() for run in runs[:most]]
    rest = sum(run.size for run in runs[most:])
    return ", ".join([*shown, *([f"{rest} more"] if rest else [])])


def _events(plan: Plan) -> list[str]:
    """How the sub-swarms of a plan split and merge."""
    lines = list(seen(timeline(plan)))
    if len(lines) <= MOST_PATHS:
        return lines
    rest = f"  ... and {len(lines) - MOST_PATHS:,} more splits and merges until the end:"
    return [*lines[: MOST_PATHS - 1], rest, lines[-1]]


def _rebuilt(plan: Plan) -> list[str]:
    """What is rebuilt in the order of time, and how many structures do nothing."""
    lines = [
        f"  {rebuilt_line(plan, each, names(each.parts), names(each.made))}"
        for each in plan.rebuilt[:MOST_PATHS]
    ]
    if rest := len(plan.rebuilt) - len(lines):
        lines.append(f"  ... and {rest:,} more reconfigurations; the JSON plan has them all")
    return list(seen([*lines, *idle_lines(plan)]))


def _rows(plan: Plan) -> Iterator[tuple[str, Bundle, int]]:
    """Every path with who is on it, and how many: agents, or structures with their modules."""
    for bundle in plan.robots:
        yield names(bundle.agents), bundle, len(bundle.agents)
    for each in alike(moved(plan)):
        yield f"{names(each.ids)} ({names(each.modules)})", each.path, len(each.ids)


def _table(plan: Plan) -> list[RenderableType]:
    from rich.table import Table  # noqa: PLC0415  (slow to import)
    from rich.text import Text  # noqa: PLC0415

    table = Table(box=None, pad_edge=False, show_edge=False, padding=(0, 1))
    table.add_column("agents", overflow="fold")
    table.add_column("class", overflow="fold")
    table.add_column("path (state:steps)", overflow="fold", ratio=1)
    rows = list(_rows(plan))
    for who, bundle, _ in rows[:MOST_PATHS]:
        cells = seen((who, bundle.class_name, path_words(bundle)))
        table.add_row(*map(Text, cells))  # as a text, no part of it is read as rich's own marks
    hidden = rows[MOST_PATHS:]
    if not hidden:
        return [table] if rows else []
    agents = sum(count for _, _, count in hidden)
    rest = f"  ... and {agents:,} agents on {len(hidden):,} more paths; the JSON plan has them all"
    return [table, rest]


def _work(plan: Plan) -> list[str]:
    """With what and how long, as far as it is known."""
    agents = sum(len(bundle.agents) for bundle in plan.robots)
    agents += sum(len(each.modules) for each in plan.structures if not each.first)
    agents += sum(group.size for group in plan.groups_at(0))
    agents += sum(round(policy.agents) for policy in plan.policies)
    return work_lines(plan, f", {agents:,} agents" if agents else "")


def work_lines(result: Outcome, more: str = "") -> list[str]:
    """Horizon, solver, model and seconds of a result; `more` is said after the horizon."""
    size, time = result.size, result.timings
    lines = [f"  horizon {result.horizon}{more}"]
    if result.solver.name:
        lines.append(
            f"  {result.solver.name} {result.solver.version}: {size.columns:,} columns "
            f"({size.integers:,} integer), {size.rows:,} rows, {size.nonzeros:,} nonzeros"
        )
    stages = [
        f"{name} {seconds:.2f}"
        for name in ("load", "parse", "reduce", "build", "solve", "extract", "verify")
        if (seconds := getattr(time, name)) >= 0.005  # noqa: PLR2004  (what two digits can show)
    ]
    inside = f" ({', '.join(stages)})" if stages else ""
    return [*lines, f"  {time.total:.2f} s{inside}"] if time.total else lines
