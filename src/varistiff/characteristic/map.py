"""The map of an actuator over deflection and setting as a labelled dataset."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import ArrayLike

from varistiff.actuators.actuator import Actuator
from varistiff.characteristic.evaluate import Points, Progress, evaluate
from varistiff.characteristic.provenance import provenance
from varistiff.core.status import Status

if TYPE_CHECKING:
    import xarray as xr


def characteristic_map(
    actuator: Actuator,
    *,
    deflection: ArrayLike,
    setting: ArrayLike | None = None,
    attrs: dict[str, str] | None = None,
    progress: Progress | None = None,
) -> xr.Dataset:
    """Evaluate on the grid deflection x setting.

    Parameters
    ----------
    deflection : grid, shape (n,) [rad] or [m]
    setting : grid, shape (m,) [m] or [rad]; None for a kind without a setting
    attrs : added to the dataset's attributes: title, design, design_hash ...
    progress : see ``evaluate``

    Returns
    -------
    Dataset with dimensions (setting, deflection), or (deflection,) for a kind without a setting: status as CF flags,
    energy, torque or force, stiffness, adjusting_force or adjusting_torque, stress, the kind's details, and the
    actuator's constants as variables without a dimension.
    """
    import xarray as xr

    d = np.asarray(deflection, float)
    s = None if setting is None else np.asarray(setting, float)
    dims: tuple[str, ...]
    if s is None:
        dims, points = ("deflection",), evaluate(actuator, d, progress=progress)
    else:
        dims = ("setting", "deflection")
        points = evaluate(actuator, d[None, :], s[:, None], progress=progress)
    angular = actuator.deflection_unit == "rad"
    coords: dict[str, Any] = {
        "deflection": (
            "deflection",
            d,
            _about("deflection" if not angular else "deflection angle", actuator.deflection_unit),
        )
    }
    if s is not None:
        coords["setting"] = (
            "setting",
            s,
            _about("setting of the stiffness drive", str(actuator.setting_unit)),
        )
    variables: dict[str, Any] = {
        name: (dims, values, about) for name, (values, about) in _variables(actuator, points).items()
    }
    for name, constant in actuator.constants.items():
        about = dict(_about(constant.long_name, constant.unit), **({"comment": constant.note} if constant.note else {}))
        variables[name] = ((), constant.value, about)
    return xr.Dataset(variables, coords, {**provenance(actuator), **(attrs or {})})


def load_name(actuator: Actuator) -> str:
    """``torque`` for a joint, ``force`` for a linear device."""
    return "torque" if actuator.deflection_unit == "rad" else "force"


def adjusting_name(actuator: Actuator) -> str:
    """``adjusting_torque`` where the setting is an angle, else ``adjusting_force``."""
    return "adjusting_torque" if actuator.setting_unit == "rad" else "adjusting_force"


def _about(long_name: str, units: str) -> dict[str, str]:
    return {"long_name": long_name, "units": units}


def _variables(actuator: Actuator, points: Points) -> dict[str, tuple[np.ndarray, dict[str, object]]]:
    joint = actuator.deflection_unit == "rad"
    flags: dict[str, object] = {
        "long_name": "status of the point",
        "flag_values": np.array([int(s) for s in Status], np.int8),
        "flag_meanings": " ".join(s.label for s in Status),
        "units": "1",
    }
    held = "N*m" if actuator.setting_unit == "rad" else "N"
    variables: dict[str, tuple[np.ndarray, dict[str, object]]] = {
        "status": (points.status.astype(np.int8), flags),
        "energy": (points.energy, dict(_about("elastic energy", "J"))),
        load_name(actuator): (points.load, dict(_about(load_name(actuator), "N*m" if joint else "N"))),
        "stiffness": (points.stiffness, dict(_about("tangent stiffness", "N*m/rad" if joint else "N/m"))),
        adjusting_name(actuator): (
            points.adjusting_load,
            dict(_about(adjusting_name(actuator).replace("_", " "), held)),
        ),
        "stress": (points.stress, dict(_about("largest stress in the elastic element", "Pa"))),
    }
    for name, values in points.details.items():
        quantity = actuator.details[name]
        variables[name] = (values, dict(_about(quantity.long_name, quantity.unit)))
    return variables
