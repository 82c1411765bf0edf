"""Names and numbers as they are shown: nothing hidden, nothing lost."""

from __future__ import annotations

import math

import pytest

from tsplan.words import known, number, visible


@pytest.mark.parametrize(
    ("value", "text"),
    [
        (10000009.0, "10,000,009"),
        (10000009.25, "10,000,009.25"),
        (999.999, "999.999"),
        (-10000009.5, "-10,000,009.5"),
        (5 / 6, "0.833333"),
        (1e-7, "1e-07"),
        (-0.0, "0"),
        (1e300, "1e+300"),
        (math.inf, "open"),
        (-math.inf, "open"),
        (math.nan, "unknown"),
        (None, "open"),
    ],
)
def test_numbers_keep_their_digits(value, text):
    assert number(value) == text


@pytest.mark.parametrize(
    ("text", "shown"),
    [
        ("仓库 é :car:", "仓库 é :car:"),
        ("\x1b[31mred\x07", "\\x1b[31mred\\x07"),
        ("a\nb\tc", "a\\nb\\tc"),
        ("\u202eevil\u2028", "\\u202eevil\\u2028"),
        ("\x9b1m\x7f", "\\x9b1m\\x7f"),
        ("half\udcff", "half\\udcff"),
        ("\u0645\u06cc\u200c\u062e", "\u0645\u06cc\u200c\u062e"),  # Persian, with a joiner
    ],
)
def test_what_cannot_be_seen_is_escaped(text, shown):
    assert visible(text) == shown
    assert visible(shown) == shown


def test_what_is_infinite_is_not_known():
    assert [known(value) for value in (1.5, math.inf, -math.inf, math.nan, None)] == [
        1.5,
        *[None] * 4,
    ]
