"""Forged and broken missions over signals: findings with places, or an answer that is right."""

from __future__ import annotations

import copy
import random
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import pytest
import yaml

import tsplan
from tests.command_line import MISTAKES, here
from tests.seeds import seed_blocks
from tsplan.errors import MissionError
from tsplan.signals.signal_files import signal_mission_from_text

FOLDER = Path(__file__).parents[1] / "environments" / "signals"
TEXTS = {path.stem: path.read_text(encoding="utf-8") for path in sorted(FOLDER.glob("*.yaml"))}
SMALL = ("linear", "reach_avoid", "too_late", "trajectory", "weights", "weights_always", "wishes")
MARKS = "[]{}:,-!&|^*\"'#%@0123456789.e<>=() \n\t"
ODD: tuple[Any, ...] = (
    *(None, -1, 0, 1, 0.5, True, "x", "", [], {}, float("nan"), float("inf"), 1e30, -1e300),
    *(10**400, [1, 2], [2, 1], {"a": 1}, "F[0,3] x >= 1", "in(goal)", "\u00e9", "~", "["),
    *(["x"], [[1]], {"min": 0}, 1e-300, 10**6, "robustness", [None]),
)
LONGEST = 60  # steps of what is planned here


def places(data: Any, path: tuple[Any, ...] = ()) -> Iterator[tuple[Any, ...]]:
    """The paths of all parts of a document."""
    keys = data if isinstance(data, dict) else range(len(data)) if isinstance(data, list) else ()
    for key in keys:
        yield (*path, key)
        yield from places(data[key], (*path, key))


def scratched(text: str, chance: random.Random) -> str:
    """A text with characters deleted or added, or without some line."""
    for _ in range(chance.randint(1, 3)):
        at, draw = chance.randrange(len(text)), chance.random()
        if draw < 0.5:
            text = text[:at] + text[at + chance.choice((1, 1, chance.randint(1, 12))) :]
        elif draw < 0.8:
            text = text[:at] + chance.choice(MARKS) + text[at:]
        else:
            lines = text.splitlines()
            del lines[chance.randrange(len(lines))]
            text = "\n".join(lines)
    return text


def change(around: Any, key: Any, chance: random.Random) -> None:
    """Delete one part, or give it another value or name."""
    value, draw = around[key], chance.random()
    if draw < 0.2:
        del around[key]
    elif draw < 0.45:
        around[key] = copy.deepcopy(chance.choice(ODD))
    elif draw < 0.6 and isinstance(around, dict):
        around[chance.choice(("q", "x", "format", "y_z"))] = around.pop(key)
    elif isinstance(value, int | float):
        around[key] = value * chance.choice((-1, 0, 10, 1e3, 1e-3, 1e9, 1e-9))
    elif isinstance(value, str):
        at = chance.randrange(len(value) + 1)
        new = chance.choice(("", "x", "9", "(", ")", "&&", "^", "in", "!"))
        around[key] = value[:at] + new + value[at + chance.randint(0, 2) :]


def forged(seed: int, names: tuple[str, ...] = (*TEXTS,)) -> str:
    """A shipped mission that is no longer what it was."""
    chance = random.Random(seed)
    text = TEXTS[chance.choice(names)]
    if chance.random() < 0.35:
        return scratched(text, chance)
    data = yaml.safe_load(text)
    for _ in range(chance.randint(1, 2)):
        *way, key = chance.choice([*places(data)])
        around = data
        for step in way:
            around = around[step]
        change(around, key, chance)
    return yaml.safe_dump(data, sort_keys=False, allow_unicode=True)


@pytest.mark.parametrize("seeds", seed_blocks(range(30), range(5000), 100))
def test_each_is_refused_with_places_or_means_what_is_written_again(seeds: list[int]) -> None:
    refused, told = 0, []
    for seed in seeds:
        try:
            mission = signal_mission_from_text(forged(seed))
        except MissionError as error:
            refused += 1
            told += [(seed, item) for item in error.findings if not (item.line and item.remedy)]
        else:
            assert signal_mission_from_text(mission.to_yaml()) == mission, seed
    assert told == []
    assert 0 < refused < len(seeds)


@pytest.mark.parametrize("seeds", seed_blocks(range(3), range(1500), 30))
def test_the_command_refuses_or_answers(seeds: list[int], tmp_path: Path) -> None:
    codes = set()
    for seed in seeds:
        text = forged(seed, SMALL)
        (tmp_path / "mission.yaml").write_text(text, encoding="utf-8", newline="")
        try:
            if signal_mission_from_text(text).horizon > LONGEST:
                continue
        except MissionError:
            pass
        arguments = ("plan", "mission.yaml", "-o", "found.json", "--quiet", "--time-limit", "5")
        code, out, err = here(*arguments, folder=tmp_path)
        assert not any(word in err for word in MISTAKES), (seed, err)
        assert code in (0, 2, 3, 4), (seed, err)
        assert (code == 2) == ("mission.yaml" in err), (seed, err)
        if code == 0:
            mission = tsplan.load_signal_mission(tmp_path / "mission.yaml")
            found = tsplan.load_trajectory(tmp_path / "found.json")
            assert tsplan.check(mission, found).ok, seed
        assert out == ""
        codes.add(code)
    assert codes >= {0, 2}
