"""Plans that move: the viewer, one HTML file for a browser, and animations."""

from tsplan.viewer.webpage import page

__all__ = ["page"]
