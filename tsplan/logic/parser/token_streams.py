"""A text as streams of tokens, none of which nests deeply.

ANTLR's runtime and the readers recurse on nested parentheses. A part inside many parentheses
becomes a stream of its own and leaves one GROUP token behind. Streams come innermost first, so
that what a GROUP token stands for is known when the stream around it is parsed.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass, field
from typing import Any

from antlr4 import InputStream, Token
from antlr4.Token import CommonToken

from tsplan.errors import Finding
from tsplan.logic.parser.source import Source

DEPTH = 12
"""Nested groups that a stream holds at most; what is deeper is cut out."""

_LISTS = 2  # lists of arguments nest as in T(1,A,{(c,1)}); more of them is an error


@dataclass(eq=False)
class Stream:
    """Tokens to be parsed together, with an end token; `opener` is the '(' they were inside of.

    `depth` counts the groups around, `lists` the lists of arguments inside the innermost group.
    `balanced` is False where parentheses had to be added or dropped.
    """

    opener: Any
    depth: int = 0
    lists: int = 0
    tokens: list[Any] = field(default_factory=list)
    balanced: bool = True


class Streams:
    """Splits the tokens of one text; `findings` is complete after the last stream.

    Characters that belong to no token are left out; `strays` holds their offsets. Where the text
    has weights and its language has none, it is `misread`; the `weighted` language has them.
    """

    def __init__(self, source: Source, lexer: Any, parser: Any, weighted: str) -> None:
        self._source = source
        self._lexer = lexer
        self._types = parser
        self._weighted = weighted
        words = ("SUM", "MIN", "MAX", "KNOWN", "TASK", "BEGUN", "LIMIT", "IN", "OUT", "CLEAR")
        listing = (name for name in (*words, "LBRACE") if hasattr(parser, name))
        self._listing = {getattr(parser, name) for name in listing}
        self.findings: list[Finding] = []
        self.strays: set[int] = set()
        self.misread = False

    def __iter__(self) -> Iterator[Stream]:
        """Streams, innermost first; the last one is the whole text."""
        tokens = self._lexer(InputStream(self._source.text)).getAllTokens()
        stack, extra = [Stream(None)], []
        for token in tokens:
            if token.type == self._types.STRAY:
                self._note_stray(token)
            elif token.type == self._types.OPEN:
                stack.append(self._opened(stack[-1], token))
            elif token.type != self._types.CLOSE:
                stack[-1].tokens.append(token)
            elif len(stack) > 1:
                yield from self._closed(stack, token)
            else:
                extra.append(token)
                stack[-1].balanced = False
        yield from self._ended(stack, extra)

    def _opened(self, around: Stream, token: Any) -> Stream:
        last = around.tokens[-1].type if around.tokens else None
        listing = last in self._listing or (last == self._types.COMMA and around.lists > 0)
        if listing and around.lists < _LISTS:
            return Stream(token, around.depth, around.lists + 1)
        return Stream(token, around.depth + 1)

    def _closed(self, stack: list[Stream], token: Any) -> Iterator[Stream]:
        """End the innermost stream: as one of its own if it is deep, else inside the one around."""
        inner, outer = stack.pop(), stack[-1]
        if not inner.lists and inner.depth % DEPTH == 0:
            inner.tokens.append(_made(Token.EOF, token.start, token.stop, ")"))
            yield inner
            outer.tokens.append(_made(self._types.GROUP, inner.opener.start, token.stop, "(...)"))
        else:
            outer.tokens += (inner.opener, *inner.tokens, token)
            outer.balanced &= inner.balanced

    def _ended(self, stack: list[Stream], extra: list[Any]) -> Iterator[Stream]:
        end = len(self._source.text)
        self._report("(", [stream.opener for stream in stack[1:]])
        self._report(")", extra)
        while len(stack) > 1:
            stack[-1].balanced = False
            yield from self._closed(stack, _made(self._types.CLOSE, end, end - 1, ")"))
            stack[-1].balanced = False
        stack[0].tokens.append(_made(Token.EOF, end, end - 1, "<EOF>"))
        yield stack[0]

    def _report(self, mark: str, tokens: list[Any]) -> None:
        if not tokens:
            return
        opens = mark == "("
        message = f"this '{mark}' is never {'closed' if opens else 'opened'}"
        if len(tokens) > 1:
            message += f", and {len(tokens) - 1} more"
        remedy = f"add '{')' if opens else '('}' or remove it"
        self.findings.append(self._source.finding(tokens[0].start, message, remedy))

    def _note_stray(self, token: Any) -> None:
        known = token.start - 1 in self.strays
        self.strays.add(token.start)
        if known:
            return  # one finding for a run of them
        if token.text == "^":
            self.misread = True
            message = "'^' begins a weight, which only the weighted languages have"
            remedy = f"read the formula in the language {self._weighted}"
        elif token.text == '"':
            message, remedy = "this quote is never closed", "end the name with another quote"
        else:
            message = f"'{token.text}' has no meaning in a formula"
            remedy = 'names with other characters than letters, digits and _ go in quotes: "a b"'
        self.findings.append(self._source.finding(token.start, message, remedy))


def _made(kind: int, start: int, stop: int, text: str) -> Any:
    token = CommonToken(type=kind, start=start, stop=stop)
    token.text = text
    return token
