"""Compiled access to an actuator's energy and response, shared by all devices of one structure."""

from __future__ import annotations

from collections.abc import Iterator

import equinox as eqx
import jax
import jax.numpy as jnp
import numpy as np
from numpy.typing import NDArray

from varistiff.actuators import Actuator, Response
from varistiff.characteristic.evaluate import evaluate

Floats = NDArray[np.float64]
BATCH = 24  # one shape, compiled once


@eqx.filter_jit
def _energy(actuator: Actuator, deflection: jax.Array, setting: jax.Array) -> jax.Array:
    return actuator.energy(deflection, setting)


@eqx.filter_jit
def _gradient(actuator: Actuator, deflection: jax.Array, setting: jax.Array) -> tuple[jax.Array, jax.Array]:
    def one(d: jax.Array, s: jax.Array) -> jax.Array:
        return actuator.energy(d, s).sum()  # points do not mix: the gradient of the sum is elementwise

    along, across = jax.grad(one, argnums=(0, 1))(deflection, setting)
    return along, across


def traced(actuator: Actuator) -> Actuator:
    """The same device with arrays for its numbers: compiled once for all parameter values."""
    device: Actuator = jax.tree.map(lambda leaf: jnp.asarray(leaf) if isinstance(leaf, float) else leaf, actuator)
    return device


def _batches(deflection: Floats, setting: Floats) -> Iterator[tuple[jax.Array, jax.Array, int]]:
    """Batches of one size, the last one filled up, and how many points of each count."""
    for start in range(0, len(deflection), BATCH):
        parts = [values[start : start + BATCH] for values in (deflection, setting)]
        count = len(parts[0])
        full = [np.append(part, np.full(BATCH - count, part[-1])) for part in parts]
        yield jnp.asarray(full[0]), jnp.asarray(full[1]), count


def energy(actuator: Actuator, deflection: Floats, setting: Floats) -> Floats:
    """V [J] at points."""
    device = traced(actuator)
    batches = _batches(deflection, setting)
    return np.concatenate([np.asarray(_energy(device, d, s))[:count] for d, s, count in batches])


def energy_gradient(actuator: Actuator, deflection: Floats, setting: Floats) -> tuple[Floats, Floats]:
    """Both first derivatives of V by automatic differentiation."""
    device = traced(actuator)
    parts = [
        np.stack([np.asarray(side)[:count] for side in _gradient(device, d, s)])
        for d, s, count in _batches(deflection, setting)
    ]
    along, across = np.concatenate(parts, axis=1)
    return along, across


def respond(actuator: Actuator, deflection: Floats, setting: Floats) -> dict[str, Floats]:
    """Fields of the response and the details by name, on the way that a user takes."""
    points = evaluate(actuator, deflection, setting)
    return {**{name: getattr(points, name) for name in Response._fields}, **points.details}


def statuses(actuator: Actuator, points: list[tuple[float, float]]) -> list[int]:
    """Status per point."""
    deflection, setting = np.array(points).T
    return [int(value) for value in respond(actuator, deflection, setting)["status"]]
