"""Draw the figures of the theory pages before Sphinx reads them."""

from __future__ import annotations

import importlib
import sys
from pathlib import Path
from typing import Any

import paper_tables

DEVICES = ("roller_beam", "torsion_tube", "antagonistic_leaves", "slider_leaf_joint", "maccepa")
COMPUTED = (
    "torsion_fillet",
    "condensed_corners",
    "joint_resonance",
    "joint_bode",
    "knee_map",
    "knee_course",
)


def draw_all(app: Any) -> None:
    """Write one SVG per device and per computed figure into figures/generated."""
    figures = Path(app.srcdir) / "figures"
    generated = figures / "generated"
    generated.mkdir(exist_ok=True)
    sys.path.insert(0, str(figures))
    for name in (*DEVICES, *COMPUTED):
        figure = importlib.import_module(name).draw()
        figure.savefig(generated / f"{name}.svg", metadata={"Date": None})
    paper_tables.draw_figures(app)


def setup(app: Any) -> dict[str, Any]:
    """Register with Sphinx."""
    app.connect("builder-inited", draw_all)
    return {"parallel_read_safe": True, "parallel_write_safe": True}
