"""Nothing that native libraries write reaches the program's output."""

from __future__ import annotations

import json
import os
import subprocess
import sys
import threading
from pathlib import Path

import pytest

import tsplan
from tests.seeds import sampled
from tsplan.process.quiet_output import aloud, hushed, hushed_alone

ROOT = str(Path(tsplan.__file__).parents[1])
MISSION = """\
format: tsplan-mission/1
map: {waiting: true, states: {p: {labels: [A]}, q: {labels: [B]}}, edges: [[p, q, 1], [q, p, 1]]}
team: [{class: a, count: 2, at: p}]
spec: {language: mtl, formula: "F[0,3] B && F[4,6] sum(A) >= 2"}
"""
# a library that writes past Python: when it is loaded, when an object is made and while it works
LOUD = """
import ctypes, os, sys

def shout(word):
    for output in (1, 2):
        os.write(output, f"LOUD {word} on {output}\\n".encode())
    ctypes.CDLL(None).puts(f"LOUD {word} kept back".encode())

shout("import")
del sys.modules["highspy"]
sys.path.remove(os.path.dirname(__file__))
import highspy as real
sys.modules["highspy"] = real

class Loud(real.Highs):
    def __init__(self):
        shout("constructor")
        super().__init__()

    def run(self):
        shout("run")
        return super().run()

real.Highs = Loud
"""


@pytest.fixture
def loud(tmp_path):
    """Runs Python with the loud library in the place of HiGHS."""
    library = tmp_path / "library"
    library.mkdir()
    (library / "highspy.py").write_text(LOUD)
    (tmp_path / "mission.yaml").write_text(MISSION)
    # no fact of it forbids a plan, so that the solver is asked
    both = MISSION.replace("F[4,6] sum(A) >= 2", "G[1,5] sum(A) >= 2")
    (tmp_path / "impossible.yaml").write_text(both)

    def run(*arguments):
        path = os.pathsep.join([str(library), ROOT])
        return subprocess.run(
            [sys.executable, *arguments],
            capture_output=True,
            text=True,
            check=False,
            timeout=120,
            cwd=tmp_path,
            env={**os.environ, "PYTHONPATH": path},
        )

    return run


posix = pytest.mark.skipif(os.name != "posix", reason="the loud library is made for POSIX")


@posix
def test_the_loud_library_is_loud(loud):
    done = loud("-c", "import highspy; highspy.Highs()")
    assert "LOUD import on 1" in done.stdout
    assert "LOUD constructor kept back" in done.stdout
    assert "LOUD import on 2" in done.stderr


@posix
@pytest.mark.parametrize("command", sampled(["plan", "explain"], ["explain"]))
def test_json_stays_one_document(loud, command):
    done = loud("-m", "tsplan", command, "mission.yaml", "--json")
    assert json.loads(done.stdout)
    assert "LOUD" not in done.stderr


@posix
@pytest.mark.long
def test_quiet_prints_nothing(loud):
    done = loud("-m", "tsplan", "plan", "mission.yaml", "--quiet")
    assert (done.returncode, done.stdout, done.stderr) == (0, "", "")


USER = """
import threading, tsplan
def heard(event):
    print("heard", flush=True)
    return False
mission = tsplan.load_mission("mission.yaml")
if {threads}:
    threading.Thread(target=threading.Event().wait, daemon=True).start()
print("before")
print(tsplan.plan(mission, on_event=heard).status)
impossible = tsplan.load_mission("impossible.yaml")
print(tsplan.explain(impossible, on_stage=heard).status)
print("after")
"""


@posix
def test_in_process_only_the_users_own_words_are_seen(loud):
    done = loud("-c", USER.format(threads=False))
    lines = done.stdout.splitlines()
    assert (lines[0], lines[-2], lines[-1]) == ("before", "explained", "after")
    assert set(lines[1:-2]) == {"heard", "optimal"}
    assert done.stderr == ""


@posix
@pytest.mark.long
def test_beside_other_threads_loading_is_quiet_and_they_are_not_hushed(loud):
    done = loud("-c", USER.format(threads=True))
    assert "LOUD import" not in done.stdout + done.stderr
    assert "LOUD constructor" not in done.stdout + done.stderr
    assert done.stdout.splitlines()[-1] == "after"


def test_a_hush_ends_however_it_ends(capfd):
    def fail():
        with hushed():
            os.write(1, b"unheard\n")
            raise KeyError

    with pytest.raises(KeyError):
        fail()
    os.write(1, b"heard\n")
    assert capfd.readouterr().out == "heard\n"


def test_words_go_to_the_hearer_and_the_users_own_are_seen(capfd):
    lines: list[str] = []
    with hushed(lines.append):
        os.write(1, b"one\n")
        with hushed():
            os.write(2, b"two\n")
        with aloud():
            os.write(1, b"aloud\n")
        os.write(1, b"three\n")
    assert lines == ["one", "two", "three"]
    assert capfd.readouterr() == ("aloud\n", "")


def test_hushes_of_several_threads_end_with_the_last(capfd):
    inside, leave = threading.Event(), threading.Event()

    def other():
        with hushed():
            inside.set()
            leave.wait(10)

    thread = threading.Thread(target=other)
    with hushed():
        thread.start()
        inside.wait(10)
    os.write(1, b"still unheard\n")
    leave.set()
    thread.join()
    os.write(1, b"heard\n")
    assert capfd.readouterr().out == "heard\n"


def test_long_work_is_hushed_only_where_nobody_else_could_speak(capfd):
    free = threading.Event()
    thread = threading.Thread(target=free.wait)
    thread.start()
    with hushed_alone():
        os.write(1, b"heard\n")
    free.set()
    thread.join()
    with hushed_alone():
        os.write(1, b"unheard\n")
    assert capfd.readouterr().out == "heard\n"


LICENSED = """
import ctypes, os
for output in (1, 2):
    os.write(output, b"LOUD licence\\n")
ctypes.CDLL(None).puts(b"LOUD kept back")
raise ImportError("no licence")
"""
LOOKING = """
from tsplan.milp.solver import SOLVERS
try:
    SOLVERS["{family}"]("").availability()
except Exception as error:
    assert "licence" in str(error)
"""


@posix
@pytest.mark.parametrize("name", sampled(["gurobipy", "pulp"], ["gurobipy"]))
def test_looking_for_other_solvers_is_quiet(loud, tmp_path, name):
    (tmp_path / "library" / f"{name}.py").write_text(LICENSED)
    done = loud("-c", LOOKING.format(family=name.removesuffix("py")))
    assert (done.returncode, done.stdout, done.stderr) == (0, "", "")
