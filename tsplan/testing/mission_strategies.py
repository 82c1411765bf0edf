"""Hypothesis strategies for maps, teams, swarms and whole missions."""

from __future__ import annotations

from typing import Any

from hypothesis import reject
from hypothesis import strategies as st

from tsplan.errors import MissionError
from tsplan.logic import horizon
from tsplan.mission import Group, Mission
from tsplan.mission.vocabulary import Language
from tsplan.testing.formula_strategies import Vocabulary, formulas
from tsplan.ts import Edge, State, TransitionSystem

CAPABILITIES = ("lift", "see")
LABELS = ("a", "b")
_OF_TEAMS = ("availability", "travel", "cost", "makespan", "agents")
_OF_SWARMS = ("splits", "travel", "moves", "balance", "makespan")


@st.composite
def maps(draw: st.DrawFn, *, most_states: int = 4) -> TransitionSystem:
    """Maps on which every agent can wait; states may have a capacity, edges a length and a cost.

    Every label of LABELS is the label of some state.

    >>> from hypothesis import HealthCheck, given, settings
    >>> @settings(max_examples=5, deadline=None, database=None, suppress_health_check=HealthCheck)
    ... @given(maps(most_states=3))
    ... def labels_are_there(system):
    ...     assert set(system.labels) == set(LABELS)
    >>> labels_are_there()
    """
    names = [f"s{number}" for number in range(draw(st.integers(1, most_states)))]
    homes = {label: draw(st.sets(st.sampled_from(names), min_size=1)) for label in LABELS}
    states = [
        State(
            name,
            frozenset(label for label in LABELS if name in homes[label]),
            capacity=draw(st.none() | st.integers(1, 3)),
        )
        for name in names
    ]
    pairs = [(one, other) for one in names for other in names if one != other]
    chosen = draw(st.sets(st.sampled_from(pairs))) if pairs else set()
    moves = [
        Edge(
            *pair,
            draw(st.integers(1, 3)),
            capacity=draw(st.none() | st.integers(1, 2)),
            cost=draw(st.none() | st.integers(0, 8).map(lambda number: number / 4)),
        )
        for pair in sorted(chosen)
    ]
    return TransitionSystem.build(states, [*(Edge(name, name) for name in names), *moves])


@st.composite
def teams(draw: st.DrawFn, system: TransitionSystem, *, most_agents: int = 3) -> tuple[Group, ...]:
    """Teams of one or two classes on a map, together at most so many agents."""
    sizes = draw(st.lists(st.integers(1, most_agents), min_size=1, max_size=2))
    able = st.sets(st.sampled_from(CAPABILITIES))
    return tuple(
        Group.of(f"k{number}", {draw(_state(system)): size}, draw(able))
        for number, size in enumerate(sizes)
        if sum(sizes[: number + 1]) <= most_agents
    )


@st.composite
def swarms(draw: st.DrawFn, system: TransitionSystem, *, most_agents: int = 4) -> dict[str, Any]:
    """One swarm on a map, as the mapping that `swarm:` of a mission file holds."""
    size = draw(st.integers(1, most_agents))
    return {
        "size": size,
        "at": {draw(_state(system)): size},
        "max_subswarms": draw(st.none() | st.integers(1, 3)),
        "min_subswarm": draw(st.integers(1, 2)),
    }


@st.composite
def missions(draw: st.DrawFn, *, swarm: bool = False, most_steps: int = 6) -> Mission:
    """Missions of a team, or of a swarm, with a formula of a horizon of at most `most_steps`.

    >>> from hypothesis import HealthCheck, given, settings
    >>> from tsplan.run.planner import plan
    >>> @settings(max_examples=3, deadline=None, database=None, suppress_health_check=HealthCheck)
    ... @given(missions())
    ... def a_plan_is_verified(mission):
    ...     made = plan(mission)
    ...     assert made.verified == made.has_paths
    >>> a_plan_is_verified()
    """
    system = draw(maps())
    words = Vocabulary(LABELS, () if swarm else CAPABILITIES)
    languages: tuple[Language, ...] = ("mtl",) if swarm else ("mtl", "catl")
    language = draw(st.sampled_from(languages))
    formula = draw(
        formulas(language, words, leaves=4).filter(lambda made: horizon(made) <= most_steps)
    )
    known = _OF_SWARMS if swarm else _OF_TEAMS
    objective = draw(st.lists(st.sampled_from(known), max_size=2, unique=True))
    who = {"swarm": draw(swarms(system))} if swarm else {"team": draw(teams(system))}
    try:
        return Mission.of(
            map=system, formula=formula, language=language, objective=objective, **who
        )
    except MissionError:
        return reject()  # a start over a state's capacity, or a sub-swarm below its least


def _state(system: TransitionSystem) -> st.SearchStrategy[str]:
    """One of a map's states."""
    return st.sampled_from(sorted(system.states))
