"""How much of each resource lies where over all steps, what executions take, and who brought it.

Everything here is read off cargo and executions by the ledger of the check, never from the solver.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING, TypeAlias

import numpy as np
import numpy.typing as npt

from tsplan.checking.fitting import refuse_misfit
from tsplan.checking.ledger_reading import read_ledger

if TYPE_CHECKING:
    from collections.abc import Iterable

    from tsplan.mission import Mission, Resource
    from tsplan.plans.ledger import Haul, Ledger, Use
    from tsplan.plans.plan import Plan

Floats: TypeAlias = npt.NDArray[np.float64]


@dataclass(frozen=True, eq=False)
class StockLine:
    """One resource at one state of a plan.

    At every step 0..horizon, `amounts` has what lies there, `staying` what is left of that once
    everything is used up and carried away, and `needs` what the executions there need: what they
    use up then, or the tools in use. `uses` are these executions, `brought` what comes there with
    whom, both in the order of time.
    """

    resource: Resource
    state: str
    amounts: Floats
    staying: Floats
    needs: Floats
    uses: tuple[Use, ...]
    brought: tuple[Haul, ...]

    @property
    def title(self) -> str:
        """The resource and the state, in words."""
        return f"{self.resource.name} at {self.state}"

    @property
    def begins(self) -> tuple[int, ...]:
        """The steps at which executions begin."""
        return tuple(dict.fromkeys(use.first for use in self.uses))

    @property
    def moves(self) -> bool:
        """Whether the amount changes or executions need it."""
        return bool(self.uses) or bool(np.ptp([*self.amounts, self.staying[-1]]))

    def at(self, time: float) -> float:
        """What lies there at a time, between two steps what has stayed after the first."""
        step = int(time)
        return float((self.amounts if time == step else self.staying)[step])


@dataclass(frozen=True, slots=True)
class Supply:
    """What an execution needs of a resource, and how it came to lie there.

    Of what lies there at `step`, `first` has lain there from the start and the others were
    `brought`, since the last step after which nothing was left; `gone` has been used up or carried
    away again since then.
    """

    resource: str
    state: str
    step: int
    needed: float
    there: float
    first: float
    brought: tuple[Haul, ...]
    gone: float


def supplies(lines: Iterable[StockLine], task: str, steps: Iterable[int]) -> tuple[Supply, ...]:
    """How the executions of a task, by its text, that begin at some steps were supplied."""
    wanted = set(steps)
    found = [
        _supply(line, use)
        for line in lines
        for use in line.uses
        if use.first in wanted and use.task.task == task
    ]
    return tuple(sorted(found, key=lambda supply: (supply.step, supply.state)))


def _supply(line: StockLine, use: Use) -> Supply:
    step = use.first
    emptied = np.flatnonzero(line.staying[:step] <= 0)
    since = int(emptied[-1]) + 1 if emptied.size else 0
    return Supply(
        line.resource.name,
        line.state,
        step,
        float(use.needs(line.resource.name)),
        float(line.amounts[step]),
        0.0 if since else float(line.amounts[0]),
        tuple(haul for haul in line.brought if since <= haul.come <= step),
        float((line.amounts - line.staying)[since:step].sum()),
    )


def stock_lines(plan: Plan, mission: Mission) -> tuple[StockLine, ...]:
    """A line for each resource at each state where some ever lies or is needed.

    They come in the order of the mission's resources and the map's states. Raises PlanError for a
    plan without paths or of another mission.
    """
    refuse_misfit(plan, mission)
    ledger, _ = read_ledger(mission, plan)
    order = {state: number for number, state in enumerate(mission.system.states)}
    lines = []
    for resource in mission.resources:
        uses = [use for use in ledger.uses if use.needs(resource.name)]
        places = {state for name, state in ledger.lying if name == resource.name}
        for state in sorted(places.union(use.state for use in uses), key=order.__getitem__):
            line = _line(ledger, resource, state)
            if line.uses or line.amounts.any():
                lines.append(line)
    return tuple(lines)


def _line(ledger: Ledger, resource: Resource, state: str) -> StockLine:
    steps = range(ledger.horizon + 1)
    name = resource.name
    uses = (use for use in ledger.uses if use.state == state and use.needs(name))
    hauls = (haul for haul in ledger.hauls if (haul.resource, haul.target) == (name, state))
    here = (haul for haul in hauls if haul.come <= ledger.horizon)
    return StockLine(
        resource,
        state,
        np.array([float(ledger.at(name, state, step)) for step in steps]),
        np.array([float(ledger.staying(name, state, step)) for step in steps]),
        np.array([float(ledger.asked(resource, state, step)) for step in steps]),
        tuple(sorted(uses, key=lambda use: use.first)),
        tuple(sorted(here, key=lambda haul: haul.come)),
    )
