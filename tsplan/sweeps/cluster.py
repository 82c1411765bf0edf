"""Clusters of Dask as executors: many machines, of which those that are lost are made up for."""

from __future__ import annotations

from collections.abc import Iterator
from concurrent.futures import Executor
from contextlib import ExitStack, contextmanager
from importlib import import_module
from typing import Any

from tsplan.errors import TsplanError

LOCAL = "local"
"""In place of an address: a cluster of processes on this machine."""

_PATIENCE = 30  # seconds for a scheduler to answer


class ClusterUnavailableError(TsplanError, RuntimeError):
    """A cluster cannot be used: Dask is not installed, or no scheduler answers."""


@contextmanager
def dask_cluster(address: str, workers: int = 1) -> Iterator[Executor]:
    """An executor of the cluster whose scheduler has an address, or of a local one.

    The run of a worker that dies is done again by another; where several have died of it, it has
    failed. A local cluster has so many `workers`. Raises ClusterUnavailableError.
    """
    try:
        distributed = import_module("distributed")
    except ImportError:
        what = "a cluster needs Dask, which is not installed; pip install 'tsplan[cluster]'"
        raise ClusterUnavailableError(what) from None
    with ExitStack() as stack:
        place: Any = address
        if address == LOCAL:
            place = stack.enter_context(
                distributed.LocalCluster(
                    n_workers=workers, threads_per_worker=1, processes=True, dashboard_address=None
                )
            )
        try:
            client = stack.enter_context(distributed.Client(place, timeout=_PATIENCE))
        except (OSError, ValueError, TimeoutError) as error:
            what = f"no scheduler of Dask answers at '{address}': {error}; check the address"
            raise ClusterUnavailableError(" ".join(what.split())) from None
        # equal runs are done as often as they are asked for
        yield client.get_executor(pure=False)
