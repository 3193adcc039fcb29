"""The idea of a sampled controller: measured and wanted numbers in, one command out, a memory between samples."""

from __future__ import annotations

from abc import abstractmethod
from typing import Any, NamedTuple

import equinox as eqx
import jax.numpy as jnp
from jaxtyping import Array, Float

Scalar = Float[Array, ""]
Number = Scalar | float


class Measured(NamedTuple):
    """Positions [rad or m] as the encoders give them: of the link, the drive and the setting drive.

    A semi-active joint has no drive; its ``drive`` is 0.
    """

    link: Number
    drive: Number
    motion: Number


class Wanted(NamedTuple):
    """What is wanted at the sample instant, from the reference signals.

    ``position`` is the link's [rad or m], ``stiffness`` the joint's [N m/rad or N/m]. ``torque`` [N m or N] is a load
    that the joint should put on the link in its positive direction, beside what the motion needs.
    """

    position: Number = 0.0
    position_rate: Number = 0.0
    position_acceleration: Number = 0.0
    stiffness: Number = 0.0
    stiffness_rate: Number = 0.0
    torque: Number = 0.0


class Controller(eqx.Module):
    """A controller of one drive: pure functions of numbers, sampled at its own rate.

    The command is the torque [N m] or force [N] asked of the drive (u_1) or of the setting drive (u_2) and is held
    until the next sample. The memory is a NamedTuple of numbers, so that a time loop can carry it.
    """

    @abstractmethod
    def start(self, measured: Measured, wanted: Wanted) -> Any:
        """Memory before the first sample: nothing integrated, nothing moving."""

    @abstractmethod
    def sample(self, memory: Any, measured: Measured, wanted: Wanted, period: Number) -> tuple[Scalar, Any]:
        """Command, and the memory for the next sample; ``period`` [s] is the time between two samples."""


def as_scalar(value: Number) -> Scalar:
    """A double of no dimension: what a memory is made of, so that its type never changes in a loop."""
    return jnp.asarray(value, dtype=float)
