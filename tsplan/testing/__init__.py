"""What to test planners with, this one or one's own: formulas, missions, and a corpus of answers.

- `random_missions`: small missions by their seed, of teams, tasks, swarms, and both.
- `random_signals`: the same over signals, of systems of all kinds.
- `corpus`: missions whose answers are known, planned and compared with what is expected.
- `formula_strategies`, `mission_strategies`: hypothesis strategies, for which the extra `test` or
  hypothesis itself has to be installed.

>>> from tsplan.testing import random_mission
>>> random_mission(1).name
'random 1'
"""

from __future__ import annotations

from typing import TYPE_CHECKING

from tsplan.errors import TsplanError
from tsplan.lazy_names import lazily

if TYPE_CHECKING:
    from tsplan.testing.corpus import Expectation, expectations, run_corpus
    from tsplan.testing.formula_strategies import (
        ANYTHING,
        KNOWN,
        Vocabulary,
        atoms,
        formulas,
        judged,
        trace_for,
    )
    from tsplan.testing.mission_strategies import maps, missions, swarms, teams
    from tsplan.testing.random_beginnings import with_closures, with_starts_under_way
    from tsplan.testing.random_missions import (
        random_map,
        random_mission,
        random_swarm_mission,
        random_task_mission,
    )
    from tsplan.testing.random_signals import random_signal_mission

__all__ = [
    "ANYTHING",
    "KNOWN",
    "Expectation",
    "HypothesisMissingError",
    "Vocabulary",
    "atoms",
    "expectations",
    "formulas",
    "judged",
    "maps",
    "missions",
    "random_map",
    "random_mission",
    "random_signal_mission",
    "random_swarm_mission",
    "random_task_mission",
    "run_corpus",
    "swarms",
    "teams",
    "trace_for",
    "with_closures",
    "with_starts_under_way",
]


class HypothesisMissingError(TsplanError, ImportError):
    """Strategies need hypothesis, which is not installed."""


_load, __dir__ = lazily(
    __name__,
    {
        "testing.random_beginnings": ("with_closures", "with_starts_under_way"),
        "testing.corpus": ("Expectation", "expectations", "run_corpus"),
        "testing.formula_strategies": (
            "ANYTHING",
            "KNOWN",
            "Vocabulary",
            "atoms",
            "formulas",
            "judged",
            "trace_for",
        ),
        "testing.mission_strategies": ("maps", "missions", "swarms", "teams"),
        "testing.random_missions": (
            "random_map",
            "random_mission",
            "random_swarm_mission",
            "random_task_mission",
        ),
        "testing.random_signals": ("random_signal_mission",),
    },
)


def __getattr__(name: str) -> object:
    """Load a name from its module on first use: most need more than who asks for one of them."""
    try:
        return _load(name)
    except ModuleNotFoundError as error:
        if error.name != "hypothesis":
            raise
        what = f"'{name}' needs hypothesis, which is not installed"
        raise HypothesisMissingError(f"{what}; pip install 'tsplan[test]'") from None
