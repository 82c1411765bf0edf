"""What a check ends with: what is wrong, what holds, and what was measured."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass

from tsplan.display import Told
from tsplan.errors import Finding, SolverError
from tsplan.words import visible

_SHOWN = 20  # findings of one kind that are listed before the rest is only counted


@dataclass(frozen=True)
class Report(Told):
    """What the check found, about a plan or what else the `noun` says; `str` tells it in words.

    `findings` is empty exactly if the plan is accepted. `availability` and `values` are computed
    from the paths and moves; they are None when these themselves are wrong. `facts` says in words
    what was found to hold. A trajectory has no availability; its `values` are those of everything
    that the objective weighs, computed from its controls.
    """

    findings: tuple[Finding, ...]
    facts: tuple[str, ...]
    availability: float | None = None
    values: Mapping[str, float] | None = None
    noun: str = "plan"

    @property
    def ok(self) -> bool:
        """Whether the plan is accepted."""
        return not self.findings

    @property
    def verdict(self) -> str:
        """Whether it is accepted, in words."""
        return f"the {self.noun} is {'accepted' if self.ok else 'refused'}"

    def __str__(self) -> str:
        """Everything that is wrong, or what was found to hold; then the verdict."""
        lines = (*map(str, self.findings), *self.facts, self.verdict)
        return "\n".join(visible(line, "\n") for line in lines)


def findings_of(problems: Sequence[str], source: str = "plan") -> tuple[Finding, ...]:
    """The first problems as findings, and how many more there are."""
    rest = len(problems) - _SHOWN
    listed = [*problems[:_SHOWN], *([f"and {rest} more"] if rest > 0 else [])]
    return tuple(Finding(message, source=source) for message in listed)


def refuse(problems: Sequence[str], source: str = "plan") -> None:
    """Raise SolverError with all problems of what was found, if there are any."""
    if problems:
        listed = "\n".join(map(str, findings_of(problems, source)))
        raise SolverError(f"the {source} that was found does not stand up to the check:\n{listed}")
