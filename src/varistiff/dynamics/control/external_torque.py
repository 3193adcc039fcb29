"""External torque, sensed from the deflection and the map."""

from __future__ import annotations

from varistiff.dynamics.control.controller import Measured, Number, Scalar
from varistiff.dynamics.control.sensed_spring import SensedSpring


def external_torque(
    spring: SensedSpring,
    measured: Measured,
    *,
    inertia: Number = 0.0,
    acceleration: Number = 0.0,
    damping: Number = 0.0,
    rate: Number = 0.0,
    gravity: Number = 0.0,
) -> Scalar:
    """Torque [N m] or force [N] from outside against the link's positive direction.

        tau_ext = load(q_1 - q, s) - J q'' - D q' - gravity(q)

    With nothing but the positions it is the paper's: the spring's torque alone, right when the link stands. Give the
    inertia with the acceleration, and the damping with the rate, for a link in motion.

    Parameters
    ----------
    spring : map and signs
    measured : positions; their quantisation passes as step * tangent stiffness
    inertia : J [kg m^2 or kg]
    acceleration : q'' [rad/s^2 or m/s^2]
    damping : D [N m s/rad or N s/m]
    rate : q' [rad/s or m/s]
    gravity : torque [N m] or force [N] of the link's weight against +q

    Notes
    -----
    Wang et al. (2024), section 3 and Eq. (17), doi 10.3390/app14072685; the paper takes the torque from Eq. (9).
    """
    return spring.link_load(measured) - inertia * acceleration - damping * rate - gravity
