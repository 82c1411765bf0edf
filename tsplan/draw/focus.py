"""What of a plan a picture shows: a moment, some agents, and what really happened beside it."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from dataclasses import dataclass
from typing import TYPE_CHECKING

from tsplan.errors import Finding, InputError, nearest

if TYPE_CHECKING:
    from tsplan.draw.tracks import Track
    from tsplan.plans.plan import Plan

HAPPENED = ", executed"
"""What follows the words of a line that tells what really happened."""


@dataclass(frozen=True)
class Focus:
    """What is looked at.

    `step` is a moment between 0 and the horizon, which may lie between two steps. `agents` are ids
    of agents, or names of classes, whose paths and rows are drawn; all where none are named.
    `executed` is what really happened, as another plan of the same mission: it is drawn full, and
    what was planned pale.
    """

    step: float | None = None
    agents: tuple[str, ...] = ()
    executed: Plan | None = None

    @classmethod
    def of(
        cls,
        step: float | None = None,
        agents: str | Iterable[str] = (),
        executed: Plan | None = None,
    ) -> Focus:
        """From what a caller gives: one name of an agent is a name, not its letters."""
        return cls(step, (agents,) if isinstance(agents, str) else tuple(agents), executed)

    def until(self, plan: Plan) -> int:
        """The last step that a picture of a plan shows: its own, or that of what happened."""
        return max(plan.horizon, self.executed.horizon if self.executed is not None else 0)

    def refuse_beyond(self, plan: Plan) -> None:
        """Raise InputError for a moment that is not on the picture of a plan."""
        last = self.until(plan)
        if self.step is not None and not 0 <= self.step <= last:
            what = f"there is no step {self.step:g}: the plan has steps 0 to {last}"
            raise InputError([Finding(what, "name one of them")])

    def chosen(self, found: Sequence[Track], plan: Plan) -> tuple[Track, ...]:
        """The tracks of a plan's agents that are looked at, each with these agents alone.

        Structures of modules, and their configurations, stand for their modules. Raises InputError
        for a name that the plan does not have.
        """
        if not self.agents:
            return tuple(found)
        wanted = set(self.agents)
        names = {*plan.moves, *(bundle.class_name for bundle in plan.bundles)}
        names.update(name for bundle in plan.bundles for name in bundle.agents)
        for each in plan.structures:
            own = {each.id, each.configuration, each.class_name}
            names |= own
            if own & wanted:
                wanted.update(each.modules)
        unknown = [name for name in self.agents if name not in names]
        if unknown:
            raise InputError(
                Finding(f"the plan has no agent or class '{name}'", nearest(name, sorted(names)))
                for name in unknown
            )
        return tuple(kept for track in found if (kept := track.only(frozenset(wanted))) is not None)


WHOLE = Focus()
"""All of a plan, over all of its time."""
