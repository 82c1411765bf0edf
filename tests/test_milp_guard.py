"""Jobs in child processes: answers, errors, crashes, Ctrl-C and the end of the parent."""

from __future__ import annotations

import faulthandler
import os
import signal
import subprocess
import sys
import threading
import time
from pathlib import Path

import pytest

from tsplan.errors import Finding, InputError, SolverError, TsplanError
from tsplan.process.child_process import CrashError, run_guarded

posix = pytest.mark.skipif(os.name != "posix", reason="needs signals between processes")


def doubles(number: int, send) -> int:
    for step in range(3):
        send(("step", step))
    return 2 * number


def dies(number: int, send) -> None:
    send("alive")
    faulthandler.disable()  # the crash is meant, and need not be described
    os.kill(os.getpid(), number)


def exits(code: int, send) -> None:
    os._exit(code)


def fails(error: Exception, send) -> None:
    raise error


def sends_itself(argument: object, send) -> object:
    return lambda: argument


def raises_what_cannot_be_sent(argument: object, send) -> None:
    class OwnError(Exception):
        pass

    raise OwnError("mine")


def waits(seconds: float, send) -> str:
    try:
        send(os.getpid())  # Ctrl-C may come as soon as it is known whom to interrupt
        time.sleep(seconds)
    except KeyboardInterrupt:
        return "interrupted"
    return "slept"


def ignores(seconds: float, send) -> str:
    signal.signal(signal.SIGINT, signal.SIG_IGN)
    send(os.getpid())
    time.sleep(seconds)
    return "slept"


def starts_another(argument: object, send) -> None:
    other = subprocess.Popen(["sleep", "30"])
    send(other.pid)
    os.kill(os.getpid(), signal.SIGKILL)


def alive(process: int) -> bool:
    """Whether a process runs; one that waits to be collected does not."""
    try:
        status = Path(f"/proc/{process}/stat").read_text()
    except OSError:
        return False
    return status.rpartition(")")[2].split()[0] != "Z"


def gone(process: int, *, within: float = 5.0) -> bool:
    until = time.monotonic() + within
    while alive(process) and time.monotonic() < until:
        time.sleep(0.02)
    return not alive(process)


def test_answers_and_events_come_back() -> None:
    events: list[object] = []
    assert run_guarded(doubles, 4, events.append) == 8
    assert events == [("step", 0), ("step", 1), ("step", 2)]
    assert run_guarded(doubles, 5) == 10


@posix
@pytest.mark.parametrize("name", ["SIGSEGV", "SIGKILL", "SIGABRT", "SIGTERM"])
def test_a_crash_becomes_a_message(name: str) -> None:
    events: list[object] = []
    with pytest.raises(CrashError, match=rf"crashed \({name}\)") as caught:
        run_guarded(dies, int(getattr(signal, name)), events.append)
    assert events == ["alive"]
    assert isinstance(caught.value, SolverError)
    assert ("memory" in str(caught.value)) == (name == "SIGKILL")


def test_an_end_without_an_answer_is_a_crash() -> None:
    with pytest.raises(CrashError, match="exit code 3"):
        run_guarded(exits, 3)


def test_lack_of_memory_is_said() -> None:
    with pytest.raises(CrashError, match="out of memory"):
        run_guarded(fails, MemoryError())


def test_errors_are_raised_here() -> None:
    with pytest.raises(SolverError, match="no licence"):
        run_guarded(fails, SolverError("no licence"))
    with pytest.raises(KeyError):
        run_guarded(fails, KeyError("x"))


def test_what_cannot_be_sent_is_said() -> None:
    with pytest.raises(TsplanError, match="OwnError: mine"):
        run_guarded(raises_what_cannot_be_sent, 0)
    with pytest.raises(TsplanError, match="cannot be sent"):
        run_guarded(sends_itself, 0)
    with pytest.raises(TsplanError):
        run_guarded(fails, InputError([Finding("wrong")]))


def test_an_error_of_the_listener_ends_the_child() -> None:
    seen: list[int] = []

    def listen(process: int) -> None:
        seen.append(process)
        raise LookupError("mine")

    with pytest.raises(LookupError):
        run_guarded(waits, 30.0, listen)
    assert gone(seen[0])


@posix
def test_a_parent_with_threads_has_children_too() -> None:
    free = threading.Event()
    thread = threading.Thread(target=free.wait)
    thread.start()
    try:
        assert run_guarded(doubles, 3) == 6
        with pytest.raises(CrashError, match="SIGSEGV"):
            run_guarded(dies, int(signal.SIGSEGV))
    finally:
        free.set()
        thread.join()


SCRIPT = """
import os, signal, sys
sys.path.insert(0, {tests!r})
from test_milp_guard import ignores, waits
from tsplan.process.child_process import run_guarded

def told(child):
    print(child, flush=True)

if __name__ == "__main__":
    try:
        print(run_guarded({job}, 30.0, told), flush=True)
    except KeyboardInterrupt:
        print("stopped at once", flush=True)
"""


@pytest.fixture
def parent(request):
    """A program that runs one of the jobs in a child, and the child's process number."""
    code = SCRIPT.format(tests=str(Path(__file__).parent), job=request.param)
    program = subprocess.Popen([sys.executable, "-c", code], stdout=subprocess.PIPE, text=True)
    yield program, int(program.stdout.readline())
    if program.poll() is None:
        program.kill()
    program.wait()
    program.stdout.close()


@posix
@pytest.mark.parametrize("parent", ["waits"], indirect=True)
def test_ctrl_c_reaches_the_job(parent) -> None:
    program, child = parent
    program.send_signal(signal.SIGINT)
    assert program.stdout.read().strip() == "interrupted"
    assert program.wait() == 0
    assert gone(child)


@posix
@pytest.mark.parametrize("parent", ["ignores"], indirect=True)
def test_a_second_ctrl_c_ends_a_job_that_does_not_listen(parent) -> None:
    program, child = parent
    program.send_signal(signal.SIGINT)
    time.sleep(0.3)
    assert alive(child)
    program.send_signal(signal.SIGINT)
    assert program.stdout.read().strip() == "stopped at once"
    assert gone(child)


@posix
@pytest.mark.parametrize("parent", ["ignores"], indirect=True)
@pytest.mark.parametrize("name", ["SIGKILL", "SIGTERM"])
def test_a_job_ends_with_its_parent(parent, name: str) -> None:
    program, child = parent
    assert alive(child)
    program.send_signal(getattr(signal, name))
    program.wait()
    assert gone(child)


@posix
def test_what_a_job_has_started_ends_with_it() -> None:
    started: list[int] = []
    with pytest.raises(CrashError):
        run_guarded(starts_another, 0, started.append)
    assert gone(started[0])
