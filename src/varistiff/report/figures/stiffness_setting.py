"""Tangent stiffness against the setting at several deflections: what the stiffness drive buys."""

from __future__ import annotations

import numpy as np
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
    """Draw the stiffness over the setting; None for a kind without a setting."""
    view = View.of(dataset)
    stiffness = view.field("stiffness", "Tangent stiffness")
    if stiffness is None or view.setting is None or view.setting.size < 2:
        return None
    # a deflection that is ok nowhere has no curve worth the ink
    columns = [column for column in view.some_deflections(5) if view.ok[:, column].any()] or [view.rest]
    curves = [
        Curve(view.y, stiffness.shown[:, column], view.status[:, column], view.deflection_text(column), colour)
        for column, colour in zip(columns, ramp(len(columns)), strict=True)
    ]
    alike = len(curves) > 1 and all(_same(curves[0], curve) for curve in curves[1:])
    if alike:
        widest = max(curves, key=lambda curve: int((curve.status == Status.OK).sum()))
        curves = [Curve(widest.x, widest.y, widest.status, "any", ramp(1)[0])]
    log = wants_log(curves)
    with styled():
        figure, axes = canvas()
        inked = draw_curves(axes, curves)
        axes.set_xlim(float(view.y.min()), float(view.y.max()))
        set_range(axes, curves, log=log)
        zero_lines(axes, horizontal=not log)
        plain_numbers(axes, log=log)
        axes.set(xlabel=view.setting_label, ylabel=stiffness.label, title="Stiffness over setting")
        legends(figure, axes, curves, title="Deflection", inked=inked)
    if alike:
        caption = "Tangent stiffness over the setting; it is the same at every deflection."
    else:
        caption = f"Tangent stiffness over the setting, at {len(columns)} deflections from rest."
    if log:
        caption += " The stiffness axis is logarithmic."
    if inked != {Status.OK}:
        caption += " Dashes mark points that are not ok."
    return Drawing("stiffness_setting", "Stiffness over setting", figure, caption)


def _same(one: Curve, other: Curve) -> bool:
    """Whether two curves coincide to the width of a line wherever both are ok."""
    both = (one.status == Status.OK) & (other.status == Status.OK)
    return bool(np.allclose(one.y[both], other.y[both], rtol=3e-3, atol=0.0))
