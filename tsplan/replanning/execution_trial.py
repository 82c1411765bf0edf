"""Carrying out a plan many times by chance, to see how often the formula holds."""

from __future__ import annotations

import json
from collections.abc import Callable, Iterable, Sequence
from dataclasses import dataclass, field
from functools import partial
from pathlib import Path
from statistics import median
from typing import TYPE_CHECKING

from tsplan.checking.fitting import refuse_misfit
from tsplan.display import Told
from tsplan.errors import Finding, InputError, MissionError
from tsplan.frequency import Frequency
from tsplan.history.rest_mission import refuse_unknown_kinds
from tsplan.limits import Range
from tsplan.logic import walk
from tsplan.logic.unfolding import shares_steps
from tsplan.mission import Mission
from tsplan.mission.read import load_mission
from tsplan.parameters import refuse_options
from tsplan.plans.plan import Plan
from tsplan.plans.plan_file import load_plan
from tsplan.replanning.execution import Executed, Execution
from tsplan.replanning.simulated_fleet import Chances, SimulatedFleet
from tsplan.run.planner import plan as plan_mission

if TYPE_CHECKING:
    from tsplan.replanning.replanner import Planner

SECONDS = 10.0
"""Seconds that planning again takes at most."""


@dataclass(frozen=True)
class TrialRun:
    """One run with the same luck both ways: as planned alone, and with planning again."""

    seed: int
    kept: Executed
    replanned: Executed | None


@dataclass(frozen=True)
class Trial(Told):
    """What came of carrying out a plan many times; `str` tells it in words.

    `kept` says how often the formula held where everybody only followed the plan as soon as it
    could, `replanned` how often it did where it was planned again, None where that was not tried.
    `seconds` has how long each of these took.
    """

    chances: Chances
    runs: tuple[TrialRun, ...] = ()
    seconds: tuple[float, ...] = field(default=())

    @property
    def kept(self) -> Frequency:
        """How often the formula held without planning again."""
        return Frequency(sum(run.kept.met for run in self.runs), len(self.runs))

    @property
    def replanned(self) -> Frequency | None:
        """How often it held with that."""
        tried = [run.replanned for run in self.runs if run.replanned is not None]
        return Frequency(sum(each.met for each in tried), len(tried)) if tried else None

    def __str__(self) -> str:
        """What `tsplan execute` prints."""
        if not self.runs:
            return "no run came to its end"
        chances = self.chances
        seeds = f"seeds {self.runs[0].seed}..{self.runs[-1].seed}"
        lines = [
            f"{len(self.runs):,} runs ({seeds}), with these chances: {chances.delay:g} that a move",
            f"takes a step longer, {chances.loss:g} that an agent is lost at a step, and",
            f"{chances.close:g} that an edge closes at a step",
            f"as planned, the formula held in {self.kept}{_parts(run.kept for run in self.runs)}",
        ]
        if self.replanned is not None:
            parts = _parts(run.replanned for run in self.runs if run.replanned is not None)
            lines.append(f"planning again, it held in {self.replanned}{parts}")
            lines.append(self._effort())
        return "\n".join(lines)

    def _effort(self) -> str:
        """How often it was planned again, and how long that took."""
        tried = [run.replanned for run in self.runs if run.replanned is not None]
        stuck = sum(each.stuck for each in tried)
        if not self.seconds:
            met = all(each.met for each in tried)
            why = "the plan went on to work" if met else "it worked, or nobody was left"
            return f"it was never planned again: {why}"
        times = f"{len(self.seconds):,} times in all"
        took = f"{median(self.seconds):.2f} s each (median), {max(self.seconds):.2f} s at most"
        return f"it was planned again {times}, {took}; {stuck:,} times there was no plan"

    def to_json(self) -> str:
        """The same as JSON."""
        runs = [
            {
                "seed": run.seed,
                "kept": run.kept.met,
                **_shares("kept", run.kept),
                **({} if run.replanned is None else _told(run.replanned)),
            }
            for run in self.runs
        ]
        chances = {name: getattr(self.chances, name) for name in ("delay", "loss", "close")}
        return json.dumps({"chances": chances, "runs": runs}, indent=1) + "\n"


def _parts(runs: Iterable[Executed]) -> str:
    """How much held on average, where a formula may hold in part, and of what is preferred."""
    every = list(runs)
    said = []
    shares = [run.satisfaction for run in every if run.satisfaction is not None]
    if shares:
        said.append(f"{float(sum(shares) / len(shares)):.1%} of it on average")
    wishes = [share == 1 for run in every for share in run.preferences]
    if wishes:
        said.append(f"{sum(wishes) / len(wishes):.1%} of what is preferred held")
    return "".join(f", {each}" for each in said)


def _told(executed: Executed) -> dict[str, object]:
    seconds = [round(each, 4) for each in executed.replanned]
    said = {"replanned": executed.met, "seconds": seconds, "stuck": executed.stuck}
    return said | _shares("replanned", executed)


def _shares(way: str, executed: Executed) -> dict[str, object]:
    """How much of the formula and of each preference held, if that is asked."""
    found: dict[str, object] = {}
    if executed.satisfaction is not None:
        found[f"{way}_satisfaction"] = float(executed.satisfaction)
    if executed.preferences:
        found[f"{way}_preferences"] = [float(share) for share in executed.preferences]
    return found


def execute(
    mission: Mission | str | Path,
    plan: Plan | str | Path,
    *,
    runs: int = 100,
    seed: int = 0,
    delay: float = 0.1,
    loss: float = 0.0,
    close: float = 0.0,
    replanning: bool = True,
    time_limit: float = SECONDS,
    on_run: Callable[[TrialRun], object] | None = None,
) -> Trial:
    """Carry out a plan `runs` times by chance, as planned and with planning again.

    A move takes a step longer with the chance `delay`, and again and again; at every step each
    agent gets lost with the chance `loss`, and one of the edges closes for good with the chance
    `close`. Whoever is late follows the plan as soon as it can. The runs have the seeds `seed`,
    `seed` + 1, ..., and the same luck both ways. With `replanning` the mission is planned again, in
    at most `time_limit` seconds, where the check says that the plan does not work any more.
    `on_run` hears of every run; when it returns True there are no more of them.

    Raises PlanError for a plan that is not of the mission, MissionError for missions that cannot be
    planned again, InputError for numbers out of range.

    >>> import tsplan
    >>> mission = tsplan.load_mission("mission.yaml")
    >>> trial = tsplan.execute(mission, tsplan.plan(mission), runs=5, delay=0.3)
    >>> trial.replanned.times >= trial.kept.times
    True
    """
    refuse_options(runs=runs, seed=seed, time_limit=time_limit)
    chances = checked(Chances(delay, loss, close))
    mission = mission if isinstance(mission, Mission) else load_mission(mission)
    plan = plan if isinstance(plan, Plan) else load_plan(plan)
    refuse_inexecutable(mission)
    refuse_misfit(plan, mission)
    planner: Planner | None = partial(plan_mission, time_limit=time_limit) if replanning else None
    done: list[TrialRun] = []
    try:
        for number in range(seed, seed + runs):
            done.append(_tried(mission, plan, chances, number, planner))
            if on_run is not None and on_run(done[-1]):
                break
    except KeyboardInterrupt:  # what has come to its end is told
        pass
    seconds = (s for run in done if run.replanned is not None for s in run.replanned.replanned)
    return Trial(chances, tuple(done), tuple(seconds))


def refuse_inexecutable(mission: Mission) -> None:
    """Raise MissionError for missions that are not carried out.

    These are those of swarms, whose agents have no orders of their own, of expected numbers, and
    those that would be planned again by depths that cannot be told.
    """
    refuse_unknown_kinds(mission)
    if mission.swarm is not None:
        what = "agents of swarms are not told one by one where to go"
        raise MissionError([Finding(what, "see tsplan simulate, where they go by chance")])
    by_depth = mission.partial and mission.satisfaction != "weighted"
    if by_depth and any(map(shares_steps, walk(mission.tree(mission.formula)))):
        what = "what holds of windows in windows is not told by its depth once they have begun"
        raise MissionError([Finding(what, "ask for the weighted order")])


def checked(chances: Chances) -> Chances:
    """Chances that are some. Raises InputError."""
    findings: Sequence[Finding] = [
        Finding(f"{name}: {words}", "give a number from 0 to 1")
        for name in ("delay", "loss", "close")
        if (words := Range(0, 1).complaint(getattr(chances, name)))
    ]
    if findings:
        raise InputError(findings)
    return chances


def _tried(
    mission: Mission, plan: Plan, chances: Chances, seed: int, planner: Planner | None
) -> TrialRun:
    kept = Execution(mission, plan, SimulatedFleet(mission, chances, seed)).run()
    if planner is None:
        return TrialRun(seed, kept, None)
    again = Execution(mission, plan, SimulatedFleet(mission, chances, seed), planner).run()
    return TrialRun(seed, kept, again)
