"""Which agents a count counts, decided here alone: a mask over classes and the nodes of their maps.

A node is a state today. Where a class has modes, a node will be a state and a mode, and a row of
the mask will be 1 at the nodes of the modes that have the capability.
"""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from tsplan.milp.model import Bools


def is_counted(capability: str | None, ability: frozenset[str]) -> bool:
    """Whether agents with these capabilities are counted somewhere."""
    return capability is None or capability in ability


def counted_nodes(capability: str | None, abilities: Sequence[frozenset[str]], nodes: int) -> Bools:
    """Whether agents of each class are counted at each node, as an array (classes, nodes).

    `abilities` are the capabilities of the classes; all agents are counted for None.

    >>> counted_nodes("lift", [frozenset({"lift"}), frozenset()], 2).tolist()
    [[True, True], [False, False]]
    """
    able = [is_counted(capability, ability) for ability in abilities]
    return np.repeat(np.array(able, dtype=np.bool_).reshape(-1, 1), nodes, axis=1)
