"""The mechanical plant as a python-control system with named signals."""

from __future__ import annotations

from typing import TYPE_CHECKING

import equinox as eqx
import jax
import jax.numpy as jnp
import numpy as np
from jaxtyping import Array, Float

from varistiff.core.errors import InputError
from varistiff.dynamics.linear.equilibrium import Equilibrium
from varistiff.dynamics.linear.matrices import COORDINATES, Coordinate, Matrices, free_coordinates, plant_matrices
from varistiff.dynamics.linear.numbers_as_arrays import numbers_as_arrays
from varistiff.dynamics.linear.state_at import numbers_of
from varistiff.dynamics.linear.without_dry_friction import without_dry_friction
from varistiff.dynamics.plant import Plant
from varistiff.dynamics.state import Command, Motion

if TYPE_CHECKING:
    import control


def linearise(
    plant: Plant, at: Equilibrium, *, dry_friction: bool = False, hold: tuple[Coordinate, ...] = ()
) -> control.StateSpace:
    """Linear model of small motions about an equilibrium.

    States are the deviations ``link``, ``link_rate``, ``drive``, ``drive_rate``, ``motion``, ``motion_rate`` of the
    coordinates that are free; inputs ``drive_command``, ``setting_command`` and ``external_torque`` as far as they act
    on a free one; outputs the free positions, ``deflection`` and ``load``. Derivatives are exact. A drive passes its
    command as torque: the current loop counts as instantaneous.

    Parameters
    ----------
    dry_friction : whether to keep dry friction and gear losses, whose smoothed laws are stiff dampers at rest
    hold : coordinates held still beside those that the plant locks: ("motion",) for a setting that its drive holds

    Raises
    ------
    InputError : nothing is free, a drive cannot give the torque that the equilibrium needs, or the derivatives do not
        exist there

    Notes
    -----
    The control package: Fuller et al. (2021), doi 10.1109/CDC45484.2021.9683368.
    """
    import control

    kept = plant if dry_friction else without_dry_friction(plant)
    command = _commands(kept, at, hold)
    matrices = plant_matrices(kept, at.motion, command=command, external_torque=at.external_torque, hold=hold)
    if not matrices.states:
        raise InputError("nothing is free to move: every coordinate is locked, prescribed or held")
    c, outputs = _outputs(kept, at.motion, matrices)
    for matrix in (matrices.a, matrices.b, c):
        if not np.isfinite(matrix).all():
            raise InputError("the equations of motion have no derivative at this point")
    return control.ss(
        matrices.a,
        matrices.b,
        c,
        np.zeros((len(outputs), len(matrices.inputs))),
        states=list(matrices.states),
        inputs=list(matrices.inputs),
        outputs=list(outputs),
        name=plant.actuator.kind,
    )


def _commands(plant: Plant, at: Equilibrium, hold: tuple[Coordinate, ...]) -> Command:
    """What the drives are asked for; their torques where the friction is left out."""
    free = free_coordinates(plant, hold)
    for name, drive, torque in (
        ("drive", plant.drive_motor, at.drive_torque),
        ("motion", plant.setting_motor, at.setting_torque),
    ):
        if name in free and abs(torque) >= drive.torque_limit:
            raise InputError(
                f"this equilibrium needs {torque:.4g} of it, beyond its limit {drive.torque_limit:.4g}",
                field=f"{'setting' if name == 'motion' else name}_motor",
            )
    return Command(jnp.asarray(at.drive_torque), jnp.asarray(at.setting_torque))


def _outputs(plant: Plant, motion: Motion, matrices: Matrices) -> tuple[np.ndarray, tuple[str, ...]]:
    slopes = np.asarray(_spring(numbers_as_arrays(plant), jnp.asarray(numbers_of(motion))))
    columns = [Motion._fields.index(name) for name in matrices.states]
    positions = tuple(name for name in COORDINATES if name in matrices.states)
    rows = [[1.0 if state == name else 0.0 for state in matrices.states] for name in positions]
    return np.array([*rows, *slopes[:, columns]]), (*positions, "deflection", "load")


@eqx.filter_jit
def _spring(plant: Plant, point: Float[Array, "6"]) -> Float[Array, "2 6"]:
    """Derivatives of deflection and load with respect to the motion."""

    def spring(at: Float[Array, "6"]) -> Float[Array, "2"]:
        motion = Motion(*at)
        setting = plant.setting_path.at(motion.motion).value
        response, _ = plant.actuator.respond(plant.stretch(motion), setting)
        return jnp.stack([plant.deflection(motion), response.load])

    slopes: Float[Array, "2 6"] = jax.jacfwd(spring)(point)
    return slopes
