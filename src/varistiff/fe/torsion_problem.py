"""What the three-dimensional check of a torsion element asks and answers."""

from __future__ import annotations

import math
from collections.abc import Callable
from dataclasses import dataclass
from typing import Any, Literal, Protocol

import numpy as np
from numpy.typing import NDArray

from varistiff.core.errors import InputError
from varistiff.sections.outline import Outline

Floats = NDArray[np.float64]
Integers = NDArray[np.int64]
BearingKind = Literal["flanks", "sleeve", "bonded"]
Progress = Callable[[str, float], None]  # what begins now, and the share of the work that is done


class TorsionSection(Protocol):
    """What the check needs to know of a cross-section."""

    @property
    def torsion_constant(self) -> Any:
        """J [m^4]."""
        ...

    @property
    def torsion_modulus(self) -> Any:
        """W [m^3], 0 where the ideal stress is unbounded."""
        ...

    def outline(self) -> Outline:
        """The boundary."""
        ...


@dataclass(frozen=True)
class TorsionProblem:
    """The solid of a torsion element at one setting.

    Parameters
    ----------
    section : cross-section; rails are those of a ``splined_tube``
    shear_modulus, poissons_ratio : G [Pa] and nu of the isotropic material
    length : of the element from its clamp at z = 0 to its free end [m]
    active_length : x [m], from the clamp to the near edge of the counter bearing; 0 is the rigid lock
    bearing_length : along z [m]; what would lie beyond the free end carries nothing
    bearing_clearance : gap between bearing and element, normal to the surface [m]
    flange_radius, flange_thickness : of the drive-side disc [m], for drawings only: the check holds z = 0 rigidly.
        None leaves it out

    Notes
    -----
    The bearing acts on the outside over z from x to x + bearing_length. Schuy et al. (2013) publish neither its
    length nor from which of its edges x counts.

    At x = 0 the bearing sits on the clamp. A rigid bearing's rotation would jump to the clamp's zero at their common
    edge, which takes infinite energy: only the given pressure on the flanks of rails has a finite stiffness there.

    Raises
    ------
    InputError : a number is out of its range
    """

    section: TorsionSection
    shear_modulus: float
    poissons_ratio: float
    length: float
    active_length: float
    bearing_length: float
    bearing_clearance: float = 0.0
    flange_radius: float | None = None
    flange_thickness: float | None = None

    def __post_init__(self) -> None:
        for name in ("shear_modulus", "length", "bearing_length"):
            _require(self, name, 0.0 < getattr(self, name) < math.inf, "a finite number above 0")
        _require(self, "poissons_ratio", -0.9 <= self.poissons_ratio <= 0.49, "-0.9 to 0.49")
        _require(self, "bearing_clearance", 0.0 <= self.bearing_clearance < math.inf, "0 or more")
        inside = 0.0 <= self.active_length < self.length
        rigid = self.active_length == 0.0 and not turns_at_the_lock(self.section)
        _require(self, "active_length", inside, f"0 to below the element's length of {self.length:.6g} m")
        _require(self, "active_length", not rigid, "above 0: a rigid bearing that meets the rigid clamp does not turn")
        for name in ("flange_radius", "flange_thickness"):
            value = getattr(self, name)
            _require(self, name, value is None or 0.0 < value < math.inf, "a finite number above 0")

    @property
    def bearing_end(self) -> float:
        """z where the engaged part of the bearing ends [m]."""
        return min(self.active_length + self.bearing_length, self.length)

    @property
    def bearing_kind(self) -> BearingKind:
        """Rails are driven at their flanks; a round outside has to be bonded; others fit a sleeve of their own form."""
        if turns_at_the_lock(self.section):
            return "flanks"
        return "bonded" if getattr(self.section, "shape", "") in ("circle", "hollow_circle") else "sleeve"


def turns_at_the_lock(section: TorsionSection) -> bool:
    """Whether the section has rails, whose flanks give way under a pressure even where the bearing meets the clamp."""
    return getattr(section, "shape", "") == "splined_tube"


def _require(problem: TorsionProblem, name: str, condition: bool, allowed: str) -> None:
    value = getattr(problem, name)
    if not (condition and (value is None or math.isfinite(value))):
        raise InputError(f"{name} is {value!r}; allowed is {allowed}", field=name)


@dataclass(frozen=True)
class LoadCase:
    """Stiffness under one way of loading the element.

    Parameters
    ----------
    name : ``end_flange_free``, ``end_flange_blocked``, ``bearing_pressure``, ``bearing_contact``, ``bearing_bonded``
    stiffness : torque over the rotation that is work-conjugate to it [N m/rad]
    error : relative change of the stiffness in the last refinement
    local_share : part of the rotation that is local to the loaded surface, the rest being the core's; NaN at a flange
    """

    name: str
    stiffness: float
    error: float
    local_share: float = math.nan


@dataclass(frozen=True)
class ContactState:
    """Frictionless unilateral contact with the counter bearing.

    Parameters
    ----------
    area_share : part of the driving area (lever arm in the sense of the torque) that carries pressure
    pressure_mean, pressure_max : on the part that carries, per torque [Pa/(N m)]; the largest is a mean over a mesh
        cell of the pressure, which a rigid edge makes unbounded
    lever : mean lever arm of the pressure [m]
    lost_motion : rotation without torque, from the clearance [rad]; not part of the stiffness
    """

    area_share: float
    pressure_mean: float
    pressure_max: float
    lever: float
    lost_motion: float


@dataclass(frozen=True)
class StressPeaks:
    """Largest stresses per torque, as the shear stress that is equivalent after von Mises [Pa/(N m)].

    Parameters
    ----------
    torsion : at half the active length under the rigid end flange, warping free; NaN for x = 0
    torsion_ratio : that over the section theory's 1/W; NaN where W is 0 (sharp re-entrant corner)
    bearing : in the element under the counter bearing's load, contact and torsion superimposed
    bearing_case : load case that the number belongs to
    bearing_ratio : that over ``torsion``; NaN for x = 0
    distance : points nearer than this to a line where the ideal stress is unbounded (sharp re-entrant corner, edge of
        the clamp, of the bearing and of its contact) are left out [m]; what is found depends on it
    sharp : whether the section has sharp re-entrant corners
    torsion_error, bearing_error : relative change of the two stresses in the last refinement. Refinement ends when the
        stiffness has settled, so the second can be large: the pressure of a rigid bearing is unbounded at its edges
    """

    torsion: float
    torsion_ratio: float
    bearing: float
    bearing_case: str
    bearing_ratio: float
    distance: float
    sharp: bool
    torsion_error: float = math.nan
    bearing_error: float = math.nan


@dataclass(frozen=True, eq=False)
class StressField:
    """Stress on a surface for a picture.

    Parameters
    ----------
    name : ``torsion_section``, ``bearing_section``, ``bearing_surface``
    points : [m], shape (n, 3)
    triangles : shape (m, 3)
    equivalent : von Mises stress per torque [Pa/(N m)], shape (n,)
    """

    name: str
    points: Floats
    triangles: Integers
    equivalent: Floats


@dataclass(frozen=True, eq=False)
class TorsionResult:
    """Answer of the check at one setting.

    Parameters
    ----------
    cases : stiffness per load case
    contact : state of the contact; None where the bearing is bonded, and at x = 0
    stress, fields : largest stresses, and the stress for pictures
    order, unknowns : polynomial order and number of unknowns of the last and largest problem
    seconds : wall time of the computation
    method : in words
    """

    cases: tuple[LoadCase, ...]
    contact: ContactState | None
    stress: StressPeaks
    fields: tuple[StressField, ...]
    order: int
    unknowns: int
    seconds: float
    method: str

    def case(self, name: str) -> LoadCase:
        """Load case of a name.

        Raises
        ------
        KeyError : there is none
        """
        for case in self.cases:
            if case.name == name:
                return case
        raise KeyError(name)

    @property
    def error(self) -> float:
        """Largest relative change of a stiffness in the last refinement."""
        return max(case.error for case in self.cases)
