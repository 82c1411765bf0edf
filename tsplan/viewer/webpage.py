"""The viewer as one file: the page, its style, its script and the plan's data, all inside it.

Whatever names a mission uses, they are data: they stand in a block that no browser runs, with
every character escaped that could end it, and the script only ever sets them as text. A content
security policy names the page's own style and script by their digests, so that nothing else runs
and nothing is loaded.
"""

from __future__ import annotations

import json
import re
from base64 import b64encode
from collections.abc import Mapping
from functools import cache
from hashlib import sha256
from importlib.resources import files
from typing import Any, cast

from tsplan.errors import Finding, InputError
from tsplan.mission import Mission
from tsplan.plans.plan import Plan
from tsplan.signals.signal_mission import SignalMission
from tsplan.signals.trajectory import Trajectory
from tsplan.viewer.page_data import page_data
from tsplan.viewer.signal_page import signal_page_data
from tsplan.words import visible

_SCRIPTS = (
    "paint model player camera map markers supplies mapview fold timeline formula chart agents "
    "signals beside link picture main"
)
_SLOT = re.compile(r"\{\{(\w+)\}\}")
_UNSAFE = {ord(mark): f"\\u{ord(mark):04x}" for mark in "<>&\u2028\u2029"}


def page(
    mission: Mission | SignalMission, result: Plan | Trajectory, executed: Plan | None = None
) -> str:
    """The whole page of a plan or a trajectory as HTML text.

    Where it is known what really happened, as another plan, both are there side by side. Raises
    PlanError for one without paths or signals, or that does not fit its mission, and InputError for
    an executed plan beside a trajectory.
    """
    if isinstance(result, Trajectory):
        if executed is not None:
            what = "what happened is told by a plan, and beside it is a trajectory"
            raise InputError([Finding(what, "leave it out, or give the plan")])
        data = signal_page_data(cast("SignalMission", mission), result)
    else:
        data = page_data(cast("Mission", mission), result, executed)
    style, script = _source("viewer.css"), _program()
    parts = {
        "policy": _policy(style, script),
        "style": style,
        "script": script,
        "data": embedded(seen(data)),
    }
    # in one pass, so that nothing in a part is taken for a slot
    return _SLOT.sub(lambda match: parts[match[1]], _source("page.html"))


def seen(data: Any) -> Any:
    r"""The data with every text as a person can see it: control characters as their escapes.

    >>> print(seen({"name": ["a\x1b", 3]}))
    {'name': ['a\\x1b', 3]}
    """
    if isinstance(data, str):
        return visible(data)
    if isinstance(data, dict):
        return {key: seen(value) for key, value in data.items()}
    return [seen(item) for item in data] if isinstance(data, list | tuple) else data


def embedded(data: Mapping[str, object]) -> str:
    r"""JSON that can stand inside a script element: no character of it can end the element.

    >>> embedded({"name": "</script>"})
    '{"name":"\\u003c/script\\u003e"}'
    """
    text = json.dumps(data, ensure_ascii=False, allow_nan=False, separators=(",", ":"))
    return text.translate(_UNSAFE)


@cache
def _source(name: str) -> str:
    return (files("tsplan.viewer") / "web" / name).read_text(encoding="utf-8")


@cache
def _program() -> str:
    """The modules one after the other, in a scope of their own."""
    modules = "\n".join(_source(f"{name}.js") for name in _SCRIPTS.split())
    return f'(() => {{\n"use strict";\n{modules}\n}})();'


def _policy(style: str, script: str) -> str:
    """Nothing but this style and this script; pictures only from the page itself."""
    return (
        f"default-src 'none'; script-src '{_digest(script)}'; style-src '{_digest(style)}'; "
        "img-src data:; base-uri 'none'; form-action 'none'"
    )


def _digest(text: str) -> str:
    return f"sha256-{b64encode(sha256(text.encode()).digest()).decode()}"
