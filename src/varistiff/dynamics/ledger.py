"""The energy account of a simulation: one entry per law."""

from __future__ import annotations

from typing import NamedTuple

from jaxtyping import Array, Float

Scalar = Float[Array, ""]


class Stores(NamedTuple):
    """Energies that the state itself determines [J]."""

    kinetic: Scalar
    elastic: Scalar
    gravity: Scalar
    stop_elastic: Scalar
    stored: Scalar


LOSSES = (
    "copper_drive",
    "copper_setting",
    "gear_drive",
    "gear_setting",
    "friction_link",
    "friction_drive",
    "friction_setting",
    "stop_loss",
    "series_loss",
    "leakage",
    "converter_loss",
)
"""What can be dissipated; none is ever below zero."""

INFLOWS = ("external_work", "supplied")
"""What enters from outside: work done on the link by the load or by what prescribes its motion, and a supply's."""

Powers = dict[str, Scalar]


class Ledger(NamedTuple):
    """Losses and inflows by name, of the kinds that a plant has, and the energy turned over.

    As rates these are powers [W], integrated they are energies [J]. Turned over is half the sum of all powers'
    magnitudes.
    """

    losses: Powers
    inflows: Powers
    turnover: Scalar


LONG_NAMES = {
    "kinetic": "kinetic energy",
    "elastic": "elastic energy of the actuator",
    "gravity": "potential energy of gravity",
    "stop_elastic": "elastic energy of the stops",
    "stored": "energy in the storage",
    "copper_drive": "copper loss of the drive motor",
    "copper_setting": "copper loss of the setting motor",
    "gear_drive": "gear loss of the drive motor",
    "gear_setting": "gear loss of the setting motor",
    "friction_link": "friction of the link",
    "friction_drive": "friction of the drive",
    "friction_setting": "friction of the setting",
    "stop_loss": "loss in the stops",
    "series_loss": "loss in the storage's series resistance",
    "leakage": "leakage of the storage",
    "converter_loss": "loss in converter and brake resistor",
    "external_work": "work done on the link from outside",
    "supplied": "energy from the supply",
    "residual": "what the energy balance leaves open",
}
