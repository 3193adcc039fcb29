"""Shear stress inside a cross-section in torsion."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from varistiff.sections.boundary import images
from varistiff.sections.outline import Points
from varistiff.sections.saint_venant import SaintVenant

CELLS = 2_000_000  # complex numbers held at once: 32 MB
ON_A_NODE = 1e-30  # distance [m] that leaves nothing of the quotient but the node's own value


def stress_field(solution: SaintVenant, points: Points) -> Points:
    """Return the shear stress (tau_x, tau_y) over G theta' [m] at points inside a solved section.

    With the warping function omega, x and y from the centroid,

        tau_x = G theta' (domega/dx - y),    tau_y = G theta' (domega/dy + x)

    and f = domega/dx - i domega/dy is analytic in the section. Along the boundary f = (domega/ds + i domega/dn)/T with
    the tangent T as a complex number, and Cauchy's formula gives it inside. It is used as the quotient

        f(z0) = sum(f w T/(z - z0)) / sum(w T/(z - z0))

    over all nodes z with weights w, in which the error near the boundary cancels.

    Parameters
    ----------
    solution : as ``solve_torsion`` returns it
    points : in the section's coordinates, shape (n, 2) [m]; inside or on the boundary, elsewhere the result is void

    Returns
    -------
    Shape (n, 2) [m]: times torque/J it is the stress. Its largest error is about that of the warping; within a
    thousandth of the size from a corner it is not resolved.

    >>> import numpy as np
    >>> from varistiff.sections import Circle
    >>> from varistiff.sections.saint_venant import solve_torsion
    >>> field = stress_field(solve_torsion(Circle(radius=0.01).outline()), np.array([[0.003, 0.004]]))
    >>> np.round(field, 9).tolist()
    [[-0.004, 0.003]]
    """
    boundary, values, weight = _boundary_values(solution)
    about = points - np.array(solution.centroid)
    at = about @ [1.0, 1.0j]
    found = np.empty(at.size, complex)
    rows = max(1, CELLS // boundary.size)
    for start in range(0, at.size, rows):
        gap = boundary - at[start : start + rows, None]
        gap[gap == 0.0] = ON_A_NODE
        kernel = np.divide(weight, gap, out=gap)
        found[start : start + rows] = (kernel @ values) / kernel.sum(axis=1)
    return np.stack([found.real - about[:, 1], -found.imag + about[:, 0]], axis=1)


def _boundary_values(
    solution: SaintVenant,
) -> tuple[NDArray[np.complex128], NDArray[np.complex128], NDArray[np.complex128]]:
    """Nodes, domega/dx - i domega/dy there, and T ds, for the whole boundary."""
    nodes = solution.nodes
    along = (nodes.position * nodes.tangent).sum(axis=1)
    slope = solution.edge_stress - (nodes.position * nodes.normal).sum(axis=1)
    where, values, weights = [], [], []
    for placed in images(solution.outline, nodes.position, nodes.tangent):
        tangent = placed.tangent @ [1.0, 1.0j]
        # a reflection turns the warping and the tangent round: the slope along the boundary stays, the one across turns
        values.append((slope + 1j * placed.sign * along) * tangent.conj())
        where.append(placed.position @ [1.0, 1.0j])
        weights.append(tangent * nodes.weight)
    return np.concatenate(where), np.concatenate(values), np.concatenate(weights)
