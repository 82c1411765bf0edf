"""Starting from nothing: new missions, shipped examples, completion, help."""

from __future__ import annotations

import json
import os
import re
import shutil
import subprocess
from pathlib import Path

import jsonschema
import pytest

import tsplan
from tests.command_line import command, here
from tsplan.cli.arguments import parser
from tsplan.cli.first_commands import FILES, NEW
from tsplan.cli.parser_words import commands_of
from tsplan.document import read_document
from tsplan.signals.signal_files import load_any_mission
from tsplan.starting.file_schemas import SCHEMAS
from tsplan.starting.shipped_examples import examples, files_of_example
from tsplan.starting.starting_folder import TEMPLATES
from tsplan.version import VERSION

ROOT = Path(tsplan.__file__).parents[1]
MODELINE = re.compile(r"# yaml-language-server: \$schema=(\S+)\n")


def tree(folder: Path) -> dict[str, bytes]:
    """The files below a folder."""
    return {
        path.relative_to(folder).as_posix(): path.read_bytes()
        for path in folder.rglob("*")
        if path.is_file()
    }


def test_the_parser_names_what_there_is():
    assert sorted(NEW) == sorted(path.name for path in TEMPLATES.iterdir())
    assert tuple(SCHEMAS) == FILES


@pytest.mark.parametrize("kind", NEW)
def test_a_new_mission_is_planned_as_it_is_and_its_editor_knows_it(kind, tmp_path):
    done = here("init", kind, "new/first", folder=tmp_path)
    assert (done.code, done.err) == (0, "")
    folder = tmp_path / "new" / "first"
    assert done.out.splitlines()[-1] == f"next: tsplan plan {Path('new', 'first', 'mission.yaml')}"
    for path in folder.glob("*.yaml"):
        text = path.read_text("utf-8")
        schema = json.loads((folder / MODELINE.match(text)[1]).read_text("utf-8"))
        jsonschema.Draft202012Validator(schema).validate(read_document(path).data)
        assert text.count("#") > 5
    assert here("lint", str(folder / "mission.yaml")).code == 0
    mission = load_any_mission(folder / "mission.yaml")
    solve = tsplan.synthesise if kind == "signals" else tsplan.plan
    result = solve(mission)
    assert (result.status, result.verified) == ("optimal", True)


def test_a_new_mission_writes_over_nothing(tmp_path):
    assert here("init", "team", folder=tmp_path).code == 0
    (tmp_path / "map.yaml").write_text("name: mine\n")
    before = tree(tmp_path)
    done = here("init", "swarm", folder=tmp_path)
    assert (done.code, done.out) == (2, "")
    assert done.err.count("there already") == 2
    assert tree(tmp_path) == before
    # what would be the same is not lost
    (tmp_path / "map.yaml").unlink()
    assert here("init", "team", folder=tmp_path).code == 0


def test_a_new_mission_needs_a_folder_that_can_be_made(tmp_path):
    (tmp_path / "file").write_text("")
    done = here("init", "team", str(tmp_path / "file" / "folder"))
    assert done.code == 2
    assert "cannot be made" in done.err


def test_every_shipped_file_is_listed_in_a_line_and_has_a_name_of_its_own():
    done = here("examples")
    lines = [line for line in done.out.splitlines() if line.startswith(" ")]
    names = [line.split()[0] for line in lines]
    assert sorted(names) == sorted(path.stem for path in (ROOT / "environments").rglob("*.yaml"))
    assert len(set(names)) == len(names) > 40
    assert all(len(line.split(maxsplit=1)[1]) > 10 and len(line) <= 110 for line in lines)


def test_a_copied_example_has_all_that_it_needs(tmp_path):
    for item in examples():
        place = tmp_path / item.name
        assert here("examples", item.name, "-o", str(place)).code == 0
        copied = tree(place)
        assert copied == {path.as_posix(): text for path, text in files_of_example(item).items()}
        [own] = [path for path in place.rglob("*.yaml") if path.stem == item.name]
        assert own.read_bytes() == item.path.read_bytes()
        data = read_document(own).data
        for key in ("map", "mission"):
            if isinstance(data.get(key), str):
                assert (own.parent / data[key]).is_file()
    assert here("lint", str(tmp_path / "office_delivery" / "office_delivery.yaml")).code == 0
    # a second one beside it shares its map
    assert here("examples", "office_late", "-o", str(tmp_path / "office_delivery")).code == 0


def test_an_example_that_is_not_there_is_refused(tmp_path):
    done = here("examples", "office_delivry", folder=tmp_path)
    assert done.code == 2
    assert "did you mean 'office_delivery'" in done.err
    assert here("examples", "-o", "x", folder=tmp_path).code == 2
    assert tree(tmp_path) == {}


COMMANDS = tuple(commands_of(parser()))


@pytest.mark.parametrize("name", COMMANDS)
def test_help_of_a_command_is_what_its_option_prints(name):
    done = here("help", name)
    assert (done.code, done.out) == (0, here(name, "--help").out)
    assert done.out.startswith(f"usage: tsplan {name}")


def test_help_alone_is_of_the_whole_and_a_wrong_command_is_refused():
    assert here("help").out == here("--help").out
    assert here("help", "plna").code == 2


def test_the_version_is_printed_by_a_process_of_its_own():
    assert command("--version") == (0, f"tsplan {VERSION}\n", "")


BASH = shutil.which("bash")
ASKED = r"""
source "$1"; shift
COMP_WORDS=("$@"); COMP_CWORD=$(($# - 1))
_tsplan; printf '%s\n' "${COMPREPLY[@]}"
"""


def completed(folder: Path, *words: str) -> list[str]:
    """What bash offers for the last of some words."""
    (folder / "script").write_text(here("completion", "bash").out)
    done = subprocess.run(
        [BASH, "--noprofile", "--norc", "-c", ASKED, "bash", "./script", *words],
        capture_output=True,
        encoding="utf-8",
        check=True,
        cwd=folder,
    )
    assert done.stderr == ""
    return sorted(filter(None, done.stdout.split("\n")))


@pytest.mark.skipif(BASH is None or os.name != "posix", reason="needs bash")
def test_bash_completes_commands_options_choices_and_files(tmp_path):
    (tmp_path / "a mission.yaml").write_text("")
    assert completed(tmp_path, "tsplan", "") == sorted(COMMANDS)
    assert completed(tmp_path, "tsplan", "pl") == ["plan"]
    assert completed(tmp_path, "tsplan", "plan", "--en") == ["--encoding"]
    assert completed(tmp_path, "tsplan", "plan", "--encoding", "") == ["reference", "tight"]
    assert completed(tmp_path, "tsplan", "plan", "a") == ["a mission.yaml"]
    assert completed(tmp_path, "tsplan", "plan", "-o", "a") == ["a mission.yaml"]
    assert completed(tmp_path, "tsplan", "plan", "--gap", "") == []
    assert completed(tmp_path, "tsplan", "init", "s") == ["script", "signals", "swarm"]
    assert completed(tmp_path, "tsplan", "examples", "reach") == ["reach_avoid"]
    assert completed(tmp_path, "tsplan", "export", "--to", "n") == ["nav2"]
    assert "highs" in completed(tmp_path, "tsplan", "plan", "--solver", "")
    assert completed(tmp_path, "tsplan", "schema", "tr") == ["trajectory"]
    assert completed(tmp_path, "tsplan", "parse", "--language", "w") == ["wmtl", "wstl"]


@pytest.mark.parametrize("shell", ["bash", "zsh", "fish"])
def test_every_shell_reads_its_script_which_has_all_commands_and_options(shell, tmp_path):
    script = here("completion", shell).out
    for name, one in commands_of(parser()).items():
        assert re.search(rf"\b{name}\b", script)
        for action in one._actions:
            for option in action.option_strings:
                written = option if shell != "fish" else option.lstrip("-")
                assert re.search(rf"(?<![\w-]){written}\b", script), option
    (tmp_path / "script").write_text(script)
    if program := shutil.which(shell):
        subprocess.run([program, "-n", "script"], cwd=tmp_path, check=True)
