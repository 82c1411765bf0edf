"""`tsplan verify`: check certificates of a mission, and whether they prove a plan the best."""

from __future__ import annotations

from typing import TYPE_CHECKING

from tsplan.certificates.checker import CertificateError
from tsplan.certificates.verification import Verified, joined, verified
from tsplan.checking.plan_check import check
from tsplan.cli.arguments import Exit
from tsplan.cli.inputs import any_mission_of
from tsplan.cli.output import say
from tsplan.document.files import read_text
from tsplan.errors import Finding, InputError, clipped
from tsplan.mission import Mission
from tsplan.plans.plan_file import load_plan

if TYPE_CHECKING:
    import argparse

_LARGEST = 4_000_000_000  # bytes of a certificate


def run(options: argparse.Namespace) -> Exit:
    """Print what is proven; what is not, or is wrong, makes the exit code 1."""
    mission = any_mission_of(options.mission)
    if not isinstance(mission, Mission):
        what = "certificates are of missions of teams and swarms"
        raise InputError([Finding(what, "check the trajectory with tsplan check")])
    proofs: list[Verified] = []
    good = True
    for path in options.certificates:
        try:
            proof = verified(mission, read_text(path, most=_LARGEST))
        except CertificateError as error:
            say(f"{path}: refused: {clipped(str(error))}")
            good = False
            continue
        proofs.append(proof)
        if not options.quiet:
            resting = f", resting on {', '.join(sorted(proof.rests))}" if proof.rests else ""
            say(f"{path}: {proof.words} (certified{resting}; {proof.steps:,} steps checked)")
    if options.plan is not None:
        good = _judged(mission, options, proofs) and good
    return Exit.DONE if good else Exit.REFUSED


def _judged(mission: Mission, options: argparse.Namespace, proofs: list[Verified]) -> bool:
    """Whether a plan holds and is the best by what was proven; all of it is printed."""
    plan = load_plan(options.plan)
    report = check(mission, plan)
    for finding in report.findings:
        say(f"{options.plan}: {clipped(finding.message)}")
    if not report.ok:
        return False
    told = joined(mission, plan, proofs)
    if not options.quiet or not told.proven:
        say(f"{options.plan}: the plan holds")
        for line in told.lines:
            say(f"  {line}")
    return told.proven
