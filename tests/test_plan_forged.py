"""Forged and broken plan files: findings or a verdict, never anything else."""

from __future__ import annotations

import copy
import json
import random
from collections import Counter
from contextlib import suppress

import pytest

import tsplan
from tests.seeds import sampled
from tsplan.cli import main
from tsplan.errors import PlanError, TsplanError
from tsplan.mission import load_mission
from tsplan.plans import agent_entries
from tsplan.plans.plan_file import load_plan

MAP = """\
map:
  waiting: true
  states: {a: {labels: [A], capacity: 30}, b: {labels: [B]}, c: {}}
  edges:
  - {from: a, to: b, duration: 2, capacity: 20, both_ways: true}
  - [b, c, 1]
  - [c, a, 1]
"""
MISSIONS = {
    "team": f"""\
format: tsplan-mission/1
{MAP}
team: [{{class: r, count: 2, at: a, capabilities: [x]}}, {{class: s, at: b}}]
spec:
  language: catl
  must: "F[0,4] T(1, B, {{(x,1)}})"
  prefer: [{{formula: "F[0,6] sum(A) >= 2", weight: 2}}]
objective: [preferences, availability, cost]
""",
    "part": f"""\
format: tsplan-mission/1
{MAP}
team: [{{class: r, count: 2, at: a, capabilities: [x]}}]
spec: F[0,4] B && G[0,6] A
objective: [satisfaction, travel]
""",
    "swarm": f"""\
format: tsplan-mission/1
{MAP}
swarms:
- {{name: u, size: 8, at: a, max_subswarms: 3, min_subswarm: 2}}
- {{name: v, size: 4, at: {{b: 2, c: 2}}}}
max_subswarms: 6
margin: 1
spec: F[0,5] (sum(B,u) >= 4 && sum(A,v) >= 1)
objective: [splits, travel]
""",
    "mixed": f"""\
format: tsplan-mission/1
{MAP}
team: [{{class: r, count: 2, at: a, capabilities: [x]}}]
swarms: [{{name: u, size: 8, at: a, max_subswarms: 2, min_subswarm: 2}}]
spec: {{language: mtl, formula: "F[0,5] (sum(B,u) >= 3 && sum(B,x) >= 1 && sum(A) >= 2)"}}
objective: [splits, availability, cost]
""",
}
WORDS = ["a", "b", "c", "u", "v", "r", "s", "r-1", "r-2", "u:1", "v:1", "x", "zz", ""]
WHOLES = [-1, 0, 1, 2, 3, 5, 8, 10**6, 10**12, 10**15, 10**30]
OTHERS = [None, True, "optimal", "infeasible", [], {}, [0, 1, "a"], ["a", "b"], "1/3", 0.5, 1e300]
PARTS = ("agents", "moves", "groups", "satisfaction", "preferences", "objective", "horizon")


@pytest.fixture(scope="module")
def folder(tmp_path_factory):
    """The missions and their plans."""
    made = tmp_path_factory.mktemp("forged")
    for name, text in MISSIONS.items():
        (made / f"{name}.yaml").write_text(text)
        plan = tsplan.plan(load_mission(made / f"{name}.yaml"))
        (made / f"{name}.json").write_text(plan.to_json())
        with pytest.MonkeyPatch.context() as patch:
            patch.setattr(agent_entries, "MOST_LISTED", 0)
            (made / f"{name}-bundles.json").write_text(plan.to_json())
    return made


def paths_in(data, path=()):
    """The paths of all parts of a document."""
    if path:
        yield path
    if isinstance(data, dict | list):
        keys = data if isinstance(data, dict) else range(len(data))
        for key in keys:
            yield from paths_in(data[key], (*path, key))


def forged(data, chance):
    """A plan with a few parts deleted, repeated, exchanged, or with other values."""
    data = copy.deepcopy(data)
    for _ in range(chance.choice((1, 1, 2, 3))):
        known = [path for path in paths_in(data) if path[0] in PARTS]
        if chance.random() < 0.15:
            known = list(paths_in(data))
        *way, key = chance.choice(known)
        around = data
        for step in way:
            around = around[step]
        change(around, key, chance)
    for part in ("groups", "agents"):
        if chance.random() < 0.15:
            data.pop(part, None)
    return data


def change(around, key, chance):
    """Change one part; mostly into something of the same kind, which gets further."""
    value, draw = around[key], chance.random()
    if draw < 0.1:
        del around[key]
    elif draw < 0.2:
        around[key] = copy.deepcopy(chance.choice(OTHERS))
    elif isinstance(value, bool):
        around[key] = not value
    elif isinstance(value, int | float):
        around[key] = chance.choice([value + 1, value - 1, -value, chance.choice(WHOLES)])
    elif isinstance(value, str):
        around[key] = chance.choice(WORDS)
    elif isinstance(value, list) and value:
        value.insert(chance.randrange(len(value)), copy.deepcopy(chance.choice(value)))
        if draw < 0.6:
            del value[chance.randrange(len(value))]
    elif isinstance(value, dict) and value:
        value[chance.choice(WORDS)] = value.pop(chance.choice(list(value)))


def forged_file(folder, seed, form=""):
    """Name of a mission and the text of a forged plan of it."""
    chance = random.Random(seed)
    name = chance.choice(list(MISSIONS))
    data = forged(json.loads((folder / f"{name}{form}.json").read_text()), chance)
    return name, json.dumps(data)


def judge(folder, seed, capsys, *, pictures, form=""):
    """Run every command on a forged plan."""
    name, text = forged_file(folder, seed, form)
    mission, plan = str(folder / f"{name}.yaml"), folder / "plan.json"
    plan.write_text(text)
    commands = [
        ["check", mission, str(plan)],
        ["show", str(plan), "--why", "--mission", mission],
        ["view", str(plan), "--mission", mission, "-o", str(folder / "view.html")],
        ["simulate", mission, str(plan), "--runs", "3"],
    ]
    if pictures:
        commands.append(["show", str(plan), "--mission", mission, "-o", str(folder / "plan.svg")])
    for command in commands:
        code = main(command)
        told = capsys.readouterr().err
        assert code in (0, 1, 2), (seed, command, told)
        assert "internal error" not in told, (seed, command, told)
        assert code != 2 or told.strip(), (seed, command)


@pytest.mark.parametrize("seed", sampled([*range(60), *range(1000, 4000)], range(2)))
def test_forged_plans_end_in_findings_or_a_verdict(folder, seed, capsys):
    judge(folder, seed, capsys, pictures=seed % (10 if seed < 60 else 5) == 0)


@pytest.mark.parametrize("seed", sampled([*range(40), *range(7000, 9000)], range(3)))
def test_forged_bundles_end_in_findings_or_a_verdict(folder, seed, capsys):
    judge(folder, seed, capsys, pictures=seed % 10 == 0, form="-bundles")


def forge_ids(data, chance):
    """Another name in place of one of the bundles', or one of them once more."""
    bundles = data["agents"]
    ids = chance.choice(bundles)["ids"]
    place = chance.randrange(len(ids))
    stem, first, last, where = ids[place]
    other = chance.choice(chance.choice(bundles)["ids"])
    ids[place] = chance.choice(
        (
            [other[0], other[1], other[1] + last - first, where],
            [stem, first + 1, last + 1, where],
            [stem, first - 1, last - 1, where],
            [f"{stem}x", first, last, where],
            [stem, first, last - 1, where],
        )
    )
    if chance.random() < 0.3:
        agents = sum(last - first + 1 for entry in bundles for _, first, last, _ in entry["ids"])
        ids.append([*other[:3], agents])


@pytest.mark.parametrize("name", ["team", "part", "mixed"])
@pytest.mark.parametrize("seed", range(8))
def test_bundles_of_others_are_refused(folder, name, seed):
    chance = random.Random(f"{name} {seed}")
    data = json.loads((folder / f"{name}-bundles.json").read_text())
    mission = load_mission(folder / f"{name}.yaml")
    whole = tsplan.Plan.from_json(json.dumps(data))
    assert tsplan.check(mission, whole).ok
    forge_ids(data, chance)
    try:
        plan = tsplan.Plan.from_json(json.dumps(data))
    except PlanError:
        return  # places with a gap, or a run without names
    same = Counter(plan.agents) == Counter(whole.agents)
    assert tsplan.check(mission, plan).ok == same


def ask_in_python(folder, seed):
    """Everything that is made of a plan in Python: it ends, or in an error of the package."""
    name, text = forged_file(folder, seed, "-bundles" if seed % 3 == 0 else "")
    try:
        plan = tsplan.Plan.from_json(text)
    except PlanError:
        return
    mission = load_mission(folder / f"{name}.yaml")
    for ask in (
        lambda: tsplan.check(mission, plan),
        lambda: tsplan.assign(mission, plan),
        lambda: tsplan.simulate(mission, plan, runs=2),
        lambda: str(plan.explain(mission)),
        lambda: plan.requirements(mission),
        lambda: (plan.states, plan.counts(), plan.state_at(1), plan.shares),
        plan._repr_html_,
        plan.to_json,
    ):
        with suppress(TsplanError):
            ask()


@pytest.mark.parametrize("seed", sampled([*range(100, 200), *range(4000, 7000)], range(150)))
def test_forged_plans_end_in_errors_of_the_package_in_python(folder, seed):
    ask_in_python(folder, seed)


def test_moves_that_are_impossible_cannot_be_assigned(folder):
    path = changed(folder, "swarm", moves={"u": [[0, "a", "zz", 8]], "v": []}, groups=None)
    mission = load_mission(folder / "swarm.yaml")
    with pytest.raises(PlanError, match="u goes from a to zz at step 0"):
        tsplan.assign(mission, load_plan(path))


def changed(folder, name, **parts):
    """The plan of a mission with other parts, written beside it; None takes a part away."""
    data = json.loads((folder / f"{name}.json").read_text()) | parts
    path = folder / f"changed-{name}.json"
    path.write_text(json.dumps({key: part for key, part in data.items() if part is not None}))
    return path


@pytest.mark.parametrize("command", [["show", "--why"], ["view", "-o", "view.html"]])
def test_impossible_paths_are_refused_alike(folder, capsys, command, monkeypatch):
    monkeypatch.chdir(folder)
    agents = json.loads((folder / "part.json").read_text())["agents"]
    agents[0]["stays"] = [[0, 0, "a"], [1, 6, "c"]]
    path = changed(folder, "part", agents=agents)
    asked = [command[0], str(path), *command[1:], "--mission", "part.yaml"]
    assert main(asked) == 2
    assert "agent r-1 goes from a to c" in capsys.readouterr().err


@pytest.mark.parametrize(
    "parts",
    [
        {"moves": {"u": [[0, "a", "c", 8]], "v": []}, "groups": None, "agents": None},
        {"moves": {"zz": [[0, "a", "b", 8]]}, "groups": None, "agents": None},
        {"moves": {}, "agents": None},
        {"groups": [{"id": "1", "swarm": "zz", "from": 0, "to": 0, "size": 8, "state": "a"}]},
        {"groups": [{"id": "1", "swarm": "u", "from": 0, "to": 9, "size": 8, "edge": ["a", "zz"]}]},
    ],
)
def test_impossible_moves_are_refused_in_words(folder, capsys, parts):
    path = changed(folder, "swarm", **parts)
    mission = str(folder / "swarm.yaml")
    for command in (
        ["show", str(path), "--why"],
        ["view", str(path), "-o", str(folder / "v.html")],
    ):
        assert main([*command, "--mission", mission]) == 2
        assert capsys.readouterr().err.strip()
    assert main(["check", mission, str(path)]) in (1, 2)


def test_moves_alone_are_enough(folder, capsys):
    path = changed(folder, "swarm", groups=None, agents=None)
    assert main(["show", str(path), "--why", "--mission", str(folder / "swarm.yaml")]) == 0
    assert "B" in capsys.readouterr().out
    picture = folder / "moves.svg"
    assert (
        main(["show", str(path), "--mission", str(folder / "swarm.yaml"), "-o", str(picture)]) == 0
    )
    assert picture.exists()


@pytest.mark.parametrize("name", MISSIONS)
def test_a_plan_called_optimal_needs_bounds_that_are_its_values(folder, name):
    mission = load_mission(folder / f"{name}.yaml")
    objective = json.loads((folder / f"{name}.json").read_text())["objective"]
    assert tsplan.check(mission, load_plan(folder / f"{name}.json")).ok
    last = objective[-1]
    open_ = [*objective[:-1], {**last, "bound": None}]
    report = tsplan.check(mission, load_plan(changed(folder, name, objective=open_)))
    assert "no bound proves it" in str(report.findings[0])
    loose = [*objective[:-1], {**last, "bound": last["value"] - 1}]
    assert not tsplan.check(mission, load_plan(changed(folder, name, objective=loose))).ok
    told = {"status": "feasible", "stopped_by": "time_limit"}
    assert tsplan.check(mission, load_plan(changed(folder, name, objective=open_, **told))).ok


@pytest.mark.parametrize("text", ["1" * 5000, "1" * 50])
def test_numbers_of_many_digits_are_refused(folder, text):
    plan = (folder / "part.json").read_text().replace('"horizon": 6', f'"horizon": {text}')
    with pytest.raises(PlanError, match="digits means nothing here"):
        tsplan.Plan.from_json(plan)
