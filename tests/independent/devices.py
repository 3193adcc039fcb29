"""Roller beams of the independent checks, and where their rollers are, from plane geometry written anew."""

from __future__ import annotations

import math
from dataclasses import dataclass

from varistiff.actuators import FixedPair, RollerBeam, Rollers, SingleLower, SingleUpper, SwivellingPair
from varistiff.elastic.leaf import Leaf

BEAM = Leaf(youngs_modulus=194e9, width=0.02545, thickness=0.00316, length=0.9)
WALL, ALONG, ACROSS = 0.06, 0.035, -0.005  # mounting angle [rad] and clamp offsets [m], values that a swap changes
RADIUS, CLEARANCE = 0.012, 0.0015

Vector = tuple[float, float]


@dataclass(frozen=True)
class Placed:
    """A roller that bears: its centre, its signed distance to the centreline, and the joint, clamp at the origin."""

    centre: Vector
    radius: float
    joint: Vector
    along_link: Vector
    lower: bool

    def mirrored(self) -> Vector:
        """The centre as a lower roller's."""
        return self.centre[0], self.centre[1] * (1 if self.lower else -1)


def turned(angle: float, vector: Vector) -> Vector:
    """Rotate a vector."""
    c, s = math.cos(angle), math.sin(angle)
    return c * vector[0] - s * vector[1], s * vector[0] + c * vector[1]


def device(rollers: Rollers, beam: Leaf = BEAM) -> RollerBeam:
    """Roller beam with every offset."""
    return RollerBeam(
        beam=beam,
        rollers=rollers,
        mounting_angle=WALL,
        clamp_offset_along=ALONG,
        clamp_offset_across=ACROSS,
    )


def placed(rollers: Rollers, deflection: float, setting: float, *, lower: bool) -> Placed:
    """Where the acting roller is.  The clamp is d_1 ahead of the joint and d_0 beside it, turned by alpha_w."""
    joint = turned(WALL, (-ALONG, -ACROSS))
    side = 1.0 if lower else -1.0
    if isinstance(rollers, SwivellingPair):
        offset, radius = rollers.offset, -rollers.clearance
    elif isinstance(rollers, SingleLower | SingleUpper):
        offset, radius = rollers.offset, rollers.radius + BEAM.thickness / 2
    else:
        assert isinstance(rollers, FixedPair)
        radius = rollers.radius + BEAM.thickness / 2
        offset = rollers.offset - side * (radius + rollers.clearance)
    arm = turned(WALL + deflection, (setting, offset))
    return Placed((joint[0] + arm[0], joint[1] + arm[1]), radius, joint, turned(WALL + deflection, (1, 0)), lower)
