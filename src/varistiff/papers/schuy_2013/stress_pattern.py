"""Where the stress sits: Figs. 10 and 11 and section IV.B."""

from __future__ import annotations

import math
from functools import cache
from itertools import pairwise

import numpy as np
from numpy.typing import NDArray

from varistiff.papers.schuy_2013 import paper_values as paper
from varistiff.papers.schuy_2013.rails import LARGEST, SMALLEST, splined_section
from varistiff.papers.schuy_2013.table_one import CORNERS, KINDS
from varistiff.sections import Circle, Section, SplinedTube
from varistiff.sections.saint_venant import SaintVenant, solve_torsion
from varistiff.sections.stress_field import stress_field

CORNER_REACH = 0.99  # of the way from the axis to a corner: how wide an "edge" is, assumed
_NODES = 12  # Gauss points each way; the stress is smooth there
Floats = NDArray[np.float64]


def table_section(name: str) -> Section:
    """Return a section of Table I with its printed dimension; the circle solid, as in its stress row."""
    if name == "circle":
        return Circle(radius=paper.TABLE_RADIUS)
    return KINDS[name](across_flats=paper.ACROSS_FLATS[name])


def largest_stress(*, section: str) -> float:
    """Return the largest shear stress of a section of Table I at 1 N m [Pa]."""
    return float(paper.PICTURED_TORQUE / table_section(section).torsion_modulus)


def edge_share(*, section: str, reach: float) -> float:
    """Return the stress at a share of the way from the axis to a corner of a polygon, over the largest in it.

    It vanishes in the corner itself, whatever the polygon.
    """
    shape = table_section(section)
    angle = math.pi / CORNERS[section]
    radius = reach * 0.5 * paper.ACROSS_FLATS[section] / math.cos(angle)
    solution = _solved(section)
    near = stress_field(solution, np.array([[radius * math.cos(angle), radius * math.sin(angle)]]))
    largest = solution.torsion_constant / float(shape.torsion_modulus)  # over G theta'
    return float(np.hypot(*near[0])) / largest


def low_stressed_edges_margin() -> float:
    """Return one half minus the largest of the polygons' stress shares, at the assumed width of an edge."""
    return 0.5 - max(edge_share(section=name, reach=CORNER_REACH) for name in KINDS)


def utilisation(*, section: str) -> float:
    """Return the mean of the squared stress over the square of the largest, W^2/(J A): 1/2 for the solid circle."""
    found = table_section(section).properties()
    return float(found.torsion_modulus**2 / (found.torsion_constant * found.area))


def rounder_is_used_better_margin() -> float:
    """Return by how much the utilisation grows at least from one section to the next rounder one."""
    shares = [utilisation(section=name) for name in (*KINDS, "circle")]
    return min(two - one for one, two in pairwise(shares))


def rails_share(section: SplinedTube) -> float:
    """Return the mean squared stress in the rails over that in the tube."""
    solution = solve_torsion(section.outline())
    rail, tube = (_mean_square(solution, *points) for points in (_rail_points(section), _tube_points(section)))
    return rail / tube


def unloaded_rails_margin() -> tuple[float, float]:
    """Return 1 minus that ratio for the smallest and the largest assumed rails: the energy they take for their size."""
    shares = [rails_share(splined_section(width=width, height=height)) for width, height in (SMALLEST, LARGEST)]
    return 1.0 - max(shares), 1.0 - min(shares)


@cache
def _solved(section: str) -> SaintVenant:
    return solve_torsion(table_section(section).outline())


def _mean_square(solution: SaintVenant, points: Floats, weights: Floats) -> float:
    squares = (stress_field(solution, points) ** 2).sum(axis=1)
    return float(np.average(squares, weights=weights))


def _rail_points(section: SplinedTube) -> tuple[Floats, Floats]:
    """Gauss points and weights of half a rail outside the tube's outer circle, without its fillet."""
    nodes, weights = _gauss()
    y = 0.5 * section.rail_width * nodes
    foot = np.sqrt(section.outer_radius**2 - y**2)
    height = section.outer_radius + section.rail_height - foot
    x = foot[:, None] + height[:, None] * nodes
    points = np.stack([x, np.broadcast_to(y[:, None], x.shape)], axis=-1)
    return points.reshape(-1, 2), (weights[:, None] * height[:, None] * weights).ravel()


def _tube_points(section: SplinedTube) -> tuple[Floats, Floats]:
    """Gauss points and weights of half a pitch of the tube between its bore and its outer circle."""
    nodes, weights = _gauss()
    angle = math.pi / section.rails * nodes
    radius = section.inner_radius + (section.outer_radius - section.inner_radius) * nodes
    points = radius[:, None, None] * np.stack([np.cos(angle), np.sin(angle)], axis=-1)
    return points.reshape(-1, 2), (weights[:, None] * radius[:, None] * weights).ravel()


def _gauss() -> tuple[Floats, Floats]:
    """Nodes and weights on [0, 1]."""
    nodes, weights = np.polynomial.legendre.leggauss(_NODES)
    return 0.5 * (nodes + 1.0), 0.5 * weights
