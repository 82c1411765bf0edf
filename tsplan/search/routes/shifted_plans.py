"""Plans whose errands are shifted in time until nothing more is gained.

Where each errand is at one place and ways have one price, who goes on from where costs little to
find out for any steps of the errands (`search.routes.link_program`). So tens of thousands of steps
are tried, and each time that has led to better ones their flows are told.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass

from tsplan.clock import Clock
from tsplan.encode.encoded import Encoded
from tsplan.milp.confirmation import tried
from tsplan.milp.model import Floats, Ints
from tsplan.milp.target import Target
from tsplan.search.effort import Effort
from tsplan.search.routes.errand_steps import Steps, without_joint
from tsplan.search.routes.errands import errands_of
from tsplan.search.routes.link_program import LinkProgram
from tsplan.search.routes.links import links_of
from tsplan.search.routes.shifting import Shifting

_MOST = 60_000  # links: programs of more take too long each
_SHARE = 0.8  # of the time that is left
_WHOLE = 5.0  # seconds for whole agents at given steps


@dataclass(frozen=True, eq=False)
class ShiftedPlans:
    """Finds plans of one model by links between its errands."""

    encoded: Encoded
    target: Target
    effort: Effort
    clock: Clock
    program: LinkProgram
    steps: Steps

    def flows(self) -> Iterator[Floats]:
        """Flows of plans, each mostly better than the ones before, until a round gains nothing."""
        left = self.clock.left
        clock = self.clock if left is None else self.clock.within(_SHARE * left)
        shifting = Shifting(self.program, self.steps, clock, self.steps.middle)
        for turn, better in enumerate(shifting.rounds()):
            if turn and not better:
                break
            found = self._plan(self.steps.begins(shifting.steps))
            if found is not None:
                yield found[self.encoded.flows]

    def _plan(self, begins: Ints) -> Floats | None:
        """The columns of the network in a plan of whole agents with these steps."""
        options = self.effort.options(self.clock.within(_WHOLE), self.target)
        values = tried(self.effort.solver, self.program.held(begins), options)
        if values is None or not self.program.whole(values):
            return None
        return self.program.flows(values, begins, len(self.target.vector))


def shifted_plans(
    encoded: Encoded, target: Target, effort: Effort, clock: Clock
) -> ShiftedPlans | None:
    """What finds plans by shifting errands; None where errands or ways are not plain enough."""
    errands = without_joint(errands_of(encoded, whole=True))
    steps = Steps.of(errands) if errands else None
    links = None if steps is None else links_of(encoded.network, errands, target.vector)
    if steps is None or links is None or len(links.group) > _MOST:
        return None
    program = LinkProgram(encoded.network, errands, links)
    return ShiftedPlans(encoded, target, effort, clock, program, steps)
