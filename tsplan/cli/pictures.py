"""How the command line has its pictures drawn, whatever the environment asks for."""

from __future__ import annotations

import os
from collections.abc import Iterator
from contextlib import contextmanager

_NAME = "MPLBACKEND"


@contextmanager
def own_backend(name: str | None) -> Iterator[None]:
    """Let matplotlib use the named backend, or choose one; the environment's is not meant for us.

    A notebook leaves its own to every process it starts, which then cannot even load matplotlib.
    """
    former = os.environ.pop(_NAME, None)
    if name is not None:
        os.environ[_NAME] = name
    try:
        yield
    finally:
        os.environ.pop(_NAME, None)
        if former is not None:
            os.environ[_NAME] = former
