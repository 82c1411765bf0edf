"""Run the tests with the lowest and with the newest versions of what the project depends on.

    python scripts/lanes.py [--lane lowest|newest|all] [--python 3.12 ...] [--short] [--folder F]

Each lane is a fresh virtual environment, for every Python of the project's classifiers that is
found on the PATH or among pyenv's:

lowest
    Every dependency in the lowest version that its range in `pyproject.toml` names.
newest
    Every dependency in the newest version that its range allows. Where a dependency has a newer
    release that its range leaves out, the tests run once more with that one release; how that ends
    is told and never fails.

`--short` runs only the tests that touch other libraries closely. The exit code is 1 if a lane that
has to pass does not, 2 if a Python that was asked for by name is not found.
"""

from __future__ import annotations

import argparse
import json
import os
import shutil
import subprocess
import sys
import tempfile
import tomllib
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import Any

from packaging.requirements import Requirement
from packaging.specifiers import SpecifierSet
from packaging.utils import canonicalize_name
from packaging.version import Version

ROOT = Path(__file__).resolve().parent.parent
EXTRA = "test"  # what the tests need; the rest of `dev` looks at the code without running it
SHORT = (
    "cli_plan",
    "corpus",
    "document",
    "draw",
    "encode",
    "environments",
    "logic_parse",
    "milp",
    "mission",
    "plans",
    "problem",
    "readme",
    "solvers",
    "ts",
    "viewer_animation",
)
"""Beginnings of the names of test files that the short set holds."""

_FLOORS, _CAPS = (">=", "==", "~="), ("<", "<=", "==", "~=", "===")
_PROBE = "import sys, venv, ensurepip; print('%d.%d' % sys.version_info[:2])"
_LIST = (
    "import json, importlib.metadata as m; "
    "print(json.dumps({d.name: d.version for d in m.distributions()}))"
)


@dataclass(frozen=True)
class Outcome:
    """How the tests of one lane ended."""

    lane: str
    python: str
    versions: Mapping[str, str]
    words: str
    passed: bool
    binding: bool = True

    @property
    def failed(self) -> bool:
        """Whether the whole run fails for it."""
        return self.binding and not self.passed


class LaneError(Exception):
    """A lane cannot be made; the message says why."""


# --- what pyproject.toml says ----------------------------------------------------------------


def project_table(path: Path = ROOT / "pyproject.toml") -> dict[str, Any]:
    """The `project` table."""
    with path.open("rb") as file:
        table: dict[str, Any] = tomllib.load(file)["project"]
    return table


def pythons(project: Mapping[str, Any]) -> list[str]:
    """The versions of Python that the classifiers name.

    >>> pythons({"classifiers": ["Programming Language :: Python :: 3.12", "Topic :: Other"]})
    ['3.12']
    """
    words = [classifier.split(" :: ") for classifier in project.get("classifiers", ())]
    return [parts[-1] for parts in words if parts[1:2] == ["Python"] and "." in parts[-1]]


def requirements(project: Mapping[str, Any], extra: str, python: str) -> list[Requirement]:
    """What the project and one of its extras need for one Python, each once.

    Extras that name the project itself with other extras are followed.
    """
    environment = {"python_version": python, "python_full_version": f"{python}.0", "extra": ""}
    texts = [*project["dependencies"], *_followed(project, extra)]
    asked = [Requirement(text) for text in texts]
    return [
        Requirement(f"{_named(item)}{item.specifier}")
        for item in asked
        if item.marker is None or item.marker.evaluate(environment)
    ]


def _followed(project: Mapping[str, Any], extra: str) -> Iterator[str]:
    own = canonicalize_name(project["name"])
    for text in project["optional-dependencies"][extra]:
        item = Requirement(text)
        if canonicalize_name(item.name) != own:
            yield text
            continue
        for inner in sorted(item.extras):
            yield from _followed(project, inner)


def lowest(requirement: Requirement) -> Version:
    """The lowest version that a range names.

    Raises LaneError for a range that names none, or that leaves out the one it names.

    >>> lowest(Requirement("rich>=13,<15"))
    <Version('13')>
    """
    floors = [Version(part.version) for part in requirement.specifier if part.operator in _FLOORS]
    if not floors:
        raise LaneError(f"'{requirement}' names no lowest version; write '{requirement.name}>=...'")
    if max(floors) not in requirement.specifier:
        raise LaneError(f"'{requirement}' leaves out {max(floors)}, the lowest version it names")
    return max(floors)


def pinned(requirement: Requirement) -> str:
    """The requirement of the lowest version alone.

    >>> pinned(Requirement("numpy>=1.26"))
    'numpy==1.26'
    """
    return f"{_named(requirement)}=={lowest(requirement)}"


def caps(requirement: Requirement) -> SpecifierSet:
    """The parts of a range that leave newer versions out.

    >>> caps(Requirement("pulp>=3,!=3.1,<5"))
    <SpecifierSet('<5')>
    """
    found = (str(part) for part in requirement.specifier if part.operator in _CAPS)
    return SpecifierSet(",".join(found))


def uncapped(requirement: Requirement) -> str:
    """The requirement without its caps.

    >>> uncapped(Requirement("pulp>=3,<5"))
    'pulp>=3'
    """
    kept = (str(part) for part in requirement.specifier if part.operator not in _CAPS)
    return _named(requirement) + ",".join(sorted(kept))


def _named(requirement: Requirement) -> str:
    """The name with its extras."""
    extras = ",".join(sorted(requirement.extras))
    return f"{requirement.name}[{extras}]" if extras else requirement.name


def short_set(folder: Path = ROOT / "tests") -> list[str]:
    """The test files of the short set."""
    found = {path for name in SHORT for path in folder.glob(f"test_{name}*.py")}
    return [str(path) for path in sorted(found)]


# --- interpreters ----------------------------------------------------------------------------


def interpreters(wanted: Sequence[str]) -> dict[str, str]:
    """The programs of the Pythons that are found and can make virtual environments."""
    found = {}
    for version in wanted:
        program = next((path for path in _candidates(version) if _answer(path) == version), None)
        if program is not None:
            found[version] = program
    return found


def _candidates(version: str) -> Iterator[str]:
    """Programs that may be this Python: this one, the PATH's, pyenv's."""
    yield sys.executable
    for folder in os.get_exec_path():
        path = shutil.which(f"python{version}", path=folder)
        if path is not None:
            yield path
    pyenv = shutil.which("pyenv")
    if pyenv is not None:
        root = subprocess.run([pyenv, "root"], capture_output=True, text=True, check=False)
        versions = Path(root.stdout.strip(), "versions")
        yield from (str(path) for path in sorted(versions.glob(f"{version}.*/bin/python")))


def _answer(program: str) -> str | None:
    """The version of a Python that can make virtual environments; None for what cannot."""
    answer = subprocess.run([program, "-c", _PROBE], capture_output=True, text=True, check=False)
    return answer.stdout.strip() if answer.returncode == 0 else None


# --- lanes -----------------------------------------------------------------------------------


@dataclass(frozen=True)
class Lane:
    """A virtual environment for one Python, and the tests that are run there."""

    folder: Path
    version: str
    tests: tuple[str, ...]

    @property
    def python(self) -> str:
        """Its interpreter."""
        below = ("Scripts", "python.exe") if os.name == "nt" else ("bin", "python")
        return str(self.folder.joinpath(*below))

    def make(self, program: str, needs: Sequence[str]) -> None:
        """Make it afresh with these requirements. Raises LaneError."""
        _run([program, "-m", "venv", "--clear", str(self.folder)])
        self.install(needs)

    def install(self, needs: Sequence[str]) -> None:
        """Bring these requirements in, in the newest versions they allow. Raises LaneError."""
        _run([self.python, "-m", "pip", "install", "--quiet", "--upgrade", *needs])

    def versions(self, needs: Sequence[Requirement]) -> dict[str, str]:
        """The installed version of each requirement."""
        text = _run([self.python, "-c", _LIST])
        there = {canonicalize_name(name): version for name, version in json.loads(text).items()}
        return {item.name: there[canonicalize_name(item.name)] for item in needs}

    def run(self, name: str, needs: Sequence[Requirement], *, binding: bool = True) -> Outcome:
        """Run the tests, pass on what they say, and tell how they ended."""
        versions = self.versions(needs)
        print(f"\n=== {name}, Python {self.version}: {_listed(versions)}", flush=True)
        command = [self.python, "-m", "pytest", "-p", "no:cacheprovider", "-n", "auto", *self.tests]
        paths = {"PYTHONPATH": str(ROOT)}
        answer = subprocess.run(
            command,
            cwd=ROOT,
            env=os.environ | paths,
            stdout=subprocess.PIPE,
            text=True,
            check=False,
        )
        print(answer.stdout, flush=True)
        last = answer.stdout.strip().splitlines()[-1:] or ["no answer"]
        words = last[0].strip("= ")
        return Outcome(name, self.version, versions, words, answer.returncode == 0, binding)


def _run(command: Sequence[str]) -> str:
    """Run a command and hand back what it prints. Raises LaneError with what went wrong."""
    answer = subprocess.run(command, capture_output=True, text=True, check=False)
    if answer.returncode:
        lines = [line for line in answer.stderr.splitlines() if line.startswith("ERROR")]
        said = (lines or answer.stderr.splitlines() or ["no reason given"])[-1]
        raise LaneError(f"{' '.join(command[:4])} ... failed: {said}")
    return answer.stdout


def run_lowest(lane: Lane, program: str, needs: Sequence[Requirement]) -> list[Outcome]:
    """The lane of the lowest versions."""
    lane.make(program, [pinned(item) for item in needs])
    return [lane.run("lowest", needs)]


def run_newest(lane: Lane, program: str, needs: Sequence[Requirement]) -> list[Outcome]:
    """The lane of the newest versions, then once more for each release that a cap leaves out."""
    lane.make(program, [str(item) for item in needs])
    found = [lane.run("newest", needs)]
    for item in needs:
        if not caps(item):
            continue
        lane.install([uncapped(item)])
        version = lane.versions([item])[item.name]
        if version in item.specifier:
            continue
        name = f"{item.name} {version} (outside {caps(item)})"
        found.append(lane.run(name, needs, binding=False))
        lane.install([str(item)])
    return found


LANES = {"lowest": run_lowest, "newest": run_newest}


def tried(name: str, lane: Lane, program: str, needs: Sequence[Requirement]) -> list[Outcome]:
    """The outcomes of a lane; one that cannot be made has failed."""
    try:
        return LANES[name](lane, program, needs)
    except LaneError as error:
        return [Outcome(name, lane.version, {}, str(error), passed=False)]
    finally:
        shutil.rmtree(lane.folder, ignore_errors=True)


# --- what is told ----------------------------------------------------------------------------


def _listed(versions: Mapping[str, str]) -> str:
    return ", ".join(f"{name} {version}" for name, version in versions.items())


def table(outcomes: Sequence[Outcome]) -> str:
    """The outcomes, a line each: lane, Python, how it ended; then the versions of each lane."""
    width = max(len(outcome.lane) for outcome in outcomes)
    lines = [f"{'lane':{width}}  Python  outcome"]
    for outcome in outcomes:
        mark = "ok" if outcome.passed else "FAILED" if outcome.binding else "fails (reported)"
        lines.append(f"{outcome.lane:{width}}  {outcome.python:6}  {mark}: {outcome.words}")
    lines.append("")
    lines += [f"{o.lane}, {o.python}: {_listed(o.versions)}" for o in outcomes if o.versions]
    return "\n".join(lines)


def arguments() -> argparse.Namespace:
    """What is asked for on the command line."""
    parser = argparse.ArgumentParser(
        description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter
    )
    parser.add_argument("--lane", choices=[*LANES, "all"], default="all")
    parser.add_argument("--python", action="append", metavar="3.X", help="default: all found")
    parser.add_argument("--short", action="store_true", help="the short set of tests")
    parser.add_argument(
        "--folder", type=Path, help="where to make environments; default: temporary"
    )
    parser.add_argument("tests", nargs="*", help="test files; default: all")
    return parser.parse_args()


def main() -> int:
    """Run the lanes and print the table."""
    options = arguments()
    project = project_table()
    wanted = options.python or pythons(project)
    found = interpreters(wanted)
    missing = [version for version in wanted if version not in found]
    print(f"Python {', '.join(found) or 'none'} found; not found: {', '.join(missing) or 'none'}")
    if not found or (options.python and missing):
        return 2
    tests = tuple(options.tests or (short_set() if options.short else ()))
    names = list(LANES) if options.lane == "all" else [options.lane]
    outcomes = []
    with tempfile.TemporaryDirectory(prefix="tsplan-lanes-", dir=options.folder) as folder:
        for version, program in found.items():
            needs = requirements(project, EXTRA, version)
            for name in names:
                lane = Lane(Path(folder, f"{name}-{version}"), version, tests)
                outcomes += tried(name, lane, program, needs)
    print(table(outcomes))
    return int(any(outcome.failed for outcome in outcomes))


if __name__ == "__main__":
    sys.exit(main())
