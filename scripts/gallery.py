"""Plan every mission of `environments/`, draw it, and write the page that shows them all.

    python scripts/gallery.py                       # docs/gallery.md and docs/gallery/
    python scripts/gallery.py reef_relay -o DIR     # some missions, elsewhere

Words and pictures depend on the missions and their plans alone: no times, no dates.
"""

from __future__ import annotations

import argparse
import io
import sys
from collections.abc import Iterator
from pathlib import Path
from typing import Any

from PIL import Image

import tsplan
from tsplan.draw.save import content
from tsplan.draw.views import draw_page
from tsplan.results import Plan, Status
from tsplan.results.summary import names, objective_line, outcome

ROOT = Path(__file__).resolve().parent.parent
ENVIRONMENTS = ROOT / "environments"
DPI = 100
COLOURS = 128
"""Of a picture; flat drawings do not need more, and the files become a third as large."""

INTRODUCTION = """# Gallery

Every mission of [`environments/`](../environments), planned and drawn by `python
scripts/gallery.py`. Each picture has the paths on the map, who is where when, and each count that
the formula asks for against its need; [pictures.md](pictures.md) says how to read them. Swarms have
a second one: who splits and merges where.
"""


def main() -> int:
    """Draw the missions that are named, or all of them."""
    asked = _arguments()
    missions = sorted(path for path in ENVIRONMENTS.glob("*_*.yaml"))
    if unknown := set(asked.missions) - {path.stem for path in missions}:
        sys.stderr.write(f"there is no mission {names(sorted(unknown))} in environments/\n")
        return 2
    folder = asked.output / "gallery"
    folder.mkdir(parents=True, exist_ok=True)
    parts = [INTRODUCTION]
    for path in missions:
        if not asked.missions or path.stem in asked.missions:
            parts.append("\n".join(_entry(path, folder)))
            print(path.stem)
    (asked.output / "gallery.md").write_text("\n".join(parts), encoding="utf-8")
    return 0


def _arguments() -> argparse.Namespace:
    parser = argparse.ArgumentParser(description="Draw the missions of environments/.")
    parser.add_argument("missions", nargs="*", help="names of mission files without their ending")
    parser.add_argument("-o", "--output", type=Path, default=ROOT / "docs", help="a folder")
    return parser.parse_args()


def _entry(path: Path, folder: Path) -> Iterator[str]:
    """The lines of one mission, whose pictures are written on the way."""
    mission = tsplan.load_mission(path)
    plan = tsplan.plan(mission, time_limit=120)
    yield f"## {mission.name}\n"
    yield f"[{path.name}](../environments/{path.name}). {_introduced(path)}\n"
    yield from (f"- {line}" for line in _facts(plan))
    yield ""
    for kind, figure in _figures(mission, plan):
        file = folder / f"{path.stem}{kind}.png"
        file.write_bytes(_compact(content(figure, "png", DPI)))
        yield f"![{mission.name}{kind.replace('_', ', ')}](gallery/{file.name})\n"


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
    yield outcome(plan).capitalize()
    yield from (objective_line(item) for item in plan.objective)
    for wish in plan.preferences:
        met = "met" if wish.met else f"not met as a whole (fraction {wish.fraction})"
        yield f"preferred: {wish.name} is {met}"


def _figures(mission: tsplan.Mission, plan: Plan) -> Iterator[tuple[str, Any]]:
    """What ends the name of each picture, and its figure."""
    if not plan.has_paths:
        yield "", mission.plot()[0]
        return
    yield "", draw_page(plan, mission)[0]
    if mission.swarm is not None:
        yield "_flow", plan.plot(mission, view="flow")[0]


def _compact(picture: bytes) -> bytes:
    """A PNG with a palette."""
    with Image.open(io.BytesIO(picture)) as image:
        packed = io.BytesIO()
        image.convert("RGB").quantize(COLOURS, dither=Image.Dither.NONE).save(
            packed, "PNG", optimize=True
        )
    return packed.getvalue()


if __name__ == "__main__":
    sys.exit(main())
