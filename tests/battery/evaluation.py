"""Compiled access to an actuator's energy and response, shared by all devices of one structure."""

from __future__ import annotations

import equinox as eqx
import jax
import jax.numpy as jnp
import numpy as np
from numpy.typing import NDArray

from varistiff.actuators import Actuator, Response
from varistiff.characteristic.evaluate import evaluate

Floats = NDArray[np.float64]


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
    return jax.tree.map(lambda leaf: jnp.asarray(leaf) if isinstance(leaf, float) else leaf, actuator)


def energy(actuator: Actuator, deflection: Floats, setting: Floats) -> Floats:
    """V [J] at points."""
    return np.asarray(_energy(traced(actuator), jnp.asarray(deflection), jnp.asarray(setting)))


def energy_gradient(actuator: Actuator, deflection: Floats, setting: Floats) -> tuple[Floats, Floats]:
    """Both first derivatives of V by automatic differentiation."""
    along, across = _gradient(traced(actuator), jnp.asarray(deflection), jnp.asarray(setting))
    return np.asarray(along), np.asarray(across)


def respond(actuator: Actuator, deflection: Floats, setting: Floats) -> dict[str, Floats]:
    """Fields of the response and the details by name, on the way that a user takes."""
    points = evaluate(actuator, deflection, setting)
    return {**{name: getattr(points, name) for name in Response._fields}, **points.details}


def statuses(actuator: Actuator, points: list[tuple[float, float]]) -> list[int]:
    """Status per point."""
    deflection, setting = np.array(points).T
    return [int(value) for value in respond(actuator, deflection, setting)["status"]]
