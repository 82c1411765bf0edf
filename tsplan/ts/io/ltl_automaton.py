"""Transition systems of KTH's ltl_automaton_core, YAML: state models, and actions between states.

A state of the map has one node of each state model, in the order of `state_dim`; an action changes
one of them, where its guard over the nodes of all models holds
(https://github.com/KTH-SML/ltl_automaton_core). The weight of an action is how long it takes, in
seconds.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from itertools import product
from math import prod
from typing import Annotated, Any

from pydantic import BaseModel, ConfigDict, Field

from tsplan.document import Document, Path
from tsplan.document.fields import Number, Word
from tsplan.errors import FormulaError, MapError, Nearest, in_order
from tsplan.limits import is_number
from tsplan.logic import TRUE, Always, And, Constant, Count, Formula, Not, Or, parse
from tsplan.ts.edges import State
from tsplan.ts.io.graph_draft import GraphDraft
from tsplan.ts.io.map_settings import MapSettings
from tsplan.ts.ride_durations import Ride
from tsplan.ts.system import TransitionSystem

MOST_STATES = 1_000_000
_TRUE = ("", "1", "true", "True")  # guards that always hold


class _Loose(BaseModel):
    model_config = ConfigDict(extra="ignore", defer_build=True)


class _Node(_Loose):
    attr: dict[str, Any] | None = None
    connected_to: dict[str, str | int] | None = None


class _Model(_Loose):
    initial: Any = None
    nodes: Annotated[dict[str, _Node | None], Field(min_length=1)]


class _Action(_Loose):
    weight: Annotated[Number, Field(ge=0)] = 1.0
    guard: Any = None


class _File(_Loose):
    state_dim: Annotated[list[Word], Field(min_length=1)] | None = None
    state_models: Annotated[dict[str, _Model], Field(min_length=1)]
    actions: dict[str, _Action] = {}


def is_state_models(document: Document, path: Path) -> bool:
    """Whether what stands at a path has state models."""
    data = document.at(path)
    return isinstance(data, dict) and isinstance(data.get("state_models"), dict)


class _Draft(GraphDraft):
    def models(self, file: _File) -> list[tuple[str, _Model]]:
        """The state models in their order."""
        names = list(file.state_models) if file.state_dim is None else file.state_dim
        closest = Nearest(file.state_models)
        for number, name in enumerate(names):
            if name not in file.state_models:
                what = f"there is no state model '{name}', so it is left out"
                self.note((*self.path, "state_dim", number), what, closest(name))
        known = [(name, file.state_models[name]) for name in names if name in file.state_models]
        if not known:
            self.refuse((*self.path, "state_dim"), "it names no state model", "name one")
        return known

    def guards(self, file: _File) -> dict[str, Formula | None]:
        """The guards of all actions; None where there is none."""
        found: dict[str, Formula | None] = {}
        for name, action in file.actions.items():
            text = "" if action.guard is None else str(action.guard).strip()
            try:
                guard = None if text in _TRUE else parse(text, "mtl")
            except FormulaError:
                guard = Always(0, 1, TRUE)  # nothing that a guard may be
            found[name] = guard
            if not _plain(guard):
                what = f"the guard '{text}' is not made of nodes, !, && and ||"
                self.refuse((*self.path, "actions", name, "guard"), what, "write it so")
        return found

    def check_links(self, name: str, model: _Model, file: _File) -> None:
        """Report links to nodes and actions that are not there."""
        nodes, actions = Nearest(model.nodes), Nearest(file.actions)
        for node, entry in model.nodes.items():
            for target, action in ((entry and entry.connected_to) or {}).items():
                path = (*self.path, "state_models", name, "nodes", node, "connected_to", target)
                if target not in model.nodes:
                    what = f"no node of '{name}' is called '{target}'"
                    self.findings.append(self.document.key_finding(path, what, nodes(target)))
                if str(action) not in file.actions:
                    self.refuse(path, f"there is no action '{action}'", actions(str(action)))

    def add_states(self, models: Sequence[tuple[str, _Model]]) -> None:
        """A state for every combination of nodes, where the first that has a pose is."""
        for nodes in product(*(model.nodes.items() for _, model in models)):
            key = tuple(name for name, _ in nodes)
            places = [pose for _, node in nodes if (pose := _pose(node)) is not None]
            place = next(iter(places), None)
            path = (*self.path, "state_models", models[0][0], "nodes", key[0])
            name = "|".join(key)
            self.add_node(key, State(name, frozenset(key), place, origin=name), path)

    def add_actions(
        self,
        models: Sequence[tuple[str, _Model]],
        file: _File,
        guards: dict[str, Formula | None],
    ) -> None:
        """An edge for every action, wherever its guard holds."""
        for place, (name, model) in enumerate(models):
            others = [list(other.nodes) for _, other in models]
            for node, target, action in _links(model):
                path = (*self.path, "state_models", name, "nodes", node, "connected_to", target)
                others[place] = [node]
                ride = Ride(seconds=file.actions[action].weight)
                for key in product(*others):
                    guard = guards[action]
                    if guard is None or _holds(guard, frozenset(key)):
                        there = (*key[:place], target, *key[place + 1 :])
                        self.add_ride((self._names[key], self._names[there]), ride, path)


def _links(model: _Model) -> Iterator[tuple[str, str, str]]:
    """Node, next node and action."""
    for node, entry in model.nodes.items():
        for target, action in ((entry and entry.connected_to) or {}).items():
            yield node, target, str(action)


def _pose(node: _Node | None) -> tuple[float, float] | None:
    """The first two coordinates of a node's pose, `[[x, y], [angle]]` or `[x, y]`."""
    pose = node.attr.get("pose") if node is not None and node.attr else None
    point = pose[0] if isinstance(pose, list) and pose and isinstance(pose[0], list) else pose
    if not isinstance(point, list) or len(point) < 2 or not all(map(is_number, point)):  # noqa: PLR2004
        return None
    return float(point[0]), float(point[1])


def _plain(formula: Formula | None) -> bool:
    """Whether a guard is made of nodes and connectives alone."""
    kinds = (And, Or, Not, Constant, Count)
    return formula is None or (isinstance(formula, kinds) and all(map(_plain, formula.children)))


def _holds(guard: Formula, nodes: frozenset[str]) -> bool:
    """Whether a guard holds where some nodes are the present ones."""
    parts = (_holds(child, nodes) for child in guard.children)
    match guard:
        case Constant():
            return guard.value
        case Count():
            return guard.label in nodes
        case Not():
            return not all(parts)
        case And():
            return all(parts)
    return any(parts)


def read_state_models(document: Document, path: Path, settings: MapSettings) -> TransitionSystem:
    """The combinations of the nodes of all state models; each is labelled by its nodes.

    Raises MapError with all that is wrong.
    """
    draft = _Draft(document, path, settings=settings)
    file = draft.part(_File, path)
    if file is None:
        raise MapError(draft.findings)
    models, guards = draft.models(file), draft.guards(file)
    for name, model in models:
        draft.check_links(name, model, file)
    count = prod(len(model.nodes) for _, model in models)
    if count > MOST_STATES:
        what = f"the state models have {count:,} states together, more than {MOST_STATES:,}"
        draft.refuse((*path, "state_models"), what, "leave some out of 'state_dim'")
    if draft.findings:
        raise MapError(in_order(draft.findings))
    draft.add_states(models)
    draft.add_actions(models, file, guards)
    starts = [str(model.initial) for _, model in models if model.initial is not None]
    if starts:
        where = (*path, "state_models")
        draft.note(where, f"the robot of the file starts at '{'|'.join(starts)}'")
    return draft.finished("")
