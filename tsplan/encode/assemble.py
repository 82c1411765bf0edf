"""From a problem to a model: the tight and the reference encoding behind one result."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Mapping, Sequence
from dataclasses import replace
from typing import Any, TypeAlias

import numpy as np

from tsplan.encode.bookings import booking_rows
from tsplan.encode.capacity_rows import capacity_rows
from tsplan.encode.class_columns import ClassColumns
from tsplan.encode.class_shares import served_by
from tsplan.encode.demand_rows import Built, DemandRows, SiteColumns
from tsplan.encode.demand_runs import Family
from tsplan.encode.encoded import Encoded, Setting
from tsplan.encode.execution_demands import demanded_columns, executed_columns
from tsplan.encode.executions import PART as EXECUTIONS
from tsplan.encode.executions import Executions
from tsplan.encode.expected_rows import expected_rows, policy_rows
from tsplan.encode.flow_network import Network, flow
from tsplan.encode.groups.group_rows import (
    counted,
    occupied_rows,
    served_rows,
    size_rows,
    swarms_of,
)
from tsplan.encode.late_modes import stood
from tsplan.encode.memory import Watch
from tsplan.encode.model_objectives import objectives_of
from tsplan.encode.own_constraints import PART as VARIABLES
from tsplan.encode.own_constraints import Quantities, constraint_rows, variable_columns
from tsplan.encode.precedence import direct, legs_of, placed, route_rows
from tsplan.encode.quantities import OwnVariable
from tsplan.encode.reference import ReferenceEncoder
from tsplan.encode.rivals.rival_rows import rival_rows
from tsplan.encode.robustness_bound import OptimisticBound
from tsplan.encode.stocks import PART as STOCKS
from tsplan.encode.stocks import stocks
from tsplan.encode.structure_flows import PART as STRUCTURES
from tsplan.encode.structure_flows import growth_rows, rebuilding
from tsplan.encode.switches import Switch
from tsplan.encode.visitor_cuts import Visits
from tsplan.encode.witness import WitnessEncoder, Witnesses, WitnessRules
from tsplan.logic import Formula
from tsplan.milp.model import Draft, Ints

Sited: TypeAlias = tuple[SiteColumns, Family]
"""A family of demands at one site, and its columns."""


def tight(setting: Setting, level: int = 0, *, chain: bool = False) -> Encoded:
    """The tight model of plans with availability at least `level`.

    With `chain` eventualities under an always get as few witnesses as possible: a restriction,
    whose flow columns are the same, for finding a first plan.
    """
    rules = WitnessRules(chain=chain, visits=Switch.VISITS in setting.switches)
    setting = setting.at(level)
    if setting.mission.expected is not None:
        return _Assembly(setting).expected()
    encoded = assembled(setting, lambda encoder, *_: encoder.encode(setting.goal), rules)
    return replace(encoded, level=level)


_RULES = WitnessRules()
_NONE = np.empty(0, dtype=np.int64)

Asking = Callable[[WitnessEncoder, Draft, Network], Witnesses]
"""Asks an encoder for what is to hold; it may add columns and rows of its own to the draft."""


def assembled(
    setting: Setting,
    ask: Asking,
    rules: WitnessRules = _RULES,
    *,
    optional: bool = False,
) -> Encoded:
    """The tight model of what `ask` requires; its formulas are parts of the setting's goal.

    `optional` says that not all demands need be met.
    """
    return _Assembly(setting).tight(ask, rules, optional=optional)


class _Assembly:
    """One model in the making.

    The columns of groups come first and those of the swarms' agents last: what stands in between,
    with robots that move one by one, is the relaxation in which only places of groups are known.
    """

    def __init__(self, setting: Setting) -> None:
        self._setting = setting
        self._draft = Draft(Watch(setting.clock))
        self._swarms = swarms_of(setting.classes, setting.together, setting.horizon, self._draft)
        self._flows: list[Ints] = []
        self._laid: dict[int, ClassColumns] = {}
        self._variables: Mapping[OwnVariable, int] = {}
        self._built: Sequence[Built] = ()
        self._visits: Sequence[Visits] = ()

    def tight(self, ask: Asking, rules: WitnessRules, *, optional: bool) -> Encoded:
        setting, draft = self._setting, self._draft
        swarms = {swarm.number: swarm.places.entered for swarm in self._swarms}
        self._flow(number for number in range(len(setting.classes)) if number not in swarms)
        robots = self._network(self._laid)
        if not swarms:
            self._shared_rows(robots)
        witnesses = self._witnesses(ask, rules, self._network({**swarms, **self._laid}))
        families: list[Sited] = []
        occupied = None
        if swarms:
            occupied = self._occupied(robots, witnesses, optional=optional)
            families += occupied.families
            self._flow(swarms)
        network = self._network(self._laid)
        if swarms:
            self._shared_rows(network)
        elif placed(network):
            if Switch.RIVALS in setting.switches and not optional:
                rival_rows(witnesses, network, draft, setting.changes)
            if Switch.TOGETHER in setting.switches and direct(network):
                legs = legs_of(witnesses, network)
                if "travel" in setting.mission.objective and not setting.delay:
                    route_rows(legs, network, draft)
        needs = witnesses
        if swarms and not setting.delay:  # of a sub-swarm some may stand and others come and go
            needs = counted(self._swarms, robots, witnesses)
        families += self._demand_rows(network, needs)
        self._swarms = tuple(
            replace(swarm, agents=self._laid[swarm.number]) for swarm in self._swarms
        )
        size_rows(self._swarms, draft)
        executed = demanded_columns(
            witnesses.executions, witnesses.choices, draft, self._free(network)
        )
        own = self._parts(network, executed)
        if "rebuilt" in own:
            growth_rows(own["own_columns"][STRUCTURES], network, self._built, draft)
        encoded = self._encoded(network, witnesses, self._flows, decided=list(swarms.values()))
        plain = not swarms and not optional and direct(network) and not setting.delay
        own |= {"families": tuple(families), "visits": tuple(self._visits)}
        own["served"] = served_by(witnesses) if plain else ()
        return replace(encoded, occupied=occupied, **own)

    def _free(self, network: Network) -> Executions | None:
        """Columns of executions beyond what is demanded, which may perform better, or None."""
        setting = self._setting
        if "performance" not in setting.mission.objective:
            return None
        return executed_columns(setting.goal, setting.atoms(network), network, self._draft)[1]

    def _parts(self, network: Network, executed: Executions) -> dict[str, Any]:
        """What objectives and other parts have of their own in a model."""
        setting, draft = self._setting, self._draft
        mission = setting.mission
        aims = objectives_of(mission)
        own: dict[str, Any] = {
            aim.name: aim.columns(setting, network, executed, draft) for aim in aims
        }
        own[EXECUTIONS] = executed
        own[VARIABLES] = self._variables
        booking_rows(mission, executed, network, draft)
        made = {}
        if setting.changes:
            own[STRUCTURES] = rebuilding(setting.changes, network, draft)
            made["rebuilt"] = own[STRUCTURES].columns
        if mission.resources:
            straight = setting.straight
            made_of = mission, executed, network, setting.arrays, draft
            own[STOCKS] = stocks(*made_of, straight=straight)
            made["loads"] = own[STOCKS].pieces
        return {"own_columns": own, **made}

    def expected(self) -> Encoded:
        """The model of expected numbers, with a column for the availability.

        Nothing that rests on whole agents is in it: cuts of arrivals, joint demands, chains.
        """
        setting, draft = self._setting, self._draft
        self._flow(range(len(setting.classes)), reduced=False)
        network = self._network(self._laid)
        decided = policy_rows(setting.mission.expected, network, draft)

        def ask(goal: Formula) -> tuple[Witnesses, OptimisticBound]:
            optimistic = OptimisticBound(goal, setting.atoms(network))
            return WitnessEncoder(draft, optimistic, WitnessRules()).encode(goal), optimistic

        witnesses, optimistic = ask(setting.judged)
        most = optimistic.best(setting.judged, 0)
        most = max(most, 0.0) if np.isfinite(most) else 0.0
        rho = int(draft.columns(1, upper=most)[0])
        expected_rows(witnesses, network, draft, rho=(rho, most))
        asked = [witnesses]
        if setting.plain is not None:  # the margin is kept whatever the availability
            asked.append(ask(setting.goal)[0])
            expected_rows(asked[-1], network, draft)
        made = [each.choices for each in asked]
        return Encoded(
            setting,
            draft.build(),
            network,
            indicators=np.array([c for each in made for c in each.columns], dtype=np.int64),
            flows=decided,
            rho=rho,
            refuted=any(each.refuted for each in made),
            steps=np.array([step for each in made for step in each.steps], dtype=np.int64),
            choices=tuple(group for each in made for group in each.groups),
        )

    def reference(self, levels: tuple[int, float]) -> Encoded:
        """The plain model, with one column `rho` for the availability between `levels`."""
        setting, draft = self._setting, self._draft
        self._flow(range(len(setting.classes)), reduced=False)
        network = self._network(self._laid)
        self._shared_rows(network)
        whole = not network.expected
        policy_rows(setting.mission.expected, network, draft)
        rho = int(draft.columns(1, lower=levels[0], upper=levels[1], integer=whole)[0])
        atoms, executed = executed_columns(setting.goal, setting.atoms(network), network, draft)
        if setting.plain is not None:  # the margin is kept whatever the availability
            none = int(draft.columns(1, upper=0.0, integer=True)[0])
            ReferenceEncoder(draft, atoms, (none, 0, 0)).encode(setting.goal)
        ReferenceEncoder(draft, atoms, (rho, *levels)).encode(setting.judged)
        swarms = tuple(replace(swarm, agents=self._laid[swarm.number]) for swarm in self._swarms)
        size_rows(swarms, draft)
        own = self._parts(network, executed)
        model = draft.build()
        flows = np.concatenate(self._flows)
        repaired = np.concatenate([flows, own.get("loads", _NONE), own.get("rebuilt", _NONE)])
        others = np.setdiff1d(np.flatnonzero(model.integer), repaired)
        return Encoded(setting, model, network, others, flows, swarms=swarms, rho=rho, **own)

    def _flow(self, numbers: Iterable[int], *, reduced: bool = True) -> None:
        """Flow columns and conservation of some classes."""
        setting = self._setting
        for number in numbers:
            graph = (setting.reduced if reduced else setting.classes)[number].graph
            robots = setting.classes[number].bounds is None
            finish = graph.avoidable if reduced and setting.monotone and robots else None
            before = self._draft.column_count
            laid = flow(graph, finish, setting.horizon, self._draft)
            self._flows.append(np.arange(before, self._draft.column_count))
            self._laid[number] = stood(laid, setting.horizon, self._draft)

    def _network(self, laid: Mapping[int, ClassColumns]) -> Network:
        return Network(tuple(laid[number] for number in sorted(laid)), self._setting.horizon)

    def _shared_rows(self, network: Network) -> None:
        """Capacities, and the user's own constraints."""
        setting, draft = self._setting, self._draft
        capacity_rows(network, setting.arrays, draft)
        self._variables = variable_columns(setting.constraints, draft)
        quantities = Quantities(setting, network, self._variables)
        constraint_rows(setting.constraints, quantities, draft)

    def _witnesses(self, ask: Asking, rules: WitnessRules, network: Network) -> Witnesses:
        """What the formula asks for; of groups it is not asked by visits."""
        setting = self._setting
        atoms = setting.atoms(network)
        optimistic = OptimisticBound(
            setting.goal, atoms, trusting=Switch.OUTLOOK not in setting.switches
        )
        rules = replace(rules, share=Switch.SHARING in setting.switches)
        if self._swarms:
            rules = replace(rules, visits=False, chain=False)
        return ask(WitnessEncoder(self._draft, optimistic, rules), self._draft, network)

    def _demand_rows(self, network: Network, witnesses: Witnesses) -> list[Sited]:
        """What is asked of the agents; nothing where it is known that they cannot do it."""
        if witnesses.choices.refuted:
            return []
        switches = self._setting.switches
        if self._swarms and self._setting.delay:  # who comes does not stand there for certain
            switches -= {Switch.VISITS, Switch.LAZY}
        maps = zip(self._setting.classes, self._setting.reduced, strict=True)
        if any(item.graph is short.graph for item, short in maps):
            switches -= {Switch.HULLS}  # whole maps have short steps around hulls, too
        rows = DemandRows(network, self._draft, switches)
        rows.write(witnesses)
        self._built = rows.built
        self._visits = () if self._swarms else rows.visits
        return rows.families

    def _occupied(self, robots: Network, witnesses: Witnesses, *, optional: bool) -> Encoded:
        """The relaxation that knows where groups are, made of all that was drafted so far."""
        swarms, draft = self._swarms, self._draft
        rows = occupied_rows(swarms, robots, self._setting.together, witnesses, draft)
        if optional:
            served_rows(swarms, robots, witnesses, draft)
        entered = [swarm.places.entered.unrolled()[2] for swarm in swarms]
        made = self._encoded(robots, witnesses, [*entered, *self._flows], decided=())
        return replace(made, families=tuple(rows.families))

    def _encoded(
        self,
        network: Network,
        witnesses: Witnesses,
        flows: Sequence[Ints],
        decided: Sequence[ClassColumns],
    ) -> Encoded:
        """What is drafted by now; where groups of `decided` columns go is decided too."""
        choices = witnesses.choices
        unrolled = [columns.unrolled() for columns in decided]
        columns = np.array(choices.columns, dtype=np.int64)
        columns = np.concatenate([columns, *(column for _, _, column in unrolled)])
        steps = np.array(choices.steps, dtype=np.int64)
        steps = np.concatenate([steps, *(step for _, step, _ in unrolled)])
        order = np.argsort(columns) if unrolled else slice(None)
        return Encoded(
            setting=self._setting,
            model=self._draft.build(),
            network=network,
            indicators=columns[order],
            flows=np.concatenate([*flows, np.empty(0, dtype=np.int64)]),
            swarms=self._swarms,
            refuted=choices.refuted,
            shared=bool(witnesses.covers),
            steps=steps[order],
            choices=tuple(choices.groups),
        )


def reference(setting: Setting, levels: tuple[int, float]) -> Encoded:
    """The reference model, with one column `rho` for the availability between `levels`."""
    return _Assembly(setting).reference(levels)
