"""Pages that a reader follows are followed, block by block, and do what they say."""

from __future__ import annotations

import re

import pytest

from tests.page_blocks import ROOT, Reader, blocks
from tests.seeds import sampled
from tsplan.public_names import GROUPS

DOCS = ROOT / "docs"
FOLLOWED = sorted(
    [
        *DOCS.glob("tutorials/*.md"),
        *DOCS.glob("coming_from/*.md"),
        *(DOCS / f"{name}.md" for name in ("own_constraints", "starting")),
    ]
)
SLOW = ("fleet_engineer", "researcher", "teacher")  # plan for seconds
RUN = ("sh", "console", "python")


@pytest.mark.parametrize(
    "page", sampled(FOLLOWED, [page for page in FOLLOWED if page.stem not in SLOW])
)
def test_a_page_does_what_it_says(page, tmp_path, monkeypatch):
    monkeypatch.setenv("COLUMNS", "100")
    monkeypatch.setattr("webbrowser.open", lambda _: True)
    reader = Reader(tmp_path)
    for block in blocks(page.read_text(encoding="utf-8")):
        try:
            reader.follow(block)
        except (Exception, SystemExit) as error:
            raise AssertionError(f"{page.name}:{block.line}: {error}") from error


@pytest.mark.parametrize("page", FOLLOWED, ids=lambda page: page.stem)
def test_a_page_leaves_no_block_out(page):
    found = blocks(page.read_text(encoding="utf-8"))
    assert sum(block.language in RUN for block in found) >= 2
    for block, before in zip(found, [None, *found], strict=False):
        shown = block.language == "text" and before is not None and before.language == "python"
        theirs = block.language == "none"  # the lines of another tool
        assert block.language in RUN or block.file or shown or theirs, block


@pytest.mark.parametrize("page", sorted(DOCS.glob("coming_from/*.md")), ids=lambda page: page.stem)
def test_lines_beside_those_of_another_tool_are_run(page):
    text = page.read_text(encoding="utf-8")
    table = re.search(r"^\|---\|---\|\n((?:\|.*\|\n)+)", text, re.MULTILINE)[1]
    ours = [row.strip("|").rsplit(" | ", 1)[1] for row in table.splitlines()]
    lines = [line for cell in ours for line in re.findall(r"`([^`]+)`", cell)]
    assert len(lines) > 9
    run = "".join("".join(block.text.split()) for block in blocks(text, "python"))
    assert [line for line in lines if "".join(line.split()) not in run] == []


TREE = re.compile(r"^```\{toctree\}\n(.*?)^```", re.MULTILINE | re.DOTALL)
ENTRY = re.compile(r"^([a-z_]+(?:/[a-z_]+)?)$", re.MULTILINE)


def test_every_page_is_in_the_contents_once():
    trees = TREE.findall((DOCS / "index.md").read_text(encoding="utf-8"))
    named = [name for tree in trees for name in ENTRY.findall(tree)]
    files = [path for path in DOCS.rglob("*") if path.suffix in (".md", ".ipynb")]
    pages = [path.relative_to(DOCS).with_suffix("") for path in files]
    pages = [page.as_posix() for page in pages if page.parts[0] != "_build"]
    assert sorted(["index", *named]) == sorted(pages)


def test_every_group_of_names_has_its_reference():
    told = {
        page.stem: re.findall(r"^\.\. public-names:: (\w+)$", page.read_text("utf-8"), re.MULTILINE)
        for page in DOCS.glob("api/*.md")
        if page.stem != "command_line"
    }
    assert told == {group.lower(): [group] for group in GROUPS}
