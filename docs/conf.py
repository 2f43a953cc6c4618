"""Sphinx configuration."""

from importlib.metadata import version as version_of

project = "swarmgrasp"
author = "The swarmgrasp authors"
release = version_of("swarmgrasp")
extensions = ["myst_parser", "sphinx.ext.autodoc", "sphinx.ext.napoleon", "sphinx.ext.mathjax"]
myst_enable_extensions = ["dollarmath"]
napoleon_google_docstring = False
napoleon_use_ivar = True
autodoc_member_order = "bysource"
autodoc_typehints = "none"
html_theme = "furo"
html_title = "swarmgrasp"
exclude_patterns = ["_build"]
