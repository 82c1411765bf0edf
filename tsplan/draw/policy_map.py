"""Policies on the map: which actions are taken how often, and how many agents end where."""

from __future__ import annotations

import math
from collections import defaultdict
from collections.abc import Mapping
from typing import Any, TypeAlias

from tsplan.checking.fitting import refuse_misfit
from tsplan.draw import canvas
from tsplan.draw.canvas import SMALL, Entry, Picture
from tsplan.draw.map import DrawnMap, arrow_heads, base, finish
from tsplan.draw.palette import Palette
from tsplan.draw.starts import draw_starts
from tsplan.mission import Mission
from tsplan.plans.plan import Plan
from tsplan.plans.policies import Policy
from tsplan.ts.edges import Pair
from tsplan.words import number

_LEAST = 0.01  # of an agent: actions that are taken more rarely are not drawn
_THICK = 1.6  # points of an arrow for one agent
_HEAD = 7.0  # points of the head of an arrow

Uses: TypeAlias = Mapping[Pair, float]
"""How many agents are expected to take an action from a state towards another, over all steps."""


def draw_policy(plan: Plan, mission: Mission, ax: Any = None) -> Picture:
    """Arrows from each state to where its actions lead most likely, as wide as these are frequent.

    At each state stands how many agents are expected there at the end. Raises PlanError for a plan
    of another mission.
    """
    refuse_misfit(plan, mission)
    palette = Palette.of(mission)
    entries = [
        Entry.line(
            f"actions of {policy.class_name} ({number(round(policy.agents))} agents)",
            color=palette.classes[policy.class_name].colour,
            linewidth=2.0,
        )
        for policy in plan.policies
    ]
    drawn = base(palette, ax, [*entries, Entry.nothing("numbers: agents expected at the end")])
    draw_starts(drawn, mission, {})
    for policy in plan.policies:
        _draw_uses(drawn, uses_of(policy, mission), palette.classes[policy.class_name].colour)
    _write_numbers(drawn, plan)
    return finish(drawn, f"{plan.mission.name or mission.name}: policy")


def uses_of(policy: Policy, mission: Mission) -> Uses:
    """How often actions are expected to be taken, by their state and their likeliest other one."""
    uses: dict[Pair, float] = defaultdict(float)
    for step, state, name, chance in policy.choices:
        action = mission.system.actions[state, name]
        if action.aim != state:
            uses[action.edge.pair] += chance * policy.expected[state][step]
    return {pair: agents for pair, agents in uses.items() if agents >= _LEAST}


def _draw_uses(drawn: DrawnMap, uses: Uses, colour: str) -> None:
    lines = [drawn.line(*pair) for pair in uses]
    widths = [_THICK * math.sqrt(agents) for agents in uses.values()]
    style = {"colors": colour, "linewidths": widths, "zorder": 4, "alpha": 0.6, "gid": "policy"}
    canvas.add_collection(drawn.ax, "LineCollection", lines, **style)
    if not drawn.dense:
        arrow_heads(drawn, lines, 0.8, (colour, _HEAD))


def _write_numbers(drawn: DrawnMap, plan: Plan) -> None:
    """How many agents are expected at each state at the last step."""
    names = [name for policy in plan.policies for name in policy.expected]
    counts = plan.counts(states=list(dict.fromkeys(names)))
    for name, agents in zip(dict.fromkeys(names), counts[:, -1].tolist(), strict=True):
        if agents >= _LEAST:
            text, size = number(round(agents, 2)), SMALL * 1.1
            places = _around(drawn, name, canvas.text_size(text, size))
            drawn.write_free(text, places, size, gid="expected", bbox=canvas.halo())


def _around(drawn: DrawnMap, state: str, extent: tuple[float, float]) -> list[complex]:
    """Places for a number: at a corner of what is written at a state, where no edges are."""
    box, (wide, tall) = drawn.labels[state].box, extent
    x, y = (box.left + box.right) / 2, (box.bottom + box.top) / 2
    across = (box.right - box.left + wide) / 2 + 3
    up = (box.top - box.bottom + tall) / 2 + 1
    corners = ((across, -up), (across, up), (-across, -up), (-across, up))
    return [complex(x + right, y + above) for right, above in corners]
