"""Transition systems: the maps that agents move on.

- `parts`, `checks`, `system`: states, edges, and the frozen system made of them.
- `read`, `own`, `lomap`, `emit`, `write`: files, in the package's own format and in LOMAP's.
- `build`: grids, and systems from networkx graphs.
- `paths`: what can be reached, and how fast.
- `product`: two systems moving at once, and moves split into single steps.
- `lint`: what is allowed but probably not meant.
"""

from tsplan.ts.edges import ByClass, Edge, State
from tsplan.ts.system import Extras, TransitionSystem

__all__ = ["ByClass", "Edge", "Extras", "State", "TransitionSystem"]
