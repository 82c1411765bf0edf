"""What a user chooses of the solver: one record from the command line to the search."""

from __future__ import annotations

from dataclasses import asdict, dataclass, replace
from typing import Any

from tsplan.parameters import refuse_options


@dataclass(frozen=True, slots=True)
class SolverChoice:
    """What a mission or a caller asks of the solver; None leaves it to who is asked next.

    `time_limit` is in seconds for the whole, `gap` relative.

    >>> SolverChoice(seed=3).over(SolverChoice("gurobi", seed=1)).over(DEFAULT_CHOICE)
    SolverChoice(name='gurobi', time_limit=None, gap=0.0, threads=None, seed=3)
    """

    name: str | None = None
    time_limit: float | None = None
    gap: float | None = None
    threads: int | None = None
    seed: int | None = None

    def over(self, other: SolverChoice) -> SolverChoice:
        """The choice, filled up with another one."""
        own = {name: value for name, value in asdict(self).items() if value not in (None, "")}
        return replace(other, **own)

    def checked(self) -> SolverChoice:
        """The choice itself; raises InputError for numbers out of range."""
        refuse_options(**asdict(self))
        return self

    @property
    def numbers(self) -> dict[str, Any]:
        """The numbers that were chosen, by their names."""
        chosen = asdict(self)
        del chosen["name"]
        return {name: value for name, value in chosen.items() if value is not None}


DEFAULT_CHOICE = SolverChoice("highs", gap=0.0)
"""What nobody has chosen otherwise."""
