"""`tsplan robustness`: values on recorded signals, and tables that are none."""

from __future__ import annotations

import json

import pytest

from tests.command_line import command
from tsplan.cli import main

FORMULA = "!(x < 10) && F[0,2] (y > 2) || G[1,3] (z <= 8) && G[4,6] (z > 8)"
TABLE = """\
x,y, "z", "a ""b"", c"
8,1,3,1

8,3,9,1
11,2,8,1
11,2,9,1
11,2,9,1
1,0,9,1
1,0,9,1e0
"""
FILES = {
    "trace.csv": TABLE,
    "spec.txt": f"{FORMULA}\n",
    "bad.txt": "x > 1 &&\n  F[0,2 y > 2",
    "weights.yaml": "w: [3, 0.5]\nearly: {0: 1, 1: 0.25}\n",
}
WEIGHED = "x >= 6 &&^w F[0,1]^early (y >= 2)"


def answer(capsys, *arguments):
    """What the command prints; it has to end well and to say nothing else."""
    assert main(["robustness", *arguments]) == 0
    out, err = capsys.readouterr()
    assert err == ""
    return out


@pytest.mark.parametrize("formula", [FORMULA, "spec.txt"])
def test_it_prints_the_value_at_the_first_step(folder, capsys, formula):
    assert answer(capsys, formula, "trace.csv") == "-1\n"
    bounds = ("--bounds", "x=0:20", "y=0:10", "--bounds", "z=0:1e1")
    found = float(answer(capsys, formula, "trace.csv", "--kind", "agm", *bounds))
    assert found == pytest.approx(-0.0416333, abs=5e-8)


def test_it_prints_the_values_at_all_steps(folder, capsys):
    shown = answer(capsys, "F[0,4] (y >= 2)", "trace.csv", "--all")
    assert shown == "0 1\n1 1\n2 0\n"
    assert answer(capsys, r'"a \"b\", c" > 0', "trace.csv") == "1\n"
    assert answer(capsys, "true", "trace.csv") == "inf\n"


def test_it_prints_json(folder, capsys):
    assert json.loads(answer(capsys, "x >= 2 || y > 1", "trace.csv", "--json")) == {
        "formula": "x >= 2 || y > 1",
        "kind": "traditional",
        "robustness": 6.0,
    }
    told = json.loads(answer(capsys, "G[0,5] true", "trace.csv", "--json", "--all"))
    assert told["robustness"] == [None, None]


def test_it_reads_weights(folder, capsys):
    weights = ("--language", "wstl", "--weights", "weights.yaml")
    assert answer(capsys, WEIGHED, "trace.csv", *weights, "--kind", "product") == "0.125\n"
    assert answer(capsys, WEIGHED, "trace.csv", *weights) == "1\n"
    assert main(["parse", WEIGHED, *weights]) == 0
    assert "&&^[3, 0.5] (x >= 6, F[0,1]^[1, 0.25] (y >= 2))" in capsys.readouterr().out


@pytest.mark.parametrize(
    ("table", "lines"),
    [
        ("", ["trace.csv: this is no table with a step in it; write"]),
        ("x,y\n\n", ["trace.csv: this is no table with a step in it; write"]),
        ("1,2\n3,4\n", ["trace.csv:1:1: the first line has numbers and no names"]),
        (
            "x,,x\n1,2,3",
            ["trace.csv:1:3: a column has no name", "trace.csv:1:4: the signal 'x' has"],
        ),
        (
            "x,y\n1, 2o\n3\n,inf\n1_0,nan\n4,5,6\n",
            [
                "trace.csv:2:4: '2o' is no finite number; write a number, as in 1.5",
                "trace.csv:3:1: this row has 1 values for 2 signals; separate",
                "trace.csv:4:1: a value is missing",
                "trace.csv:4:2: 'inf' is no finite number",
                "trace.csv:5:1: '1_0' is no finite number",
                "trace.csv:5:5: 'nan' is no finite number",
                "trace.csv:6:5: this row has 3 values for 2 signals",
            ],
        ),
        ("x;y\n1;2\n", ["trace.csv:2:1: '1;2' is no finite number"]),
        ("y\n1\n", ["trace.csv: the trace has no signal 'x'"]),
    ],
)
def test_tables_that_are_none(folder, capsys, table, lines):
    (folder / "trace.csv").write_text(table)
    assert main(["robustness", "x > 1", "trace.csv"]) == 2
    out, err = capsys.readouterr()
    assert out == ""
    told = err.splitlines()
    assert len(told) == len(lines)
    assert all(one.startswith(wanted) for one, wanted in zip(told, lines, strict=True)), err


@pytest.mark.parametrize(
    ("arguments", "lines"),
    [
        (("bad.txt", "none.csv"), ["bad.txt:2:9: 'y' is unexpected", "none.csv: there is no such"]),
        (("G[0,9] x > 1", "trace.csv"), ["trace.csv: the formula looks 9 steps ahead"]),
        (
            ("x > y", "trace.csv", "--kind", "agm", "--bounds", "x=3:1"),
            ["the bounds of", "the signal"],
        ),
        (
            ("x > 1", "trace.csv", "--weights", "weights.yaml"),
            ["no operator has the weights 'early'"],
        ),
        (
            (WEIGHED, "trace.csv", "--language", "wstl", "--weights", "trace.csv"),
            ["trace.csv:1:1: "],
        ),
    ],
)
def test_what_does_not_fit(folder, capsys, arguments, lines):
    assert main(["robustness", *arguments]) == 2
    out, err = capsys.readouterr()
    assert out == ""
    found = err.splitlines()
    assert all(one.startswith(wanted) for one, wanted in zip(found, lines, strict=False)), err


def test_weights_that_are_none(folder, capsys):
    (folder / "weights.yaml").write_text("w: [3, 0]\nearly: {a: 1}\n")
    assert main(["parse", WEIGHED, "--language", "wstl", "--weights", "weights.yaml"]) == 2
    assert capsys.readouterr().err.splitlines() == [
        "weights.yaml:1:4: w: '0' is no weight; write a number above 0",
        "weights.yaml:2:8: early: 'a' is no step or part; write its number, as in {3: 0.5, 4: 0.2}",
    ]


@pytest.mark.parametrize("bounds", ["x", "x=1", "=1:2", "x=1:b", "x=nan:2"])
def test_bounds_that_are_none(folder, bounds):
    done = command("robustness", "x > 1", "trace.csv", "--bounds", bounds)
    assert (done.code, done.out) == (2, "")
    assert "argument --bounds: " in done.err
