"""Section properties from the solved torsion problem, with a stated error."""

from __future__ import annotations

import math
from collections.abc import Callable
from contextlib import suppress
from typing import NamedTuple

import numpy as np

from varistiff.core.errors import InputError
from varistiff.sections.condensed import place_condensed
from varistiff.sections.outline import Outline, Points
from varistiff.sections.panels import NODES_MAX, Boundary, Nodes, boundary_of, gauss, images, place_nodes
from varistiff.sections.properties import SectionProperties
from varistiff.sections.saint_venant import SaintVenant, Values, solve_torsion

GAP = math.radians(60.0)  # outside a re-entrant corner: from here on order 4 may leave more than 1e-4
QUICK = 1024  # nodes on the whole boundary: of the rungs with fewer, the finest is used


class Rung(NamedTuple):
    """Nodes a panel and share of J given up at a corner, of a solution and of the coarser one that tells its error.

    ``most`` is the number of nodes up to which it counts as quick, ``beside_gaps`` the same where there is a gap
    narrower than GAP.
    """

    fine: tuple[int, float]
    coarse: tuple[int, float]
    most: int = QUICK
    beside_gaps: int = QUICK


RUNGS = (
    Rung((10, 1e-8), (8, 1e-6)),
    Rung((8, 1e-6), (6, 3e-5)),
    Rung((6, 1e-6), (4, 3e-6)),
    Rung((6, 1e-5), (4, 3e-5)),
    Rung((4, 1e-5), (3, 1e-4)),
    Rung((4, 3e-5), (3, 3e-4)),
    Rung((4, 1e-4), (3, 1e-3)),
)
# where corners are condensed the shares are left to the few that are not, and what counts is the nodes
CONDENSED_RUNGS = (
    Rung((10, 1e-9), (8, 1e-8)),
    Rung((8, 1e-8), (6, 1e-7)),
    Rung((6, 1e-7), (5, 1e-6)),
    Rung((5, 1e-6), (4, 1e-5), beside_gaps=1280),
    Rung((4, 1e-5), (3, 1e-4)),
)
ROUNDING = 1e-14
CONDENSED_ERROR = 1e-8  # of what is interpolated over the angle, which both solutions share


def solved_properties(outline: Outline) -> SectionProperties:
    """Solve torsion of an outline and return the section's properties.

    The stated error is the difference in J from a coarser solution, which is larger than the error itself.

    Raises
    ------
    InputError : walls or gaps too thin, or too many corners
    """
    fine, coarse = (solve_torsion(outline, nodes=nodes) for nodes in rung_nodes(outline))
    peak, places = largest_stress(fine)
    return SectionProperties(
        area=fine.area,
        centroid=fine.centroid,
        second_moments=fine.second_moments,
        torsion_constant=fine.torsion_constant,
        torsion_modulus=fine.torsion_constant / peak,
        stress_points=tuple((float(x), float(y)) for x, y in places),
        shear_centre=fine.shear_centre,
        error=max(difference(fine, coarse), CONDENSED_ERROR if fine.nodes.condensed else ROUNDING),
        method="boundary integral",
    )


def rung_nodes(outline: Outline) -> tuple[Nodes, Nodes]:
    """Nodes of the finest rung that stays quick, or else of the last one, and those of its coarser solution.

    Corners are condensed where the outline has re-entrant ones, at which the stress is unbounded, and no symmetry.

    Raises
    ------
    InputError : walls or gaps too thin, or too many corners
    """
    boundary = boundary_of(outline)
    copies = outline.rotations * (2 if outline.mirror else 1)
    condensed = copies == 1 and any(corner.is_reentrant for corner in boundary.corners)
    place, rungs = (place_condensed, CONDENSED_RUNGS) if condensed else (place_nodes, RUNGS)
    gap = 2.0 * math.pi - max((corner.interior_angle for corner in boundary.corners), default=math.pi)
    *quick, last = rungs
    for rung in quick:
        most = rung.most if gap > GAP else rung.beside_gaps
        with suppress(InputError):
            return _placed(boundary, place, rung, int(most / math.sqrt(copies)))
    return _placed(boundary, place, last, NODES_MAX)


def _placed(boundary: Boundary, place: Callable[..., Nodes], rung: Rung, limit: int) -> tuple[Nodes, Nodes]:
    fine, coarse = (
        place(boundary, order=order, tolerance=share, limit=limit) for order, share in (rung.fine, rung.coarse)
    )
    return fine, coarse


def difference(fine: SaintVenant, coarse: SaintVenant) -> float:
    """Relative difference of J between two solutions of one outline, without cancellation.

    It is the sum over the segments of the boundary: what one corner has too much hides nothing of what another lacks.
    """
    return float(np.abs(_terms(coarse) - _terms(fine)).sum()) / fine.torsion_constant


def _terms(solution: SaintVenant) -> Values:
    """What J is the sum of [m^4]: the warping along each segment, and the polar moment."""
    nodes, outline = solution.nodes, solution.outline
    along = (nodes.position * nodes.tangent).sum(axis=1)
    starts = np.cumsum([0, *(t.size for t in nodes.parameters[:-1])])
    copies = outline.rotations * (2 if outline.mirror else 1)
    warping = np.add.reduceat(solution.warping * along * nodes.weight, starts)
    return np.append(-copies * warping, sum(solution.second_moments[:2]))


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
