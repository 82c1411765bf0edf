"""Whether resources fit together with map, team and tasks: names, amounts, where tasks stand.

Tasks that book agents are executed as those with resources are, and may stand where these may.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Sequence
from dataclasses import dataclass

from tsplan import logic
from tsplan.errors import Nearest, nearest
from tsplan.exact import exact
from tsplan.limits import LARGEST, Range
from tsplan.logic import Formula
from tsplan.logic.text_spans import Way
from tsplan.mission.configuration_checks import Carrier
from tsplan.mission.findings import FORMULA, Fault, Place
from tsplan.mission.objectives import OBJECTIVES
from tsplan.mission.resources import Amounts, Resource
from tsplan.mission.team import Group, SwarmRules
from tsplan.ts import TransitionSystem

_AMOUNT = Range(0, LARGEST)


@dataclass(frozen=True)
class Carrying:
    """Resources, who carries them and the map, as far as they are known; whether tasks book."""

    resources: Sequence[Resource] | None
    entries: Sequence[Carrier] | None
    system: TransitionSystem | None
    books: bool = False


def resource_faults(
    carrying: Carrying, objective: Sequence[str], swarm: SwarmRules | None
) -> Iterator[Fault]:
    """What is wrong with resources, where they lie, and what robots carry of them."""
    resources, system = carrying.resources or (), carrying.system
    states = Nearest(() if system is None else system.states)
    names = [item.name for item in resources]
    for number, item in enumerate(resources):
        place: Place = ("resources", number)
        if item.name in names[:number]:
            yield Fault((*place, "name"), f"two resources are called '{item.name}'", "rename one")
        for state, _ in item.at:
            if system is not None and state not in system.states:
                what = f"the map has no state '{state}'"
                yield Fault((*place, "at", state), what, states(state))
        yield from _wrong_amounts(item.at, [item] * len(item.at), (*place, "at"))
    if resources and swarm is not None:
        what = "resources are planned for teams, and this mission has swarms"
        yield Fault(("resources",), what, "describe the agents as a team")
    for number, name in enumerate(objective):
        if name in OBJECTIVES and OBJECTIVES[name].of_amounts and not resources:
            what = f"'{name}' is about resources, and the mission has none"
            yield Fault(("objective", number), what, "add 'resources: [...]' or remove it")
    for place, group in carrying.entries or ():
        yield from _carried(group.carries, resources, (*place, "carries"))
        if isinstance(group, Group):
            yield from _begun_with(group, resources, place)


def _begun_with(group: Group, resources: Sequence[Resource], place: Place) -> Iterator[Fault]:
    """Unknown names and wrong amounts of what robots carry that start under way."""
    known = {item.name: item for item in resources}
    for start, _ in group.coming:
        path = (*place, "at", start.label)
        for name, amount in start.carrying:
            if name in known:
                yield from _wrong_amounts(((name, amount),), [known[name]], path)
            else:
                remedy = nearest(name, known) if known else "add 'resources: [...]' to the mission"
                yield Fault(path, f"there is no resource '{name}'", remedy)


def _carried(carries: object, resources: Sequence[Resource], place: Place) -> Iterator[Fault]:
    """Unknown names and amounts that nothing can be carried with."""
    if not isinstance(carries, tuple):
        if words := _AMOUNT.complaint(carries):
            yield Fault(place, words, "write how much one robot carries")
        elif not resources:
            yield Fault(place, "the mission has no resources to carry", "add 'resources: [...]'")
        return
    known = {item.name: item for item in resources}
    closest = Nearest(known)
    for name, amount in carries:
        if words := _AMOUNT.complaint(amount):
            yield Fault((*place, name), words, "write how much one robot carries")
        elif name not in known:
            yield Fault((*place, name), f"there is no resource '{name}'", closest(name))
        elif known[name].indivisible and 0 < amount < 1:
            what = f"{amount:g} of '{name}' is less than one piece, so nothing can be carried"
            yield Fault((*place, name), what, "write 1 or more, or 0 for nothing")


def _wrong_amounts(
    amounts: Amounts, resources: Iterable[Resource | None], place: Place
) -> Iterator[Fault]:
    """Amounts that are none, and parts of what comes in whole pieces."""
    for (key, amount), resource in zip(amounts, resources, strict=True):
        if words := _AMOUNT.complaint(amount):
            yield Fault((*place, key), words, "write an amount from 0")
        elif resource is not None and resource.indivisible and amount != int(amount):
            yield Fault((*place, key), *_broken(resource.name, amount))


def _broken(name: str, amount: float) -> tuple[str, str]:
    what = f"'{name}' comes in whole pieces, and {amount:g} is no whole number"
    return what, "write a whole number, or remove 'indivisible: true'"


def spending_faults(formula: Formula, carrying: Carrying, *, whole: bool) -> Iterator[Fault]:
    """Tasks whose resources nobody knows or has, and tasks with resources out of place.

    They may be named where the formula holds as a `whole`, and under no negation; so may all tasks
    that book agents.
    """
    for node in logic.walk(formula):
        if isinstance(node, logic.Task) and (node.resources or carrying.books):
            yield from _spent(node, carrying)
            yield from _uncarried(node, carrying)
            if not whole:
                has = "needs resources" if node.resources else "books agents"
                what = f"'{node}' {has}, and what holds in part is planned without any"
                yield Fault(FORMULA, what, "let it be what must hold as a whole", node=node)
    for node in _negated(formula, books=carrying.books):
        kind, less = "with resources", "remove its resources"
        if not node.resources:
            kind, less = "that books agents", "write 'booking: shared'"
        what = f"'{node}' is under a negation: a task {kind} is executed or not, never shunned"
        yield Fault(FORMULA, what, f"{less}, or remove the negation", node=node)


def _spent(node: logic.Task, carrying: Carrying) -> Iterator[Fault]:
    """Unknown resources of a task, parts of whole pieces, and more than there is (a warning)."""
    resources, system = carrying.resources, carrying.system
    if resources is None:
        return
    sites = 1 if system is None else len(system.labels.get(node.label, (node.label,)))
    known = {item.name: item for item in resources}
    closest = Nearest(known)
    for number, (name, amount) in enumerate(node.resources):
        if name not in known:
            what = f"there is no resource '{name}'"
            remedy = closest(name) if known else "add 'resources: [...]' to the mission"
            yield Fault(FORMULA, what, remedy, node=node, way=("resources", number, 0))
        elif known[name].indivisible and amount != int(amount):
            what, remedy = _broken(name, amount)
            yield Fault(FORMULA, what, remedy, node=node, way=("resources", number, 1))
        elif exact(amount) * sites > known[name].total:
            total = float(known[name].total)
            what = f"{amount * sites:g} of '{name}' are needed, and there are {total:g}"
            remedy = "the task can never be executed; ask for less"
            way: Way = ("resources", number, 1)
            yield Fault(FORMULA, what, remedy, serious=False, node=node, way=way)


def _uncarried(node: logic.Task, carrying: Carrying) -> Iterator[Fault]:
    """Resources that lie elsewhere and that no robot carries (warnings)."""
    resources, entries, system = carrying.resources, carrying.entries, carrying.system
    if resources is None or entries is None or system is None:
        return
    known = {item.name: _known_at(item) for item in resources}
    for number, (name, amount) in enumerate(node.resources):
        lying = known.get(name)
        sites = system.labels.get(node.label, (node.label,))
        there = lying is None or all(lying.get(state, 0.0) >= amount for state in sites)
        if not there and _nobody(name, entries):
            what = f"no robot carries '{name}', and it lies elsewhere"
            remedy = f"the task can never be executed; give a class 'carries: {{{name}: 1}}'"
            way: Way = ("resources", number, 0)
            yield Fault(FORMULA, what, remedy, serious=False, node=node, way=way)


def _known_at(resource: Resource) -> dict[str, float]:
    """What lies or is brought where, sooner or later."""
    found: dict[str, float] = {}
    for state, _, amount in resource.sources:
        found[state] = found.get(state, 0.0) + amount
    return found


def _nobody(name: str, entries: Sequence[Carrier]) -> bool:
    """Whether no robot carries any of a resource."""
    return not any(
        dict(group.carries).get(name) if isinstance(group.carries, tuple) else group.carries
        for _, group in entries
    )


def _negated(formula: Formula, *, books: bool) -> list[logic.Task]:
    """The tasks that are executed and stand under an odd number of negations somewhere."""
    found: dict[logic.Task, None] = {}
    seen: set[tuple[Formula, bool]] = set()
    waiting = [(formula, True)]
    while waiting:
        node, positive = waiting.pop()
        if (node, positive) in seen:
            continue
        seen.add((node, positive))
        if isinstance(node, logic.Task) and (node.resources or books) and not positive:
            found[node] = None
        for number, child in enumerate(node.children):
            turned = isinstance(node, logic.Not) or (isinstance(node, logic.Implies) and not number)
            waiting.append((child, positive is not turned))
            if isinstance(node, logic.Iff):
                waiting.append((child, not positive))
    return list(found)
