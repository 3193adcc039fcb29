"""Pictures of linear analysis: Bode diagram, and resonance over the setting."""

from __future__ import annotations

import numpy as np
import xarray as xr
from matplotlib.axes import Axes
from matplotlib.figure import Figure
from matplotlib.ticker import FuncFormatter, LogLocator, MultipleLocator, NullFormatter

from varistiff.report.display import display, number
from varistiff.report.style import BLUE, VERMILION, WIDTH, Drawing, canvas, styled

_LEFT, _WIDE = 0.13, 0.83  # of the axes, as parts of the figure
_DOT = "\N{MIDDLE DOT}"


def draw_bode(response: xr.Dataset) -> Drawing:
    """Magnitude and phase over frequency.

    Parameters
    ----------
    response : of ``varistiff.dynamics.linear.frequency_response``
    """
    output, source = response.attrs["output"], response.attrs["input"]
    units = response.magnitude.attrs.get("units", "").replace("*", _DOT)
    title = f"{output} over {source}".replace("_", " ")
    f = response.frequency.values
    with styled():
        figure = Figure(figsize=(WIDTH, 5.6))
        top = figure.add_axes((_LEFT, 0.52, _WIDE, 0.41))
        bottom = figure.add_axes((_LEFT, 0.12, _WIDE, 0.31))
        top.loglog(f, response.magnitude, color=BLUE)
        bottom.semilogx(f, np.degrees(response.phase), color=BLUE)
        top.set(ylabel=f"Magnitude [{units}]" if units else "Magnitude", title=title[:1].upper() + title[1:])
        bottom.set(xlabel="Frequency [Hz]", ylabel="Phase [deg]")
        bottom.yaxis.set_major_locator(MultipleLocator(90.0))
        low, high = np.degrees(float(response.phase.min())), np.degrees(float(response.phase.max()))
        # whole right angles, less the few degrees by which a phase nears one from outside
        bottom.set_ylim(90.0 * np.floor((low + 10.0) / 90.0) - 12.0, 90.0 * np.ceil((high - 10.0) / 90.0) + 12.0)
        for axes in (top, bottom):
            axes.set_xlim(float(f[0]), float(f[-1]))
        _plain_frequencies(bottom)
        _plain_frequencies(top)
    return Drawing("bode", "Bode diagram", figure, f"Bode diagram from {source} to {output}.")


def draw_resonance(resonance: xr.Dataset) -> Drawing:
    """Resonance and antiresonance over the setting; a joint without a free drive has the first only.

    Parameters
    ----------
    resonance : of ``varistiff.dynamics.linear.resonance_over_settings``
    """
    shown = display(resonance.setting.attrs["units"])
    x = shown.factor * resonance.setting.values
    lines = [("resonance", "resonance", BLUE), ("antiresonance", "antiresonance: link on a held drive", VERMILION)]
    with styled():
        figure, axes = canvas(right=0.96)
        for name, label, colour in lines:
            if np.isfinite(resonance[name].values).any():
                axes.plot(x, resonance[name], color=colour, label=label)
        axes.set_ylim(bottom=0.0)
        axes.set(xlabel=f"Setting [{shown.unit}]", ylabel="Frequency [Hz]", title="Resonance over setting")
        axes.legend(loc="best", borderaxespad=0.6)
    caption = "Natural frequencies of small motions about rest over the setting, which its drive holds."
    return Drawing("resonance", "Resonance over setting", figure, caption)


def _plain_frequencies(axes: Axes) -> None:
    """Decades and their halves as plain numbers."""
    axes.xaxis.set_major_locator(LogLocator(10.0, subs=(1.0, 2.0, 5.0)))
    axes.xaxis.set_major_formatter(FuncFormatter(lambda value, _: number(float(value))))
    axes.xaxis.set_minor_formatter(NullFormatter())
