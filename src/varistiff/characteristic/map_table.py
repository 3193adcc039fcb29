"""A characteristic map as plain arrays, and how to find and name the points that matter."""

from __future__ import annotations

import math
from dataclasses import dataclass

import numpy as np
import numpy.typing as npt
import xarray as xr

from varistiff.core.status import Status

Array = npt.NDArray[np.float64]
Mask = npt.NDArray[np.bool_]


@dataclass(frozen=True)
class MapTable:
    """The map as plain arrays of shape (setting, deflection); one row where the kind has no setting."""

    deflection: Array
    setting: Array | None
    status: npt.NDArray[np.int8]
    energy: Array
    load: Array
    stiffness: Array
    adjusting: Array | None
    stress: Array | None
    strength: float | None
    load_name: str
    adjusting_name: str
    units: dict[str, str]

    @staticmethod
    def of(dataset: xr.Dataset) -> MapTable:
        """Read a dataset as ``characteristic_map`` returns it."""
        load_name = "torque" if "torque" in dataset else "force"
        adjusting_name = "adjusting_torque" if "adjusting_torque" in dataset else "adjusting_force"
        setting = np.asarray(dataset["setting"].values, float) if "setting" in dataset.dims else None

        def values(name: str) -> Array:
            return np.atleast_2d(np.asarray(dataset[name].values, float))

        def optional(name: str) -> Array | None:
            return values(name) if name in dataset and np.isfinite(dataset[name].values).any() else None

        def unit(name: str) -> str:
            return str(dataset[name].attrs.get("units", "")) if name in dataset.variables else ""

        names = {"deflection": "deflection", "setting": "setting", "load": load_name, "energy": "energy"}
        names |= {"stiffness": "stiffness", "adjusting": adjusting_name, "stress": "stress"}
        return MapTable(
            deflection=np.asarray(dataset["deflection"].values, float),
            setting=setting,
            status=np.atleast_2d(np.asarray(dataset["status"].values)).astype(np.int8),
            energy=values("energy"),
            load=values(load_name),
            stiffness=values("stiffness"),
            adjusting=optional(adjusting_name) if setting is not None else None,
            stress=optional("stress"),
            strength=_finite(float(dataset.attrs.get("strength", math.inf))),
            load_name=load_name,
            adjusting_name=adjusting_name,
            units={key: unit(name) for key, name in names.items()},
        )

    @property
    def ok(self) -> Mask:
        """Where the status is ok."""
        return np.asarray(self.status == Status.OK)

    @property
    def unbounded(self) -> bool:
        """Whether ok points have an infinite stress: one that the ideal shape does not bound."""
        return self.stress is not None and bool(np.isinf(self.stress[self.ok]).any())

    @property
    def rest(self) -> int:
        """Column of the deflection nearest to zero."""
        return int(np.argmin(np.abs(self.deflection)))

    def where(self, index: tuple[int, int]) -> str:
        """Place of a point, in the units that people read."""
        text = f"at deflection {spoken(self.deflection[index[1]], self.units['deflection'])}"
        if self.setting is not None:
            text += f", setting {spoken(self.setting[index[0]], self.units['setting'])}"
        return text


def spoken(value: float, unit: str) -> str:
    """Value in the unit that people read."""
    factor, name = {"rad": (180.0 / math.pi, "deg"), "m": (1e3, "mm")}.get(unit, (1.0, unit))
    return f"{value * factor:.4g} {name}"


def extreme(values: Array, mask: Mask, *, largest: bool = True) -> tuple[int, int] | None:
    """Index of the largest (or smallest) finite value under a mask; None where there is none."""
    usable = mask & np.isfinite(values)
    if not usable.any():
        return None
    keyed = np.where(usable, values if largest else -values, -np.inf)[:, ::-1]  # of equals, the positive deflection
    best = float(keyed.max())
    row, column = np.unravel_index(int(np.argmax(keyed >= best - 1e-9 * abs(best))), keyed.shape)
    return int(row), keyed.shape[1] - 1 - int(column)


def _finite(value: float) -> float | None:
    return value if math.isfinite(value) and value > 0.0 else None
