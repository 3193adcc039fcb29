"""A characteristic map as the figures need it: plain arrays, units for people, and a choice of curves."""

from __future__ import annotations

import math
from dataclasses import dataclass

import numpy as np
import numpy.typing as npt
import xarray as xr

from varistiff.core.status import Status
from varistiff.report.display import Display, display

Array = npt.NDArray[np.float64]
Mask = npt.NDArray[np.bool_]

SETTING_NAMES = {
    "antagonistic_leaves": "Nut distance",
    "maccepa": "Pretension",
    "roller_beam": "Roller position",
    "slider_leaf_joint": "Active length",
    "torsion_tube": "Active length",
}


@dataclass(frozen=True)
class Field:
    """One variable of the map in SI, shape (setting, deflection), and the unit to show it in."""

    values: Array
    display: Display
    title: str

    @property
    def shown(self) -> Array:
        """Values in the unit that is shown."""
        return self.values * self.display.factor

    @property
    def label(self) -> str:
        """Axis label with its unit in brackets."""
        return f"{self.title} [{self.display.unit}]" if self.display.unit else self.title


@dataclass(frozen=True)
class View:
    """Axes and statuses of a map; a kind without a setting has one row and ``setting`` None."""

    dataset: xr.Dataset
    deflection: Array
    setting: Array | None
    status: npt.NDArray[np.int8]

    @staticmethod
    def of(dataset: xr.Dataset) -> View:
        """Wrap a characteristic map."""
        return View(
            dataset=dataset,
            deflection=np.asarray(dataset["deflection"].values, float),
            setting=np.asarray(dataset["setting"].values, float) if "setting" in dataset.dims else None,
            status=np.atleast_2d(np.asarray(dataset["status"].values)).astype(np.int8),
        )

    @property
    def ok(self) -> Mask:
        """Where the status is ok."""
        return np.asarray(self.status == Status.OK)

    @property
    def statuses(self) -> list[Status]:
        """Statuses that occur, in the order of the contract."""
        present = set(np.unique(self.status).tolist())
        return [status for status in Status if int(status) in present]

    @property
    def load_name(self) -> str:
        """Name of the load's variable: torque of a joint, force of a linear device."""
        return "torque" if "torque" in self.dataset else "force"

    @property
    def adjusting_name(self) -> str:
        """Name of the adjusting load's variable."""
        return "adjusting_torque" if "adjusting_torque" in self.dataset else "adjusting_force"

    @property
    def strength(self) -> float | None:
        """What the stress is held against [Pa]; None where the design gives none."""
        value = float(self.dataset.attrs.get("strength", math.inf))
        return value if math.isfinite(value) and value > 0.0 else None

    @property
    def unbounded_stress(self) -> bool:
        """Whether ok points have an infinite stress: one that the ideal shape does not bound."""
        stress = np.atleast_2d(np.asarray(self.dataset["stress"].values, float))
        return bool(np.isinf(stress[self.ok]).any())

    @property
    def deflection_display(self) -> Display:
        """Unit that deflections are shown in."""
        return display(str(self.dataset["deflection"].attrs.get("units", "rad")))

    @property
    def setting_display(self) -> Display:
        """Unit that settings are shown in."""
        return display(str(self.dataset["setting"].attrs.get("units", "m")) if self.setting is not None else "1")

    @property
    def deflection_label(self) -> str:
        """Label of the deflection axis."""
        return f"Deflection [{self.deflection_display.unit}]"

    @property
    def setting_label(self) -> str:
        """Label of the setting axis, by the name that the kind's setting goes by."""
        return f"{self.setting_name} [{self.setting_display.unit}]"

    @property
    def setting_name(self) -> str:
        """What the stiffness drive moves, capitalised."""
        if self.setting_display.unit == "deg":
            return "Disc angle"
        return SETTING_NAMES.get(str(self.dataset.attrs.get("kind", "")), "Setting")

    @property
    def x(self) -> Array:
        """Deflections in the unit that is shown."""
        return self.deflection * self.deflection_display.factor

    @property
    def y(self) -> Array:
        """Settings in the unit that is shown."""
        if self.setting is None:
            return np.zeros(1)
        return self.setting * self.setting_display.factor

    def field(self, name: str, title: str) -> Field | None:
        """Variable of the map by name; None where the map has no finite number of it."""
        if name not in self.dataset:
            return None
        values = np.atleast_2d(np.asarray(self.dataset[name].values, float))
        finite = np.isfinite(values)
        if not finite.any():
            return None
        telling = finite & self.ok if (finite & self.ok).any() else finite
        unit = display(str(self.dataset[name].attrs.get("units", "1")), float(np.abs(values[telling]).max()))
        return Field(values, unit, title)

    @property
    def rest(self) -> int:
        """Column of the deflection nearest to zero."""
        return int(np.argmin(np.abs(self.deflection)))

    def some_settings(self, count: int) -> list[int]:
        """Rows whose curves lie well apart: spread half by setting and half by the logarithm of stiffness."""
        stiffness = np.atleast_2d(np.asarray(self.dataset["stiffness"].values, float))
        usable = np.isfinite(stiffness) & (self.ok if self.ok.any() else True)
        rows = np.flatnonzero(usable.any(axis=1))
        if rows.size < 2:
            return rows.tolist() or [0]
        level = np.array([np.median(np.abs(stiffness[row, usable[row]])) for row in rows])
        travel = np.cumsum(np.abs(np.diff(np.log(np.maximum(level, 1e-300)), prepend=np.log(max(level[0], 1e-300)))))
        position = (rows - rows[0]) / (rows[-1] - rows[0])
        if travel[-1] > 0.0:
            position = 0.5 * position + 0.5 * travel / travel[-1]
        chosen = np.searchsorted(position, np.linspace(0.0, 1.0, count) - 1e-12)
        return sorted({int(rows[min(place, rows.size - 1)]) for place in chosen})

    def some_deflections(self, count: int) -> list[int]:
        """Columns from rest to the last ok deflection, on the side of the map that has more ok points."""
        after, before = int(self.ok[:, self.rest :].sum()), int(self.ok[:, : self.rest + 1].sum())
        good = np.flatnonzero(self.ok.any(axis=0))
        end = self.deflection.size - 1
        if good.size:
            end = int(good.max() if after >= before else good.min())
        columns = np.round(np.linspace(self.rest, end, count)).astype(int).tolist()
        return sorted(set(columns), key=lambda column: abs(column - self.rest))

    def setting_text(self, row: int) -> str:
        """Setting of a row with its unit."""
        return self.setting_display.text(None if self.setting is None else float(self.setting[row]))

    def deflection_text(self, column: int) -> str:
        """Deflection of a column with its unit."""
        return self.deflection_display.text(float(self.deflection[column]))
