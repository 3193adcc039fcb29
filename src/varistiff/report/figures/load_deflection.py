"""Torque (or force) against deflection at several settings."""

from __future__ import annotations

import xarray as xr

from varistiff.core.status import Status
from varistiff.report.figures.curves import (
    Curve,
    curve_limits,
    draw_curves,
    legends,
    plain_numbers,
    zero_lines,
)
from varistiff.report.style import Drawing, canvas, ramp, styled
from varistiff.report.view import View


def draw(dataset: xr.Dataset) -> Drawing | None:
    """Draw the load over deflection; None where the map has no load."""
    view = View.of(dataset)
    name = view.load_name.capitalize()
    load = view.field(view.load_name, name)
    if load is None:
        return None
    rows = view.some_settings(5)
    colours = ramp(len(rows))
    curves = [
        Curve(view.x, load.shown[row], view.status[row], view.setting_text(row), colour)
        for row, colour in zip(rows, colours, strict=True)
    ]
    with styled():
        alone = view.setting is None and view.statuses == [Status.OK]
        figure, axes = canvas(right=0.95 if alone else 0.76)
        inked = draw_curves(axes, curves)
        axes.set_xlim(float(view.x.min()), float(view.x.max()))
        limits = curve_limits(curves)
        if limits:
            axes.set_ylim(*limits)
        zero_lines(axes)
        plain_numbers(axes, log=False)
        axes.set(xlabel=view.deflection_label, ylabel=load.label, title=f"{name} over deflection")
        if not alone:
            legends(figure, axes, curves if view.setting is not None else [], title=view.setting_name, inked=inked)
    caption = f"{name}, the derivative of the energy along the deflection, over deflection"
    caption += "." if view.setting is None else f", at {len(rows)} of the {view.status.shape[0]} settings of the map."
    if len(inked) > 1:
        caption += " Solid where every number may be used; dashes say why not. The axis shows all usable points."
    return Drawing("load_deflection", f"{name} over deflection", figure, caption)
