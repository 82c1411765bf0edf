"""What is said of a plan after each step of its being carried out."""

from __future__ import annotations

from dataclasses import dataclass
from math import inf
from typing import Literal, NamedTuple, TypeAlias

from tsplan.words import many

Truth: TypeAlias = Literal["holds", "violated", "open"]
"""What is decided: it holds or is violated whatever is still to come, or neither is certain."""


class Slack(NamedTuple):
    """How much there is to spare if all goes on as it is taken to from here.

    `agents` is the availability: with so many agents less at any one place and step, or more where
    there are bounds from above, it still holds; negative where it does not hold, infinite where it
    asks for nobody. `steps` is by how many steps everything may be late: it still holds if all
    agents stop now for that long or shorter, and then go on; infinite where that never matters,
    and minus infinity where it does not hold. Longer stops may do, too.
    """

    agents: float
    steps: float

    def __str__(self) -> str:
        if self.agents < 0:
            return f"{many(int(-self.agents), 'agent')} missing" if self.agents > -inf else "fails"
        able = "any number of agents" if self.agents == inf else many(int(self.agents), "agent")
        late = "any number of steps" if self.steps == inf else many(int(self.steps), "step")
        return f"{able} and {late} to spare"


@dataclass(frozen=True, slots=True)
class PartVerdict:
    """What is said of one part of a mission's formula, or of a preferred formula.

    `decided` is the step at which its truth became certain, None while it is open. A part that is
    not `required` is preferred: the mission holds without it.
    """

    text: str
    truth: Truth
    slack: Slack
    decided: int | None = None
    required: bool = True

    def __str__(self) -> str:
        since = "" if self.decided is None else f" since step {self.decided}"
        spare = f"; {self.slack}" if self.truth == "open" else ""
        return f"{self.text}: {self.truth}{since}{spare}"


@dataclass(frozen=True, slots=True)
class Verdict:
    """What is said of a mission after a step.

    `truth` is that of the whole formula and `parts` those of its parts, which must all hold, and of
    preferred formulas. `works` says whether the plan as it stands still works: the formula holds if
    all goes on as it is taken to from here; where the mission may hold in part, every part of it
    does that the plan meets. `slack` is that of the whole formula.

    >>> print(Verdict(3, "open", True, Slack(1, 4), ()))
    step 3: open; the plan still works, 1 agent and 4 steps to spare
    """

    step: int
    truth: Truth
    works: bool
    slack: Slack
    parts: tuple[PartVerdict, ...]

    def __str__(self) -> str:
        plan = f"the plan {'still works' if self.works else 'works no more'}, {self.slack}"
        return "\n  ".join([f"step {self.step}: {self.truth}; {plan}", *map(str, self.parts)])
