"""The package as others get it: built, installed elsewhere, and what it says of itself."""

from __future__ import annotations

import email
import re
import shutil
import subprocess
import sys
import tarfile
import tomllib
import zipfile
from pathlib import Path

import jsonschema
import pytest
import yaml

import tsplan
from tests.command_line import here, python
from tsplan.version import VERSION

ROOT = Path(tsplan.__file__).parents[1]
OTHERS = shutil.ignore_patterns(
    ".git", ".venv*", "*cache*", "*.egg-info", "build", "dist", "_build"
)
BUILD = "import sys; from setuptools import build_meta as made; print(made.build_{}(sys.argv[1]))"
CHECKOUT = (ROOT / "pyproject.toml").is_file()
pytestmark = pytest.mark.skipif(not CHECKOUT, reason="this is no checkout")


def built(kind: str, source: Path, folder: Path) -> Path:
    """The archive that the build of a source tree makes, without a network."""
    done = subprocess.run(
        [sys.executable, "-c", BUILD.format(kind), str(folder)],
        cwd=source,
        capture_output=True,
        text=True,
        check=False,
    )
    assert done.returncode == 0, done.stderr
    return folder / done.stdout.split()[-1]


@pytest.fixture(scope="module")
def archives(tmp_path_factory):
    """The source archive of the checkout, and the wheel that is built from that archive alone."""
    pytest.importorskip("setuptools", minversion="77.0.3", reason="building needs setuptools")
    folder = tmp_path_factory.mktemp("built")
    shutil.copytree(ROOT, folder / "checkout", ignore=OTHERS)
    source = built("sdist", folder / "checkout", folder)
    with tarfile.open(source) as archive:
        archive.extractall(folder, filter="data")
    return source, built("wheel", folder / f"tsplan-{VERSION}", folder)


@pytest.mark.long
def test_what_is_built_is_installed_elsewhere_and_plans_what_it_ships(archives, tmp_path):
    _, wheel = archives
    site = tmp_path / "site"
    pip = ("-m", "pip", "install", "-q", "--no-deps", "--no-index", "--no-compile")
    done = python(*pip, "--target", str(site), str(wheel), folder=tmp_path)
    assert done.code == 0, done.err
    where = {"folder": tmp_path, "PYTHONPATH": str(site)}
    [script] = (site / "bin").glob("tsplan*")
    listed = python(str(script), "examples", **where)  # the script, as an installation has it
    assert (listed.code, listed.out) == (0, here("examples").out)
    assert python("-m", "tsplan", "examples", "farm_patrol", **where).code == 0
    run = "import tsplan; print(tsplan.__file__); print(tsplan.plan('farm_patrol.yaml'))"
    done = python("-c", run, **where)
    assert done.code == 0, done.err
    assert done.out.startswith(str(site))
    assert "optimal plan (accepted by the independent check)" in done.out


@pytest.mark.long
def test_archives_hold_what_they_should_and_nothing_else(archives):
    source, wheel = archives
    with tarfile.open(source) as archive:
        told = {Path(*Path(name).parts[1:]).as_posix() for name in archive.getnames()}
    tracked = {
        path.relative_to(ROOT).as_posix()
        for folder in ("docs", "environments", "grammars", "scripts", "tests", "tsplan")
        for path in (ROOT / folder).rglob("*")
        if path.is_file() and not {"__pycache__", "_build"} & set(path.parts)
    }
    assert sorted(tracked - told) == []
    with zipfile.ZipFile(wheel) as archive:
        names = archive.namelist()
        [place] = [name for name in names if name.endswith(".dist-info/METADATA")]
        said = email.message_from_string(archive.read(place).decode())
    assert {name.split("/")[0] for name in names} == {"tsplan", f"tsplan-{VERSION}.dist-info"}
    assert any(name.endswith("licenses/LICENSE") for name in names)
    data = ("py.typed", "viewer/web/page.html", "starting/templates/team/mission.yaml")
    assert {f"tsplan/{name}" for name in (*data, "environments/farm_patrol.yaml")} <= set(names)
    assert (said["Name"], said["Version"], said["License-Expression"]) == ("tsplan", VERSION, "MIT")


def test_the_version_is_said_once():
    assert tsplan.__version__ == VERSION
    table = tomllib.loads((ROOT / "pyproject.toml").read_text("utf-8"))
    assert "version" not in table["project"]
    written = re.compile(rf"(?<![\d.]){re.escape(VERSION)}(?![\d.])")
    files = [*ROOT.glob("*.*"), *(ROOT / "tsplan").rglob("*.py"), *(ROOT / "docs").glob("*.*")]
    texts = {path.name: path for path in files if path.suffix in (".py", ".toml", ".cff", ".md")}
    found = {name for name, path in texts.items() if written.search(path.read_text("utf-8"))}
    # the list of changes begins with it, of which the next test knows
    assert found == {"version.py", "CHANGELOG.md"}


def test_changes_begin_with_the_version():
    text = (ROOT / "CHANGELOG.md").read_text("utf-8")
    assert re.findall(r"^## (\S+)", text, re.MULTILINE)[0] == VERSION


# what the Citation File Format 1.2.0 says of the keys that are used
PERSON = {
    "type": "object",
    "anyOf": [{"required": ["family-names", "given-names"]}, {"required": ["name"]}],
    "properties": {
        word: {"type": "string", "minLength": 1} for word in ("family-names", "given-names", "name")
    },
    "additionalProperties": False,
}
PEOPLE = {"type": "array", "items": PERSON, "minItems": 1, "uniqueItems": True}
WORDS = {"type": "string", "minLength": 1}
REFERENCE = {
    "type": "object",
    "required": ["authors", "title", "type"],
    "properties": {
        "type": {"enum": ["article", "conference-paper", "software"]},
        "title": WORDS,
        "authors": PEOPLE,
        "journal": WORDS,
        "year": {"type": "integer"},
        "doi": {"type": "string", "pattern": r"^10\.\d{4,9}(\.\d+)?/\S+$"},
    },
    "additionalProperties": False,
}
CITATION = {
    "type": "object",
    "required": ["authors", "cff-version", "message", "title"],
    "properties": {
        "cff-version": {"const": "1.2.0"},
        "message": WORDS,
        "title": WORDS,
        "abstract": WORDS,
        "type": {"enum": ["software", "dataset"]},
        "authors": PEOPLE,
        "license": {"const": "MIT"},
        "keywords": {"type": "array", "items": WORDS, "minItems": 1, "uniqueItems": True},
        "references": {"type": "array", "items": REFERENCE, "minItems": 1, "uniqueItems": True},
    },
    "additionalProperties": False,
}


def test_how_to_cite_it_is_a_valid_file():
    data = yaml.safe_load((ROOT / "CITATION.cff").read_text("utf-8"))
    jsonschema.Draft202012Validator(CITATION).validate(data)
    table = tomllib.loads((ROOT / "pyproject.toml").read_text("utf-8"))["project"]
    assert (data["title"], data["license"]) == (table["name"], table["license"])
    assert data["keywords"] == table["keywords"]
    assert [person["name"] for person in data["authors"]] == [table["authors"][0]["name"]]
