"""Every class of nodes has everything that is asked of one, from its parser to its explanation.

Operations that dispatch on the class of a node are found by themselves, wherever they are. For
those that do not, every class has a sample here: a mission that it is planned in, and one without
a plan, which is explained. A new class fails by the name of what it lacks.
"""

from __future__ import annotations

import functools
import importlib
import inspect
import pkgutil
import sys
from collections.abc import Callable, Mapping
from dataclasses import dataclass
from fractions import Fraction
from types import ModuleType
from typing import Any

import pytest

import tsplan
from tsplan import logic
from tsplan.encode.atom_encoders import Atoms
from tsplan.encode.preparation import prepare
from tsplan.explanation import explain
from tsplan.logic import Formula, walk
from tsplan.mission import Mission, mission_from_text

A, B = logic.at_least("a"), logic.at_least("b", 2, "c")

EXAMPLES = {
    logic.Constant: (logic.TRUE, "mtl"),
    logic.Not: (~A, "mtl"),
    logic.Whole: (logic.Whole(A & B), "mtl"),
    logic.And: (A & B, "mtl"),
    logic.Or: (A | B, "mtl"),
    logic.Implies: (A >> B, "mtl"),
    logic.Iff: (A.iff(B), "mtl"),
    logic.Eventually: (A.eventually(1, 2), "mtl"),
    logic.Always: (A.always(0, 2), "mtl"),
    logic.Until: (A.until(B, 1, 2), "mtl"),
    logic.Release: (A.release(B, 0, 2), "mtl"),
    logic.Count: (logic.Count("min", "a", "c", "<", logic.Percent(Fraction(25, 2))), "mtl"),
    logic.Linear: (logic.linear({"x": 2, "y": -0.5}, "!=", -3), "stl"),
    logic.Known: (logic.Known(-3), "mtl"),
    logic.Task: (logic.Task(2, "a", (("c", 1),), (("water", 2.5),)), "catl"),
    logic.Limit: (logic.limit("a", {"c": 0}), "catl"),
}


@dataclass(frozen=True)
class Sample:
    """A formula that a plan exists for, one that none does for, and what can be edited in that."""

    holds: str
    fails: str
    edits: frozenset[str] = frozenset()
    language: str = "mtl"


# two agents with c start at p (labelled a); from there it takes three steps to r (labelled b)
TEXT = """\
format: tsplan-mission/1
name: sample
map:
  waiting: true
  states: {p: {labels: [a]}, q: {}, r: {labels: [b]}}
  edges: [{from: p, to: q, duration: 2, both_ways: true}, [q, r, 1], [r, q, 1]]
team: [{class: k, count: 2, at: p, capabilities: [c]}]
spec:
  language: LANGUAGE
  formula: 'FORMULA'
"""
NEED, LATER = frozenset({"lower_need"}), frozenset({"extend_deadline", "lower_need"})
SAMPLES = {
    logic.Constant: Sample("true", "false"),
    logic.Not: Sample("!(F[0,1] b)", "!(F[0,1] a)"),
    logic.Whole: Sample("F[0,3] all(a, b)", "F[0,2] all(a, sum(b) >= 2)", NEED),
    logic.And: Sample("F[0,3] (a && b)", "F[0,2] (a && sum(b) >= 2)", NEED),
    logic.Or: Sample("G[1,2] (b || a)", "G[1,2] (b || sum(a) >= 3)", NEED),
    logic.Implies: Sample("a => F[0,3] b", "a => F[0,1] b"),
    logic.Iff: Sample("a <=> F[0,3] b", "a <=> F[0,1] b"),
    logic.Eventually: Sample("F[0,3] b", "F[0,2] b", LATER),
    logic.Always: Sample("G[3,5] b", "G[1,5] b", NEED),
    logic.Until: Sample("a U[1,3] b", "a U[1,2] b", LATER),
    logic.Release: Sample("b R[0,4] a", "b R[0,4] (sum(a) >= 3)", NEED),
    logic.Count: Sample("F[0,9] sum(b,c) >= 2", "F[0,9] sum(b,c) >= 3", NEED),
    logic.Known: Sample("known(0) && F[0,3] b", "known(-1)"),
    logic.Task: Sample("F[0,4] T(2, b, {(c, 2)})", "F[0,4] T(2, b, {(c, 3)})", NEED, "catl"),
    logic.Limit: Sample(
        "G[1,4] L(a, {(c, 1)})", "G[0,1] L(a, {(c, 1)})", frozenset({"loosen_limit"}), "catl"
    ),
}
# what operations of some modules do not know: atoms are left to the encoders of their classes, and
# a release is rewritten for fractions
LEFT = {
    "reference": {logic.Count, logic.Known},
    "witness": {logic.Count, logic.Known},
    "fraction_terms": {logic.Release},
}
# what tables do not hold: steps are told of operators that look ahead, and signs stand between two
TABLES_LEAVE = {
    "_RESTS": {logic.And, logic.Or, logic.Not, logic.Whole, logic.Implies, logic.Iff},
    "_SIGNS": {logic.And, logic.Or, logic.Whole},
}
OF_TASKS = {logic.Execution}  # is what tasks with resources translate to, and is not written
OF_SIGNALS = {logic.Linear}  # are judged on traces, and no mission has them


def mission(text: str, language: str) -> Mission:
    return mission_from_text(TEXT.replace("LANGUAGE", language).replace("FORMULA", text))


def node_classes() -> list[type[Formula]]:
    """Classes of nodes that no other class refines."""
    found, waiting = [], [Formula]
    while waiting:
        kind = waiting.pop()
        below = [sub for sub in kind.__subclasses__() if is_defined(sub)]
        waiting += below
        if not below:
            found.append(kind)
    return sorted(found, key=lambda kind: kind.__name__)


def is_defined(kind: type) -> bool:
    """Not what a dataclass with slots was before it had them, and not made by a test."""
    return getattr(sys.modules[kind.__module__], kind.__name__, None) is kind


def encoded_classes() -> set[type[Formula]]:
    """Classes that the formulas of samples have when they are encoded."""
    goals = [mission(s.holds, s.language).goal for s in SAMPLES.values()]
    goals += [mission(s.fails, s.language).goal for s in SAMPLES.values()]
    return {type(node) for goal in goals for node in walk(goal)}


@dataclass(frozen=True)
class Operation:
    """Something that dispatches on the class of a node: a function, or a method of a class."""

    file: str
    name: str
    registry: Callable[[type], Callable[..., object]]
    call: Callable[[Formula], object]

    @property
    def of_all(self) -> bool:
        """Whether it has to know all that can be written, or only what is encoded."""
        return self.file.startswith("tsplan.logic.")

    def needed(self) -> list[type[Formula]]:
        """Classes it has to know."""
        if self.of_all:
            return node_classes()
        return sorted(encoded_classes() - LEFT.get(base(self.file), set()), key=str)

    def missing(self, kinds: list[type[Formula]]) -> list[str]:
        default = self.registry(object)
        return [kind.__name__ for kind in kinds if self.registry(kind) is default]


def tables() -> dict[str, tuple[str, set[type[Formula]]]]:
    """Every table of the package by classes of operators: its module, and what it knows."""
    return {
        f"{loaded.__name__}.{name}": (loaded.__name__, set(value))
        for loaded in modules()
        for name, value in vars(loaded).items()
        if isinstance(value, Mapping) and value and all(map(is_node_class, value))
        if any(kind in EXAMPLES and EXAMPLES[kind][0].children for kind in value)
    }


def operators(name: str, file: str) -> set[type[Formula]]:
    """Operators that a table has to know: those that it can meet."""
    shown = file.startswith(("tsplan.explanation.", "tsplan.viewer."))
    met = set(node_classes()) if shown else encoded_classes()
    left = TABLES_LEAVE.get(base(name), set())
    return {kind for kind in met - OF_TASKS if EXAMPLES[kind][0].children} - left


def base(file: str) -> str:
    """The last part of a name."""
    return file.rsplit(".", maxsplit=1)[-1]


def modules() -> list[ModuleType]:
    """The modules of the package, but for what is generated."""
    return [
        importlib.import_module(module.name)
        for module in pkgutil.walk_packages(tsplan.__path__, "tsplan.")
        if "generated" not in module.name and not module.name.endswith("__main__")
    ]


def is_node_class(value: object) -> bool:
    return inspect.isclass(value) and issubclass(value, Formula)


def operations() -> dict[str, Operation]:
    """Every operation of the package that dispatches on nodes."""
    found = {}
    for loaded in modules():
        for place in [loaded, *filter(inspect.isclass, vars(loaded).values())]:
            for name, value in [*vars(place).items()]:  # looking builds schemas of pydantic
                made = operation(place, name, value)
                if made is not None and made.file == loaded.__name__:
                    found[made.name] = made
    return found


def operation(place: Any, name: str, value: Any) -> Operation | None:
    """A value of a module or class as an operation, if it dispatches on nodes."""
    method = isinstance(value, functools.singledispatchmethod)
    dispatcher = value.dispatcher if method else value
    kinds = getattr(dispatcher, "registry", {})
    if not any(map(is_node_class, kinds)):
        return None

    def call(node: Formula) -> object:
        others = [()] * (len(inspect.signature(kinds[object]).parameters) - 1 - method)
        if method:
            encoder = object.__new__(place)
            encoder._atoms = Atoms({}, 0)  # what is no operator is looked for among the atoms
            return getattr(encoder, name)(node, *others)
        return value(node, *others)

    file = str(place.__module__ if method else value.__module__)
    owner = f"{file}.{place.__name__}" if method else file
    return Operation(file, f"{owner}.{name}", dispatcher.dispatch, call)


OPERATIONS = operations()
TABLES = tables()


def forgotten() -> type[Formula]:
    class Forgotten(Formula):
        __slots__ = ()

    return Forgotten


def test_the_operations_are_found():
    files = [item.file for item in OPERATIONS.values()]
    assert {file.split(".")[-1] for file in files if file.startswith("tsplan.logic.")} == {
        "catl",
        "causes",
        "evaluation",
        "fraction",
        "normal_form",
        "progression",
        "simplification",
        "symbols",
        "text",
        "time_horizon",
    }
    # the witness, the reference and the partial encoding; risks and words
    assert sum(file.startswith("tsplan.encode.") for file in files) >= 3
    assert len(TABLES) >= 3
    assert set(LEFT) <= set(map(base, files)), "a name that LEFT has is gone"
    assert set(TABLES_LEAVE) <= set(map(base, TABLES)), "a name that TABLES_LEAVE has is gone"


@pytest.mark.parametrize("name", OPERATIONS)
def test_every_class_of_nodes_is_registered(name):
    found = OPERATIONS[name]
    assert found.missing(found.needed()) == [], f"register these for {name}"


@pytest.mark.parametrize("name", TABLES)
def test_every_operator_is_in_the_tables_of_operators(name):
    file, known = TABLES[name]
    assert {kind.__name__ for kind in operators(name, file) - known} == set(), (
        f"add these to {name}"
    )


def test_every_atom_that_is_encoded_has_an_encoder():
    for sample in SAMPLES.values():
        setting = prepare(mission(sample.fails, sample.language))
        leaves = [node for node in walk(setting.goal) if not node.children]
        atoms = setting.atoms(setting.unrolled())
        assert all(node in atoms for node in leaves if not isinstance(node, logic.Constant))


@pytest.mark.parametrize("name", OPERATIONS)
def test_a_class_without_registration_is_noticed_and_named(name):
    kind = forgotten()
    assert OPERATIONS[name].missing([kind]) == ["Forgotten"]
    with pytest.raises(TypeError, match="Forgotten"):
        OPERATIONS[name].call(object.__new__(kind))


def test_every_class_has_an_example_and_a_sample():
    kinds = set(node_classes()) - OF_TASKS
    assert kinds - set(EXAMPLES) == set(), "say how these are parsed"
    assert kinds - set(SAMPLES) - OF_SIGNALS == set(), "say how these are planned and explained"
    assert encoded_classes() >= {logic.And, logic.Or, logic.Until, logic.Release, logic.Count}


@pytest.mark.parametrize("kind", EXAMPLES, ids=lambda kind: kind.__name__)
def test_it_is_printed_and_read_again(kind):
    formula, language = EXAMPLES[kind]
    assert isinstance(formula, kind)
    assert logic.parse(str(formula), language) is formula


@pytest.mark.parametrize("kind", SAMPLES, ids=lambda kind: kind.__name__)
def test_it_is_planned_alike_by_both_encodings_and_in_part(kind):
    sample = SAMPLES[kind]
    made = mission(sample.holds, sample.language)
    assert any(isinstance(node, kind) for node in walk(made.formula))
    plans = [tsplan.plan(made, encoding=name) for name in ("tight", "reference")]
    assert [plan.status for plan in plans] == ["optimal", "optimal"]
    assert plans[0].objective == plans[1].objective
    for text, share in ((sample.holds, 1), (sample.fails, None)):
        soft = tsplan.Mission.of(
            map=made.system,
            team=made.team,
            formula=text,
            language=sample.language,
            objective=[{"satisfaction": "weighted"}],
        )
        plan = tsplan.plan(soft)
        assert plan.status == "optimal"
        assert plan.satisfaction.fraction == 1 if share else plan.satisfaction.fraction < 1


@pytest.mark.parametrize("kind", SAMPLES, ids=lambda kind: kind.__name__)
def test_why_it_holds_is_said_in_words(kind):
    sample = SAMPLES[kind]
    made = mission(sample.holds, sample.language)
    tree = tsplan.plan(made).explain(made)
    assert tree.holds
    assert len(str(tree).splitlines()) >= len(set(walk(made.formula)))


@pytest.mark.parametrize("kind", SAMPLES, ids=lambda kind: kind.__name__)
def test_why_it_cannot_hold_is_said_at_its_place_and_with_its_edits(kind):
    sample = SAMPLES[kind]
    made = mission(sample.fails, sample.language)
    assert any(isinstance(node, kind) for node in walk(made.formula))
    found = explain(made)
    assert found.status == "explained"
    assert found.conflicts
    lines = made.origin.content.splitlines()
    for conflict in found.conflicts:
        parts = [part for part in conflict.parts if part.kind == "formula"]
        assert parts, f"no element of the formula for {kind.__name__}"
        for part in parts:
            at = part.place
            said = lines[at.line - 1][at.column - 1 : at.end_column - 1]
            assert part.text.split(" in ")[0] == said
    kinds = {change.kind for change in found.changes}
    assert kinds & (NEED | LATER | {"loosen_limit", "shorten_task"}) == sample.edits
