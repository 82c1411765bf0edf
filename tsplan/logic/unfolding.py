"""What is left of a tree whose fraction counts, after the first steps of a trace.

A fraction is made of all parts of a tree, those that are past as well. So nothing is left out and
nothing is joined: what was a window over past steps is `and` or `or` of its steps, with the same
weights, and the atoms at these are known by their margins (`tsplan.logic.fraction` says what
fractions are).
"""

from __future__ import annotations

from dataclasses import replace

from tsplan.logic import nodes
from tsplan.logic.atoms import Count, Known
from tsplan.logic.evaluation import robustness
from tsplan.logic.nodes import Formula
from tsplan.logic.settled import known_count
from tsplan.logic.traces import CountTrace
from tsplan.logic.traversal import walk


def unfolded(tree: Formula, trace: CountTrace, *, levels: bool = False) -> Formula:
    """What is left of a tree of `tree_of` after a trace of the first k steps, judged at step k.

    Of every whole trace that begins with this one, it has on the steps from k on the fraction, the
    preference by weights and the robustness that the tree has on the whole trace. With `levels` as
    many pairs hold at each depth, too, while none around them does.

    Raises ValueError with `levels` for an until that is judged at one of the first steps, whose
    change-overs are one depth further down, and for windows in one that is: they share steps, each
    of which counts once.

    >>> import numpy as np
    >>> from tsplan.logic import parse
    >>> trace = CountTrace({None: np.array([[2, 0]])}, {"a": np.array([0])})
    >>> print(unfolded(parse("G[0,3] a && F[2,4] a"), trace))
    (known(1) && known(-1) && a && F[1,1] a) && F[0,2] a
    """
    return _Unfolding(tree, trace, levels=levels).judged(tree, 0)


def shares_steps(node: Formula) -> bool:
    """Whether the depths of what holds of a node cannot be told once it has begun.

    >>> from tsplan.logic import parse
    >>> [shares_steps(parse(text)) for text in ("F[0,3] a", "G[0,3] F[0,2] a", "a U[0,2] b")]
    [False, True, True]
    """
    if isinstance(node, nodes.Until):
        return True
    windows = nodes.Window | nodes.Until
    within = walk(node.child) if isinstance(node, nodes.Window) else ()
    return any(isinstance(each, windows) for each in within)


class _Unfolding:
    """The first steps of a trace, and what is left of the parts of a tree judged at each."""

    def __init__(self, tree: Formula, trace: CountTrace, *, levels: bool) -> None:
        atoms = {node for node in walk(tree) if isinstance(node, Count | Known)}
        self._margins = {atom: robustness(atom, trace).tolist() for atom in atoms}
        self._steps = trace.steps
        self._levels = levels
        self._made: dict[tuple[Formula, int], Formula] = {}

    def judged(self, node: Formula, step: int) -> Formula:
        """What is left of a node judged at a step of the whole trace."""
        if step >= self._steps:
            return self._later(node, step - self._steps)
        if (node, step) not in self._made:
            self._made[node, step] = self._past(node, step)
        return self._made[node, step]

    def _past(self, node: Formula, step: int) -> Formula:
        """The same of one of the first steps."""
        if node in self._margins:
            return known_count(self._margins[node][step])
        if isinstance(node, nodes.Eventually | nodes.Always):
            kind = nodes.Or if isinstance(node, nodes.Eventually) else nodes.And
            first = step + node.low
            if first >= self._steps:
                return _moved(node, step - self._steps)
            parts = [self.judged(node.child, first + n) for n in range(node.high - node.low + 1)]
            if shares_steps(node):
                self._refuse(node)
            if len(parts) == 1:
                return replace(node, low=0, high=0, child=parts[0])
            return kind(tuple(parts), node.weights)
        if isinstance(node, nodes.Until):
            self._refuse(node)
            last = range(step + node.low, step + node.high + 1)
            changes = [self._change(node, step, switch) for switch in last]
            return nodes.Or(tuple(changes), node.weights) if len(changes) > 1 else changes[0]
        return node.over(self.judged(child, step) for child in node.children)

    def _change(self, node: nodes.Until, step: int, switch: int) -> Formula:
        """An until that changes over at a step."""
        before = (self.judged(node.left, at) for at in range(step, switch))
        return _all((*before, self.judged(node.right, switch)))

    def _later(self, node: Formula, steps: int) -> Formula:
        """A node judged so many steps from now on."""
        if not steps or not (node.children or node in self._margins):
            return node
        if isinstance(node, nodes.Eventually | nodes.Always):
            return _moved(node, steps)
        if isinstance(node, nodes.Until):
            self._refuse(node)
        elif node.children:
            return node.over(self._later(child, steps) for child in node.children)
        return nodes.Eventually(steps, steps, node)

    def _refuse(self, node: Formula) -> None:
        if self._levels:
            what = "what holds of windows in windows is told by its depth from the first step alone"
            raise ValueError(f"'{node}' has begun, and {what}")


def _moved(node: nodes.Window, steps: int) -> Formula:
    return replace(node, low=node.low + steps, high=node.high + steps)


def _all(parts: tuple[Formula, ...]) -> Formula:
    return nodes.And(parts) if len(parts) > 1 else parts[0]
