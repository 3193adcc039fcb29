"""One figure per file, each a pure function from a run to a drawing, or None where there is nothing to show."""

from __future__ import annotations

from collections.abc import Callable, Iterator

import xarray as xr

from varistiff.report.simulation.figures import (
    drives,
    energy,
    map_path,
    residual,
    safe_area,
    stiffness,
    storage,
    temperature,
    tracking,
)
from varistiff.report.simulation.run import Run
from varistiff.report.style import Drawing

OVER_TIME: tuple[Callable[[Run], Drawing | None], ...] = (
    drives.draw_drive,
    drives.draw_setting,
    energy.draw,
    residual.draw,
    storage.draw,
    temperature.draw,
)


def draw_all(run: Run, characteristic: xr.Dataset) -> Iterator[Drawing]:
    """Draw every figure that the run has something for, in the order of the report.

    Parameters
    ----------
    run : the simulation
    characteristic : map of its design, for the safe area
    """
    first = (tracking.draw(run), stiffness.draw(run), safe_area.draw(run, characteristic))
    then = (map_path.draw(run, characteristic), *(draw(run) for draw in OVER_TIME))
    for drawing in (*first, *then):
        if drawing is not None:
            yield drawing
