"""How often something comes out, and what that says of its probability."""

from __future__ import annotations

import math
from dataclasses import dataclass
from statistics import NormalDist

_CONFIDENCE = 0.95


@dataclass(frozen=True, slots=True)
class Frequency:
    """How many of `runs` came out so, and an interval for the probability that one does.

    The interval is Wilson's score interval at 95 % (E. B. Wilson, "Probable inference, the law of
    succession, and statistical inference", J. Am. Stat. Assoc. 22, 1927).

    >>> half = Frequency(50, 100)
    >>> half.rate, round(half.low, 3), round(half.high, 3)
    (0.5, 0.404, 0.596)
    """

    times: int
    runs: int

    def __str__(self) -> str:
        """How many, their share and the interval."""
        told = f"95 % interval {self.low:.1%} to {self.high:.1%}"
        return f"{self.times:,} of them: {self.rate:.1%} ({told})"

    @property
    def rate(self) -> float:
        """The share of the runs."""
        return self.times / self.runs

    @property
    def low(self) -> float:
        """Lower end of the interval."""
        return max(self._interval()[0], 0.0)

    @property
    def high(self) -> float:
        """Upper end of the interval."""
        return min(self._interval()[1], 1.0)

    def _interval(self) -> tuple[float, float]:
        square = NormalDist().inv_cdf((1 + _CONFIDENCE) / 2) ** 2
        spread = square / self.runs
        middle = (self.rate + spread / 2) / (1 + spread)
        variance = self.rate * (1 - self.rate) * spread + spread**2 / 4
        half = math.sqrt(variance) / (1 + spread)
        return middle - half, middle + half
