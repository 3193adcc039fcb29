"""One quantity by several methods over the setting, like Fig. 9 of Schuy et al. (2013)."""

from __future__ import annotations

from collections.abc import Iterator
from typing import Any

import numpy as np
from matplotlib.figure import Figure

from varistiff.fe.comparison import Comparison
from varistiff.report.display import display
from varistiff.report.style import BLACK, BLUE, GREEN, INK, ORANGE, PURPLE, SKY, VERMILION, Drawing, styled

COLOURS = (BLUE, VERMILION, GREEN, PURPLE, ORANGE, SKY)
MARKERS = ("s", "^", "o", "D", "v", "P")


def _looks(comparison: Comparison) -> Iterator[dict[str, Any]]:
    solid = 0
    for number, method in enumerate(comparison.methods):
        if np.isfinite(method.errors).any():
            colour, marker = COLOURS[solid % len(COLOURS)], MARKERS[solid % len(MARKERS)]
            solid += 1
            yield {"color": colour, "marker": marker, "markersize": 5.5, "linewidth": 1.0, "linestyle": ":"}
        else:
            one = {"marker": "_" if number == 0 else "|", "markersize": 14} if comparison.setting.size == 1 else {}
            yield {"color": INK, "linestyle": "-" if number == 0 else "--", "linewidth": 1.6, **one}


def draw(comparison: Comparison, setting_unit: str) -> Drawing:
    """Draw every method as a line, what came from a computation in three dimensions with markers."""
    at = display(setting_unit)
    shown = display(comparison.unit, float(np.nanmax(np.abs(comparison.reference.values))))
    x = comparison.setting * at.factor
    positive = all(np.nanmin(method.values) > 0.0 for method in comparison.methods)
    spread = (
        max(np.nanmax(method.values) / np.nanmin(method.values) for method in comparison.methods) if positive else 1
    )
    with styled():
        figure = Figure(figsize=(9.2, 6.4))
        axes = figure.add_axes((0.095, 0.40, 0.52, 0.53))
        below = figure.add_axes((0.095, 0.10, 0.52, 0.23), sharex=axes)
        for method, look in zip(comparison.methods, _looks(comparison), strict=True):
            axes.plot(x, method.values * shown.factor, label=method.label, **look)
            if method is not comparison.reference:
                below.plot(x, 100.0 * comparison.difference(method), **look)
        if comparison.measured is not None:
            where, values = comparison.measured
            cross: dict[str, Any] = {
                "color": BLACK,
                "marker": "x",
                "markersize": 8,
                "markeredgewidth": 2.0,
                "linestyle": "none",
            }
            axes.plot(where * at.factor, values * shown.factor, label="measured", **cross)
        if spread > 20.0:
            axes.set_yscale("log")
        elif positive:
            axes.set_ylim(bottom=0.0)
        axes.set(
            ylabel=f"{comparison.quantity.capitalize()} [{shown.unit}]",
            title=f"{comparison.quantity.capitalize()} by method",
        )
        axes.tick_params(labelbottom=False)
        below.axhline(0.0, color=INK, linewidth=1.6)
        below.set(xlabel=f"Setting [{at.unit}]", ylabel="Difference [%]")
        axes.legend(loc="upper left", bbox_to_anchor=(1.02, 1.0), borderaxespad=0.0)
        below.text(1.03, 0.98, f"from {comparison.reference.label}", transform=below.transAxes, va="top", color=INK)
    caption = (
        f"{comparison.quantity.capitalize()} over the setting. Lines: formulas; dots with markers: computed in three "
        "dimensions"
        + ("; crosses: measured." if comparison.measured is not None else ".")
        + f" Below: the difference from {comparison.reference.label}."
    )
    if spread > 20.0:
        caption += " The axis is logarithmic."
    return Drawing("comparison", "Comparison", figure, caption)
