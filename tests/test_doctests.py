"""The examples in the docstrings do what they say.

They run from a folder with a `mission.yaml`, since many of them read one.
"""

from __future__ import annotations

import doctest
import importlib
from pathlib import Path

import pytest

import tsplan
from tests.page_blocks import blocks

PACKAGE = Path(tsplan.__file__).parent
DOCS = PACKAGE.parent / "docs"
PAGES = sorted(page for page in DOCS.rglob("*.md") if "\n>>> " in page.read_text("utf-8"))
OPTIONAL = {"gurobipy", "matplotlib", "pulp"}
MISSION = """\
format: tsplan-mission/1
name: ferry
map:
  waiting: true
  states: {yard: {labels: [home]}, dock: {labels: [shore]}}
  edges: [{from: yard, to: dock, duration: 2, both_ways: true}]
team: [{class: crew, count: 3, at: yard}]
spec: {language: mtl, formula: "F[0,6] sum(shore) >= 1"}
objective: [travel]
"""


def modules() -> list[str]:
    """The modules whose text has an example."""
    files = sorted(path for path in PACKAGE.rglob("*.py") if ">>> " in path.read_text("utf-8"))
    parts = [path.relative_to(PACKAGE.parent).with_suffix("").parts for path in files]
    return [".".join(part).removesuffix(".__init__") for part in parts]


def found(name: str) -> list[doctest.DocTest]:
    """The examples of a module; skips the test where what it needs is optional and missing."""
    try:
        module = importlib.import_module(name)
    except ImportError as error:
        if error.name not in OPTIONAL:
            raise
        pytest.skip(f"needs {error.name}")
    return [item for item in doctest.DocTestFinder().find(module) if item.examples]


@pytest.fixture(autouse=True)
def folder(tmp_path, monkeypatch):
    """A folder to work in, with a mission."""
    (tmp_path / "mission.yaml").write_text(MISSION, encoding="utf-8")
    monkeypatch.chdir(tmp_path)


@pytest.mark.parametrize("name", modules())
def test_examples(name):
    said: list[str] = []
    runner = doctest.DocTestRunner(verbose=False)
    tried = [runner.run(item, out=said.append).attempted for item in found(name)]
    assert sum(tried) > 0
    assert not said, "".join(said)


@pytest.mark.parametrize("page", PAGES, ids=lambda page: page.name)
def test_examples_of_pages(page):
    """All blocks of a page together, with the values of those above."""
    parser, said = doctest.DocTestParser(), []
    found = blocks(page.read_text("utf-8"), "python")
    text = "".join(block.text for block in found if block.text.startswith(">>> "))
    examples = parser.get_doctest(text, {}, page.name, str(page), 0)
    assert doctest.DocTestRunner(verbose=False).run(examples, out=said.append).attempted > 1
    assert not said, "".join(said)


def test_no_example_is_left_out():
    assert len(PAGES) >= 4
    assert len(modules()) > 50
    skipped = [path for path in PACKAGE.rglob("*.py") if "+SKIP" in path.read_text("utf-8")]
    assert skipped == []
