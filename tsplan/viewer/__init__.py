"""Plans that move: the viewer, one HTML file for a browser, and animations."""

from tsplan.viewer.page import page

__all__ = ["page"]
