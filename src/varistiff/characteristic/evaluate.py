"""Evaluate an actuator at points, in blocks of one size so that each kind is compiled once."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass, field

import numpy as np
from numpy.typing import ArrayLike

from varistiff.actuators.actuator import Actuator, Response
from varistiff.actuators.compiled import BLOCK, respond_block
from varistiff.core.errors import InputError
from varistiff.core.status import Status

Progress = Callable[[int, int], None]


@dataclass(frozen=True, repr=False)
class Points:
    """Response at points as NumPy arrays of one shape, SI units; see ``Response`` for the meaning.

    ``details`` holds the numbers that only this kind has, by name.
    """

    deflection: np.ndarray
    setting: np.ndarray
    status: np.ndarray
    energy: np.ndarray
    load: np.ndarray
    stiffness: np.ndarray
    adjusting_load: np.ndarray
    stress: np.ndarray
    details: dict[str, np.ndarray] = field(default_factory=dict)

    def __repr__(self) -> str:
        shape = " x ".join(str(n) for n in self.status.shape) or "1"
        counts = ", ".join(f"{count} {status.label}" for status, count in self.counts().items())
        names = ", ".join(("energy", "load", "stiffness", "adjusting_load", "stress", *self.details))
        return f"<Points {shape}: {counts or 'none'}; {names}>"

    def counts(self) -> dict[Status, int]:
        """Number of points per status, statuses that occur only."""
        values, numbers = np.unique(self.status, return_counts=True)
        return {Status(int(v)): int(n) for v, n in zip(values, numbers, strict=True)}


def evaluate(
    actuator: Actuator,
    deflection: ArrayLike,
    setting: ArrayLike | None = None,
    *,
    progress: Progress | None = None,
) -> Points:
    """Response of ``actuator`` at points.

    Parameters
    ----------
    deflection : [rad] for a joint, [m] for a linear device
    setting : [m] or [rad], broadcast against deflection; may be left out for a kind without one
    progress : called with (points done, points in all) after each block

    Returns
    -------
    Points of the broadcast shape.

    Raises
    ------
    InputError : a value is not finite, the shapes do not broadcast, or a needed setting is missing.
    """
    d, s = _broadcast(actuator, deflection, setting)
    shape, total = d.shape, d.size
    flat_d, flat_s = d.ravel(), s.ravel()
    blocks = []
    for start in range(0, max(total, 1), BLOCK):
        stop = min(start + BLOCK, total)
        blocks.append(respond_block(actuator, flat_d[start:stop], flat_s[start:stop]))
        if progress is not None:
            progress(stop, total)
    numbers = {
        name: np.concatenate([getattr(response, name) for response, _ in blocks]).reshape(shape)
        for name in Response._fields
    }
    extra = {name: np.concatenate([details[name] for _, details in blocks]).reshape(shape) for name in blocks[0][1]}
    echoed = s if actuator.setting_unit is not None or setting is not None else np.full(shape, np.nan)
    return Points(deflection=d, setting=echoed, details=extra, **numbers)


def _broadcast(actuator: Actuator, deflection: ArrayLike, setting: ArrayLike | None) -> tuple[np.ndarray, np.ndarray]:
    if setting is None:
        if actuator.setting_unit is not None:
            raise InputError(f"a {actuator.kind} needs a setting in {actuator.setting_unit}", field="setting")
        setting = 0.0
    columns = {"deflection": _numbers("deflection", deflection), "setting": _numbers("setting", setting)}
    for name, values in columns.items():
        if not np.isfinite(values).all() and not (name == "setting" and actuator.setting_unit is None):
            raise InputError("must be finite; NaN and infinity are not points of a map", field=name)
    try:
        d, s = np.broadcast_arrays(columns["deflection"], columns["setting"])
    except ValueError:
        shapes = " and ".join(f"{name} {values.shape}" for name, values in columns.items())
        raise InputError(f"shapes must broadcast: {shapes}") from None
    return d, s


def _numbers(name: str, values: ArrayLike) -> np.ndarray:
    try:
        return np.asarray(values, float)
    except (TypeError, ValueError):
        raise InputError("takes numbers in SI units; quantities as text belong into design files", field=name) from None
