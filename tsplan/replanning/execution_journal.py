"""The journal of an execution: every step that was carried out, safe as soon as it is seen.

Each line is an object of JSON. The first has the plan, then there is one for what is seen at every
step, followed by one with the plan from there on if that is another one. A line that was not
finished is as if it was never begun.
"""

from __future__ import annotations

import json
import os
from dataclasses import dataclass
from pathlib import Path
from typing import Any, NamedTuple

from pydantic import TypeAdapter, ValidationError

from tsplan.errors import Finding, InputError, PlanError
from tsplan.plans.plan import Plan
from tsplan.plans.records import as_json
from tsplan.plans.worlds import Closed, Opened
from tsplan.replanning.robot_fleet import Seen


class Kept(NamedTuple):
    """What a journal has: the plan that was followed last, and what was seen since."""

    plan: Plan
    seen: tuple[Seen, ...]


@dataclass(frozen=True)
class ExecutionJournal:
    """The file of a journal; there may be none yet."""

    path: Path

    def read(self, digest: str) -> Kept | None:
        """What the journal of a mission, by the digest of its text, has; None where there is none.

        Raises InputError for a file that is another, or that of another mission.
        """
        try:
            lines = self.path.read_bytes().split(b"\n")[:-1]
        except FileNotFoundError:
            return None
        except OSError as error:
            raise self._refusal(f"the journal cannot be read: {error.strerror}") from None
        if not lines:
            return None
        try:
            entries = [json.loads(line) for line in lines]
            plan, seen = Plan.from_json(str(entries[0]["plan"])), list[Seen]()
            for entry in entries[1:]:
                if "plan" in entry:
                    plan, seen = Plan.from_json(str(entry["plan"])), []
                else:
                    seen.append(seen_from(entry["seen"]))
        except (ValueError, KeyError, TypeError, PlanError):
            raise self._refusal("this is no journal of an execution") from None
        if plan.mission.sha256 != digest:
            raise self._refusal("the journal is that of another mission, or of other text")
        return Kept(plan, tuple(seen))

    def begin(self, plan: Plan) -> None:
        """Begin anew with a plan, or, where a journal goes on, cut off what was not finished."""
        try:
            with self.path.open("ab+") as stream:
                stream.seek(0)
                content = stream.read()
                stream.truncate(content.rfind(b"\n") + 1)
        except OSError as error:
            raise self._refusal(f"the journal cannot be kept: {error.strerror}") from None
        if b"\n" not in content:
            self._append({"plan": plan.to_json()})

    def keep(self, seen: Seen, plan: Plan | None) -> None:
        """Write what was seen at a step, or the plan from there on; it is on the disk then."""
        self._append({"seen": seen_data(seen)} if plan is None else {"plan": plan.to_json()})

    def _append(self, entry: dict[str, Any]) -> None:
        try:
            with self.path.open("ab") as stream:
                stream.write(json.dumps(entry).encode() + b"\n")
                stream.flush()
                os.fsync(stream.fileno())
        except OSError as error:
            raise self._refusal(f"the journal cannot be kept: {error.strerror}") from None

    def _refusal(self, what: str) -> InputError:
        return InputError([Finding(what, "name another file", str(self.path))])


def seen_data(seen: Seen) -> dict[str, Any]:
    """What was seen, as JSON has it."""
    data: dict[str, Any] = {"step": seen.step, "agents": dict(seen.places)}
    for name in ("closed", "opened"):
        if getattr(seen, name):
            data[name] = json.loads(as_json(getattr(seen, name)))
    return data


_CLOSED, _OPENED = TypeAdapter(tuple[Closed, ...]), TypeAdapter(tuple[Opened, ...])


def seen_from(data: Any) -> Seen:
    """The same from JSON, in which a place that is closed for good may stand by itself.

    Raises ValueError for what is none.
    """
    step = data.get("step") if isinstance(data, dict) else None
    if type(step) is not int:
        raise ValueError("'step' is missing: say of which step this is")
    places = data.get("agents", {})
    if not isinstance(places, dict):
        raise ValueError('\'agents\' is no object: write {"scout-1": "q1"}')  # noqa: TRY004
    closed = [
        each if isinstance(each, dict) else {"place": each} for each in data.get("closed", ())
    ]
    try:
        shut = _CLOSED.validate_python(closed)
        opened = _OPENED.validate_python(data.get("opened", ()))
    except ValidationError as error:
        raise ValueError(str(error)) from None
    return Seen(step, {name: _sighting(name, p) for name, p in places.items()}, shut, opened)


def _sighting(name: str, place: Any) -> str | tuple[str, str] | None:
    if place is None or isinstance(place, str):
        return place
    if isinstance(place, list) and len(place) == 2 and all(isinstance(end, str) for end in place):  # noqa: PLR2004
        return place[0], place[1]
    remedy = 'write a state, ["q1", "q2"] for an edge, or null for an agent that is lost'
    raise ValueError(f"{name} is at no place: {remedy}")
