"""The rooms stand on floors: no import goes up, files import each other in no circle.

All imports are read, those inside functions and those for type checkers too.
"""

from __future__ import annotations

import ast
import sys
from collections import Counter
from collections.abc import Iterator
from dataclasses import dataclass
from pathlib import Path

import networkx as nx
import pytest

import tsplan

PACKAGE = Path(tsplan.__file__).parent
GUIDE = (PACKAGE.parent / "CONTRIBUTING.md").read_text(encoding="utf-8")
DRAWN = GUIDE.split("## Floors")[1].split("```")[1].strip()
# below the rooms are the modules without one, above them `tsplan` itself and `python -m tsplan`
FLOORS = (["base"], *map(str.split, DRAWN.splitlines()), ["top"])
FLOOR = {room: height for height, rooms in enumerate(FLOORS) for room in rooms}

# the one file that may name what is above it: how data asks to be shown
HOOK = "display"
# files whose imports inside functions are meant: for `--help` to be quick, for a package to be
# imported without all that it offers, and for solvers to be loaded where they work alone
BOUNDARIES = (
    "cli.",
    "document.__init__",
    "explanation.__init__",
    "logic.__init__",
    "logic.parsing",
    "milp.solver",
    "run.isolate",
)
# what other packages are imported inside functions: those that may be missing or are slow to load
LATE = frozenset(
    {
        "PIL",
        "ctypes",
        "difflib",
        "gurobipy",
        "networkx",
        "pandas",
        "pulp",
        "pydantic",
        "resource",
        "rich",
    }
    | {"scipy"}
)


Statement = ast.Import | ast.ImportFrom
Modules = dict[str, list[tuple[Statement, bool]]]  # the statements, and whether in a function


@dataclass(frozen=True)
class Import:
    """One import of a module: who imports what, and whether inside a function."""

    importer: str
    imported: str
    late: bool

    def __str__(self) -> str:
        return f"{self.importer} -> {self.imported}"


def files() -> dict[str, Path]:
    """The package's own modules by their names without `tsplan.`, but for what is generated."""
    return {
        ".".join(path.relative_to(PACKAGE).with_suffix("").parts): path
        for path in sorted(PACKAGE.rglob("*.py"))
        if "generated" not in path.parts
    }


def sources() -> Modules:
    """The import statements of the package's own modules."""
    return {name: statements(path.read_text(encoding="utf-8")) for name, path in files().items()}


def imports(modules: Modules) -> Iterator[Import]:
    """Every import of a module of the package, or of another package."""
    for name, found in modules.items():
        for node, late in found:
            for imported in named(node, modules):
                if imported != name:
                    yield Import(name, imported, late)


def statements(text: str) -> list[tuple[Statement, bool]]:
    """The import statements of a text, each with whether it is inside a function.

    Expressions, which are most of a tree, have no statements and are not looked into. The tree is
    not kept: many of them slow down whatever is done, since garbage is sought in them again.
    """
    found: list[tuple[Statement, bool]] = []
    left: list[tuple[ast.AST, bool]] = [(ast.parse(text), False)]
    while left:
        node, late = left.pop()
        if isinstance(node, ast.Import | ast.ImportFrom):
            found.append((node, late))
        late = late or isinstance(node, ast.FunctionDef | ast.AsyncFunctionDef)
        for name in ("body", "orelse", "finalbody", "handlers", "cases"):
            left += [(each, late) for each in getattr(node, name, ())]
    return found


def named(node: Statement, modules: Modules) -> set[str]:
    """The modules that a statement imports; those of the package by their names here."""
    if isinstance(node, ast.Import):
        return {resolved(alias.name, modules) for alias in node.names}
    assert node.level == 0, "relative imports hide where they go"
    base = node.module or ""
    inner = {alias.name for alias in node.names}
    below = {name for name in inner if resolved(f"{base}.{name}", modules) in modules}
    found = {resolved(f"{base}.{name}", modules) for name in below}
    return found | ({resolved(base, modules)} if inner - below else set())


def resolved(full: str, modules: Modules) -> str:
    """The name of a module or package here; another package's first name as it is."""
    own = full.removeprefix("tsplan").removeprefix(".")
    if full != "tsplan" and not full.startswith("tsplan."):
        return f"({full.split('.', maxsplit=1)[0]})"
    return own if own in modules else f"{own}.__init__".removeprefix(".")


def room(module: str) -> str:
    if module in ("__init__", "__main__"):
        return "top"
    return module.split(".", maxsplit=1)[0] if "." in module else "base"


def own(found: list[Import]) -> list[Import]:
    return [item for item in found if not item.imported.startswith("(")]


def arrows_up(found: list[Import]) -> set[str]:
    """Imports of a room that is not on a lower floor."""
    arrows = {
        (item.importer, room(item.importer), room(item.imported))
        for item in own(found)
        if item.importer != HOOK
    }
    return {
        f"up: {importer} -> {other}"
        for importer, one, other in arrows
        if one != other and FLOOR[other] >= FLOOR[one]
    }


def circles(found: list[Import]) -> set[str]:
    """The files of one room from which imports lead back to them.

    Circles through several rooms have an arrow up.
    """
    graph = nx.DiGraph(
        (item.importer, item.imported)
        for item in own(found)
        if room(item.importer) == room(item.imported)
    )
    knots = [knot for knot in nx.strongly_connected_components(graph) if len(knot) > 1]
    return {f"circle: {module}" for knot in knots for module in knot}


def late_imports(found: list[Import]) -> set[str]:
    """Files with imports inside functions that are no boundary, unless of optional packages."""
    return {
        f"late: {item.importer}"
        for item in found
        if item.late
        and not item.importer.startswith(BOUNDARIES)
        and item.imported.strip("()") not in LATE
    }


def same_names(modules: Modules) -> set[str]:
    """Modules of one base name, which nobody can tell apart in a list of files."""
    bases = Counter(module.split(".")[-1] for module in modules)
    return {
        f"name: {module}"
        for module in modules
        for base in [module.split(".")[-1]]
        if bases[base] > 1 and base != "__init__"
    }


def violations(modules: Modules) -> set[str]:
    found = list(imports(modules))
    return arrows_up(found) | circles(found) | late_imports(found) | same_names(modules)


def package(**texts: str) -> Modules:
    """Modules from their texts; `__` in their names stands for a dot."""
    return {name.replace("__", ".", 1): statements(text) for name, text in texts.items()}


def test_what_stands_on_its_floor_is_accepted():
    modules = package(
        errors="",
        logic__nodes="import numpy\nfrom tsplan.errors import TsplanError",
        mission__read="from tsplan.logic.nodes import Formula\nfrom tsplan.logic import nodes",
        cli__main="def run():\n    from tsplan.mission import read",
        mission____init__="",
        logic____init__="",
        display="if TYPE_CHECKING:\n    from tsplan.draw.map import draw_map",
        draw__map="",
    )
    assert violations(modules) == set()


@pytest.mark.parametrize(
    ("text", "violation"),
    [
        ("from tsplan.run.planner import plan", "up: plans.plan -> run"),
        ("from tsplan.run import planner", "up: plans.plan -> run"),
        ("import tsplan.run.planner", "up: plans.plan -> run"),
        ("from tsplan import Mission", "up: plans.plan -> top"),
        ("if TYPE_CHECKING:\n    from tsplan.run.planner import plan", "up: plans.plan -> run"),
        ("from tsplan.plans.moves import Move", "circle: plans.moves"),
        ("def f():\n    from tsplan.errors import Finding", "late: plans.plan"),
        ("class A:\n    def f(self):\n        import json", "late: plans.plan"),
    ],
)
def test_each_violation_is_found(text, violation):
    others = {"errors": "", "run__planner": "", "plans__moves": "import tsplan.plans.plan"}
    assert violation in violations(package(plans__plan=text, __init__="", **others))


def test_rooms_of_one_floor_do_not_import_each_other():
    up = violations(package(encode__a="import tsplan.checking.b", checking__b=""))
    assert up == {"up: encode.a -> checking"}


def test_two_files_of_one_name_are_found():
    modules = package(logic__text="", plans__text="", plans__moves="")
    assert violations(modules) == {"name: logic.text", "name: plans.text"}


def test_every_room_has_a_floor():
    assert {room(module) for module in files()} == set(FLOOR)


def test_no_import_goes_up_or_round():
    assert violations(sources()) == set(), "let what is needed above be given from above"


if __name__ == "__main__":
    sys.stdout.write("\n".join(sorted(violations(sources()))) + "\n")
