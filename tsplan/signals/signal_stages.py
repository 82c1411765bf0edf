"""The stages of synthesis: a first trajectory by restrictions, then one objective after the other.

Robustness has a bound that costs nothing: that of a formula whose parts are judged each on its own
(`SignalSetting.ideal`). Often it is reached, so it is asked for first, in models that leave most
choices out: one for blocks of steps, finer and finer. A trajectory of such a model is one of the
whole, and where it reaches the bound it is proven to be the best without a search. Where none does,
the whole model is maximised, from the best of what was found.

Source of the restrictions: none; of moving blocks of controls: R. Cagienard et al., "Move blocking
strategies in receding horizon control", J. Process Control 17 (2007).
"""

from __future__ import annotations

from dataclasses import dataclass, field, replace

import numpy as np

from tsplan.clock import Clock
from tsplan.encode.switches import Switch
from tsplan.encode.witness import WitnessRules
from tsplan.errors import SolverError
from tsplan.logic.evaluation import margins
from tsplan.logic.obligations import START, obligations
from tsplan.milp.confirmation import confirmed, tried
from tsplan.milp.model import Floats, Model
from tsplan.milp.solution import Progress, Status
from tsplan.milp.target import Target
from tsplan.search.effort import Effort
from tsplan.search.lexicographic import Found, Lexicographic, Tell
from tsplan.signals.aims import Aim
from tsplan.signals.equalities import MARGIN
from tsplan.signals.kept_models import Judge, KeptModels
from tsplan.signals.signal_model import SignalModel, chosen_model
from tsplan.signals.signal_objectives import AimObjective, SignalObjective, SignalPoint
from tsplan.signals.signal_setting import SignalSetting

CLOSE = 1e-6
"""Robustness this close to a bound counts as that: what solvers forgive a row."""

_MARGINS = (0.0, 1e-9, 1e-7, MARGIN)
"""Shares of its range by which a predicate is to hold where by none it does not: a corner that a
linear program meets, what floats round, what solvers forgive, and ten times that."""

_BLOCKS = (16, 8, 4, 2)  # steps for which a choice stays, in restrictions
_FINE = 4  # such steps from which on a restriction is maximised rather than asked for the bound
_STRIDE = 2  # steps between those at which eventualities are looked for there
_TWICE = 2  # blocks that a horizon must hold at least
_FEW = 30  # choices up to which the whole model is solved at once
_FEWER = 0.75  # of the choices of the whole model that a restriction to be maximised may have
_SHARE = 0.2  # of the time left that one restriction may take
_RESTRICTED = 10.0  # seconds that it may take where there is more


@dataclass(frozen=True, eq=False)
class Start:
    """Where a search begins: values (names, T+1) of a trajectory, and whether it is one.

    If it is not, what it chooses may still do for one: which part of a formula holds, and when.
    """

    rows: Floats
    holds: bool


@dataclass(eq=False)
class SignalStages(Lexicographic[SignalPoint, SignalObjective]):
    """Runs the objectives of a problem over signals in order.

    `least` is the robustness that a trajectory must have, `margin` the share of its range by which
    a predicate must hold. `tight` is False for the reference encoding, searched as a whole; what
    need not hold as a whole is the tight encoding's in any case. `start` has the
    values of a trajectory that is known, or of one whose choices may do for another.
    """

    problem: Judge
    objectives: tuple[SignalObjective, ...]
    effort: Effort
    clock: Clock
    tell: Tell[SignalPoint]
    least: float = 0.0
    margin: float = 0.0
    tight: bool = True
    start: Start | None = None
    _stage: str = field(default="first plan", init=False)
    _told: SignalObjective | None = field(default=None, init=False)
    _firm: bool = field(default=False, init=False)

    def __post_init__(self) -> None:
        super().__init__(self.clock)
        self.setting = replace(self.problem.setting(self.margin), clock=self.clock)
        self._models = KeptModels(self.problem, self.setting, self.clock, self.least, self.tight)
        self._ideal = self._models.ideal

    # --- stages --------------------------------------------------------------------------------

    def opened(self, opening: SignalObjective | None) -> Found:
        """Some trajectory; one of the greatest robustness where that comes first."""
        self._begin("first plan", None)
        self._begun()
        if self.point is not None:
            return Found(self.point.values, None, -np.inf, proven=False)
        if self._ideal < self.least - CLOSE or self.setting.reach.empty:
            return Found(None, None, np.inf, proven=True)
        made = self._whole()
        if made.refuted:
            return Found(None, None, np.inf, proven=True)
        first = self.objectives[0] if self.objectives else None
        if self.tight and made.model.size.integers > _FEW:
            self._restricted(first)
        if self.point is None and self.tight and not self._robust(first):
            least = self._models.level[0]
            firm = self._models.made(WitnessRules(), (least, least), self._firm_setting)
            if not firm.refuted:
                self._ask(firm, None, first=True)
        if self.point is not None:
            return Found(self.point.values, None, -np.inf, proven=False)
        return self._ask(made, None, first=True)

    def _robust(self, first: SignalObjective | None) -> bool:
        """Whether the robustness is what comes first, and has a bound."""
        return first is not None and first.plain_robustness and bool(np.isfinite(self._ideal))

    @property
    def _firm_setting(self) -> SignalSetting:
        """What is asked for where any trajectory will do: that it truly holds.

        Predicates hold by more than solvers forgive.
        """
        return replace(self.problem.setting(max(self.margin, MARGIN)), clock=self.clock)

    def _begun(self) -> None:
        """Take in where the search is to begin."""
        if self.start is None:
            return
        point = SignalPoint.of(self.start.rows)
        if self.start.holds:
            self._hear(point)
            if self.objectives:
                self._polish(self.objectives[0])
            return
        found = self._best_of(point, self._leading, self.setting)
        if found is not None:
            self._hear(found)

    def settled(self, objective: SignalObjective, done: Found | None) -> float | None:
        """Optimise one objective and keep what it reached; its bound."""
        self._begin(objective.name, objective)
        bound = objective.ideal(self.setting)
        if not self._closed(objective, bound):
            self._polish(objective)
        if not self._closed(objective, bound):
            made = self._whole()
            found = self._ask(made, objective)
            self._polish(objective)
            self.stopping(found.stopped_by)
            told = objective.target(self.setting, made).own(found.bound)
            if np.isfinite(told):
                bound = told if bound is None else min(bound, told)
        assert self.point is not None
        value = objective.worth(self.setting, self.point)
        if self._closed(objective, bound):
            bound = value
        self._models.kept.append((objective, value))
        return bound

    def worth(self, objective: SignalObjective, point: SignalPoint) -> float:
        """What a trajectory is worth; what was reached is kept within what rows forgive."""
        value = objective.worth(self.setting, point)
        for kept, reached in self._models.kept:
            near = _TWICE * (objective.close(reached) + self.problem.slack)
            if kept is objective and abs(value - reached) <= near:
                return reached
        return value

    def _begin(self, stage: str, told: SignalObjective | None) -> None:
        self._stage, self._told = stage, told
        self.tell(stage, None, None, None)

    def _closed(self, objective: SignalObjective, bound: float | None) -> bool:
        """Whether the best trajectory known reaches a bound."""
        if bound is None or self.point is None or not np.isfinite(bound):
            return False
        value = objective.worth(self.setting, self.point)
        return objective.sign * (value - bound) <= _TWICE * objective.close(bound)

    # --- restrictions --------------------------------------------------------------------------

    def _restricted(self, first: SignalObjective | None) -> None:
        """Find trajectories in models with fewer choices, until one reaches the bound."""
        robust = self._robust(first)
        level = max(self._ideal - CLOSE, self.least) if robust else self.least
        setting = self.setting if robust else self._firm_setting
        blocks = _BLOCKS if Switch.BLOCKS in self.setting.switches else ()
        able = [block for block in blocks if _TWICE * block <= self.setting.reach.horizon]
        asked: list[tuple[int, SignalObjective | None]] = [(block, None) for block in able]
        if first is not None:
            asked += [(block, first) for block in able if block <= _FINE]
        for block, objective in asked:
            if objective is None and self.point is not None:
                continue
            rules = WitnessRules(block=block, stride=_STRIDE)
            if objective is None:
                made = self._models.made(rules, (level, level), setting.whole)
            else:
                made = self._models.made(rules, (self.least, max(level, self._ideal)))
            if objective is not None and made.model.size.integers > _FEWER * self.size[1]:
                continue  # the whole model is no harder
            self._try(made, objective)
            bound = None if first is None else first.ideal(self.setting)
            if self.clock.over or (first is not None and self._closed(first, bound)):
                return

    def _try(self, made: SignalModel, objective: SignalObjective | None) -> None:
        """Take in what is found in a restriction; it proves nothing."""
        left = self.clock.left
        clock = self.clock.within(_RESTRICTED if left is None else min(_RESTRICTED, _SHARE * left))
        if made.refuted:
            return
        model, target = self._asked(made, objective)
        options = self.effort.options(clock, target, self._start(made))
        options = replace(options, first=objective is None)
        values = tried(self.effort.solver, model, options, self._watch)
        if values is not None:
            self._hear(SignalPoint(made, values))
            if self.objectives:
                self._polish(self.objectives[0])

    # --- questions -----------------------------------------------------------------------------

    def _ask(
        self, made: SignalModel, objective: SignalObjective | None, *, first: bool = False
    ) -> Found:
        """The solver's answer about a whole model."""
        model, target = self._asked(made, objective)
        options = self.effort.options(self.clock, target, self._start(made))
        known = None
        if objective is not None and self.point is not None and options.start is None:
            known = target.minimised(objective.worth(self.setting, self.point))
        cutoff = None if known is None else target.cutoff(known)
        options = replace(options, first=first, cutoff=cutoff)
        solution = confirmed(self.effort.solver, model, options, self._watch)
        if solution.status is Status.INFEASIBLE and known is not None:
            return Found(None, None, known, proven=True)
        if solution.status is Status.INFEASIBLE and self.point is not None:
            raise SolverError("the solver calls a model infeasible of which a point is known")
        if solution.values is not None:
            self._hear(SignalPoint(made, solution.values))
        bound = -np.inf if solution.bound is None else target.proven(solution.bound)
        bound = bound if known is None else min(bound, known)
        proven = solution.status in (Status.OPTIMAL, Status.INFEASIBLE)
        return Found(solution.values, solution.objective, bound, proven, solution.stopped_by)

    def _asked(self, made: SignalModel, objective: SignalObjective | None) -> tuple[Model, Target]:
        """The model of a question and what is minimised in it."""
        if objective is None:
            return made.model, Target(np.zeros(made.model.size.columns), step=0.0)
        target = objective.target(self.setting, made)
        return made.model.with_objective(target.vector), target

    def _watch(self, progress: Progress) -> bool:
        """Tell of a bound while a solver runs."""
        if self._told is not None and progress.bound is not None and self.point is not None:
            value = self._told.worth(self.setting, self.point)
            target = self._told.target(self.setting, self._whole())
            self.tell(self._stage, None, value, target.own(progress.bound))
        return self.clock.stop()

    def _hear(self, point: SignalPoint) -> None:
        """Keep a point that is no worse in the objective at hand, and tell of it.

        Where what is to hold is chosen, so is what the point all but meets, by most: the corners
        that solvers find lie on the borders of predicates, and beside them.
        """
        told = self._told or (self.objectives[0] if self.objectives else None)
        self._keep(point, told)
        if told is not None and told.chooses:
            meant = self._best_of(point, self._leading, self.setting, meant=True)
            if meant is not None:
                self._keep(meant, told)

    def _keep(self, point: SignalPoint, told: SignalObjective | None) -> None:
        """One that misses the formula by a solver's tolerance is made firm if its choices allow."""
        firm = self.problem.holds(point)
        if not firm and (other := self._firmed(point)) is not None:
            point, firm = other, True
        value = None if told is None else told.worth(self.setting, point)
        if self.point is not None and firm <= self._firm:
            former = None if told is None else told.worth(self.setting, self.point)
            if firm < self._firm or _worse(told, value, former):
                return
        self.point, self._firm = point, firm
        self.tell(self._stage, point, value if self._told else None, None)

    def _whole(self) -> SignalModel:
        """The model of all trajectories that lose nothing of what was reached."""
        made = self._models.whole()
        size = made.model.size
        self.size = size.columns, size.integers, size.rows, size.nonzeros
        return made

    # --- the choices that are made -----------------------------------------------------------

    def _start(self, made: SignalModel) -> Floats | None:
        """The point that is known, where it is one of this model."""
        point = self.point
        return point.values if point is not None and point.made is made else None

    def _polish(self, objective: SignalObjective) -> None:
        """Take in the best trajectory of the choices that are made."""
        if self.point is not None and not objective.chooses:
            better = self._best_of(self.point, objective, self.setting)
            if better is not None:
                self._hear(better)

    def _firmed(self, point: SignalPoint) -> SignalPoint | None:
        """A trajectory of the same choices that truly holds; by as little as it takes."""
        for margin in _MARGINS:  # a corner may lie right on the border
            firm = self._best_of(point, self._leading, self.problem.setting(margin))
            if firm is not None and self.problem.holds(firm):
                return firm
        return None

    @property
    def _leading(self) -> SignalObjective:
        """The objective at hand, or the robustness where that says what is to hold."""
        objective = self._told or (self.objectives[0] if self.objectives else None)
        if objective is None or objective.chooses:
            return AimObjective(Aim((("robustness", 1.0),)))
        return objective

    def _best_of(
        self,
        point: SignalPoint,
        objective: SignalObjective,
        setting: SignalSetting,
        *,
        meant: bool = False,
    ) -> SignalPoint | None:
        """The best trajectory of the choices of another, or those it is `meant` to make: an LP."""
        trace = point.trace(setting.system)
        goal, atoms = setting.meant(trace) if meant else (setting.held(trace), {})
        values = margins(goal, trace)
        own = float(values[goal][0])
        if own < 0:  # what is chosen is told by what is above the whole
            values = {node: row - own for node, row in values.items()}
        with self.clock.timed("build"):
            owed = obligations(goal, START, values)
            steps = {atoms.get(node, node): it.steps.tolist() for (node, _), it in owed.items()}
            made = self._models.narrowed(chosen_model(setting, self._models.level, steps))
        options = self.effort.limited(self.clock)
        found = tried(self.effort.solver, self._asked(made, objective)[0], options)
        return None if found is None else SignalPoint(made, found)


def _worse(objective: SignalObjective | None, value: float | None, known: float | None) -> bool:
    """Whether a value is worse than the one that is known."""
    if objective is None or value is None or known is None:
        return False
    return objective.sign * value > objective.sign * known
