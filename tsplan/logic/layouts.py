"""How each class of nodes is written."""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from itertools import islice
from types import MappingProxyType

from tsplan.logic import nodes
from tsplan.logic.atoms import Count, Execution, Known, Limit, Linear, Task, begun_text
from tsplan.logic.nodes import Formula
from tsplan.logic.text import Binding, Layout, Operand, Part, layout, number_text, quoted, sum_text
from tsplan.logic.weight_values import Weights

_SIGNS: Mapping[type[Formula], str] = MappingProxyType(
    {
        nodes.Eventually: "F",
        nodes.Always: "G",
        nodes.Until: "U",
        nodes.Release: "R",
        nodes.Implies: "=>",
        nodes.Iff: "<=>",
    }
)


@layout.register
def _(node: nodes.Constant) -> Layout:
    return Layout(Binding.UNARY, ("true" if node.value else "false",))


@layout.register
def _(node: nodes.Not) -> Layout:
    return Layout(Binding.UNARY, ("!", Operand(node.child, Binding.UNARY)))


@layout.register
def _(node: nodes.Whole) -> Layout:
    """Parts and windows without weights are written as those of `all` itself."""
    child = node.child
    plain = getattr(child, "weights", None) is None
    if plain and isinstance(child, nodes.Always):
        window = f"all{_interval(child)} "
        return Layout(Binding.UNARY, (window, Operand(child.child, Binding.UNARY)))
    return _listed("all", (child if plain and isinstance(child, nodes.And) else node).children)


@layout.register
def _(node: nodes.And | nodes.Or) -> Layout:
    sign, binding = (" && ", Binding.AND) if isinstance(node, nodes.And) else (" || ", Binding.OR)
    if node.weights is not None:
        return _listed(f"{sign.strip()}{_weights(node.weights)} ", node.children)
    parts: list[Part] = []
    for child in node.children:
        parts += (sign, Operand(child, Binding(binding + 1)))
    return Layout(binding, tuple(parts[1:]))


@layout.register
def _(node: nodes.Implies | nodes.Iff | nodes.Until | nodes.Release) -> Layout:
    interval = _interval(node) if isinstance(node, nodes.Switch) else ""
    left, right = (Operand(child, Binding.UNARY) for child in node.children)
    return Layout(Binding.LOOSE, (left, f" {_SIGNS[type(node)]}{interval} ", right))


@layout.register
def _(node: nodes.Eventually | nodes.Always) -> Layout:
    sign = f"{_SIGNS[type(node)]}{_interval(node)} "
    return Layout(Binding.UNARY, (sign, Operand(node.child, Binding.UNARY)))


@layout.register
def _(node: Count) -> Layout:
    if (node.function, node.capability, node.relation, node.bound) == ("sum", None, ">=", 1):
        return _atom(quoted(node.label))
    inside = [quoted(node.label)]
    if node.capability is not None:
        inside.append(quoted(node.capability))
    return _comparison(f"{node.function}({','.join(inside)})", node.relation, str(node.bound))


@layout.register
def _(node: Linear) -> Layout:
    return _comparison(sum_text(node.terms), node.relation, number_text(node.bound))


@layout.register
def _(node: Known) -> Layout:
    return _atom(f"known({node.margin})")


@layout.register
def _(node: Task) -> Layout:
    parts = [str(node.duration), quoted(node.label), _pairs(node.needs)]
    if node.resources:
        parts.append(_pairs(node.resources))
    return _atom(begun_text(f"T({','.join(parts)})", node.begun))


@layout.register
def _(node: Execution) -> Layout:
    return _atom(f"executed {node.task}")


@layout.register
def _(node: Limit) -> Layout:
    return _atom(f"L({quoted(node.label)},{_pairs(node.needs)})")


def _listed(operator: str, children: Iterable[Formula]) -> Layout:
    parts = (part for child in children for part in (", ", Operand(child, Binding.LOOSE)))
    return Layout(Binding.UNARY, (f"{operator}(", *islice(parts, 1, None), ")"))


def _interval(node: nodes.Window | nodes.Switch) -> str:
    return f"[{node.low},{node.high}]{_weights(node.weights)}"


def _weights(weights: Weights) -> str:
    """One number where all are the same, else all of them."""
    if not weights:
        return ""
    if len(set(weights)) == 1:
        return f"^{number_text(weights[0])}"
    return f"^[{', '.join(map(number_text, weights))}]"


def _atom(text: str) -> Layout:
    return Layout(Binding.UNARY, (text,))


def _comparison(left: str, relation: str, right: str) -> Layout:
    return Layout(Binding.COMPARISON, (f"{left} {relation} {right}",))


def _pairs(pairs: tuple[tuple[str, int], ...] | tuple[tuple[str, float], ...]) -> str:
    inside = (f"({quoted(name)},{number_text(amount)})" for name, amount in pairs)
    return "{" + ",".join(inside) + "}"
