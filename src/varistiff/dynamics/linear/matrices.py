"""Jacobians of the equations of motion: the mechanical plant as x' = A x + B u about one point."""

from __future__ import annotations

from typing import Literal, NamedTuple

import equinox as eqx
import jax
import jax.numpy as jnp
import numpy as np
from jaxtyping import Array, Float

from varistiff.dynamics.equations import rates
from varistiff.dynamics.linear.numbers_as_arrays import numbers_as_arrays
from varistiff.dynamics.linear.state_at import pushed, state_at
from varistiff.dynamics.plant import Plant
from varistiff.dynamics.state import Command, Motion

Coordinate = Literal["link", "drive", "motion"]
COORDINATES: tuple[Coordinate, ...] = ("link", "drive", "motion")
INPUTS = ("drive_command", "setting_command", "external_torque")


class Matrices(NamedTuple):
    """A (n, n) and B (n, m) of the states and inputs that are free, named in order.

    States are deviations of positions [rad or m] and rates from the point, inputs deviations of the two commands and
    of the external torque [N m or N].
    """

    a: np.ndarray
    b: np.ndarray
    states: tuple[str, ...]
    inputs: tuple[str, ...]


def free_coordinates(plant: Plant, hold: tuple[Coordinate, ...] = ()) -> tuple[Coordinate, ...]:
    """Coordinates that move by the equations: not locked, prescribed, absent or held."""
    modes = {"link": plant.link.mode, "drive": plant.drive.mode, "motion": plant.setting.mode}
    absent = () if plant.driven else ("drive",)
    return tuple(name for name in COORDINATES if modes[name] == "free" and name not in (*absent, *hold))


def free_states(plant: Plant, hold: tuple[Coordinate, ...] = ()) -> tuple[str, ...]:
    """Names of the states: position and rate of each free coordinate."""
    return tuple(state for name in free_coordinates(plant, hold) for state in (name, f"{name}_rate"))


def plant_matrices(
    plant: Plant,
    motion: Motion,
    *,
    command: Command | None = None,
    external_torque: float = 0.0,
    hold: tuple[Coordinate, ...] = (),
) -> Matrices:
    """Linear plant about a point, which need not be an equilibrium.

    Exact derivatives of ``equations.rates``; storage and temperatures stand still. Values are those of the branch that
    the point is on: of a stop, of backlash, of a saturated drive.

    Parameters
    ----------
    motion : positions and rates at the point
    command : of the drives there [N m] or [N]; None for none
    external_torque : against the link's positive direction there [N m] or [N]
    hold : coordinates that are held still beside those that the plant locks
    """
    commands = (0.0, 0.0) if command is None else tuple(map(float, command))
    point = jnp.asarray([*map(float, motion), *commands, external_torque])
    whole = np.asarray(_jacobian(numbers_as_arrays(plant), point))
    free = free_coordinates(plant, hold)
    states = free_states(plant, hold)
    acts = {"drive_command": "drive", "setting_command": "motion", "external_torque": "link"}
    inputs = tuple(name for name in INPUTS if acts[name] in free)
    names = (*Motion._fields, *INPUTS)
    rows = [names.index(name) for name in states]
    columns = [names.index(name) for name in inputs]
    return Matrices(whole[np.ix_(rows, rows)], whole[np.ix_(rows, columns)], states, inputs)


@eqx.filter_jit
def _jacobian(plant: Plant, point: Float[Array, "9"]) -> Float[Array, "6 9"]:
    """Derivatives of the rates of the six motions with respect to them and the three inputs."""

    def slopes(at: Float[Array, "9"]) -> Float[Array, "6"]:
        state = state_at(plant, Motion(*at[:6]))
        return jnp.stack(rates(plant, state, Command(at[6], at[7]), pushed(at[8])).motion)

    jacobian: Float[Array, "6 9"] = jax.jacfwd(slopes)(point)
    return jacobian
