"""A protection cylinder that keeps a leaf from bending too tightly at its clamp."""

from __future__ import annotations

from typing import Any

from varistiff.fe import import_ngsolve
from varistiff.fe.leaf_solid import LeafSolid

_STIFFNESS = 1e-3  # of the cylinder's surface, in E over the thickness: it gives way by a thousandth of a thickness
_ROUNDING = 5e-4  # of the thickness: the range in which contact begins


def add_guard(solid: LeafSolid, radius: float, youngs_modulus: float) -> None:
    """Put a rigid frictionless cylinder on the leaf's upper face, tangent to it at the clamp.

    It pushes where the face would enter it, by a stiff foundation with pressure k m(g) at the gap g, where

        m(g) = (sqrt(g^2 + e^2) - g)/2

    is 0 outside, -g inside, and smooth between, so that Newton's method sees no kink.

    Parameters
    ----------
    solid : the leaf
    radius : of the mid-plane that lies on the cylinder [m]
    youngs_modulus : of the leaf [Pa]
    """
    ng = import_ngsolve()
    rounding = _ROUNDING * solid.thickness
    stiffness = _STIFFNESS * youngs_modulus / solid.thickness
    surface = radius - 0.5 * solid.thickness

    def density(u: Any) -> Any:
        x, y = (solid.position + u)[0], (solid.position + u)[1] - radius
        gap = ng.sqrt(x * x + y * y) - surface
        inside = 0.5 * (ng.sqrt(gap * gap + rounding**2) - gap)
        return 0.5 * stiffness * inside * inside

    solid.add_upper(density)
