"""How much of the random suites runs: a sample by default, the rest under `long`."""

from __future__ import annotations

from collections.abc import Collection, Iterable

import pytest
from hypothesis import settings
from hypothesis import strategies as st

from tsplan.logic import LANGUAGES

quick = settings(max_examples=50, deadline=None)
seeds = st.integers(0, 2**32 - 1)
languages = st.sampled_from(LANGUAGES)


def sampled(every: Iterable[object], default: Collection[object]) -> list[object]:
    """Parameters for tests of single values; those that are not in `default` are marked `long`."""
    return [
        pytest.param(value, marks=() if value in default else pytest.mark.long) for value in every
    ]


def seed_blocks(default: Iterable[int], rest: Iterable[int], size: int) -> list[object]:
    """Parameters for tests of blocks of so many seeds; those of `rest` are marked `long`."""
    return [
        pytest.param(block, id=f"{block[0]}..{block[-1]}", marks=marks)
        for chosen, marks in ((list(default), ()), (list(rest), pytest.mark.long))
        for block in (chosen[at : at + size] for at in range(0, len(chosen), size))
    ]
