"""Maps as grids: MovingAI, the League of Robot Runners, and ROS's occupancy grids."""

from __future__ import annotations

import builtins
import sys

import numpy as np
import pytest

from tests import foreign_maps
from tests.foreign_maps import (
    OCCUPANCY,
    OCTILE,
    moves,
    noted,
    read,
    refused,
)
from tsplan.ts.io.grey_image import read_grey

FILES = foreign_maps.FILES


# --- MovingAI ---


def test_a_grid_of_movingai(folder):
    system = read(folder, "grid.map")
    assert len(system.states) == 16
    assert system.labels == {"swamp": ("r1c3",), "water": ("r1c4", "r2c3", "r2c4")}
    assert system.states["r3c1"].origin == 16
    assert system.states["r3c1"].at == (1.5, 3.5)
    found = moves(system)
    assert ("r0c3", "r1c3") in found
    assert ("r1c3", "r1c4") not in found  # water is not entered from land
    assert ("r1c4", "r2c4") in found
    assert ("r0c0", "r1c1") not in found
    assert set(found.values()) == {1}
    assert noted(system) == [
        "robots move in four directions: diagonal moves are not used",
        "3 cells of water cannot be entered from land",
    ]
    slow = read(folder, "grid.map", cell=0.5, speed=0.2)
    assert set(moves(slow).values()) == {3}
    assert slow.states["r3c1"].at == (0.75, 1.75)


def test_a_map_of_the_league_has_stations(tmp_path):
    text = OCTILE.replace("type octile\n", "type octile\r\n").replace("..TWW", "..TES")
    system = read(tmp_path, "kiva.map", text.replace(".@@SW", ".@@.."))
    assert system.labels == {"emitter": ("r2c3",), "service": ("r2c4",)}


def test_all_that_is_wrong_with_a_grid_is_said_at_once(tmp_path):
    text = OCTILE.replace("height 4", "height 7").replace(".@@SW", ".@@S").replace("@....", "@..x.")
    assert refused(tmp_path, "grid.map", text) == [
        "grid.map:2:8: the map has 4 rows, and its height is 7; correct one of them",
        "grid.map:6:1: this row has 4 cells, and the width is 5; correct one of them",
        (
            "grid.map:8:1: 'x' (column 4) is no kind of cell; "
            "known: . G S W E are cells, @ O T are blocked"
        ),
    ]
    wide = refused(tmp_path, "grid.map", OCTILE.replace("width 5", "width five"))
    assert wide[0].startswith("grid.map:3:7: width: 'five' is no whole number")
    assert (
        "the map has no states"
        in refused(tmp_path, "grid.map", "type octile\nheight 1\nwidth 1\nmap\n@\n")[0]
    )


# --- occupancy grids ---


def test_an_occupancy_grid_is_one_of_larger_cells(folder):
    system = read(folder, "room.yaml")
    assert list(system.states) == ["r0c0", "r1c0"]  # 1 m wide, free in all their dots
    assert system.states["r0c0"].at == (-0.5, 3.5)
    assert system.states["r1c0"].at == (-0.5, 2.5)
    assert system.frame == "map"
    assert "2 x 2 cells of 1 m (2 x 2 dots), 2 of them free" in noted(system)[0]
    fine = read(folder, "room.yaml", cell=0.5, speed=0.25)
    assert len(fine.states) == 18
    assert set(moves(fine).values()) == {2}
    assert "r1c3" not in fine.states  # black
    assert "r2c2" not in fine.states  # grey: unknown
    assert fine.states["r0c4"].at == (1.25, 3.75)


def test_a_grid_may_be_turned_and_negated(tmp_path):
    (tmp_path / "room.pgm").write_bytes(b"P5 2 1 255\n\x00\xff")
    text = OCCUPANCY.replace("negate: 0", "negate: 1").replace(
        "2.0, 0.0]", "2.0, 1.5707963267948966]"
    )
    system = read(tmp_path, "room.yaml", text, cell=0.5)
    assert list(system.states) == ["r0c0"]
    assert system.states["r0c0"].at == pytest.approx((-1.25, 2.25))


@pytest.mark.parametrize(
    ("picture", "words"),
    [
        (b"P5 2 2 255\n\x00\x00", "not a whole PGM picture: it has 2 of its 4 dots"),
        (b"P5 2 x", "not a whole PGM picture: its height is missing"),
        (b"P2 0 4 255\n", "not a whole PGM picture: it is 0 x 4 with values up to 255"),
        (b"P2 2 1 255\n1 dot", "not a whole PGM picture"),
        (b"hello", "not a picture"),
    ],
)
def test_broken_pictures_are_told_at_their_name(tmp_path, picture, words):
    (tmp_path / "room.pgm").write_bytes(picture)
    said = refused(tmp_path, "room.yaml", OCCUPANCY)
    assert said[0].startswith(f"room.yaml:1:8: the picture 'room.pgm': {words}")


def test_what_is_wrong_with_an_occupancy_grid(folder, tmp_path):
    assert (
        "there is no such file" in refused(tmp_path, "o.yaml", OCCUPANCY.replace("room.", "no."))[0]
    )
    text = OCCUPANCY.replace("0.5\n", "0\n").replace("[-1.0, 2.0, 0.0]", "[-1.0]")
    said = refused(tmp_path, "o.yaml", text)
    assert len(said) == 2
    (folder / "room.pgm").write_bytes(b"P5 1001 1000 255\n" + b"\xff" * 1_001_000)
    large = refused(folder, "room.yaml", OCCUPANCY, cell=0.5)
    assert "room.yaml:2:13: 1,001,000 cells of 0.5 m are more than 1,000,000" in large[0]


def test_pictures_of_all_kinds_are_the_same(tmp_path, monkeypatch):
    image = pytest.importorskip("PIL.Image")
    dots = np.array([[0, 128, 255], [255, 1, 2]], dtype=np.uint8)
    image.fromarray(dots).save(tmp_path / "a.png")
    image.fromarray(dots).save(tmp_path / "a.pgm")
    image.fromarray(dots.astype(np.uint16) * 257).save(tmp_path / "b.png")
    raw = dots.astype(">u2") * np.uint16(257)
    (tmp_path / "b.pgm").write_bytes(b"P5\n3 2\n65535\n" + raw.astype(">u2").tobytes())
    for name in ("a.png", "a.pgm", "b.png", "b.pgm"):
        assert np.allclose(read_grey(tmp_path / name), dots / 255, atol=1e-5), name
    found = builtins.__import__

    def without_pillow(name, *others):
        if name.startswith("PIL"):
            raise ImportError(name)
        return found(name, *others)

    monkeypatch.setattr(builtins, "__import__", without_pillow)
    for name in [name for name in sys.modules if name.startswith("PIL")]:
        monkeypatch.delitem(sys.modules, name)
    (tmp_path / "room.pgm").write_bytes((tmp_path / "a.png").read_bytes())
    said = refused(tmp_path, "room.yaml", OCCUPANCY)
    assert "this is a PNG picture; save it as PGM, or install tsplan[plot]" in said[0]
