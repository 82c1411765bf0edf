"""The formula as it is after parts of it were withdrawn, demanded or given other deadlines."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace
from typing import TYPE_CHECKING

from tsplan.errors import Finding, FormulaError, PlanError, nearest
from tsplan.logic import And, Formula, Window, conjunction, horizon, parse_with_places
from tsplan.logic.nodes import Eventually, Switch
from tsplan.mission.formula_checks import formula_faults
from tsplan.mission.name_resolution import with_named_states

if TYPE_CHECKING:
    from tsplan.mission import Mission
    from tsplan.plans.worlds import World


def parts_of(formula: Formula) -> tuple[Formula, ...]:
    """The formulas that a formula joins by `&&`, and those that they join.

    >>> from tsplan.logic import parse
    >>> [str(part) for part in parts_of(parse("a && (b && F[0,1] c)"))]
    ['a', 'b', 'F[0,1] c']
    """
    if isinstance(formula, And) and formula.weights is None:
        return tuple(part for child in formula.children for part in parts_of(child))
    return (formula,)


def changed_formula(mission: Mission, worlds: Sequence[World]) -> Formula:
    """What has to hold of the whole trace, judged at step 0, after what some worlds say.

    Raises PlanError for parts that the mission does not have, and texts that are no formulas of it.
    """
    if not any(world.demanded or world.withdrawn or world.deadlines for world in worlds):
        return mission.formula  # grouped as it is written, which matters where it holds in part
    parts = list(parts_of(mission.formula))
    for world in worlds:
        parts = _changed(mission, parts, world)
    return conjunction(parts)


def changed_mission(mission: Mission, worlds: Sequence[World]) -> Mission:
    """The mission with what has to hold of the whole trace after what some worlds say.

    Raises PlanError as `changed_formula` does.
    """
    formula = changed_formula(mission, worlds)
    if formula is mission.formula:
        return mission
    mission = on_named_states(mission, formula)
    last = max(mission.horizon, horizon(mission.translated(formula)))
    return replace(mission, formula=formula, text="", horizon=last, origin=None)


def on_named_states(mission: Mission, formula: Formula) -> Mission:
    """The mission whose map has labels for the states that a formula names."""
    system = with_named_states(mission.system, [formula])
    return mission if system is mission.system else replace(mission, system=system)


def _changed(mission: Mission, parts: list[Formula], world: World) -> list[Formula]:
    findings: list[Finding] = []

    def read(text: str) -> Formula | None:
        try:
            return parse_with_places(text, mission.language, weights=mission.weights)[0]
        except FormulaError as error:
            findings.extend(
                replace(item, message=f"{item.message} ({text})") for item in error.findings
            )
            return None

    def place(text: str) -> int | None:
        formula = read(text)
        if formula is None or formula in parts:
            return None if formula is None else parts.index(formula)
        remedy = nearest(text, [str(part) for part in parts])
        findings.append(Finding(f"the mission has no part '{text}'", remedy))
        return None

    def demanded(text: str) -> Formula | None:
        formula = read(text)
        own = mission.system, mission.team, mission.swarm
        faults = () if formula is None else formula_faults(formula, *own)
        serious = (fault for fault in faults if fault.serious)
        findings.extend(Finding(f"{each.message} ({text})", each.remedy) for each in serious)
        return formula

    gone = {place(text) for text in world.withdrawn}
    later: dict[int, Formula] = {}
    for text, last in world.deadlines.items():
        number = place(text)
        if number is not None:
            later[number] = _with_deadline(parts[number], last, findings)
    new = [demanded(text) for text in world.demanded]
    if findings:
        raise PlanError(findings)
    kept = [later.get(n, part) for n, part in enumerate(parts) if n not in gone]
    step = world.step
    asked = [Eventually(step, step, part) if step else part for part in new if part is not None]
    return kept + asked


def _with_deadline(part: Formula, last: int, findings: list[Finding]) -> Formula:
    if not isinstance(part, Window | Switch) or part.weights is not None:
        what = f"'{part}' has no window of its own, so it has no deadline"
        findings.append(Finding(what, "withdraw it, and demand another formula"))
        return part
    if last < part.low:
        what = f"the deadline of '{part}' cannot be {last}, before its window begins"
        findings.append(Finding(what, f"write at least {part.low}"))
        return part
    return replace(part, high=last)
