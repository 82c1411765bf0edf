"""Missions as files: what is written is read as the same mission.

The entries of a file are made here for missions from Python values, too (`mission.values`).
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator, Mapping
from dataclasses import asdict
from fractions import Fraction
from functools import partial
from pathlib import Path
from typing import Any

from tsplan.document.files import write_whole
from tsplan.document.flow_style import flow, word
from tsplan.errors import Finding, FormulaError, MissionError
from tsplan.logic import Formula, Percent, parse_with_places
from tsplan.logic.weight_values import Weight
from tsplan.milp.solver_choice import SolverChoice
from tsplan.mission.amount_entries import amounts_entry, carries_entry
from tsplan.mission.mission_parts import MissionParts, Preference
from tsplan.mission.module_entries import module_entries
from tsplan.mission.resources import Resource
from tsplan.mission.start_entries import starts_entry
from tsplan.mission.team import ONE_SWARM, Group, SwarmRules
from tsplan.mission.vocabulary import FORMAT, Language
from tsplan.mission.weight_entries import entries_of
from tsplan.ts.io.map_files import save_map
from tsplan.ts.io.tsplan_yaml import map_to_yaml

_FINEST = 15  # digits after the point of a percentage that a file may have


def mission_to_yaml(mission: MissionParts, map_file: str | None = None) -> str:
    """The text of a mission file; the map stands in it, or is the file that is named."""
    return "".join(f"{line}\n" for line in _lines(mission, map_file))


def save_mission(mission: MissionParts, path: Path, map_file: str | None = None) -> None:
    """Write a mission to a file, and its map to a file beside it if one is named."""
    text = mission_to_yaml(mission, map_file)
    if map_file is not None:
        save_map(mission.system, path.parent / map_file)
    write_whole(path, text.encode(), MissionError)


def _lines(mission: MissionParts, map_file: str | None) -> Iterator[str]:
    yield f"format: {FORMAT}"
    if mission.name:
        yield f"name: {word(mission.name)}"
    if map_file is None:
        yield "map:"
        yield from (f"  {line}" for line in map_to_yaml(mission.system).splitlines())
    else:
        yield f"map: {word(map_file)}"
    if mission.resources:
        yield "resources:"
        yield from (f"  - {flow(resource_entry(item))}" for item in mission.resources)
    for key, entry in module_entries(mission.modular).items():
        yield f"{key}:"
        lines = entry.items() if isinstance(entry, dict) else (("-", item) for item in entry)
        yield from (
            f"  - {flow(item)}" if name == "-" else f"  {word(name)}: {flow(item)}"
            for name, item in lines
        )
    yield from _team_lines(mission)
    read = partial(read_formula, language=mission.language, weights=mission.weights)
    yield from spec_lines(mission.language, (mission.formula, mission.text), mission.prefer, read)
    if weights := _named_weights(mission):
        yield f"  weights: {flow(weights)}"
    aims = [
        {name: mission.satisfaction} if name == "satisfaction" else name
        for name in mission.objective
    ]
    yield f"objective: {flow(aims)}"
    if mission.delay:
        yield f"delay: {mission.delay}"
    if mission.books:
        yield f"booking: {mission.booking}"
    if mission.task_interval != "closed":
        yield f"task_interval: {mission.task_interval}"
    yield f"horizon: {mission.horizon}"
    yield from _expected_lines(mission)
    if solver := solver_entry(mission.solver):
        yield f"solver: {flow(solver)}"


def _expected_lines(mission: MissionParts) -> Iterator[str]:
    """What is asked of policies."""
    if mission.expected is None:
        return
    yield "dynamics: expected"
    if mission.expected.deterministic:
        yield "policy: deterministic"
    if mission.expected.margin:
        yield f"margin: {margin_text(mission.expected.margin)}"


def read_formula(text: str, language: Language, weights: Mapping[str, Weight]) -> Formula:
    """The formula of one of several texts that share their weights."""
    return parse_with_places(text, language, weights=weights)[0]


def _named_weights(mission: MissionParts) -> dict[str, Any]:
    """The weights that the texts of formulas name, as far as these are written as they are."""
    names: set[str] = set()
    for soft in (Preference(mission.formula, mission.text), *mission.prefer):
        try:
            read, written = parse_with_places(soft.text, mission.language, weights=mission.weights)
        except FormulaError:
            continue  # its own print is written, which names none
        names |= written.weight_names if read is soft.formula else set()
    return entries_of({name: mission.weights[name] for name in sorted(names)})[0]


def spec_lines(
    language: str,
    must: tuple[Formula, str],
    prefer: Iterable[Preference],
    read: Callable[[str], Formula],
) -> Iterator[str]:
    """What has to hold, with its text, and what is preferred; `read` reads such texts."""
    wishes = [
        f"    - {flow(preference_entry(soft, written_formula(soft.formula, soft.text, read)))}"
        for soft in prefer
    ]
    yield "spec:"
    yield f"  language: {language}"
    yield f"  {'must' if wishes else 'formula'}: {_scalar(written_formula(*must, read))}"
    if wishes:
        yield "  prefer:"
        yield from wishes


def _team_lines(mission: MissionParts) -> Iterator[str]:
    """The robots, and the swarms with what bounds them."""
    rules = mission.swarm
    swarms = [group for group in mission.team if mission.group_bounds(group.class_name)]
    robots = [group for group in mission.team if not mission.group_bounds(group.class_name)]
    if robots:
        yield "team:"
        yield from (f"  - {flow(group_entry(group))}" for group in robots)
    if rules is None:
        return
    if len(swarms) == 1 and ONE_SWARM == swarms[0].class_name not in swarms[0].capabilities:
        entry = swarm_entry(swarms[0], rules)
        if rules.together is not None:  # it bounds this one
            entry["max_subswarms"] = min(rules.together, entry.get("max_subswarms", rules.together))
        yield f"swarm: {flow(entry)}"
    else:
        yield "swarms:"
        for swarm in swarms:
            yield f"  - {flow({'name': swarm.class_name, **swarm_entry(swarm, rules)})}"
        if rules.together is not None:
            yield f"max_subswarms: {rules.together}"
    if rules.margin:
        yield f"margin: {margin_text(rules.margin)}"


def group_entry(group: Group) -> dict[str, Any]:
    """The entry of a group of robots."""
    starts: dict[str, Any] = {"at": starts_entry(group)}
    if len(group.starts) == 1 and not group.coming:
        ((state, count),) = group.starts
        starts = {"count": count, "at": state}
    able = {"capabilities": sorted(group.capabilities)} if group.capabilities else {}
    shape = {} if group.configuration is None else {"configuration": group.configuration}
    carries = carries_entry(group.carries)
    return {"class": group.class_name, **starts, **able, **carries, **shape}


def resource_entry(resource: Resource) -> dict[str, Any]:
    """The entry of a resource."""
    entry: dict[str, Any] = {"name": resource.name, "at": amounts_entry(resource.at)}
    if resource.indivisible:
        entry["indivisible"] = True
    return entry if resource.consumed else {**entry, "consumed": False}


def swarm_entry(swarm: Group, rules: SwarmRules) -> dict[str, Any]:
    """The entry of a swarm but for its name, which is one of its capabilities anyway."""
    bounds = rules.each[swarm.class_name]
    entry: dict[str, Any] = {"size": swarm.count, "at": starts_entry(swarm)}
    if bounds.most is not None:
        entry["max_subswarms"] = bounds.most
    if bounds.least > 1:
        entry["min_subswarm"] = bounds.least
    able = sorted(swarm.capabilities - {swarm.class_name})
    return {**entry, "capabilities": able} if able else entry


def preference_entry(soft: Preference, text: str) -> dict[str, Any]:
    """The entry of a formula that is preferred, whose text is given."""
    weight = float(soft.weight)
    if Fraction(str(weight)) != soft.weight:
        what = f"the weight {soft.weight} of '{soft.name}' has no end as a decimal number"
        raise MissionError([Finding(what, "choose a weight of at most 15 digits")])
    return {
        "formula": text,
        "name": soft.name,
        "weight": weight,
        "level": soft.level,
        "partial": soft.partial,
    }


def solver_entry(solver: SolverChoice) -> dict[str, Any]:
    """What is asked of the solver."""
    return {key: value for key, value in asdict(solver).items() if value is not None}


def margin_text(margin: Fraction | int) -> str:
    """A margin: a number of agents, or an exact percentage."""
    if isinstance(margin, int):
        return str(margin)
    try:
        text = str(Percent(100 * margin))
    except ValueError:
        text = ""
    if not text or len(text.rstrip("%").partition(".")[2]) > _FINEST:
        what = f"the margin {margin} is no percentage of {_FINEST} digits after the point"
        raise MissionError([Finding(what, "round it up")])
    return text


def written_formula(formula: Formula, text: str, read: Callable[[str], Formula]) -> str:
    """A text that is read as the formula: the one it has, or else its own print."""
    try:
        if read(text) is formula:
            return text
    except FormulaError:
        pass
    printed = str(formula)
    read(printed)  # a task, for example, cannot be written in another language
    return printed


def _scalar(text: str) -> str:
    """A formula as a block of lines if that is easier to read, else in quotes if it needs any."""
    lines = text.split("\n")
    plain = text == text.strip() and all(line.isprintable() for line in lines)
    if plain and (len(lines) > 1 or '"' in text or "\\" in text):
        return "\n".join(["|-", *(f"    {line}" for line in lines)])
    return word(text)
