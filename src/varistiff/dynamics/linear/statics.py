"""Forces on a joint at rest."""

from __future__ import annotations

import dataclasses
from collections.abc import Callable
from typing import NamedTuple

import equinox as eqx
import jax
import jax.numpy as jnp
import numpy as np
from jaxtyping import Array, Float

from varistiff.dynamics.drives import TorqueSource
from varistiff.dynamics.equations import flows
from varistiff.dynamics.friction import Friction
from varistiff.dynamics.linear.matrices import COORDINATES, Coordinate
from varistiff.dynamics.linear.numbers_as_arrays import numbers_as_arrays
from varistiff.dynamics.linear.state_at import pushed, state_at
from varistiff.dynamics.plant import Member, Plant
from varistiff.dynamics.state import Command, Motion
from varistiff.dynamics.storage import Supply

Positions = Float[Array, "3"]


class Statics(NamedTuple):
    """Forces of spring, gravity and stops on link, drive and setting (3,) [N m or N], and their derivatives (3, 3).

    The derivatives are minus the Hessian of the potential energy.
    """

    forces: np.ndarray
    slopes: np.ndarray
    status: int


def real_coordinates(plant: Plant) -> tuple[Coordinate, ...]:
    """Coordinates that the joint has: no drive of a semi-active one, no setting where the actuator has none."""
    absent = (*(() if plant.driven else ("drive",)), *(() if plant.actuator.setting_unit else ("motion",)))
    return tuple(name for name in COORDINATES if name not in absent)


def statics(plant: Plant) -> Callable[[np.ndarray], Statics]:
    """Forces as a function of the positions of link, drive and setting drive (3,) [rad or m], everything at rest.

    Taken from the equations of motion themselves, with unit inertias, all rates zero and no drive torque.
    """
    bare = numbers_as_arrays(_bare(plant))

    def at(positions: np.ndarray) -> Statics:
        (forces, status), slopes = _statics(bare, jnp.asarray(positions, dtype=float))
        return Statics(np.asarray(forces), np.asarray(slopes), int(status))

    return at


def _bare(plant: Plant) -> Plant:
    def unit(member: Member) -> Member:
        return dataclasses.replace(member, inertia=1.0, friction=Friction(), mode="free")

    return dataclasses.replace(
        plant,
        link=unit(plant.link),
        drive=unit(plant.drive),
        setting=unit(plant.setting),
        drive_motor=TorqueSource(),
        setting_motor=TorqueSource(),
        storage=Supply(),
    )


@eqx.filter_jit
def _statics(plant: Plant, positions: Positions) -> tuple[tuple[Positions, Array], Float[Array, "3 3"]]:
    zero = jnp.asarray(0.0)

    def forces(at: Positions) -> tuple[Positions, tuple[Positions, Array]]:
        motion = Motion(at[0], zero, at[1], zero, at[2], zero)
        now = flows(plant, state_at(plant, motion), Command(zero, zero), pushed(zero))
        inertia = plant.inertias(motion)
        found = jnp.stack(
            [
                inertia.link * now.link_acceleration,
                inertia.drive * now.drive_acceleration,
                inertia.setting * now.motion_acceleration,
            ]
        )
        return found, (found, now.response.status)

    slopes, found = jax.jacfwd(forces, has_aux=True)(positions)
    return found, slopes
