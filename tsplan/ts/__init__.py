"""Transition systems: the maps that agents move on.

- `actions`: moves whose outcome is a matter of chance.
- `edges`, `validity`, `system`: states and edges, what is wrong with them, and the frozen system.
- `io`: files; each format is one module, and `io.map_files` finds the one that fits.
- `builders`, `graph_attributes`: grids, and systems from networkx graphs.
- `ride_durations`, `parallel_edges`: lengths as steps, and which of several edges is kept.
- `reachability`, `waits`: what can be reached, how fast, and where agents can stay.
- `product`: two systems moving at once, and moves split into single steps.
- `map_lint`: what is allowed but probably not meant.
"""

from tsplan.ts.actions import Action
from tsplan.ts.edges import ByClass, Edge, State
from tsplan.ts.system import Extras, TransitionSystem

__all__ = ["Action", "ByClass", "Edge", "Extras", "State", "TransitionSystem"]
