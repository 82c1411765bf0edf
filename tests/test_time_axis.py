"""One axis of steps for all pictures, and one story between its steps."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest

from tests.legible import assert_legible
from tests.walks import wandering
from tests.yards import bars, yard
from tsplan.draw.row_chart import profile
from tsplan.draw.step_axes import DWELL
from tsplan.draw.timeline_rows import rows_of
from tsplan.draw.tracks import tracks
from tsplan.draw.views import draw_page
from tsplan.ts.builders import grid

pytest.importorskip("matplotlib")


def test_charts_of_a_page_share_one_axis_of_steps():
    mission, plan = yard()
    figure, (_, *charts) = draw_page(plan, mission)
    figure.draw_without_rendering()
    spans = {(round(ax.get_position().x0, 6), round(ax.get_position().x1, 6)) for ax in charts}
    assert len(spans) == 1
    assert len({ax.get_xlim() for ax in charts}) == 1
    assert [bool(ax.get_xlabel()) for ax in charts] == [False, True]
    shown = [[t.label1.get_visible() for t in ax.xaxis.get_major_ticks()] for ax in charts]
    assert not any(shown[0])
    assert all(shown[1])


def test_between_two_steps_all_pictures_say_the_same():
    mission, plan = yard()
    (cart, *_) = tracks(plan, mission)
    _, timeline = plan.plot(mission, view="timeline")
    rows = {row.label: row for row in plan.requirements(mission)}
    places, counts = profile(rows["crop"].counts)  # the cart alone is counted there
    for time in (np.arange(8 * 20) + 0.5) / 20:
        where = cart.at(time, DWELL)
        (bar,) = (
            name for name, begin, end, row in bars(timeline) if row == 0 and begin <= time < end
        )
        assert (bar == "on the way") == (where.share > 0)
        if not where.share:
            assert bar == where.source.state
            there = mission.system.states[bar].labels & {"crop"}
            assert np.interp(time, places, counts) == len(there)


def test_of_many_agents_those_who_never_move_have_one_row():
    system = grid(4, 4, labels={(0, 0): "base"})
    mission, plan = wandering(system, [("a", {"r0c0": 20, "r1c1": 12, "r3c3": 8}, ["see"])], 12)
    idle = [((0, 12, agent.stays[0][2]),) for agent in plan.agents]
    still = tuple(
        agent if n % 4 == 0 else replace(agent, stays=idle[n], heading=None)
        for n, agent in enumerate(plan.agents)
    )
    rows = rows_of(replace(plan, agents=still), tracks(replace(plan, agents=still)))
    assert [row.moves for row in rows] == [True] * (len(rows) - 1) + [False]
    assert rows[-1].name == "30 idle a"
    assert rows[-1].stops[0].state == "15 at r0c0, 9 at r1c1, 6 at r3c3"
    assert sum(row.count for row in rows) == 40
    figure, ax = replace(plan, agents=still).plot(mission, view="timeline")
    assert ax.get_yticklabels()[-1].get_text() == "30 idle a"
    assert_legible(figure)
