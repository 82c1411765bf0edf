"""`tsplan lint`: what looks odd in a map."""

from __future__ import annotations

from dataclasses import replace
from typing import TYPE_CHECKING

from tsplan.cli.arguments import Exit
from tsplan.cli.output import say
from tsplan.ts.io.map_files import load_map
from tsplan.ts.map_lint import lint

if TYPE_CHECKING:
    import argparse


def run(options: argparse.Namespace) -> Exit:
    """Print one line for everything that looks odd."""
    system = load_map(options.map)
    findings = lint(system)
    for finding in findings:
        placed = finding if finding.source else replace(finding, source=str(options.map))
        say(str(placed))
    if findings:
        return Exit.REFUSED
    say(f"{len(system.states)} states, {len(system.edges)} edges, nothing looks odd")
    return Exit.DONE
