"""State feedback with gains that follow the setting."""

from __future__ import annotations

import math
from typing import NamedTuple

import jax.numpy as jnp
import numpy as np
from jaxtyping import Array, Float

from varistiff.core.errors import InputError
from varistiff.dynamics.control.checks import check_number, check_range
from varistiff.dynamics.control.controller import Controller, Measured, Number, Scalar, Wanted, as_scalar
from varistiff.dynamics.control.filtered_rate import RateMemory, filtered_rate, start_rate
from varistiff.dynamics.control.link_demand import GravityTorque, LinkModel, wanted_deflection
from varistiff.dynamics.control.lqr import LqrWeights, closed_loop_poles, is_stable, lqr_gains
from varistiff.dynamics.control.sensed_spring import SensedSpring
from varistiff.dynamics.control.torque_control import require_drive
from varistiff.dynamics.control.two_mass import TwoMass, tangent_stiffness

_BETWEEN = 4  # places between two nodes where the interpolated gains are tried


class LqrMemory(NamedTuple):
    """Rates of link and drive, and the integral of the link's error [rad s]."""

    link: RateMemory
    drive: RateMemory
    error: Scalar


class ScheduledLqr(Controller):
    """u_1 = u_w - K(s) (x - x_w), x = (q, q', q_1, q_1'[, integral of q]), with K interpolated over the setting.

    The wanted state and command follow from the wanted motion and the map: the link needs the load
    tau = J q_w'' + D q_w' + gravity(q_w) + tau_w, the drive stands at q_1w = q_w + d_w where the spring gives it, moves
    with the link, and needs u_w = tau + J_1 q_w'' + D_1 q_w'. Rates are filtered differences of the encoders.

    Parameters
    ----------
    spring : map of a driven joint, for the setting and d_w
    link : inertia, damping and gravity of the link
    gains : (n, 4) or (n, 5), at n settings of equal distance; ``scheduled_lqr`` designs them
    setting_min, setting_max : first and last of these settings [m or rad]; beyond them their gains hold
    drive_inertia, drive_damping : J_1 and D_1
    limit : largest command [N m or N]; while it binds the integral rests
    filter_time : of both rates [s]
    stiffness_min : see ``wanted_deflection``

    Notes
    -----
    Gain scheduling: Rugh and Shamma (2000), doi 10.1016/S0005-1098(00)00058-3. Right while the setting moves slowly
    against the closed loop.

    Raises
    ------
    InputError : a number is out of range, or the joint is semi-active
    """

    spring: SensedSpring
    link: LinkModel
    gains: Float[Array, "setting state"]
    setting_min: Number
    setting_max: Number
    drive_inertia: Number = 0.0
    drive_damping: Number = 0.0
    limit: Number = math.inf
    filter_time: Number = 0.0
    stiffness_min: Number = 1e-6

    def __check_init__(self) -> None:
        check_number("gains", self.gains)
        if jnp.ndim(self.gains) != 2 or self.gains.shape[0] < 1 or self.gains.shape[1] not in (4, 5):
            raise InputError(f"must have the shape (n, 4) or (n, 5), not {jnp.shape(self.gains)}", field="gains")
        for name in ("drive_inertia", "drive_damping", "filter_time"):
            check_number(name, getattr(self, name), least=0.0)
        check_number("stiffness_min", self.stiffness_min, above=0.0)
        check_number("limit", self.limit, above=0.0, infinite=True)
        if self.gains.shape[0] > 1:
            check_range("setting", self.setting_min, self.setting_max)
        require_drive(self.spring)

    def gain(self, setting: Number) -> tuple[Scalar, ...]:
        """Gains [N m/rad, N m s/rad, ...] at a setting [m or rad], linear between the nodes."""
        nodes, states = self.gains.shape
        if nodes == 1:
            return tuple(self.gains[0, state] for state in range(states))
        part = (as_scalar(setting) - self.setting_min) / (self.setting_max - self.setting_min)
        place = (nodes - 1) * jnp.clip(part, 0.0, 1.0)
        index = jnp.minimum(jnp.floor(place), nodes - 2).astype(int)
        rest = place - index
        return tuple(
            (1.0 - rest) * self.gains[index, state] + rest * self.gains[index + 1, state] for state in range(states)
        )

    def start(self, measured: Measured, wanted: Wanted) -> LqrMemory:
        """See ``Controller.start``."""
        del wanted
        return LqrMemory(start_rate(measured.link), start_rate(measured.drive), as_scalar(0.0))

    def sample(self, memory: LqrMemory, measured: Measured, wanted: Wanted, period: Number) -> tuple[Scalar, LqrMemory]:
        """See ``Controller.sample``."""
        link = filtered_rate(memory.link, measured.link, period, self.filter_time)
        drive = filtered_rate(memory.drive, measured.drive, period, self.filter_time)
        load = self.link.load(wanted)
        deflection = wanted_deflection(
            self.spring.response(measured), self.spring.deflection(measured), load, stiffness_min=self.stiffness_min
        )
        errors = (
            link.position - wanted.position,
            link.rate - wanted.position_rate,
            drive.position - (wanted.position + deflection),
            drive.rate - wanted.position_rate,
            memory.error,
        )
        ahead = load + self.drive_inertia * wanted.position_acceleration + self.drive_damping * wanted.position_rate
        gains = self.gain(self.spring.setting(measured))
        unlimited = ahead - sum(gain * error for gain, error in zip(gains, errors, strict=False))
        command = jnp.clip(unlimited, -self.limit, self.limit)
        error = memory.error + jnp.where(command == unlimited, period * errors[0], 0.0)
        return command, LqrMemory(link, drive, error)


def scheduled_lqr(
    spring: SensedSpring,
    model: TwoMass,
    weights: LqrWeights,
    *,
    nodes: int = 17,
    deflection: float = 0.0,
    period: float | None = None,
    gravity: GravityTorque | None = None,
    limit: float = math.inf,
    filter_time: float = 0.0,
) -> ScheduledLqr:
    """Design a ``ScheduledLqr`` with the map's tangent stiffness, over the spring's range of settings.

    Parameters
    ----------
    spring : map of a driven joint with a finite range of settings (any, where the actuator has no setting)
    model : inertias and dampings
    weights : of the cost
    nodes : settings at which a regulator is designed, at least 2
    deflection : at which the tangent stiffness is taken [rad or m]
    period : sample time [s] for sampled regulators; None for continuous ones
    gravity : of the link, for the feedforward; its stiffness belongs into ``model.link_stiffness``
    limit, filter_time : see ``ScheduledLqr``

    Raises
    ------
    InputError : the map has no positive stiffness somewhere, no regulator exists, or the interpolated gains are
        unstable between two nodes; says at which setting
    """
    require_drive(spring)
    settings = _design_settings(spring, nodes)
    stiffness = tangent_stiffness(spring.actuator, settings, deflection=deflection)
    controller = ScheduledLqr(
        spring=spring,
        link=LinkModel(model.link_inertia, model.link_damping, gravity),
        gains=jnp.asarray(lqr_gains(model, stiffness, weights, period=period)),
        setting_min=float(settings[0]),
        setting_max=float(settings[-1]),
        drive_inertia=model.drive_inertia,
        drive_damping=model.drive_damping,
        limit=limit,
        filter_time=filter_time,
    )
    _check_between(controller, model, settings, deflection, period)
    return controller


def _design_settings(spring: SensedSpring, nodes: int) -> np.ndarray:
    if spring.actuator.setting_unit is None:
        return np.zeros(1)
    if nodes < 2:
        raise InputError(f"must be at least 2, not {nodes}", field="nodes")
    for name in ("setting_min", "setting_max"):
        check_number(name, getattr(spring, name))
    return np.linspace(float(spring.setting_min), float(spring.setting_max), nodes)


def _check_between(
    controller: ScheduledLqr, model: TwoMass, settings: np.ndarray, deflection: float, period: float | None
) -> None:
    """Refuse gains that do not hold the loop stable between their nodes."""
    fine = np.linspace(settings[0], settings[-1], (settings.size - 1) * (_BETWEEN + 1) + 1)
    stiffness = tangent_stiffness(controller.spring.actuator, fine, deflection=deflection)
    for setting, value in zip(fine, stiffness, strict=True):
        gains = np.array([float(gain) for gain in controller.gain(float(setting))])
        poles = closed_loop_poles(model, float(value), gains, period=period)
        if not is_stable(poles, sampled=period is not None):
            raise InputError(
                f"the gains between two nodes do not hold the loop stable at a setting of {setting:.6g}; "
                "design at more nodes"
            )
