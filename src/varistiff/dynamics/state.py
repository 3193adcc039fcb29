"""State of a joint in motion: scalars only, so that the whole time loop compiles into one function."""

from __future__ import annotations

from typing import NamedTuple

from jaxtyping import Array, Float

from varistiff.dynamics.drives import Temperatures
from varistiff.dynamics.ledger import Ledger

Scalar = Float[Array, ""]


class Motion(NamedTuple):
    """Positions [rad or m] and rates of link, drive and setting drive."""

    link: Scalar
    link_rate: Scalar
    drive: Scalar
    drive_rate: Scalar
    motion: Scalar
    motion_rate: Scalar


class State(NamedTuple):
    """Everything that is integrated: motion, storage charge, motor temperatures and the energy account."""

    motion: Motion
    charge: Scalar
    drive_heat: Temperatures
    setting_heat: Temperatures
    ledger: Ledger


class Command(NamedTuple):
    """What the controllers ask of the drives, held between samples: torques or forces at the outputs."""

    drive: Scalar
    setting: Scalar
