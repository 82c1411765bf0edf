"""Certificates of a plan as files: one for each objective whose bound is certified."""

from __future__ import annotations

from collections.abc import Sequence
from pathlib import Path

from tsplan.certificates.checker import CertificateError, checked
from tsplan.certificates.stage_model import Head, uncertifiable
from tsplan.certificates.vipr_text import UnprovenError, vipr_text
from tsplan.document.files import write_whole
from tsplan.errors import Finding, InputError
from tsplan.milp.proof_tree import StageProof
from tsplan.mission import Mission
from tsplan.plans.outcomes import CERTIFIED, ObjectiveValue, Status
from tsplan.plans.plan import Plan
from tsplan.run.problem import Problem, Tuning


def refuse_without(problem: Problem) -> None:
    """InputError for a problem whose proofs are of a kind that has no certificates."""
    what = uncertifiable(problem.mission)
    if problem.extended:
        what = "a user's own constraints and objectives"
    if problem.tuning != Tuning():
        what = "other encodings than the usual one"
    if what is not None:
        remedy = "plan without a certificate; --certified says who vouches for what"
        raise InputError([Finding(f"there are no certificates of {what}", remedy)])


def write_certificates(
    mission: Mission, plan: Plan, proofs: Sequence[StageProof], path: Path
) -> tuple[str, ...]:
    """Write the certificates of a plan; sentences that say which there are, and which are not.

    A single one is written to the path, several to numbered ones: plan.1.vipr, plan.2.vipr.
    """
    texts: list[tuple[str, str]] = []
    notes = []
    for stage, proof in _wanted(plan, proofs):
        if proof is None:
            notes.append(f"there is no certificate of {stage}: no program was needed for its bound")
            continue
        try:
            text = vipr_text(proof.tree, Head.of(mission, proof).comments)
            checked(text)
            texts.append((stage, text))
        except (UnprovenError, CertificateError) as error:
            notes.append(f"there is no certificate of {stage}: {error}")
    for place, (stage, text) in enumerate(texts):
        file = path if len(texts) == 1 else path.with_suffix(f".{place + 1}{path.suffix}")
        write_whole(file, text.encode())
        notes.append(f"certificate of {stage}: {file.name}")
    return tuple(notes)


def _wanted(plan: Plan, proofs: Sequence[StageProof]) -> list[tuple[str, StageProof | None]]:
    """For each stage that is certified what proves it, as far as it is known."""
    if plan.status is Status.INFEASIBLE:
        found = [each for each in proofs if each.tree.bound is None and not each.kept]
        return [("infeasibility", found[-1] if found else None)]
    return [
        (item.name, _of(item, proofs))
        for item in plan.objective
        if item.proof == CERTIFIED and item.value is not None
    ]


def _of(item: ObjectiveValue, proofs: Sequence[StageProof]) -> StageProof | None:
    """What proves the bound of an objective."""
    mine = [each for each in proofs if each.stage == item.name]
    levels = [
        each
        for each in mine
        if each.tree.bound is None and each.kept and each.kept[-1][0] == item.name
    ]
    if levels:
        return min(levels, key=lambda each: abs(each.kept[-1][1] - (item.bound or 0.0)))
    bounds = [each for each in mine if each.objective == item.name and each.tree.bound is not None]
    return max(bounds, key=lambda each: each.tree.bound or 0.0, default=None)
