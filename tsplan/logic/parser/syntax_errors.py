"""What the parser finds wrong, said in plain words."""

from __future__ import annotations

from collections.abc import Mapping
from types import MappingProxyType
from typing import Any

from antlr4 import Token
from antlr4.error.ErrorListener import ErrorListener

from tsplan.errors import Finding
from tsplan.logic.parser.source import Source

FORMS: Mapping[str, str] = MappingProxyType(
    {
        "interval": "write an interval as [a,b] in whole steps, such as [0,5]",
        "bound": "write an interval as [a,b] in whole steps, such as [0,5]",
        "count": "write a count as sum(label) or sum(label,capability); also min and max",
        "task": "write a task as T(duration, label, {(capability, number), ...})",
        "limit": "write a limit as L(label, {(capability, number), ...})",
        "region": "write in(region), or in(robot, region) for one of several; also out and clear",
        "pairs": "write needs as {(capability, number), ...}",
        "pair": "write needs as {(capability, number), ...}",
        "weight": "write a weight as ^name, ^0.5 or ^[0.2, 0.8]",
        "value": "write a weight as ^name, ^0.5 or ^[0.2, 0.8]",
        "name": "write a name of letters, digits and _, or any text in quotes",
    }
)

WORDS: Mapping[str, str] = MappingProxyType(
    {
        "next": "X",
        "eventually": "F[a,b]",
        "finally": "F[a,b]",
        "always": "G[a,b]",
        "globally": "G[a,b]",
        "until": "U[a,b]",
        "release": "R[a,b]",
        "and": "&&",
        "or": "||",
        "implies": "=>",
        "iff": "<=>",
    }
)
"""Words that other tools use for operators."""

_PARTS = "join parts so: a && b, or &&^w (a, b)"
TEMPORAL = ("F", "G", "U", "R", "<>", "[]")


class Complaints(ErrorListener):  # type: ignore[misc]  # the ANTLR runtime has no types
    """Collects the findings of one stream; at most one for an interval, a count, a task, ...

    `strays` are offsets of characters that were left out: what the parser finds there is told.
    """

    def __init__(self, source: Source, parser: Any, strays: set[int]) -> None:
        self._source = source
        self._types = parser
        self._strays = strays
        self._told: set[int] = set()
        self._misplaced = False  # a weight, whose name or numbers are wrong there, too
        self.findings: list[Finding] = []

    def syntaxError(  # noqa: N802  (ANTLR calls it so)
        self,
        recognizer: Any,
        offendingSymbol: Any,  # noqa: N803  (ANTLR passes it by position)
        *_details: Any,
    ) -> None:
        """Turn one report of the parser into a finding."""
        token, context = offendingSymbol, recognizer._ctx  # noqa: SLF001  (no other way)
        if self._misplaced:
            return
        self._misplaced = token.text == "^"
        tokens = recognizer.getTokenStream().tokens
        before = tokens[token.tokenIndex - 1] if token.tokenIndex > 0 else None
        start = before.stop + 1 if before is not None else 0
        if self._strays.intersection(range(start, token.start)) or self._repeats(context):
            return
        rule = recognizer.ruleNames[context.getRuleIndex()]
        expected = recognizer.getExpectedTokens()
        ends = (self._types.AND, self._types.CLOSE, Token.EOF)
        joinable = token.type != Token.EOF and any(end in expected for end in ends)
        for at in (before, token):
            if at is not None and at.text.lower() in WORDS:
                message, remedy = f"'{at.text}' is no operator", f"write {WORDS[at.text.lower()]}"
                self.findings.append(self._source.finding(at.start, message, remedy))
                return
        if joinable and token.text == ")" and self.findings:
            return  # every ')' has its '(': what stands before was told
        message, remedy = _explained(token, before, rule, joinable=joinable)
        self.findings.append(self._source.finding(token.start, message, remedy))

    def _repeats(self, context: Any) -> bool:
        """Whether something was told already about the form that a part belongs to."""
        names, around = context.parser.ruleNames, None
        while context is not None and names[context.getRuleIndex()] in FORMS:
            around, context = context, context.parentCtx
        if around is None:
            return False
        told = around.start.start in self._told
        self._told.add(around.start.start)
        return told


def _explained(token: Any, before: Any, rule: str, *, joinable: bool) -> tuple[str, str]:
    """Message and remedy for a token that does not fit after the one before it."""
    shown = "the end" if token.type == Token.EOF and token.text != ")" else f"'{token.text}'"
    last = before.text if before is not None else ""
    slip = _slip(token.text, last, shown)
    if slip is not None:
        return slip
    if rule in FORMS or (rule == "parts" and not joinable):
        follows = f" after '{last}'" if last else ""
        return f"{shown} is unexpected{follows}", FORMS.get(rule, _PARTS)
    if last[:1].isdigit() and token.text.isidentifier():
        return f"'{token.text}' cannot follow the number {last}", "multiply with *, such as 2*x"
    if joinable and not (token.text == ")" and last in ("(", ",")):
        remedy = "join it with an operator such as && or ||, or remove it"
        return f"{shown} is left over after the formula", remedy
    return _missing(token, last, shown)


def _slip(text: str, last: str, shown: str) -> tuple[str, str] | None:
    """Message and remedy for slips that two neighbouring tokens give away."""
    if last in TEMPORAL and text != "[":
        remedy = f"write {last}[a,b] with whole numbers of steps, such as {last}[0,5]"
        return f"'{last}' needs an interval before {shown}", remedy
    if text == "^":
        remedy = (
            "weights follow && and ||, and the intervals of F, G, U and R: a &&^w b, F[0,5]^w a"
        )
        return f"a weight cannot stand after '{last}'" if last else "a weight stands alone", remedy
    if text == "[" and last.isidentifier():
        remedy = (
            "every temporal operator has its own interval and stands apart from names: "
            "G[0,9] F[0,3] a, a U[0,2] b"
        )
        return f"'[' cannot follow the name '{last}'", remedy
    if text == "(" and last.isidentifier():
        remedy = (
            "counts are sum, min and max; tasks T(...) and limits L(...) are CaTL; regions "
            "in(...), out(...) and clear(...) are STL"
        )
        return f"'(' cannot follow the name '{last}'", remedy
    return None


def _missing(token: Any, last: str, shown: str) -> tuple[str, str]:
    """Message and remedy where an operand should begin."""
    if token.text == ")" and last in ("", "("):
        return "there is nothing between the parentheses", "write a formula there or remove them"
    follows = f" after '{last}'" if last else ""
    return f"{shown} stands where a formula should begin{follows}", (
        "write what is missing there, or remove what is too much"
    )
