"""Evaluate an actuator at points, in blocks of one size so that each kind is compiled once."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass, field
from functools import lru_cache
from typing import Any

import equinox as eqx
import jax
import jax.numpy as jnp
import numpy as np
from numpy.typing import ArrayLike

from varistiff.actuators.actuator import Actuator
from varistiff.core.errors import InputError
from varistiff.core.status import Status

BLOCK = 4096

Progress = Callable[[int, int], None]


@dataclass(frozen=True)
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

    def counts(self) -> dict[Status, int]:
        """Number of points per status, statuses that occur only."""
        values, numbers = np.unique(self.status, return_counts=True)
        return {Status(int(v)): int(n) for v, n in zip(values, numbers, strict=True)}


@lru_cache(maxsize=1)
def _compiled() -> Callable[..., Any]:
    return eqx.filter_jit(lambda actuator, deflection, setting: actuator.respond(deflection, setting))


def _as_arrays(actuator: Actuator) -> Actuator:
    """Parameters as arrays, so that another design of the same kind needs no compilation."""
    return jax.tree.map(lambda leaf: jnp.asarray(leaf) if isinstance(leaf, float) else leaf, actuator)


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
    solve, parameters = _compiled(), _as_arrays(actuator)
    blocks = []
    for start in range(0, max(total, 1), BLOCK):
        stop = min(start + BLOCK, total)
        response, details = solve(parameters, _padded(flat_d[start:stop]), _padded(flat_s[start:stop]))
        blocks.append((stop - start, response, details))
        if progress is not None:
            progress(stop, total)

    def joined(pick: Callable[[Any, Any], Any]) -> np.ndarray:
        parts = [np.asarray(pick(response, details))[:count] for count, response, details in blocks]
        return np.concatenate(parts).reshape(shape)

    numbers = {name: joined(lambda r, _, name=name: getattr(r, name)) for name in blocks[0][1]._fields}
    extra = {name: joined(lambda _, e, name=name: e[name]) for name in blocks[0][2]}
    echoed = s if actuator.setting_unit is not None or setting is not None else np.full(shape, np.nan)
    return Points(deflection=d, setting=echoed, details=extra, **numbers)


def _broadcast(
    actuator: Actuator, deflection: ArrayLike, setting: ArrayLike | None
) -> tuple[np.ndarray, np.ndarray]:
    if setting is None:
        if actuator.setting_unit is not None:
            raise InputError(f"a {actuator.kind} needs a setting in {actuator.setting_unit}", field="setting")
        setting = 0.0
    columns = {"deflection": np.asarray(deflection, float), "setting": np.asarray(setting, float)}
    for name, values in columns.items():
        if not np.isfinite(values).all() and not (name == "setting" and actuator.setting_unit is None):
            raise InputError("must be finite; NaN and infinity are not points of a map", field=name)
    try:
        d, s = np.broadcast_arrays(columns["deflection"], columns["setting"])
    except ValueError:
        shapes = " and ".join(f"{name} {values.shape}" for name, values in columns.items())
        raise InputError(f"shapes must broadcast: {shapes}") from None
    return d, s


def _padded(values: np.ndarray) -> np.ndarray:
    """One block, filled up with its last value."""
    if values.size == BLOCK:
        return values
    fill = values[-1] if values.size else 0.0
    return np.concatenate([values, np.full(BLOCK - values.size, fill)])
