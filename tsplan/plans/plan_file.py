"""Files of plans, and what those of trajectories have in common with them."""

from __future__ import annotations

from dataclasses import dataclass, replace
from pathlib import Path
from typing import Protocol

from tsplan.document.files import beginning, read_text, write_whole
from tsplan.errors import InputError, PlanError
from tsplan.plans.plan import Plan
from tsplan.plans.plan_text import PLANS, ResultFormat, refuse_other, spelled

LARGEST_PLAN = 1024**3  # bytes; a path takes some hundred
_GLANCE = 4096  # bytes by which a file that is no plan is known


class Written(Protocol):
    """What is written as JSON: a plan or a trajectory."""

    def to_json(self) -> str:
        """The text of its file."""


def load_plan(path: str | Path) -> Plan:
    """Read a plan file; raises PlanError if it is missing, no ordinary file or not a plan."""
    return Plan.from_json(text_of_result(path, PLANS), str(path))


def text_of_result(path: str | Path, form: ResultFormat) -> str:
    """The text of a file that should be of a format; PlanError if it is missing or obviously not.

    Names are in the form in which they are compared.
    """
    try:
        refuse_other(beginning(path, _GLANCE), form, str(path))
        return spelled(read_text(path, most=LARGEST_PLAN))
    except PlanError:
        raise
    except InputError as error:
        raise PlanError(
            replace(item, message=f"cannot read the {form.noun}: {item.message}")
            for item in error.findings
        ) from None


@dataclass(frozen=True)
class EachAgent:
    """A plan in whose file every agent has an entry of its own, however many there are."""

    plan: Plan

    def to_json(self) -> str:
        """The text of its file."""
        return self.plan.to_json(each=True)


def save_plan(plan: Written, path: str | Path) -> None:
    """Write a plan file so that a reader sees the old file or the whole new one, never a part.

    More than 1,000 agents are written as bundles of agents on one path. Raises PlanError if the
    place cannot be written.
    """
    write_whole(Path(path), plan.to_json().encode(), PlanError)
