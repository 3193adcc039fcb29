"""What the 3-D check of a leaf is asked and what it answers."""

from __future__ import annotations

import math
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from varistiff.core.errors import InputError

Floats = NDArray[np.float64]

_SLENDER = 2.0  # a leaf shorter than this many thicknesses is no leaf


@dataclass(frozen=True)
class Motion:
    """How the contact's centre moves with the deflection, and how many such leaves the device has.

    Parameters
    ----------
    rate : dC/d(deflection) in the leaf's frame, (x, y) [m per unit of deflection]
    acceleration : d2C/d(deflection)2
    copies : number of solved pieces that make the device; the energy is copies times that of the piece
    """

    rate: tuple[float, float] = (0.0, 1.0)
    acceleration: tuple[float, float] = (0.0, 0.0)
    copies: float = 1.0


@dataclass(frozen=True)
class SlidingContact:
    """A rigid frictionless roller on which the leaf slides: the force is normal to the leaf, its place unknown.

    Parameters
    ----------
    centre : C in the leaf's frame, (x, y) [m]; y > 0 is the side to which the leaf is pushed
    radius : r [m], from C to the mid-plane along the leaf's normal: roller radius plus half the thickness; 0 for a
        pivot in the mid-plane; negative for a pair of rollers that turns with the leaf
    guard_radius : of the mid-plane on a protection cylinder that is tangent to the leaf at the clamp [m]
    """

    centre: tuple[float, float]
    radius: float = 0.0
    guard_radius: float = math.inf


@dataclass(frozen=True)
class UprightContact:
    """A point of the mid-plane held at ``centre`` (x, y) [m] by a force square to the clamped leaf (no axial force).

    Half the guided leaf of Chacon et al. (2011): the leaf's length is what puts the point there.
    """

    centre: tuple[float, float]


@dataclass(frozen=True)
class TurnedEnd:
    """The end section turned by ``angle`` [rad] by a pure moment; nothing else acts. The load is the moment."""

    angle: float


Hold = SlidingContact | UprightContact | TurnedEnd


@dataclass(frozen=True)
class LeafProblem:
    """A rectangular leaf clamped at the origin along +x, bent towards +y by what holds it.

    Parameters
    ----------
    youngs_modulus, poissons_ratio : [Pa], [-]; isotropic, -1 < nu < 1/2
    width, thickness : b and h [m]
    hold : the contact, or the turned end
    length : from the clamp to the turned end [m]; of no effect for a contact, which finds its own
    tail : free length beyond the contact [m]
    motion : of the contact with the device's deflection
    side : -1 where the device's leaf is the mirror image (y reversed) of the solved one
    name : of the leaf, for messages
    """

    youngs_modulus: float
    poissons_ratio: float
    width: float
    thickness: float
    hold: Hold
    length: float = math.nan
    tail: float = 0.0
    motion: Motion = Motion()
    side: float = 1.0
    name: str = "leaf"

    def __post_init__(self) -> None:
        """Refuse sizes and constants that make no leaf."""
        for field in ("youngs_modulus", "width", "thickness"):
            if not 0.0 < getattr(self, field) < math.inf:
                raise InputError(f"is {getattr(self, field):g}; allowed is a positive number", field=field)
        if not -1.0 < self.poissons_ratio < 0.5:
            raise InputError(f"is {self.poissons_ratio:g}; allowed is -1 < nu < 0.5", field="poissons_ratio")
        if not 0.0 <= self.tail < math.inf:
            raise InputError(f"is {self.tail:g} m; allowed is a finite length >= 0", field="tail")
        if isinstance(self.hold, TurnedEnd):
            if self.hold.angle == 0.0 or not math.isfinite(self.hold.angle):
                raise InputError(f"is {self.hold.angle:g} rad; allowed is a finite angle that is not 0", field="angle")
            if not _SLENDER * self.thickness <= self.length < math.inf:
                raise InputError(f"is {self.length:g} m; allowed is a finite length over 2 thicknesses", field="length")
        elif not self.hold.centre[1] > 0.0 and not isinstance(self.hold, SlidingContact):
            raise InputError(f"is {self.hold.centre}; the second must be positive", field="centre")

    @property
    def flexural_rigidity(self) -> float:
        """E I of a narrow leaf [N m^2]."""
        return self.youngs_modulus * self.width * self.thickness**3 / 12.0


@dataclass(frozen=True, eq=False)
class LeafResult:
    """Equilibrium of the solid leaf; numbers are of the finest level, SI units.

    ``load`` and ``stiffness`` are the part of this leaf (all its ``copies``) in the device's; the rest is of one
    leaf, in its own frame. ``error`` is relative: the change of the load from the last level but one to the last.

    ``stress`` is the largest bending stress (along the leaf, in the outer fibre) in the middle of the width that is
    at least ``stress_distance`` away from the clamp, whose edge is singular. The arrays are for pictures: ``arc`` (n,)
    along the leaf, ``across`` (m,) over the whole width, ``points`` (n, m, 3) of the deformed mid-plane,
    ``stress_upper`` and ``stress_lower`` (n, m) along the leaf in the faces y = +h/2 and -h/2 of the device's leaf.
    """

    problem: LeafProblem
    load: float
    stiffness: float
    energy: float  # of one piece
    contact_force: float  # N; the end moment [N m] for a turned end
    contact_slope: float  # direction of the contact force against the clamp's normal
    arc_length: float  # of the undeformed leaf from clamp to contact
    stress: float
    stress_distance: float
    error: float
    unknowns: int
    seconds: float
    level_loads: tuple[float, ...]  # from coarse to fine
    iterations: int
    arc: Floats
    across: Floats
    points: Floats
    stress_upper: Floats
    stress_lower: Floats
