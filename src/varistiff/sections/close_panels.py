"""Kernels between a straight panel and points close to it, for which the panel's own quadrature is too coarse."""

from __future__ import annotations

from functools import cache
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from varistiff.sections.boundary import gauss
from varistiff.sections.panels import Nodes

Values = NDArray[np.float64]
Complex = NDArray[np.complex128]
Integers = NDArray[np.int_]
STRAIGHT = 1e-12  # largest change of a straight panel's unit tangent
IN_LINE = 1e-9  # share of a panel by which points in line with it may miss its line
CLOSE = 1e-12  # error of the quadrature of a kernel from which on it is replaced; J of thin walls is a small remainder
WIDEST = 9.0  # sum of the half axes of the largest ellipse around [-1, 1] in which it is


class Replaced(NamedTuple):
    """(y - x) ds/|y - x|^2 of some panels' nodes y at some points x, shape (m, order); ``points`` ascend."""

    points: Integers
    panels: Integers
    vectors: Complex

    def among(self, low: int, high: int) -> Replaced:
        """Those at the points from low to below high, counted from low."""
        part = slice(*np.searchsorted(self.points, (low, high)))
        return Replaced(self.points[part] - low, self.panels[part], self.vectors[part])


def close_kernels(nodes: Nodes) -> Replaced:
    """What stands for the kernels of straight panels at all nodes of a boundary that are close to them.

    (y - x)/|y - x|^2 ds is the conjugate of ds/(y - x). With z = (x - centre)/(half length times t), where the panel is
    [-1, 1], the integral of a polynomial over tau - z follows from its moments: p_0 = log((1 - z)/(-1 - z)) and
    p_k+1 = z p_k + (1 + (-1)^k)/(k + 1) (Helsing and Ojala, Journal of Computational Physics 227 (2008) 2899,
    https://doi.org/10.1016/j.jcp.2007.11.024). So the result is exact for polynomials of the panel's order less one,
    however close the point. The recursion loses digits away from the panel, where it is not used. What the two sides of
    a condensed corner do to each other is zero here, because the corner's own matrix has it.
    """
    order = nodes.order
    t, _ = gauss(order)
    at: Complex = nodes.position[:, 0] + 1.0j * nodes.position[:, 1]
    first, last = at[::order], at[order - 1 :: order]
    tangent = nodes.tangent.reshape(-1, order, 2)
    straight = np.flatnonzero((np.abs(tangent - tangent[:, :1]) < STRAIGHT).all(axis=(1, 2)))
    centre, half = 0.5 * (first + last)[straight], (0.5 * (last - first) / (t[-1] - t[0]))[straight]
    # a kernel alone is integrated to the sum of the half axes of the ellipse through z to the power -2 order
    radius = min(CLOSE ** (-0.5 / order), WIDEST)
    longest = 0.5 * (radius + 1.0 / radius)
    gap_x, gap_y = (part(at)[:, None] - part(centre) for part in (np.real, np.imag))
    points, panels = np.nonzero(gap_x * gap_x + gap_y * gap_y < (longest * np.abs(half)) ** 2)
    z = (at[points] - centre[panels]) / half[panels]
    # in line with the panel, or on it, the kernel is a polynomial where it counts
    close = (np.abs(z + 1.0) + np.abs(z - 1.0) < 2.0 * longest) & (np.abs(z.imag) > IN_LINE)
    close &= points // order != straight[panels]
    points, panels, vectors = points[close], straight[panels[close]], _moments(z[close], order) @ _weights(order)
    # they are those of t ds/(y - x), with t along the panel
    vectors = vectors.conj() * (half / np.abs(half))[np.searchsorted(straight, panels), None]
    if nodes.condensed:
        before, after = np.split(nodes.condensed.rows, 2, axis=1)
        panel = np.stack([after, before])[:, :, :1] // order
        points = np.concatenate([points, np.stack([before, after]).ravel()])
        panels = np.concatenate([panels, np.broadcast_to(panel, (2, *before.shape)).ravel()])
        vectors = np.concatenate([vectors, np.zeros((2 * before.size, order))])
    rank = np.argsort(points, kind="stable")
    return Replaced(points[rank], panels[rank], vectors[rank])


def _moments(z: Complex, order: int) -> Complex:
    found = np.empty((z.size, order), complex)
    found[:, 0] = np.log((1.0 - z) / (-1.0 - z))
    for power in range(1, order):
        found[:, power] = z * found[:, power - 1] + (power % 2) * 2.0 / power
    return found


@cache
def _weights(order: int) -> Values:
    """Moments to weights of a panel's nodes."""
    t, _ = gauss(order)
    return np.asarray(np.linalg.inv(np.vander(2.0 * t - 1.0, increasing=True)), dtype=np.float64)
