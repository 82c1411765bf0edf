"""Plan every mission of `environments/`, draw it, and write the page that shows them all.

    python scripts/gallery.py                           # docs/gallery.md and docs/gallery/
    python scripts/gallery.py --plans DIR farm_patrol   # one picture anew, from DIR/NAME.json

Words and pictures depend on the missions and their plans alone: no times, no dates.
"""

from __future__ import annotations

import argparse
import sys
from collections.abc import Iterator
from dataclasses import replace
from pathlib import Path
from typing import Any

import tsplan
from tsplan.draw.picture_files import save_picture
from tsplan.draw.views import draw_page
from tsplan.plans.outcomes import Status
from tsplan.plans.plan import Plan
from tsplan.plans.summary import names, objective_line, outcome

ROOT = Path(__file__).resolve().parent.parent
ENVIRONMENTS = ROOT / "environments"
DOCS = ROOT / "docs"
FLOW, STOCKS = "_flow", "_stocks"
DPI = 90

EXAMPLE, STEP, AGENT = "farm_harvest", 7, "harvester-3"
"""The mission whose plan is drawn at a step, too, and as it would go if an agent stopped there."""

INTRODUCTION = """# Gallery

Every mission of [`environments/`](../environments), planned and drawn by `python
scripts/gallery.py`. Each picture has the paths on the map, who is where when, and each count that
the formula asks for against its need; [pictures.md](pictures.md) says how to read them. Swarms
and modular robots have a second one: who splits and merges where. So have missions with resources:
what lies where.
"""


def main() -> int:
    """Draw the missions that are named, or all of them."""
    asked = _arguments()
    missions = sorted(path for path in ENVIRONMENTS.glob("*_*.yaml"))
    if unknown := set(asked.missions) - {path.stem for path in missions}:
        sys.stderr.write(f"there is no mission {names(sorted(unknown))} in environments/\n")
        return 2
    folder = DOCS / "gallery"
    folder.mkdir(exist_ok=True)
    parts = [INTRODUCTION]
    for path in missions:
        mission = tsplan.load_mission(path)
        plan = _planned(mission, path.stem, asked.plans)
        parts.append("\n".join(_entry(path, mission, plan)))
        if not asked.missions or path.stem in asked.missions:
            _draw(folder / path.stem, mission, plan)
            if path.stem == EXAMPLE:
                _draw_looks(folder, mission, plan)
            print(path.stem)
    (DOCS / "gallery.md").write_text("\n".join(parts), encoding="utf-8")
    return 0


def _arguments() -> argparse.Namespace:
    parser = argparse.ArgumentParser(description="Draw the missions of environments/.")
    parser.add_argument("missions", nargs="*", help="those to draw, all unless named")
    parser.add_argument("--plans", type=Path, help="a folder with plans that 'tsplan plan' wrote")
    return parser.parse_args()


def _planned(mission: tsplan.Mission, name: str, folder: Path | None) -> Plan:
    if folder is None:
        return tsplan.plan(mission, time_limit=120)
    return tsplan.load_plan(folder / f"{name}.json")


def _entry(path: Path, mission: tsplan.Mission, plan: Plan) -> Iterator[str]:
    """The lines of one mission."""
    yield f"## {mission.name.capitalize()}\n"
    yield f"[{path.name}](../environments/{path.name}). {_introduced(path)}\n"
    yield from (f"- {line}" for line in _facts(plan))
    yield ""
    for kind, words in _kinds(mission, plan).items():
        yield f"![{mission.name}: {words}](gallery/{path.stem}{kind}.png)\n"


def _kinds(mission: tsplan.Mission, plan: Plan) -> dict[str, str]:
    """What ends the name of each picture of a mission, and what it shows."""
    if not plan.has_paths:
        return {"": "the map, and who starts where"}
    grouped = mission.swarm is not None or plan.structures
    flow = {FLOW: "who splits and merges where"} if grouped else {}
    stocks = {STOCKS: "what lies where"} if mission.resources else {}
    first = "policy and counts" if plan.policies else "paths, times and counts"
    return {"": first, **flow, **stocks}


def _draw(place: Path, mission: tsplan.Mission, plan: Plan) -> None:
    """Write the pictures of a mission; `place` is their common path."""
    for kind in _kinds(mission, plan):
        figure = _figure(mission, plan, kind)
        save_picture(figure, place.with_name(f"{place.name}{kind}.png"), dpi=DPI)


def _draw_looks(folder: Path, mission: tsplan.Mission, plan: Plan) -> None:
    """A plan at one step in the dark, and beside what would happen if an agent stopped there."""
    looks: dict[str, dict[str, Any]] = {
        "step": {"step": STEP, "dark": True},
        "executed": {"executed": stopped(plan, AGENT, STEP)},
    }
    for name, look in looks.items():
        drawn = plan.plot(mission, view="page", **look)
        tsplan.save_picture(drawn, folder / f"{EXAMPLE}_{name}.png", dpi=DPI)


def stopped(plan: Plan, name: str, step: int) -> Plan:
    """The plan as it would go if an agent stayed for good where it is at a step, or comes next."""
    agents = []
    for agent in plan.agents:
        stays = agent.stays
        if agent.id == name:
            place = next(place for place, stay in enumerate(stays) if stay[1] >= step)
            first, _, state = stays[place]
            stays = (*stays[:place], (first, plan.horizon, state))
        agents.append(replace(agent, stays=stays))
    return replace(plan, agents=tuple(agents))


def _figure(mission: tsplan.Mission, plan: Plan, kind: str) -> Any:
    if kind in (FLOW, STOCKS):
        return plan.plot(mission, view=kind[1:])[0]
    return draw_page(plan, mission)[0] if plan.has_paths else mission.plot()[0]


def _introduced(path: Path) -> str:
    """What the comment at the top of a mission says of it."""
    lines = []
    for line in path.read_text(encoding="utf-8").splitlines():
        if not line.startswith("#"):
            break
        lines.append(line.lstrip("# ").rstrip())
    return " ".join(lines)


def _facts(plan: Plan) -> Iterator[str]:
    """What came out."""
    if plan.status is Status.INFEASIBLE:
        yield "There is no plan, and that is proven; the picture shows where everybody starts."
        return
    said = outcome(plan)
    yield said[0].upper() + said[1:]
    yield from (objective_line(item) for item in plan.objective)
    for wish in plan.preferences:
        met = "met" if wish.met else f"not met as a whole (fraction {wish.fraction})"
        yield f"preferred: {wish.name} is {met}"


if __name__ == "__main__":
    sys.exit(main())
