"""Friction of a moving part: Coulomb, Stribeck and viscous, smooth through rest."""

from __future__ import annotations

import equinox as eqx
import jax.numpy as jnp
from jaxtyping import Array, Float

Scalar = Float[Array, ""]


class DryFriction(eqx.Module):
    """Coulomb friction with the Stribeck peak, smooth through rest.

        F(v) = [C + (S - C) exp(-(v/v_S)^2)] tanh(v/v_0)

    Below about ``smoothing_rate`` v_0 the tanh stands for sticking: a body under less than S creeps at up to v_0, it
    never quite stands. v_0 is a stated part of the model, not of the solver; a step must resolve inertia v_0/S.

    Parameters
    ----------
    coulomb : C [N m] or [N]
    breakaway : S >= C [N m] or [N]; None for S = C
    stribeck_rate : v_S [rad/s] or [m/s]
    smoothing_rate : v_0 [rad/s] or [m/s]

    Notes
    -----
    Armstrong-Helouvry, Dupont and Canudas de Wit (1994), doi 10.1016/0005-1098(94)90209-7.
    """

    coulomb: float
    breakaway: float | None = None
    stribeck_rate: float = 0.1
    smoothing_rate: float = 0.01

    def force(self, rate: Scalar) -> Scalar:
        """Torque [N m] or force [N] against ``rate``; odd in it, so force*rate is a loss."""
        level = jnp.asarray(self.coulomb)
        if self.breakaway is not None:
            level = level + (self.breakaway - self.coulomb) * jnp.exp(-((rate / self.stribeck_rate) ** 2))
        return level * jnp.tanh(rate / self.smoothing_rate)


class Friction(eqx.Module):
    """Torque or force against a rate: viscous D v, and dry friction where there is any.

    Parameters
    ----------
    viscous : D [N m s/rad] or [N s/m]
    dry : Coulomb friction; None for none

    >>> float(Friction(viscous=0.1, dry=DryFriction(coulomb=2.0)).force(5.0))
    2.5
    """

    viscous: float = 0.0
    dry: DryFriction | None = None

    def force(self, rate: Scalar | float) -> Scalar:
        """Torque [N m] or force [N] against ``rate``."""
        speed = jnp.asarray(rate)
        viscous = self.viscous * speed
        return viscous if self.dry is None else viscous + self.dry.force(speed)
