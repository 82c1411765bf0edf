"""Plans as tables of pandas, which is used where it is installed."""

from __future__ import annotations

from itertools import chain
from typing import TYPE_CHECKING, Any

from tsplan.errors import Finding, PlanError, TsplanError
from tsplan.plans.agent_plans import AgentPlan, state_in
from tsplan.plans.bundles import Agents

if TYPE_CHECKING:
    from collections.abc import Iterable, Mapping, Sequence


class FrameUnavailableError(TsplanError, RuntimeError):
    """A table needs pandas, which is not installed."""


def frame(columns: Mapping[str, Sequence[Any]]) -> Any:
    """A DataFrame of some columns; FrameUnavailableError with the remedy without pandas."""
    try:
        import pandas  # noqa: ICN001, PLC0415  (an extra, slow to import)
    except ImportError:
        what = "a table needs pandas, which is not installed; pip install pandas"
        raise FrameUnavailableError(what) from None
    return pandas.DataFrame(columns)


def agent_columns(given: Iterable[AgentPlan], horizon: int) -> dict[str, list[Any]]:
    """Where every agent is at every step, in columns; the state is None while it is travelling.

    The agents come in the order of the plan. Raises PlanError where there are none.

    >>> agent = AgentPlan("a-1", "a", frozenset(), ((0, 0, "p"), (2, 2, "q")))
    >>> columns = agent_columns([agent], 2)
    >>> columns["step"], columns["state"]
    ([0, 1, 2], ['p', None, 'q'])
    """
    every = Agents.of(given)
    if not every:
        what = "the plan has no paths of agents, which a table is made of"
        remedy = "of a swarm they can be made: tsplan.assign(mission, plan)"
        raise PlanError([Finding(what, remedy)])
    steps = range(horizon + 1)
    agents, classes, states = [], [], []
    for names, path in every.stretches:
        row = [state_in(path.stays, step) for step in steps]
        for name in names.names():
            agents.append(name)
            classes.append(path.class_name)
            states.append(row)
    return {
        "agent": [name for name in agents for _ in steps],
        "class": [name for name in classes for _ in steps],
        "step": [step for _ in agents for step in steps],
        "state": list(chain.from_iterable(states)),
    }
