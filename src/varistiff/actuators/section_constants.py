"""The numbers of a cross-section that a datasheet states."""

from __future__ import annotations

import math

from varistiff.actuators.actuator import Constant
from varistiff.sections.filleted import filleted
from varistiff.sections.properties import SectionProperties
from varistiff.sections.section import Section


def section_constants(section: Section) -> dict[str, Constant]:
    """Return area, torsion and second moments of a section, and its centres where they are not the origin."""
    found = section.properties()
    size = math.sqrt(found.area)
    xx, yy, xy = found.second_moments
    constants = {
        "section_area": Constant(found.area, "area of the section", "m^2"),
        "torsion_constant": Constant(found.torsion_constant, "torsion constant J", "m^4", _accuracy(found)),
        "torsion_modulus": _modulus(section, found),
        "second_moment_xx": Constant(xx, "second moment, integral of x^2", "m^4", "about the centroid"),
        "second_moment_yy": Constant(yy, "second moment, integral of y^2", "m^4", "about the centroid"),
    }
    if abs(xy) > 1e-9 * (xx + yy):
        constants["second_moment_xy"] = Constant(xy, "second moment, integral of x y", "m^4", "about the centroid")
    for name, words, place in (
        ("centroid", "centroid", found.centroid),
        ("shear_centre", "shear centre", found.shear_centre),
    ):
        if math.hypot(*place) > 1e-9 * size:
            for axis, value in zip("xy", place, strict=True):
                note = "in the section's own coordinates"
                constants[f"{name}_{axis}"] = Constant(value, f"{words}, {axis}", "m", note)
    return constants


def _accuracy(found: SectionProperties) -> str:
    if found.error == 0.0:
        return found.method
    return f"{found.method}, relative error below {found.error:.1g}"


def _modulus(section: Section, found: SectionProperties) -> Constant:
    name = "torsion modulus W = torque/largest stress"
    if found.torsion_modulus > 0.0:
        x, y = found.stress_points[0]
        count = len(found.stress_points)
        places = f" and {count - 1} more like it" if count > 1 else ""
        note = f"largest stress at x = {_mm(x)}, y = {_mm(y)} mm{places}"
        if section.shape in ("circle", "hollow_circle"):
            note = "largest stress on the whole rim"
        return Constant(found.torsion_modulus, name, "m^3", note)
    note = "the ideal stress is unbounded at sharp re-entrant corners"
    rounded = filleted(section)
    if rounded is not None:
        w = 1e9 * rounded.torsion_modulus
        note += f"; with a root fillet of {_mm(rounded.root_fillet)} mm W would be {w:.4g} mm^3"
    return Constant(math.nan, name, "m^3", note)


def _mm(length: float) -> str:
    return f"{1e3 * length + 0.0:.4g}" if abs(length) > 1e-9 else "0"
