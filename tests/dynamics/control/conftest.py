"""Devices and an exact sampled plant for the tests of control."""

from __future__ import annotations

import math
from collections.abc import Callable
from typing import Any

import jax
import jax.numpy as jnp
import numpy as np
import pytest
from scipy.linalg import expm

from varistiff.actuators import Groove, RollerBeam, SliderLeafJoint, SmallDeflection, SwivellingPair
from varistiff.dynamics.control import Controller, Measured, Wanted
from varistiff.elastic.leaf import Leaf

Simulate = Callable[..., tuple[np.ndarray, np.ndarray]]


@pytest.fixture(scope="session")
def wang_joint() -> SliderLeafJoint:
    """The printed leaf and groove of Wang et al. (2024), Table 2, with the arc radius of the example."""
    groove = Groove(inner_radius=0.025, outer_radius=0.054, outer_angle=math.radians(47.0), arc_radius=0.0368)
    leaf = Leaf(youngs_modulus=206e9, width=0.025, thickness=0.001)
    return SliderLeafJoint(leaf=leaf, count=1, clamp_radius=0.025, theory=SmallDeflection(), groove=groove)


@pytest.fixture(scope="session")
def knee() -> RollerBeam:
    """A roller beam with a pivot at its clamp and no clearance: M = 3 E I theta/x_r at small angles."""
    beam = Leaf(youngs_modulus=194e9, width=0.02545, thickness=0.00316)
    return RollerBeam(beam=beam, rollers=SwivellingPair(offset=0.0, clearance=0.0))


@pytest.fixture(scope="session")
def simulate() -> Simulate:
    """Run a controller on x' = A x + B u + w with the command held between samples, exact at the samples.

    Returns the states (n + 1, states) and the commands (n,).
    """

    def run(
        controller: Controller,
        a: np.ndarray,
        b: np.ndarray,
        start: list[float],
        *,
        wanted: Callable[[Any], Wanted],
        period: float,
        samples: int,
        measure: Callable[[Any], Measured] = lambda x: Measured(x[0], x[2], 0.0),
        disturbance: list[float] | None = None,
    ) -> tuple[np.ndarray, np.ndarray]:
        states = a.shape[0]
        outside = np.zeros((states, 1)) if disturbance is None else np.array(disturbance)[:, None]
        whole = np.zeros((states + 2, states + 2))
        whole[:states] = np.hstack([a, b, outside])
        step = expm(whole * period)[:states]

        def advance(carry: Any, index: Any) -> Any:
            x, memory = carry
            command, memory = controller.sample(memory, measure(x), wanted(index * period), period)
            after = step @ jnp.concatenate([x, jnp.stack([command, jnp.asarray(1.0)])])
            return (after, memory), (after, command)

        x = jnp.asarray(start, dtype=float)
        memory = controller.start(measure(x), wanted(jnp.asarray(0.0)))
        loop = jax.jit(lambda carry: jax.lax.scan(advance, carry, jnp.arange(samples, dtype=float)))
        _, (path, commands) = loop((x, memory))
        return np.vstack([start, np.asarray(path)]), np.asarray(commands)

    return run
