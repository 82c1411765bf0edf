"""Files of plans."""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path

from tsplan.document.files import beginning, read_text, write_whole
from tsplan.errors import InputError, PlanError
from tsplan.plans.plan import Plan
from tsplan.plans.plan_text import refuse_other, spelled

LARGEST_PLAN = 1024**3  # bytes; a path takes some hundred
_GLANCE = 4096  # bytes by which a file that is no plan is known


def load_plan(path: str | Path) -> Plan:
    """Read a plan file; raises PlanError if it is missing, no ordinary file or not a plan."""
    try:
        refuse_other(beginning(path, _GLANCE), str(path))
        text = read_text(path, most=LARGEST_PLAN)
    except PlanError:
        raise
    except InputError as error:
        raise PlanError(
            replace(item, message=f"cannot read the plan: {item.message}")
            for item in error.findings
        ) from None
    return Plan.from_json(spelled(text), str(path))


def save_plan(plan: Plan, path: str | Path) -> None:
    """Write a plan file so that a reader sees the old file or the whole new one, never a part.

    Raises PlanError if the place cannot be written.
    """
    write_whole(Path(path), plan.to_json().encode(), PlanError)
