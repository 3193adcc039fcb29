"""Elastic energy over deflection and setting."""

from __future__ import annotations

import numpy as np
import xarray as xr

from varistiff.core.status import Status
from varistiff.report.figures.curves import Curve, draw_curves, legends, plain_numbers, set_range, zero_lines
from varistiff.report.figures.field import draw_field, field_canvas, veil
from varistiff.report.style import Drawing, canvas, ramp, styled
from varistiff.report.view import Field, View


def draw(dataset: xr.Dataset) -> Drawing | None:
    """Draw the energy: contours over deflection and setting, or one line for a kind without a setting."""
    view = View.of(dataset)
    energy = view.field("energy", "Elastic energy")
    if energy is None:
        return None
    if view.setting is None or view.setting.size < 2:
        return _line(view, energy)
    with styled():
        figure, axes = field_canvas()
        draw_field(figure, axes, view, energy.shown, label=energy.label)
        veil(figure, axes, view)
        axes.set_title("Elastic energy")
    caption = (
        "Elastic energy V. Its slope along the deflection is the load, its slope along the setting is what the"
        " stiffness drive must hold."
    )
    if not view.ok.all():
        caption += " Hatched points are not ok; the colours cover the ok points."
    return Drawing("energy", "Elastic energy", figure, caption)


def _line(view: View, energy: Field) -> Drawing:
    curves = [Curve(view.x, energy.shown[0], view.status[0], "", ramp(1)[0])]
    with styled():
        alone = view.statuses == [Status.OK]
        figure, axes = canvas(right=0.95 if alone else 0.76)
        inked = draw_curves(axes, curves)
        axes.set_xlim(float(view.x.min()), float(view.x.max()))
        set_range(axes, curves, log=False)
        zero_lines(axes)
        plain_numbers(axes, log=False)
        axes.set(xlabel=view.deflection_label, ylabel=energy.label, title="Elastic energy")
        axes.fill_between(view.x, 0.0, np.nan_to_num(energy.shown[0]), color=ramp(1)[0], alpha=0.10, linewidth=0.0)
        if not alone:
            legends(figure, axes, [], title="", inked=inked)
    caption = "Elastic energy V over deflection; its slope is the load, its curvature the stiffness."
    return Drawing("energy", "Elastic energy", figure, caption)
