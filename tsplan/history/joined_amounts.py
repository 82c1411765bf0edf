"""What is carried and executed before a step and after it as one plan, and what of that is after.

Robots have other names in the plan of a rest, and tasks that have begun are the rest of themselves.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Sequence
from dataclasses import replace
from typing import TYPE_CHECKING, Any

from tsplan.history.past_amounts import executable
from tsplan.logic.atoms import begun_text
from tsplan.name_runs import Run, RunMap, counterpart
from tsplan.plans.cargo_rows import CargoRows
from tsplan.plans.presence import state_counts
from tsplan.plans.supplies import ExecutedTask, StockHistory

if TYPE_CHECKING:
    from tsplan.history.rest_mission import Rest
    from tsplan.logic import Execution
    from tsplan.plans.plan import Plan
    from tsplan.plans.supplies import Cargo


def joined_amounts(rest: Rest, plan: Plan, names: Iterable[tuple[Run, Run]]) -> dict[str, Any]:
    """What is carried and executed, and what lies where, before a step and in the plan of the rest.

    `names` are those of robots before and in the plan of the rest.
    """
    if not (rest.mission.resources or rest.mission.books):
        return {}
    back = RunMap((new, (new, old)) for old, new in names)
    after = cargo_from(plan.cargo, -rest.step, back)
    return {
        "cargo": CargoRows.joined([*rest.past.cargo.order, *after.order]),
        "executions": tuple(_executions(rest, plan)),
        "stocks": _joined_stocks(rest, plan.stocks),
    }


def cargo_from(cargo: Iterable[Cargo], step: int, names: RunMap[tuple[Run, Run]]) -> CargoRows:
    """The cargo from a step on, which is step 0 then, by other names of those who carry it.

    `names` have for each run of names itself and the others.
    """
    return CargoRows.joined(
        row._replace(names=counterpart(part, *both), step=row.step - step)
        for row in CargoRows.of(cargo).order
        if row.step >= step
        for part, both in names.parts(row.names)
        if both is not None
    )


def executions_from(executions: Iterable[ExecutedTask], rest: Rest) -> tuple[ExecutedTask, ...]:
    """What is executed from the step of a rest on, which is step 0 then.

    So are the rests of tasks that have begun, where they use something of their own still.
    """
    step = rest.step
    known = executable(rest.mission, rest.mission.formula)
    found = []
    for each in executions:
        task = begun_text(each.task, step - each.step) if each.step < step else each.task
        if each.step >= step or (task in known and each.given_up is None):
            found.append(ExecutedTask(task, each.state, max(each.step - step, 0)))
    return tuple(found)


def _executions(rest: Rest, plan: Plan) -> Iterator[ExecutedTask]:
    """What was executed and is; what has begun is given up where it does not go on."""
    step = rest.step
    going_on = {(each.task, each.state) for each in plan.executions if not each.step}
    tasks = executable(rest.mission, rest.formula, rest.mission.formula)
    for each in rest.past.executions:
        task = tasks.get(each.task)
        ends = each.step if task is None else each.step + task.last
        mine = begun_text(each.task, step - each.step), each.state
        over = ends < step or each.given_up is not None
        if over or mine in going_on or (mine[0] not in tasks and _stays(rest, plan, each, task)):
            yield each
        else:
            yield replace(each, given_up=step)
    begun = {begun_text(each.task, step - each.step) for each in rest.past.executions}
    for each in plan.executions:
        if each.step or each.task not in begun:
            yield replace(each, step=each.step + step)


def _stays(rest: Rest, plan: Plan, item: ExecutedTask, task: Execution | None) -> bool:
    """Whether the robots of a task stay to its end that needs nothing else any more."""
    if task is None:
        return False
    consumed = {each.name for each in rest.mission.resources if each.consumed}
    if rest.mission.books or not consumed.issuperset(name for name, _ in task.resources):
        return False
    last = item.step + task.last - rest.step
    present = plan.presences
    return all(
        state_counts(present, [item.state], last, name).min() >= number
        for name, number in task.needs
    )


def stocks_from(stocks: Iterable[StockHistory], step: int) -> tuple[StockHistory, ...]:
    """What lies where from a step on, which is step 0 then."""
    found = []
    for each in stocks:
        later = [(since - step, amount) for since, amount in each.amounts if since > step]
        amounts = ((0, each.at(step)), *later)
        if any(amount for _, amount in amounts):
            found.append(replace(each, amounts=amounts))
    return tuple(found)


def _joined_stocks(rest: Rest, after: Sequence[StockHistory]) -> tuple[StockHistory, ...]:
    """What lies where before the step of a rest, and from it on by histories that begin with it."""
    step, order = rest.step, {each.name: n for n, each in enumerate(rest.mission.resources)}
    later = {(each.resource, each.state): each for each in after}
    earlier = {(each.resource, each.state): each for each in rest.stocks}
    found = []
    for place in sorted({*earlier, *later}, key=lambda place: (order[place[0]], place[1])):
        old, new = earlier.get(place), later.get(place)
        amounts = list(() if old is None or not step else old.amounts)
        amounts = amounts or ([(0, 0.0)] if step else [])
        for since, amount in ((0, 0.0),) if new is None else new.amounts:
            if not amounts or amounts[-1][1] != amount:
                amounts.append((since + step, amount))
        found.append(StockHistory(*place, tuple(amounts)))
    return tuple(found)
