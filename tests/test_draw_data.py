"""Places and paints: what pictures are made from, without matplotlib."""

from __future__ import annotations

import math
from itertools import combinations

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from tests.command_line import printed
from tests.seeds import quick, sampled
from tsplan.draw.colours import NAMED, colour_of, ink_on, lightness, mixed, rgb
from tsplan.draw.edge_layout import MOST_SPRINGS, spacing
from tsplan.draw.layout import places
from tsplan.draw.palette import HATCHES, HUES, PLAIN, TRAVEL, Palette, paints
from tsplan.ts import Edge, State, TransitionSystem
from tsplan.ts.builders import grid
from tsplan.ts.state_places import centroid


def bare(system):
    """The same map without coordinates."""
    states = [State(state.name, state.labels) for state in system.states.values()]
    return TransitionSystem.build(states, system.edges.values())


def test_nothing_here_needs_matplotlib():
    code = (
        "import sys, tsplan, tsplan.draw.layout, tsplan.draw.palette, "
        "tsplan.explanation.why.witness_tree,"
        "tsplan.explanation.why.requirements; print('matplotlib' in sys.modules)"
    )
    assert printed(code) == "False\n"


def test_own_coordinates_win_over_shapes():
    square = ((0, 0), (4, 0), (4, 2), (0, 2))
    system = TransitionSystem.build(
        [State("p", at=(9, 9), shape=square), State("q", shape=square)], []
    )
    assert places(system) == {"p": (9.0, 9.0), "q": (2.0, 1.0)}


def test_the_centre_of_an_area_is_not_the_mean_of_its_corners():
    # an L: two squares, each with its own centre; the corners alone would give (1.17, 1.17)
    ell = [(0, 0), (3, 0), (3, 1), (1, 1), (1, 3), (0, 3)]
    assert centroid(ell) == pytest.approx((1.1, 1.1))
    assert centroid(ell[::-1]) == pytest.approx((1.1, 1.1))
    assert centroid([(0, 0), (2, 2), (4, 4)]) == pytest.approx((2, 2))
    assert centroid([(1, 5)]) == (1, 5)


@pytest.mark.parametrize("size", sampled([(2, 2), (5, 5), (13, 13), (50, 50)], [(2, 2), (13, 13)]))
def test_grids_without_coordinates_are_laid_out_as_grids(size):
    system = bare(grid(*size))
    assert (len(system.states) > MOST_SPRINGS) == (size[0] >= 13)
    found = places(system)
    assert list(found) == list(system.states)
    assert found == places(bare(grid(*size)))
    lengths = [math.dist(found[s], found[t]) for s, t in system.edges if s != t]
    corners = [math.dist(found["r0c0"], found[f"r{size[0] - 1}c{size[1] - 1}"])]
    # neighbours stay together, and opposite corners apart
    assert max(lengths) < 3 * np.median(lengths)
    assert max(corners) > 0.9 * (size[0] - 1) * np.median(lengths)


def test_separate_parts_do_not_overlap():
    states = [State(name) for name in "abcdefg"]
    edges = [Edge("a", "b"), Edge("b", "c"), Edge("c", "a"), Edge("d", "e")]
    found = places(TransitionSystem.build(states, edges))
    boxes = []
    for part in ("abc", "de", "f", "g"):
        points = np.array([found[name] for name in part])
        boxes.append((points.min(axis=0) - 0.1, points.max(axis=0) + 0.1))
    for (low, high), (low2, high2) in combinations(boxes, 2):
        assert (high < low2).any() or (high2 < low).any()


def test_states_without_coordinates_go_to_their_neighbours():
    states = [State(f"s{n}", at=(10.0 * n, 0.0)) for n in range(5)] + [State("x"), State("y")]
    edges = [Edge("x", "s4"), Edge("y", "s0"), Edge("s0", "s1")]
    found = places(TransitionSystem.build(states, edges))
    assert all(found[f"s{n}"] == (10 * n, 0) for n in range(5))
    assert math.dist(found["x"], found["s4"]) < math.dist(found["x"], found["s2"])
    assert math.dist(found["y"], found["s0"]) < math.dist(found["y"], found["s2"])
    assert spacing(found) > 1


def test_one_state_and_states_on_one_spot():
    assert set(places(TransitionSystem.build([State("p")], []))) == {"p"}
    assert spacing({"p": (1, 1), "q": (1, 1)}) == 1


def seen(colours, kind):
    """Colours in CIELAB as people with a colour-vision deficiency see them (Machado 2009)."""
    matrices = {
        "normal": np.eye(3),
        "protanopia": [
            [0.152286, 1.052583, -0.204868],
            [0.114503, 0.786281, 0.099216],
            [-0.003882, -0.048116, 1.051998],
        ],
        "deuteranopia": [
            [0.367322, 0.860646, -0.227968],
            [0.280085, 0.672501, 0.047413],
            [-0.011820, 0.042940, 0.968881],
        ],
        "tritanopia": [
            [1.255528, -0.076749, -0.178779],
            [-0.078411, 0.930809, 0.147602],
            [0.004733, 0.691367, 0.303900],
        ],
    }
    parts = np.array([rgb(colour) for colour in colours]) / 255
    linear = np.where(parts <= 0.04045, parts / 12.92, ((parts + 0.055) / 1.055) ** 2.4)
    linear = np.clip(linear @ np.array(matrices[kind]).T, 0, 1)
    to_xyz = np.array(
        [
            [0.4124564, 0.3575761, 0.1804375],
            [0.2126729, 0.7151522, 0.0721750],
            [0.0193339, 0.1191920, 0.9503041],
        ]
    )
    xyz = linear @ to_xyz.T / to_xyz.sum(axis=1)
    root = np.where(xyz > 216 / 24389, np.cbrt(xyz), (24389 / 27 * xyz + 16) / 116)
    x, y, z = root.T
    return np.stack([116 * y - 16, 500 * (x - y), 200 * (y - z)], axis=1)


@pytest.mark.parametrize("kind", ["normal", "protanopia", "deuteranopia", "tritanopia"])
def test_every_two_hues_differ_for_everybody(kind):
    for one, other in combinations(seen(HUES, kind), 2):
        assert np.linalg.norm(one - other) >= 25


def test_every_two_hues_differ_in_grey():
    shades = sorted(lightness(hue) for hue in HUES)
    assert min(np.diff(shades)) >= 7
    # and those given out one after the other twice as much
    given_out = [lightness(hue) for hue in HUES]
    assert min(np.abs(np.diff(given_out))) >= 15


@quick
@given(st.lists(st.text(min_size=1), max_size=60))
def test_paints_are_distinct_and_always_the_same(names):
    given_out = paints(names)
    assert set(given_out) == set(names)
    assert paints(names) == given_out
    first = list(given_out.values())[: len(HUES) * len(HATCHES)]
    assert len(set(first)) == len(first)
    assert TRAVEL not in first
    assert PLAIN not in first


def test_states_are_painted_as_the_map_says():
    states = [
        State("a", frozenset({"crop"})),
        State("b", frozenset({"crop"})),
        State("c", frozenset({"shop"})),
        State("d"),
        State("e", frozenset({"crop"}), color="tan"),
        State("f", frozenset({"lime", "road"})),
        State("g", frozenset({"x"}), color="url(javascript:alert(1))"),
    ]
    system = TransitionSystem.build(states, [])
    painted = Palette(system, ("scout", "heavy")).states
    assert painted["a"] == painted["b"] != painted["c"]
    assert painted["d"] == PLAIN
    assert painted["e"].colour == "#d2b48c"
    assert painted["f"].colour == "#00ff00"
    assert painted["g"].colour in HUES
    labels = Palette(system).labels
    assert labels["shop"] == painted["c"]
    assert labels["crop"] == painted["a"]
    assert set(labels) == set(system.labels)


def test_colour_words():
    assert len(NAMED) == 148
    assert colour_of("RebeccaPurple") == "#663399"
    assert colour_of("#ABC") == "#aabbcc"
    assert colour_of(" #a0b1c2 ") == "#a0b1c2"
    for word in (None, "", "b", "#12", "#gggggg", "red;background:url(x)", "</style>"):
        assert colour_of(word) is None


@quick
@given(st.sampled_from(sorted(NAMED.values())))
def test_text_on_a_colour_can_be_read(colour):
    assert abs(lightness(ink_on(colour)) - lightness(colour)) >= 40
    assert mixed(colour, "#ffffff", 0) == colour
    assert mixed(colour, "#123456", 1) == "#123456"
