"""What the stiffness drive must hold, over deflection and setting."""

from __future__ import annotations

import xarray as xr

from varistiff.report.figures.field import draw_field, field_canvas, veil
from varistiff.report.style import Drawing, styled
from varistiff.report.view import View


def draw(dataset: xr.Dataset) -> Drawing | None:
    """Draw the adjusting force (or torque); None for a kind without a setting."""
    view = View.of(dataset)
    title = view.adjusting_name.replace("_", " ").capitalize()
    adjusting = view.field(view.adjusting_name, title)
    if adjusting is None or view.setting is None or view.setting.size < 2:
        return None
    with styled():
        figure, axes = field_canvas()
        draw_field(figure, axes, view, adjusting.shown, label=adjusting.label, colours="cividis")
        veil(figure, axes, view)
        axes.set_title(title)
    caption = (
        f"{title} that the stiffness drive must hold, the slope of the energy along the setting."
        " Positive: it pushes"
        " towards larger settings; negative: it holds back from them."
    )
    return Drawing("adjusting", title, figure, caption)
