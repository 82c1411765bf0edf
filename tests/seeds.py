"""How much of the random suites runs: a sample by default, the rest under `long`.

What is marked `long` is made in runs that ask for it only: tens of thousands of tests would be
collected to be left out, each time.
"""

from __future__ import annotations

from collections.abc import Callable, Collection, Iterable
from typing import TypeVar

import pytest
from hypothesis import settings
from hypothesis import strategies as st

from tsplan.logic import LANGUAGES

FEW, MANY = 10, 200  # examples of hypothesis
whole = False  # whether the run asks for what is marked `long`: `conftest.py` says so
seeds = st.integers(0, 2**32 - 1)
languages = st.sampled_from(LANGUAGES)
Test = TypeVar("Test", bound=Callable[..., None])


def quick(test: Test) -> Test:
    """Give a test of hypothesis few examples; it is one of the `long` ones where these run."""
    if whole:
        return pytest.mark.long(settings(max_examples=MANY, deadline=None)(test))
    return settings(max_examples=FEW, deadline=None)(test)


def long(*values: object) -> object:
    """Parameters for one test that is marked `long`, in a list of others that are not."""
    return pytest.param(*values, marks=pytest.mark.long)


def sampled(every: Iterable[object], default: Collection[object]) -> list[object]:
    """Parameters for tests of single values; those that are not in `default` are marked `long`."""
    return [
        pytest.param(value, marks=() if value in default else pytest.mark.long)
        for value in every
        if whole or not default or value in default
    ]


def seed_blocks(default: Iterable[int], every: Iterable[int], size: int) -> list[object]:
    """Parameters for tests of blocks of so many seeds; those of `every` are marked `long`."""
    first = list(default)
    rest = list(every) if whole or not first else []
    return [
        pytest.param(block, id=f"{block[0]}..{block[-1]}", marks=marks)
        for chosen, marks in ((first, ()), (rest, pytest.mark.long))
        for block in (chosen[at : at + size] for at in range(0, len(chosen), size))
    ]
