"""Kinematics of the setting: from the setting drive's own coordinate to a length or an angle."""

from __future__ import annotations

from abc import abstractmethod
from typing import NamedTuple

import equinox as eqx
import jax
import jax.numpy as jnp
from jaxtyping import Array, Float

from varistiff.actuators.groove import Groove

Scalar = Float[Array, ""]


class Place(NamedTuple):
    """Value of a path and its first two derivatives with respect to the drive's coordinate."""

    value: Scalar
    slope: Scalar
    curvature: Scalar


class Path(eqx.Module):
    """A length or angle as a smooth function of the setting drive's coordinate z."""

    @abstractmethod
    def at(self, motion: Scalar) -> Place:
        """Value, slope and curvature at z."""


class Affine(Path):
    """start + ratio z: a screw (ratio = lead/(2 pi)), a belt (pulley radius), a straight line, or z itself.

    Parameters
    ----------
    start : value at z = 0 [m] or [rad]
    ratio : value per coordinate [m/rad], [m/m] or [rad/rad], not zero
    """

    start: float = 0.0
    ratio: float = 1.0

    def at(self, motion: Scalar) -> Place:
        """Straight line; no curvature."""
        z = jnp.asarray(motion)
        return Place(self.start + self.ratio * z, jnp.asarray(self.ratio) + 0.0 * z, 0.0 * z)


class GroovePath(Path):
    """Radius start + l_1(z) of a slider in the groove of a disc that is turned by z.

    Parameters
    ----------
    groove : of the stiffness disc
    start : added to the active length [m]: 0 for the length itself, the clamp's radius for the slider's
    """

    groove: Groove
    start: float = 0.0

    def at(self, motion: Scalar) -> Place:
        """Closed form of the groove; the curvature by differentiating its slope."""
        z = jnp.asarray(motion)
        slope, curvature = jax.jvp(self.groove.active_length_rate, (z,), (jnp.ones_like(z),))
        return Place(self.start + self.groove.active_length(z), slope, curvature)
