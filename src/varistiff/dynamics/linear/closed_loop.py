"""Poles of the sampled control loop: whether small motions about rest die out."""

from __future__ import annotations

import dataclasses
import math
from dataclasses import dataclass
from typing import Any

import equinox as eqx
import jax
import jax.numpy as jnp
import numpy as np
from jax.flatten_util import ravel_pytree
from jaxtyping import Array, Float
from scipy.linalg import expm

from varistiff.characteristic.evaluate import evaluate
from varistiff.core.errors import InputError
from varistiff.core.status import Status
from varistiff.dynamics.control import Encoder, Pid, ScheduledLqr, Wanted
from varistiff.dynamics.control_loop import ControlLoop
from varistiff.dynamics.linear.equilibrium import Equilibrium
from varistiff.dynamics.linear.matrices import Matrices, plant_matrices
from varistiff.dynamics.linear.numbers_as_arrays import numbers_as_arrays
from varistiff.dynamics.linear.rest import rest
from varistiff.dynamics.linear.state_at import first_load, standing, start_of
from varistiff.dynamics.linear.without_dry_friction import without_dry_friction
from varistiff.dynamics.plant import Plant
from varistiff.dynamics.program import Case
from varistiff.dynamics.state import Motion

_MARGIN = 1e-6  # a double pole at 1, of a joint that nothing holds, is found to about 1e-8


@dataclass(frozen=True)
class ClosedLoop:
    """Poles of a sampled loop.

    Parameters
    ----------
    poles : (n,) in the z-plane, of the motion over one interval, largest magnitude first
    interval : [s], after which all controllers have been sampled: the period, or a multiple of it
    """

    poles: np.ndarray
    interval: float

    @property
    def growth_rates(self) -> np.ndarray:
        """log|z|/interval [1/s] of each pole: motions grow or decay as exp(rate t); -inf for a pole at 0."""
        with np.errstate(divide="ignore"):
            return np.log(np.abs(self.poles)) / self.interval

    @property
    def growth_rate(self) -> float:
        """Largest growth rate [1/s]; -inf where nothing moves."""
        return float(np.max(self.growth_rates, initial=-math.inf))

    @property
    def unstable(self) -> bool:
        """Whether a pole lies outside the unit circle by more than rounding makes of a multiple pole at 1."""
        return bool(np.max(np.abs(self.poles), initial=0.0) > 1.0 + _MARGIN)


def closed_loop(case: Case) -> ClosedLoop:
    """Linear sampled loop about rest at the start.

    The plant between two samples is its exact solution under held commands, exp(A T); the controllers are
    differentiated as they are, with their memories, delays and sample rates, but without their torque limits. Encoders
    are ideal: a quantiser has the derivative 0 almost everywhere. What is wanted is the rest itself. Dry friction and
    gear losses are left out, which errs towards too little damping. Memory that does not both feel and drive the motion
    (an integral part with no gain) is no part of the loop.

    Where no rest is found, the loop is linearised where it starts, at zero rates; the poles are NaN off the map.

    Notes
    -----
    Astrom and Wittenmark (1997), Computer-Controlled Systems, sections 2.3 and 3.2.
    """
    smooth = numbers_as_arrays(dataclasses.replace(case, plant=without_dry_friction(case.plant)))
    at = _rest_or_start(case)
    matrices = plant_matrices(smooth.plant, at.motion, external_torque=at.external_torque)
    loop = dataclasses.replace(_without_limits(smooth.loop), encoders=(Encoder(), Encoder(), Encoder()))
    channels = [channel.every for channel in (loop.drive, loop.setting) if channel is not None]
    count = math.lcm(*channels) if channels else 1
    if not matrices.states:
        return ClosedLoop(np.zeros(0, complex), count * float(case.period))
    if not np.isfinite(matrices.a).all():
        return ClosedLoop(np.full(len(matrices.states), np.nan, complex), count * float(case.period))
    held = _zero_order_hold(matrices, float(case.period))
    period, wanted = jnp.asarray(case.period), numbers_as_arrays(_wanted(case.plant, at.motion))
    factors = [
        np.asarray(_factor(loop, *held, at.motion, wanted, period, jnp.asarray(float(index)), matrices.states))
        for index in range(count)
    ]
    product = np.linalg.multi_dot(factors[::-1]) if count > 1 else factors[0]
    kept = _in_the_loop(np.sum(np.abs(factors), axis=0), len(matrices.states))
    poles = np.linalg.eigvals(product[np.ix_(kept, kept)])
    return ClosedLoop(poles[np.argsort(-np.abs(poles))], count * float(case.period))


def closed_loop_poles(case: Case) -> np.ndarray:
    """Poles of the sampled loop in the z-plane, largest magnitude first; see ``closed_loop``."""
    return closed_loop(case).poles


def _rest_or_start(case: Case) -> Equilibrium:
    try:
        return rest(case)
    except InputError:
        start = start_of(case)
        still = standing(float(start.link), float(start.drive), float(start.motion))
        return Equilibrium(still, first_load(case), 0.0, 0.0, math.nan, (), np.zeros((0, 0)), Status.OK)


def _zero_order_hold(matrices: Matrices, period: float) -> tuple[Array, Array]:
    """Exact transition over a period and response to commands held over it; zero columns for drives without effect."""
    size = len(matrices.states)
    b = np.zeros((size, 2))
    for column, name in enumerate(("drive_command", "setting_command")):
        if name in matrices.inputs:
            b[:, column] = matrices.b[:, matrices.inputs.index(name)]
    whole = np.zeros((size + 2, size + 2))
    whole[:size, :size], whole[:size, size:] = matrices.a, b
    moved = expm(whole * period)
    return jnp.asarray(moved[:size, :size]), jnp.asarray(moved[:size, size:])


def _without_limits(loop: ControlLoop) -> ControlLoop:
    """The loop with controllers that never saturate: at a limit the derivative would be that of an open loop."""

    def limited(value: object) -> bool:
        return isinstance(value, Pid | ScheduledLqr)

    def unlimited(value: Any) -> Any:
        return dataclasses.replace(value, limit=np.asarray(math.inf)) if limited(value) else value

    opened: ControlLoop = jax.tree.map(unlimited, loop, is_leaf=limited)
    return opened


def _wanted(plant: Plant, motion: Motion) -> Wanted:
    """What is asked of a joint that rests where it is asked to: the position, stiffness and torque that it has."""
    at = np.array([float(plant.stretch(motion))]), np.array([float(plant.setting_path.at(motion.motion).value)])
    points = evaluate(plant.actuator, *at)
    stiffness, load = (float(np.nan_to_num(values[0])) for values in (points.stiffness, points.load))
    return Wanted(position=motion.link, stiffness=stiffness, torque=load if plant.driven else -load)


@eqx.filter_jit
def _factor(
    loop: ControlLoop,
    moves: Float[Array, "n n"],
    answers: Float[Array, "n 2"],
    motion: Motion,
    wanted: Wanted,
    period: Float[Array, ""],
    index: Float[Array, ""],
    states: tuple[str, ...],
) -> Float[Array, "m m"]:
    """Jacobian of one period of control and plant, x' = moves x + answers u, over the free states and memories."""
    memory = loop.start(motion, wanted)
    base = jnp.array([getattr(motion, name) for name in states])
    start, unravel = ravel_pytree((base, memory))

    def advance(vector: Float[Array, " m"]) -> Float[Array, " m"]:
        x, held = unravel(vector)
        now = motion._replace(**dict(zip(states, x, strict=True)))
        command, held = loop.sample(held, now, wanted, index, period)
        x = moves @ x + answers @ jnp.stack([command.drive, command.setting])
        return ravel_pytree((x, held))[0]

    jacobian: Float[Array, "m m"] = jax.jacfwd(advance)(start)
    return jacobian


def _in_the_loop(influence: np.ndarray, states: int) -> np.ndarray:
    """Indices of the motion and of the memory that both feels it and drives it, by the pattern of the Jacobian."""
    size = influence.shape[0]
    reaches = (influence != 0.0) | np.eye(size, dtype=bool)
    for _ in range(size.bit_length()):
        reaches = reaches.astype(int) @ reaches.astype(int) > 0
    feels = reaches[:, :states].any(axis=1)
    drives = reaches[:states, :].any(axis=0)
    return np.flatnonzero(feels & drives)
