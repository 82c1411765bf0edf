"""Commands and options. Nothing here imports more than argparse needs, so help comes at once."""

from __future__ import annotations

import argparse
from collections.abc import Callable
from enum import IntEnum
from pathlib import Path
from typing import TypeVar

from tsplan.limits import DIGITS, LARGEST, OPTIONS, Range

NumberT = TypeVar("NumberT", int, float)


class Exit(IntEnum):
    """What the process's exit code says."""

    DONE = 0
    REFUSED = 1  # check: the plan does not hold; lint: something looks odd
    BAD_INPUT = 2
    INFEASIBLE = 3
    NO_PLAN = 4
    FAILED = 5
    UNSHOWN = 6  # what was found out could not be written to stdout
    INTERRUPTED = 130


MOST_FRAMES = 50  # a second; players of GIFs show no more
LEAST_SIDE, MOST_SIDE = 200, 4000  # dots of a moving picture

_CODES = """exit codes of plan: 0 a verified plan, 2 bad input or usage, 3 infeasible,
4 no plan within the limits, 5 internal or solver failure,
6 the standard output could not be written to"""


def parser() -> argparse.ArgumentParser:
    """The whole command line."""
    from tsplan import __version__  # noqa: PLC0415  (the package is being imported)

    top = argparse.ArgumentParser(
        prog="tsplan",
        description="Plan a team of robots from a map and a temporal-logic formula.",
        epilog=_CODES,
    )
    top.add_argument("--version", action="version", version=f"tsplan {__version__}")
    commands = top.add_subparsers(dest="command", required=True, metavar="COMMAND")
    _plan(commands)
    _explain(commands)
    _check(commands)
    _simulate(commands)
    _parse(commands)
    _show(commands)
    _view(commands)
    _animate(commands)
    _lint(commands)
    return top


def _plan(commands: argparse._SubParsersAction[argparse.ArgumentParser]) -> None:
    plan = commands.add_parser(
        "plan", help="plan a mission and print the verified plan", epilog=_CODES
    )
    plan.add_argument("mission", type=Path, metavar="MISSION", help="mission file (YAML)")
    plan.add_argument("--solver", metavar="NAME", help="highs (default), gurobi, pulp, pulp:NAME")
    plan.add_argument("--time-limit", type=_positive, metavar="S", help="seconds for the whole")
    plan.add_argument("--gap", type=_share, metavar="G", help="accepted relative gap, as in 0.05")
    plan.add_argument("--threads", type=_threads, metavar="N", help="threads of the solver")
    plan.add_argument("--seed", type=_seed, metavar="N", help="another seed, another equal plan")
    plan.add_argument(
        "--encoding",
        choices=("tight", "reference"),
        default="tight",
        help="tight (default), or the slow plain one to compare with",
    )
    plan.add_argument(
        "--without",
        action="append",
        default=[],
        metavar="IDEA",
        help="switch an idea of the tight encoding off, to find a culprit; may be repeated",
    )
    plan.add_argument(
        "--agents", action="store_true", help="a path for every agent of a swarm, however many"
    )
    plan.add_argument("-o", "--output", type=Path, metavar="FILE", help="write the plan as JSON")
    plan.add_argument("--json", action="store_true", help="print the JSON alone")
    plan.add_argument("--quiet", action="store_true", help="no progress and no summary")


def _explain(commands: argparse._SubParsersAction[argparse.ArgumentParser]) -> None:
    explain = commands.add_parser(
        "explain",
        help="say why there is no plan and what would help; what is tight where there is one",
        epilog="exit codes: 0 explained, 2 bad input or usage, 4 no answer within the time limit, "
        "5 internal or solver failure, 6 the standard output could not be written to",
    )
    explain.add_argument("mission", type=Path, metavar="MISSION", help="mission file (YAML)")
    explain.add_argument("--all", action="store_true", help="several different conflicts")
    explain.add_argument(
        "--slack", action="store_true", help="how much sooner each deadline of a plan could be"
    )
    explain.add_argument("--solver", metavar="NAME", help="highs (default), gurobi, pulp, ...")
    explain.add_argument("--time-limit", type=_positive, metavar="S", help="seconds of search")
    explain.add_argument("--fix", type=_count, metavar="N", help="write the mission after change N")
    explain.add_argument("-o", "--output", type=Path, metavar="FILE", help="where --fix writes it")
    explain.add_argument("--json", action="store_true", help="print the JSON alone")


def _check(commands: argparse._SubParsersAction[argparse.ArgumentParser]) -> None:
    check = commands.add_parser("check", help="judge a plan without any solver; exit code 0 or 1")
    check.add_argument("mission", type=Path, metavar="MISSION", help="mission file (YAML)")
    check.add_argument("plan", type=Path, metavar="PLAN", help="plan file (JSON)")
    check.add_argument("--quiet", action="store_true", help="print only what is wrong")


def _simulate(commands: argparse._SubParsersAction[argparse.ArgumentParser]) -> None:
    simulate = commands.add_parser(
        "simulate", help="let the agents of a swarm follow their plan's shares by chance"
    )
    simulate.add_argument("mission", type=Path, metavar="MISSION", help="mission file (YAML)")
    simulate.add_argument("plan", type=Path, metavar="PLAN", help="plan file (JSON)")
    simulate.add_argument("--runs", type=_runs, default=1000, metavar="N", help="default 1000")
    simulate.add_argument("--seed", type=_seed, default=0, metavar="N", help="of the chances")
    simulate.add_argument(
        "--probability",
        type=_chance,
        default=0.95,
        metavar="P",
        help="say which margin makes the formula hold so often (default 0.95)",
    )


def _parse(commands: argparse._SubParsersAction[argparse.ArgumentParser]) -> None:
    parse = commands.add_parser("parse", help="show what a formula means")
    parse.add_argument("formula", metavar="FORMULA", help="the formula's text")
    parse.add_argument("--language", choices=("catl", "mtl", "stl"), required=True)


def _show(commands: argparse._SubParsersAction[argparse.ArgumentParser]) -> None:
    show = commands.add_parser("show", help="draw a map, a mission or a plan; say why a plan holds")
    show.add_argument("file", type=Path, metavar="FILE", help="map, mission or plan file")
    show.add_argument(
        "-o", "--output", type=Path, metavar="PICTURE", help="write .png, .svg or .pdf, no window"
    )
    show.add_argument(
        "--mission",
        type=Path,
        metavar="MISSION",
        help="mission of a plan, to draw its paths on the map (default: looked for beside it)",
    )
    show.add_argument(
        "--view",
        choices=("page", "paths", "timeline", "requirements", "flow", "map"),
        help="picture of a plan: everything on one page (default), or one view of it",
    )
    show.add_argument(
        "--why",
        action="store_true",
        help="print why a plan satisfies its formula: where each part holds, and by whom",
    )


def _view(commands: argparse._SubParsersAction[argparse.ArgumentParser]) -> None:
    view = commands.add_parser("view", help="play a plan in the browser, from one file")
    view.add_argument("plan", type=Path, metavar="PLAN", help="plan file (JSON)")
    _mission_of_plan(view)
    view.add_argument(
        "-o", "--output", type=Path, metavar="HTML", help="write the page here and open nothing"
    )


def _animate(commands: argparse._SubParsersAction[argparse.ArgumentParser]) -> None:
    animate = commands.add_parser("animate", help="write a plan as a moving picture")
    animate.add_argument("plan", type=Path, metavar="PLAN", help="plan file (JSON)")
    _mission_of_plan(animate)
    animate.add_argument(
        "-o",
        "--output",
        type=Path,
        required=True,
        metavar="FILE",
        help="picture to write: .gif, .mp4 (needs ffmpeg) or .html (see view)",
    )
    animate.add_argument("--fps", type=_frames, metavar="N", help="pictures a second (default 10)")
    animate.add_argument(
        "--seconds-per-step",
        type=_positive,
        metavar="S",
        help="default 0.6, less where the whole would take more than 30 seconds",
    )
    animate.add_argument("--size", type=_size, metavar="WxH", help="in dots (default 960x600)")


def _mission_of_plan(command: argparse.ArgumentParser) -> None:
    command.add_argument(
        "--mission",
        type=Path,
        metavar="MISSION",
        help="mission of the plan (default: looked for beside it)",
    )


def _lint(commands: argparse._SubParsersAction[argparse.ArgumentParser]) -> None:
    lint = commands.add_parser("lint", help="say what looks odd in a map; exit code 0 or 1")
    lint.add_argument("map", type=Path, metavar="MAP", help="map file (YAML)")


def _number(text: str) -> float:
    try:
        return float(text)
    except ValueError:
        raise argparse.ArgumentTypeError(f"'{_clipped(text)}' is not a number") from None


def _clipped(text: str) -> str:
    return text if len(text) <= DIGITS else f"{text[:DIGITS]}..."


def _real(allowed: Range) -> Callable[[str], float]:
    """A reader of numbers in a range."""

    def read(text: str) -> float:
        return allowed_only(_number(text), allowed)

    return read


def _whole(allowed: Range) -> Callable[[str], int]:
    """A reader of whole numbers in a range."""

    def read(text: str) -> int:
        try:
            value = int(text)
        except ValueError:
            raise argparse.ArgumentTypeError(f"'{_clipped(text)}' is not a whole number") from None
        return allowed_only(value, allowed)

    return read


def allowed_only(value: NumberT, allowed: Range) -> NumberT:
    """The value, if its range allows it."""
    words = allowed.complaint(value)
    if words is not None:
        raise argparse.ArgumentTypeError(words)
    return value


def _size(text: str) -> tuple[int, int]:
    width, cross, height = text.lower().partition("x")
    if not cross:
        raise argparse.ArgumentTypeError(f"'{text}' is not WIDTHxHEIGHT, as in 960x600")
    side = _whole(Range(LEAST_SIDE, LARGEST, whole=True))
    size = side(width), side(height)
    if max(size) > MOST_SIDE:
        raise argparse.ArgumentTypeError(f"'{text}' is larger than {MOST_SIDE}x{MOST_SIDE}")
    return size


_positive = _real(OPTIONS["time_limit"])
_share = _real(OPTIONS["gap"])
_chance = _real(OPTIONS["probability"])
_count = _whole(Range(1, LARGEST, whole=True))
_threads = _whole(OPTIONS["threads"])
_seed = _whole(OPTIONS["seed"])
_runs = _whole(OPTIONS["runs"])
_frames = _whole(Range(1, MOST_FRAMES, whole=True))
