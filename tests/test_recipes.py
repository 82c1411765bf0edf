"""Every recipe of CONTRIBUTING.md, followed from outside: what it names is all that is needed."""

from __future__ import annotations

import json
import re
from dataclasses import dataclass, fields, replace
from importlib import import_module
from pathlib import Path

import numpy as np
import pytest
from pydantic import TypeAdapter

import tsplan
from tests.test_registrations import OPERATIONS
from tsplan import Edge, Group, Mission, State, TransitionSystem
from tsplan.checking import measures
from tsplan.encode import model_objectives
from tsplan.encode.model_objectives import ModelObjective
from tsplan.logic import causes, evaluation, fraction, horizon, normal_form, simplification, text
from tsplan.logic.nodes import And, Or, Pair
from tsplan.milp import solver as solvers
from tsplan.milp.highs import Highs
from tsplan.mission import objectives
from tsplan.plans.plan import Plan
from tsplan.plans.records import Word
from tsplan.ts.io import map_files
from tsplan.ts.io.map_files import MapFormat, load_map, save_map
from tsplan.ts.system import Extras
from tsplan.writers import plan_formats

ROOT = Path(__file__).parents[1]
GUIDE = (ROOT / "CONTRIBUTING.md").read_text(encoding="utf-8")

# from a to c in one move of 5 steps, or in two of 1
DETOUR = TransitionSystem.build(
    [State("a"), State("b"), State("c", "goal")],
    [
        Edge("a", "c", 5),
        Edge("a", "b"),
        Edge("b", "c"),
        *(Edge(name, name) for name in "abc"),
    ],
)


def errand(formula="F[0,8] goal", objective=("travel",)):
    team = [Group.of("cart", {"a": 1})]
    return Mission.of(
        map=DETOUR, team=team, formula=formula, language="mtl", objective=list(objective)
    )


def test_the_guide_names_files_and_what_is_in_them():
    named = re.findall(r"`(tsplan/[\w/]+\.py)`((?:(?: and)? \(`\w+`\))*)", GUIDE)
    assert len(named) > 20
    for path, names in named:
        assert (ROOT / path).is_file(), path
        module = import_module(path.removesuffix(".py").replace("/", "."))
        for name in re.findall(r"\w+(?=`)", names):
            assert hasattr(module, name), (path, name)
    for test in re.findall(r"`(test_\w+)`", GUIDE):
        assert callable(globals()[test])
    for path in re.findall(r"`((?:tests|scripts|grammars)/[\w./]*)`", GUIDE):
        assert (ROOT / path).exists(), path


# --- a map format ---


def read_corridor(document, path, settings):
    names = [f"x{number}" for number in range(document.at((*path, "corridor")))]
    ways = [Edge(one, two) for one in names for two in names if abs(int(one[1]) - int(two[1])) < 2]
    return TransitionSystem.build(map(State, names), ways, extras=Extras("corridor"))


CORRIDOR = MapFormat(
    "corridor",
    lambda document, path: "corridor" in (document.at(path) or {}),
    read_corridor,
    lambda system: f"corridor: {len(system.states)}\n",
)


def test_a_map_format(monkeypatch, tmp_path):
    file = tmp_path / "map.yaml"
    file.write_text("corridor: 4\n")
    with pytest.raises(tsplan.MapError):
        load_map(file)
    monkeypatch.setattr(map_files, "FORMATS", (CORRIDOR, *map_files.FORMATS))
    system = load_map(file)
    assert (len(system.states), len(system.edges)) == (4, 10)
    save_map(system, tmp_path / "again.yaml")
    assert (tmp_path / "again.yaml").read_text() == "corridor: 4\n"
    (tmp_path / "mission.yaml").write_text(
        "format: tsplan-mission/1\nmap: map.yaml\nteam: [{class: cart, at: x0}]\nspec: F[0,3] x3\n"
    )
    assert tsplan.load_mission(tmp_path / "mission.yaml").system.edges == system.edges


# --- a plan format ---


def write_rounds(handover):
    """Who goes where, a line each."""
    for agent, journey in handover.journeys():
        yield f"{agent}: {' '.join(stop.state for stop in journey.visits)}\n"


def test_a_plan_format(monkeypatch, tmp_path):
    mission, file = errand(), tmp_path / "plan.txt"
    plan = tsplan.plan(mission)
    with pytest.raises(tsplan.InputError, match="cannot be written as 'rounds'"):
        tsplan.export(plan, file, to="rounds", map=mission)
    formats = {**plan_formats.FORMATS, "rounds": write_rounds}
    monkeypatch.setattr(plan_formats, "FORMATS", formats)
    tsplan.export(plan, file, to="rounds", map=mission)
    assert file.read_text() == "cart-1: a b c\n"


# --- a solver ---


class Counting(Highs):
    """HiGHS under another name, which counts how often it is asked."""

    name = "counting"
    requests = 0

    def answer(self, request):
        type(self).requests += 1
        return super().answer(request)


def test_a_solver(monkeypatch):
    monkeypatch.setattr(solvers, "SOLVERS", {**solvers.SOLVERS, "counting": Counting})
    monkeypatch.setattr(Counting, "requests", 0)
    plan = tsplan.plan(errand(), solver="counting", without=("tree", "dive"))
    assert (plan.status, plan.solver.name, plan.objective[0].value) == ("optimal", "counting", 2)
    assert Counting.requests


# --- an objective ---


class Hops(ModelObjective):
    """Moves that agents enter, however long they take."""

    name = "hops"

    def reducible(self, setting):
        """A quickest way may have more moves than another one."""
        return False

    def vector(self, setting, encoded):
        vector = np.zeros(encoded.model.size.columns)
        for item in encoded.network.classes:
            edge, _, column = item.unrolled()
            vector[column] = ~item.graph.wait[edge]
        return vector


@pytest.fixture
def hops():
    """The three entries of an objective, taken back afterwards."""
    objectives.register(objectives.Objective("hops", "minimise", "moves that agents enter"))
    measures.register_measure("hops", lambda traffic: sum(part.agents for part in traffic.away))
    model_objectives.register(Hops())
    yield
    del objectives._REGISTER["hops"]
    del measures._REGISTER["hops"]
    del model_objectives._OBJECTIVES["hops"]


@pytest.mark.usefixtures("hops")
def test_an_objective():
    by_hops, by_travel = (tsplan.plan(errand(objective=o)) for o in (["hops"], ["travel"]))
    assert [stay[2] for stay in by_travel.agents[0].stays] == ["a", "b", "c"]
    assert [stay[2] for stay in by_hops.agents[0].stays] == ["a", "c"]
    [hops] = by_hops.objective
    assert (by_hops.status, hops.value, hops.bound) == ("optimal", 1, 1)
    assert tsplan.check(errand(objective=["hops"]), by_hops).ok


def test_an_objective_that_lacks_something_is_told_when_it_is_made():
    class Lacking(ModelObjective):
        """It does not say its vector."""

        name = "lacking"

    with pytest.raises(TypeError, match="vector"):
        Lacking()


def test_an_objective_is_unknown_before():
    with pytest.raises(tsplan.MissionError, match="unknown objective 'hops'"):
        errand(objective=["hops"])


# --- an operator ---


def exactly_one(first, second):
    """A derived operator: a function that says it by others."""
    return ~first.iff(second)


def xor_node():
    """A node and what is registered for it; made here, so that other tests know no such node."""

    @dataclass(frozen=True, eq=False, repr=False, slots=True)
    class Xor(Pair):
        """One side holds and the other does not."""

    @text.layout.register(Xor)
    def _(node):
        operands = [text.Operand(child, text.Binding.UNARY) for child in node.children]
        return text.Layout(text.Binding.LOOSE, (operands[0], " ^ ", operands[1]))

    @normal_form.normal.register(Xor)
    def _(_node, below):
        left, right = below
        one = Or((And((left.holds, right.fails)), And((left.fails, right.holds))))
        same = Or((And((left.holds, right.holds)), And((left.fails, right.fails))))
        return normal_form.Polarity(one, same)

    @simplification.simpler.register(Xor)
    def _(node, below):
        return node.over(below)

    @evaluation.value.register(Xor)
    def _(_node, below, reading):
        steps = min(values.shape[-1] for values in below)
        left, right = (values[..., :steps] for values in below)
        one, other = (
            np.minimum(left, reading.negate(right)),
            np.minimum(reading.negate(left), right),
        )
        return np.maximum(one, other)

    @causes.cause.register(Xor)
    def _(node, judged):
        return causes.Cause(tuple(judged.steps for _ in node.children))

    @fraction.share.register(Xor)
    def _(node, _below):
        raise ValueError(f"'{node}' has no fraction of its own; take tree_of() first")

    return Xor


def test_an_operator():
    one, other = tsplan.parse("goal"), tsplan.parse("F[0,2] sum(goal) >= 2")
    node = xor_node()(one, other)
    assert str(node) == "goal ^ F[0,2] (sum(goal) >= 2)"
    for name, operation in OPERATIONS.items():
        if name.startswith("tsplan.logic."):
            assert operation.missing([type(node)]) == [], name
    for formula in (node, exactly_one(one, other)):
        reached, avoided = formula.eventually(0, 6), (~formula).always(0, 8)
        plan = tsplan.plan(asking(reached))
        assert (plan.status, plan.objective[0].value, plan.verified) == ("optimal", 2, True)
        assert plan.explain(asking(reached)).holds
        plan = tsplan.plan(asking(avoided & one.eventually(0, 8)))
        assert plan.status == "infeasible"


def asking(formula):
    """The errand with a formula made in Python, as the grammar does not know all operators."""
    return replace(errand(), formula=formula, text=str(formula), horizon=horizon(formula))


# --- a field of plans ---


def test_a_field_of_plans():
    @dataclass(frozen=True)
    class Weathered(Plan):
        """A plan with one more line in its record."""

        weather: Word = "calm"

    made = tsplan.plan(errand())
    given = {field.name: getattr(made, field.name) for field in fields(Plan)}
    told = Weathered(**given, weather="ice")
    data = json.loads(told.to_json())
    assert data.pop("format") == json.loads(made.to_json())["format"]
    assert data["weather"] == "ice"
    reader = TypeAdapter(Weathered)
    assert reader.validate_python(data, context={}) == told
    del data["weather"]  # as files have it that were written before
    assert reader.validate_python(data, context={}).weather == "calm"
