"""Reading counts of agents (MTL), and tasks and limits (CaTL)."""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from dataclasses import dataclass, replace
from fractions import Fraction
from typing import Any, TypeAlias, cast

from tsplan.limits import LARGEST
from tsplan.logic.atoms import (
    MIRRORED,
    Count,
    Function,
    Known,
    Limit,
    Percent,
    Relation,
    Task,
    at_least,
)
from tsplan.logic.parser.numerals import exact, whole
from tsplan.logic.parser.reading import reach
from tsplan.logic.parser.tree_reader import Reader
from tsplan.logic.text_spans import Span, Way, Written

Pairs: TypeAlias = "list[tuple[str, Number, Any]]"

SPELLED: dict[str, Relation] = {
    "GE": ">=",
    "LE": "<=",
    "GT": ">",
    "LT": "<",
    "EQ": "=",
    "NE": "!=",
}
"""Relations by the name of their token."""


LABEL: Way = ("label",)


def relation_of(part: Any) -> Relation:
    """The relation of a part of the tree that is one."""
    return SPELLED[part.parser.symbolicNames[part.start.type]]


@dataclass(frozen=True, slots=True)
class Number:
    """A number as written: None if it is out of all range."""

    text: str
    value: Fraction | None
    percent: bool
    span: Span


@dataclass(frozen=True, slots=True)
class Measure:
    """A count that may still be compared with a number; `bare` if only the label was written."""

    function: Function
    label: str
    capability: str | None
    parts: Mapping[Way, Span]
    bare: bool = False


class CountReader(Reader):
    """Reads MTL and CaTL, which share all rules but two."""

    quantities = (Number,)

    def formula(self, value: Any, part: Any) -> Written | None:
        """A formula as it is; a bare label asks for one agent."""
        if isinstance(value, Measure):
            if value.bare:
                return Written(at_least(value.label), value.parts[LABEL], parts=value.parts)
            text = self.quote(part, part)
            self.complain(part, f"'{text}' is a number of agents", f"compare it: {text} >= 1")
            return None
        if isinstance(value, Number):
            remedy = "compare a count with it, such as sum(A) >= 2, or write true or false"
            self.complain(part, f"'{value.text}' is a number, not a formula", remedy)
            return None
        return cast("Written | None", value)

    def read_comparison(self, part: Any) -> Any:
        """Read a count compared with a number, in either order, or a lone operand."""
        operands, relations = part.operand(), part.relation()
        values = [self.read(operand) for operand in operands]
        if not relations:
            return values[0]
        if len(relations) > 1:
            remedy = "compare twice and join with &&: sum(A) >= 1 && sum(A) <= 3"
            self.complain(relations[1], "a count is compared with one number at a time", remedy)
            return None
        if None in values:
            return None
        left, right = values
        relation = relation_of(relations[0])
        if isinstance(left, Number) and isinstance(right, Measure):
            left, right, relation = right, left, MIRRORED[relation]
        if not (isinstance(left, Measure) and isinstance(right, Number)):
            remedy = "write a count on one side and a number on the other, such as sum(A) >= 2"
            self.complain(relations[0], "only counts and numbers can be compared", remedy)
            return None
        bound = self._bound(right, operands[values.index(right)])
        if bound is None:
            return None
        count = Count(left.function, left.label, left.capability, relation, bound)
        return Written(count, reach(part), parts={**left.parts, ("bound",): right.span})

    def read_number(self, part: Any) -> Number:
        """Read a number with its sign and percent sign."""
        text = "".join(part.getText().split())
        return Number(text, exact(text.rstrip("%")), text.endswith("%"), reach(part))

    def read_atom(self, part: Any) -> Any:
        """Read a count, what is known, a task, a limit or a label."""
        if not part.name():
            return self.read(part.children[0])
        label = self.read(part.name())
        return (
            None if label is None else Measure("sum", label, None, {LABEL: reach(part)}, bare=True)
        )

    def read_count(self, part: Any) -> Measure | None:
        """Read sum, min or max over the states with a label."""
        names = [self.read(name) for name in part.name()]
        if None in names:
            return None
        parts = dict(zip((LABEL, ("capability",)), map(reach, part.name()), strict=False))
        capability = names[1] if len(names) > 1 else None
        return Measure(cast("Function", part.start.text), names[0], capability, parts)

    def read_known(self, part: Any) -> Written | None:
        """Read the margin by which something is known to hold or to fail."""
        number = self.read(part.number())
        if number is None:
            return None
        margin = None if number.percent else whole(number.value)
        if margin is None:
            remedy = "write by how many agents it holds, or with a minus how many are missing"
            self.complain(part.number(), f"{number.text} is not a whole number of agents", remedy)
            return None
        return Written(Known(margin), reach(part), parts={("margin",): reach(part.number())})

    def read_task(self, part: Any) -> Written | None:
        """Read a duration, a label, what is needed and, if written, what is spent."""
        duration = self._natural(self.read(part.number()), part.number(), "a duration")
        label = self.read(part.name())
        needs, *spent = (self.read(pairs) for pairs in part.pairs())
        numbers = self._needs(needs)
        amounts = self._amounts(spent[0]) if spent else ()
        if duration is None or label is None or numbers is None or amounts is None:
            return None
        if not numbers and not amounts:
            remedy = "name at least one (capability, number)"
            self.complain(part.pairs(0), "the task asks for nothing", remedy)
            return None
        made = Task(duration, label, numbers, amounts)
        parts = {("duration",): reach(part.number()), LABEL: reach(part.name())}
        for name, pairs in zip(("needs", "resources"), part.pairs(), strict=False):
            parts |= _pair_spans(name, pairs, amounts if name == "resources" else numbers)
        return Written(made, reach(part), parts=parts)

    def read_begun(self, part: Any) -> Written | None:
        """Read a task and how many steps ago it has begun."""
        task = self.read(part.task())
        steps = self._natural(self.read(part.number()), part.number(), "a number of steps")
        if task is None or steps is None:
            return None
        if not 0 < steps <= task.formula.duration:
            what = f"a task of {task.formula.duration} steps has not begun {steps} steps ago"
            self.complain(part.number(), what, "write a step after the first one of the task")
            return None
        made = replace(task.formula, begun=steps)
        parts = {**task.parts, ("begun",): reach(part.number())}
        return Written(made, reach(part), parts=parts)

    def read_limit(self, part: Any) -> Written | None:
        """Read a label and the most agents that may be at each of its states."""
        label, needs = self.read(part.name()), self._needs(self.read(part.pairs()))
        if label is None or needs is None:
            return None
        parts = {LABEL: reach(part.name()), **_pair_spans("needs", part.pairs(), needs)}
        return Written(Limit(label, needs), reach(part), parts=parts)

    def read_pairs(self, part: Any) -> Pairs | None:
        """Read (name, number) pairs."""
        pairs = [self.read(pair) for pair in part.pair()]
        return None if None in pairs else pairs

    def read_pair(self, part: Any) -> tuple[str, Number, Any] | None:
        """Read one name with its number."""
        name, number = self.read(part.name()), self.read(part.number())
        return None if name is None or number is None else (name, number, part.number())

    def _bound(self, number: Number, part: Any) -> int | Percent | None:
        """What a count is compared with."""
        if number.percent:
            try:
                return Percent(number.value if number.value is not None else Fraction(-1))
            except ValueError:
                remedy = "write a share of all agents, such as 30%"
                self.complain(part, f"{number.text} is not between 0% and 100%", remedy)
                return None
        bound = whole(number.value)
        if bound is None:
            remedy = "agents are counted in whole numbers of at most 15 digits"
            self.complain(part, f"{number.text} is not a number of agents", remedy)
        return bound

    def _natural(self, number: Number | None, part: Any, what: str) -> int | None:
        """A whole number from 0."""
        if number is None:
            return None
        value = whole(number.value)
        if value is None or value < 0 or number.percent:
            remedy = f"write {what} as a whole number from 0"
            self.complain(part, f"{number.text} is not {what}", remedy)
            return None
        return value

    def _needs(self, pairs: Pairs | None) -> tuple[tuple[str, int], ...] | None:
        """Numbers of agents; no capability twice."""
        if pairs is None:
            return None
        read: list[tuple[str, int | None]] = []
        for name, number, at in pairs:
            many = self._natural(number, at, "a number of agents")
            if any(name == other for other, _ in read):
                remedy = "write each name once, with the number that is meant"
                self.complain(at.parentCtx, f"'{name}' is named twice", remedy)
                many = None
            read.append((name, many))
        sure = tuple((name, number) for name, number in read if number is not None)
        return sure if len(sure) == len(read) else None

    def _amounts(self, pairs: Pairs | None) -> tuple[tuple[str, float], ...] | None:
        """Amounts of resources, which need not be whole; those of one name add up in the task."""
        if pairs is None:
            return None
        amounts = []
        for name, number, at in pairs:
            small = number.value is not None and 0 <= number.value <= LARGEST
            if number.value is None or not small or number.percent:
                remedy = f"write how much is spent as a number from 0 to {LARGEST:,}"
                self.complain(at, f"{number.text} is not an amount", remedy)
            else:
                amounts.append((name, float(number.value)))
        return tuple(amounts) if len(amounts) == len(pairs) else None


def _pair_spans(kind: str, pairs: Any, read: Iterable[tuple[str, float]]) -> dict[Way, Span]:
    """Where the pairs of a task or limit stand, and the name and number of each.

    Of pairs that add up it is where the name is written first.
    """
    spans: dict[Way, Span] = {}
    numbers: dict[str, int] = {}
    for (name, _), pair in zip(read, pairs.pair(), strict=True):
        if name in numbers:
            continue
        number = numbers[name] = len(numbers)
        for way, part in (((), pair), ((0,), pair.name()), ((1,), pair.number())):
            spans[kind, number, *way] = reach(part)
    return spans
