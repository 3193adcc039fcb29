"""The shape of a leaf under one force normal to its end, for the drawings."""

from __future__ import annotations

import numpy as np
from scipy.special import elliprd


def leaf_shape(slope: float, scale: float, points: int = 120) -> np.ndarray:
    """Return the curve, of shape (points, 2), from the clamp at the origin to a contact of this slope [rad].

    With psi the angle left to turn, the distance to the contact is 2 k sqrt(sin psi) along the contact's
    tangent and k I2(psi) across it; scale is k.
    """
    remaining = slope * np.linspace(1, 0, points) ** 2
    root = np.sqrt(np.sin(remaining))
    across = 2 / 3 * root**3 * elliprd(1 - root**2, 1 + root**2, 1)
    tangent = np.array([np.cos(slope), np.sin(slope)])
    normal = np.array([-np.sin(slope), np.cos(slope)])
    behind = scale * (2 * root[:, None] * tangent - across[:, None] * normal)
    return behind[0] - behind
