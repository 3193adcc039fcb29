"""Stiffness wanted and reached, the error, and the setting that makes it."""

from __future__ import annotations

import math

import numpy as np

from varistiff.report.simulation.run import Run
from varistiff.report.simulation.timeline import WANTED, Panel, Trace, draw_panels
from varistiff.report.style import BLUE, INK, PURPLE, VERMILION, Drawing, styled
from varistiff.report.view import Array


def draw(run: Run) -> Drawing | None:
    """Draw tangent stiffness and setting over time; None where both stay as they are and nothing is wanted."""
    real, wanted, setting = run.given("stiffness"), run.telling("wanted_stiffness"), run.given("setting")
    if real is None or (wanted is None and not varies(real) and not varies(setting)):
        return None
    unit = run.unit("stiffness")
    traces = [Trace(real, "tangent", BLUE, width=2.4)]
    if wanted is not None:
        traces.append(Trace(wanted, "wanted", INK, WANTED, 1.5))
    panels = [Panel("Stiffness", unit, tuple(traces))]
    if wanted is not None:
        panels.append(Panel("Error", unit, (Trace(wanted - real, "wanted minus\ntangent", VERMILION),)))
    if setting is not None and varies(setting):
        limits = run.simulation.design.setting_range or (-math.inf, math.inf)
        panels.append(Panel(run.setting_name, run.unit("setting"), (Trace(setting, "setting", PURPLE),), limits))
    with styled():
        figure = draw_panels(run, panels, "Stiffness")
    caption = "Tangent stiffness of the actuator at its deflection and setting"
    caption += ", and how far it is from what was wanted." if wanted is not None else "."
    if setting is not None and varies(setting):
        caption += " Below: the setting; its limits are the ends of the design's range."
    return Drawing("stiffness", "Stiffness", figure, caption)


def varies(values: Array | None) -> bool:
    """Whether a variable changes by more than rounding."""
    if values is None:
        return False
    known = values[np.isfinite(values)]
    return bool(np.ptp(known) > 1e-9 * np.abs(known).max())
