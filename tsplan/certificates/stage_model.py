"""The model of a certificate, made anew from its mission, and held against what it has."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass, replace
from itertools import zip_longest
from typing import Any

from tsplan.certificates.checker import CertificateError, Proven, Row
from tsplan.certificates.cut_rows import CutRows
from tsplan.certificates.rows_of import KINDS, REFUTATION, constraints_of, exactly
from tsplan.encode.assemble import tight
from tsplan.encode.encoded import Encoded, Setting
from tsplan.encode.model_objectives import Availability, Delay, model_objective
from tsplan.encode.objective_kinds import LevelObjective, StageObjective, TargetObjective
from tsplan.encode.preparation import delayed, prepare
from tsplan.milp.proof_tree import StageProof
from tsplan.milp.target import Target
from tsplan.mission import Mission

FORMAT = "tsplan-certificate/1"


@dataclass(frozen=True)
class Head:
    """What a certificate is about, as its first lines say.

    `kept` are objectives with the least or greatest values that plans must not lose, as they are
    minimised; `places` says that swarms are known by the places of their groups alone.
    """

    mission: str
    stage: str
    objective: str
    kept: tuple[tuple[str, float], ...]
    places: bool = False

    @classmethod
    def of(cls, mission: Mission, proof: StageProof) -> Head:
        """Of what a search proved."""
        return cls(mission.digest, proof.stage, proof.objective, proof.kept, proof.places)

    @property
    def comments(self) -> list[str]:
        """The lines that say it."""
        return [
            FORMAT,
            f"mission {self.mission}",
            f"stage {self.stage}",
            f"minimised {self.objective}",
            *(f"kept {name} {value!r}" for name, value in self.kept),
            *(["places"] if self.places else []),
        ]

    @classmethod
    def read(cls, comments: Sequence[str]) -> Head:
        """From those lines. Raises CertificateError for others."""
        if not comments or comments[0] != FORMAT:
            raise CertificateError(f"its first line is not '% {FORMAT}'")
        said: dict[str, Any] = {"kept": (), "places": False}
        for comment in comments[1:]:
            key, _, rest = comment.partition(" ")
            if key == "kept":
                name, _, value = rest.rpartition(" ")
                try:
                    said["kept"] += ((name, float(value)),)
                except ValueError:
                    raise CertificateError(f"'{comment}' names no value") from None
            elif comment == "places":
                said["places"] = True
            elif key in ("mission", "stage", "minimised") and key not in said:
                said[key] = rest
            else:
                raise CertificateError(f"'{comment}' says nothing about a mission")
        if missing := [key for key in ("mission", "stage", "minimised") if key not in said]:
            raise CertificateError(f"it does not say its {missing[0]}")
        return cls(said["mission"], said["stage"], said["minimised"], said["kept"], said["places"])


@dataclass(frozen=True, eq=False)
class StageModel:
    """The model of one stage: what is minimised in it, and how its cuts are told."""

    setting: Setting
    encoded: Encoded
    target: Target

    @classmethod
    def of(cls, mission: Mission, head: Head) -> StageModel:
        """The model that a certificate speaks of, made from the mission."""
        if what := uncertifiable(mission):
            raise CertificateError(f"there are no certificates of {what}")
        kept = [(_objective(name), value) for name, value in head.kept]
        _refuse_parts(kept)
        setting = prepare(mission)
        delay = max([mission.delay, *(int(v) for o, v in kept if isinstance(o, Delay))])
        setting = setting if delay == setting.delay else delayed(setting, delay)
        level = max([0, *(int(v) for o, v in kept if isinstance(o, Availability))])
        encoded = tight(setting, level)
        if head.places:
            told = [objective for objective, _ in kept if not objective.built]
            if not all(objective.by_places for objective in (*told, _objective(head.objective))):
                raise CertificateError("the places of groups do not say what it is about")
            if encoded.occupied is None:
                raise CertificateError("there are no groups whose places it could be about")
            encoded = encoded.occupied
        for objective, value in kept:
            if not objective.built or encoded.rho >= 0:
                encoded = objective.kept(setting, encoded, value)
        minimised = _objective(head.objective)
        if not isinstance(minimised, TargetObjective):
            raise CertificateError(f"{head.objective} is not minimised as it stands")
        if not head.places:
            encoded = minimised.extended(encoded)
        return cls(setting, encoded, minimised.target(setting, encoded))

    @property
    def reduced(self) -> frozenset[str]:
        """That maps were reduced, if they were."""
        maps = zip(self.setting.classes, self.setting.reduced, strict=True)
        some = any(item.graph is not short.graph for item, short in maps)
        return frozenset({"reduced maps"} if some else ())

    def own(self, name: str, value: float) -> float:
        """What is minimised of an objective in its own unit."""
        objective = _objective(name)
        if isinstance(objective, TargetObjective) and not isinstance(objective, LevelObjective):
            return objective.target(self.setting, self.encoded).own(value)
        return value

    def compare(self, proven: Proven) -> frozenset[str]:
        """Hold a certificate's program against the model; what it adds to that, by kinds.

        Raises CertificateError where it is another one, or has rows that are no cuts of it.
        """
        model = replace(self.encoded.model, objective=self.target.vector)
        rows = model.matrix.shape[0]
        limits = constraints_of(model, rows)
        if proven.variables != model.size.columns:
            raise CertificateError("the mission's model has another number of columns")
        if proven.whole != frozenset(model.integer.nonzero()[0].tolist()):
            raise CertificateError("other columns of the mission's model are whole")
        vector = {j: exactly(c) for j, c in enumerate(model.objective.tolist()) if c}
        if dict(proven.objective) != vector:
            raise CertificateError("something else is minimised in the mission's model")
        for own, given in zip_longest(limits.rows, proven.rows[: len(limits.rows)]):
            if given is None or not _same(own, given):
                raise CertificateError(
                    f"the mission's model has another row in place of {own.name}"
                )
        return frozenset(self._added(proven.rows[len(limits.rows) :]))

    def _added(self, rows: Sequence[Row]) -> Iterator[str]:
        """The kinds of further rows, each of which has to be true of the mission."""
        cuts = CutRows(self.encoded)
        for row in rows:
            if row.name == REFUTATION:
                if not self.encoded.refuted or not row.false:
                    raise CertificateError("demands, judged one by one, do not refute the mission")
                yield "demands judged one by one"
                continue
            kind = row.name.rstrip("gl").rstrip("0123456789")
            if kind not in KINDS or not cuts.true(kind, row):
                raise CertificateError(f"row {row.name} is no cut of the mission")
            yield KINDS[kind]


def _refuse_parts(kept: Sequence[tuple[StageObjective, float]]) -> None:
    for objective, value in kept:
        if isinstance(objective, LevelObjective) and not value.is_integer():
            raise CertificateError(f"{objective.name} is a whole number, and not {value}")


def uncertifiable(mission: Mission) -> str | None:
    """What of a mission has no certificates, as it is proven by other models; None for nothing."""
    if mission.partial or mission.prefer:
        return "missions that are met as far as possible"
    return None if mission.expected is None else "expected numbers"


def _same(own: Row, given: Row) -> bool:
    return (own.sense, own.side, dict(own.terms)) == (given.sense, given.side, dict(given.terms))


def _objective(name: str) -> StageObjective:
    found = model_objective(name)
    if found is None:
        raise CertificateError(f"there is no objective '{name}'")
    return found
