"""The script that runs the tests with the lowest and the newest versions: its pure parts."""

from __future__ import annotations

import sys

import pytest

pytest.importorskip("packaging")
from packaging.requirements import Requirement

from scripts import lanes

PROJECT = {
    "name": "Own_Name",
    "dependencies": [
        "numpy>=1.26; python_version < '3.13'",
        "numpy>=2.1; python_version >= '3.13'",
    ],
    "optional-dependencies": {
        "pulp": ["PuLP>=3.3.2,!=3.9,<5"],
        "plot": ["matplotlib>=3.8"],
        "all": ["own-name[pulp,plot]"],
        "test": ["own_name[all]", "pytest>=8"],
    },
}


def test_what_an_extra_needs_is_followed_and_markers_are_heeded():
    for python, numpy in (("3.11", "numpy>=1.26"), ("3.13", "numpy>=2.1")):
        found = [str(item) for item in lanes.requirements(PROJECT, "test", python)]
        assert found == [numpy, "matplotlib>=3.8", "PuLP!=3.9,<5,>=3.3.2", "pytest>=8"]


@pytest.mark.parametrize(
    ("text", "pin"),
    [
        ("a>=1.2", "a==1.2"),
        ("a>=1.2,!=1.3,<2", "a==1.2"),
        ("a>=1.2,>=1.4", "a==1.4"),
        ("a~=1.4.2", "a==1.4.2"),
        ("a==3", "a==3"),
        ("a[y,x]>=1", "a[x,y]==1"),
    ],
)
def test_the_lowest_version_is_the_one_that_the_range_names(text, pin):
    assert lanes.pinned(Requirement(text)) == pin


@pytest.mark.parametrize("text", ["a", "a<2", "a>1", "a>=1,!=1", "a>=2,<2"])
def test_a_range_without_a_lowest_version_is_refused(text):
    with pytest.raises(lanes.LaneError, match="lowest version"):
        lanes.lowest(Requirement(text))


def test_caps_are_read_and_taken_away():
    for text, cap, rest in [
        ("a>=1,<2", "<2", "a>=1"),
        ("a>=1,!=1.5", "", "a!=1.5,>=1"),
        ("a~=1.4", "~=1.4", "a"),
        ("a>=1,<=3,!=2", "<=3", "a!=2,>=1"),
    ]:
        item = Requirement(text)
        assert (str(lanes.caps(item)), lanes.uncapped(item)) == (cap, rest)


def test_every_dependency_of_the_project_has_a_lowest_version():
    project = lanes.project_table()
    assert lanes.pythons(project)[:3] == ["3.11", "3.12", "3.13"]
    for python in lanes.pythons(project):
        needs = lanes.requirements(project, "dev", python)
        names = [item.name for item in needs]
        assert len(names) == len(set(names))
        assert {"highspy", "gurobipy", "matplotlib", "pytest", "ruff"} <= set(names)
        assert all(lanes.lowest(item) in item.specifier for item in needs)


def test_the_short_set_names_files_that_are_there():
    files = lanes.short_set()
    assert all(any(f"test_{name}" in file for file in files) for name in lanes.SHORT)
    assert len(files) < len(list((lanes.ROOT / "tests").glob("test_*.py")))


def test_interpreters_are_found_and_asked_who_they_are():
    here = "{}.{}".format(*sys.version_info)
    assert lanes.interpreters([here, "2.99"]) == {here: sys.executable}


def test_the_table_tells_what_fails_and_what_may():
    versions = {"numpy": "2.1"}
    outcomes = [
        lanes.Outcome("lowest", "3.11", versions, "12 passed in 1s", passed=True),
        lanes.Outcome("newest", "3.11", versions, "1 failed", passed=False),
        lanes.Outcome(
            "a 2 (outside <2)", "3.11", versions, "2 failed", passed=False, binding=False
        ),
    ]
    assert [outcome.failed for outcome in outcomes] == [False, True, False]
    lines = lanes.table(outcomes).splitlines()
    assert lines[1].split() == ["lowest", "3.11", "ok:", "12", "passed", "in", "1s"]
    assert "FAILED: 1 failed" in lines[2]
    assert "fails (reported): 2 failed" in lines[3]
    assert lines[-1] == "a 2 (outside <2), 3.11: numpy 2.1"


def test_a_lane_that_cannot_be_made_has_failed(tmp_path):
    lane = lanes.Lane(tmp_path / "lane", "3.11", ())
    [outcome] = lanes.tried("lowest", lane, sys.executable, [Requirement("a>1")])
    assert outcome.failed
    assert "names no lowest version" in outcome.words
