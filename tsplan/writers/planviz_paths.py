"""PlanViz: paths on a grid in the JSON of the League of Robot Runners.

The keys are those of its start kit (https://github.com/MAPF-Competition/Start-Kit), as PlanViz
(https://github.com/MAPF-Competition/PlanViz) reads them for the action model `MAPF`: rows count
from the top, and the moves are `R` (one column on), `L`, `U` (one row on), `D`, and `W` for a wait.
"""

from __future__ import annotations

from collections.abc import Iterator
from functools import lru_cache
from itertools import pairwise
from typing import Any

from tsplan.errors import Finding, PlanError
from tsplan.plans.records import as_json
from tsplan.writers.grid_cells import OTHERS, Cells, refuse_no_grid
from tsplan.writers.handover import Handover
from tsplan.writers.journeys import Journey
from tsplan.writers.json_parts import document

_MOVES = {(0, 1): "R", (0, -1): "L", (1, 0): "U", (-1, 0): "D", (0, 0): "W"}
_KEPT = 1024  # journeys whose moves are kept for the agents that follow


def write(handover: Handover) -> Iterator[str]:
    """The start of every agent and its moves, one for each step, and its last cell as its task.

    PlanViz has agents by number: `agents` has their names in the same order.

    Raises
    ------
    PlanError
        The map is no grid, a move is none of one step to a neighbouring cell, or there is none.

    """
    cells = refuse_no_grid(handover.system)
    _refuse_other_moves(handover, cells)
    moves = lru_cache(_KEPT)(lambda journey: as_json(_moves(handover, cells, journey)))
    done = [_done(journey) for _, journey in handover.journeys()]
    head: dict[str, Any] = {
        "actionModel": "MAPF",
        "version": "2023 LoRR",
        "AllValid": "Yes" if handover.plan.verified else "No",
        "teamSize": len(done),
        "numTaskFinished": len(done),
        "sumOfCost": sum(done),
        "makespan": handover.plan.horizon,
        "errors": [],
    }
    starts = (cells[journey.stays[0][2]] for _, journey in handover.journeys())
    goals = (cells[journey.stays[-1][2]] for _, journey in handover.journeys())
    lists = {
        "agents": (as_json(agent) for agent, _ in handover.journeys()),
        "start": (as_json((*cell, "N/A")) for cell in starts),
        "actualPaths": (moves(journey) for _, journey in handover.journeys()),
        "plannerPaths": (moves(journey) for _, journey in handover.journeys()),
        "events": (
            as_json([(number, 0, "assigned"), (number, step, "finished")])
            for number, step in enumerate(done)
        ),
        "tasks": (as_json((number, *cell)) for number, cell in enumerate(goals)),
    }
    yield from document(head, lists)


def _refuse_other_moves(handover: Handover, cells: Cells) -> None:
    """Raise PlanError for no moves, and for those that PlanViz cannot show with who makes them."""
    if not handover.plan.horizon:
        raise PlanError([Finding("the plan ends at step 0, so there are no moves", OTHERS)])
    found: dict[str, Finding] = {}
    seen: set[Journey] = set()
    for agent, journey in handover.journeys():
        if journey.coming is not None:
            what = f"agent {agent} is on its way from {journey.coming} when the plan begins"
            found.setdefault("coming", Finding(what, OTHERS))
        for source, target, left, arrives in () if journey in seen else journey.legs:
            words = _oddity(cells, source, target, None if arrives is None else arrives - left)
            if words is not None:
                what = f"agent {agent} goes from {source} to {target} at step {left}, {words}"
                found.setdefault(words + source + target, Finding(what, OTHERS))
        seen.add(journey)
    if found:
        raise PlanError(found.values())


def _oddity(cells: Cells, source: str, target: str, steps: int | None) -> str | None:
    """What PlanViz cannot show about a move."""
    if source == target:
        return None
    shift = tuple(two - one for one, two in zip(cells[source], cells[target], strict=True))
    if shift not in _MOVES:
        return "which is no neighbouring cell of its row or column"
    return None if steps == 1 else f"which takes {steps or 'several'} steps, and PlanViz knows one"


def _moves(handover: Handover, cells: Cells, journey: Journey) -> str:
    """The move of every step up to the horizon, with commas between them."""
    steps = range(handover.plan.horizon + 1)
    at = [cells[journey.latest(step)] for step in steps]
    shifts = ((two[0] - one[0], two[1] - one[1]) for one, two in pairwise(at))
    return ",".join(_MOVES[shift] for shift in shifts)


def _done(journey: Journey) -> int:
    """The step from which an agent stays where it ends."""
    state = journey.stays[-1][2]
    first = journey.stays[-1][0]
    for begin, _, other in reversed(journey.stays):
        if other != state:
            break
        first = begin
    return first
