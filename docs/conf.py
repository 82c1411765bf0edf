"""How the documentation is built: `sphinx-build -W docs docs/_build`, with the extra `docs`."""

from __future__ import annotations

import sys
from pathlib import Path
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from sphinx.application import Sphinx

DOCS = Path(__file__).parent
sys.path[:0] = [str(DOCS.parent), str(DOCS)]

from tsplan.version import VERSION  # noqa: E402  (the package beside this folder)

project = "tsplan"
author = "The tsplan authors"
copyright = "2026, the tsplan authors"  # noqa: A001  (Sphinx's name)
version = release = VERSION

extensions = [
    "myst_nb",
    "sphinx.ext.autodoc",
    "sphinx.ext.napoleon",
    "library_reference",
]
exclude_patterns = ["_build", "**.ipynb_checkpoints"]
templates_path: list[str] = []
nitpicky = False

highlight_language = "none"  # what is printed has no language
html_theme = "furo"
html_title = f"tsplan {VERSION}"
html_static_path = ["_static"]
html_css_files = ["tsplan.css"]
html_show_sphinx = False

# pages link to each other's headings as they do on code hosts
myst_heading_anchors = 4
myst_links_external_new_tab = False
# notebooks are stored with what they print, which tests compare with a run
nb_execution_mode = "off"
nb_merge_streams = True

autodoc_member_order = "bysource"
autodoc_typehints = "signature"
autodoc_default_options = {"members": True}
autodoc_preserve_defaults = True
napoleon_numpy_docstring = True
napoleon_google_docstring = False
napoleon_use_rtype = False
python_use_unqualified_type_names = True
add_module_names = False
maximum_signature_line_length = 88


def setup(app: Sphinx) -> None:
    """Tell of files outside of this folder that pages link to: they are part of the project."""
    app.connect("source-read", _linked_outside)


def _linked_outside(_: Sphinx, __: str, content: list[str]) -> None:
    """Links to folders of the project, which a page cannot have, become what they are called."""
    content[0] = content[0].replace("[`environments/`](../environments)", "`environments/`")
