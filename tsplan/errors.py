"""One family of errors: what is wrong, where, and what to do about it."""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass
from difflib import get_close_matches
from typing import TypeAlias

Spot: TypeAlias = tuple[str | None, int | None, int | None]
"""A place in a file: its name, line and column as far as they are known."""

_SHOWN = 8  # known words listed where none is close
_LONGEST = 600  # characters of a message or of a remedy that are told

MOST_TOLD = 100
"""Findings of one input that are told; there may be one for each character of it."""


@dataclass(frozen=True, slots=True)
class Finding:
    """One thing that is wrong with an input, with its place and its remedy.

    `line` and `column` count from 1; both are None where a finding concerns the whole source.
    """

    message: str
    remedy: str = ""
    source: str | None = None
    line: int | None = None
    column: int | None = None

    def __str__(self) -> str:
        """`file:line:column: what is wrong; what to do`, without the parts that are unknown."""
        place = [self.source or ""]
        if self.line is not None:
            place += [str(self.line), str(self.column or 1)]
        where = ":".join(part for part in place if part)
        parts = [clipped(part) for part in (self.message, self.remedy) if part]
        text = "; ".join(parts)
        return f"{where}: {text}" if where else text


def clipped(text: str) -> str:
    """A text of a bearable length: names and formulas in it may be of any.

    >>> len(clipped("a" * 1_000_000))
    600
    """
    if len(text) <= _LONGEST:
        return text
    half = (_LONGEST - 5) // 2
    return f"{text[:half]} ... {text[-(_LONGEST - 5 - half) :]}"


def told(findings: Iterable[Finding]) -> list[str]:
    """The lines that tell of findings: the first ones, and how many more there are."""
    listed = list(findings)
    lines = [str(finding) for finding in listed[:MOST_TOLD]]
    if len(listed) > MOST_TOLD:
        lines.append(f"and {len(listed) - MOST_TOLD:,} more findings; correct these first")
    return lines


def in_order(findings: Iterable[Finding]) -> list[Finding]:
    """Findings by their place in a file, each once."""
    each = dict.fromkeys(findings)
    return sorted(each, key=lambda finding: (finding.line or 0, finding.column or 0))


class TsplanError(Exception):
    """Root of every error that tsplan raises on purpose."""


class InputError(TsplanError, ValueError):
    """An input cannot be used. `findings` holds everything that is wrong with it at once."""

    def __init__(self, findings: Iterable[Finding]) -> None:
        self.findings: tuple[Finding, ...] = tuple(findings)
        super().__init__("\n".join(told(self.findings)))

    def __reduce__(self) -> tuple[type[InputError], tuple[tuple[Finding, ...]]]:
        """Pickle by the findings, so that errors survive the way between processes."""
        return type(self), (self.findings,)


class FormulaError(InputError):
    """A formula cannot be read or does not fit its use."""


class MapError(InputError):
    """A map cannot be read or is inconsistent."""


class MissionError(InputError):
    """A mission cannot be read or does not fit its map, team or formula."""


class PlanError(InputError):
    """A plan file is not one, or a plan does not fit its mission."""


class SolverError(TsplanError, RuntimeError):
    """A solver failed, or answered something that cannot be used."""


class SolverUnavailableError(SolverError):
    """A solver is not installed, or its licence does not allow this model."""


def nearest(name: str, known: Iterable[str]) -> str:
    """A remedy that names the known word closest to `name`, or lists some known ones.

    >>> nearest("gren", ["green", "blue"])
    "did you mean 'green'?"
    """
    words = sorted(set(known))
    close = get_close_matches(name[:_LONGEST], words, n=1, cutoff=0.5)
    if close:
        return f"did you mean '{close[0]}'?"
    shown = [*words[:_SHOWN], *(["..."] if len(words) > _SHOWN else [])]
    return f"known: {', '.join(shown)}" if words else "none are defined"


class Nearest:
    """Remedies for many unknown names: as `nearest`, and without one once many were asked for.

    Looking for a close word takes time with every known word, and nobody reads so many remedies.
    """

    def __init__(self, known: Iterable[str]) -> None:
        self._words = frozenset(known)
        self._remedies: dict[str, str] = {}

    def __call__(self, name: str) -> str:
        """The remedy for one name."""
        if name not in self._remedies and len(self._remedies) < MOST_TOLD:
            self._remedies[name] = nearest(name, self._words)
        return self._remedies.get(name, "")
