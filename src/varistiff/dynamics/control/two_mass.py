"""The linear model behind a controller: two inertias and the spring's tangent stiffness."""

from __future__ import annotations

from typing import NamedTuple

import numpy as np

from varistiff.actuators.actuator import Actuator
from varistiff.actuators.compiled import respond_block
from varistiff.core.errors import InputError
from varistiff.dynamics.control.checks import check_number


class TwoMass(NamedTuple):
    """Inertias and viscous dampings of a driven joint.

    ``link_inertia`` J and ``drive_inertia`` J_1 [kg m^2 or kg], rotor included; ``link_damping`` D and
    ``drive_damping`` D_1 [N m s/rad or N s/m]; ``link_stiffness`` [N m/rad or N/m] is that of gravity or a
    surrounding spring between link and ground.
    """

    link_inertia: float
    drive_inertia: float
    link_damping: float = 0.0
    drive_damping: float = 0.0
    link_stiffness: float = 0.0

    def matrices(self, stiffness: float) -> tuple[np.ndarray, np.ndarray]:
        """A (4, 4) and B (4, 1) of x' = A x + B u with x = (q, q', q_1, q_1') and u = u_1.

            J q'' + D q' + K_g q = k (q_1 - q),    J_1 q_1'' + D_1 q_1' = u - k (q_1 - q)

        Parameters
        ----------
        stiffness : k [N m/rad or N/m]

        Raises
        ------
        InputError : an inertia is not above 0, or another number is not finite
        """
        for name in ("link_inertia", "drive_inertia"):
            check_number(name, getattr(self, name), above=0.0)
        for name in ("link_damping", "drive_damping", "link_stiffness"):
            check_number(name, getattr(self, name))
        check_number("stiffness", stiffness)
        j, j_1, k = self.link_inertia, self.drive_inertia, float(stiffness)
        a = np.array(
            [
                [0.0, 1.0, 0.0, 0.0],
                [-(k + self.link_stiffness) / j, -self.link_damping / j, k / j, 0.0],
                [0.0, 0.0, 0.0, 1.0],
                [k / j_1, 0.0, -k / j_1, -self.drive_damping / j_1],
            ]
        )
        return a, np.array([[0.0], [0.0], [0.0], [1.0 / j_1]])


def tangent_stiffness(actuator: Actuator, settings: np.ndarray, *, deflection: float = 0.0) -> np.ndarray:
    """Stiffness [N m/rad or N/m] of the map at one deflection over settings, shape (n,).

    Raises
    ------
    InputError : the map has no positive stiffness at one of them; says where
    """
    response, _ = respond_block(actuator, np.full(settings.size, float(deflection)), np.asarray(settings, dtype=float))
    stiffness = np.asarray(response.stiffness)
    for setting, value in zip(settings, stiffness, strict=True):
        if not value > 0.0:
            raise InputError(
                f"a controller needs a positive stiffness, but the map says {value:.6g} {_unit(actuator)} at a setting "
                f"of {setting:.6g} {actuator.setting_unit} and a deflection of {deflection:.6g}"
            )
    return stiffness


def _unit(actuator: Actuator) -> str:
    return "N*m/rad" if actuator.deflection_unit == "rad" else "N/m"
