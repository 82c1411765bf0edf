"""Own constraints on who enters which edge when hold exactly, however maps are reduced."""

from __future__ import annotations

from dataclasses import replace
from fractions import Fraction
from itertools import product
from random import Random

import pytest

import tsplan
from tests.joint_plans import JointPlan, holds, joint_plans, small_enough
from tests.module_missions import random_module_mission
from tests.seeds import sampled, seed_blocks
from tsplan.errors import MissionError
from tsplan.run.own_terms import worth
from tsplan.run.problem import Tuning
from tsplan.testing import random_mission, random_swarm_mission
from tsplan.testing.random_missions import random_task_mission
from tsplan.ts import Edge, State, TransitionSystem


def detour(lone: int = 3, **more) -> tsplan.Mission:
    """A slow edge from home to the end beside a quick way, by which nobody would go unasked."""
    states = [State("home"), State("way"), State("far"), State("end", frozenset({"goal"}))]
    edges = [Edge(s.name, s.name) for s in states]
    edges += [Edge("home", "way"), Edge("way", "end"), Edge("home", "end", lone)]
    edges += [Edge("end", "far"), Edge("far", "home")]
    given = {"team": {"cart": {"home": 3}}, "objective": ["travel"]} | more
    system = TransitionSystem.build(states, edges)
    return tsplan.Mission.of(map=system, formula="F[0,5] goal >= 2", language="mtl", **given)


# --- what is meant ----------------------------------------------------------------------------


@pytest.mark.parametrize("encoding", ["tight", "reference"])
@pytest.mark.parametrize("objective", [["travel"], ["cost", "travel"], ["makespan"], []])
def test_an_edge_that_no_quickest_way_takes_is_taken(encoding, objective):
    problem = tsplan.Problem(detour(objective=objective), Tuning.named(encoding))
    problem.add(problem.flow(("home", "end"), step=1) == 1, "by the slow way")
    problem.add(problem.flow(("way", "end"), step=1) == 1)
    plan = tsplan.plan(problem)
    assert plan.status == "optimal"
    ways = {agent.stays for agent in plan.agents}
    assert ((0, 1, "home"), (4, 5, "end")) in ways
    assert not problem.broken(plan)


def test_what_goes_that_way_may_be_too_much():
    problem = tsplan.Problem(detour())
    for step in range(5):
        problem.add(problem.flow(("way", "end"), step=step) <= 0)
    assert tsplan.plan(problem).value("travel") == 6
    problem.add(sum(problem.flow(("home", "end"), step=step) for step in range(5)) <= 1)
    assert tsplan.plan(problem).status == "infeasible"


def test_waits_are_edges_and_the_last_move_may_be_cut_short():
    problem = tsplan.Problem(detour())
    problem.add(problem.flow(("home", "home"), step=0) == 2)
    problem.add(problem.flow(("home", "end"), step=4) == 1)
    plan = tsplan.plan(problem)
    assert {agent.heading for agent in plan.agents} == {None, "end"}
    assert not problem.broken(plan)


def test_flows_can_be_an_objective():
    problem = tsplan.Problem(detour())
    problem.maximise(sum(problem.flow(("home", "end"), step=step) for step in range(5)))
    plan = tsplan.plan(problem)
    assert plan.notes == ("own objective, maximised: 3 (bound 3)",)


def test_of_a_swarm_it_is_its_agents():
    problem = tsplan.Problem(detour(team=None, swarm={"size": 20, "at": "home"}, objective=()))
    problem.add(problem.flow(("home", "end"), step=0) == 7)
    plan = tsplan.plan(problem)
    assert (0, "home", "end", 7) in plan.moves["swarm"]
    assert not problem.broken(plan)


@pytest.mark.parametrize(
    ("edge", "more", "words"),
    [
        (("home", "far"), {}, r"no edge from 'home' to 'far'; from 'home' lead \('home', 'home'\)"),
        (("hom", "end"), {}, "did you mean 'home'"),
        (("home", "goal"), {}, "no state 'goal'"),
        ("home", {}, r"'home' is no edge; name its two ends"),
        (("home", "way", "end"), {}, "is no edge"),
        (None, {}, "None is no edge"),
        (("home", 3), {}, "3 is not the name of a state"),
        (("home", "end"), {"step": 5}, r"outside 0\.\.4"),
        (("home", "end"), {"step": -1}, r"outside 0\.\.4"),
        (("home", "end"), {"step": 1.5}, "not a whole number"),
        (("home", "end"), {"capability": "fly"}, "no capability 'fly'"),
    ],
)
def test_what_is_no_flow_is_an_error_where_it_is_written(edge, more, words):
    problem = tsplan.Problem(detour())
    with pytest.raises(MissionError, match=words):
        problem.flow(edge, **{"step": 1, **more})


def test_edges_can_be_given_as_they_are():
    mission = detour()
    problem = tsplan.Problem(mission)
    edge = mission.system.edges["home", "end"]
    asked = problem.flow(edge, step=2) >= 1
    assert str(asked) == str(problem.flow(("home", "end"), step=2) >= 1)


def test_a_mission_without_steps_has_no_flows():
    still = replace(detour(), formula=tsplan.parse("goal >= 0", "mtl"), horizon=0)
    with pytest.raises(MissionError, match="ends at step 0"):
        tsplan.Problem(still).flow(("home", "end"), step=0)


def test_flows_of_another_mission_are_refused():
    other = tsplan.Problem(detour()).flow(("home", "end"), step=1)
    yard = tsplan.grid(1, 2)
    mission = tsplan.Mission.of(map=yard, team={"a": {"r0c0": 1}}, formula="true", language="mtl")
    with pytest.raises(MissionError, match="no state 'home'"):
        tsplan.Problem(mission).add(other >= 1)


def test_a_plan_that_enters_another_edge_is_refused(monkeypatch):
    problem = tsplan.Problem(detour())
    problem.add(problem.flow(("home", "end"), step=1) >= 1, "slow")
    monkeypatch.setattr("tsplan.encode.assemble.constraint_rows", lambda *_: None)
    with pytest.raises(tsplan.SolverError, match=r"'slow' asks for flow\(\('home', 'end'\)"):
        tsplan.plan(problem)


# --- against brute force ----------------------------------------------------------------------


class Asked:
    """Random own constraints, an objective perhaps, and what they come to in a joint plan."""

    def __init__(self, problem: tsplan.Problem, random: Random) -> None:
        mission = problem.mission
        self.random = random
        self.steps = mission.horizon
        self.able = [None, *sorted({c for g in mission.team for c in g.capabilities})]
        self.edges = [*mission.system.edges]
        self.places = [*mission.system.states]
        self.boxes = [random.randint(0, 2)] if random.random() < 0.4 else []
        self.demands = [self._demand() for _ in range(random.randint(1, 2))]
        self.own = self._sum() if random.random() < 0.5 else []
        for terms, relation, bound in self.demands:
            made = self._built(problem, terms)
            problem.add(made >= bound if relation == ">=" else made <= bound)
        if self.own and not self._built(problem, self.own).terms:
            self.own = []
        if self.own:
            problem.minimise(self._built(problem, self.own))

    def _sum(self) -> list[tuple[str, object, str | None, int, int]]:
        random = self.random
        found = []
        for _ in range(random.randint(1, 3)):
            kind = random.choice(["flow", "flow", "flow", "count", *(["box"] * len(self.boxes))])
            where = random.choice(self.places if kind == "count" else self.edges)
            step = random.randrange(self.steps)
            found.append(
                (kind, where, random.choice(self.able), step, random.choice([1, 1, 2, -1]))
            )
        return found

    def _demand(self) -> tuple[list[tuple[str, object, str | None, int, int]], str, int]:
        return self._sum(), self.random.choice([">=", "<="]), self.random.choice([0, 0, 1, 1, 2])

    def _built(self, problem: tsplan.Problem, terms) -> object:
        def quantity(kind, where, able, step):
            if kind == "flow":
                return problem.flow(where, able, step=step)
            if kind == "count":
                return problem.count(where, able, step=step)
            return problem.variable("boxes", -1, self.boxes[0])

        return sum(factor * quantity(*key) for *key, factor in terms)

    def _worth(self, plan: JointPlan, terms, boxes: int) -> int:
        agents = plan.mission.agents

        def value(kind, where, able, step):
            if kind == "box":
                return boxes
            return sum(
                (able is None or able in agent.capabilities)
                and (
                    (*where, step) in {entry[:3] for entry in path.entered}
                    if kind == "flow"
                    else path.states[step] == where
                )
                for agent, path in zip(agents, plan.paths, strict=True)
            )

        return sum(factor * value(*key) for *key, factor in terms)

    def best(self, mission: tsplan.Mission) -> tuple[int, float] | None:
        """The least own sum, and the least travel beside it; None where nothing is allowed."""
        found = None
        choices = range(-1, self.boxes[0] + 1) if self.boxes else [0]
        for plan, boxes in product(joint_plans(mission), choices):
            sums = [(self._worth(plan, terms, boxes), r, b) for terms, r, b in self.demands]
            if not all(s >= b if r == ">=" else s <= b for s, r, b in sums):
                continue
            value = self._worth(plan, self.own, boxes), float(plan.worth("travel"))
            if (found is None or value < found) and holds(mission, plan, mission.delay):
                found = value
        return found


def agrees(mission: tsplan.Mission, seed: int) -> bool | None:
    """Both encodings find what is best of all joint plans; whether there is a plan."""
    mission = replace(mission, objective=("travel",), prefer=())
    if not (small_enough(mission) and mission.horizon and mission.system.edges):
        return None
    expected = None
    for encoding in ("tight", "reference"):
        problem = tsplan.Problem(mission, Tuning.named(encoding))
        asked = Asked(problem, Random(seed))
        expected = asked.best(mission)
        plan = tsplan.plan(problem)
        if expected is None:
            assert plan.status == "infeasible", (seed, encoding)
            continue
        assert (plan.status, plan.verified) == ("optimal", True), (seed, encoding)
        own = worth(problem.own.expression.terms, plan, mission)
        assert (own, plan.value("travel")) == expected, (seed, encoding)
        assert tsplan.Plan.from_json(plan.to_json()) == plan
    return expected is not None


def of_kind(seed: int) -> tsplan.Mission:
    """A random mission: of tasks, any formula, late agents, swarms, or robots and swarms."""
    kind = seed % 5
    if kind == 0:
        return random_task_mission(seed, states=4)
    if kind == 3:
        return random_swarm_mission(seed, fits=small_enough)
    mission = random_mission(seed, states=4, most_agents=2, steps=5, mixed=kind == 4)
    late = min(1 + seed % 2, mission.horizon) if kind == 2 else 0
    return replace(mission, delay=late)


@pytest.mark.parametrize("seeds", seed_blocks(range(20), range(3060), 60))
def test_random_flows_agree_with_brute_force(seeds: list[int]) -> None:
    answers = [agrees(of_kind(seed), seed) for seed in seeds]
    assert min(answers.count(True), answers.count(False)) >= 3


@pytest.mark.parametrize("seed", sampled(range(200), range(8)))
def test_structures_of_modules_are_counted_alike(seed: int) -> None:
    mission = replace(random_module_mission(seed), objective=("travel",))
    found = []
    for encoding in ("tight", "reference"):
        problem = tsplan.Problem(mission, Tuning.named(encoding))
        random = Random(seed)
        edges = random.sample([*mission.system.edges], 2)
        flows = [problem.flow(e, step=random.randrange(mission.horizon)) for e in edges]
        problem.add(flows[0] >= 1)
        problem.maximise(flows[1])
        plan = tsplan.plan(problem)
        assert not plan.has_paths or not problem.broken(plan)
        found.append((plan.status, plan.has_paths and plan.notes[0], plan.objective))
    assert found[0] == found[1]


def test_exact_sums_of_numbers_that_no_float_has():
    problem = tsplan.Problem(detour())
    third = problem.flow(("home", "end"), step=0) / 3 + problem.flow(("home", "way"), step=0) / 3
    problem.add(third == Fraction(2, 3))
    assert tsplan.plan(problem).status == "optimal"
