"""A first plan of missions that ask for something again and again (F under G).

Sharing its witnesses between the windows keeps such a model exact, but its LP says little: a bit
of a witness at every step covers all windows. The *chained* restriction asks for as few witnesses
as can cover the windows, one choice each (see `encode.witness`). It leaves plans out, so it proves
nothing; but its choices can be dived through in the order of time, and without arrival cuts its LPs
are small.
"""

from __future__ import annotations

from dataclasses import replace

from tsplan.clock import Clock
from tsplan.encode.assemble import tight
from tsplan.encode.encoded import Encoded, Setting
from tsplan.encode.switches import Switch
from tsplan.milp.model import Floats
from tsplan.milp.target import Target
from tsplan.search.dive import Earliest
from tsplan.search.effort import Effort
from tsplan.search.search import Search

_CUTS = frozenset({Switch.VISITS, Switch.LAZY, Switch.VISITORS, Switch.TOGETHER})


def chain_model(setting: Setting, level: int) -> Encoded:
    """The chained model at availability `level`, with the flow columns of the exact model."""
    return tight(replace(setting, switches=setting.switches - _CUTS), level, chain=True)


def first_flows(restricted: Encoded, target: Target, effort: Effort, clock: Clock) -> Floats | None:
    """Flows of a point of the chained model, in whole agents; None if none was found."""
    search = Search(restricted, target, effort, clock, _unheard)
    values = search.dive_for(Earliest(restricted.indicators, restricted.steps, restricted.choices))
    return None if values is None else values[restricted.flows]


def _unheard(*_: object) -> None:
    """Reports of a search on a restriction are nobody's business: its bounds are not true ones."""
