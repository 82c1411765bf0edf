"""The command line: output, exit codes, one line per finding, never a traceback."""

from __future__ import annotations

import json

import pytest

import tsplan
from tests.command_line import command, printed
from tests.missions import MAP, MISSION
from tests.seeds import sampled
from tsplan.cli import main
from tsplan.logic import LANGUAGES


def write(folder, **changes):
    text = MISSION
    for old, new in changes.values():
        assert old in text
        text = text.replace(old, new)
    (folder / "mission.yaml").write_text(text)


def plan_text(*, there=(1, 4)):
    first, last = there
    stays = [[0, first - 1, "p"], [first, last, "q"], [last + 1, 6, "p"]]
    agents = [
        {"id": f"a-{n}", "class": "a", "capabilities": ["see"], "stays": stays} for n in (1, 2)
    ]
    return json.dumps(
        {
            "format": "tsplan-plan/1",
            "status": "optimal",
            "mission": {"name": "there and back", "sha256": ""},
            "horizon": 6,
            "objective": [{"name": "travel", "value": 4, "bound": 4}],
            "availability": 0,
            "agents": agents,
        }
    )


def test_check_accepts_and_says_what_holds(folder, capsys):
    (folder / "plan.json").write_text(plan_text())
    assert main(["check", "mission.yaml", "plan.json"]) == 0
    out = capsys.readouterr().out
    assert "the formula holds" in out
    assert out.endswith("the plan is accepted\n")
    assert main(["check", "mission.yaml", "plan.json", "--quiet"]) == 0
    assert capsys.readouterr().out == ""


def test_check_refuses_with_one_line_each(folder, capsys):
    (folder / "plan.json").write_text(plan_text(there=(4, 5)))
    assert main(["check", "mission.yaml", "plan.json"]) == 1
    out, err = capsys.readouterr()
    assert out.startswith("plan.json: the formula does not hold")
    assert err == ""


def test_check_reports_both_files(folder, capsys):
    write(folder, label=("sum(A)", "sum(C)"))
    (folder / "plan.json").write_text("{")
    assert main(["check", "mission.yaml", "plan.json"]) == 2
    err = capsys.readouterr().err.splitlines()
    assert len(err) == 2
    assert err[0].startswith("mission.yaml:5:")
    assert err[1].startswith("plan.json:1:2: this is not JSON")


def test_parse_prints_every_form(capsys):
    assert main(["parse", "F[0,2] T(1, green, {(IR,2)}) && !red", "--language", "catl"]) == 0
    out = capsys.readouterr().out
    assert "eventually [0,2]" in out
    rows = {line.split()[0]: line for line in out.splitlines() if not line.startswith(" ")}
    assert rows["horizon"].split() == ["horizon", "3"]
    assert "min(green,IR) >= 2" in rows["mtl"]
    assert "sum(red) <= 0" in rows["positive"]
    assert main(["parse", rows["text"].split(maxsplit=1)[1], "--language", "catl"]) == 0
    assert capsys.readouterr().out == out


def test_parse_knows_every_language(capsys):
    for language in LANGUAGES:
        atom = "x > 1" if language.endswith("stl") else "a"
        assert main(["parse", f"one({atom}, F[0,2] {atom})", "--language", language]) == 0
    capsys.readouterr()
    assert main(["parse", "F[0,1]^[1, 3] x > 1 ||^2 y > 0", "--language", "wstl"]) == 0
    out = capsys.readouterr().out
    assert "  or ^2\n    eventually [0,1]^[1, 3]\n      x > 1\n" in out
    assert "text      ||^2 (F[0,1]^[1, 3] (x > 1), y > 0)\n" in out
    assert main(["parse", "F[0,1]^w x > 1", "--language", "wstl"]) == 2
    assert "1:7: no weights 'w' are given" in capsys.readouterr().err


def test_parse_points_at_mistakes(capsys):
    assert main(["parse", "F[0,2.5] a", "--language", "mtl"]) == 2
    out, err = capsys.readouterr()
    assert out == ""
    assert "1:5" in err
    assert "Traceback" not in err


def test_parse_survives_deep_nesting(capsys):
    assert main(["parse", "!" * 300 + "a", "--language", "mtl"]) == 0
    assert "horizon" in capsys.readouterr().out


def test_lint(folder, capsys):
    assert main(["lint", "map.yaml"]) == 0
    assert "2 states, 4 edges" in capsys.readouterr().out
    (folder / "map.yaml").write_text(MAP.replace("[q, p, 1]", "[q, q, 1]"))
    assert main(["lint", "map.yaml"]) == 1
    assert capsys.readouterr().out.startswith("map.yaml: ")


def test_lint_of_missions(folder, capsys):
    write(folder)
    assert main(["lint", "mission.yaml"]) == 0
    assert capsys.readouterr().out == "2 agents, horizon 6, nothing looks odd\n"
    path = folder / "signals.yaml"
    text = "format: tsplan-signals/1\nsignals: {x: [0, 9]}\nspec: F[0,4] x %s 5\n"
    path.write_text(text % ">=")
    assert main(["lint", "signals.yaml"]) == 0
    assert capsys.readouterr().out == "1 signal, 0 controls, horizon 4, nothing looks odd\n"
    path.write_text(text % "=")
    assert main(["lint", "signals.yaml"]) == 1
    assert capsys.readouterr().out.startswith("signals.yaml:3:14: 'x = 5' can only hold with")


@pytest.mark.parametrize(
    ("arguments", "words"),
    [
        ([], "COMMAND"),
        (["plan"], "MISSION"),
        (["fly"], "fly"),
        (["plan", "mission.yaml", "--time-limit", "0"], "not above 0"),
        (["plan", "mission.yaml", "--time-limit", "nan"], "not a finite number"),
        (["plan", "mission.yaml", "--gap", "-1"], "below 0"),
        (["plan", "mission.yaml", "--threads", "1.5"], "not a whole number"),
        (["plan", "mission.yaml", "--seed", "-1"], "below 0"),
        (["plan", "mission.yaml", "--encoding", "loose"], "loose"),
        (["parse", "a"], "--language"),
        (["plan", "none.yaml"], "none.yaml: there is no such file"),
        (["show", "none.yaml", "-o", "x.png"], "none.yaml"),
        (["lint", "none.yaml"], "none.yaml: there is no such file"),
        (["check", "mission.yaml", "none.json"], "none.json: cannot read the plan"),
        (["plan", "mission.yaml", "-o", "none/plan.json"], "none/plan.json"),
        (["plan", "mission.yaml", "-o", "."], "."),
    ],
)
def test_bad_usage_is_two(folder, capsys, arguments, words):
    assert main(arguments) == 2
    err = capsys.readouterr().err
    assert words in err
    assert "Traceback" not in err


def test_a_finding_is_one_line_even_about_several(folder, capsys):
    write(folder, language=("language: mtl", "language: 'mtl\\n\\n  and more'"))
    text = (folder / "mission.yaml").read_text().replace("\\n", "\n")
    (folder / "mission.yaml").write_text(text)
    assert main(["check", "mission.yaml", "none.json"]) == 2
    assert len(capsys.readouterr().err.splitlines()) == 2


def test_an_internal_error_is_one_line(folder, capsys, monkeypatch):
    def broken(*_):
        raise ZeroDivisionError("two\nlines")

    monkeypatch.setattr("tsplan.cli.lint_command.lint", broken)
    assert main(["lint", "map.yaml"]) == 5
    err = capsys.readouterr().err
    assert err.count("\n") == 1
    assert "ZeroDivisionError: two lines" in err
    assert "report" in err


@pytest.mark.parametrize("kind", sampled(["png", "svg"], ["svg"]))
def test_show_draws_maps_missions_and_plans(folder, kind):
    pytest.importorskip("matplotlib")
    (folder / "plan.json").write_text(plan_text())
    for file in ("map.yaml", "mission.yaml", "plan.json"):
        assert main(["show", file, "-o", f"picture.{kind}"]) == 0
        assert (folder / f"picture.{kind}").stat().st_size > 1000
    assert main(["show", "plan.json", "--mission", "mission.yaml", "-o", "picture.png"]) == 0
    assert main(["show", "map.yaml", "-o", "picture.docx"]) == 2


def test_show_without_a_display_names_the_remedy(folder, capsys):
    pytest.importorskip("matplotlib.pyplot").switch_backend("Agg")
    assert main(["show", "map.yaml"]) == 5
    assert "-o FILE.png" in capsys.readouterr().err


def test_help_loads_nothing_that_is_slow():
    code = (
        "import sys, tsplan.cli; tsplan.cli.main(['--help']); "
        "heavy = {'numpy', 'scipy', 'highspy', 'matplotlib', 'rich', 'pydantic', 'antlr4', "
        "'networkx'}; print(sorted(heavy & set(sys.modules)))"
    )
    *shown, loaded = printed(code).splitlines()
    assert loaded == "[]"
    assert any("exit codes" in line for line in shown)


def test_the_module_runs_as_a_program(folder):
    code, out, err = command("plan", "none.yaml")
    assert code == 2
    assert err.startswith("none.yaml: there is no such file")
    assert out == ""


def test_the_package_is_imported_lazily():
    heavy = "{'highspy', 'matplotlib', 'numpy', 'antlr4'}"
    assert printed(f"import sys, tsplan; print({heavy} & set(sys.modules))") == "set()\n"


def test_every_public_name_exists():
    for name in tsplan.__all__:
        assert getattr(tsplan, name) is not None
    assert set(tsplan.__all__) <= set(dir(tsplan))
    with pytest.raises(AttributeError):
        tsplan.nothing  # noqa: B018
