"""A plan or a trajectory as something that moves: in a notebook, and in a file."""

from __future__ import annotations

from dataclasses import dataclass
from html import escape
from pathlib import Path
from typing import TYPE_CHECKING

from tsplan.display import Displayed
from tsplan.viewer.animation import Pace, animate
from tsplan.viewer.webpage import page

if TYPE_CHECKING:
    from tsplan.plans.plan import Plan
    from tsplan.signals.result_check import AnyMission
    from tsplan.signals.trajectory import Trajectory
    from tsplan.viewer.scene import Size

_ALLOWED = "allow-scripts allow-downloads"  # downloads: of the picture that the page saves
_HEIGHT = 640  # pixels of the page in a notebook


@dataclass(frozen=True, repr=False)
class Movie(Displayed):
    """A plan or a trajectory with its mission, which a notebook plays as its page."""

    mission: AnyMission
    result: Plan | Trajectory

    def save(
        self,
        path: str | Path,
        *,
        fps: int | None = None,
        seconds_per_step: float | None = None,
        size: Size | None = None,
    ) -> Path:
        """Write it as .gif, .mp4 or .html, which the name says; return the path.

        `fps` pictures a second show each step for `seconds_per_step`; `size` is in dots. Raises as
        `tsplan.animate`.
        """
        pace = Pace.of(self.result.horizon, fps, seconds_per_step, size)
        animate(self.mission, self.result, Path(path), pace)
        return Path(path)

    def _repr_html_(self) -> str:
        """The page in a frame of its own, where it reaches nothing of the notebook."""
        text = escape(page(self.mission, self.result))
        style = f"width:100%;height:{_HEIGHT}px;border:0"
        return f'<iframe sandbox="{_ALLOWED}" style="{style}" srcdoc="{text}"></iframe>'

    def __repr__(self) -> str:
        return f"<Movie of {self.result.mission.name!r}: {self.result.horizon} steps>"


def movie(
    mission: AnyMission,
    result: Plan | Trajectory,
    path: str | Path | None = None,
    *,
    fps: int | None = None,
    seconds_per_step: float | None = None,
    size: Size | None = None,
) -> Movie:
    """A plan or a trajectory as a `Movie`, which is saved where a path is given."""
    made = Movie(mission, result)
    if path is not None:
        made.save(path, fps=fps, seconds_per_step=seconds_per_step, size=size)
    return made
