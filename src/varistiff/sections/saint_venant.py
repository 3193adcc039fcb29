"""Saint-Venant torsion of any cross-section by a boundary integral equation.

Twisted by theta' per length, a straight bar moves along its axis by theta' omega(x, y). The warping function omega is
harmonic with the normal derivative g = d(r^2/2)/ds, s the arc length of the boundary with the material on its left.
Green's third identity, with the constant taken out on the left and an integration by parts on the right, leaves

    sum over the boundary of (omega(x) - omega(y)) (y - x).n/|y - x|^2 ds
        = sum of (|y|^2 - |x|^2)/2 (y - x).t/|y - x|^2 ds

with kernels that are smooth along a smooth boundary, so plain Gauss-Legendre panels converge at their full order. Holes
need nothing special: omega is single-valued. Then, r about any origin,

    J = integral of r^2 dA - sum of omega g ds,    shear stress along the boundary = G theta' (domega/ds + x.n).
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from contextlib import nullcontext
from dataclasses import dataclass
from functools import cache

import numpy as np
from numpy.typing import NDArray
from scipy.linalg import lu_factor, lu_solve
from threadpoolctl import ThreadpoolController

from varistiff.sections.boundary import Corner, Placed, boundary_of, gauss, images
from varistiff.sections.close_panels import Replaced, close_kernels
from varistiff.sections.outline import Outline, Points
from varistiff.sections.panels import Nodes, place_nodes
from varistiff.sections.wedge import wedge

Values = NDArray[np.float64]
ORDER, TOLERANCE = 10, 1e-8
THREADED = 2000  # nodes from which on threads pay; below they wait for each other, ten times as long on busy cores
REFINEMENTS, PRECISION = 8, 1e-11  # of a linear solution: steps at most, and the share of the last one
CELLS = 50_000  # of the matrix at a time: what is computed with them stays in the cache


@dataclass(frozen=True)
class SaintVenant:
    """The solved torsion problem of an outline.

    Parameters
    ----------
    outline, nodes : the boundary, nodes about the centroid
    centroid : [m], shape (2,)
    area : [m^2]
    second_moments : about the centroid, integrals of x^2, y^2 and x y [m^4]
    torsion_constant : J [m^4]
    shear_centre : of Trefftz, which does not depend on Poisson's ratio, shape (2,) [m]
    warping : omega at the nodes [m^2]; beside condensed corners, of the polynomial next to it in the mean square
    """

    outline: Outline
    nodes: Nodes
    centroid: tuple[float, float]
    area: float
    second_moments: tuple[float, float, float]
    torsion_constant: float
    shear_centre: tuple[float, float]
    warping: Values

    @property
    def corners(self) -> tuple[Corner, ...]:
        """Corners of the fundamental pieces."""
        return self.nodes.corners

    @property
    def edge_stress(self) -> Values:
        """Shear stress along the boundary over G theta' [m] at the nodes, shape (n,).

        Raises
        ------
        ValueError : nodes with condensed corners, which know the warping beside them only in the mean
        """
        if self.nodes.condensed:
            raise ValueError("the stress beside condensed corners is not known; solve_torsion(outline) grades to them")
        return _derivative(self.nodes, self.warping) + (self.nodes.position * self.nodes.normal).sum(axis=1)


def solve_torsion(
    outline: Outline, *, order: int = ORDER, tolerance: float = TOLERANCE, nodes: Nodes | None = None
) -> SaintVenant:
    """Solve Saint-Venant torsion of an outline.

    Parameters
    ----------
    order : nodes a panel
    tolerance : share of J that the grading to corners may cost
    nodes : the outline's nodes where they are already placed, in place of order and tolerance

    Raises
    ------
    InputError : the boundary comes too close to itself
    """
    if nodes is None:
        nodes = place_nodes(boundary_of(outline), order=order, tolerance=tolerance)
    area, centroid = _area_and_centroid(outline, nodes)
    nodes = _about(nodes, centroid)
    moments = _second_moments(outline, nodes)
    with _blas().limit(limits=1, user_api="blas") if nodes.weight.size < THREADED else nullcontext():
        warping = _warping(outline, nodes)
    copies = outline.rotations * (2 if outline.mirror else 1)
    along = (nodes.position * nodes.tangent).sum(axis=1)
    constant = moments[0] + moments[1] - copies * float((warping * along * nodes.weight).sum())
    offset = _shear_centre(outline, nodes, warping, moments)
    centroid = nodes.origin
    return SaintVenant(
        outline=outline,
        nodes=nodes,
        centroid=(float(centroid[0]), float(centroid[1])),
        area=area,
        second_moments=moments,
        torsion_constant=constant,
        shear_centre=(float(centroid[0] + offset[0]), float(centroid[1] + offset[1])),
        warping=warping,
    )


def _about(nodes: Nodes, place: Points) -> Nodes:
    """The nodes from another origin, which is a place from the present one."""
    condensed = nodes.condensed
    if condensed:
        condensed = condensed._replace(point=condensed.point - place)
    return nodes._replace(position=nodes.position - place, origin=nodes.origin + place, condensed=condensed)


def _whole(outline: Outline, nodes: Nodes) -> tuple[Points, Points, Values]:
    """Positions, normals and weights of the whole boundary."""
    placed = images(outline, nodes.position, nodes.tangent)
    tangent = np.concatenate([one.tangent for one in placed])
    normal = np.stack([tangent[:, 1], -tangent[:, 0]], axis=1)
    return np.concatenate([one.position for one in placed]), normal, np.tile(nodes.weight, len(placed))


def _area_and_centroid(outline: Outline, nodes: Nodes) -> tuple[float, Points]:
    position, normal, weight = _whole(outline, nodes)
    middle = position.mean(axis=0)  # the origin may lie far away
    position = position - middle
    flux = (position * normal).sum(axis=1) * weight
    area = 0.5 * float(flux.sum())
    centroid = middle + (position * flux[:, None]).sum(axis=0) / (3.0 * area)
    if outline.rotations > 1:
        centroid = np.zeros(2)
    elif outline.mirror:
        centroid[1] = 0.0
    return area, centroid


def _second_moments(outline: Outline, nodes: Nodes) -> tuple[float, float, float]:
    position, normal, weight = _whole(outline, nodes)
    flux = (position * normal).sum(axis=1) * weight / 4.0
    x, y = position.T
    return float((x * x * flux).sum()), float((y * y * flux).sum()), float((x * y * flux).sum())


@cache
def _blas() -> ThreadpoolController:
    """What sets the threads of the linear algebra, found once: it takes some milliseconds."""
    return ThreadpoolController()


def _warping(outline: Outline, nodes: Nodes) -> Values:
    """Solve the integral equation for omega at the nodes; its mean is zero."""
    count = nodes.weight.size
    matrix, load, total = np.empty((count, count)), np.empty(count), np.empty(count)
    placed = images(outline, nodes.position, nodes.tangent)
    replaced = close_kernels(nodes) if nodes.condensed else None
    height = max(1, CELLS // count)
    for low in range(0, count, height):
        rows = slice(low, min(low + height, count))
        matrix[rows], load[rows], total[rows] = _equations(nodes, placed, rows, replaced)
    # omega(x) - omega(x): the limit of the right side
    load += (nodes.position * nodes.tangent).sum(axis=1) * nodes.weight
    if nodes.condensed:
        _condense(matrix, load, total, nodes)
    matrix[np.diag_indices(count)] += total
    if not outline.mirror:  # omega is known up to a constant
        matrix += nodes.weight * (2.0 * math.pi / nodes.weight.sum())
    return _solved(matrix, load)


def _solved(matrix: Values, load: Values) -> Values:
    """Solve linear equations by factors in single precision, which take half the time, refined to double."""
    # the transpose lies in memory as LAPACK wants it
    factors = lu_factor(matrix.T.astype(np.float32), overwrite_a=True, check_finite=False)
    found = np.zeros_like(load)
    size = np.inf
    for _ in range(REFINEMENTS):
        step: Values = lu_solve(factors, (load - matrix @ found).astype(np.float32), trans=1, check_finite=False)
        found += step
        before, size = size, float(np.abs(step).max())
        if size <= PRECISION * np.abs(found).max():
            return found
        if not size < 0.1 * before:  # too ill-conditioned for single precision
            break
    factors = lu_factor(matrix.T, overwrite_a=True, check_finite=False)
    exact: Values = lu_solve(factors, load, trans=1, check_finite=False)
    return exact


def _equations(
    nodes: Nodes, placed: Sequence[Placed], rows: slice, replaced: Replaced | None
) -> tuple[Values, Values, Values]:
    """Some rows of the matrix, without what belongs on its diagonal, of the load, and of that diagonal."""
    x, y = nodes.position[rows].T
    half = 0.5 * (nodes.position**2).sum(axis=1)
    matrix, load, total = np.zeros((x.size, half.size)), np.zeros(x.size), np.zeros(x.size)
    for number, one in enumerate(placed):
        # (y - x) ds/|y - x|^2, whose parts along t and n are the kernels
        dx, dy = one.position[:, 0] - x[:, None], one.position[:, 1] - y[:, None]
        square = dx * dx
        square += dy * dy
        if number == 0:
            square[np.arange(x.size), np.arange(rows.start, rows.stop)] = 1.0
        np.divide(nodes.weight, square, out=square)
        dx *= square
        dy *= square
        if replaced is not None:
            points, panels, vectors = replaced.among(rows.start, rows.stop)
            dx.reshape(x.size, -1, nodes.order)[points, panels] = vectors.real
            dy.reshape(x.size, -1, nodes.order)[points, panels] = vectors.imag
        tx, ty = one.tangent.T
        along = dx @ np.stack([tx * half, tx], axis=1) + dy @ np.stack([ty * half, ty], axis=1)
        load += along[:, 0] - half[rows] * along[:, 1]
        dx *= ty
        dy *= tx
        across = np.subtract(dx, dy, out=dx)
        total += across.sum(axis=1)
        matrix -= across if one.sign > 0.0 else -across
    return matrix, load, total


def _condense(matrix: Values, load: Values, total: Values, nodes: Nodes) -> None:
    """Put the condensed corners into matrix and load; the row sums must stay zero in all."""
    assert nodes.condensed is not None
    rows, angle, length, point = nodes.condensed
    corner = wedge(angle, nodes.order)
    matrix[rows[:, :, None], rows[:, None]] += corner.matrix
    total[rows] -= corner.matrix.sum(axis=2)
    # r^2/2 along a side is its value at the corner, a linear part and half the square of the distance
    before, after = -nodes.tangent[rows[:, 0]], nodes.tangent[rows[:, nodes.order]]
    parts = [length * (point * before).sum(axis=1), length * (point * after).sum(axis=1), length**2]
    load[rows] += (corner.loads @ np.stack(parts, axis=1)[:, :, None])[:, :, 0]


def _derivative(nodes: Nodes, values: Values) -> Values:
    """d/ds along each panel, by the polynomial through its nodes."""
    t, w = gauss(nodes.order)
    matrix = differentiation(t)
    speed = nodes.weight.reshape(-1, nodes.order) / w
    found: Values = ((values.reshape(-1, nodes.order) @ matrix.T) / speed).ravel()
    return found


def differentiation(t: Values) -> Values:
    """Matrix that differentiates the polynomial through values at t."""
    gap = t[:, None] - t
    np.fill_diagonal(gap, 1.0)
    weight = 1.0 / gap.prod(axis=1)
    matrix = (weight / weight[:, None]) / gap
    np.fill_diagonal(matrix, 0.0)
    np.fill_diagonal(matrix, -matrix.sum(axis=1))
    return matrix


def _shear_centre(
    outline: Outline, nodes: Nodes, warping: Values, moments: tuple[float, float, float]
) -> tuple[float, float]:
    """Centre of twist about which the warping has no linear part, from the centroid."""
    if outline.rotations > 1:
        return 0.0, 0.0
    placed = images(outline, nodes.position, nodes.tangent)
    first = np.zeros(2)
    for one in placed:
        normal = np.stack([one.tangent[:, 1], -one.tangent[:, 0]], axis=1)
        along = (one.position * one.tangent).sum(axis=1)
        # integral of x omega dA = sum of omega d(x^3/6)/dn - x^3/6 domega/dn
        flux = (one.sign * warping)[:, None] * 0.5 * one.position**2 * normal - one.position**3 / 6.0 * along[:, None]
        first += (flux * nodes.weight[:, None]).sum(axis=0)
    xx, yy, xy = moments
    # the warping has mean zero on the boundary, not over the area: no matter, about the centroid x and y have mean zero
    determinant = xx * yy - xy * xy
    return (xy * first[0] - xx * first[1]) / determinant, (yy * first[0] - xy * first[1]) / determinant
