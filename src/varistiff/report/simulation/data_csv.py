"""The samples of a run as a table of text."""

from __future__ import annotations

import numpy as np
import xarray as xr

from varistiff.core.status import Status


def as_csv(data: xr.Dataset) -> str:
    """One row a sample, SI units, 17 significant digits; the header names the variables, the status is a word.

    Columns are ``time`` and every variable over time, in the order of the dataset.
    """
    names = ["time", *(str(name) for name, variable in data.data_vars.items() if variable.dims == ("time",))]
    columns = [_cells(name, np.asarray(data[name].values)) for name in names]
    lines = [",".join(names), *map(",".join, zip(*columns, strict=True))]
    return "\n".join(lines) + "\n"


def _cells(name: str, values: np.ndarray) -> list[str]:
    if name == "status":
        labels = {int(status): status.label for status in Status}
        return [labels.get(int(value), "") if np.isfinite(value) else "" for value in values]
    return [format(value, ".17g") for value in np.asarray(values, np.float64).tolist()]
