"""The plant without what stands still for: dry friction and gear losses."""

from __future__ import annotations

import dataclasses

import jax

from varistiff.dynamics.drives import Drive, Motor
from varistiff.dynamics.friction import DryFriction
from varistiff.dynamics.plant import Plant


def without_dry_friction(plant: Plant) -> Plant:
    """The same plant with Coulomb friction, the motors' friction torque and gear losses at zero; viscous ones stay.

    At rest the smoothed laws are dampers of slope S/v_0, many times what a moving joint feels: poles at rest would say
    that every joint is overdamped and every loop stable. Without them the linear model describes motions large enough
    to slide all the time, and errs towards too little damping.
    """

    def slipping(value: object) -> object:
        if not isinstance(value, DryFriction):
            return value
        breakaway = None if value.breakaway is None else 0.0
        return dataclasses.replace(value, coulomb=0.0, breakaway=breakaway)

    smooth: Plant = jax.tree.map(slipping, plant, is_leaf=lambda value: isinstance(value, DryFriction))
    return dataclasses.replace(
        smooth, drive_motor=_lossless(smooth.drive_motor), setting_motor=_lossless(smooth.setting_motor)
    )


def _lossless(drive: Drive) -> Drive:
    if not isinstance(drive, Motor):
        return drive
    return dataclasses.replace(drive, friction_torque=0.0, gear_efficiency=1.0)
