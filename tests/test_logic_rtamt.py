"""An optional job: robustness against an independent monitor, rtamt, in discrete time.

rtamt 0.3 needs an older ANTLR runtime than tsplan's parser, so the two share an environment only
for this: build one with `pip install rtamt antlr4-python3-runtime==4.7.2 numpy hypothesis pytest`
and run `python -m pytest -m rtamt tests/test_logic_rtamt.py` there. Formulas are drawn as nodes;
nothing is parsed by tsplan.
"""

import contextlib
import io
from functools import reduce

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from tests.seeds import seeds
from tsplan import logic
from tsplan.testing.formula_strategies import trace_for

pytestmark = pytest.mark.rtamt

SIGNS = {">=": ">=", "<=": "<=", ">": ">", "<": "<", "=": "==", "!=": "!=="}


@pytest.fixture(scope="module")
def monitor():
    try:
        import rtamt  # noqa: PLC0415
    except ImportError:
        pytest.skip("rtamt is not installed here, so robustness was not compared with it")
    except Exception as error:  # noqa: BLE001  (its parsers refuse other runtimes with any error)
        pytest.skip(f"rtamt does not run here, so robustness was not compared with it: {error}")
    return rtamt.STLDiscreteTimeSpecification


@st.composite
def _predicates(draw):
    name = draw(st.sampled_from(["x", "y", "z"]))
    relation = draw(st.sampled_from(sorted(SIGNS)))
    return logic.Linear(((name, 1.0),), relation, float(draw(st.integers(0, 5))))


@st.composite
def _operators(draw, below):
    left, right = draw(below), draw(below)
    low = draw(st.integers(0, 3))
    high = low + draw(st.integers(0, 3))
    return draw(
        st.sampled_from(
            [
                ~left,
                left & right,
                left | right,
                logic.And((left, right, left)),
                left >> right,
                left.iff(right),
                left.eventually(low, high),
                left.always(low, high),
                left.until(right, low, high),
                left.release(right, low, high),
            ]
        )
    )


# Its own 'iff' measures the distance of the two sides, so that is written with implications.
TEXTS = {
    logic.Not: "not {0}",
    logic.Implies: "{0} implies {1}",
    logic.Iff: "({0} implies {1}) and ({1} implies {0})",
    logic.Eventually: "eventually{span} {0}",
    logic.Always: "always{span} {0}",
    logic.Until: "{0} until{span} {1}",
    logic.Release: "not ((not {0}) until{span} (not {1}))",
}


def spelled(node):
    """A formula as rtamt writes it, every part in parentheses."""
    if isinstance(node, logic.Linear):
        return f"{node.terms[0][0]} {SIGNS[node.relation]} {node.bound}"
    below = [f"({spelled(child)})" for child in node.children]
    if isinstance(node, logic.And | logic.Or):
        word = "and" if isinstance(node, logic.And) else "or"
        return reduce(lambda left, right: f"({left} {word} {right})", below)
    span = f"[{node.low},{node.high}]" if hasattr(node, "low") else ""
    return TEXTS[type(node)].format(*below, span=span)


@given(st.recursive(_predicates(), _operators, max_leaves=6), seeds)
@settings(max_examples=300, deadline=None)
def test_robustness_agrees(monitor, formula, seed):
    trace = trace_for("stl", formula, seed, extra=2)
    values = logic.robustness(formula, trace)
    specification = monitor()
    for name in trace.signals:
        specification.declare_var(name, "float")
    specification.declare_var("out", "float")
    specification.spec = f"out = {spelled(formula)}"
    with contextlib.redirect_stdout(io.StringIO()):
        specification.parse()
        data = {"time": list(range(trace.steps))}
        data |= {name: array.tolist() for name, array in trace.signals.items()}
        judged = specification.evaluate(data)
    assert [value for _, value in judged[: len(values)]] == values.tolist()
