"""Maps of other programs: every format is recognised, kept and described."""

from __future__ import annotations

import pytest

from tests import foreign_maps
from tests.command_line import ROOT
from tests.foreign_maps import (
    MAPS,
    moves,
    read,
    refused,
)
from tsplan.document import parse_document
from tsplan.ts.io import map_files
from tsplan.ts.io.map_files import FORMATS, format_of, load_map, map_document, save_map
from tsplan.ts.io.tsplan_yaml import map_to_yaml, read_own
from tsplan.ts.ride_durations import Ride, steps_of

FILES = foreign_maps.FILES


@pytest.mark.parametrize("name", MAPS)
def test_formats_are_told_by_content_not_by_name(folder, name):
    form = format_of(map_document(folder / name)).name
    for suffix in ("", ".txt", ".yaml", ".json"):
        other = folder / f"other{suffix}"
        other.write_text(MAPS[name])
        assert format_of(map_document(other)).name == form
    assert form != FORMATS[-1].name


@pytest.mark.parametrize("name", MAPS)
def test_every_map_becomes_an_own_file_and_is_read_as_the_same(folder, name):
    system = read(folder, name, step=2.0)
    save_map(system, folder / "own.yaml")
    assert (folder / "own.yaml").read_text() == map_to_yaml(system)
    again = load_map(folder / "own.yaml")
    assert again == system
    assert again.step_seconds == 2.0
    origins = [state.origin for state in again.states.values()]
    assert None not in origins
    assert len(set(origins)) == len(origins)


@pytest.mark.parametrize("name", MAPS)
def test_waits_are_added_unless_that_is_refused(folder, name):
    waiting, restless = read(folder, name), read(folder, name, waiting=False)
    assert all((state, state) in waiting.edges for state in waiting.states)
    assert not any(edge.is_wait for edge in restless.edges.values())
    assert moves(waiting) == moves(restless)


def test_every_format_is_described():
    page = (ROOT / "docs" / "maps.md").read_text()
    for form in FORMATS:
        assert f"| `{form.name}`: " in page


def test_lengths_become_durations_in_one_place():
    assert steps_of(Ride(12.1 - 10.4), 1.0, 0.1) == 17
    assert steps_of(Ride(0.0), 1.0, 1.0) == 1
    assert steps_of(Ride(4, seconds=2.5), 0.5, 9.0) == 5
    assert steps_of(Ride(6, share=0.5, limit=0.25), 1.0, 1.0) == 24
    assert steps_of(Ride(6, pause=3), 4.0, 2.0) == 2
    assert steps_of(Ride(6), 1.0, {"a": 2, "default": 2}) == 3
    assert steps_of(Ride(6), 1.0, {"a": 2}) == {"a": 3}
    assert steps_of(Ride(6, limit={"a": None, "b": 0.5}), 1.0, {"a": 3}) == {"a": 2, "b": 12}


# --- formats of other packages ---


def test_other_packages_add_formats(tmp_path, monkeypatch):
    def read_line(document, path, settings):
        return read_own(parse_document("states: {a: {}, b: {}}", "inner"))

    class Point:
        name = "line"

        def load(self):
            if broken:
                raise ImportError("no module named line")
            return map_files.MapFormat(
                "line",
                lambda document, path: document.at(path) == "a line",
                read_line,
                opens=lambda *_: None,
            )

    def points(group):
        assert group == "tsplan.map_readers"
        return [Point()]

    broken = False
    monkeypatch.setattr(map_files, "entry_points", points)
    map_files.added_formats.cache_clear()
    try:
        assert list(read(tmp_path, "line.txt", "a line\n").states) == ["a", "b"]
        broken = True
        map_files.added_formats.cache_clear()
        assert "the map reader 'line' cannot be loaded: no module" in str(
            refused(tmp_path, "line.txt", "a line\n")
        )
    finally:
        map_files.added_formats.cache_clear()
