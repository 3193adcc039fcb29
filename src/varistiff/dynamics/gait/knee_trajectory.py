"""The roller's place at each instant of a gait cycle, so that the spring carries the knee's moment."""

from __future__ import annotations

from dataclasses import dataclass

import jax
import jax.numpy as jnp
import numpy as np

from varistiff.actuators.actuator import Actuator
from varistiff.characteristic.evaluate import evaluate
from varistiff.core.errors import InputError
from varistiff.dynamics.gait.knee import KneeGait
from varistiff.dynamics.signals.limits import check_positive

_SETTINGS = 257  # over the travel, evenly in its logarithm; between them a straight line


@dataclass(frozen=True)
class KneeTrajectory:
    """What a roller that follows the knee's moment would do, instant by instant, without inertia.

    Parameters
    ----------
    time : over one cycle, the end left out [s]
    angle : deflection of the joint, the flexion [rad]
    wanted : extensor moment [N m]
    setting : that gives it, or comes nearest to it [m]
    load : of the spring there [N m]
    followed : where the setting gives the wanted moment; elsewhere the setting that comes nearest was taken
    """

    time: np.ndarray
    angle: np.ndarray
    wanted: np.ndarray
    setting: np.ndarray
    load: np.ndarray
    followed: np.ndarray

    @property
    def share(self) -> float:
        """Share of the cycle in which the moment can be followed."""
        return float(np.mean(self.followed))

    @property
    def error_rms(self) -> float:
        """Root of the mean square of load minus wanted moment [N m]."""
        return float(np.sqrt(np.mean((self.load - self.wanted) ** 2)))

    @property
    def error_max(self) -> float:
        """Largest magnitude of load minus wanted moment [N m]."""
        return float(np.max(np.abs(self.load - self.wanted)))


def knee_trajectory(
    actuator: Actuator,
    gait: KneeGait,
    *,
    body_mass: float,
    setting_min: float,
    setting_max: float,
    samples: int = 100,
) -> KneeTrajectory:
    """Return the setting x_r at which load(q, x_r) = M(t) at the knee angle q(t), for each instant.

    Where several settings give the moment, the one nearest to the setting before is taken; where none does, the one
    whose load comes nearest: an end of the travel, or a turning point of the load. The cycle is gone round twice, so
    that the first instant follows from the last.

    Parameters
    ----------
    actuator : semi-active, deflection = flexion [rad], setting a length
    gait : angle and moment per body mass
    body_mass : [kg]
    setting_min, setting_max : travel of the roller [m]
    samples : instants in a cycle

    Raises
    ------
    InputError : a travel that is none, or an instant at which no setting of the travel has a solution
    """
    check_positive("setting_min", setting_min, "m")
    if not setting_max > setting_min:
        raise InputError(f"is {setting_max!r} m; allowed is above setting_min", field="setting_max")
    time = np.arange(samples) * gait.cycle_duration / samples
    moment = gait.moment(body_mass)
    angle = np.asarray(jax.vmap(lambda now: gait.angle.at(now).value)(jnp.asarray(time)))
    wanted = np.asarray(jax.vmap(lambda now: moment.at(now).value)(jnp.asarray(time)))
    settings = np.geomspace(setting_min, setting_max, _SETTINGS)
    loads = evaluate(actuator, angle[:, None], settings[None, :]).load
    chosen, followed = np.empty(samples), np.empty(samples, dtype=bool)
    before = 0.5 * (setting_min + setting_max)
    for index in [*range(samples), *range(samples)]:
        before, followed[index] = _nearest(settings, loads[index], wanted[index], before)
        chosen[index] = before
    load = np.array(evaluate(actuator, angle, chosen).load)
    return KneeTrajectory(time, angle, wanted, chosen, load, followed)


def _nearest(settings: np.ndarray, loads: np.ndarray, wanted: float, before: float) -> tuple[float, bool]:
    """Setting with the wanted load that is nearest to the one before, or the setting whose load is nearest."""
    missing = loads - wanted
    if not np.isfinite(missing).any():
        raise InputError("the actuator has no solution at any setting of the travel", field="actuator")
    left, right = missing[:-1], missing[1:]
    crossing = np.flatnonzero((left * right <= 0.0) & (left != right))
    if crossing.size == 0:
        return float(settings[int(np.nanargmin(np.abs(missing)))]), False
    share = left[crossing] / (left[crossing] - right[crossing])
    roots = settings[crossing] + share * (settings[crossing + 1] - settings[crossing])
    return float(roots[int(np.argmin(np.abs(roots - before)))]), True
