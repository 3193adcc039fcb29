"""Converter, brake resistor, series resistance and leakage around a voltage: the same in every storage."""

from __future__ import annotations

from typing import NamedTuple

import jax.numpy as jnp
from jaxtyping import Array, Float

from varistiff.dynamics.storage.converter import converter_loss
from varistiff.dynamics.storage.series_source import draw

Scalar = Float[Array, ""]


class TerminalFlows(NamedTuple):
    """Current out of the open-circuit voltage [A] without leakage, the leakage's own [A], and powers [W]."""

    current: Scalar
    leakage_current: Scalar
    series_power: Scalar
    leakage_power: Scalar
    converter_power: Scalar
    shortfall: Scalar


def terminal_flows(
    power: Scalar,
    *,
    voltage: Scalar,
    series_resistance: float,
    leakage_resistance: float,
    converter_efficiency: float,
    regenerative: bool,
    takes: Scalar | float = 1.0,
    gives: Scalar | float = 1.0,
) -> TerminalFlows:
    """Currents and losses at an open-circuit voltage under the drives' power.

    Parameters
    ----------
    power : that the drives draw [W]; below zero where they return it
    voltage : without a current [V]
    series_resistance, leakage_resistance : [ohm]
    converter_efficiency, regenerative : see ``converter_loss``
    takes : share of a returned power that finds room, from 0 (full) to 1; the rest goes to the brake resistor
    gives : share of a drawn power that is there, from 0 (empty) to 1; the rest is a shortfall
    """
    loss = converter_loss(power, efficiency=converter_efficiency, regenerative=regenerative)
    asked = power + loss
    braked = (1.0 - takes) * jnp.maximum(-asked, 0.0)
    missing = (1.0 - gives) * jnp.maximum(asked, 0.0)
    drawn = draw(asked + braked - missing, voltage=voltage, resistance=series_resistance)
    leak = voltage / leakage_resistance
    return TerminalFlows(
        current=drawn.current,
        leakage_current=leak,
        series_power=series_resistance * drawn.current**2,
        leakage_power=voltage * leak,
        converter_power=loss + braked,
        shortfall=drawn.shortfall + missing,
    )


def smooth_step(margin: Scalar, band: float) -> Scalar:
    """0 where the margin is used up, 1 from a band of it on, x^2 (3 - 2 x) between.

    >>> float(smooth_step(0.5, 1.0)), float(smooth_step(-1.0, 1.0)), float(smooth_step(2.0, 1.0))
    (0.5, 0.0, 1.0)
    """
    x = jnp.clip(margin / band, 0.0, 1.0)
    return x * x * (3.0 - 2.0 * x)
