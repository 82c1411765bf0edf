"""What is left of a formula once more with its tasks as tasks.

Formulas are progressed over numbers of agents. What remains of tasks that are executed is said by
tasks again, those that have begun by the rest of them, so that it can be written and explained as
any formula of tasks.
"""

from __future__ import annotations

from dataclasses import replace
from typing import TYPE_CHECKING

from tsplan.logic import And, Execution, Formula, Task, conjunction, fold, simplify, walk

if TYPE_CHECKING:
    from tsplan.mission import Mission


def with_tasks(rest: Formula, formula: Formula, mission: Mission) -> Formula:
    """What is left of a formula of a mission, with the tasks of that where it has executions.

    Of parts that are joined, those that a task among them says are left out.
    """
    every = (replace(node, begun=0) for node in walk(formula) if isinstance(node, Task))
    tasks = {str(task): task for task in every}
    said: dict[Formula, frozenset[Formula]] = {}

    def parts(task: Formula) -> frozenset[Formula]:
        """What a task says of numbers of agents."""
        if task not in said:
            made = simplify(mission.counting(task))
            said[task] = frozenset(made.children if isinstance(made, And) else (made,))
        return said[task]

    def back(node: Formula, below: tuple[Formula, ...]) -> Formula:
        if isinstance(node, Execution):
            return replace(tasks[node.whole], begun=node.begun)
        if not isinstance(node, And):
            return node.over(below)
        gone = frozenset().union(*(parts(each) for each in below if isinstance(each, Task)))
        return conjunction(each for each in below if each not in gone)

    if not any(isinstance(node, Execution) for node in walk(rest)):
        return rest
    return fold(rest, back)
