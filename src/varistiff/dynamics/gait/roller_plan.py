"""A roller's course over the gait cycle that weighs the moment's error against electrical energy."""

from __future__ import annotations

from dataclasses import dataclass
from functools import partial
from typing import Any, NamedTuple

import jax
import jax.numpy as jnp
import numpy as np
from jaxtyping import Array, Float
from scipy.optimize import minimize

from varistiff.actuators.actuator import Actuator
from varistiff.dynamics.drives import Motor
from varistiff.dynamics.gait.knee import KneeGait
from varistiff.dynamics.gait.knee_trajectory import knee_trajectory
from varistiff.dynamics.signals import Samples

Vector = Float[Array, " n"]

_ROOM = 0.9  # share of current and voltage limit that a plan may use: the servo needs the rest
_HARD = 1.0  # price of exceeding a limit, per its square in A^2, V^2 and J^2, against (N m)^2
_INNER = 0.02  # share of the travel, on a logarithmic scale, that the first guess keeps from the ends


class Shuttle(NamedTuple):
    """What moves the roller: a motor with the ratio of gear and belt [rad/m] in ``gear_ratio``, and a mass [kg]."""

    motor: Motor
    mass: float


class _Cycle(NamedTuple):
    """The cycle at even instants: angle, its rate, wanted moment; and the Fourier matrices of value, rate, second."""

    angle: Vector
    rate: Vector
    wanted: Vector
    value: Array
    first: Array
    second: Array
    duration: float


class _Course(NamedTuple):
    """What follows from a course at all instants."""

    setting: Vector
    load: Vector
    current: Vector
    voltage: Vector
    power: Vector


@dataclass(frozen=True)
class RollerPlan:
    """A smooth periodic course of the roller and what it is expected to do, by inverse dynamics.

    Parameters
    ----------
    time : over one cycle, both ends [s]
    setting : of the roller [m]
    load, wanted : of the spring and of the knee [N m]
    electrical_energy : drawn by the motor in a cycle, below zero where it returns more [J]
    copper_energy : of that, heat in the winding [J]
    """

    time: np.ndarray
    setting: np.ndarray
    load: np.ndarray
    wanted: np.ndarray
    electrical_energy: float
    copper_energy: float

    @property
    def error_rms(self) -> float:
        """Root of the mean square of load minus wanted moment [N m]."""
        return float(np.sqrt(np.mean((self.load[:-1] - self.wanted[:-1]) ** 2)))

    def signal(self) -> Samples:
        """The course as a periodic signal of time [s] in m."""
        return Samples.through(list(self.time), list(self.setting), periodic=True)


def roller_plan(
    actuator: Actuator,
    gait: KneeGait,
    shuttle: Shuttle,
    *,
    body_mass: float,
    setting_min: float,
    setting_max: float,
    energy_weight: float = 1.0,
    harmonics: int = 12,
    samples: int = 100,
    iterations: int = 200,
) -> RollerPlan:
    """Return the course that minimises mean (load - M)^2 + weight * electrical energy, with current and voltage kept.

        F = (m + n^2 J) x'' + dV/dx - m x q'^2,    i = (F/n + friction)/k
        P = (dV/dx - m x q'^2 + n friction) x' + R i^2, without what goes into inertia and comes back

    The logarithm of the place is a logistic function of a Fourier series, so that it stays within the travel. Work that
    the joint would take from the walker beyond what the gait brakes, net, is priced too.

    Parameters
    ----------
    actuator, body_mass, setting_min, setting_max : see ``knee_trajectory``
    gait : angle and moment per body mass
    shuttle : motor and mass
    energy_weight : in (N m)^2/J; 0 asks for the moment alone
    harmonics : of the series; 12 reach 10 Hz in level walking
    samples : instants of a cycle, above twice the harmonics
    iterations : of the search (L-BFGS), which ends in a local minimum near the static trajectory

    Notes
    -----
    The gear is taken as ideal and the winding as cold; the simulation has both. The device: dos Santos and Richter
    (2019), doi 10.3390/act8010012.
    """
    static = knee_trajectory(
        actuator, gait, body_mass=body_mass, setting_min=setting_min, setting_max=setting_max, samples=samples
    )
    cycle = _cycle(gait, static.time, static.wanted, harmonics)
    ends = (setting_min, setting_max)
    start = _series(static.setting, ends, cycle)
    course = partial(_course, actuator=actuator, shuttle=shuttle, cycle=cycle, ends=ends)
    cost = jax.jit(jax.value_and_grad(lambda y: _cost(course(y), shuttle.motor, cycle, energy_weight)))

    def judged(y: np.ndarray) -> tuple[float, np.ndarray]:
        value, slope = cost(jnp.asarray(y))
        finite = bool(jnp.isfinite(value)) and bool(jnp.isfinite(slope).all())
        return (float(value), np.asarray(slope)) if finite else (1e9, np.zeros_like(y))  # turns the line search back

    found = minimize(judged, start, jac=True, method="L-BFGS-B", options={"maxiter": iterations})
    best = jax.jit(course)(jnp.asarray(found.x))
    return _plan(best, static.time, cycle, shuttle.motor)


def _cycle(gait: KneeGait, time: np.ndarray, wanted: np.ndarray, harmonics: int) -> _Cycle:
    angle = jax.vmap(gait.angle.at)(jnp.asarray(time))
    order = np.arange(1, harmonics + 1)
    rate = 2.0 * np.pi * order / gait.cycle_duration
    phase = np.outer(time, rate)
    sine, cosine = np.sin(phase), np.cos(phase)
    still = np.zeros((time.size, 1))
    return _Cycle(
        angle=angle.value,
        rate=angle.rate,
        wanted=jnp.asarray(wanted),
        value=jnp.asarray(np.hstack([still + 1.0, cosine, sine])),
        first=jnp.asarray(np.hstack([still, -rate * sine, rate * cosine])),
        second=jnp.asarray(np.hstack([still, -(rate**2) * cosine, -(rate**2) * sine])),
        duration=gait.cycle_duration,
    )


def _series(setting: np.ndarray, ends: tuple[float, float], cycle: _Cycle) -> np.ndarray:
    """Fourier coefficients of a course that comes near a static one."""
    share = np.clip(np.log(setting / ends[0]) / np.log(ends[1] / ends[0]), _INNER, 1.0 - _INNER)
    return np.asarray(np.linalg.lstsq(np.asarray(cycle.value), np.log(share / (1.0 - share)), rcond=None)[0])


def _course(y: Vector, *, actuator: Actuator, shuttle: Shuttle, cycle: _Cycle, ends: tuple[float, float]) -> _Course:
    motor, span = shuttle.motor, jnp.log(ends[1] / ends[0])

    def place(value: Any) -> Any:
        return ends[0] * jnp.exp(span * jax.nn.sigmoid(value))

    def moving(value: Any, first: Any, second: Any) -> Any:
        def along(time: Any) -> Any:
            return place(value + first * time + 0.5 * second * time**2)

        speed = jax.grad(along)
        return along(0.0), speed(0.0), jax.grad(speed)(0.0)

    setting, speed, acceleration = jax.vmap(moving)(cycle.value @ y, cycle.first @ y, cycle.second @ y)
    response, _ = jax.vmap(actuator.respond)(cycle.angle, setting)
    inertia = shuttle.mass + motor.reflected_inertia
    force = inertia * acceleration + response.adjusting_load - shuttle.mass * setting * cycle.rate**2
    rotor = motor.gear_ratio * speed
    friction = motor.friction_torque * jnp.tanh(rotor / motor.smoothing_rate) + motor.viscous_friction * rotor
    current = (force / motor.gear_ratio + friction) / motor.torque_constant
    voltage = motor.resistance * current + motor.torque_constant * rotor
    # a cycle gives back what it puts into inertia: left out, so that too few instants cannot make energy of it
    steady = force - inertia * acceleration
    power = steady * speed + friction * rotor + motor.resistance * current**2
    return _Course(setting, response.load, current, voltage, power)


def _cost(course: _Course, motor: Motor, cycle: _Cycle, weight: float) -> Any:
    energy = cycle.duration * jnp.mean(course.power)
    braked = cycle.duration * jnp.mean(course.load * cycle.rate)
    allowed = jnp.maximum(cycle.duration * jnp.mean(cycle.wanted * cycle.rate), 0.0)
    beyond = (
        jnp.mean(_over(course.current, motor.current_limit))
        + jnp.mean(_over(course.voltage, motor.voltage_limit))
        + jnp.maximum(braked - allowed, 0.0) ** 2
    )
    return jnp.mean((course.load - cycle.wanted) ** 2) + weight * energy + _HARD * beyond


def _over(value: Vector, limit: float) -> Vector:
    """Square of what exceeds the share of a limit that a plan may use."""
    return jnp.maximum(jnp.abs(value) - min(_ROOM * limit, 1e12), 0.0) ** 2  # finite where there is no limit


def _plan(course: _Course, time: np.ndarray, cycle: _Cycle, motor: Motor) -> RollerPlan:
    def closed(values: Any) -> np.ndarray:
        return np.append(np.asarray(values), float(values[0]))

    return RollerPlan(
        time=np.append(time, cycle.duration),
        setting=closed(course.setting),
        load=closed(course.load),
        wanted=closed(cycle.wanted),
        electrical_energy=float(cycle.duration * jnp.mean(course.power)),
        copper_energy=float(cycle.duration * jnp.mean(motor.resistance * course.current**2)),
    )
