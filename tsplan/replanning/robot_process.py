"""A fleet that is another process, which reads orders and tells what it sees in lines of JSON.

The protocol is described in docs/execution.md, so that any program can take its place, a node of
ROS as well as a simulator.
"""

from __future__ import annotations

import json
import queue
import shlex
import subprocess
import threading
from collections.abc import Mapping, Sequence
from contextlib import suppress
from dataclasses import dataclass, field
from typing import IO, Any

from tsplan.errors import TsplanError
from tsplan.limits import clipped
from tsplan.plans.worlds import OnEdge
from tsplan.replanning.execution_journal import seen_from
from tsplan.replanning.robot_fleet import Assembly, MoveOrder, Order, RebuildOrder, Seen

FORMAT = "tsplan-robots/1"


class RobotsError(TsplanError):
    """The process of the robots ended, is silent, or says what cannot be understood."""


@dataclass(eq=False)
class RobotProcess:
    """Robots behind the standard streams of a command.

    A step that is not answered within `patience` seconds is an error. At the end the process has
    `grace` seconds to end by itself.
    """

    command: str
    patience: float = 60.0
    grace: float = 5.0
    _process: subprocess.Popen[str] | None = field(default=None, init=False)
    _lines: queue.Queue[str | None] = field(default_factory=queue.Queue, init=False)

    def begin(
        self, step: int, places: Mapping[str, str | OnEdge], built: Sequence[Assembly] = ()
    ) -> None:
        """Start the process, and tell it where everybody is. Raises RobotsError."""
        try:
            self._process = subprocess.Popen(  # noqa: S603  (a command of the user's own)
                shlex.split(self.command),
                stdin=subprocess.PIPE,
                stdout=subprocess.PIPE,
                encoding="utf-8",
            )
        except (OSError, ValueError) as error:
            raise RobotsError(f"the robots cannot be started: {error}") from None
        assert self._process.stdout is not None
        threading.Thread(target=self._listen, args=(self._process.stdout,), daemon=True).start()
        agents = {name: _place(place) for name, place in places.items()}
        structures = {"structures": [each._asdict() for each in built]} if built else {}
        self._say({"type": "begin", "format": FORMAT, "step": step, "agents": agents, **structures})
        answer = self._answer("begin")
        if answer.get("type") != "ready":
            raise RobotsError(f"the robots should say that they are ready, and say {answer}")

    def advance(self, step: int, orders: Sequence[Order]) -> Seen:
        """Send the orders of a step, and wait for what is seen at the next. Raises RobotsError."""
        moves = [
            {"agent": name, "from": source, "to": target, "arrives": arrives}
            for name, source, target, arrives in (o for o in orders if isinstance(o, MoveOrder))
        ]
        rebuild = [_rebuild(order) for order in orders if isinstance(order, RebuildOrder)]
        more = {"rebuild": rebuild} if rebuild else {}
        self._say({"type": "step", "step": step, "orders": moves, **more})
        answer = self._answer(f"step {step}")
        try:
            seen = seen_from(answer)
        except ValueError as error:
            raise RobotsError(f"what the robots say of step {step} is wrong: {error}") from None
        if answer.get("type") != "seen" or seen.step != step + 1:
            what = f"after step {step} the robots should tell what is seen at step {step + 1}"
            raise RobotsError(f"{what}, and say {clipped(json.dumps(answer))}")
        return seen

    def end(self) -> None:
        """Say that this is the end, and wait for the process to end."""
        process = self._process
        if process is None:
            return
        with suppress(RobotsError):  # it may have ended by itself
            self._say({"type": "end"})
        if process.stdin is not None:
            with suppress(OSError):
                process.stdin.close()
        try:
            process.wait(self.grace)
        except subprocess.TimeoutExpired:
            process.kill()
            process.wait()

    def _say(self, message: dict[str, Any]) -> None:
        assert self._process is not None
        assert self._process.stdin is not None
        try:
            self._process.stdin.write(json.dumps(message) + "\n")
            self._process.stdin.flush()
        except (OSError, ValueError):
            raise RobotsError("the robots have ended") from None

    def _answer(self, after: str) -> dict[str, Any]:
        try:
            line = self._lines.get(timeout=self.patience)
        except queue.Empty:
            raise RobotsError(
                f"the robots have said nothing for {self.patience:g} s after {after}"
            ) from None
        if line is None:
            raise RobotsError(f"the robots have ended after {after}")
        try:
            message = json.loads(line)
        except ValueError:
            message = None
        if not isinstance(message, dict):
            raise RobotsError(
                f"after {after} the robots say what is no JSON object: {clipped(line)}"
            )
        return message

    def _listen(self, stream: IO[str]) -> None:
        for line in stream:
            self._lines.put(line)
        self._lines.put(None)


def _rebuild(order: RebuildOrder) -> dict[str, Any]:
    return {**order._asdict(), "made": [each._asdict() for each in order.made]}


def _place(place: str | OnEdge) -> Any:
    if isinstance(place, str):
        return place
    return {"from": place.source, "to": place.target, "arrives": place.arrives}
