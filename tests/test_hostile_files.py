"""Files from strangers: nothing in them runs, fetches or fills the machine; see SECURITY.md."""

from __future__ import annotations

import struct
import zlib

import pytest

import tsplan
from tsplan.document.kinds import kind_of_text
from tsplan.limits import MOST_LETTERS
from tsplan.ts.io.grey_image import MOST_DOTS
from tsplan.ts.io.map_files import load_map
from tsplan.ts.io.map_settings import MapSettings

GRAPH = "<graphml><graph><node id='a'/></graph></graphml>"
OCCUPANCY = "image: {}\nresolution: {}\norigin: [0, 0, 0]\n"
MISSION = """\
format: tsplan-mission/1
map: {{waiting: true, states: {{a: {{labels: [a]}}}}, edges: []}}
team: [{{class: r, count: 1, at: a}}]
spec: {{language: mtl, formula: "{}"}}
"""
CALL = "__import__('os').system('touch ran')"


@pytest.fixture(autouse=True)
def folder(tmp_path, monkeypatch):
    """A folder to work in; in the end, nothing was run there."""
    monkeypatch.chdir(tmp_path)
    yield tmp_path
    assert not (tmp_path / "ran").exists()


def refused(path, content, load=tsplan.load_map):
    """What is said of a file that is refused."""
    path.write_bytes(content if isinstance(content, bytes) else content.encode())
    with pytest.raises(tsplan.InputError) as caught:
        load(path)
    return str(caught.value)


@pytest.mark.parametrize("load", [tsplan.load_map, tsplan.load_any_mission, tsplan.load_plan])
@pytest.mark.parametrize(
    "text",
    [
        "!!python/object/apply:os.system ['touch ran']\n",
        "states: !!python/object/new:os.system ['touch ran']\n",
        "!Ts\nname: !!python/object/apply:os.system ['touch ran']\ngraph: {}\n",
        "states: {a: !!python/name:os.system ''}\n",
    ],
)
def test_tags_of_yaml_are_never_called(folder, load, text):
    said = refused(folder / "tags.yaml", text, load)
    assert load is tsplan.load_plan or "tag" in said


@pytest.mark.parametrize("formula", [CALL, "sum(a) >= " + CALL, "F[0," + CALL + "] a"])
def test_formulas_are_parsed_and_never_evaluated_as_code(folder, formula):
    refused(folder / "m.yaml", MISSION.format(formula), tsplan.load_mission)


def test_formulas_without_end_are_refused_before_they_are_read(folder):
    long = "!" * (MOST_LETTERS + 1)
    said = refused(folder / "m.yaml", MISSION.format(long), tsplan.load_mission)
    assert "a formula of 2,000,001 characters; at most 2,000,000 are read" in said
    assert len(said) < 1000


def test_sums_of_signals_and_guards_are_no_code(folder):
    signals = f'format: tsplan-signals/1\nsignals: {{x: [0, 1]}}\nlimits: ["{CALL} <= 1"]\n'
    refused(folder / "s.yaml", signals + "spec: F[0,1] x >= 0\n", tsplan.load_any_mission)
    models = f"""\
state_models:
  - state_dim: [place]
    initial: [r1]
    nodes: {{r1: {{connected_to: {{r1: stay}}}}}}
actions:
  stay: {{type: move, weight: 1, guard: "{CALL}"}}
"""
    refused(folder / "models.yaml", models)


@pytest.mark.parametrize(
    "declared",
    [
        "<!DOCTYPE g [<!ENTITY a 'aaaa'><!ENTITY b '&a;&a;&a;'>]>",
        "<!DOCTYPE g [<!ENTITY a SYSTEM 'file:///etc/hostname'>]>",
        "<!DOCTYPE g [<!ENTITY % a SYSTEM 'file:///etc/hostname'> %a;]>",
    ],
)
def test_entities_of_xml_are_neither_grown_nor_fetched(folder, declared):
    text = declared + GRAPH.replace("'a'", "'&a;'")
    assert "XML entities are not read" in refused(folder / "g.graphml", text)


def test_definitions_of_other_files_are_not_fetched(folder):
    (folder / "g.dtd").write_text("<!ENTITY a 'secret'>")
    (folder / "g.graphml").write_text(f"<!DOCTYPE graphml SYSTEM 'g.dtd'>{GRAPH}")
    assert list(tsplan.load_map(folder / "g.graphml").states) == ["a"]
    text = "<!DOCTYPE graphml SYSTEM 'g.dtd'>" + GRAPH.replace("'a'", "'&a;'")
    assert "secret" not in refused(folder / "g.graphml", text)


@pytest.mark.parametrize(
    "text",
    [
        "<?xml version='1.0'?>" + "<!---->" * 2000 + "<x/>",
        "<!---->" * 2000 + "<x/>",
        "<!DOCTYPE x [ ] >" * 2000 + "<x/>",
        "<!DOCTYPE x [" + "] " * 2000 + "<x/>",
        "P2 " + "# " * 2000,
        "type x\n" + "height 1\n" * 2000,
    ],
)
def test_what_a_text_is_takes_no_time_that_grows_without_end(folder, text):
    kind_of_text(text)
    refused(folder / "x.graphml", text)


def png(width, height):
    """The head of a picture, and hardly anything of its dots."""

    def chunk(kind, data):
        sums = zlib.crc32(kind + data)
        return struct.pack(">I", len(data)) + kind + data + struct.pack(">I", sums)

    head = struct.pack(">IIBBBBB", width, height, 8, 0, 0, 0, 0)
    body = chunk(b"IDAT", zlib.compress(bytes(1000))) + chunk(b"IEND", b"")
    return b"\x89PNG\r\n\x1a\n" + chunk(b"IHDR", head) + body


@pytest.mark.parametrize("side", [8000, 12_000, 60_000])
def test_small_files_of_large_pictures_are_refused_by_their_heads(folder, side):
    pytest.importorskip("PIL")
    assert side * side > MOST_DOTS
    (folder / "bomb.png").write_bytes(png(side, side))
    assert "dots are more than" in refused(folder / "o.yaml", OCCUPANCY.format("bomb.png", 0.05))


@pytest.mark.parametrize(
    ("picture", "words"),
    [
        (b"P5 60000 60000 255\n\xff", "dots are more than 50,000,000"),
        (b"P2 60000 60000 255\n1", "dots are more than 50,000,000"),
        (b"P5 " + b"9" * 5000 + b" 1 255\n\xff", "its width is missing"),
        (b"P2 1 1 255\n" + b"255 " * 5_000_000, None),
    ],
)
def test_heads_of_plain_pictures_are_believed_no_more(folder, picture, words):
    (folder / "p.pgm").write_bytes(picture)
    text = OCCUPANCY.format("p.pgm", 1)
    if words is None:
        (folder / "o.yaml").write_text(text)
        assert len(tsplan.load_map(folder / "o.yaml").states) == 1
    else:
        assert words in refused(folder / "o.yaml", text)


def test_pictures_that_other_programs_would_run_are_none(folder):
    pytest.importorskip("PIL")
    script = b"%!PS-Adobe-3.0 EPSF-3.0\n%%BoundingBox: 0 0 9 9\n%%EndComments\n(ran) (w) file\n"
    (folder / "p.eps").write_bytes(script)
    said = refused(folder / "o.yaml", OCCUPANCY.format("p.eps", 1))
    assert "it is none of PNG, BMP" in said


def test_sizes_without_sense_are_findings(folder):
    digits = "9" * 5000
    text = f"type octile\nheight {digits}\nwidth 1\nmap\n.\n"
    assert "is no whole number" in refused(folder / "g.map", text)
    (folder / "p.pgm").write_bytes(b"P5 1 1 255\n\xff")
    said = refused(folder / "o.yaml", OCCUPANCY.format("p.pgm", 1e-300))
    assert "choose a smaller cell" in said
    (folder / "o.yaml").write_text(OCCUPANCY.format("p.pgm", 1))
    with pytest.raises(tsplan.MapError, match="choose a smaller cell"):
        load_map(folder / "o.yaml", MapSettings(cell=1e12))


def test_a_journal_that_somebody_else_has_written_is_started_anew(folder):
    mission = tsplan.mission_from_text(MISSION.format("F[0,1] a"))
    (folder / "out.csv.journal").write_text("[" * 200_000 + "\n" + '{"row": 3}\n' + "x\n")
    [row] = tsplan.sweep([mission], csv=folder / "out.csv")
    assert row["status"] == "optimal"
