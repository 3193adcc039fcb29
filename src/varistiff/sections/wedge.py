"""A corner between two straight sides, condensed to the few nodes of one panel on each.

Near a corner with the angle beta inside the material the warping goes with powers k pi/beta of the distance, and the
integral operator has more powers of its own, so plain panels must be graded to it. What lies outside sees little of
that. Write the integral equation of two sides of length 1 as (pi - K) omega = P g + f: K is the kernel between them, g
the smooth part of the load, on polynomials P of low degree, and f what the two sides cause to each other. The outside
needs no more of omega than its projection on the same polynomials,

    omega_c = R g + r,    R = P' W (pi - K)^-1 P,    r = P' W (pi - K)^-1 f,

which depends on nothing but beta, because K does not change with the length. So S = R^-1 takes the place of pi - K in
the equation on the few nodes, and S r is added to its load: exact but for what polynomials miss of g. R and r come from
a finely graded mesh and are interpolated over beta.

The idea is that of Helsing and Ojala, Journal of Computational Physics 227 (2008) 8820,
https://doi.org/10.1016/j.jcp.2008.06.022, without its recursion.
"""

from __future__ import annotations

import math
from functools import cache
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from varistiff.sections.boundary import gauss

Values = NDArray[np.float64]
NARROW = math.radians(20.0)  # sharper corners and slots see each other too closely along their sides
DEGREES = 10  # polynomials on a side
ANGLES = 40  # of the interpolation: R is singular at 0 and 2 pi, which leaves 4e-8
RATIO, LEVELS = 3.0, 30  # of the fine mesh: its innermost panel is 1e-14 long
FINEST, COARSEST = 14, 4  # nodes of its panels: inside their errors count less


class Wedge(NamedTuple):
    """Corners on their nodes: first those of the side before the corner, outward from it, then those of the side after.

    ``matrix`` is S, shape (m, 2 n, 2 n). ``loads`` is S r, shape (m, 2 n, 3), for a half square of the distance from
    the origin that is x + s along the side before the corner, x + s along the one after it, and x + s^2 along both,
    where x is its value at the corner and s the distance from there.
    """

    matrix: Values
    loads: Values


def wedge(angles: Values, order: int) -> Wedge:
    """Condense corners with these angles inside the material [rad], shape (m,), to ``order`` nodes a side.

    Angles are from NARROW to 2 pi - NARROW, orders at most DEGREES.
    """
    table = _table()
    scaled = (angles - math.pi) / (math.pi - NARROW)
    found = np.polynomial.chebyshev.chebvander(scaled, ANGLES - 1) @ table
    found = found.reshape(-1, DEGREES, 2 * DEGREES + 3)[:, :order]
    t, w = gauss(order)
    basis = _polynomials(t, order)
    # on the nodes a function is basis @ its coefficients, and these are basis' @ (w times the function)
    to_nodes, to_basis = basis, basis.T * w
    even = np.linalg.inv(found[:, :, :order])
    odd = np.linalg.inv(found[:, :, DEGREES : DEGREES + order])
    even_loads = to_nodes @ even @ found[:, :, -3:-2]
    odd_loads = to_nodes @ odd @ found[:, :, -2:]
    even, odd = to_nodes @ even @ to_basis, to_nodes @ odd @ to_basis
    same, other = 0.5 * (even + odd), 0.5 * (even - odd)
    before = np.concatenate([even_loads + odd_loads[:, :, :1], odd_loads[:, :, :1] - even_loads], axis=2)
    after = np.concatenate([even_loads - odd_loads[:, :, :1], -even_loads - odd_loads[:, :, :1]], axis=2)
    square = odd_loads[:, :, 1:]
    return Wedge(
        np.block([[same, other], [other, same]]),
        np.concatenate(
            [np.concatenate([0.5 * before, square], axis=2), np.concatenate([0.5 * after, -square], axis=2)], axis=1
        ),
    )


def _polynomials(t: Values, count: int) -> Values:
    """Orthonormal Legendre polynomials on [0, 1] at t, one a column."""
    found: Values = np.polynomial.legendre.legvander(2.0 * t - 1.0, count - 1) * np.sqrt(2.0 * np.arange(count) + 1.0)
    return found


@cache
def _table() -> Values:
    """Chebyshev coefficients over the angle of R for even and odd functions, and of three r, rows flattened."""
    scaled = np.polynomial.chebyshev.chebpts1(ANGLES)
    s, weight = _mesh()
    half = [_condensed(math.pi + (math.pi - NARROW) * place, s, weight) for place in scaled[: ANGLES // 2]]
    values = [own for own, _ in half] + [other for _, other in reversed(half)]
    coefficients = np.linalg.solve(np.polynomial.chebyshev.chebvander(scaled, ANGLES - 1), values)
    return np.asarray(coefficients, dtype=np.float64)


def _mesh() -> tuple[Values, Values]:
    """Nodes and weights on [0, 1], finely graded to 0."""
    marks = np.concatenate([[0.0], RATIO ** np.arange(1.0 - LEVELS, 1.0)])
    nodes, weights = [], []
    for number, (low, width) in enumerate(zip(marks[:-1], np.diff(marks), strict=True)):
        share = min(1.0, number / (0.75 * LEVELS))
        t, w = gauss(round(COARSEST + (FINEST - COARSEST) * share))
        nodes.append(low + width * t)
        weights.append(width * w)
    return np.concatenate(nodes), np.concatenate(weights)


def _condensed(angle: float, s: Values, weight: Values) -> tuple[Values, Values]:
    """R for even and odd functions and the three r, flattened, of one angle and of 2 pi less that angle.

    The sides lie symmetrically: a function is its even and its odd part, and the reflection turns the tangents round.
    The other angle has -K in place of K, so that even and odd change places.
    """
    # t ds/(y - x) as for all panels, from a point of the side before the corner to one of the side after it
    near, high = s[:, None] * math.cos(angle), s[:, None] * math.sin(angle)
    share = weight / ((s - near) ** 2 + high**2)
    along, across = share * (s - near), share * high
    own, other = -s * along.sum(axis=1), along @ s
    square = 0.5 * (along @ (s * s) - s * s * along.sum(axis=1))
    basis = _polynomials(s, DEGREES)
    given = np.column_stack([basis, own - other, own + other, square])
    unit = math.pi * np.eye(s.size)
    even, odd = ((basis.T * weight) @ np.linalg.solve(unit + way * across, given) for way in (-1.0, 1.0))
    n = DEGREES
    first, second = (
        np.concatenate([one[:, :n], two[:, :n], one[:, n : n + 1], two[:, n + 1 :]], axis=1).ravel()
        for one, two in ((even, odd), (odd, even))
    )
    return first, second
