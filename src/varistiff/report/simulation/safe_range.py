"""How far an actuator may be deflected at each setting, from its map."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
import xarray as xr

from varistiff.core.status import Status
from varistiff.report.view import Array, View

SAFE = (Status.OK, Status.NO_CONTACT)


@dataclass(frozen=True)
class SafeRange:
    """Deflections that are reached from rest through safe points only, per row of a map, and the loads there."""

    setting: Array
    deflection: tuple[Array, Array]  # lowest and highest
    load: tuple[Array, Array]

    @staticmethod
    def of(characteristic: xr.Dataset) -> SafeRange:
        """Read it from a map; NaN where not even rest is safe."""
        view = View.of(characteristic)
        safe = np.isin(view.status, SAFE)
        load = np.atleast_2d(np.asarray(characteristic[view.load_name].values, float))
        ends = np.array([_ends(row, view.rest) for row in safe])
        rows = np.arange(safe.shape[0])
        rest = safe[rows, view.rest]
        setting = np.zeros(1) if view.setting is None else view.setting
        deflection = [np.where(rest, view.deflection[ends[:, side]], np.nan) for side in (0, 1)]
        loads = np.sort(np.stack([np.where(rest, load[rows, ends[:, side]], np.nan) for side in (0, 1)]), axis=0)
        return SafeRange(setting, (deflection[0], deflection[1]), (loads[0], loads[1]))

    def at(self, setting: Array | None, count: int) -> tuple[tuple[Array, Array], tuple[Array, Array]]:
        """Ranges of deflection and of load over time, straight between the rows of the map."""
        places = np.full(count, self.setting[0]) if setting is None else setting

        def over_time(values: Array) -> Array:
            return np.asarray(np.interp(places, self.setting, values, left=np.nan, right=np.nan))

        low, high = (over_time(part) for part in self.deflection)
        least, most = (over_time(part) for part in self.load)
        return (low, high), (least, most)


def _ends(safe: np.ndarray, rest: int) -> tuple[int, int]:
    """Columns of the first and last point of the safe stretch around rest."""
    low = high = rest
    while low > 0 and safe[low - 1]:
        low -= 1
    while high < safe.size - 1 and safe[high + 1]:
        high += 1
    return low, high
