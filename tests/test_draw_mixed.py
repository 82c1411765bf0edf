"""Robots and swarms of one plan: every picture, the animation and the page show all of them."""

from __future__ import annotations

import pytest

from tsplan.checking.plan_check import certify
from tsplan.draw.step_axes import DWELL, HALF
from tsplan.draw.tracks import tracks
from tsplan.mission import Mission
from tsplan.plans.moves import Move
from tsplan.plans.outcomes import MissionRef
from tsplan.plans.plan import AgentPlan, Plan
from tsplan.ts import Edge, State, TransitionSystem
from tsplan.viewer.markers import Ground, markers
from tsplan.viewer.page_data import page_data
from tsplan.viewer.positions import with_slots

HOME, REEF, PIER = "home", "reef", "pier"
SYSTEM = TransitionSystem.build(
    [
        State(name, frozenset({name}), at=(4.0 * n, n % 2))
        for n, name in enumerate((HOME, REEF, PIER))
    ],
    [
        *(Edge(name, name) for name in (HOME, REEF, PIER)),
        Edge(HOME, REEF, {"boat": 3, "default": 2}),
        Edge(REEF, HOME, 2),
        Edge(HOME, PIER),
        Edge(PIER, HOME),
    ],
    name="bay",
)
MOVES = (
    Move(0, HOME, HOME, 400),
    Move(0, HOME, REEF, 800),
    Move(1, HOME, HOME, 400),
    Move(2, HOME, HOME, 100),
    Move(2, HOME, REEF, 300),
    Move(2, REEF, REEF, 800),
    Move(3, HOME, HOME, 100),
    Move(3, REEF, REEF, 800),
)
SEEN = {  # how many of each class are at home, at the reef and at the pier, step by step
    "boat": [(1, 0, 1), (1, 0, 1), (2, 0, 0), (1, 0, 0), (1, 0, 0)],
    "drone": [(1200, 0, 0), (400, 0, 0), (400, 800, 0), (100, 800, 0), (100, 1100, 0)],
}


@pytest.fixture(scope="module")
def mission():
    team = [{"class": "boat", "at": {HOME: 1, PIER: 1}, "capabilities": ["boat"]}]
    swarms = [{"name": "drone", "size": 1200, "at": HOME, "max_subswarms": 3}]
    formula = "F[0,4] sum(reef,drone) >= 1000 && F[0,2] sum(home,boat) >= 2"
    return Mission.of(
        map=SYSTEM, team=team, swarms=swarms, formula=formula, language="mtl", name="bay work"
    )


@pytest.fixture(scope="module")
def plan(mission):
    boat = frozenset({"boat"})
    agents = (
        AgentPlan("boat-1", "boat", boat, ((0, 4, HOME),)),
        AgentPlan("boat-2", "boat", boat, ((0, 1, PIER), (2, 2, HOME)), REEF),
    )
    reference = MissionRef(mission.name, mission.digest)
    made = certify(
        mission,
        Plan("feasible", reference, 4, "gap", agents=agents, moves={"drone": MOVES}),
    )
    assert made.verified
    return made


def gids(ax):
    return {artist.get_gid() for artist in ax.get_children()}


def rows(ax):
    return [tick.get_text() for tick in ax.get_yticklabels()]


def test_tracks_are_agents_and_groups_class_by_class(mission, plan):
    found = tracks(plan, mission, moving=True)
    assert [(track.name, track.end) for track in found] == [
        ("boat-1", 5),
        ("boat-2", 5),
        ("drone 1 (400)", 2),
        ("drone 2 (800)", 5),
        ("drone 3 (100)", 5),
        ("drone 4 (300)", 5),
    ]
    assert [list(track.journeys(4)) for track in found[1:4:2]] == [[(1, 2), (2, 5)], [(0, 2)]]
    last = found[1].stops[-1]
    assert (last.state, last.first) == (REEF, 5)


def test_the_page_has_everybody_where_the_plan_does(mission, plan):
    data = page_data(mission, plan)
    assert [(kind["name"], kind["agents"]) for kind in data["classes"]] == [
        ("boat", 2),
        ("drone", 1200),
    ]
    assert [track["ids"] for track in data["tracks"]] == [["boat-1"], ["boat-2"], [], [], [], []]
    found = with_slots(tracks(plan, mission, moving=True))
    ground = Ground(dict.fromkeys(SYSTEM.states, (0.0, 0.0)), radius=2.0, most=4)
    for step in range(5):
        for name, counts in SEEN.items():
            own = [track for track in found if track.class_name == name]
            shown = markers(own, ground, step).counts
            assert tuple(shown[state] for state in SYSTEM.states) == counts[step]


def test_the_map_has_paths_of_robots_and_of_groups(mission, plan):
    pytest.importorskip("matplotlib")
    _, ax = plan.plot(mission)
    assert {"path:boat-2", "path:drone 2 (800)", "path:drone 4 (300)"} <= gids(ax)
    assert sum(artist.get_gid() == "start" for artist in ax.get_children()) == 3
    legend = [text.get_text() for text in ax.get_legend().get_texts()]
    assert legend[:3] == ["boat-2", "drone 2 (800)", "drone 4 (300)"]
    assert "1 never moves" in legend


def bars(ax):
    """What each bar of a timeline means, from when to when it reaches, and its row."""
    return [
        (
            bar.get_gid(),
            round(bar.get_x(), 9),
            round(bar.get_x() + bar.get_width(), 9),
            round(bar.get_y() + bar.get_height() / 2),
        )
        for bar in ax.patches
    ]


def test_the_timeline_has_rows_of_robots_and_of_groups(mission, plan):
    pytest.importorskip("matplotlib")
    _, ax = plan.plot(mission, view="timeline")
    assert rows(ax) == [
        "boat-1",
        "boat-2",
        "drone 1 (400)",
        "drone 2 (800)",
        "drone 3 (100)",
        "drone 4 (300)",
    ]
    found = bars(ax)
    assert ("home", -HALF, 2 - DWELL, 2) in found  # until the group splits
    assert ("reef", 2 - DWELL, 4 + HALF, 3) in found
    assert ("home", 2 - DWELL, 4 + HALF, 4) in found
    assert ("on the way", 2 + DWELL, 4 + HALF, 1) in found


def test_the_flow_has_bands_of_robots_and_of_swarms(mission, plan):
    pytest.importorskip("matplotlib")
    _, ax = plan.plot(mission, view="flow")
    assert {"stays:boat", "moves:boat", "stays:drone", "moves:drone"} <= gids(ax)
    written = {text.get_text() for text in ax.texts}
    assert "1,201" in written  # all at home together, robots and swarm


def test_the_page_of_pictures_and_the_animation_have_all(mission, plan):
    pytest.importorskip("matplotlib")
    from tsplan.draw.views import draw_page  # noqa: PLC0415  (needs matplotlib)
    from tsplan.viewer.scene import Scene  # noqa: PLC0415  (as above)

    _, parts = draw_page(plan, mission)
    assert [ax.get_title(loc="left") for ax in parts] == [
        "bay work: paths",
        "bay work: who is where",
        "bay work: who splits and merges where",
        "bay work: count against need",
    ]
    scene = Scene(mission, plan, (480, 300))
    assert (scene.at(0) != scene.at(3)).any()


def test_a_swarm_without_paths_has_a_timeline_of_its_groups(mission, plan):
    pytest.importorskip("matplotlib")
    alone = Plan("feasible", plan.mission, 4, "gap", moves={"drone": MOVES}, groups=plan.groups)
    _, ax = alone.plot(mission, view="timeline")
    assert rows(ax) == ["drone 1 (400)", "drone 2 (800)", "drone 3 (100)", "drone 4 (300)"]


def test_the_requirements_count_robots_and_swarms(mission, plan):
    counts = {row.label: row.counts.tolist() for row in plan.requirements(mission)}
    assert counts == {REEF: [0, 0, 800, 800, 1100], HOME: [1, 1, 2, 1, 1]}
    rows = {part["heading"]: part for part in page_data(mission, plan)["formula"][1:]}
    assert [part["settled"] for part in rows.values()] == [((4, 1),), ((2, 1),)]
    assert all(part["failed"] is None for part in rows.values())
