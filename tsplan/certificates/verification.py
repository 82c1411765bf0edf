"""Certificates held against their mission, and against a plan: what is proven, and by what."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from math import isfinite

from tsplan.certificates.checker import CertificateError, checked
from tsplan.certificates.stage_model import Head, StageModel
from tsplan.encode.encoded import Setting
from tsplan.encode.model_objectives import model_objective, objectives_of
from tsplan.encode.objective_kinds import LevelObjective, StageObjective
from tsplan.encode.preparation import prepare
from tsplan.mission import Mission
from tsplan.plans.outcomes import CERTIFIED
from tsplan.plans.plan import Plan
from tsplan.words import number


@dataclass(frozen=True, eq=False)
class Verified:
    """A certificate that was accepted: the bound of its stage's objective that it proves.

    The bound is in the objective's own unit; None says that there is no plan at all. It holds of
    plans that lose nothing of what is `kept`: objectives with values in their own units. It `rests`
    on the encoding of the mission, and on what is named of it; `steps` were checked.
    """

    stage: str
    bound: float | None
    kept: tuple[tuple[str, float], ...]
    rests: frozenset[str]
    steps: int

    @property
    def words(self) -> str:
        """What is proven."""
        among = ", ".join(f"{name} {number(value)}" for name, value in self.kept)
        among = f" that keeps {among}" if among else ""
        if self.bound is None:
            return f"no plan{among} satisfies the mission"
        found = model_objective(self.stage)
        side = "above" if found is None or found.rises else "below"
        return f"no plan{among} has {self.stage} {side} {number(self.bound)}"


def verified(mission: Mission, text: str) -> Verified:
    """What a certificate proves about a mission.

    Raises CertificateError where it is not of the mission, or any step of it is wrong.
    """
    proven = checked(text)
    head = Head.read(proven.comments)
    if head.mission != mission.digest:
        raise CertificateError("it is of another mission, or the mission's text has changed")
    made = StageModel.of(mission, head)
    rests = made.compare(proven) | made.reduced
    kept = tuple((name, made.own(name, value)) for name, value in head.kept)
    if proven.bound is not None:
        if head.stage != head.objective:
            raise CertificateError(f"a bound of {head.objective} says nothing of {head.stage}")
        bound = made.target.own(float(proven.bound)) if isfinite(proven.bound) else None
        if bound is None:
            raise CertificateError("it claims no bound")
        return Verified(head.stage, bound, kept, rests, proven.steps)
    bound = None
    last = model_objective(kept[-1][0]) if kept else None
    if isinstance(last, LevelObjective) and last.name == head.stage:
        # no plan reaches this level, so the next one is all there can be
        bound = kept[-1][1] + (-1 if last.rises else 1)
        kept = kept[:-1]
    return Verified(head.stage, bound, kept, rests, proven.steps)


@dataclass(frozen=True)
class Joined:
    """A plan's objectives with what certificates say of each: proven, or not, in words."""

    lines: tuple[str, ...]
    proven: bool


def joined(mission: Mission, plan: Plan, proofs: Sequence[Verified]) -> Joined:
    """What certificates prove of a plan, objective by objective.

    A bound counts for a plan if it is one for plans that keep just what this one reaches before.
    """
    setting = prepare(mission)
    values = {item.name: item.value for item in plan.objective}
    lines, sure = [], True
    before: list[tuple[str, float]] = []
    for objective in objectives_of(mission):
        value = values.get(objective.name)
        found = [p for p in proofs if p.stage == objective.name and [*p.kept] == before]
        words = _told(setting, objective, value, found)
        sure = sure and words is not None
        name = f"{objective.name} {number(value)}"
        open_ = f"{found[0].words} (certified)" if found else "not proven by these certificates"
        lines.append(f"{name}: {words or open_}")
        if value is not None:
            before.append((objective.name, value))
    return Joined(tuple(lines), sure)


def _told(
    setting: Setting, objective: StageObjective, value: float | None, found: Sequence[Verified]
) -> str | None:
    """Why no plan does better; None where nothing says so."""
    if value is None:
        return None
    for proof in found:
        if proof.bound == value:
            rests = f", resting on {', '.join(sorted(proof.rests))}" if proof.rests else ""
            return f"{CERTIFIED}{rests}"
    if isinstance(objective, LevelObjective) and objective.ideal(setting) == value:
        return f"{CERTIFIED}, resting on demands judged one by one"
    return None
