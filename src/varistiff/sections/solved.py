"""Section properties from the solved torsion problem, with a stated error."""

from __future__ import annotations

import numpy as np

from varistiff.sections.boundary import gauss, images
from varistiff.sections.outline import Outline, Points
from varistiff.sections.properties import SectionProperties
from varistiff.sections.rungs import settled
from varistiff.sections.saint_venant import SaintVenant, Values


def solved_properties(outline: Outline) -> SectionProperties:
    """Solve torsion of an outline and return the section's properties.

    The stated error comes from a coarser solution, see ``stated_error``; it was found larger than the error itself.

    Raises
    ------
    InputError : walls or gaps too thin, or too many corners
    """
    fine, error = settled(outline)
    peak, places = largest_stress(fine)
    return SectionProperties(
        area=fine.area,
        centroid=fine.centroid,
        second_moments=fine.second_moments,
        torsion_constant=fine.torsion_constant,
        torsion_modulus=fine.torsion_constant / peak,
        stress_points=tuple((float(x), float(y)) for x, y in places),
        shear_centre=fine.shear_centre,
        error=error,
        method="boundary integral",
    )


def largest_stress(solution: SaintVenant) -> tuple[float, Points]:
    """Largest shear stress over G theta' [m], which always sits on the boundary, and every point where it does.

    Infinite at a sharp re-entrant corner: the stress goes with the distance to the power pi/angle - 1 there.
    """
    outline = solution.outline
    sharp = [corner.point for corner in solution.corners if corner.is_reentrant]
    if sharp:
        points = np.array(sharp)
        return np.inf, _distinct(np.concatenate([one.position for one in images(outline, points, points)]))
    order = solution.nodes.order
    t, _ = gauss(order)
    values = solution.edge_stress.reshape(-1, order)
    dense = interpolation(t, np.linspace(0.0, 1.0, 201))
    found = np.abs(values @ dense.T)
    panel = int(np.argmax(found.max(axis=1)))
    at = dense[int(np.argmax(found[panel]))]
    place = at @ solution.nodes.position.reshape(-1, order, 2)[panel] + solution.centroid
    copies = images(outline, place[None], place[None])
    return float(found[panel].max()), _distinct(np.concatenate([one.position for one in copies]))


def interpolation(nodes: Values, at: Values) -> Values:
    """Matrix that evaluates the polynomial through values at ``nodes``."""
    columns = []
    for number, node in enumerate(nodes):
        others = np.delete(nodes, number)
        columns.append(np.prod((at[:, None] - others) / (node - others), axis=1))
    return np.stack(columns, axis=1)


def _distinct(points: Points) -> Points:
    size = float(np.abs(points).max()) or 1.0
    _, first = np.unique(np.round(points / (1e-6 * size)), axis=0, return_index=True)
    kept: Points = points[np.sort(first)]
    return kept
