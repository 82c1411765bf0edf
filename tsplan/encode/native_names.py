"""Names for the columns and rows of a model, for whoever looks at it in the solver's own object.

`n[barn,3,cart]` is how many carts wait at the barn from step 3 on, `x[barn,field,3,cart]` how many
enter the edge to the field then. Nothing is ever read back from a name.
"""

from __future__ import annotations

import re
from collections import Counter
from collections.abc import Iterable, Iterator, Mapping
from typing import TYPE_CHECKING

from tsplan.encode.own_constraints import PART
from tsplan.encode.read_back import node_names

if TYPE_CHECKING:
    from tsplan.encode.agent_classes import AgentClass
    from tsplan.encode.encoded import Encoded, Setting
    from tsplan.encode.quantities import OwnVariable
    from tsplan.milp.model import Model

_UNWRITABLE = re.compile(r"[^\w.!#$%&()/;?@_'`{}|~>\[\],-]")  # in the files that solvers write
_LONGEST = 200  # letters; solvers take 255


def column_names(encoded: Encoded) -> list[str]:
    """A name for every column; those that stand for no agents on an edge are numbered: `y[7]`.

    Own variables have their names; their columns say by how much they are above their least value.
    Of a reduced map an edge may be a whole way. Where two columns would have one name, as those of
    two such ways, all but the first have their numbers behind it.
    """
    names = [f"y[{number}]" for number in range(encoded.model.size.columns)]
    variables: Mapping[OwnVariable, int] = encoded.own_columns.get(PART, {})
    for variable, number in variables.items():
        names[number] = variable.name
    setting = encoded.setting
    for item, columns in zip(setting.classes, encoded.network.classes, strict=True):
        who, places = _who(setting, item), node_names(setting, item)
        edges, steps, numbers = columns.unrolled()
        tails, heads = columns.graph.tail[edges].tolist(), columns.graph.head[edges].tolist()
        for tail, head, step, number in zip(
            tails, heads, steps.tolist(), numbers.tolist(), strict=True
        ):
            where = places[tail] if tail == head else f"{places[tail]},{places[head]}"
            names[number] = f"{'n' if tail == head else 'x'}[{where},{step},{who}]"
    return list(_distinct(names))


def row_names(model: Model) -> list[str]:
    """A name for every row: what it is for, the step where it is for one, and a number.

    The rows of an own constraint have the name that it was added by.
    """
    names = [f"row[{number}]" for number in range(model.size.rows)]
    for tag in model.tags:
        kind = tag.kind if tag.step is None else f"{tag.kind}[{tag.step}]"
        for number in range(tag.start, tag.stop):
            names[number] = kind if tag.stop == tag.start + 1 else f"{kind}.{number - tag.start}"
    return list(_distinct(names))


def _who(setting: Setting, item: AgentClass) -> str:
    """The classes of the team whose agents these are."""
    team = setting.mission.team
    names = dict.fromkeys(team[group].class_name for group in item.groups)
    shape = () if item.shape is None else (item.shape,)
    return "+".join((*names, *shape))


def _distinct(names: Iterable[str]) -> Iterator[str]:
    """The names as files can have them, each once."""
    written = [_UNWRITABLE.sub("_", name)[:_LONGEST] for name in names]
    times, taken = Counter(written), set(written)
    seen: set[str] = set()
    for number, name in enumerate(written):
        told = name
        if times[name] > 1 and name in seen:
            told = f"{name}#{number}"
            while told in taken:  # a state may be called so
                told += "#"
            taken.add(told)
        seen.add(name)
        yield told
