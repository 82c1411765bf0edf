"""Names in the solver's own objects: what they say, that each is there once, and that files do."""

from __future__ import annotations

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

import tsplan
from tests.seeds import quick
from tsplan.encode.native_names import _distinct, column_names, row_names
from tsplan.milp.solver import SOLVERS
from tsplan.milp.solver import solver as solver_named
from tsplan.run.problem import Tuning


def problem(*, encoding: str = "reference", barn: str = "barn") -> tsplan.Problem:
    """Three harvesters at a barn, of which some are wanted in the field; and an own constraint."""
    states = [tsplan.State(barn), tsplan.State("field", frozenset({"crop"}))]
    edges = [tsplan.Edge(barn, "field", 2), tsplan.Edge("field", barn, 2)]
    edges += [tsplan.Edge(barn, barn), tsplan.Edge("field", "field")]
    mission = tsplan.Mission.of(
        map=tsplan.TransitionSystem.build(states, edges),
        team={"harvester": {barn: 3}},
        formula="F[0,6] crop >= 2",
        language="mtl",
    )
    made = tsplan.Problem(mission, Tuning.named(encoding))
    made.add(made.count("field", step=6) <= 2, "never all")
    return made


def test_flows_are_named_by_edge_step_and_class():
    encoded = problem().encode()
    names = column_names(encoded)
    assert {"n[barn,3,harvester]", "x[barn,field,0,harvester]"} <= set(names)
    [columns] = encoded.network.classes
    for edge, step, number in zip(*(part.tolist() for part in columns.unrolled()), strict=True):
        ends = (columns.graph.tail[edge], columns.graph.head[edge])
        tail, head = (encoded.setting.arrays.names[end] for end in ends)
        where = f"n[{tail}" if tail == head else f"x[{tail},{head}"
        assert names[number] == f"{where},{step},harvester]"
    others = np.setdiff1d(np.arange(len(names)), columns.unrolled()[2])
    assert all(names[number] == f"y[{number}]" for number in others)


def test_rows_are_named_by_what_they_are_for():
    names = row_names(problem().model)
    assert "never_all" in names
    assert len(set(names)) == len(names) == problem().model.size.rows


@pytest.mark.parametrize("encoding", ["tight", "reference"])
@pytest.mark.parametrize("name", list(SOLVERS))
def test_native_models_have_the_names(name, encoding, tmp_path):
    if not solver_named(name).availability().usable:
        pytest.skip(f"{name} is not usable here")
    asked = problem(encoding=encoding, barn="the barn: west")
    columns, rows = column_names(asked.encode()), row_names(asked.model)
    assert any(text.startswith("n[the_barn__west,") for text in columns)
    native = asked.native(name)
    if name == "highs":
        assert [native.getColName(number)[1] for number in range(len(columns))] == columns
        assert [native.getRowName(number)[1] for number in range(len(rows))] == rows
        native.writeModel(str(tmp_path / "model.mps"))
        assert "never_all" in (tmp_path / "model.mps").read_text(encoding="utf-8")
    elif name == "gurobi":
        assert [variable.VarName for variable in native.getVars()] == columns
        assert {row.ConstrName for row in native.getConstrs()} <= set(rows)
        ranged = np.isfinite(asked.model.row_lower) & np.isfinite(asked.model.row_upper)
        assert "never_all" in {row.ConstrName for row in native.getConstrs()}
        assert native.NumConstrs >= len(rows) - int(ranged.sum())
        row = native.getRow(native.getConstrByName("never_all"))
        expected = asked.model.matrix[[rows.index("never_all")]]
        found = {row.getVar(number).VarName for number in range(row.size())}
        assert found == {columns[number] for number in expected.indices}


@quick
@given(st.lists(st.text(st.characters(codec="utf-8"), max_size=3), max_size=20))
def test_names_are_distinct_and_writable(given_names):
    made = list(_distinct(given_names))
    assert len(set(made)) == len(made) == len(given_names)
    assert not any(letter.isspace() for name in made for letter in name)
