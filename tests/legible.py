"""Whether what is written on a picture can be read: nothing hidden, nothing cut off."""

from __future__ import annotations

from itertools import combinations


def boxes(figure):
    """The extents of all texts that are to be seen."""
    from matplotlib.axes import Axes  # noqa: PLC0415  (an extra)
    from matplotlib.backends.backend_agg import FigureCanvasAgg  # noqa: PLC0415
    from matplotlib.text import Text  # noqa: PLC0415

    renderer = FigureCanvasAgg(figure).get_renderer()
    figure.draw_without_rendering()
    hidden = set()
    for ax in figure.findobj(Axes):
        for axis in (ax.xaxis, ax.yaxis):
            low, high = sorted(axis.get_view_interval())
            ticks = axis.get_major_ticks()
            unseen = [tick for tick in ticks if not low <= tick.get_loc() <= high]
            hidden |= {id(label) for tick in unseen for label in (tick.label1, tick.label2)}
            hidden.add(id(axis.offsetText))
            hidden |= {id(label) for label in axis.get_ticklabels() if not ax.axison}
    return [
        (text.get_text(), text.get_window_extent(renderer))
        for text in figure.findobj(Text)
        if text.get_visible() and text.get_text().strip() and id(text) not in hidden
    ]


def assert_legible(figure):
    """No text hides another one, and none is cut off."""
    found = boxes(figure)
    width, height = figure.get_size_inches() * figure.dpi
    for words, box in found:
        assert box.x0 >= -1, (words, "is cut off")
        assert box.y0 >= -1, (words, "is cut off")
        assert box.x1 <= width + 1, (words, "is cut off")
        assert box.y1 <= height + 1, (words, "is cut off")
    for (one, a), (other, b) in combinations(found, 2):
        apart = a.x0 >= b.x1 - 1 or b.x0 >= a.x1 - 1 or a.y0 >= b.y1 - 1 or b.y0 >= a.y1 - 1
        assert apart, (one, other, "overlap")
