"""Largest stress in the elastic element, and the working area that it leaves."""

from __future__ import annotations

import numpy as np
import xarray as xr
from matplotlib import patheffects

from varistiff.report.display import display
from varistiff.report.figures.curves import Curve, draw_curves, legends, plain_numbers, set_range, zero_lines
from varistiff.report.figures.field import draw_field, field_canvas, veil
from varistiff.report.style import VERMILION, Drawing, canvas, ramp, styled
from varistiff.report.view import Field, View

TITLE = "Stress and safe working area"


def draw(dataset: xr.Dataset) -> Drawing | None:
    """Draw the largest stress; None where the kind has none, or one without a bound, which no colour shows."""
    view = View.of(dataset)
    if view.unbounded_stress:
        return None
    stress = view.field("stress", "Largest stress")
    if stress is None:
        return None
    if view.setting is None or view.setting.size < 2:
        return _line(view, stress)
    strength = view.strength
    with styled():
        figure, axes = field_canvas()
        draw_field(figure, axes, view, stress.shown, label=stress.label, colours="cividis")
        veil(figure, axes, view)
        finite = stress.values[np.isfinite(stress.values)]
        if strength is not None and finite.min() < strength < finite.max():
            line = axes.contour(
                view.x,
                view.y,
                np.ma.masked_invalid(stress.values / strength),
                levels=[1.0],
                colors=VERMILION,
                linewidths=2.4,
                zorder=3.5,
            )
            line.set_path_effects([patheffects.withStroke(linewidth=4.0, foreground="white")])
        axes.set_title(TITLE)
    caption = "Largest stress in the elastic element."
    if not view.ok.all():
        caption += " The clear area is safe to work in; hatched points are not ok."
    else:
        caption += " Every point of the map is safe to work in."
    if strength is not None:
        limit = display("Pa").text(strength)
        caption += f" The strength is {limit}; the orange line, where it appears, is its contour."
    else:
        caption += " No yield strength is given, so no point can count as yielded."
    return Drawing("stress", TITLE, figure, caption)


def _line(view: View, stress: Field) -> Drawing:
    curves = [Curve(view.x, stress.shown[0], view.status[0], "", ramp(1)[0])]
    with styled():
        figure, axes = canvas()
        inked = draw_curves(axes, curves)
        axes.set_xlim(float(view.x.min()), float(view.x.max()))
        set_range(axes, curves, log=False)
        if view.strength is not None:
            axes.axhline(view.strength * stress.display.factor, color=VERMILION, linewidth=2.0)
        zero_lines(axes)
        plain_numbers(axes, log=False)
        axes.set(xlabel=view.deflection_label, ylabel=stress.label, title=TITLE)
        legends(figure, axes, [], title="", inked=inked)
    return Drawing("stress", TITLE, figure, "Largest stress in the elastic element over deflection.")
