"""Commands and options. Nothing here imports more than argparse, so that help comes at once."""

from __future__ import annotations

import argparse
import math
from enum import IntEnum
from pathlib import Path


class Exit(IntEnum):
    """What the process's exit code says."""

    DONE = 0
    REFUSED = 1  # check: the plan does not hold; lint: something looks odd
    BAD_INPUT = 2
    INFEASIBLE = 3
    NO_PLAN = 4
    FAILED = 5
    INTERRUPTED = 130


_CODES = """exit codes of plan: 0 a verified plan, 2 bad input or usage, 3 infeasible,
4 no plan within the limits, 5 internal or solver failure"""


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
    _parse(commands)
    _show(commands)
    _lint(commands)
    return top


def _plan(commands: argparse._SubParsersAction[argparse.ArgumentParser]) -> None:
    plan = commands.add_parser(
        "plan", help="plan a mission and print the verified plan", epilog=_CODES
    )
    plan.add_argument("mission", type=Path, metavar="MISSION", help="mission file (YAML)")
    plan.add_argument("--solver", metavar="NAME", help="highs (default), gurobi, pulp, pulp:NAME")
    plan.add_argument("--time-limit", type=_positive, metavar="S", help="seconds of search")
    plan.add_argument("--gap", type=_share, metavar="G", help="accepted relative gap, as in 0.05")
    plan.add_argument("--threads", type=_count, metavar="N", help="threads of the solver")
    plan.add_argument("--seed", type=_seed, metavar="N", help="another seed, another equal plan")
    plan.add_argument(
        "--encoding",
        choices=("tight", "reference"),
        default="tight",
        help="tight (default), or the slow plain one to compare with",
    )
    plan.add_argument("-o", "--output", type=Path, metavar="FILE", help="write the plan as JSON")
    plan.add_argument("--json", action="store_true", help="print the JSON alone")
    plan.add_argument("--quiet", action="store_true", help="no progress and no summary")


def _explain(commands: argparse._SubParsersAction[argparse.ArgumentParser]) -> None:
    explain = commands.add_parser(
        "explain",
        help="say why there is no plan and what would help; what is tight where there is one",
        epilog="exit codes: 0 explained, 2 bad input or usage, 4 no answer within the time limit",
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


def _parse(commands: argparse._SubParsersAction[argparse.ArgumentParser]) -> None:
    parse = commands.add_parser("parse", help="show what a formula means")
    parse.add_argument("formula", metavar="FORMULA", help="the formula's text")
    parse.add_argument("--language", choices=("catl", "mtl", "stl"), required=True)


def _show(commands: argparse._SubParsersAction[argparse.ArgumentParser]) -> None:
    show = commands.add_parser("show", help="draw a map, a mission or a plan")
    show.add_argument("file", type=Path, metavar="FILE", help="map, mission or plan file")
    show.add_argument("-o", "--output", type=Path, metavar="PNG", help="picture to write")
    show.add_argument(
        "--mission",
        type=Path,
        metavar="MISSION",
        help="mission of a plan, to draw its paths on the map (default: looked for beside it)",
    )


def _lint(commands: argparse._SubParsersAction[argparse.ArgumentParser]) -> None:
    lint = commands.add_parser("lint", help="say what looks odd in a map; exit code 0 or 1")
    lint.add_argument("map", type=Path, metavar="MAP", help="map file (YAML)")


def _number(text: str) -> float:
    try:
        value = float(text)
    except ValueError:
        raise argparse.ArgumentTypeError(f"'{text}' is not a number") from None
    if not math.isfinite(value):
        raise argparse.ArgumentTypeError(f"'{text}' is not a finite number")
    return value


def _positive(text: str) -> float:
    value = _number(text)
    if value <= 0:
        raise argparse.ArgumentTypeError(f"'{text}' is not above 0")
    return value


def _share(text: str) -> float:
    value = _number(text)
    if value < 0:
        raise argparse.ArgumentTypeError(f"'{text}' is below 0")
    return value


def _whole(text: str, least: int) -> int:
    try:
        value = int(text)
    except ValueError:
        raise argparse.ArgumentTypeError(f"'{text}' is not a whole number") from None
    if value < least:
        raise argparse.ArgumentTypeError(f"'{text}' is below {least}")
    return value


def _count(text: str) -> int:
    return _whole(text, 1)


def _seed(text: str) -> int:
    return _whole(text, 0)
