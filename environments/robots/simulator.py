"""Robots and structures that are now and then late, or lost: `tsplan execute --robots`.

    tsplan execute mission.yaml plan.json --robots "python simulator.py --late 0.2 --seed 1"

It reads a line of JSON from the standard input and answers with one on the standard output. A
program that drives real robots can take its place; docs/execution.md has the protocol.
"""

from __future__ import annotations

import argparse
import json
import random
import sys
from typing import Any


def main() -> None:
    """Answer every line."""
    options = argparse.ArgumentParser()
    options.add_argument("--late", type=float, default=0.1, help="chance that a move takes longer")
    options.add_argument("--lost", type=float, default=0, help="chance to be lost, at every step")
    options.add_argument("--seed", type=int, default=0)
    given = options.parse_args()
    robots = Robots(given.late, given.lost, given.seed)
    for line in sys.stdin:
        message = json.loads(line)
        if message["type"] == "end":
            break
        sys.stdout.write(json.dumps(robots.answer(message)) + "\n")
        sys.stdout.flush()


class Robots:
    """Where everybody is: at a state, on an edge with the step of arrival, or lost, as None."""

    def __init__(self, late: float, lost: float, seed: int) -> None:
        self.late, self.lost, self.seed = late, lost, seed
        self.places: dict[str, Any] = {}

    def answer(self, message: dict[str, Any]) -> dict[str, Any]:
        """What to say to a message."""
        if message["type"] == "begin":
            self.places = dict(message["agents"])
            return {"type": "ready"}
        step = message["step"]
        for order in message["orders"]:
            self.set_out(order, self.chance(step, order["agent"]))
        for order in message.get("rebuild", []):
            self.rebuild(order, self.chance(step, *order["parts"]))
        for name in self.places:
            if self.chance(step, name, "lost").random() < self.lost:
                self.places[name] = None
        return {"type": "seen", "step": step + 1, "agents": self.seen(step + 1)}

    def chance(self, *about: object) -> random.Random:
        """What happens to a robot at a step, whatever happens to others."""
        return random.Random(" ".join(map(str, (self.seed, *about))))

    def set_out(self, order: dict[str, Any], chance: random.Random) -> None:
        """Begin a move, which may take longer than it should."""
        arrives = order["arrives"] + self.delay(chance)
        self.places[order["agent"]] = {**order, "arrives": arrives}

    def rebuild(self, order: dict[str, Any], chance: random.Random) -> None:
        """Begin to make structures of others, on the way from a state to itself until then."""
        for name in order["parts"]:
            del self.places[name]
        done = order["done"] + self.delay(chance)
        for made in order["made"]:
            way = {"from": order["state"], "to": order["state"], "arrives": done}
            self.places[made["structure"]] = way

    def delay(self, chance: random.Random) -> int:
        """By how many steps something takes longer."""
        steps = 0
        while chance.random() < self.late:
            steps += 1
        return steps

    def seen(self, step: int) -> dict[str, Any]:
        """Where everybody is at a step: a state, the two ends of an edge, or None."""
        found: dict[str, Any] = {}
        for name, place in self.places.items():
            here = place
            if isinstance(place, dict):
                arrived = place["arrives"] <= step
                here = place["to"] if arrived else [place["from"], place["to"]]
                if arrived:
                    self.places[name] = here
            found[name] = here
        return found


if __name__ == "__main__":
    main()
