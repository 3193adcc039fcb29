"""Sphinx configuration; the pages are Markdown (MyST)."""

from __future__ import annotations

import sys
from importlib import metadata
from pathlib import Path

sys.path.insert(0, str(Path(__file__).parent / "_ext"))

project = "varistiff"
author = "The varistiff authors"
copyright = author
version = release = metadata.version("varistiff")

extensions = [
    "generated_pages",
    "mathml",
    "mechanism_figures",
    "myst_parser",
    "sphinx.ext.autodoc",
    "docstrings",
    "sphinx.ext.autosummary",
    "sphinx.ext.napoleon",
    "sphinx.ext.viewcode",
]
exclude_patterns = ["_build", "generated"]

myst_enable_extensions = ["attrs_block", "colon_fence", "deflist", "dollarmath"]
myst_heading_anchors = 3

autosummary_generate = True
toc_object_entries = False  # the navigation of every page would carry every function: minutes of building
autodoc_member_order = "bysource"
autodoc_typehints = "signature"
autodoc_default_options = {"members": True, "show-inheritance": True}
napoleon_google_docstring = False
napoleon_use_rtype = False
suppress_warnings = ["ref.python"]  # an annotation says Motion or Run, and two rooms have one; the link is left out
nitpicky = False  # jaxtyping and pydantic put names into signatures that have no page

html_math_renderer = "mathml"
html_theme = "furo"
html_title = f"varistiff {version}"
html_static_path: list[str] = []
