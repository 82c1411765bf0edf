"""What the options of a command say that has happened, in short forms, as a world."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

from tsplan.errors import Finding, PlanError
from tsplan.limits import clipped
from tsplan.replanning.world_values import Changes, load_world, with_changes, world_of

if TYPE_CHECKING:
    import argparse
    from collections.abc import Iterator

    from tsplan.mission import Mission
    from tsplan.plans.plan import Plan
    from tsplan.plans.worlds import World
    from tsplan.ts import TransitionSystem


def world_given(options: argparse.Namespace, mission: Mission, plan: Plan) -> World:
    """The world of a file and of what options say besides.

    Raises PlanError for what cannot be read.
    """
    system = mission.system
    said = Changes(
        lost=options.lost,
        moved={name: _place(place, system) for name, place in map(_pair, options.moved)},
        late={name: _number(steps) for name, steps in map(_pair, options.late)},
        closed=[each for text in options.closed for each in _closed(text, system)],
        opened=[each for text in options.opened for each in _opened(text, system)],
        demanded=options.demand,
        withdrawn=options.withdraw,
        deadlines={part: _number(step) for part, step in map(_pair, options.deadline)},
    )
    if options.world is None:
        if options.at is None:
            raise PlanError([Finding("it is not said at which step", "add --at STEP")])
        return world_of(options.at, said)
    world = load_world(options.world, options.at)
    return with_changes(world, world_of(world.step, said))


def _pair(text: str) -> tuple[str, str]:
    """A name and what is said of it, as in `scout-1=q4`; the last sign counts."""
    name, sign, value = text.rpartition("=")
    if not (name and sign and value):
        remedy = "write a name, an equals sign and a value, as in scout-1=q4"
        raise PlanError([Finding(f"'{clipped(text)}' says nothing of anybody", remedy)])
    return name.strip(), value.strip()


def _number(text: str) -> Any:
    """A whole number, or the text as it is, for whoever reads it to refuse."""
    return (
        int(text)
        if text.isdecimal() and text.isascii() and len(text) <= len("1000000000")
        else text
    )


def _place(text: str, system: TransitionSystem) -> Any:
    """A state, or an edge with the step of arrival, as in `q1-q2@9`."""
    if text in system.states or "@" not in text:
        return text
    edge, _, step = text.rpartition("@")
    ends = next(_ends(edge, system), None)
    if ends is None:
        remedy = "write the state, or the edge and when it arrives, as in q1-q2@9"
        raise PlanError([Finding(f"'{clipped(text)}' is no place of the map", remedy)])
    return {"from": ends[0], "to": ends[1], "arrives": _number(step)}


def _ends(text: str, system: TransitionSystem) -> Iterator[tuple[str, str]]:
    """The pairs of states that a text with hyphens between them can mean."""
    for at, letter in enumerate(text):
        ends = text[:at], text[at + 1 :]
        if letter == "-" and all(end in system.states for end in ends):
            yield ends


def _both_ways(text: str, system: TransitionSystem) -> list[tuple[str, str]]:
    """The edges between two states, in either direction."""
    found = [
        ends for pair in _ends(text, system) for ends in (pair, pair[::-1]) if ends in system.edges
    ]
    if not found:
        remedy = "write a state, or two states with a hyphen between them, as in q1-q2"
        what = f"'{clipped(text)}' is neither a state nor an edge of the map"
        raise PlanError([Finding(what, remedy)])
    return list(dict.fromkeys(found))


def _closed(text: str, system: TransitionSystem) -> Iterator[dict[str, Any]]:
    """What is closed, as `q1`, `q1-q2` (both ways), or with the last step of it, `q1@20`."""
    name, sign, step = text.rpartition("@")
    until = {"until": _number(step)} if sign and text not in system.states else {}
    name = name if until else text
    places = [name] if name in system.states else _both_ways(name, system)
    return ({"place": place, **until} for place in places)


def _opened(text: str, system: TransitionSystem) -> Iterator[dict[str, Any]]:
    """An edge that is there or lasts as long from now on, both ways, as in `q1-q2=3`."""
    name, steps = _pair(text) if "=" in text else (text, "1")
    pairs = list(_ends(name, system))
    if not pairs:
        what = f"'{clipped(name)}' are no two states of the map"
        raise PlanError([Finding(what, "write them with a hyphen between, as in q1-q2=3")])
    for source, target in dict.fromkeys([*pairs[:1], pairs[0][::-1]]):
        yield {"from": source, "to": target, "duration": _number(steps)}
