"""Table I: four sections of equal stiffness, their factors and their largest stresses."""

from __future__ import annotations

import math
from collections.abc import Sequence
from itertools import pairwise

from varistiff.papers.schuy_2013 import paper_values as paper
from varistiff.papers.schuy_2013.device import bare_tube, length_of_stiffness, respond, stiffness, tube_of
from varistiff.sections import Circle, Hexagon, Octagon, Section, Square

KINDS: dict[str, type[Square] | type[Hexagon] | type[Octagon]] = {
    "square": Square,
    "hexagon": Hexagon,
    "octagon": Octagon,
}
CORNERS = {"square": 4, "hexagon": 6, "octagon": 8}
_REQUIRED = paper.STIFFNESS_MAX * paper.LENGTH_MIN  # G J [N m^2]
Interval = tuple[float, float]


def stiffness_factor(*, section: str) -> float:
    """Return c_g = J/b^4 of a regular polygon, b across flats."""
    return float(KINDS[section](across_flats=1.0).torsion_constant)


def resistance_factor(*, section: str) -> float:
    """Return c_r = W/b^3 of a regular polygon, b across flats."""
    return float(KINDS[section](across_flats=1.0).torsion_modulus)


def circle_factor_margin(*, of: str) -> float:
    """Return 1e-12 minus the relative error of the circle's pi/32 (``c_g``) or pi/16 (``c_r``), over the diameter."""
    circle = Circle(radius=0.5)  # diameter 1
    found = circle.torsion_constant / (math.pi / 32.0) if of == "c_g" else circle.torsion_modulus / (math.pi / 16.0)
    return 1e-12 - abs(found - 1.0)


def across_flats(*, section: str, shear_modulus: float = paper.POLYAMIDE) -> float:
    """Return the distance b of parallel sides with the stiffness asked for [m]; Eq. (6) without its factor 2.

    The stiffness of a section goes with the fourth power of its size, so the device of size 1 m gives the size.
    """
    return _size(KINDS[section](across_flats=1.0), shear_modulus)


def radius(*, ratio: float = paper.HOLLOW_RATIO, shear_modulus: float = paper.POLYAMIDE) -> float:
    """Return the outer radius of the cylinder with the stiffness asked for [m], hollow by ``ratio``; Eq. (4)."""
    unit = bare_tube(shear_modulus=shear_modulus, bore_ratio=ratio, outer_radius=1.0)
    return float((paper.STIFFNESS_MAX / stiffness(unit, active_length=paper.LENGTH_MIN)) ** 0.25)


def across_flats_as_printed(*, section: str, shear_modulus: float = paper.POLYAMIDE) -> float:
    """Return b after the printed Eq. (6), with its stray factor 2 and the printed c_g [m]."""
    return float((2.0 * _REQUIRED / (shear_modulus * paper.STIFFNESS_FACTORS[section])) ** 0.25)


def modulus_interval(*, factor: float, size: float) -> Interval:
    """Return the shear moduli [Pa] for which the dimension rounds to the printed one.

    Parameters
    ----------
    factor : J over the fourth power of the dimension
    size : printed dimension [m]
    """
    low, high = (_REQUIRED / (factor * (size + way * paper.HALF_DIGIT) ** 4) for way in (1.0, -1.0))
    return low, high


def cylinder_interval(*, ratio: float) -> Interval:
    """Return the shear moduli [Pa] for which the cylinder, hollow by ``ratio``, rounds to the printed radius."""
    return modulus_interval(factor=0.5 * math.pi * (1.0 - ratio**4), size=paper.TABLE_RADIUS)


def polygon_interval(*, section: str, exact: bool) -> Interval:
    """Return the shear moduli [Pa] for which a polygon rounds to its printed b, with the exact or the printed c_g."""
    factor = stiffness_factor(section=section) if exact else paper.STIFFNESS_FACTORS[section]
    return modulus_interval(factor=factor, size=paper.ACROSS_FLATS[section])


def common_modulus(*, ratio: float = paper.HOLLOW_RATIO, exact: bool = False) -> Interval | None:
    """Return the shear moduli [Pa] that meet all four dimensions of Table I, or None where there is none."""
    every = [cylinder_interval(ratio=ratio), *(polygon_interval(section=name, exact=exact) for name in KINDS)]
    return overlap(every)


def overlap(intervals: Sequence[Interval]) -> Interval | None:
    """Return what intervals have in common, or None."""
    low, high = max(one[0] for one in intervals), min(one[1] for one in intervals)
    return (low, high) if low < high else None


def stress_ratio(*, section: str) -> float:
    """Return the largest stress of a polygon over the solid cylinder's at equal torque; Eq. (7).

    Dimensions and factors as Table I prints them: the cylinder is solid here, though its radius is a hollow one's.
    """
    return _ratio(paper.RESISTANCE_FACTORS[section] * paper.ACROSS_FLATS[section] ** 3, hollow=False)


def stress_ratio_hollow(*, section: str) -> float:
    """Return the same over the hollow cylinder of the printed radius."""
    return _ratio(paper.RESISTANCE_FACTORS[section] * paper.ACROSS_FLATS[section] ** 3, hollow=True)


def stress_ratio_at_equal_stiffness(*, section: str, ratio: float, size_ratio: float | None = None) -> float:
    """Return the same with exact factors and dimensions, the cylinder hollow by ``ratio``.

    ``size_ratio`` is the one by which the cylinder's radius is found; another than ``ratio`` mixes two cylinders, as
    the table does. The shear modulus cancels.
    """
    outer = radius(ratio=ratio if size_ratio is None else size_ratio)
    cylinder = bare_tube(shear_modulus=1e9, bore_ratio=ratio, outer_radius=outer)
    polygon = KINDS[section](across_flats=across_flats(section=section))
    return float(cylinder.torsion_modulus / polygon.torsion_modulus)


def rounder_is_better_margin() -> float:
    """Return by how much the stress ratio falls at least from one section to the next rounder one."""
    ratios = [stress_ratio_at_equal_stiffness(section=name, ratio=0.0) for name in KINDS] + [1.0]
    return min(one - two for one, two in pairwise(ratios))


def rounder_is_smaller_margin() -> float:
    """Return by how much the circle around a section shrinks at least towards the next rounder one, of its size."""
    around = [across_flats(section=name) / math.cos(math.pi / CORNERS[name]) for name in KINDS]
    around.append(2.0 * radius(ratio=0.0))
    return min(one / two - 1.0 for one, two in pairwise(around))


def comparable_dimensions_margin() -> float:
    """Return 0.2 minus the spread of the four widths (b, or the cylinder's diameter) over the smallest."""
    widths = [across_flats(section=name) for name in KINDS] + [2.0 * radius()]
    return 0.2 - (max(widths) / min(widths) - 1.0)


def length_of_softest() -> Interval:
    """Return the active length [m] at which the four sections of equal stiffness are softest: smallest and largest."""
    sections: list[Section] = [KINDS[name](across_flats=across_flats(section=name)) for name in KINDS]
    tubes = [tube_of(shear_modulus=paper.POLYAMIDE, section=section) for section in sections]
    tubes.append(bare_tube(shear_modulus=paper.POLYAMIDE, bore_ratio=paper.HOLLOW_RATIO, outer_radius=radius()))
    lengths = [length_of_stiffness(tube, wanted=paper.STIFFNESS_MIN) for tube in tubes]
    return min(lengths), max(lengths)


def factors_transfer_margin() -> float:
    """Return 1 % minus the largest error of the printed factors c_g and c_r of the polygons."""
    errors = [paper.STIFFNESS_FACTORS[name] / stiffness_factor(section=name) - 1.0 for name in KINDS]
    errors += [paper.RESISTANCE_FACTORS[name] / resistance_factor(section=name) - 1.0 for name in KINDS]
    return 0.01 - max(abs(error) for error in errors)


def oversizing_margin() -> float:
    """Return 1 % minus the largest error of W of a polygon that is scaled to the cylinder's stress at equal torque.

    It has to be larger by the cube root of its stress ratio, here as printed.
    """
    cylinder, worst = Circle(radius=paper.TABLE_RADIUS).torsion_modulus, 0.0
    for name, kind in KINDS.items():
        scaled = kind(across_flats=paper.ACROSS_FLATS[name] * paper.STRESS_RATIOS[name] ** (1.0 / 3.0))
        worst = max(worst, abs(float(scaled.torsion_modulus / cylinder) - 1.0))
    return 0.01 - worst


def _size(unit: Section, shear_modulus: float) -> float:
    tube = tube_of(shear_modulus=shear_modulus, section=unit)
    return float((paper.STIFFNESS_MAX / stiffness(tube, active_length=paper.LENGTH_MIN)) ** 0.25)


def _ratio(modulus: float, *, hollow: bool) -> float:
    bore = paper.HOLLOW_RATIO if hollow else 0.0
    cylinder = bare_tube(shear_modulus=1e9, bore_ratio=bore, outer_radius=paper.TABLE_RADIUS)
    found = respond(cylinder, twist=1e-3, active_length=paper.LENGTH_MIN)
    return float(found.load / found.stress) / modulus  # W of the cylinder over that of the polygon
