"""What a file is, told by its content: ours, or something else that is named for what it is."""

from __future__ import annotations

import re
from collections.abc import Mapping
from typing import Any

_SIGNATURES: tuple[tuple[bytes, str], ...] = (
    (b"\x89PNG\r\n", "a PNG picture"),
    (b"\xff\xd8\xff", "a JPEG picture"),
    (b"GIF8", "a GIF picture"),
    (b"BM", "a BMP picture"),
    (b"II*\x00", "a TIFF picture"),
    (b"MM\x00*", "a TIFF picture"),
    (b"RIFF", "a WebP picture or a sound"),
    (b"P4", "a PBM picture"),
    (b"P5", "a PGM picture, as of an occupancy grid"),
    (b"P6", "a PPM picture"),
    (b"%PDF", "a PDF document"),
    (b"PK\x03\x04", "a zip archive or an office document"),
    (b"\x1f\x8b", "a gzip archive"),
    (b"\x80", "a pickle of Python"),
)

# what may stand before the first element of XML; what is matched once is not tried in another way
_COMMENTS = r"(?><!--.*?-->\s*)*"
_PROLOGUE = r"(?><\?xml.*?\?>\s*)?" + _COMMENTS

_BEGINNINGS: tuple[tuple[re.Pattern[str], str], ...] = tuple(
    (re.compile(pattern, re.IGNORECASE | re.DOTALL), name)
    for pattern, name in (
        (rf"{_PROLOGUE}<graphml\b", "a graph in GraphML"),
        (rf"{_PROLOGUE}<gexf\b", "a graph in GEXF"),
        (rf"{_PROLOGUE}<osm\b", "a map of OpenStreetMap"),
        (rf"{_PROLOGUE}(?><!doctype[^>]*>\s*)?{_COMMENTS}<svg\b", "an SVG picture"),
        (r"<!doctype html|<html\b", "a page in HTML"),
        (r"<\?xml\b", "an XML document"),
        (r"type \w+\s+height \d+\s+width \d+\s+map\b", "a grid map of the MovingAI benchmarks"),
        (r"version [\d.]+\s+\d+\t", "a list of scenarios of the MovingAI benchmarks"),
        (r"(strict\s+)?(di)?graph\s*\w*\s*\{", "a graph in DOT"),
        (r"(creator [^\n]*\n\s*)?graph\s*\[", "a graph in GML"),
        (r"P[123]\s+(?>#[^\n]*\n\s*)*\d+\s+\d+", "a picture of the PNM family"),
    )
)

MISSION, MAP, PLAN, TRAJECTORY = "a mission", "a map", "a plan", "a trajectory"
SIGNALS = "a mission over signals"
SWEEP = "a sweep of missions"
WORLD = "what has happened to a plan"
_KINDS_OF_MISSIONS = ("team", "swarm", "swarms")
_MARKS = (
    ("tsplan-mission", MISSION),
    ("tsplan-signals", SIGNALS),
    ("tsplan-sweep", SWEEP),
    ("tsplan-world", WORLD),
    ("tsplan-plan", PLAN),
    ("tsplan-trajectory", TRAJECTORY),
)


def kind_of_bytes(raw: bytes) -> str | None:
    """What a file that is no text is, in words; None if nobody knows.

    >>> kind_of_bytes(bytes([0x89]) + b"PNG" + bytes([13, 10, 26, 10]))
    'a PNG picture'
    """
    return next((name for mark, name in _SIGNATURES if raw.startswith(mark)), None)


def kind_of_text(text: str) -> str | None:
    r"""What a text is that is neither YAML nor JSON, by how it begins; None if nobody knows.

    >>> kind_of_text("type octile\nheight 4\nwidth 5\nmap\n")
    'a grid map of the MovingAI benchmarks'
    """
    begins = text[:2000].lstrip()
    return next((name for pattern, name in _BEGINNINGS if pattern.match(begins)), None)


def kind_of_data(data: Any) -> str | None:
    """What a document holds, by its keys: `MISSION`, `SIGNALS`, `MAP`, `PLAN` or other words.

    None where the keys do not tell.

    >>> kind_of_data({"states": {}, "edges": []}), kind_of_data({"type": "FeatureCollection"})
    ('a map', 'geographic data (GeoJSON)')
    """
    if not isinstance(data, Mapping):
        return None
    own = str(data.get("format", ""))
    for mark, kind in _MARKS:
        if own.startswith(mark):
            return kind
    for keys, kind in _KEYS:
        if keys <= data.keys():
            return kind
    if "spec" in data or ("map" in data and any(kind in data for kind in _KINDS_OF_MISSIONS)):
        return MISSION
    if str(data.get("type")) in _GEOGRAPHIC:
        return "geographic data (GeoJSON)"
    return MAP if "states" in data or isinstance(data.get("graph"), Mapping) else None


def is_of_ours(kind: str) -> bool:
    """Whether a kind is one of the files of this project, maps included."""
    return kind in (MISSION, MAP, PLAN, TRAJECTORY, SIGNALS, SWEEP, WORLD)


def remedy_for(kind: str, wanted: str, source: str) -> str:
    """What to do with a document of one kind where another is wanted; none is a text of any."""
    name = source.replace(chr(92), "/").rpartition("/")[2]
    if kind in _FOREIGN_MAPS and wanted in ("", MISSION):
        return f"it can be the map of a mission: map: {{file: {name}}}"
    remedy = "write it as YAML" if not wanted else f"what is wanted is {wanted}, written in YAML"
    remedy = _REMEDIES.get((wanted, kind), remedy)
    return f"{remedy} (map: {name})" if (wanted, kind) == (MISSION, MAP) else remedy


_REMEDIES: Mapping[tuple[str, str], str] = {
    (MISSION, MAP): "plan needs a mission that names it",
    (MISSION, PLAN): "name the mission that was planned",
    (MAP, MISSION): "name the map that it uses, or write that map into a file of its own",
    (MAP, PLAN): "name the map of its mission",
    (MISSION, SIGNALS): "what is wanted has a team on a map instead of signals",
    (SIGNALS, MISSION): "what is wanted has signals instead of a team on a map",
    (SIGNALS, TRAJECTORY): "name the mission that it was made for",
    (MISSION, TRAJECTORY): "name the mission that it was made for",
    (MISSION, SWEEP): "run all its missions by 'tsplan sweep'",
    (SWEEP, MISSION): "name it as the 'mission' of a sweep, or give the folder that it is in",
    (SWEEP, SIGNALS): "name it as the 'mission' of a sweep, or give the folder that it is in",
}
_FOREIGN_MAPS = (
    "a graph in GraphML",
    "a grid map of the MovingAI benchmarks",
    "a graph in networkx's node-link JSON",
    "a transition system of another planner (state_models)",
    "a building of Open-RMF",
    "an occupancy grid of ROS",
    "a layout in the interchange format LIF",
    "geographic data (GeoJSON)",
)
"""Kinds that the map readers know."""

_GEOGRAPHIC = ("FeatureCollection", "Feature", "GeometryCollection", "Topology")
_KEYS: tuple[tuple[frozenset[str], str], ...] = (
    (frozenset({"status", "horizon", "objective"}), PLAN),
    (frozenset({"signals", "spec"}), SIGNALS),
    (frozenset({"mission", "axes"}), SWEEP),
    (frozenset({"mission", "runs"}), SWEEP),
    (frozenset({"nodes", "links"}), "a graph in networkx's node-link JSON"),
    (frozenset({"directed", "multigraph", "nodes"}), "a graph in networkx's node-link JSON"),
    (frozenset({"adjacency", "nodes"}), "a graph in networkx's adjacency JSON"),
    (frozenset({"state_models"}), "a transition system of another planner (state_models)"),
    (frozenset({"building_name", "levels"}), "a building of Open-RMF"),
    (frozenset({"image", "resolution", "origin"}), "an occupancy grid of ROS"),
    (frozenset({"metaInformation", "layouts"}), "a layout in the interchange format LIF"),
    (frozenset({"metaInformation", "origins"}), "a layout in the interchange format LIF"),
)
