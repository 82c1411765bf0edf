"""Every class of nodes has its registration in every operation, and is read and printed."""

import importlib
import inspect
import pkgutil
import sys
from fractions import Fraction

import pytest

from tsplan import logic
from tsplan.logic import Formula

A, B = logic.at_least("a"), logic.at_least("b", 2, "c")

EXAMPLES = {
    logic.Constant: (logic.TRUE, "mtl"),
    logic.Not: (~A, "mtl"),
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
    logic.Task: (logic.Task(2, "a", (("c", 1),), (("water", 2.5),)), "catl"),
    logic.Limit: (logic.limit("a", {"c": 0}), "catl"),
}


def node_classes():
    """Classes of nodes that no other class refines."""
    found, waiting = [], [Formula]
    while waiting:
        kind = waiting.pop()
        below = [sub for sub in kind.__subclasses__() if is_defined(sub)]
        waiting += below
        if not below:
            found.append(kind)
    return sorted(found, key=lambda kind: kind.__name__)


def is_defined(kind):
    """Not what a dataclass with slots was before it had them, and not made by a test."""
    return getattr(sys.modules[kind.__module__], kind.__name__, None) is kind


def operations():
    """Every single-dispatch function of the package that dispatches on nodes."""
    found = {}
    for module in pkgutil.iter_modules(logic.__path__):
        loaded = importlib.import_module(f"tsplan.logic.{module.name}")
        for name, value in vars(loaded).items():
            if hasattr(value, "registry") and value.__module__ == loaded.__name__:
                found[f"{module.name}.{name}"] = value
    return found


def missing(operation):
    default = operation.registry[object]
    return [kind.__name__ for kind in node_classes() if operation.dispatch(kind) is default]


def test_the_operations_are_found():
    assert {name.split(".")[0] for name in operations()} == {
        "catl",
        "causes",
        "evaluation",
        "fraction",
        "normal_form",
        "simplification",
        "symbols",
        "text",
        "time_horizon",
    }


@pytest.mark.parametrize("name", operations())
def test_every_class_of_nodes_is_registered(name):
    assert missing(operations()[name]) == []


@pytest.mark.parametrize("name", operations())
def test_an_operator_without_registration_is_noticed_and_named(name):
    class Forgotten(Formula):
        __slots__ = ()

    operation = operations()[name]
    others = [()] * (len(inspect.signature(operation).parameters) - 1)
    with pytest.raises(TypeError, match="registered for Forgotten"):
        operation(object.__new__(Forgotten), *others)


@pytest.mark.parametrize("kind", node_classes())
def test_every_class_of_nodes_is_printed_and_read_again(kind):
    assert kind in EXAMPLES, f"no example of {kind.__name__} is parsed in this test"
    formula, language = EXAMPLES[kind]
    assert isinstance(formula, kind)
    assert logic.parse(str(formula), language) is formula
