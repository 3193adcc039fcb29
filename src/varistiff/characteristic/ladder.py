"""The model ladder: where linear, small-deflection and pseudo-rigid-body theory are good enough."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from functools import partial

import jax
import jax.numpy as jnp
import numpy as np

from varistiff.actuators.actuator import Field
from varistiff.elastic.link_contact import LinkContact, link_contact
from varistiff.elastic.pseudo_rigid_body import CHARACTERISTIC_RADIUS, pseudo_rigid_body_energy

Energy = Callable[[Field], Field]


@dataclass(frozen=True)
class Rung:
    """One theory over a grid of deflections; SI units."""

    name: str
    torque: np.ndarray
    stiffness: np.ndarray


@dataclass(frozen=True)
class Ladder:
    """All theories of one joint at one setting, the exact elastica last."""

    deflection: np.ndarray
    rungs: tuple[Rung, ...]

    @property
    def exact(self) -> Rung:
        """The rung that the others are judged by."""
        return self.rungs[-1]

    def error(self, rung: Rung, quantity: str) -> np.ndarray:
        """Relative error of ``torque`` or ``stiffness`` per deflection."""
        value, truth = getattr(rung, quantity), getattr(self.exact, quantity)
        return np.asarray(value / truth - 1.0)

    def good_to(self, rung: Rung, quantity: str, tolerance: float = 0.01) -> float:
        """Largest deflection [rad] up to which the error stays within ``tolerance``; 0 where it never does."""
        outside = ~(np.abs(self.error(rung, quantity)) <= tolerance)  # beyond the fold there is nothing to be good to
        if not outside.any():
            return float(self.deflection[-1])
        first = int(outside.argmax())
        return 0.0 if first == 0 else float(self.deflection[first - 1])


def _linear(deflection: Field, *, radius: float, length: float, rigidity: float) -> Field:
    """V = k phi^2/2 with the stiffness at rest k = 3 E I R^2/l^3."""
    return 1.5 * rigidity * radius**2 / length**3 * deflection**2


def _small_deflection(deflection: Field, *, radius: float, length: float, rigidity: float) -> Field:
    """V = 3 E I R^2 (1 - cos phi)/l^3: linear leaf of fixed length, turned (Wang et al. 2024, Eq. 10)."""
    return 6.0 * rigidity * radius**2 / length**3 * jnp.sin(0.5 * deflection) ** 2


def _linear_leaf(deflection: Field, *, radius: float, length: float, rigidity: float) -> Field:
    """V = 3 E I y^2/(2 x^3): linear leaf up to where the roller really is."""
    x, y = radius * jnp.cos(deflection) - (radius - length), radius * jnp.sin(deflection)
    return 1.5 * rigidity * y**2 / x**3


def _pseudo_rigid_body(deflection: Field, *, radius: float, length: float, rigidity: float) -> Field:
    """One pivot and one spring, at the roller's true position."""
    x, y = radius * jnp.cos(deflection) - (radius - length), radius * jnp.sin(deflection)
    return pseudo_rigid_body_energy(x, y, jnp.asarray(rigidity))


def _rescaled_body(deflection: Field, *, radius: float, length: float, rigidity: float) -> Field:
    """The same with K_Theta = 3 gamma, which is exact at small deflections."""
    x, y = radius * jnp.cos(deflection) - (radius - length), radius * jnp.sin(deflection)
    return pseudo_rigid_body_energy(x, y, jnp.asarray(rigidity), coefficient=3.0 * CHARACTERISTIC_RADIUS)


RUNGS: dict[str, Callable[..., Field]] = {
    "linear": _linear,
    "small deflection, fixed length": _small_deflection,
    "linear leaf, exact kinematics": _linear_leaf,
    "pseudo-rigid body": _pseudo_rigid_body,
    "pseudo-rigid body, K = 3 gamma": _rescaled_body,
}


def model_ladder(
    *, radius: float, length: float, flexural_rigidity: float, deflection_max: float, points: int = 400
) -> Ladder:
    """Compare the theories of a point roller at ``radius`` from the joint that bends a leaf of active ``length``.

    Parameters
    ----------
    radius : x_r of a roller beam, r_2 + l_1 of a slider leaf joint [m]
    length : distance from the clamp to the roller at rest [m]; equal to the radius where the clamp is at the joint
    flexural_rigidity : E I of all leaves together [N m^2]
    deflection_max : last deflection of the grid [rad], below the fold
    points : of the grid, which starts at deflection_max/points

    Returns
    -------
    Ladder; torque and stiffness of every rung but the exact one are derivatives of its energy.
    """
    deflection = deflection_max * np.arange(1, points + 1) / points
    grid = jnp.asarray(deflection)
    about = {"radius": radius, "length": length, "rigidity": flexural_rigidity}
    rungs = [_rung(name, partial(energy, **about), grid) for name, energy in RUNGS.items()]
    solved = _exact(grid, *(jnp.asarray(value) for value in (radius, length, flexural_rigidity)))
    exists = np.asarray(solved.contact.exists)
    torque = np.where(exists, np.asarray(solved.moment), np.nan)
    stiffness = np.where(exists, np.asarray(solved.stiffness), np.nan)
    return Ladder(deflection, (*rungs, Rung("exact elastica", torque, stiffness)))


@jax.jit
def _exact(grid: Field, radius: Field, length: Field, rigidity: Field) -> LinkContact:
    zero = jnp.zeros_like(grid)
    joint = (zero + length - radius, zero)
    return link_contact(grid, zero + radius, offset=zero, joint=joint, radius=zero, flexural_rigidity=rigidity)


def _rung(name: str, energy: Energy, grid: Field) -> Rung:
    slope = jax.jit(jax.vmap(jax.grad(energy)))
    curvature = jax.jit(jax.vmap(jax.grad(jax.grad(energy))))
    return Rung(name, np.asarray(slope(grid)), np.asarray(curvature(grid)))
