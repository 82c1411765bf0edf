"""Maps with anything changed in them: refused in words and with places, or read."""

from __future__ import annotations

import json
import random

import pytest
import yaml

from tests import foreign_maps
from tests.foreign_maps import MAPS
from tests.seeds import seed_blocks
from tsplan import MapError
from tsplan.document import parse_document
from tsplan.ts.io.map_files import load_map
from tsplan.ts.io.map_settings import MapSettings
from tsplan.ts.io.tsplan_yaml import map_to_yaml, read_own

FILES = foreign_maps.FILES
OTHERS = [None, True, -1, 0, 1e30, 0.5, "x", "", [], {}, [1], {"id": 1}, "1", [[1, 2]]]


def changed(value, draw):
    """The same data with one value that is another, or none."""
    if isinstance(value, dict | list) and value and draw.random() < 0.9:
        key = draw.choice(list(value) if isinstance(value, dict) else range(len(value)))
        made = value.copy()
        if draw.random() < 0.1:
            del made[key]
        else:
            made[key] = changed(value[key], draw)
        return made
    return draw.choice(OTHERS)


@pytest.mark.parametrize("seeds", seed_blocks(range(20), range(2000), 20))
@pytest.mark.parametrize("name", MAPS)
def test_whatever_is_wrong_with_a_map_is_refused_in_words(folder, name, seeds):
    text = MAPS[name]
    plain = not text.startswith(("type", "<"))
    data = yaml.safe_load(text.replace("\t", " ")) if plain else None
    for seed in seeds:
        draw = random.Random(seed)
        made = json.dumps(changed(data, draw)) if plain else ""
        if not plain:
            at = draw.randrange(len(text))
            made = text[:at] + draw.choice(["", "<", "@", "9", "\n", '"']) + text[at + 1 :]
        (folder / "broken").write_text(made)
        try:
            system = load_map(folder / "broken", MapSettings(capacity=draw.choice([None, 1])))
        except MapError as error:
            said = error.findings
        else:
            said = ()
            assert read_own(parse_document(map_to_yaml(system), "own")) == system
        assert all(finding.source and finding.message for finding in said), (seed, said)
