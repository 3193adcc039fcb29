"""What the energy balance leaves open, on a logarithmic axis, against what is allowed."""

from __future__ import annotations

import numpy as np

from varistiff.report.display import Display
from varistiff.report.simulation.balance import Balance
from varistiff.report.simulation.run import Run
from varistiff.report.simulation.timeline import LIMIT, finish, key, sheet, thinned
from varistiff.report.style import BLUE, VERMILION, Drawing, styled

TITLE = "Residual of the energy balance"
DECADES = 8.0  # below the allowance that are worth seeing


def draw(run: Run) -> Drawing | None:
    """Draw the magnitude of the residual; None where it is not a number throughout."""
    balance = Balance.of(run)
    size = np.abs(balance.residual)
    if not np.isfinite(size).any():
        return None
    top = max(float(np.nanmax(size)), balance.allowance) or 1e-12
    floor = top * 10.0**-DECADES
    with styled():
        figure, (axes,) = sheet(run, [2.1], TITLE)
        x, y = thinned(run.x, np.maximum(size, floor))
        handles = axes.plot(x, y, color=BLUE, linewidth=1.6, label="magnitude", zorder=3.0)
        if balance.allowance > 0.0:
            line = axes.axhline(balance.allowance, color=VERMILION, linestyle=LIMIT, linewidth=1.8, label="allowed")
            axes.axhspan(balance.allowance, 1e6 * top, color=VERMILION, alpha=0.10, linewidth=0.0)
            handles.append(line)
        axes.set_yscale("log")
        axes.set_ylim(0.5 * float(np.nanmin(y)), 5.0 * top)
        finish(axes, "Residual", Display(1.0, "J"), log=True)
        key(axes, handles)
    caption = (
        f"{balance.sentence} The residual is what the stores gain and what is lost, less what came in; no term is"
        " computed as a remainder."
    )
    return Drawing("residual", TITLE, figure, caption)
