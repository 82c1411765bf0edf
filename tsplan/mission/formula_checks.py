"""Whether formulas fit map, team and horizon: labels, names, kinds of atoms, how far they look."""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from dataclasses import dataclass
from itertools import islice

from tsplan import logic
from tsplan.errors import FormulaError, Nearest
from tsplan.limits import MOST_STEPS
from tsplan.logic import Formula
from tsplan.logic.text_spans import Way
from tsplan.mission.findings import FORMULA, Fault
from tsplan.mission.team import ONE_SWARM, Group, SwarmRules
from tsplan.mission.vocabulary import Order, TaskInterval
from tsplan.ts import TransitionSystem


def formula_faults(
    formula: Formula,
    system: TransitionSystem | None,
    team: Iterable[Group] | None,
    swarm: SwarmRules | None,
) -> Iterator[Fault]:
    """Labels, capabilities and kinds of atoms, as far as map and team are known."""
    places = Nearest(() if system is None else {*system.labels, *system.states})
    names = None if team is None else _Names.of(team, swarm)
    for node in logic.walk(formula):
        yield from _refused(node)
        if isinstance(node, logic.Count | logic.Task | logic.Limit):
            if system is not None:
                yield from _unplaced(node, node.label, system, places)
            if names is not None:
                yield from names.faults(node)


def _unplaced(
    node: Formula, label: str, system: TransitionSystem, closest: Nearest
) -> Iterator[Fault]:
    """A label of no state, or (a warning) one that is the name of a state without it."""
    way: Way = ("label",)
    state = system.states.get(label)
    if label not in system.labels and state is None:
        what = f"no state of the map has the label '{label}'"
        yield Fault(FORMULA, what, closest(label), node=node, way=way)
    elif state is not None and label in system.labels and label not in state.labels:
        carriers = ", ".join(system.labels[label][:3])
        what = f"'{label}' is the label of {carriers}, and also the name of a state without it"
        remedy = "the label is meant; give the state a label of its own to count there"
        yield Fault(FORMULA, what, remedy, serious=False, node=node, way=way)


@dataclass(frozen=True)
class _Names:
    """What atoms may name: capabilities, and the classes of robots and swarms."""

    capabilities: frozenset[str]
    classes: dict[str, frozenset[str]]  # with their capabilities
    swarms: frozenset[str]
    closest: Nearest

    @classmethod
    def of(cls, team: Iterable[Group], swarm: SwarmRules | None) -> _Names:
        classes: dict[str, frozenset[str]] = {}
        for group in team:
            able = classes.get(group.class_name, frozenset())
            classes[group.class_name] = able | group.capabilities
        known: frozenset[str] = frozenset().union(*classes.values())
        swarms = frozenset(() if swarm is None else swarm.each)
        return cls(known, classes, swarms, Nearest(known.union(classes)))

    def faults(self, node: Formula) -> Iterator[Fault]:
        """The names in an atom that nobody has, those of two meanings, shares of no swarm."""
        percent = isinstance(node, logic.Count) and isinstance(node.bound, logic.Percent)
        if percent and not self.swarms:
            what = f"'{node}' asks for a percentage, which only a swarm has"
            yield Fault(FORMULA, what, "write the number of robots", node=node)
        for way, name in _capabilities(node):
            if name not in self.classes.get(name, self.capabilities):
                yield self._stranger(node, way, name)

    def _stranger(self, node: Formula, way: Way, name: str) -> Fault:
        """A capability that nobody has, or (a warning) one that is the name of other robots."""
        serious = False
        what = f"no robot has the capability '{name}', so it always counts 0"
        remedy = self.closest(name)
        if name in self.capabilities:
            what = f"'{name}' is a capability, and also the name of a class without it"
            remedy = "the capability is meant; call the class something else to count it"
        elif self.classes and self.classes.keys() <= self.swarms:
            serious, what = True, f"there is no swarm '{name}'"
            if self.swarms == {ONE_SWARM}:
                remedy = f"leave '{name}' out: the one swarm has no name"
        return Fault(FORMULA, what, remedy, serious=serious, node=node, way=way)


def _capabilities(node: Formula) -> list[tuple[Way, str]]:
    """The capabilities that an atom itself names, in order, and where."""
    if isinstance(node, logic.Task | logic.Limit):
        return [(("needs", number, 0), name) for number, (name, _) in enumerate(node.needs)]
    if isinstance(node, logic.Count) and node.capability is not None:
        return [(("capability",), node.capability)]
    return []


def _refused(node: Formula) -> Iterator[Fault]:
    """Atoms that have a meaning elsewhere but not for a team."""
    if isinstance(node, logic.Linear):
        what = f"'{node}' speaks about signals, and a team has only counts of robots"
        remedy = "write what is to be counted, for example sum(A) >= 2 for a label A"
        yield Fault(FORMULA, what, remedy, node=node)


def weight_faults(formula: Formula, order: Order | None) -> Iterator[Fault]:
    """Weights where they do not count: they weigh what holds in part.

    `order` is that in which the formula may hold in part, None where it holds or does not.
    """
    if order == "weighted":
        return
    weighed = (node for node in logic.walk(formula) if getattr(node, "weights", None) is not None)
    for node in islice(weighed, 1):
        if order is None:
            what = "weights have no effect on a formula that must hold as a whole"
            other = ", or prefer it with 'partial: true'"
        else:
            what, other = f"weights have no effect in the order '{order}'", ""
        remedy = f"ask for satisfaction: 'objective: [{{satisfaction: weighted}}]'{other}"
        yield Fault(FORMULA, what, remedy, node=node, way=("weight",))


def horizon_faults(
    formula: Formula, task_interval: TaskInterval, horizon: int | None
) -> Iterator[Fault]:
    """Tasks without a meaning in this interval, or a horizon that is too short or too long."""
    empty = _empty_tasks(formula, task_interval)
    own = None if empty else formula_horizon(formula, task_interval)
    yield from empty
    if own is None:
        return
    steps = max(own, horizon or 0)
    if steps > MOST_STEPS:
        path = FORMULA if own > MOST_STEPS else ("horizon",)
        yield Fault(path, f"a horizon of {steps:,} steps", f"at most {MOST_STEPS:,} are planned")
    elif horizon is not None and horizon < own:
        what = f"the horizon {horizon} is shorter than the formula's, {own}"
        yield Fault(("horizon",), what, f"set it to at least {own} or leave it out")


def _empty_tasks(formula: Formula, task_interval: TaskInterval) -> list[Fault]:
    """Tasks that hold over no step at all."""
    remedy = "give the task a duration of at least 1"
    return [
        Fault(FORMULA, f"'{node}' is empty when tasks are half-open", remedy, node=node)
        for node in (logic.walk(formula) if task_interval == "half-open" else ())
        if isinstance(node, logic.Task) and not node.left
    ]


def formula_horizon(formula: Formula, task_interval: TaskInterval) -> int | None:
    """The last step the formula speaks about; None where it has no meaning over counts."""
    try:
        return logic.horizon(logic.translate(formula, interval=task_interval))
    except FormulaError:
        return None  # `formula_faults` names what cannot be translated
