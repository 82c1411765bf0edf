"""How data is shown: the functions of higher rooms that draw, explain or simulate what lies below.

Maps, missions, formulas and plans say `plot`, `view` or how a notebook shows them, but know nothing
of pictures and pages: they ask this module, which finds the function when it is first used. It is
the only place below those rooms that names them.
"""

from __future__ import annotations

from html import escape
from typing import TYPE_CHECKING, Any

from tsplan.lazy_names import lazily
from tsplan.words import visible

if TYPE_CHECKING:
    from tsplan.checking.plan_check import objective_values
    from tsplan.draw.canvas import Picture
    from tsplan.draw.map import draw_map
    from tsplan.draw.starts import draw_mission
    from tsplan.draw.trajectory_views import draw_trajectory
    from tsplan.draw.views import draw_plan
    from tsplan.explanation.report import explanation_words
    from tsplan.explanation.why.requirements import Requirement, requirements
    from tsplan.explanation.why.trajectory_reasons import explain_trajectory
    from tsplan.explanation.why.witness_tree import WitnessNode, explain
    from tsplan.plans.summary import plan_words
    from tsplan.protocol.disturbances import DisturbedRuns, simulate_disturbed
    from tsplan.protocol.simulation import Simulation, simulate
    from tsplan.signals.trajectory_summary import trajectory_words
    from tsplan.viewer.browser import show_page
    from tsplan.viewer.movie import Movie, movie
    from tsplan.viewer.notebook import formula_svg, map_svg, plan_html
    from tsplan.viewer.trajectory_form import trajectory_html

_LINES = "\n"  # what separates lines is not shown as a character
_FORMS = {"image/svg+xml": "_repr_svg_", "text/html": "_repr_html_"}

__all__ = [
    "Displayed",
    "DisturbedRuns",
    "Movie",
    "Picture",
    "Requirement",
    "Simulation",
    "Told",
    "WitnessNode",
    "draw_map",
    "draw_mission",
    "draw_plan",
    "draw_trajectory",
    "explain",
    "explain_trajectory",
    "explanation_words",
    "formula_svg",
    "map_svg",
    "movie",
    "objective_values",
    "plan_html",
    "plan_words",
    "requirements",
    "show_page",
    "simulate",
    "simulate_disturbed",
    "trajectory_html",
    "trajectory_words",
]


class Displayed:
    """What a notebook shows: a class has `_repr_svg_` or `_repr_html_`, and words beside it."""

    __slots__ = ()

    def _caption(self) -> str:
        """The words that stand for it where nothing can be drawn."""
        return repr(self)

    def _repr_mimebundle_(self, **_choice: Any) -> dict[str, str]:
        """Every form that a notebook may ask for."""
        forms = {kind: getattr(self, name, None) for kind, name in _FORMS.items()}
        drawn = {kind: form() for kind, form in forms.items() if form is not None}
        return {"text/plain": self._caption(), **drawn}


class Told(Displayed):
    """What is told in words, which are its `str`: a notebook shows them line by line."""

    __slots__ = ()

    def _caption(self) -> str:
        return str(self)

    def _repr_html_(self) -> str:
        """The words, as they stand."""
        return f"<pre>{escape(visible(str(self), _LINES))}</pre>"


__getattr__, __dir__ = lazily(
    __name__,
    {
        "checking.plan_check": ("objective_values",),
        "draw.map": ("draw_map",),
        "draw.starts": ("draw_mission",),
        "viewer.notebook": ("formula_svg", "map_svg", "plan_html"),
        "viewer.trajectory_form": ("trajectory_html",),
        "viewer.movie": ("Movie", "movie"),
        "draw.views": ("draw_plan",),
        "draw.trajectory_views": ("draw_trajectory",),
        "explanation.why.trajectory_reasons": ("explain_trajectory",),
        "explanation.report": ("explanation_words",),
        "explanation.why.requirements": ("requirements",),
        "explanation.why.witness_tree": ("explain",),
        "plans.summary": ("plan_words",),
        "signals.trajectory_summary": ("trajectory_words",),
        "protocol.simulation": ("simulate",),
        "protocol.disturbances": ("DisturbedRuns", "simulate_disturbed"),
        "viewer.browser": ("show_page",),
    },
)
