"""Pictures and datasets as files."""

from __future__ import annotations

import os
import re
from pathlib import Path

import xarray as xr

from varistiff.report.html import Picture
from varistiff.report.style import Drawing

PACKED_ABOVE = 1000  # values; below, compression costs more than it saves


def saved(drawing: Drawing, folder: Path) -> Picture:
    """Write a drawing as SVG and PNG into a folder, which is made; returns what the report embeds."""
    folder.mkdir(exist_ok=True)
    svg = drawing.svg()
    (folder / f"{drawing.name}.svg").write_text(svg, encoding="utf-8")
    drawing.save_png(folder / f"{drawing.name}.png")
    return Picture(drawing.name, drawing.title, drawing.caption, svg)


def write_netcdf(dataset: xr.Dataset, path: Path) -> None:
    """Write a dataset as netCDF, large variables compressed.

    Raises
    ------
    OSError : it cannot be written, a full disk included
    """
    packed = {
        name: {"zlib": True, "complevel": 1}
        for name, variable in dataset.data_vars.items()
        if variable.size > PACKED_ABOVE
    }
    try:
        dataset.to_netcdf(path, engine="h5netcdf", encoding=packed)
    except (OSError, RuntimeError) as error:
        # HDF5 tells of a full disk in the middle of a long text, and not always as an OSError
        found = re.search(r"errno = (\d+)", str(error))
        if found is None:
            raise
        raise OSError(int(found[1]), os.strerror(int(found[1])), str(path)) from error
