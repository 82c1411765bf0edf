"""`tsplan robustness`: by how much a formula holds on signals that were recorded."""

from __future__ import annotations

import json
from typing import TYPE_CHECKING

from tsplan.cli.arguments import Exit
from tsplan.cli.formula_inputs import formula_of, trace_of
from tsplan.cli.output import say, say_json
from tsplan.errors import Finding, InputError
from tsplan.exact import digits
from tsplan.logic.evaluation import robustness
from tsplan.words import known

if TYPE_CHECKING:
    import argparse


def run(options: argparse.Namespace) -> Exit:
    """Print the robustness at the first step, or at every step that can be judged."""
    findings: list[Finding] = []
    try:
        formula = formula_of(options)
    except InputError as error:
        findings += error.findings
    try:
        trace = trace_of(options.trace)
    except InputError as error:
        findings += error.findings
    if findings:
        raise InputError(findings)
    try:
        found = robustness(formula, trace, options.kind, dict(options.bounds)).tolist()
    except InputError:
        raise
    except ValueError as error:  # the trace does not fit the formula
        raise InputError([Finding(str(error), "", str(options.trace))]) from None
    if options.json:
        values = [known(value) for value in found]
        told = {"formula": str(formula), "kind": options.kind}
        answer = {**told, "robustness": values if options.all else values[0]}
        say_json(json.dumps(answer, ensure_ascii=False) + "\n")
    elif options.all:
        for step, value in enumerate(found):
            say(f"{step} {digits(value)}")
    else:
        say(digits(found[0]))
    return Exit.DONE
