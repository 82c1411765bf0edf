"""Plans that the check refuses."""

from __future__ import annotations

import pytest

from tsplan.checking.plan_check import certify, check
from tsplan.errors import SolverError
from tsplan.mission import Mission
from tsplan.plans.plan import Plan


def refused(mission: Mission, plan: Plan, *words: str) -> None:
    """A plan is no plan of a mission, with all the words among the reasons, and is never shown."""
    report = check(mission, plan)
    text = "\n".join(finding.message for finding in report.findings)
    assert not report.ok
    assert not report.facts
    assert all(word in text for word in words), text
    with pytest.raises(SolverError):
        certify(mission, plan)
