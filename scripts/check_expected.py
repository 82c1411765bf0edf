"""Plan every mission of a folder and compare with what its `expected.yaml` says; print a table.

    python scripts/check_expected.py FOLDER [--skip NAME ...] [--time-limit S]

`expected.yaml` maps mission names to `feasible` and, where known, `availability`. A name with a
slash is a path below the folder, any other lies in its `missions`. Every plan is written, read
back and judged by the independent check. The exit code is 1 if anything differs.
"""

from __future__ import annotations

import argparse
import sys
import time
from pathlib import Path
from typing import Any

import yaml

import tsplan


def judged(path: Path, expected: dict[str, Any], limit: float) -> tuple[bool, str]:
    """Whether the planner's answer is the expected one, and the answer in words."""
    mission = tsplan.load_mission(path)
    began = time.perf_counter()
    plan = tsplan.plan(mission, time_limit=limit)
    seconds = time.perf_counter() - began
    accepted = True
    if plan.has_paths:
        again = tsplan.Plan.from_json(plan.to_json())
        accepted = tsplan.check(mission, again).ok
    right = plan.has_paths == expected["feasible"] and accepted
    if "availability" in expected:
        right = right and plan.availability == expected["availability"]
    return right, f"{plan.status}, availability {plan.availability}, {seconds:.2f} s"


def main() -> int:
    """Run the table."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("folder", type=Path)
    parser.add_argument("--skip", nargs="*", default=[])
    parser.add_argument("--time-limit", type=float, default=100.0)
    options = parser.parse_args()
    table = yaml.safe_load((options.folder / "expected.yaml").read_text(encoding="utf-8"))
    right_ones = wrong = 0
    for name, expected in table.items():
        if name in options.skip:
            continue
        below = name if "/" in name else f"missions/{name}"
        right, words = judged(options.folder / f"{below}.yaml", expected, options.time_limit)
        wrong += not right
        right_ones += right
        mark = "ok    " if right else "DIFFERS"
        print(f"{mark} {name}: {words} (expected {expected})")
    print(f"{right_ones} as expected, {wrong} different")
    return 1 if wrong else 0


if __name__ == "__main__":
    sys.exit(main())
