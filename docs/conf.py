"""Sphinx configuration."""

import sys
from importlib.metadata import version as version_of
from pathlib import Path

sys.path.insert(0, str(Path(__file__).parent / "extensions"))

project = "swarmgrasp"
author = "The swarmgrasp authors"
project_copyright = author
release = version_of("swarmgrasp")
extensions = [
    "myst_nb",
    "sphinx.ext.autodoc",
    "sphinx.ext.napoleon",
    "gallery",
    "generated",
    "mathml",
    "signatures",
    "wrapping",
]
html_math_renderer = "mathml"
myst_enable_extensions = ["dollarmath"]
myst_heading_anchors = 3  # links to headings, as scenario.md#units-and-quantities
nb_execution_mode = "force"
nb_execution_raise_on_error = True
nb_execution_timeout = 300
nb_ipywidgets_js = {}  # nothing from a network: sliders move in running notebooks
napoleon_google_docstring = False
napoleon_use_ivar = True
autodoc_member_order = "bysource"
autodoc_typehints = "signature"
autodoc_typehints_format = "short"
python_use_unqualified_type_names = True
default_role = "py:obj"
toc_object_entries_show_parents = "hide"
html_theme = "furo"
html_title = "swarmgrasp"
html_theme_options = {
    key: {"code-font-size": "75%"} for key in ("light_css_variables", "dark_css_variables")
}
html_static_path = ["static"]
html_css_files = ["pages.css"]
exclude_patterns = ["_build", "extensions"]
