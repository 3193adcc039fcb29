"""The torsion tube of ``varistiff.actuators`` as the computations of this paper ask it."""

from __future__ import annotations

import math

import jax.numpy as jnp

from varistiff.actuators.actuator import Response
from varistiff.actuators.torsion_tube import TorsionTube
from varistiff.sections import HollowCircle, Section

_TWIST = 1e-3  # rad; the stiffness does not depend on it


def tube_of(
    *, shear_modulus: float, section: Section, length: float = math.inf, series_stiffness: float = math.inf
) -> TorsionTube:
    """Return a torsion tube; by default alone, with nothing else in the drive train.

    Parameters
    ----------
    shear_modulus : G [Pa]
    section : cross-section
    length, series_stiffness : see ``TorsionTube``
    """
    return TorsionTube(shear_modulus=shear_modulus, section=section, length=length, series_stiffness=series_stiffness)


def respond(tube: TorsionTube, *, twist: float, active_length: float) -> Response:
    """Return what the device does at a twist [rad] and an active length [m]."""
    response, _ = tube.respond(jnp.asarray(twist), jnp.asarray(active_length))
    return response


def stiffness(tube: TorsionTube, *, active_length: float) -> float:
    """Tangent stiffness [N m/rad] at an active length [m]; NaN where there is none."""
    return float(respond(tube, twist=_TWIST, active_length=active_length).stiffness)


def length_of_stiffness(tube: TorsionTube, *, wanted: float) -> float:
    """Active length [m] at which a torsion tube has the stiffness wanted [N m/rad].

    The compliance grows evenly with the length, so two points of the device fix it.
    """
    near, far = 0.01, 0.02
    one, two = (1.0 / stiffness(tube, active_length=x) for x in (near, far))
    return near + (1.0 / wanted - one) * (far - near) / (two - one)


def bare_tube(*, shear_modulus: float, bore_ratio: float, outer_radius: float) -> TorsionTube:
    """Return a hollow cylinder, the paper's idea of its element."""
    section = HollowCircle(outer_radius=outer_radius, inner_radius=bore_ratio * outer_radius)
    return tube_of(shear_modulus=shear_modulus, section=section)
