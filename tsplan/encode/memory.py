"""Models that do not fit the machine's memory are refused before they are made.

What a column and an entry cost was measured (docs/encoding.md): the drafted arrays, the model,
and what HiGHS holds while it solves the first linear program.
"""

from __future__ import annotations

import os
from collections.abc import Callable, Iterator
from contextlib import suppress
from pathlib import Path

from tsplan.clock import Clock
from tsplan.stopping import Halted, StoppedBy

COLUMN_BYTES = 400
ENTRY_BYTES = 250

_GROUPS = Path("/sys/fs/cgroup")  # of versions 2 and 1
_UNLIMITED = 1 << 60  # what control groups say when they do not limit anything is above this


class Watch:
    """Hears of every block of a draft before it is made; raises Halted where that must not be."""

    def __init__(self, clock: Clock, room: Callable[[], int | None] | None = None) -> None:
        self._clock = clock
        self._room = (room or free_memory)()

    def __call__(self, columns: int, entries: int) -> None:
        """Let the draft grow to so many columns and entries, or raise Halted."""
        self._clock.check()
        wanted = columns * COLUMN_BYTES + entries * ENTRY_BYTES
        if self._room is not None and wanted > self._room:
            raise Halted(StoppedBy.MEMORY, _words(columns, entries, wanted, self._room))


def _words(columns: int, entries: int, wanted: int, room: int) -> str:
    return (
        f"the model would have more than {columns:,} columns and {entries:,} nonzeros, which take "
        f"about {_size(wanted)} of memory, and {_size(room)} are free: shorten the horizon of the "
        "formula, plan with longer steps, use a smaller map or fewer classes, or use a machine "
        "with more memory"
    )


def _size(count: int) -> str:
    return f"{count / 1e9:.1f} GB" if count >= 10**9 else f"{count / 1e6:.0f} MB"


def free_memory() -> int | None:
    """Bytes that this process may still take: of the machine, its control group and its limits.

    None where nothing of that can be read.
    """
    return min((max(found, 0) for found in _found()), default=None)


def _found() -> Iterator[int]:
    with suppress(OSError, ValueError, IndexError):
        for line in Path("/proc/meminfo").read_text(encoding="ascii").splitlines():
            if line.startswith("MemAvailable:"):
                yield int(line.split()[1]) * 1024
                break
        else:
            yield os.sysconf("SC_AVPHYS_PAGES") * os.sysconf("SC_PAGE_SIZE")
    for most, used in (
        ("memory.max", "memory.current"),
        ("memory/memory.limit_in_bytes", "memory/memory.usage_in_bytes"),
    ):
        with suppress(OSError, ValueError):  # "max" is no number: there is no limit
            limit = int((_GROUPS / most).read_text(encoding="ascii"))
            if limit < _UNLIMITED:
                yield limit - int((_GROUPS / used).read_text(encoding="ascii"))
    yield from _own_limits()


def _own_limits() -> Iterator[int]:
    """What is left of the limits on this process's address space and data."""
    with suppress(ImportError, OSError, ValueError, IndexError):
        import resource  # noqa: PLC0415  (not on every system)

        pages = Path("/proc/self/statm").read_text(encoding="ascii").split()
        for kind, place in ((resource.RLIMIT_AS, 0), (resource.RLIMIT_DATA, 5)):
            limit = resource.getrlimit(kind)[0]
            if limit != resource.RLIM_INFINITY:
                yield limit - int(pages[place]) * os.sysconf("SC_PAGE_SIZE")
