"""Commands and options. Nothing here imports more than argparse needs, so help comes at once."""

from __future__ import annotations

import argparse
from collections.abc import Callable
from enum import IntEnum
from pathlib import Path

from tsplan.cli import argument_values as values
from tsplan.cli.first_commands import Commands, add_first_commands
from tsplan.version import VERSION


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


_CODES = """exit codes of plan: 0 a verified plan, 2 bad input or usage, 3 infeasible,
4 no plan within the limits, 5 internal or solver failure,
6 the standard output could not be written to"""


def parser() -> argparse.ArgumentParser:
    """The whole command line."""
    top = argparse.ArgumentParser(
        prog="tsplan",
        description="Plan a team of robots, or signals, from a temporal-logic formula.",
        epilog=_CODES,
    )
    top.add_argument("--version", action="version", version=f"tsplan {VERSION}")
    commands = top.add_subparsers(dest="command", required=True, metavar="COMMAND")
    every = (
        _plan,
        _replan,
        _execute,
        _sweep,
        _explain,
        _check,
        _verify,
        _simulate,
        _parse,
        _robustness,
    )
    shown = (_show, _view, _animate, _export, _lint, _map)
    for command in (*every, *shown):
        command(commands)
    add_first_commands(commands)
    return top


_FILES = {
    "mission": "mission file (YAML)",
    "plan": "file of a plan or a trajectory (JSON)",
    "trace": "signals over steps (CSV): a line of names, then a row of numbers for each step",
}


def _command(
    commands: Commands, name: str, words: str, *files: str, epilog: str | None = None
) -> Callable[..., object]:
    """A new command that reads some files; what adds further arguments to it."""
    command = commands.add_parser(name, help=words, epilog=epilog)
    for file in files:
        command.add_argument(file, type=Path, metavar=file.upper(), help=_FILES[file])
    return command.add_argument


def _plan(commands: Commands) -> None:
    words = "plan a mission and print the verified plan"
    add = _command(commands, "plan", words, "mission", epilog=_CODES)
    _solving(add)
    what = "call nothing proven that only a solver says: the own tree proves it exactly"
    add("--certified", action="store_true", help=what)
    what = "write what proves it (VIPR), with --certified; several objectives: FILE with numbers"
    add("--certificate", type=Path, metavar="FILE", help=what)
    add(
        "--encoding",
        choices=("tight", "reference"),
        default="tight",
        help="tight (default), or the slow plain one to compare with",
    )
    add(
        "--without",
        action="append",
        default=[],
        metavar="IDEA",
        help="switch an idea of the tight encoding off, to find a culprit; may be repeated",
    )
    pieces = "plan in pieces: windows of so many steps, for missions that are too long for one"
    add("--window", type=values.count, metavar="STEPS", help=pieces)
    kept = "steps of each window that are kept (default: a third of it)"
    add("--commit", type=values.count, metavar="STEPS", help=kept)
    old = "begin the search with the paths of this plan, of the mission or of one like it (JSON)"
    add("--start", type=Path, metavar="PLAN", help=old)
    each = "a path for every agent of a swarm, and an entry for every agent, however many"
    add("--agents", action="store_true", help=each)
    add("-o", "--output", type=Path, metavar="FILE", help="write the plan as JSON")
    add("--json", action="store_true", help="print the JSON alone")
    add(
        "--log-solver",
        action="store_true",
        help="print on stderr what the solver says of each integer program",
    )
    add("--quiet", action="store_true", help="no progress and no summary")


def _replan(commands: Commands) -> None:
    words = "plan again from a step of a plan on, as things are there"
    add = _command(commands, "replan", words, "mission", "plan", epilog=_CODES)
    add(
        "--at", type=values.whole, metavar="STEP", help="the step from which on it is planned again"
    )
    many = {"action": "append", "default": [], "help": ""}
    told = {
        "lost": ("AGENTS", "agents that are gone for good, with commas between them"),
        "moved": ("AGENT=PLACE", "it is at a state, or on an edge as in scout-1=q1-q2@9"),
        "late": ("AGENT=STEPS", "it arrives, or has arrived, so many steps late"),
        "closed": ("PLACE", "nobody may enter a state, or an edge as in q1-q2 (until @STEP)"),
        "opened": ("EDGE=STEPS", "an edge, both ways, is there or takes as long, as in q1-q2=3"),
        "demand": ("FORMULA", "has to hold, judged at that step"),
        "withdraw": ("PART", "part of the mission's formula that has not to hold any more"),
        "deadline": ("PART=STEP", "the last step of the window of a part, counted as there"),
    }
    for name, (value, what) in told.items():
        listed = name in ("lost", "moved", "late", "closed", "opened")
        kind = values.names if listed else str
        action = "extend" if listed else "append"
        how = {**many, "action": action, "help": f"{what}; may be repeated"}
        add(f"--{name}", type=kind, metavar=value, **how)
    add("--world", type=Path, metavar="FILE", help="the same and more from a file (YAML)")
    names = "objectives in place of the mission's, with commas between them, as stability,travel"
    add("--objective", type=values.names, metavar="NAMES", default=[], help=names)
    add("--rest", type=Path, metavar="FILE", help="write the mission that is left (YAML)")
    _solving(add)
    add("-o", "--output", type=Path, metavar="FILE", help="write the whole plan as JSON")
    add("--json", action="store_true", help="print the JSON alone")
    add("--quiet", action="store_true", help="no progress and no summary")
    add("--agents", action="store_true", help="an entry for every agent, however many")


def _execute(commands: Commands) -> None:
    words = "carry out a plan by chance or with robots, planning again where it does not work"
    add = _command(commands, "execute", words, "mission", "plan")
    add("--runs", type=values.runs, default=100, metavar="N", help="runs by chance (default 100)")
    add("--seed", type=values.seed, metavar="N", help="that of the first run (default 0)")
    chances = {
        "delay": ("a move takes a step longer, and again", 0.1),
        "loss": ("an agent is lost at a step", 0.0),
        "close": ("one of the edges closes for good at a step", 0.0),
    }
    for name, (what, most) in chances.items():
        how = f"chance that {what} (default {most:g})"
        add(f"--{name}", type=values.chance, default=most, metavar="P", help=how)
    drawn = "draw how often the formula held, and how long planning again took"
    add("--plot", type=Path, metavar="PICTURE", help=drawn)
    add("--robots", metavar="COMMAND", help="one execution by a process that speaks JSON lines")
    wait = "seconds in which the robots have to answer (default 60)"
    add("--patience", type=values.positive, default=60.0, metavar="S", help=wait)
    kept = "keep every step here, and go on where it ends"
    add("--journal", type=Path, metavar="FILE", help=kept)
    add(
        "--replanning",
        action=argparse.BooleanOptionalAction,
        default=True,
        help="plan again where the plan does not work any more (default)",
    )
    add("--solver", metavar="NAME", help="highs (default), gurobi, pulp, pulp:NAME")
    add(
        "--time-limit", type=values.positive, metavar="S", help="seconds to plan again (default 10)"
    )
    add("-o", "--output", type=Path, metavar="FILE", help="write what happened as a plan (JSON)")
    add("--json", action="store_true", help="print the runs as JSON alone")
    add("--quiet", action="store_true", help="no progress")


def _solving(add: Callable[..., object]) -> None:
    """What is chosen of the solver."""
    add("--solver", metavar="NAME", help="highs (default), gurobi, pulp, pulp:NAME")
    add("--time-limit", type=values.positive, metavar="S", help="seconds for the whole")
    add("--gap", type=values.share, metavar="G", help="accepted relative gap, as in 0.05")
    add(
        "--anytime",
        action=argparse.BooleanOptionalAction,
        default=True,
        help="go on improving until the limit or proof (default), or end with the first plan",
    )
    add("--threads", type=values.threads, metavar="N", help="threads of the solver")
    add("--seed", type=values.seed, metavar="N", help="another seed, another equal plan")


def _sweep(commands: Commands) -> None:
    words = "plan many missions, and keep a table of the results that can be gone on with"
    codes = (
        "exit codes: 0 every run is recorded, failed ones too, 2 bad input or usage, 5 the cluster "
        "cannot be used or has dropped runs, 6 the standard output could not be written to, "
        "130 interrupted: what was done is recorded"
    )
    add = _command(commands, "sweep", words, epilog=codes)
    add("file", type=Path, metavar="FILE", help="sweep file (YAML), or a folder of missions")
    what = "table to write, the journal beside it (default: named after FILE, in this folder)"
    add("-o", "--output", type=Path, metavar="CSV", help=what)
    add("--jobs", type=values.jobs, default=1, metavar="N", help="runs side by side (default 1)")
    add("--dask", metavar="ADDRESS", help="run on the cluster of a scheduler, or 'local'")
    add("--fresh", action="store_true", help="forget what is recorded and start anew")
    add("--retry", action="store_true", help="once more the runs that have failed")
    add("--plans", type=Path, metavar="FOLDER", help="keep the plan of each run there")
    add("--plot", type=Path, metavar="PICTURE", help="draw the seconds by each axis")
    add("--solver", metavar="NAME", help="for every run, whatever files say")
    add("--time-limit", type=values.positive, metavar="S", help="seconds for each run, likewise")
    add("--gap", type=values.share, metavar="G", help="accepted relative gap, likewise")
    add("--threads", type=values.threads, metavar="N", help="threads of the solver, likewise")
    add("--json", action="store_true", help="print the results as JSON alone")
    add("--quiet", action="store_true", help="no progress and no table")


def _explain(commands: Commands) -> None:
    words = "say why there is no plan and what would help; what is tight where there is one"
    codes = (
        "exit codes: 0 explained, 2 bad input or usage, 4 no answer within the time limit, "
        "5 internal or solver failure, 6 the standard output could not be written to"
    )
    add = _command(commands, "explain", words, "mission", epilog=codes)
    add("--all", action="store_true", help="several different conflicts")
    add("--slack", action="store_true", help="how much sooner each deadline of a plan could be")
    what = "take no solver's word for it that something cannot be met"
    add("--certified", action="store_true", help=what)
    add("--solver", metavar="NAME", help="highs (default), gurobi, pulp, ...")
    add("--time-limit", type=values.positive, metavar="S", help="seconds of search")
    add("--fix", type=values.count, metavar="N", help="write the mission after change N")
    add("-o", "--output", type=Path, metavar="FILE", help="where --fix writes it")
    add("--json", action="store_true", help="print the JSON alone")
    add("--quiet", action="store_true", help="no progress")


def _check(commands: Commands) -> None:
    words = "judge a plan or a trajectory without any solver; exit code 0 or 1"
    add = _command(commands, "check", words, "mission", "plan")
    add("--quiet", action="store_true", help="print only what is wrong")


def _verify(commands: Commands) -> None:
    words = "check certificates of a mission in exact arithmetic; exit code 0 or 1"
    add = _command(commands, "verify", words, "mission")
    what = "what `tsplan plan --certificate` has written"
    add("certificates", type=Path, nargs="+", metavar="CERTIFICATE", help=what)
    what = "a plan (JSON): check it, too, and say whether it is proven to be the best"
    add("--plan", type=Path, metavar="PLAN", help=what)
    add("--quiet", action="store_true", help="print only what is wrong")


def _simulate(commands: Commands) -> None:
    words = "let the agents of a swarm follow their plan by chance, or shake a trajectory"
    add = _command(commands, "simulate", words, "mission", "plan")
    add("--runs", type=values.runs, default=1000, metavar="N", help="default 1000")
    add("--seed", type=values.seed, default=0, metavar="N", help="of the chances")
    add(
        "--amplitude",
        type=values.amplitude,
        action="append",
        default=[],
        metavar="A",
        help="most by which a step shakes every signal, or as NAME=A one of them; may be repeated",
    )
    add(
        "--probability",
        type=values.chance,
        default=0.95,
        metavar="P",
        help="say which margin makes the formula hold so often (default 0.95)",
    )


def _parse(commands: Commands) -> None:
    add = _command(commands, "parse", "show what a formula means")
    _formula(add)
    add("--language", choices=("catl", "mtl", "stl", "wmtl", "wstl"), required=True)


def _formula(add: Callable[..., object]) -> None:
    add("formula", metavar="FORMULA", help="the formula's text, or a file of it")
    add("--weights", type=Path, metavar="FILE", help="what the formula's names of weights mean")


def _robustness(commands: Commands) -> None:
    words = "say by how much a formula holds on recorded signals"
    add = _command(commands, "robustness", words)
    _formula(add)
    add("trace", type=Path, metavar="TRACE", help=_FILES["trace"])
    add("--language", choices=("stl", "wstl"), default="stl", help="stl (default) or wstl")
    kinds = ("traditional", "agm", "product", "normalised")
    what = "traditional (default), by means (agm), or weighted (product, normalised)"
    add("--kind", choices=kinds, default="traditional", help=what)
    ends = "least and greatest value of a signal, as in x=0:10, for agm; may be repeated"
    add(
        "--bounds", type=values.ends, action="extend", nargs="+", default=[], metavar="B", help=ends
    )
    add("--all", action="store_true", help="at every step that can be judged, not only the first")
    add("--json", action="store_true", help="print JSON alone")


def _show(commands: Commands) -> None:
    words = "draw a map, a mission, a plan or a trajectory; say why one holds"
    add = _command(commands, "show", words)
    add("file", type=Path, metavar="FILE", help="map, mission, plan or trajectory file")
    add("-o", "--output", type=Path, metavar="PICTURE", help="write .png, .svg or .pdf, no window")
    what = "mission of a plan, to draw its paths on the map (default: looked for beside it)"
    add("--mission", type=Path, metavar="MISSION", help=what)
    add(
        "--view",
        choices=(
            "page",
            "paths",
            "timeline",
            "requirements",
            "stocks",
            "flow",
            "policy",
            "map",
            "signals",
            "plane",
        ),
        help="everything on one page (default), or one view; signals, plane: of a trajectory",
    )
    why = "print why the formula holds: where each part does, by whom or by how much"
    add("--why", action="store_true", help=why)
    add("--step", type=values.moment, metavar="K", help="step to look at: who is where then")
    who = "ids or classes, with commas between them, whose paths and rows to draw (default: all)"
    add("--agents", type=values.names, action="extend", default=[], metavar="IDS", help=who)
    add("--executed", type=Path, metavar="PLAN", help=_EXECUTED)
    add(
        "--size",
        type=values.sheet,
        metavar="WxH",
        help="in inches, as in 7x4.5 (default: as it needs)",
    )
    add("--dpi", type=values.dots, metavar="N", help="dots per inch of a .png file (default 150)")
    add("--dark", action="store_true", help="on a dark ground")


_OF_PLAN = "mission of the plan (default: looked for beside it)"
_EXECUTED = "what really happened, as the file of a plan: shown beside what was planned"


def _view(commands: Commands) -> None:
    add = _command(
        commands, "view", "play a plan or a trajectory in the browser, from one file", "plan"
    )
    add("--mission", type=Path, metavar="MISSION", help=_OF_PLAN)
    what = "write the page here and open nothing"
    add("-o", "--output", type=Path, metavar="HTML", help=what)
    add("--step", type=values.moment, metavar="K", help="step at which the page opens")
    add("--executed", type=Path, metavar="PLAN", help=_EXECUTED)


def _animate(commands: Commands) -> None:
    add = _command(commands, "animate", "write a plan or a trajectory as a moving picture", "plan")
    add("--mission", type=Path, metavar="MISSION", help=_OF_PLAN)
    what = "picture to write: .gif, .mp4 (needs ffmpeg) or .html (see view)"
    add("-o", "--output", type=Path, required=True, metavar="FILE", help=what)
    add("--fps", type=values.frames, metavar="N", help="pictures a second (default 10)")
    seconds = "default 0.6, less where the whole would take more than 30 seconds"
    add("--seconds-per-step", type=values.positive, metavar="S", help=seconds)
    add("--size", type=values.size, metavar="WxH", help="in dots (default 960x600)")


def _export(commands: Commands) -> None:
    words = "write a plan for other programs: robots' navigation, fleets, viewers, tables"
    add = _command(commands, "export", words, "plan")
    formats = (
        "nav2, rmf, planviz, movingai, csv, geojson, graphml, or one that another package adds"
    )
    add("--to", required=True, metavar="FORMAT", help=formats)
    add("--mission", type=Path, metavar="MISSION", help=_OF_PLAN)
    what = "map with the coordinates, ids and seconds to write (default: the mission's)"
    add("--map", type=Path, metavar="MAP", help=what)
    ids = "ids of the agents to write, with commas between them; may be repeated (default: all)"
    add("--agents", type=values.names, action="extend", default=[], metavar="IDS", help=ids)
    add("-o", "--output", type=Path, required=True, metavar="FILE", help="file to write")


def _lint(commands: Commands) -> None:
    words = "say what looks odd in a map or a mission; exit code 0 or 1"
    add = _command(commands, "lint", words)
    add("file", type=Path, metavar="FILE", help="map or mission file")


def _map(commands: Commands) -> None:
    words = "convert a map of another program, and say what is dropped and what looks odd"
    add = _command(commands, "map", words)
    add("file", type=Path, metavar="FILE", help="map file of any format that is known")
    add("-o", "--output", type=Path, metavar="FILE", help="write the map in the own format (YAML)")
    add("--step", type=values.positive, metavar="S", help="seconds of a step (default 1)")
    what = "metres a second (default 1), or of a class as in cart=0.5; may be repeated"
    add("--speed", type=values.speed, action="append", default=[], metavar="V", help=what)
    add("--cell", type=values.positive, metavar="M", help="metres of the side of a cell of a grid")
    what = "most agents at each state, and on each edge both ways, that says nothing of it"
    add("--capacity", type=values.whole, metavar="N", help=what)
    what = "scenario (.scen) of a grid map: -o writes a mission, every robot to its own goal"
    add("--scenario", type=Path, metavar="SCEN", help=what)
    add("--robots", type=values.count, metavar="N", help="the first N robots of the scenario")
    add("--json", action="store_true", help="print the report as JSON alone")
