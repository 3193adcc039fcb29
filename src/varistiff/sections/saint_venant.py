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
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray
from scipy.linalg import lu_factor, lu_solve

from varistiff.sections.outline import Outline, Points
from varistiff.sections.panels import Corner, Nodes, boundary_of, gauss, images, place_nodes

Values = NDArray[np.float64]
ORDER, TOLERANCE = 10, 1e-8


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
    warping : omega at the nodes [m^2]
    edge_stress : shear stress along the boundary over G theta' [m], shape (n,)
    """

    outline: Outline
    nodes: Nodes
    centroid: tuple[float, float]
    area: float
    second_moments: tuple[float, float, float]
    torsion_constant: float
    shear_centre: tuple[float, float]
    warping: Values
    edge_stress: Values

    @property
    def corners(self) -> tuple[Corner, ...]:
        """Corners of the fundamental pieces."""
        return self.nodes.corners


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
    nodes = nodes._replace(position=nodes.position - centroid)
    moments = _second_moments(outline, nodes)
    warping = _warping(outline, nodes)
    copies = outline.rotations * (2 if outline.mirror else 1)
    along = (nodes.position * nodes.tangent).sum(axis=1)
    constant = moments[0] + moments[1] - copies * float((warping * along * nodes.weight).sum())
    edge = _derivative(nodes, warping) + (nodes.position * nodes.normal).sum(axis=1)
    offset = _shear_centre(outline, nodes, warping, moments)
    return SaintVenant(
        outline=outline,
        nodes=nodes,
        centroid=(float(centroid[0]), float(centroid[1])),
        area=area,
        second_moments=moments,
        torsion_constant=constant,
        shear_centre=(float(centroid[0] + offset[0]), float(centroid[1] + offset[1])),
        warping=warping,
        edge_stress=edge,
    )


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


def _warping(outline: Outline, nodes: Nodes) -> Values:
    """Solve the integral equation for omega at the nodes; its mean is zero."""
    at = nodes.position @ [1.0, 1.0j]
    half = 0.5 * np.abs(at) ** 2
    count = at.size
    matrix, load, total = np.zeros((count, count)), np.zeros(count), np.zeros(count)
    for number, placed in enumerate(images(outline, nodes.position, nodes.tangent)):
        # t ds/(y - x) as complex numbers: its real part is (y - x).t ds/|y - x|^2, its imaginary part (y - x).n ds/...
        gap = placed.position @ [1.0, 1.0j] - at[:, None]
        if number == 0:
            np.fill_diagonal(gap, 1.0)
        kernel = np.divide((placed.tangent @ [1.0, 1.0j]) * nodes.weight, gap, out=gap)
        if number == 0:  # omega(x) - omega(x), and the limit of the right side
            np.fill_diagonal(kernel, 0.0)
            load += (nodes.position * nodes.tangent).sum(axis=1) * nodes.weight
        total += kernel.imag.sum(axis=1)
        load += kernel.real @ half - half * kernel.real.sum(axis=1)
        matrix -= placed.sign * kernel.imag
    matrix[np.diag_indices(count)] += total
    if not outline.mirror:  # omega is known up to a constant
        matrix += nodes.weight * (2.0 * math.pi / nodes.weight.sum())
    # the transpose lies in memory as LAPACK wants it, so nothing is copied
    factors = lu_factor(matrix.T, overwrite_a=True, check_finite=False)
    found: Values = lu_solve(factors, load, trans=1, check_finite=False)
    return found


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
