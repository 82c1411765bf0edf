"""How the command line has its windows opened, whatever the environment asks for."""

from __future__ import annotations

import os
from collections.abc import Iterator
from contextlib import contextmanager

_NAME = "MPLBACKEND"


@contextmanager
def own_backend() -> Iterator[None]:
    """Let matplotlib choose a backend with windows; the environment's is not meant for us.

    A notebook leaves its own to every process it starts. Pictures in files need none at all.
    """
    former = os.environ.pop(_NAME, None)
    try:
        yield
    finally:
        if former is not None:
            os.environ[_NAME] = former
