"""Reconfigurations that take fewer steps, or that can be done at more places."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping
from dataclasses import replace
from types import MappingProxyType
from typing import TYPE_CHECKING, Any

from tsplan.words import many

if TYPE_CHECKING:
    from collections.abc import Callable

    from tsplan.mission import Mission, Reconfiguration

MOST_SITES = 4
"""States at which each reconfiguration is tried, beside all at once."""


def _rule(mission: Mission, number: int) -> Reconfiguration:
    return mission.modular.reconfigurations[number]


def _put_rule(mission: Mission, number: int, rule: Reconfiguration) -> Mission:
    rules = list(mission.modular.reconfigurations)
    rules[number] = rule
    modular = replace(mission.modular, reconfigurations=tuple(rules))
    return replace(mission, modular=modular, warnings=())


def _steps(mission: Mission, number: int) -> int:
    return _rule(mission, number).duration


def _put_steps(mission: Mission, value: int, number: int) -> Mission:
    return _put_rule(mission, number, replace(_rule(mission, number), duration=value))


def _sites(mission: Mission, number: int, *state: str) -> int:
    """Whether it can be done at a state, or everywhere."""
    at = _rule(mission, number).at
    names = {*state, *(label for name in state for label in mission.system.states[name].labels)}
    return int(not at or not names.isdisjoint(at))


def _put_sites(mission: Mission, value: int, number: int, *state: str) -> Mission:
    """A reconfiguration that can be done at one state more, or everywhere; never at fewer."""
    rule = _rule(mission, number)
    if not value or not rule.at:
        return mission
    return _put_rule(mission, number, replace(rule, at=(*rule.at, *state) if state else ()))


ACCESS: Mapping[str, tuple[Callable[..., Any], Callable[..., Mission]]] = MappingProxyType(
    {"rebuild": (_steps, _put_steps), "site": (_sites, _put_sites)}
)
"""How the numbers of reconfigurations are read and put: steps, and whether a place will do."""


def _shown(parts: Iterable[tuple[str, int]]) -> str:
    """So many of each configuration in words, in which nothing is filled in."""
    words = " and ".join(f"{count} {name}" for name, count in parts)
    return words.replace("{", "{{").replace("}", "}}")


def numbers_of(
    mission: Mission, wanted: Iterable[str]
) -> Iterator[tuple[str, tuple[Any, ...], int, str, int]]:
    """Kind and key of each number, the most it can move, words for that, and what it is now.

    Places are those that are wanted, first of all.
    """
    near = list(dict.fromkeys(wanted))
    for number, rule in enumerate(mission.modular.reconfigurations):
        before, after = _shown(rule.parts), _shown(rule.made)
        now = many(rule.duration, "step")
        quicker = f"rebuild {before} into {after} in {{steps}} less (now {now})"
        yield "rebuild", (number,), rule.duration - 1, quicker, rule.duration
        if not rule.at:
            continue
        for state in [name for name in near if not _sites(mission, number, name)][:MOST_SITES]:
            shown = state.replace("{", "{{").replace("}", "}}")
            yield "site", (number, state), 1, f"let {before} become {after} at '{shown}', too", 0
        yield "site", (number,), 1, f"let {before} become {after} everywhere", 0
