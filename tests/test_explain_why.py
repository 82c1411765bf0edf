"""Why a formula holds: the evidence tree and the requirements, by hand and on random missions."""

from __future__ import annotations

from random import Random

import numpy as np
import pytest

from tests.seeds import sampled
from tsplan import Mission
from tsplan.errors import PlanError
from tsplan.explanation.why.requirements import requirements, runs
from tsplan.explanation.why.staffing import Presence
from tsplan.explanation.why.witness_tree import explain
from tsplan.logic import horizon, parse, robustness
from tsplan.logic.atoms import Count
from tsplan.logic.evaluation import margins
from tsplan.logic.nodes import Always, And, Eventually, Iff, Implies, Not, Or, Release, Until
from tsplan.logic.obligations import JUDGED, obligations
from tsplan.mission import Group
from tsplan.plans.agent_plans import AgentPlan
from tsplan.plans.count_traces import count_trace
from tsplan.plans.outcomes import MissionRef
from tsplan.plans.plan import Plan
from tsplan.plans.presence import state_counts
from tsplan.testing.random_missions import LABELS, random_formula, random_map
from tsplan.ts import Edge, State, TransitionSystem

NAMES = ("home", "east", "west", "hill")
SYSTEM = TransitionSystem.build(
    [
        State("home", frozenset({"home"})),
        State("east", frozenset({"field"})),
        State("west", frozenset({"field"})),
        State("hill", frozenset({"top"})),
    ],
    [Edge(a, b) for a in NAMES for b in NAMES],
)


def made(formula, paths, language="mtl", **more):
    """A mission and a plan of agents that are at one state a step; `-` is on the way."""
    able = {"a": ["see"], "b": ["see", "lift"]}
    starts: dict[str, dict[str, int]] = {}
    agents = []
    for number, (class_name, path) in enumerate(paths):
        stays = tuple(
            (step, step, state) for step, state in enumerate(path.split()) if state != "-"
        )
        agents.append(
            AgentPlan(f"{class_name}-{number}", class_name, frozenset(able[class_name]), stays)
        )
        begin = starts.setdefault(class_name, {})
        begin[stays[0][2]] = begin.get(stays[0][2], 0) + 1
    team = [Group.of(name, begin, able[name]) for name, begin in starts.items()]
    steps = len(paths[0][1].split()) - 1
    mission = Mission.of(
        map=SYSTEM, team=team, formula=formula, language=language, horizon=steps, **more
    )
    return mission, Plan("feasible", MissionRef("m", ""), steps, "gap", agents=tuple(agents))


HARVEST = """F[0,4] T(1,field,{(see,1)}) && G[0,4] L(top,{(lift,0)})
&& (F[0,2] T(0,top,{(see,2)}) || F[3,5] T(0,top,{(see,1)}))"""
WALKS = [
    ("a", "home east east east home home"),
    ("a", "home west west west home hill"),
    ("b", "home home east home home home"),
]


def test_a_tree_by_hand():
    mission, plan = made(HARVEST, WALKS, "catl")
    top = plan.explain(mission)
    (both,) = [node for depth, node in top.walk() if depth == 0]
    assert both is top
    assert (top.steps, top.availability, top.holds) == ((0,), (0.0,), True)
    harvest, clear, either = top.children
    # both fields have one agent at steps 1..3; both steps 1 and 2 start a task with none to spare
    assert isinstance(harvest.formula, Eventually)
    assert (harvest.witness_steps, harvest.availability) == ((1,), (0.0,))
    (task,) = harvest.children
    assert task.formula is parse("T(1,field,{(see,1)})", language="catl")
    assert (task.steps, task.witness_steps) == ((1,), ())
    (field,) = task.children
    assert (field.steps, field.counts, field.tightest) == ((1, 2), (1, 1), 1)
    assert field.present == (Presence("east", 1, ("a-0",)), Presence("west", 1, ("a-1",)))
    assert isinstance(clear.formula, Always)
    assert clear.children[0].steps == (0, 1, 2, 3, 4)
    assert clear.availability == (0.0,)
    early, late = either.children
    assert (early.needed, early.availability, early.witness_steps) == (False, (-2.0,), (0,))
    assert (late.needed, late.witness_steps, late.availability) == (True, (5,), (0.0,))
    assert late.children[0].children[0].present == (Presence("hill", 1, ("a-1",)),)


def test_the_tree_in_words():
    mission, plan = made(HARVEST, WALKS, "catl")
    lines = str(plan.explain(mission)).splitlines()
    assert lines[0].split() == ["&&", "holds", "at", "0,", "availability", "0"]
    assert lines[1].startswith("  F[0,4]  ")
    assert lines[1].endswith("holds at 0, availability 0, met at 1")
    assert lines[2].startswith("    T(1,field,{(see,1)})  ")
    assert lines[3].endswith("count 1, at step 1: a-0 at east; a-1 at west")
    assert any("(not needed: fails at 0, availability -2, closest at 0)" in line for line in lines)


def test_the_earliest_of_the_most_robust_steps_is_chosen():
    walks = [("a", "home hill home hill hill"), ("a", "home home home hill hill")]
    mission, plan = made("F[0,4] top", walks)
    top = plan.explain(mission)
    assert (top.witness_steps, top.availability) == ((3,), (1.0,))
    assert top.children[0].counts == (2,)


def test_until_and_release_say_where_they_change_over():
    walks = [("a", "home home home east hill hill"), ("a", "hill hill hill hill hill hill")]
    mission, plan = made("(sum(field) <= 0) U[1,4] (sum(top) >= 2)", walks)
    # the field is entered at step 3, before the second agent comes to the hill at step 4
    top = plan.explain(mission)
    assert (top.holds, top.availability) == (False, (-1.0,))
    held, reached = top.children
    # every change-over misses by one agent: up to step 3 on the hill, later on the left side
    assert (held.steps, reached.steps) == ((3,), (1, 2, 3))
    assert "left side ends at 3" in str(top)
    mission, plan = made("(sum(field) <= 1) U[1,4] (sum(top) >= 2)", walks)
    top = plan.explain(mission)
    assert (top.witness_steps, top.availability) == ((4,), (0.0,))
    assert [child.steps for child in top.children] == [(0, 1, 2, 3), (4,)]
    mission, plan = made("field R[0,5] (sum(top) <= 1)", walks)
    top = plan.explain(mission)
    assert top.witness_steps == (3,)
    assert [child.steps for child in top.children] == [(3,), (0, 1, 2, 3)]
    mission, plan = made("(sum(home) >= 9) R[0,5] (sum(top) <= 2)", walks)
    top = plan.explain(mission)
    assert top.witness_steps == (None,)
    assert [child.steps for child in top.children] == [(), (0, 1, 2, 3, 4, 5)]
    assert "held all through" in str(top)
    assert "not needed" in str(top)


def test_negation_turns_what_settles_a_window():
    walks = [("a", "home home east home")]
    mission, plan = made("!F[0,3] top && !G[0,3] home", walks)
    never, sometimes = plan.explain(mission).children
    assert never.children[0].children[0].steps == (0, 1, 2, 3)
    assert sometimes.children[0].witness_steps == (2,)
    assert sometimes.children[0].children[0].steps == (2,)
    assert sometimes.children[0].holds is False


def test_agents_are_named_up_to_a_few_and_counted_beyond():
    walks = [("a", "hill hill")] * 3 + [("b", "hill hill")] * 3
    mission, plan = made("G[0,1] sum(top,see) >= 5", walks)
    (atom,) = plan.explain(mission).children
    assert atom.present == (Presence("hill", 6, ("a-0", "a-1", "a-2", "b-3")),)
    assert "a-0..2, b-3 and 2 more at hill" in str(atom)
    empty, plan = made("G[0,1] min(field) >= 0", walks)
    assert "nobody at east; nobody at west" in str(plan.explain(empty))


def test_formulas_of_any_depth_and_with_shared_parts():
    deep = parse("top")
    for _ in range(3_000):
        deep = ~deep
    mission, plan = made(deep, [("a", "hill hill")])
    why = plan.explain(mission)
    assert sum(1 for _ in why.walk()) == 3_001
    assert "further nodes" in str(why)
    shared = parse("top")
    for _ in range(11):
        shared = And((shared, shared))
    mission, plan = made(shared, [("a", "hill hill")])
    why = plan.explain(mission)
    assert why.holds
    assert "more than 2000 further nodes" in str(why)


def test_another_mission_s_plan_is_refused():
    mission, plan = made("F[0,1] top", [("a", "home hill")])
    longer, _ = made("F[0,2] top", [("a", "home hill hill")])
    with pytest.raises(PlanError, match="ends at step 1"):
        plan.explain(longer)
    with pytest.raises(PlanError, match="no paths"):
        Plan("infeasible", MissionRef("m", ""), 1).explain(mission)
    stray = AgentPlan("a-0", "a", frozenset(), ((0, 1, "hil"),))
    with pytest.raises(PlanError, match="did you mean 'hill'"):
        Plan("feasible", MissionRef("m", ""), 1, "gap", agents=(stray,)).requirements(mission)


def test_requirements_by_hand():
    mission, plan = made(HARVEST, WALKS, "catl")
    found = {(r.title): r for r in plan.requirements(mission)}
    field = found["see at every field \u2265 1"]
    assert field.counts.tolist() == [0, 1, 1, 1, 0, 0]
    assert field.margins.tolist() == [-1, 0, 0, 0, -1, -1]
    assert (field.windows, field.witness_steps, field.slack) == (((0, 5),), ((1, 2),), 0)
    assert (field.label, field.capability, field.relation, field.bound) == ("field", "see", ">=", 1)
    early, late = found["see at top \u2265 2"], found["see at top \u2265 1"]
    assert (early.windows, early.witness_steps, early.slack) == (((0, 2),), (), None)
    assert (late.windows, late.witness_steps) == (((3, 5),), ((5, 5),))
    assert found["lift at top \u2264 0"].witness_steps == ((0, 4),)
    assert not field.counts.flags.writeable


def test_one_atom_in_two_windows_is_one_requirement():
    mission, plan = made("F[0,1] top && F[3,4] top", [("a", "home hill home home hill")])
    (one,) = plan.requirements(mission)
    assert one.windows == ((0, 1), (3, 4))
    assert one.witness_steps == ((1, 1), (4, 4))


def test_runs():
    assert runs(np.array([], dtype=np.int64)) == ()
    assert runs(np.array([4])) == ((4, 4),)
    assert runs(np.array([0, 1, 3, 4, 5, 9])) == ((0, 1), (3, 5), (9, 9))


def random_case(seed):
    """A random mission of any formula, and random walks that need not satisfy it."""
    random = Random(seed)
    system = random_map(random, 4, strange=False)
    text = random_formula(random, random.randint(1, 3))
    if random.random() < 0.3:
        other = random_formula(random, 1)
        text = random.choice([f"({text}) <=> ({other})", f"!({text})"])
    formula = parse(text, language="mtl")
    steps = horizon(formula) + random.randint(0, 2)
    names = list(system.states)
    agents = []
    for number in range(random.randint(1, 5)):
        abilities = frozenset(name for name in "uv" if random.random() < 0.6)
        stays = tuple(
            (step, step, random.choice(names))
            for step in range(steps + 1)
            if not step or random.random() < 0.8
        )
        agents.append(AgentPlan(f"k{number}-1", f"k{number}", abilities, stays))
    team = [Group.of(a.class_name, {a.stays[0][2]: 1}, a.capabilities) for a in agents]
    mission = Mission.of(map=system, team=team, formula=formula, language="mtl", horizon=steps)
    return mission, Plan("feasible", MissionRef("m", ""), steps, "gap", agents=tuple(agents))


def everything(mission, plan):
    """All counts of a plan."""
    states = list(mission.system.states)
    counts = {
        name: state_counts(plan.presences, states, plan.horizon, name) for name in (None, "u", "v")
    }
    return count_trace(mission.system, counts)


def settles(node):
    """Whether what is below a node fixes its values at its steps, told from the children alone."""
    values = [dict(zip(child.steps, child.availability, strict=True)) for child in node.children]
    for place, (step, value) in enumerate(zip(node.steps, node.availability, strict=True)):
        assert rebuilt(node, values, (step, value, place)) == value


def rebuilt(node, values, at):
    """A node's value at a step from the values of its children where they are judged."""
    step, value, place = at
    formula = node.formula
    match formula:
        case Not():
            return -values[0][step] - 1
        case And() | Or():
            choose = min if isinstance(formula, And) else max
            return choose(v[step] for v in values if step in v)
        case Implies():
            left = -values[0][step] - 1 if step in values[0] else -np.inf
            return max(left, values[1].get(step, -np.inf))
        case Iff():
            left, right = values[0][step], values[1][step]
            return max(min(left, right), min(-left - 1, -right - 1))
        case Eventually() | Always():
            inside = [
                values[0][s]
                for s in range(step + formula.low, step + formula.high + 1)
                if s in values[0]
            ]
            assert values[0][node.witness_steps[place]] == value
            return (max if isinstance(formula, Eventually) else min)(inside)
        case Until() | Release():
            return switched(formula, values, step, value)
    raise AssertionError(formula)


def switched(formula, values, step, value):
    """An until that holds, or a release that fails, by its change-over; else by the refusals."""
    left, right = values
    sign = 1 if isinstance(formula, Until) else -1
    found = []
    for s in range(step + formula.low, step + formula.high + 1):
        # a side that is not judged at a step does not settle anything: it is as good as can be
        # where the node is refused, and as bad as can be where it is reached
        reached = (value >= 0) == (sign == 1)
        free = -np.inf if reached else np.inf
        parts = [sign * right[s] if s in right else free]
        parts += [sign * left[t] if t in left else free for t in range(step, s)]
        found.append(min(parts))
    return sign * max(found)


@pytest.mark.parametrize("seed", sampled(range(150), range(50)))
def test_random_evidence_settles_the_formula_and_agrees_with_the_evaluator(seed):
    mission, plan = random_case(seed)
    top = explain(plan, mission)
    trace = everything(mission, plan)
    assert top.availability == (float(robustness(mission.counted, trace)[0]),)
    for _, node in top.walk():
        if not node.steps:  # nothing rests on it; it may even look beyond the horizon
            continue
        expected = robustness(node.formula, trace)
        assert node.availability == tuple(expected[list(node.steps)].tolist())
        if node.children:
            settles(node)
        if isinstance(node.formula, Count):
            there = {there.state: there.count for there in node.present}
            measure = {"sum": sum, "min": min, "max": max}[node.formula.function]
            counts = dict(zip(node.steps, node.counts, strict=True))
            assert measure(there.values()) == counts[node.tightest]


@pytest.mark.parametrize("seed", sampled(range(150, 250), range(150, 190)))
def test_random_requirements_stay_in_their_windows_and_settle_the_goal(seed):
    mission, plan = random_case(seed)
    found = requirements(plan, mission)
    trace = everything(mission, plan)
    value = float(robustness(mission.goal, trace)[0])
    owed = obligations(mission.goal, JUDGED, margins(mission.goal, trace))
    wheres = {node: tuple(sorted(one.windows)) for (node, _), one in owed.items()}
    used = {node: one.steps for (node, _), one in owed.items()}
    assert {r.atom for r in found} == {node for node in wheres if isinstance(node, Count)}
    for r in found:
        assert r.margins.tolist() == robustness(r.atom, trace).tolist()
        assert r.windows == wheres[r.atom]
        assert r.label in LABELS
        inside = {s for first, last in r.windows for s in range(first, last + 1)}
        steps = {s for first, last in r.witness_steps for s in range(first, last + 1)}
        assert steps == set(used[r.atom].tolist())
        assert steps <= inside
        if value >= 0 and r.witness_steps:
            assert r.slack >= value
