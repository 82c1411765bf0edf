"""Plans as moving pictures: GIF by Pillow, MP4 by ffmpeg where it is installed, HTML."""

from __future__ import annotations

import io
import shutil
import subprocess
import tempfile
from collections.abc import Callable, Iterable
from contextlib import suppress
from dataclasses import dataclass
from itertools import chain
from pathlib import Path
from types import MappingProxyType
from typing import Any, cast

import numpy as np

from tsplan.document.files import write_whole
from tsplan.draw.matplotlib_loading import tell_lost
from tsplan.errors import Finding, InputError, TsplanError
from tsplan.mission import Mission
from tsplan.plans.plan import Plan
from tsplan.signals.signal_mission import SignalMission
from tsplan.signals.trajectory import Trajectory
from tsplan.viewer.browser import write_page
from tsplan.viewer.scene import Film, Pixels, Scene, Size
from tsplan.viewer.signal_scene import SignalScene

LONGEST = 30.0
"""Seconds that an animation takes at most, unless the seconds of a step are given."""

_HOLD = 1.0  # seconds that the last picture is shown
_COLORS = 255  # of a GIF's one palette
_SAMPLES = 5  # pictures that the palette is made from


class FfmpegUnavailableError(TsplanError, RuntimeError):
    """Writing MP4 needs ffmpeg, which is not installed, or it failed."""


@dataclass(frozen=True)
class Pace:
    """How an animation looks: pictures a second, seconds of a step, width and height in dots."""

    fps: int = 10
    seconds_per_step: float = 0.6
    size: Size = (960, 600)

    @classmethod
    def of(
        cls,
        horizon: int,
        fps: int | None = None,
        seconds_per_step: float | None = None,
        size: Size | None = None,
    ) -> Pace:
        """The pace for a plan; what is None is chosen so that the whole is not too long."""
        slow = min(cls.seconds_per_step, LONGEST / max(1, horizon))
        return cls(fps or cls.fps, seconds_per_step or slow, size or cls.size)

    def times(self, horizon: int) -> tuple[float, ...]:
        """The time of every picture, from 0 to the horizon.

        >>> Pace(fps=4, seconds_per_step=0.5).times(2)
        (0.0, 0.5, 1.0, 1.5, 2.0)
        """
        pictures = max(1, round(horizon * self.seconds_per_step * self.fps)) if horizon else 0
        return (*(horizon * number / pictures for number in range(pictures)), float(horizon))


def animate(
    mission: Mission | SignalMission,
    plan: Plan | Trajectory,
    path: Path,
    pace: Pace | None = None,
    tell: Callable[[str], object] | None = None,
) -> None:
    """Write a plan or a trajectory as a moving picture.

    The file's name says which kind: .gif, .mp4 or .html.

    Letters that no font could draw are named in one sentence to `tell`, without it as
    MissingLettersWarning.

    Raises InputError for another kind, PlanError for a plan that cannot be shown,
    FfmpegUnavailableError for MP4 without ffmpeg, PlotUnavailableError without matplotlib.
    """
    pace = pace or Pace.of(plan.horizon)
    kind = path.suffix.lower()
    if kind == ".html":
        write_page(mission, plan, path)
        return
    if kind not in _WRITERS:
        what = f"moving pictures cannot be written as '{kind or path.name}'"
        raise InputError([Finding(what, "use .gif, .mp4 or .html", str(path))])
    width, height = pace.size
    if kind == ".mp4":
        _ffmpeg()  # says what is missing before anything is painted
        width, height = width // 2 * 2, height // 2 * 2  # the usual codec asks for it
    if isinstance(plan, Trajectory):
        scene: Film = SignalScene(cast("SignalMission", mission), plan, (width, height))
    else:
        scene = Scene(cast("Mission", mission), plan, (width, height))
    write_whole(path, _WRITERS[kind](scene, pace.times(plan.horizon), pace.fps))
    tell_lost(scene.letters, "an .html file is shown in the reader's fonts", tell, path)


def gif(scene: Film, times: tuple[float, ...], fps: int) -> bytes:
    """The pictures at some times as a GIF that starts again at its end."""
    from PIL import Image  # noqa: PLC0415  (comes with matplotlib, an extra)

    samples = np.linspace(0, len(times) - 1, _SAMPLES).astype(int)
    sheet = Image.fromarray(np.vstack([scene.at(times[number]) for number in samples]))
    palette = sheet.quantize(_COLORS, method=Image.Quantize.MEDIANCUT)

    style: dict[str, Any] = {"palette": palette, "dither": Image.Dither.NONE}
    made = (Image.fromarray(scene.at(time)).quantize(**style) for time in times)
    content = io.BytesIO()
    each = round(1000 / fps)
    pauses = [*(each for _ in times[1:]), each + round(1000 * _HOLD)]
    film: dict[str, Any] = {"format": "GIF", "save_all": True, "append_images": made, "loop": 0}
    next(made).save(content, duration=pauses, **film)
    return content.getvalue()


def _ffmpeg() -> str:
    program = shutil.which("ffmpeg")
    if program is None:
        raise FfmpegUnavailableError(
            "writing .mp4 needs the program ffmpeg, which is not installed; install it, or write "
            "a .gif or .html file"
        )
    return program


def _mp4(scene: Film, times: tuple[float, ...], fps: int) -> bytes:
    width, height = scene.size
    with tempfile.TemporaryDirectory() as folder:
        target = Path(folder, "plan.mp4")
        command = [
            *(_ffmpeg(), "-loglevel", "error", "-y"),
            *("-f", "rawvideo", "-pix_fmt", "rgb24", "-s", f"{width}x{height}"),
            *("-r", str(fps), "-i", "-", "-an"),
            *("-pix_fmt", "yuv420p", "-movflags", "+faststart", str(target)),
        ]
        frames = chain(times, [times[-1]] * round(_HOLD * fps))
        said = _fed(command, (scene.at(time) for time in frames))
        if said or not target.is_file():
            raise FfmpegUnavailableError(f"ffmpeg failed: {said or 'it wrote nothing'}")
        return target.read_bytes()


def _fed(command: list[str], frames: Iterable[Pixels]) -> str:
    """Run a program on a stream of pictures; what it says if it fails."""
    with subprocess.Popen(  # noqa: S603  (a fixed command, no shell)
        command, stdin=subprocess.PIPE, stderr=subprocess.PIPE
    ) as process:
        assert process.stdin is not None
        with suppress(BrokenPipeError):  # what it says explains why
            for frame in frames:
                process.stdin.write(frame.tobytes())
        words = process.communicate()[1].decode(errors="replace").strip()
    return (words or f"exit code {process.returncode}") if process.returncode else ""


_WRITERS = MappingProxyType({".gif": gif, ".mp4": _mp4})
