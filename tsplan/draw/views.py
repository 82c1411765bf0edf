"""The views of a plan by name, and all of them on one page."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Mapping
from types import MappingProxyType
from typing import Any, TypeAlias

from tsplan.checking.fitting import refuse_misfit
from tsplan.draw.canvas import Picture, new_figure, settle
from tsplan.draw.focus import WHOLE, Focus
from tsplan.draw.map import height_of as map_height
from tsplan.draw.night import darkened
from tsplan.draw.path_map import draw_paths
from tsplan.draw.policy_map import draw_policy
from tsplan.draw.requirement_chart import draw_requirements, prepare_requirements
from tsplan.draw.requirement_chart import height_of as chart_height
from tsplan.draw.starts import draw_mission
from tsplan.draw.step_axes import TITLE, Prepared, share_steps
from tsplan.draw.stock_chart import draw_stocks, lines_of, prepare_stocks
from tsplan.draw.stock_chart import height_of as stocks_height
from tsplan.draw.swarm_bands import FLOW_HEIGHT, draw_swarm, prepare_swarm
from tsplan.draw.timeline import draw_timeline, prepare_timeline
from tsplan.draw.timeline import height_of as timeline_height
from tsplan.draw.tracks import tracks
from tsplan.errors import Finding, InputError, nearest
from tsplan.mission import Mission
from tsplan.plans.plan import Plan

View: TypeAlias = "Callable[[Plan, Mission, Any, Focus], Picture]"

WIDTH = 10.0  # inches of a page

VIEWS: Mapping[str, View] = MappingProxyType(
    {
        "paths": draw_paths,
        "timeline": draw_timeline,
        "requirements": draw_requirements,
        "stocks": draw_stocks,
        "flow": draw_swarm,
        "policy": lambda plan, mission, ax, _focus: draw_policy(plan, mission, ax),
        "map": lambda _plan, mission, ax, _focus: draw_mission(mission, ax),
    }
)
"""Every single picture of a plan."""

_CHARTS: Mapping[str, Callable[[Plan, Mission, Any, Focus], Prepared]] = MappingProxyType(
    {
        "timeline": prepare_timeline,
        "flow": prepare_swarm,
        "requirements": prepare_requirements,
        "stocks": prepare_stocks,
    }
)
"""The views over time, which share its axis on a page."""

PAGE = "page"
"""The name of the view that has the paths, the timeline and the requirements below each other."""


def draw_plan(
    plan: Plan,
    mission: Mission | None = None,
    view: str = "",
    ax: Any = None,
    *,
    step: float | None = None,
    agents: str | Iterable[str] = (),
    executed: Plan | None = None,
    dark: bool = False,
    size: tuple[float, float] | None = None,
) -> Picture:
    """One of the `VIEWS`: the paths unless named; without a mission the timeline, all there is.

    `step` is a moment to look at, between 0 and the horizon: badges on the map say who is where,
    and a line goes through the charts. `agents` are ids, or names of classes, whose paths and rows
    are drawn. `executed` is what really happened, as another plan of the mission, beside which what
    was planned is pale. `dark` paints on a dark ground, `size` is in inches, across and down.

    The view `PAGE` is a figure with several axes, for which none can be given. Raises InputError
    for a view that does not exist or needs the mission, and for a step or an agent that the plan
    does not have, and PlanError for a plan without paths or of another mission.
    """
    focus = Focus.of(step, agents, executed)
    if ax is not None and (view == PAGE or dark or size is not None):
        what = "a page has axes of its own" if view == PAGE else "dark and size are of a figure"
        raise InputError([Finding(what, "leave out ax")])
    figure = new_figure(*size) if size is not None else None
    drawn = _drawn(plan, mission, view, (figure, ax), focus)
    if dark:
        darkened(drawn[0])
    return drawn


def _drawn(
    plan: Plan, mission: Mission | None, view: str, on: tuple[Any, Any], focus: Focus
) -> Picture:
    """A view on a given figure or axes, or on a figure of its own."""
    figure, ax = on
    if mission is not None and view == PAGE:
        return draw_page(plan, mission, figure, focus)
    if mission is None and view not in ("", "timeline"):
        remedy = "give the mission too: plan.plot(mission, ...)"
        raise InputError([Finding(f"the view '{view}' needs the map of the mission", remedy)])
    ax = ax if figure is None else figure.add_subplot()
    if mission is not None:
        return draw_view(plan, mission, view or ("policy" if plan.policies else "paths"), ax, focus)
    focus.refuse_beyond(plan)
    return draw_timeline(plan, None, ax, focus)


def draw_view(
    plan: Plan, mission: Mission, view: str, ax: Any = None, focus: Focus = WHOLE
) -> Picture:
    """One of the `VIEWS`, by name; raises as `draw_plan`."""
    if view not in VIEWS:
        found = Finding(f"there is no view '{view}' of a plan", nearest(view, [*VIEWS, PAGE]))
        raise InputError([found])
    if bool(plan.policies) is not (view == "policy") and view not in ("map", "requirements"):
        what = "a plan of policies has no" if plan.policies else "the plan has no policy, nor a"
        remedy = f"look at its {'policy' if plan.policies else 'paths'} or requirements"
        raise InputError([Finding(f"{what} {view}", remedy)])
    focus.refuse_beyond(plan)
    return VIEWS[view](plan, mission, ax, focus)


def draw_page(
    plan: Plan, mission: Mission, figure: Any = None, focus: Focus = WHOLE
) -> tuple[Any, tuple[Any, ...]]:
    """Paths, timeline, requirements and stocks on one page: the figure and its axes.

    All that goes over time has one axis of steps, below the last. Swarms without paths of single
    agents have their flow, and the map where there are no paths. A given `figure` is drawn on as it
    is; it should be about as large as `page_size`. Raises as `draw_plan`.
    """
    refuse_misfit(plan, mission)
    focus.refuse_beyond(plan)
    heights = _heights(plan, mission, focus)
    (first, tall), *timed = heights.items()
    whole = figure if figure is not None else new_figure(*page_size(plan, mission, focus))
    shares = [tall, sum(height for _, height in timed)]
    above, below = whole.subfigures(2, 1, height_ratios=shares) if timed else (whole, None)
    _, mapped = VIEWS[first](plan, mission, above.add_subplot(), focus)
    if below is None:
        return whole, (mapped,)
    style = {"height_ratios": [height for _, height in timed]}
    grid = below.subplots(len(timed), 1, sharex=True, squeeze=False, gridspec_kw=style)[:, 0]
    fills = [
        _CHARTS[view](plan, mission, ax, focus)[1]
        for (view, _), ax in zip(timed, grid, strict=True)
    ]
    share_steps(grid)
    settle(whole)
    for fill in fills:
        fill()
    return whole, (mapped, *grid)


def page_size(plan: Plan, mission: Mission, focus: Focus = WHOLE) -> tuple[float, float]:
    """Inches across and down of the page of a plan."""
    return WIDTH, sum(_heights(plan, mission, focus).values())


def _heights(plan: Plan, mission: Mission, focus: Focus) -> dict[str, float]:
    """The views on the page, each with the inches it takes."""
    first = "paths" if plan.agents else "policy" if plan.policies else "map"
    mapped = {first: map_height(mission.system)}
    moving = tracks(plan, mission, modules=True)
    timed = {"timeline": timeline_height(plan, mission, focus) + TITLE} if plan.agents else {}
    grouped = any(not track.ids for track in moving)
    flowing = {"flow": FLOW_HEIGHT + TITLE} if grouped else {}
    charted = {"requirements": chart_height(plan.requirements(mission)) + TITLE}
    lying = lines_of(plan, mission, focus)[0]
    stocked = {"stocks": stocks_height(lying) + TITLE} if lying else {}
    return mapped | timed | flowing | charted | stocked
