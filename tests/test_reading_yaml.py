"""What YAML makes of formulas, merge keys, and files that are no files."""

from __future__ import annotations

import os

import pytest

from tsplan.document import parse_document, read_document
from tsplan.document.kinds import kind_of_bytes, kind_of_data, kind_of_text
from tsplan.errors import InputError, MapError, MissionError, PlanError
from tsplan.mission import load_mission, mission_from_text
from tsplan.plans.plan_file import load_plan
from tsplan.ts.io.map_files import load_map, map_from_document

MISSION = """\
format: tsplan-mission/1
map: {waiting: true, states: {a: {labels: [a]}, b: {labels: [b]}}, edges: [[a, b, 1]]}
team: [{class: r, count: 1, at: a}]
spec:
  language: mtl
  formula: FORMULA
"""


def told(formula):
    """What is said of a mission with this formula, without the name of the file."""
    with pytest.raises(MissionError) as caught:
        mission_from_text(MISSION.replace("FORMULA", formula), "m")
    return str(caught.value)


@pytest.mark.parametrize(
    ("formula", "words"),
    [
        (
            "! a",
            "m:6:12: YAML takes '!' for a tag, and only 'a' is left; put the formula in quotes",
        ),
        ("!a b", "YAML takes '!a' for a tag"),
        ("! 'a'", "YAML takes '!' for a tag"),
        ("[b, ! a]", "m:6:16: YAML takes '!' for a tag"),
        ("! [a, b]", "m:6:12: YAML takes '!' for a tag"),
        ("&a b", "YAML takes '&a' for an anchor, and only 'b' is left"),
        ("&a & b", "YAML takes '&' at the beginning"),
        ("* a", "YAML takes '*' at the beginning"),
        ("*a", "'*a' refers to nothing; put the whole formula in quotes"),
        ("| a", "after '|', YAML begins a text on the next line"),
        ("> a", "after '>', YAML begins a text on the next line"),
        ("@a", "no text may begin with '@' in YAML"),
        ("`a`", "no text may begin with '`' in YAML"),
        ("%a", "no text may begin with '%' in YAML"),
        ("[][0,3] a", "for the beginning of a list"),
        ("a: b", "YAML takes a second ': ' in a line"),
        ('"a" && b', "put the whole"),
        ("'a", "this quote is never closed"),
        ('"F[0,3] a /\\ F[0,3] b"', "inside double quotes, YAML takes a backslash for an escape"),
        ('"a \\/ b"', "inside double quotes, YAML takes a backslash for an escape"),
        ('"a /\\F b"', "inside double quotes, YAML knows no '\\F'"),
        ("F[0,3] (a # b)", "m:6:21: YAML takes ' #' for a comment, so the formula ends before it"),
        ("[a, sum(a, r) >= 1]", "inside { } and [ ], YAML ends a text"),
    ],
)
def test_a_formula_that_yaml_takes_apart_is_told_so(formula, words):
    assert words in told(formula)


@pytest.mark.parametrize(
    "spec",
    [
        "{language: mtl, formula: F[0,3] a}",
        "{language: mtl, formula: sum(a, r) >= 1}",
        "{language: mtl, formula: a && b, c}",
    ],
)
def test_a_formula_inside_braces_that_ends_at_a_comma(spec):
    head = MISSION[: MISSION.index("spec:")]
    with pytest.raises(MissionError, match=r"inside \{ \} and .*YAML ends a text without quotes"):
        mission_from_text(f"{head}spec: {spec}\n")


def test_comments_and_anchors_that_are_meant_stay():
    assert str(mission_from_text(MISSION.replace("FORMULA", "F[0,3] b  # the goal")).formula)
    text = MISSION.replace("FORMULA", "[&goal 'F[0,3] b', *goal]")
    assert str(mission_from_text(text).formula) == str(
        mission_from_text(MISSION.replace("FORMULA", "['F[0,3] b', 'F[0,3] b']")).formula
    )


MERGED = """\
states:
  a: &room {labels: [A], capacity: 3, color: blue}
  b: {<<: *room, labels: [B]}
  c: {<<: [{capacity: 1}, *room]}
edges:
  - &lane {from: a, to: b, duration: 2, both_ways: true}
  - {<<: *lane, from: b, to: c}
"""


def test_merge_keys_take_in_what_is_not_there():
    system = map_from_document(parse_document(MERGED, "f"))
    assert [(s.labels, s.capacity, s.color) for s in system.states.values()] == [
        ({"A"}, 3, "blue"),
        ({"B"}, 3, "blue"),
        ({"A"}, 1, "blue"),
    ]
    assert system.edges["c", "b"].duration == 2


@pytest.mark.parametrize(
    ("old", "new", "words"),
    [
        ("capacity: 3", "capacity: x", "f:2:36: capacity: 'x' is not a whole number"),
        ("*room, labels: [B]", "*room, labels: [B], labels: []", "'labels' appears twice"),
        ("<<: *room, labels", "<<: *room, <<: *room, labels", "'<<' appears twice"),
        ("<<: *room, labels", "<<: 3, labels", "'<<' takes in the entries of mappings"),
        ("[{capacity: 1}, *room]", "[{capacity: 1}, 3]", "f:4:27: '<<' takes in"),
    ],
)
def test_what_is_wrong_with_a_merge_has_its_place(old, new, words):
    assert old in MERGED
    with pytest.raises(InputError) as caught:
        map_from_document(parse_document(MERGED.replace(old, new, 1), "f"))
    assert words in str(caught.value)


def test_a_quoted_merge_key_is_a_key_like_any_other():
    assert parse_document("a: {'<<': 1}", "f").data == {"a": {"<<": 1}}


def test_a_format_that_is_missing_is_named():
    with pytest.raises(MissionError, match="'format' is missing; add 'format: tsplan-mission/1'"):
        mission_from_text(MISSION.replace("format: tsplan-mission/1\n", "").replace("FORMULA", "a"))


def test_what_is_wrong_elsewhere_is_told_in_the_same_go():
    text = MISSION.replace("FORMULA", "F[0,3] c").replace("at: a}", "at: c}") + "colour: red\n"
    with pytest.raises(MissionError) as caught:
        mission_from_text(text, "m")
    found = str(caught.value)
    assert "unknown key 'colour'" in found
    assert "no state of the map has the label 'c'" in found
    assert "the map has no state 'c'" in found
    broken = MISSION.replace("FORMULA", "F[0,3] c").replace("count: 1", "count: x")
    with pytest.raises(MissionError) as caught:
        mission_from_text(broken, "m")
    found = str(caught.value)
    assert "count" in found
    assert "no state of the map has the label 'c'" in found


OTHERS = {
    "graph.json": '{"directed": true, "nodes": [{"id": 1}], "links": []}',
    "graph.graphml": "<?xml version='1.0'?>\n<graphml xmlns='x'><graph/></graphml>",
    "grid.map": "type octile\nheight 1\nwidth 2\nmap\n.@\n",
    "places.json": '{"type": "FeatureCollection", "features": []}',
    "picture.png": b"\x89PNG\r\n\x1a\n\x00\x00",
    "picture.jpg": b"\xff\xd8\xff\xe0",
    "grid.pgm": b"P5\n2 2\n255\n\xff\x00\xff\x00",
    "ros.yaml": "image: a.pgm\nresolution: 0.1\norigin: [0, 0, 0]\n",
    "dot.gv": "digraph g { a -> b }",
    "other.svg": "<svg xmlns='x'></svg>",
}
NAMES = {
    "graph.json": "node-link JSON",
    "graph.graphml": "GraphML",
    "grid.map": "MovingAI",
    "places.json": "GeoJSON",
    "picture.png": "PNG picture",
    "picture.jpg": "JPEG picture",
    "grid.pgm": "PGM picture",
    "ros.yaml": "occupancy grid of ROS",
    "dot.gv": "DOT",
    "other.svg": "SVG",
}


MAPS = ("graph.json", "graph.graphml", "grid.map", "ros.yaml")


@pytest.mark.parametrize(
    ("load", "name"),
    [
        (load, name)
        for load in (load_map, load_mission, load_plan)
        for name in OTHERS
        if load is not load_map or name not in MAPS
    ],
)
def test_other_files_are_named_for_what_they_are(tmp_path, load, name):
    content = OTHERS[name]
    path = tmp_path / name
    path.write_bytes(content if isinstance(content, bytes) else content.encode())
    with pytest.raises(InputError) as caught:
        load(path)
    assert len(caught.value.findings) == 1
    assert NAMES[name] in str(caught.value)
    if load is load_mission and name in MAPS:
        assert f"it can be the map of a mission: map: {{file: {name}}}" in str(caught.value)


def test_ours_are_told_apart(tmp_path):
    (tmp_path / "m.yaml").write_text(MISSION.replace("FORMULA", "a"))
    (tmp_path / "map.yaml").write_text("states: {a: {}}\n")
    (tmp_path / "plan.json").write_text('{"format": "tsplan-plan/1", "status": "optimal"}')
    with pytest.raises(MissionError, match=r"this is a map; plan needs a mission that names it"):
        load_mission(tmp_path / "map.yaml")
    with pytest.raises(MissionError, match="this is a plan; name the mission"):
        load_mission(tmp_path / "plan.json")
    with pytest.raises(MapError, match="this is a mission; name the map that it uses"):
        load_map(tmp_path / "m.yaml")
    with pytest.raises(MapError, match="this is a plan; name the map"):
        load_map(tmp_path / "plan.json")
    with pytest.raises(PlanError, match="this is no plan: it is a mission"):
        load_plan(tmp_path / "m.yaml")
    with pytest.raises(PlanError, match="this is no plan: it is a map"):
        load_plan(tmp_path / "map.yaml")
    assert kind_of_data({"states": {}}) == "a map"
    assert kind_of_bytes(b"text") is kind_of_text("a: 1") is None


@pytest.mark.parametrize("load", [read_document, load_map, load_mission, load_plan])
def test_what_is_no_file_is_refused_by_its_kind(tmp_path, load):
    pipe = tmp_path / "pipe"
    os.mkfifo(pipe)
    for path, kind in (("/dev/zero", "a device"), (pipe, "a pipe"), (tmp_path, "a directory")):
        with pytest.raises(InputError, match=f"this is {kind}; name a file"):
            load(path)


def test_a_map_that_is_no_file_is_refused():
    text = MISSION.replace("FORMULA", "a")
    start, stop = text.index("map:"), text.index("team:")
    text = f"{text[:start]}map: /dev/zero\n{text[stop:]}"
    with pytest.raises(MissionError, match="/dev/zero: this is a device; name a file"):
        mission_from_text(text)


def test_files_that_grow_while_they_are_read_are_read_up_to_the_limit(tmp_path, monkeypatch):
    monkeypatch.setattr("tsplan.document.document.LARGEST_FILE", 100)
    path = tmp_path / "m.yaml"
    path.write_text("a: " + "x" * 200)
    real = os.fstat

    def small(descriptor):
        """What `stat` says of a file before it grows."""
        told = list(real(descriptor))
        told[6] = 3
        return os.stat_result(told)

    monkeypatch.setattr("os.fstat", small)
    with pytest.raises(InputError, match="larger than"):
        read_document(path)


def test_plans_of_any_size_are_refused_without_reading_them(tmp_path):
    path = tmp_path / "plan.json"
    with path.open("wb") as file:
        file.write(b'{"format": "tsplan-plan/1"')
        file.truncate(10 * 1024**4)  # a file with a hole, of ten terabytes
    with pytest.raises(PlanError, match="cannot read the plan: larger than 1024 MiB"):
        load_plan(path)


def test_a_folder_that_nobody_may_look_into_is_a_sentence(tmp_path, monkeypatch):
    def refuse(*_args, **_more):
        raise PermissionError(13, "Permission denied")

    monkeypatch.setattr("pathlib.Path.iterdir", refuse)
    with pytest.raises(InputError, match="there is no such file; check the path"):
        read_document(tmp_path / "none.yaml")
    monkeypatch.setattr("os.open", refuse)
    with pytest.raises(InputError, match="cannot be read: Permission denied"):
        read_document(tmp_path / "none.yaml")
    from tsplan.cli.inputs import refuse_place  # noqa: PLC0415  (imported after the change)

    monkeypatch.setattr("pathlib.Path.is_dir", refuse)
    with pytest.raises(InputError, match="cannot write the plan: Permission denied"):
        refuse_place(tmp_path / "plan.json", "the plan")


@pytest.mark.parametrize("load", [read_document, load_plan])
def test_utf_16_is_named(tmp_path, load):
    (tmp_path / "f").write_bytes("a: 1".encode("utf-16"))
    with pytest.raises(InputError, match="not UTF-8 text but UTF-16; save the file as UTF-8"):
        load(tmp_path / "f")
