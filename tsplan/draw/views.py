"""The views of a plan by name, and all of them on one page."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from types import MappingProxyType
from typing import Any, TypeAlias

from tsplan.checking.fitting import refuse_misfit
from tsplan.draw.canvas import Picture, new_figure
from tsplan.draw.map import height_of as map_height
from tsplan.draw.path_map import draw_paths
from tsplan.draw.policy_map import draw_policy
from tsplan.draw.requirement_chart import draw_requirements
from tsplan.draw.requirement_chart import height_of as chart_height
from tsplan.draw.starts import draw_mission
from tsplan.draw.step_axes import REST
from tsplan.draw.stock_chart import draw_stocks
from tsplan.draw.stock_chart import height_of as stocks_height
from tsplan.draw.swarm_bands import FLOW_HEIGHT, draw_swarm
from tsplan.draw.timeline import draw_timeline
from tsplan.draw.timeline import height_of as timeline_height
from tsplan.draw.tracks import tracks
from tsplan.errors import Finding, InputError, nearest
from tsplan.explanation.why.stock_lines import stock_lines
from tsplan.mission import Mission
from tsplan.plans.plan import Plan

View: TypeAlias = "Callable[[Plan, Mission, Any], Picture]"

WIDTH = 10.0  # inches of a page

VIEWS: Mapping[str, View] = MappingProxyType(
    {
        "paths": draw_paths,
        "timeline": draw_timeline,
        "requirements": draw_requirements,
        "stocks": draw_stocks,
        "flow": draw_swarm,
        "policy": draw_policy,
        "map": lambda _plan, mission, ax: draw_mission(mission, ax),
    }
)
"""Every single picture of a plan."""

PAGE = "page"
"""The name of the view that has the paths, the timeline and the requirements below each other."""


def draw_plan(
    plan: Plan, mission: Mission | None = None, view: str = "", ax: Any = None
) -> Picture:
    """One of the `VIEWS`: the paths unless named; without a mission the timeline, all there is.

    The view `PAGE` is a figure with several axes, for which none can be given. Raises InputError
    for a view that does not exist or needs the mission, and PlanError for a plan without paths or
    of another mission.
    """
    if view == PAGE and ax is not None:
        raise InputError([Finding("a page has axes of its own", "leave out ax")])
    if mission is not None and view == PAGE:
        return draw_page(plan, mission)
    if mission is not None:
        return draw_view(plan, mission, view or ("policy" if plan.policies else "paths"), ax)
    if view not in ("", "timeline"):
        remedy = "give the mission too: plan.plot(mission, ...)"
        raise InputError([Finding(f"the view '{view}' needs the map of the mission", remedy)])
    return draw_timeline(plan, None, ax)


def draw_view(plan: Plan, mission: Mission, view: str, ax: Any = None) -> Picture:
    """One of the `VIEWS`, by name; raises as `draw_plan`."""
    if view not in VIEWS:
        found = Finding(f"there is no view '{view}' of a plan", nearest(view, [*VIEWS, PAGE]))
        raise InputError([found])
    if bool(plan.policies) is not (view == "policy") and view not in ("map", "requirements"):
        what = "a plan of policies has no" if plan.policies else "the plan has no policy, nor a"
        remedy = f"look at its {'policy' if plan.policies else 'paths'} or requirements"
        raise InputError([Finding(f"{what} {view}", remedy)])
    return VIEWS[view](plan, mission, ax)


def draw_page(plan: Plan, mission: Mission, figure: Any = None) -> tuple[Any, tuple[Any, ...]]:
    """Paths, timeline, requirements and stocks on one page: the figure and its axes.

    Swarms without paths of single agents have their flow, and the map where there are no paths.
    A given `figure` is drawn on as it is; it should be about as large as `page_size`.
    """
    refuse_misfit(plan, mission)
    heights = _heights(plan, mission)
    whole = figure if figure is not None else new_figure(*page_size(plan, mission))
    parts = whole.subfigures(len(heights), 1, height_ratios=list(heights.values()))
    every = [part.add_subplot() for part in parts]
    for view, ax in zip(heights, every, strict=True):
        VIEWS[view](plan, mission, ax)
    return whole, tuple(every)


def page_size(plan: Plan, mission: Mission) -> tuple[float, float]:
    """Inches across and down of the page of a plan."""
    return WIDTH, sum(_heights(plan, mission).values())


def _heights(plan: Plan, mission: Mission) -> dict[str, float]:
    """The views on the page, each with the inches it takes."""
    first = "paths" if plan.agents else "policy" if plan.policies else "map"
    mapped = {first: map_height(mission.system)}
    moving = tracks(plan, mission, modules=True)
    timed = {"timeline": timeline_height(plan, moving) + REST} if plan.agents else {}
    grouped = any(not track.ids for track in moving)
    flowing = {"flow": FLOW_HEIGHT + REST} if grouped else {}
    charted = {"requirements": chart_height(plan.requirements(mission)) + REST}
    lying = [line for line in stock_lines(plan, mission) if line.moves]
    stocked = {"stocks": stocks_height(lying) + REST} if lying else {}
    return mapped | timed | flowing | charted | stocked
