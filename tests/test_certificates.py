"""Certificates: what is written is accepted, by two readers; what is tampered with is refused."""

from __future__ import annotations

import json
import re
import subprocess
import sys
from dataclasses import replace
from fractions import Fraction
from pathlib import Path
from random import Random

import pytest

import tsplan
from tests.many_tasks import mission as many_tasks
from tests.second_checker import accepts
from tests.seeds import sampled, seed_blocks
from tsplan.certificates.checker import CertificateError, checked
from tsplan.certificates.cut_rows import CutRows
from tsplan.certificates.rows_of import KINDS
from tsplan.certificates.stage_model import Head, StageModel
from tsplan.certificates.verification import Verified, joined, verified
from tsplan.cli.main import main
from tsplan.errors import InputError
from tsplan.plans.outcomes import CERTIFIED
from tsplan.testing import random_mission, random_swarm_mission, random_task_mission

ENVIRONMENTS = Path(__file__).parent.parent / "environments"
BRANCHED = (45, 59)  # seeds of missions whose trees have branchings
CUT = (1, 7)  # seeds of missions of many tasks with branchings and cuts of both kinds


def written(mission: tsplan.Mission, folder: Path) -> tuple[tsplan.Plan, list[str]]:
    """A certified plan and the texts of its certificates."""
    plan = tsplan.plan(mission, certificate=folder / "c.vipr", time_limit=60)
    return plan, [path.read_text() for path in sorted(folder.glob("*.vipr"))]


def drawn(seed: int) -> tsplan.Mission:
    kinds = (
        random_mission,
        random_task_mission,
        random_swarm_mission,
        lambda s: random_mission(s, mixed=True),
    )
    return kinds[seed % len(kinds)](seed)


@pytest.mark.parametrize("seeds", seed_blocks(range(4), range(4, 400), 4))
def test_what_is_proven_can_be_verified(seeds, tmp_path):
    for seed in seeds:
        mission, folder = drawn(seed), tmp_path / str(seed)
        folder.mkdir()
        plan, texts = written(mission, folder)
        plain = tsplan.plan(mission, time_limit=60)
        assert (plan.status, plan.objective) == (plain.status, plain.objective)
        proofs = [verified(mission, text) for text in texts]
        assert all(accepts(text) for text in texts)
        if not plan.has_paths:
            assert plan.proof == CERTIFIED
            assert [proof.words for proof in proofs] == ["no plan satisfies the mission"]
        elif not any("rounds what need not be whole" in note for note in plan.notes):
            assert joined(mission, plan, proofs).proven


@pytest.mark.parametrize("seed", [50, 62])
def test_swarms_whose_program_is_refuted_at_once_have_certificates(seed, tmp_path):
    mission = drawn(seed)
    plan, texts = written(mission, tmp_path)
    assert (plan.status, plan.proof) == (tsplan.Status.INFEASIBLE, CERTIFIED)
    assert [verified(mission, text).words for text in texts] == ["no plan satisfies the mission"]


@pytest.mark.parametrize("mission", [*map(random_mission, BRANCHED), many_tasks(CUT[0], tasks=5)])
def test_trees_with_branchings_are_verified(mission, tmp_path):
    plan, texts = written(mission, tmp_path)
    assert any(" uns " in text for text in texts)
    assert all(accepts(text) for text in texts)
    assert joined(mission, plan, [verified(mission, text) for text in texts]).proven


# --- what is tampered with ---------------------------------------------------------------------


def tampered(text: str, random: Random) -> str:
    """A certificate in which one number of a row, a bound, a branching or a proof is another."""
    lines = text.split("\n")
    kinds = {
        "objective": [n for n, line in enumerate(lines) if n and lines[n - 1] == "OBJ min"],
        "rows": [n for n, line in enumerate(lines) if line[:1] in "glrav" and line[1:2] != " "],
        "branchings": [n for n, line in enumerate(lines) if "{ asm }" in line],
        "multipliers": [n for n, line in enumerate(lines) if "{ lin" in line or "{ rnd" in line],
        "choices": [n for n, line in enumerate(lines) if "{ uns" in line],
        "claim": [n for n, line in enumerate(lines) if line.startswith("RTP range")],
    }
    kinds["rows"] = [n for n in kinds["rows"] if len(lines[n].split()) > 3]
    kind = random.choice([kind for kind, places in kinds.items() if places])
    place = random.choice(kinds[kind])
    words = lines[place].split()
    if kind == "claim":
        words[2] = str(Fraction(words[2]) + random.choice([1, Fraction(1, 2), 10]))
    elif kind == "objective":
        return _with(lines, place, _changed(words, range(2, len(words), 2), random))
    elif kind == "choices":
        begin = words.index("uns") + 1
        # which assumptions it is about; of what holds under them several lines may do as well
        words = _changed(words, [begin + 1, begin + 3], random)
    elif kind == "multipliers":
        begin = words.index("{") + 4
        words = _changed(words, range(begin, len(words) - 2, 2), random)
    else:  # the side, or a factor
        end = words.index("{") if "{" in words else len(words)
        words = _changed(words, [2, *range(5, end, 2)], random)
    return _with(lines, place, words)


def _with(lines: list[str], place: int, words: list[str]) -> str:
    return "\n".join([*lines[:place], " ".join(words), *lines[place + 1 :]])


def _changed(words: list[str], places: list[int] | range, random: Random) -> list[str]:
    """Words of which one number is another."""
    made = list(words)
    if not len(places):
        return made
    place = random.choice(list(places))
    number = Fraction(made[place])
    made[place] = str(random.choice([number + 1, number - 1, -number or 3, 2 * number or 1]))
    return made


@pytest.fixture(scope="module")
def samples(tmp_path_factory) -> list[tuple[tsplan.Mission, str]]:
    """Missions with a certificate each: of a bound, with branchings, and of infeasibility."""
    found = []
    made = [*map(random_mission, (*BRANCHED, 3)), random_swarm_mission(2)]
    for mission in [*made, *(many_tasks(seed, tasks=5) for seed in CUT)]:
        _, texts = written(mission, tmp_path_factory.mktemp("certificates"))
        found += [(mission, text) for text in texts]
    return found


@pytest.mark.parametrize("seeds", seed_blocks(range(20), range(1040), 40))
def test_tampering_is_found(seeds, samples):
    refused = 0
    for seed in seeds:
        random = Random(seed)
        mission, text = random.choice(samples)
        other = tampered(text, random)
        if other == text:
            continue
        with pytest.raises(CertificateError):
            verified(mission, other)
        refused += 1
    assert refused > len(seeds) / 2


def test_a_certificate_is_of_its_mission_alone(samples):
    for (mission, text), (other, _) in zip(samples, [*samples[1:], samples[0]], strict=True):
        if other.digest == mission.digest:
            continue
        with pytest.raises(CertificateError, match="another mission"):
            verified(other, text)
        forged = text.replace(mission.digest, other.digest)
        with pytest.raises(CertificateError, match=r"mission's model|no groups|no cut"):
            verified(other, forged)


def test_a_changed_mission_is_told_even_with_a_forged_digest(tmp_path):
    path = ENVIRONMENTS / "farm_overbooked.yaml"
    mission = tsplan.load_mission(path)
    _, (text,) = written(mission, tmp_path)
    assert isinstance(verified(mission, text), Verified)
    # one more harvester, and there is a plan
    changed = tmp_path / "mission.yaml"
    words = path.read_text().replace("count: 3", "count: 4", 1)
    changed.write_text(words.replace("map: ", f"map: {ENVIRONMENTS}/", 1))
    other = tsplan.load_mission(changed)
    assert other.digest != mission.digest
    with pytest.raises(CertificateError, match="mission's model"):
        verified(other, text.replace(mission.digest, other.digest))


# --- the checker alone ---------------------------------------------------------------------------

EXAMPLE = """% x + y is at least 1 where 4x + y >= 1, 4x - y <= 2
VER 1.0
VAR 2
x
y
INT 2
0 1
OBJ min
2 0 1 1 1
CON 2 0
C1 G 1 2 0 4 1 1
C2 L 2 2 0 4 1 -1
RTP range 1 1
SOL 1
best 1 1 1
DER 4
C3 G -1/2 1 1 1 { lin 2 0 1/2 1 -1/2 } 3
C4 G 0 1 1 1 { rnd 1 2 1 } 4
C5 G 1/4 OBJ { lin 2 0 1/4 3 3/4 } 5
C6 G 1 OBJ { rnd 1 4 1 } 0
"""


def test_the_example_of_the_format_is_accepted():
    proven = checked(EXAMPLE)
    assert (proven.bound, proven.value, proven.steps) == (1, 1, 4)
    assert accepts(EXAMPLE)


@pytest.mark.parametrize(
    ("old", "new", "words"),
    [
        ("RTP range 1 1", "RTP range 2 2", "not the bound that is claimed|as good as is claimed"),
        ("{ rnd 1 2 1 }", "{ lin 1 2 1 }", "does not follow"),
        ("{ lin 2 0 1/2 1 -1/2 }", "{ lin 2 0 1/2 1 1/2 }", "at least and what is at most"),
        ("{ lin 2 0 1/4 3 3/4 }", "{ asm }", "rests on an assumption"),
        ("INT 2\n0 1", "INT 1\n0", "need not be whole"),
        ("best 1 1 1", "best 1 0 1", "does not meet C2"),
        ("{ rnd 1 4 1 }", "{ uns 2 0 3 1 }", "branching"),
        ("{ rnd 1 4 1 }", "{ rnd 1 9 1 }", "no constraint 9 here"),
        ("{ rnd 1 4 1 }", "{ why 1 4 1 }", "no reason 'why'"),
        ("VER 1.0", "VER 2.0", "'1.0' is expected"),
        ("0 4 1 -1", "0 4 5 -1", "no variable 5 here"),
        ("DER 4", "DER 5", "ends too early"),
        ("DER 4", "DER 3", "beyond the end"),
        ("RTP range", "RTP about", "'about' is nothing"),
        ("C1 G 1 2", "C1 G one 2", "'one' is no number"),
    ],
)
def test_what_is_wrong_is_named(old, new, words):
    assert old in EXAMPLE
    with pytest.raises(CertificateError, match=words):
        checked(EXAMPLE.replace(old, new))
    assert not accepts(EXAMPLE.replace(old, new))


def test_the_checker_is_small_and_knows_no_solver():
    source = Path(tsplan.__file__).parent / "certificates" / "checker.py"
    assert len(source.read_text().splitlines()) <= 300
    code = (
        "import sys; from tsplan.certificates import verification; "
        "print([n for n in sys.modules if 'highspy' in n or n.startswith('tsplan.search')])"
    )
    told = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, check=True)
    assert told.stdout.strip() == "[]"


# --- the command line ----------------------------------------------------------------------------


def test_the_command_line_writes_and_verifies(tmp_path, capsys, monkeypatch):
    monkeypatch.chdir(tmp_path)
    mission = str(ENVIRONMENTS / "fence_build.yaml")
    told = ["--certificate", "c.vipr", "-o", "plan.json", "--quiet", "--seed", "1"]
    assert main(["plan", mission, *told]) == 0
    plan = json.loads(Path("plan.json").read_text())
    assert [item["proof"] for item in plan["objective"]] == [CERTIFIED, CERTIFIED]
    assert plan["programs"]["verified"] > 0
    files = ["c.1.vipr", "c.2.vipr"]
    assert main(["verify", mission, *files, "--plan", "plan.json"]) == 0
    out = capsys.readouterr().out
    assert "c.1.vipr: no plan has energy below 32 (certified" in out
    assert "c.2.vipr: no plan that keeps energy 32 has travel below 40 (certified" in out
    assert "plan.json: the plan holds" in out
    # without the first certificate the first objective is not proven
    assert main(["verify", mission, files[1], "--plan", "plan.json"]) == 1
    assert "energy 32: not proven by these certificates" in capsys.readouterr().out
    other = str(ENVIRONMENTS / "farm_harvest.yaml")
    assert main(["verify", other, files[0]]) == 1
    assert "refused: it is of another mission" in capsys.readouterr().out


def test_what_has_no_certificates_says_so(tmp_path):
    mission = tsplan.load_mission(ENVIRONMENTS / "farm_shortage.yaml")
    with pytest.raises(InputError, match="no certificates of missions that are met as far"):
        tsplan.plan(mission, certificate=tmp_path / "c.vipr")
    assert not list(tmp_path.iterdir())


def test_no_certificate_is_taken_for_a_mission_of_another_kind(tmp_path):
    # that the whole formula cannot hold says nothing where it need not hold as a whole
    whole = tsplan.load_mission(ENVIRONMENTS / "farm_overbooked.yaml")
    _, (text,) = written(whole, tmp_path)
    soft = replace(whole, objective=("satisfaction",), satisfaction="weighted")
    assert soft.partial
    with pytest.raises(CertificateError, match="met as far as possible"):
        verified(soft, text.replace(whole.digest, soft.digest))


def test_levels_are_whole_numbers(tmp_path):
    mission = random_mission(45)
    _, texts = written(mission, tmp_path)
    (level,) = (text for text in texts if "% kept makespan" in text and "RTP infeas" in text)
    assert verified(mission, level).bound is not None
    forged = re.sub(r"% kept makespan (\d+)\.0", r"% kept makespan \1.5", level)
    with pytest.raises(CertificateError, match="is a whole number"):
        verified(mission, forged)


def test_conflicts_can_be_certified():
    mission = tsplan.load_mission(ENVIRONMENTS / "office_double.yaml")
    made = tsplan.explain(mission, certified=True)
    assert "certified conflict: " in str(made)
    assert json.loads(made.to_json())["conflicts"][0]["certified"] is True


@pytest.mark.parametrize("seed", sampled(range(20), CUT))
def test_cuts_are_told_from_the_mission(seed, tmp_path):
    mission = many_tasks(seed, tasks=5)
    _, texts = written(mission, tmp_path)
    kinds = set()
    for text in texts:
        proven = checked(text)
        made = StageModel.of(mission, Head.read(proven.comments))
        cuts = CutRows(made.encoded)
        for row in proven.rows:
            kind = row.name.rstrip("gl").rstrip("0123456789")
            if kind not in KINDS:
                continue
            kinds.add(kind)
            assert cuts.true(kind, row)
            # one agent more than that is too much, and so are fewer that may come
            assert not cuts.true(kind, row._replace(side=row.side + 1))
            coming = next(column for column, factor in row.terms.items() if factor == 1)
            fewer = {column: f for column, f in row.terms.items() if column != coming}
            assert not cuts.true(kind, row._replace(terms=fewer))
            other = "visitors" if kind == "arrival" else "arrival"
            assert not cuts.true(other, row)
    assert kinds == set(KINDS) or seed not in CUT


def test_a_bound_that_is_not_reached_is_verified_too(tmp_path):
    mission = many_tasks(CUT[0], tasks=5)
    plan, (text,) = written(mission, tmp_path)
    proof = verified(mission, text)
    worse = replace(plan.objective[0], value=plan.value("travel") + 1)
    told = joined(mission, replace(plan, objective=(worse,)), [proof])
    assert not told.proven
    assert told.lines == ("travel 29: no plan has travel below 28 (certified)",)
    # without the tree's last end nothing is proven
    lines = text.splitlines()
    cut = [line for line in lines if not line.startswith("d0 ")]
    with pytest.raises(CertificateError):
        verified(mission, "\n".join(cut))
