"""A motor geared straight to the knee: what it returns in a step by Richter's law, as a yardstick."""

from __future__ import annotations

from dataclasses import dataclass

import jax
import jax.numpy as jnp

from varistiff.dynamics.drives import Motor
from varistiff.dynamics.gait.knee import KneeGait
from varistiff.dynamics.semi_active import regenerates, semi_active_power
from varistiff.dynamics.signals.signal import Field


@dataclass(frozen=True)
class DirectDrive:
    """Energy of a geared knee motor over one cycle.

    Parameters
    ----------
    returned : into the store by Richter's law, net [J]: work braked less copper, nothing else
    copper : heat in the winding by it [J]
    regenerating_share : share of the time in which power flows into the store by it
    current_max : [A] by it
    voltage_max : [V] by it
    returned_with_losses : the same with the motor's friction, its gear's losses and the torque that turns its rotor [J]
    """

    returned: float
    copper: float
    regenerating_share: float
    current_max: float
    voltage_max: float
    returned_with_losses: float


def direct_drive(gait: KneeGait, motor: Motor, *, body_mass: float, samples: int = 1000) -> DirectDrive:
    """Return what a motor does that puts the whole knee moment on the shank.

        dE/dt = tau_v w - R tau_v^2/a^2,    tau_v = M, the extensor moment, w the rate of flexion, a = n k

    Parameters
    ----------
    gait : angle and moment per body mass
    motor : with ``gear_ratio`` from the knee to the rotor
    body_mass : [kg]
    samples : instants in a cycle; sums over a smooth period converge fast

    Notes
    -----
    Khalaf and Richter (2018), doi 10.1115/1.4037653. With losses the rotor gives T = tau/(n eta) where it drives and
    tau eta/n where it is driven, tau = -M + n^2 J q'', and its friction beside. Nothing limits current and voltage.
    """
    time = jnp.arange(samples) * gait.cycle_duration / samples
    angle = jax.vmap(gait.angle.at)(time)
    torque = jax.vmap(gait.moment(body_mass).at)(time).value
    coupling = motor.gear_ratio * motor.torque_constant
    law = {"resistance": motor.resistance, "coupling": coupling}
    power = semi_active_power(torque, angle.rate, **law)
    current = -torque / coupling
    real = _electrical_power(-torque + motor.reflected_inertia * angle.acceleration, angle.rate, motor)
    step = gait.cycle_duration / samples
    return DirectDrive(
        returned=float(step * jnp.sum(power)),
        copper=float(step * jnp.sum(motor.resistance * current**2)),
        regenerating_share=float(jnp.mean(jax.vmap(lambda t, w: regenerates(t, w, **law))(torque, angle.rate))),
        current_max=float(jnp.max(jnp.abs(current))),
        voltage_max=float(jnp.max(jnp.abs(motor.resistance * current + coupling * angle.rate))),
        returned_with_losses=float(-step * jnp.sum(real)),
    )


def _electrical_power(torque: Field, rate: Field, motor: Motor) -> Field:
    """Power drawn [W] for a torque at the knee [N m] through gear, friction and winding."""
    speed, eta = motor.gear_ratio * rate, motor.gear_efficiency
    rotor = torque / motor.gear_ratio * jnp.where(torque * rate > 0.0, 1.0 / eta, eta)
    rotor += motor.friction_torque * jnp.tanh(speed / motor.smoothing_rate) + motor.viscous_friction * speed
    current = rotor / motor.torque_constant
    return motor.resistance * current**2 + motor.torque_constant * speed * current
