"""Two searches that take turns."""

from __future__ import annotations

import time

import pytest

from tsplan.search import in_turns as module
from tsplan.search.in_turns import in_turns


def test_whoever_has_taken_less_time_goes_on(monkeypatch: pytest.MonkeyPatch) -> None:
    now = [0.0]
    monkeypatch.setattr(module.time, "perf_counter", lambda: now[0])

    def search(name: str, seconds: float, count: int):
        for _ in range(count):
            now[0] += seconds
            yield name

    assert "".join(in_turns(search("a", 3.0, 3), search("b", 1.0, 4))) == "abbbaba"
    assert "".join(in_turns(search("a", 3.0, 0), search("b", 1.0, 2))) == "bb"
    assert time.perf_counter() == now[0]
