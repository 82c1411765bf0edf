"""The notebooks of the documentation: light, harmless, and what they print is what a run prints."""

from __future__ import annotations

import json
import re
from pathlib import Path

import pytest

DOCS = Path(__file__).parents[1] / "docs"
NOTEBOOKS = sorted((DOCS / "notebooks").glob("*.ipynb"))


def test_there_is_one_for_each_kind_of_work():
    names = ["an_experiment", "plan_a_swarm", "plan_a_team", "synthesise_signals"]
    assert [path.stem for path in NOTEBOOKS] == names


@pytest.mark.parametrize("path", NOTEBOOKS, ids=lambda path: path.stem)
def test_they_are_executed_small_and_tell_nothing_of_the_machine(path):
    text = path.read_text(encoding="utf-8")
    assert len(text) < 300_000
    for trace in (r"/home/", r"/tmp/", r"/usr/", r"/root", r"\b20\d\d-\d\d-\d\d", r"site-packages"):
        assert not re.search(trace, text), trace
    cells = [cell for cell in json.loads(text)["cells"] if cell["cell_type"] == "code"]
    assert [cell["execution_count"] for cell in cells] == list(range(1, len(cells) + 1))
    kinds = [output["output_type"] for cell in cells for output in cell["outputs"]]
    assert "error" not in kinds
    shown = [key for cell in cells for out in cell["outputs"] for key in out.get("data", ())]
    assert "image/png" in shown
    modules = set(re.findall(r"^(?:import|from) (\w+)(?:[ .]|$)", _code(cells), re.MULTILINE))
    assert modules <= {"tsplan", "pathlib", "matplotlib"}
    assert "from tsplan" not in _code(cells)


def _code(cells):
    return "\n".join("".join(cell["source"]) for cell in cells)


@pytest.mark.long
@pytest.mark.parametrize("folder", ["", "docs", "docs/notebooks"])
@pytest.mark.parametrize("path", NOTEBOOKS, ids=lambda path: path.stem)
def test_they_run_and_what_they_print_is_not_stale(path, folder):
    pytest.importorskip("nbclient", reason="running notebooks needs nbclient")
    pytest.importorskip("ipykernel", reason="running notebooks needs ipykernel")
    from scripts.notebooks import ROOT, stale  # noqa: PLC0415  (needs what may be missing)

    assert stale(path, ROOT / folder) == []
