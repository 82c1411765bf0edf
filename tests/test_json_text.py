"""JSON is read by its own rules, with the places and meanings of YAML."""

from __future__ import annotations

import json

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from tsplan.document import parse_document
from tsplan.document.compose import compose
from tsplan.document.json_text import json_nodes, may_be_json
from tsplan.errors import InputError

TEXTS = st.text(st.characters(codec="utf-8", exclude_categories=["Cc", "Cs"]), max_size=8)
VALUES = st.recursive(
    st.none() | st.booleans() | st.integers(-(10**20), 10**20) | st.floats(-1e9, 1e9) | TEXTS,
    lambda below: st.lists(below, max_size=4) | st.dictionaries(TEXTS, below, max_size=4),
    max_leaves=12,
)


def outline(node):
    """Values and places of all nodes."""
    below = node.children
    if isinstance(below, dict):
        below = [below[key] for key in below]
    own = (node.line, node.column, node.start, node.end, node.size, node.text, node.keys)
    return node.value, own, [outline(child) for child in below or ()]


@settings(max_examples=25, deadline=None)
@given(st.dictionaries(TEXTS, VALUES, min_size=1, max_size=4), st.sampled_from([None, 1, 3]))
def test_json_is_read_as_yaml_reads_it(value, indent):
    text = json.dumps(value, indent=indent, ensure_ascii=False)
    assert may_be_json(text)
    assert outline(json_nodes(text, "f")) == outline(compose(text, "f"))


@settings(max_examples=15, deadline=None)
@given(st.dictionaries(TEXTS, VALUES, min_size=1, max_size=4))
def test_tabs_and_escapes_change_nothing(value):
    plain = parse_document(json.dumps(value, ensure_ascii=False), "f").data
    tabbed = parse_document(json.dumps(value, indent="\t"), "f")
    assert tabbed.data == plain


def test_places_are_those_in_the_text():
    document = parse_document('{"a": [1,\n\t{"b":\ttrue}]}', "f.json")
    assert document.place(("a", 1, "b")) == (2, 8)
    assert document.key_place(("a", 1, "b")) == (2, 3)
    assert document.text(("a", 0)) == "1"
    assert document.content[slice(*document.span(("a", 1)))] == '{"b":\ttrue}'


@pytest.mark.parametrize(
    ("text", "words"),
    [
        ('{"a": 1,\n "b" 2}', "f:2:6: not valid JSON: ':' is expected"),
        ('{"a": ["1" 2]}', "f:1:12: not valid JSON: ',' or ']' is expected"),
        ('{"a": [{"b": [}]}', "f:1:15: not valid JSON: a value is expected"),
        ('{"a": "x', "f:1:7: not valid JSON: unterminated string"),
        ('{"a": 1} {"b": 2}', "f:1:10: not valid JSON: the text goes on after its end"),
        ('{"a": 1, "b": 2, "a": 3}', "f:1:18: the key 'a' appears twice, first in line 1"),
        ('{"a": ' + "[" * 60 + "]" * 60 + "}", "nested deeper than 50 levels"),
    ],
)
def test_what_is_wrong_is_told_at_its_place(text, words):
    with pytest.raises(InputError) as caught:
        parse_document(text, "f")
    assert words in str(caught.value)


def test_what_is_yaml_but_no_json_is_still_read():
    assert parse_document('{"a": b, "c": .5}', "f").data == {"a": "b", "c": 0.5}
    assert parse_document('{"a": 1} # a remark', "f").data == {"a": 1}
    assert parse_document("{a: [1, 2]}", "f").data == {"a": [1, 2]}
    assert parse_document('["a", NaN]', "f").data == ["a", "NaN"]
    assert parse_document('\ufeff{"a": "\\ud83d\\ude00"}', "f").data == {"a": "\U0001f600"}
