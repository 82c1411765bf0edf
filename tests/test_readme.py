"""The README: its Python example runs, and its consoles show what the commands print."""

from __future__ import annotations

import re

import pytest

from tests.command_line import here, python
from tests.page_blocks import ROOT, blocks, commands, is_shown, run_command
from tests.seeds import long
from tsplan import sweep, synthesise
from tsplan.signals.signal_files import signal_mission_from_text

README = (ROOT / "README.md").read_text(encoding="utf-8")


def texts(language: str, page: str = README) -> list[str]:
    """The blocks of one language, of the README or another page."""
    return [block.text for block in blocks(page, language)]


@pytest.mark.parametrize(("name", "availability"), [("office_late", 0), long("office_delivery", 1)])
def test_the_python_example_runs(name, availability):
    """By default with a smaller mission than the one that is named there."""
    [text] = texts("python")
    assert "office_delivery" in text
    text = text.replace("office_delivery", name)
    answer = python("-W", "error", "-c", text, folder=ROOT, PYTHONUTF8="1")
    assert (answer.code, answer.err) == (0, "")
    assert re.match(rf"optimal {availability}(\.0)? \(\(0, \d+, '", answer.out)


@pytest.mark.long
def test_the_examples_of_signals_run():
    page = (ROOT / "docs" / "signals.md").read_text(encoding="utf-8")
    [text] = texts("yaml", page)
    assert synthesise(signal_mission_from_text(text)).status == "optimal"
    first, *more = texts("python", page)
    answer = python("-W", "error", "-c", "".join([first, *more]), folder=ROOT, PYTHONUTF8="1")
    assert (answer.code, answer.err) == (0, "")
    # what is printed is what the comments say
    said = re.findall(r"^print.*# (.*)$", first, re.MULTILINE)
    assert answer.out.splitlines()[: len(said)] == said
    folder = ROOT / "environments" / "signals"
    assert {path.name for path in folder.iterdir()} >= set(re.findall(r"signals/(\w+\.yaml)", page))


SWEEPS = (ROOT / "docs" / "sweeps.md").read_text(encoding="utf-8")
RULES = ROOT / "environments" / "sweeps" / "office_rules.yaml"


@pytest.mark.long
def test_the_table_of_a_sweep_is_what_is_printed(tmp_path):
    axes, _ = texts("yaml", SWEEPS)
    assert axes in RULES.read_text(encoding="utf-8")
    [shown] = [text for text in texts("", SWEEPS) if text.startswith("formula ")]
    table = str(tmp_path / "rules.csv")
    done = here("sweep", str(RULES), "-o", table)
    seconds = re.compile(r" +\d+\.\d\d$", re.MULTILINE)
    assert seconds.sub("", done.out.replace(table, "rules.csv")) == seconds.sub("", shown)


@pytest.mark.long
def test_the_examples_of_sweeps_run(tmp_path):
    _, listed = texts("yaml", SWEEPS)
    (tmp_path / "sweeps").mkdir()
    for name in ("office.yaml", "office_closed.yaml"):
        (tmp_path / name).write_text((RULES.parents[1] / name).read_text(encoding="utf-8"))
    place = tmp_path / "sweeps" / "listed.yaml"
    place.write_text(listed)
    assert [row["status"] for row in sweep(place)] == ["infeasible", "optimal", "infeasible"]
    [text] = texts("python", SWEEPS)
    answer = python("-W", "error", "-c", text, folder=ROOT, PYTHONUTF8="1")
    said = re.findall(r"^print.*# (.*)$", text, re.MULTILINE)
    assert (answer.code, answer.err, answer.out.splitlines()) == (0, "", said)


CONSOLES = [pair for text in texts("") for pair in commands(text)]
EXPLAINED = (ROOT / "docs" / "explanations.md").read_text(encoding="utf-8")
LONGER = [
    pair
    for text in texts("", EXPLAINED)
    for pair in commands(text)
    if "environments/" in pair[0] and "--time-limit" not in pair[0]
]


def see(command: str, shown: str) -> None:
    """Run a command; what is shown may be the beginning of what it prints."""
    if command.startswith("tsplan plan"):
        # which of several best plans is found may differ; what is said of it may not
        shown = shown.split("\n\n", maxsplit=1)[0] + "\n"
    elif "there is a plan\n" in shown and "\n..." not in shown:
        shown = "\n".join(shown.splitlines()[:5])  # the rest is about the plan that was found
    done = run_command(command, ROOT)
    assert is_shown(f"{shown}...", done.out), done.out


@pytest.mark.parametrize(("command", "shown"), CONSOLES, ids=[pair[0] for pair in CONSOLES])
def test_consoles_show_what_is_printed(command, shown, monkeypatch):
    monkeypatch.setenv("COLUMNS", "110")
    see(command, shown)


@pytest.mark.long
@pytest.mark.parametrize(("command", "shown"), LONGER, ids=[pair[0] for pair in LONGER])
def test_explanations_are_what_is_printed(command, shown, monkeypatch):
    monkeypatch.setenv("COLUMNS", "100")
    see(command, shown)


def test_there_are_consoles_and_the_files_it_names_are_there():
    assert len(CONSOLES) >= 2
    assert len(LONGER) >= 8
    named = {path for path in re.findall(r"\]\(([^)#]+)", README) if "://" not in path}
    named |= set(re.findall(r"environments/[\w/]+\.yaml", README))
    assert sorted(path for path in named if not (ROOT / path).exists()) == []


def test_the_second_command_installs_and_runs_the_tests():
    [line] = [line for line in README.splitlines() if "pip install" in line and "pytest" in line]
    assert "'.[dev]'" in line
    assert line.split("&&")[1].split()[0] == ".venv/bin/pytest"


@pytest.mark.parametrize("page", sorted((ROOT / "docs").glob("*.md")), ids=lambda page: page.name)
def test_pages_name_files_of_code_that_are_there(page):
    named = set(re.findall(r"`([\w/]+\.py)[`:]", page.read_text(encoding="utf-8")))
    roots = (ROOT, ROOT / "tsplan")
    assert [name for name in named if not any((root / name).is_file() for root in roots)] == []
