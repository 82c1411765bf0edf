"""Processes that work side by side, of which one that dies takes nothing along but its own job."""

from __future__ import annotations

import ctypes
import multiprocessing
import os
import signal
import sys
import threading
from collections.abc import Callable
from concurrent.futures import Executor, Future, ProcessPoolExecutor
from concurrent.futures.process import BrokenProcessPool
from contextlib import suppress
from dataclasses import dataclass, field
from typing import Any, TypeVar

T = TypeVar("T")
_DEATH_OF_PARENT = 1  # what prctl calls the signal for it


@dataclass(eq=False)
class _Lane:
    """One worker, begun anew after it has died; `pending` is what it has to do."""

    pool: ProcessPoolExecutor | None = None
    workers: set[Any] = field(default_factory=set)
    pending: list[Future[Any]] = field(default_factory=list)

    @property
    def load(self) -> int:
        """How much it has to do."""
        self.pending = [future for future in self.pending if not future.done()]
        return len(self.pending)

    def submit(self, job: Callable[..., T], *given: Any, **named: Any) -> Future[T]:
        """Give it a job."""
        try:
            future = self._submitted(job, *given, **named)
        except BrokenProcessPool:
            self.pool = None
            future = self._submitted(job, *given, **named)
        self.pending.append(future)
        return future

    def _submitted(self, job: Callable[..., T], *given: Any, **named: Any) -> Future[T]:
        if self.pool is None:
            context = multiprocessing.get_context("spawn")
            self.pool = ProcessPoolExecutor(1, context, _begin_worker)
        before = set(multiprocessing.active_children())
        future = self.pool.submit(job, *given, **named)
        self.workers |= set(multiprocessing.active_children()) - before
        return future


class WorkerPool(Executor):
    """So many processes, each in a pool of its own.

    A process that dies breaks its pool: the future of its job raises BrokenProcessPool, and the
    next job gets a new one. So give it no more jobs at once than it has workers.
    """

    def __init__(self, workers: int) -> None:
        self._lanes = [_Lane() for _ in range(workers)]
        self._lock = threading.Lock()

    def submit(self, job: Callable[..., T], /, *given: Any, **named: Any) -> Future[T]:
        """Give a job to the worker that has least to do."""
        with self._lock:
            lane = min(self._lanes, key=lambda lane: lane.load)
            return lane.submit(job, *given, **named)

    def shutdown(self, wait: bool = True, *, cancel_futures: bool = False) -> None:
        """End the workers when what they do is done; at once where futures are cancelled."""
        for lane in self._lanes:
            if cancel_futures:
                for worker in lane.workers:
                    with suppress(ValueError):  # its process is closed
                        worker.kill()
            if lane.pool is not None:
                lane.pool.shutdown(wait=wait, cancel_futures=cancel_futures)


def _begin_worker() -> None:
    """In a worker: Ctrl-C is for the parent alone, without which the worker ends."""
    signal.signal(signal.SIGINT, signal.SIG_IGN)
    parent = multiprocessing.parent_process()
    if sys.platform == "linux":
        # a thread that waits for it would keep the worker from making children quickly, by fork
        with suppress(OSError, AttributeError):
            ctypes.CDLL(None).prctl(_DEATH_OF_PARENT, signal.SIGKILL)
        if parent is not None and not parent.is_alive():
            os._exit(1)
    elif parent is not None:
        threading.Thread(target=_end_with, args=(parent,), daemon=True).start()


def _end_with(parent: Any) -> None:
    parent.join()
    os._exit(1)
