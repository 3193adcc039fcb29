"""Tangent stiffness against deflection at several settings."""

from __future__ import annotations

import xarray as xr

from varistiff.core.status import Status
from varistiff.report.figures.curves import (
    Curve,
    draw_curves,
    legends,
    plain_numbers,
    set_range,
    wants_log,
    zero_lines,
)
from varistiff.report.style import Drawing, canvas, ramp, styled
from varistiff.report.view import View


def draw(dataset: xr.Dataset) -> Drawing | None:
    """Draw the stiffness over deflection; logarithmic where settings differ by more than a factor of 12."""
    view = View.of(dataset)
    stiffness = view.field("stiffness", "Tangent stiffness")
    if stiffness is None:
        return None
    rows = view.some_settings(5)
    curves = [
        Curve(view.x, stiffness.shown[row], view.status[row], view.setting_text(row), colour)
        for row, colour in zip(rows, ramp(len(rows)), strict=True)
    ]
    log = wants_log(curves)
    with styled():
        alone = view.setting is None and view.statuses == [Status.OK]
        figure, axes = canvas(right=0.95 if alone else 0.76)
        inked = draw_curves(axes, curves)
        axes.set_xlim(float(view.x.min()), float(view.x.max()))
        set_range(axes, curves, log=log)
        zero_lines(axes, horizontal=not log)
        plain_numbers(axes, log=log)
        axes.set(xlabel=view.deflection_label, ylabel=stiffness.label, title="Stiffness over deflection")
        if not alone:
            legends(figure, axes, curves if view.setting is not None else [], title=view.setting_name, inked=inked)
    caption = "Tangent stiffness, the second derivative of the energy, over deflection"
    caption += "." if view.setting is None else f", at {len(rows)} settings."
    if log:
        caption += " The stiffness axis is logarithmic."
    return Drawing("stiffness_deflection", "Stiffness over deflection", figure, caption)
