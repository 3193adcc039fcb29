"""One figure per file, each a pure function from a characteristic map to a drawing."""

from __future__ import annotations

from collections.abc import Callable, Iterator

import xarray as xr

from varistiff.report.figures import (
    adjusting_map,
    energy_map,
    load_deflection,
    status_map,
    stiffness_deflection,
    stiffness_setting,
    stress_map,
)
from varistiff.report.style import Drawing

DRAWINGS: tuple[Callable[[xr.Dataset], Drawing | None], ...] = (
    load_deflection.draw,
    stiffness_deflection.draw,
    stiffness_setting.draw,
    energy_map.draw,
    adjusting_map.draw,
    stress_map.draw,
    status_map.draw,
)


def draw_all(dataset: xr.Dataset) -> Iterator[Drawing]:
    """Draw every figure that the map has numbers for, in the order of the report."""
    for draw in DRAWINGS:
        drawing = draw(dataset)
        if drawing is not None:
            yield drawing
