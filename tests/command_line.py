"""The command line as a process of its own: with pipes or on a terminal."""

from __future__ import annotations

import contextlib
import io
import os
import subprocess
import sys
from collections.abc import Iterator
from pathlib import Path
from typing import NamedTuple

import pytest

import tsplan
from tsplan.cli import main

ROOT = Path(tsplan.__file__).parents[1]
MISTAKES = ("Traceback", "internal error", "Exception ignored")
PATIENCE = 120  # seconds after which a process hangs, and does not only take long
linux = pytest.mark.skipif(sys.platform != "linux", reason="needs processes made by fork")
posix = pytest.mark.skipif(os.name != "posix", reason="needs signals between processes")
terminals = pytest.mark.skipif(not hasattr(os, "openpty"), reason="needs terminals of programs")


class Done(NamedTuple):
    """What a process ended with."""

    code: int
    out: str
    err: str


def surroundings(variables: dict[str, str]) -> dict[str, str]:
    """The environment of a process that finds the package which is tested."""
    return {**os.environ, "PYTHONPATH": str(ROOT), **variables}


def python(*arguments: str, folder: Path | None = None, **variables: str) -> Done:
    """Run Python with arguments, its streams being pipes."""
    done = subprocess.run(
        [sys.executable, *arguments],
        capture_output=True,
        encoding="utf-8",
        check=False,
        timeout=PATIENCE,
        cwd=folder,
        env=surroundings(variables),
    )
    return Done(done.returncode, done.stdout, done.stderr)


def command(*arguments: str, folder: Path | None = None, **variables: str) -> Done:
    """Run the command line, its streams being pipes."""
    return python("-m", "tsplan", *arguments, folder=folder, **variables)


def printed(code: str, *arguments: str, **variables: str) -> str:
    """What Python prints when it runs some code, which has to end well."""
    done = python("-c", code, *arguments, **variables)
    assert done.code == 0, done.err
    return done.out


def here(*arguments: str, folder: Path | None = None, encoding: str = "utf-8") -> Done:
    """Run the command line in this process, its streams being of an encoding and no terminals."""
    streams = [io.TextIOWrapper(io.BytesIO(), encoding) for _ in range(2)]
    with (
        contextlib.chdir(folder or Path()),
        contextlib.redirect_stdout(streams[0]),
        contextlib.redirect_stderr(streams[1]),
    ):
        code = main(arguments)
    for stream in streams:
        stream.seek(0)
    return Done(code, *(stream.read() for stream in streams))


def on_terminal(*arguments: str, folder: Path) -> Done:
    """Run the command line with a terminal for its stderr; stdout is a file in the folder."""
    ours, theirs = os.openpty()
    seen = b""
    place = folder / "stdout"  # a pipe would fill while only the terminal is read
    with (
        place.open("wb") as stdout,
        subprocess.Popen(
            [sys.executable, "-m", "tsplan", *arguments],
            stdout=stdout,
            stderr=theirs,
            cwd=folder,
            env=surroundings({}),
        ) as process,
    ):
        os.close(theirs)
        with contextlib.suppress(OSError):  # raised where the other end is gone
            while part := os.read(ours, 65536):
                seen += part
    os.close(ours)
    return Done(process.returncode, place.read_text(encoding="utf-8"), seen.decode())


@contextlib.contextmanager
def started(code: str, *arguments: str) -> Iterator[subprocess.Popen[str]]:
    """Start Python on some code, its streams being pipes; it is killed if it still runs then."""
    process = subprocess.Popen(
        [sys.executable, "-c", code, *arguments],
        stdout=subprocess.PIPE,
        stderr=subprocess.PIPE,
        text=True,
        env=surroundings({}),
        start_new_session=True,
    )
    with process:
        try:
            yield process
        finally:
            process.kill()
