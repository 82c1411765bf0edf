"""Documents: what scalars mean, bounds, and the place of everything."""

import hashlib
import json
from typing import Annotated, Literal

import pytest
from hypothesis import given
from hypothesis import strategies as st
from pydantic import AfterValidator, BaseModel, ConfigDict, Field

from tests.missions import findings
from tests.seeds import quick
from tsplan.document import parse_document, read_document, validated
from tsplan.document.compose import DEEPEST
from tsplan.document.document import LARGEST_FILE
from tsplan.document.fields import Positive, Word, Words
from tsplan.errors import InputError


def wrong(text):
    return findings(parse_document, text, "f.yaml")


@pytest.mark.parametrize(
    ("text", "value"),
    [
        ("NO", "NO"),
        ("on", "on"),
        ("yes", "yes"),
        ("1:30", "1:30"),
        ("true", True),
        ("False", False),
        ("TRUE", "TRUE"),
        ("~", None),
        ("", None),
        ("12", 12),
        ("-3", -3),
        ("010", 10),
        ("0x1F", 31),
        ("0o17", 15),
        ("1_000", "1_000"),
        ("1.5", 1.5),
        ("1e3", 1000.0),
        (".5", 0.5),
        ("-.inf", float("-inf")),
        ("'12'", "12"),
        ("!!str 12", "12"),
        ("!!float 3", 3.0),
        ("2024-01-01", "2024-01-01"),
        ("9" * 5000, "9" * 5000),
        (".", "."),
        ("-", [None]),
    ],
)
def test_what_a_scalar_means(text, value):
    assert parse_document(text, "f").data == value
    assert type(parse_document(text, "f").data) is type(value)


def test_keys_are_the_text_of_keys():
    document = parse_document("1: a\n01: b\n~: c\n[x, 2]: d\n", "f")
    assert document.data == {"1": "a", "01": "b", "~": "c", "(x, 2)": "d"}


def test_text_is_as_written():
    document = parse_document("a: [01, x]", "f")
    assert document.text(("a", 0)) == "01"
    assert document.text(("a",)) is None


def test_places_from_one():
    document = parse_document("a:\n  - é: x\n    b: [1, {c: 2}]\n", "f")
    assert document.place(()) == (1, 1)
    assert document.place(("a", 0, "b", 1, "c")) == (3, 16)
    assert document.place(("a", 0, "é")) == (2, 8)
    assert document.key_place(("a", 0, "b")) == (3, 5)
    assert document.place(("a", 0, "nowhere", 7)) == document.place(("a", 0))
    assert document.place(("a", 0, "b", 0)) == (3, 9)
    assert str(document.finding(("a", 0, "é"), "no", "fix")) == "f:2:8: no; fix"


def test_digest_is_that_of_the_text():
    assert parse_document("a: 1\n", "f").digest == hashlib.sha256(b"a: 1\n").hexdigest()


def test_every_duplicate_key_is_found():
    assert wrong("a: 1\nb: {c: 1, c: 2}\na: 3\n") == [
        "f.yaml:2:11: the key 'c' appears twice, first in line 2; keep one of them",
        "f.yaml:3:1: the key 'a' appears twice, first in line 1; keep one of them",
    ]


@pytest.mark.parametrize(
    "tag", ["!!python/object/apply:os.system", "!!python/name:os.system", "!!binary", "!Mine"]
)
def test_tags_never_run_code(tag):
    [finding] = wrong(f"a: {tag} [x]")
    assert finding.startswith("f.yaml:1:4: the tag '")


def test_nesting_is_bounded():
    depth = DEEPEST - 1
    assert parse_document("[" * depth + "]" * depth, "f").data
    for text in ("[" * 100 + "]" * 100, "{a: " * 100 + "1" + "}" * 100, "[" * 100_000):
        [finding] = wrong(text)
        assert "nested deeper than 50 levels" in finding


def test_aliases_are_bounded():
    lines = ["a0: &a0 [x, x, x, x, x, x, x, x, x, x]"]
    lines += [f"a{n + 1}: &a{n + 1} [{', '.join([f'*a{n}'] * 10)}]" for n in range(9)]
    [finding] = wrong("\n".join(lines))
    assert "aliases multiply" in finding
    assert parse_document("a: &x [1]\nb: *x\n", "f").data == {"a": [1], "b": [1]}


def test_an_alias_cannot_contain_itself():
    assert "contains itself" in wrong("&a [*a]")[0]
    assert "refers to nothing" in wrong("[*a]")[0]


def test_syntax_errors_have_a_place():
    [finding] = wrong("a: 1\nb: c: d\n")
    assert finding.startswith("f.yaml:2:5: not valid YAML: ")
    assert wrong("a: \x01")[0].startswith("f.yaml:1:4: the character U+0001")
    assert "more than one document" in wrong("a\n---\nb")[0]


def test_sets_and_tuples_are_lists():
    document = parse_document("a: !!set {x, y}\nb: !!python/tuple [1, 2]\n", "f")
    assert document.data == {"a": ["x", "y"], "b": [1, 2]}
    assert document.node(("b",)).tag == "tag:yaml.org,2002:python/tuple"
    assert document.place(("a", 1)) == (1, 14)


def test_files_that_cannot_be_read(tmp_path):
    (tmp_path / "farm.yaml").write_bytes(b"a: 1\nb: caf\xe9\n")
    with pytest.raises(InputError, match=r"farm\.yaml:2:7: not UTF-8 text"):
        read_document(tmp_path / "farm.yaml")
    with pytest.raises(InputError, match=r"there is no such file; did you mean .*farm\.yaml"):
        read_document(tmp_path / "fram.yaml")
    with pytest.raises(InputError, match="there is no such file; check the path"):
        read_document(tmp_path / "nowhere" / "x.yaml")
    with pytest.raises(InputError, match="this is a directory"):
        read_document(tmp_path)
    with pytest.raises(InputError, match="cannot be read"):
        read_document("a\0b")
    with (tmp_path / "large.yaml").open("wb") as file:
        file.truncate(LARGEST_FILE + 1)
    with pytest.raises(InputError, match="larger than 64 MiB"):
        read_document(tmp_path / "large.yaml")


def test_a_byte_order_mark_is_no_content(tmp_path):
    (tmp_path / "f.yaml").write_bytes(b"\xef\xbb\xbfa: 1\n")
    document = read_document(tmp_path / "f.yaml")
    assert document.data == {"a": 1}
    assert document.place(("a",)) == (1, 4)


FORMULAS = {
    "literal": "f: |\n    F[0,3] a\n      && b\n",
    "folded": "f: >-\n  F[0,3] a\n  && b\n",
    "plain": "x: 1\nf: F[0,3] a\n  && b\n",
    "quoted": "f: 'F[0,3] a\n  && b'\n",
    "double": 'f: "F[0,3] a && b"\n',
    "commented": "f: |  # words\n\n  F[0,3] a\n  && b\n",
    "beside emoji": "😀: 1\nf: F[0,3] é😀a && b\n",
}


@pytest.mark.parametrize("style", FORMULAS)
def test_places_inside_a_scalar(style):
    text = FORMULAS[style]
    document = parse_document(text, "f")
    value, lines = document.data["f"], text.split("\n")
    for number, part in enumerate(value.split("\n"), start=1):
        for column, char in enumerate(part, start=1):
            if not char.isspace():
                line, at = document.inside(("f",), number, column)
                assert lines[line - 1][at - 1] == char
    first = document.inside(("f",), 1, 1)
    if style != "commented":
        assert lines[first[0] - 1][first[1] - 1] == "F"


def test_a_place_behind_the_text_of_a_scalar():
    assert parse_document("f: 'F a'", "f").inside(("f",), 1, 4) == (1, 8)
    assert parse_document("f: |\n  F a\n", "f").inside(("f",), 1, 4) == (2, 6)
    assert parse_document("f: ''", "f").inside(("f",), 1, 1) == (1, 5)


class Robot(BaseModel):
    model_config = ConfigDict(extra="forbid")
    name: Word
    count: Positive = 1
    skills: Words = []


class Team(BaseModel):
    model_config = ConfigDict(extra="forbid")
    robots: list[Robot]
    leader: Robot | None = None


def test_schemas_give_findings_with_places():
    document = parse_document(
        "robots:\n"
        "  - {name: 1, count: 2.0}\n"
        "  - {nam: a, count: 0, skills: x}\n"
        "  - {name: b, count: true, skills: [a, 2]}\n"
        "  - 7\n"
        "leader: {name: c, skils: []}\n",
        "t.yaml",
    )
    team, found = validated(document, Team)
    assert team is None
    assert [str(item) for item in found] == [
        "t.yaml:2:12: name: '1' is not text; put it in quotes",
        "t.yaml:3:5: 'name' is missing; add 'name: ...'",
        (
            "t.yaml:3:21: count: '0' should be greater than or equal to 1; "
            "use a number that is at least 1"
        ),
        "t.yaml:3:32: skills: 'x' is not a list; write it as [a, b]",
        "t.yaml:3:6: unknown key 'nam'; did you mean 'name'?",
        "t.yaml:4:22: count: 'true' is not a whole number; write one, as in 3",
        "t.yaml:4:40: skills: '2' is not text; put it in quotes",
        "t.yaml:5:5: robots: '7' is not a mapping; write it as {key: value}",
        "t.yaml:6:19: unknown key 'skils'; did you mean 'skills'?",
    ]


def test_schemas_give_the_model():
    document = parse_document("x: {robots: [{name: a, count: 2.0}]}", "t")
    team, found = validated(document, Team, ("x",))
    assert not found
    assert team == Team(robots=[Robot(name="a", count=2)])


@quick
@given(st.text())
def test_any_text_is_a_document_or_an_input_error(text):
    try:
        parse_document(text, "f")
    except InputError as error:
        assert error.findings  # noqa: PT017 - either outcome is right


@quick
@given(
    st.recursive(
        st.none() | st.booleans() | st.integers(-999, 999) | st.text("ab 1:", max_size=5),
        lambda inner: (
            st.lists(inner, max_size=3)
            | st.dictionaries(st.text("abc", min_size=1, max_size=3), inner, max_size=3)
        ),
        max_leaves=20,
    )
)
def test_json_is_read_as_it_is(value):
    document = parse_document(json.dumps(value), "f")
    assert document.data == value
    assert all(document.at(path) == part for path, part in parts(value))


def parts(value, path=()):
    """Every part of a value with its path."""
    yield path, value
    if isinstance(value, list | dict):
        for step, part in value.items() if isinstance(value, dict) else enumerate(value):
            yield from parts(part, (*path, step))


def test_no_word_of_the_library_is_in_a_finding():
    class Schema(BaseModel):
        model_config = ConfigDict(extra="forbid")

        least: Annotated[float, Field(ge=1)]
        most: Annotated[int, Field(lt=5)]
        choice: Literal["one", "two"]
        own: Annotated[int, AfterValidator(_odd)]
        words: Words

    document = parse_document("{least: 0.5, most: 5, choice: three, own: 2, words: [1]}", "t")
    _, found = validated(document, Schema)
    assert [str(finding).split(": ", 1)[1] for finding in found] == [
        "least: '0.5' should be greater than or equal to 1.0; use a number that is at least 1.0",
        "most: '5' should be less than 5; use a number that is less than 5",
        "choice: 'three' should be 'one' or 'two'; use one of 'one' or 'two'",
        "own: it has to be odd",
        "words: '1' is not text; put it in quotes",
    ]


def _odd(value):
    if value % 2 == 0:
        raise ValueError("It has to be odd")
    return value
