"""Native work in its own thread: news, errors, limits, and work that does not listen."""

from __future__ import annotations

import os
import signal
import threading
import time

import pytest

from tsplan.process.grace_period import GracePeriod
from tsplan.process.watchdog import Watchdog
from tsplan.stopping import StoppedBy


def until(watchdog: Watchdog, *, most: float = 5.0) -> None:
    """Work that ends when it is asked to."""
    began = time.perf_counter()
    while not watchdog.stopping and time.perf_counter() - began < most:
        time.sleep(0.005)


def test_news_are_heard_in_order_and_in_this_thread() -> None:
    heard: list[tuple[object, bool]] = []
    here = threading.current_thread()

    def hear(news: object) -> bool:
        heard.append((news, threading.current_thread() is here))
        return False

    watchdog = Watchdog(hear=hear)
    assert watchdog.run(lambda: [watchdog.tell(number) for number in range(5)] and None)
    assert heard == [(number, True) for number in range(5)]
    assert watchdog.stopped_by is None


def test_short_work_is_not_waited_for() -> None:
    began = time.perf_counter()
    for _ in range(20):
        assert Watchdog().run(lambda: None)
    assert time.perf_counter() - began < 0.5


def test_errors_come_out_where_the_work_was_asked_for() -> None:
    def work() -> None:
        raise MemoryError

    with pytest.raises(MemoryError):
        Watchdog().run(work)


@pytest.mark.parametrize("how", ["asked", "hear"])
def test_a_listener_may_stop_the_work(how: str) -> None:
    stops: list[int] = []
    watchdog = Watchdog(**{how: lambda *_: True}, stop=lambda: stops.append(1))

    def work() -> None:
        watchdog.tell("news")
        until(watchdog)

    assert watchdog.run(work)
    assert (watchdog.stopped_by, stops) == (StoppedBy.INTERRUPT, [1])


def test_a_deadline_stops_the_work() -> None:
    watchdog = Watchdog(deadline=time.perf_counter() + 0.1)
    assert watchdog.run(lambda: until(watchdog))
    assert watchdog.stopped_by is StoppedBy.TIME_LIMIT


def test_a_flood_of_news_hides_no_deadline() -> None:
    watchdog = Watchdog(deadline=time.perf_counter() + 0.2)
    began = time.perf_counter()

    def work() -> None:
        while not watchdog.stopping and time.perf_counter() - began < 5:
            watchdog.tell("news")

    watchdog.run(work)
    assert watchdog.stopped_by is StoppedBy.TIME_LIMIT
    assert time.perf_counter() - began < 2


def test_work_that_does_not_listen_is_left_behind() -> None:
    free = threading.Event()
    began = time.perf_counter()
    watchdog = Watchdog(deadline=began + 0.1, grace=GracePeriod(0.1, 1.0))
    assert not watchdog.run(lambda: free.wait(10) and None)
    assert time.perf_counter() - began < 0.5
    free.set()


def test_an_error_of_the_listener_stops_the_work() -> None:
    def hear(_: object) -> bool:
        raise LookupError("mine")

    watchdog = Watchdog(hear=hear)
    done = threading.Event()

    def work() -> None:
        watchdog.tell("news")
        until(watchdog)
        done.set()

    with pytest.raises(LookupError, match="mine"):
        watchdog.run(work)
    assert done.wait(1.0)


def test_ctrl_c_asks_once_and_raises_the_second_time() -> None:
    def press(*, after: float) -> None:
        threading.Timer(after, lambda: os.kill(os.getpid(), signal.SIGINT)).start()

    watchdog = Watchdog()
    press(after=0.2)
    assert watchdog.run(lambda: until(watchdog))
    assert watchdog.stopped_by is StoppedBy.INTERRUPT
    free = threading.Event()
    stubborn = Watchdog(grace=GracePeriod(0.2, 10.0))
    press(after=0.2)
    press(after=0.5)
    began = time.perf_counter()
    with pytest.raises(KeyboardInterrupt):
        stubborn.run(lambda: free.wait(5) and None)
    assert time.perf_counter() - began < 2
    free.set()
