"""Derivatives of the torsion constant with respect to a shape's lengths."""

from __future__ import annotations

from dataclasses import fields

import numpy as np

from varistiff.sections.outline import Points
from varistiff.sections.panels import Nodes
from varistiff.sections.saint_venant import solve_torsion
from varistiff.sections.section import Section

WIDE_STEP = 1e-3  # for J, which is known to about 1e-9
STEP = 1e-5  # of the length: the outline's points move smoothly, so the error of the difference is about 1e-10


def torsion_sensitivity(section: Section) -> dict[str, float]:
    """Return dJ/dp [m^3] for every length p of a shape, from one solution of its torsion problem.

    Moving the boundary outward by v_n changes J by the integral of q^2 v_n ds with q the shear stress along the
    boundary over G theta' (Hadamard's formula for the torsional rigidity), holes included. The lengths move the
    boundary; its points are differentiated by central differences. At a sharp re-entrant corner q^2 is integrable but
    large, and J itself is differenced in place of it, to about 1e-6. A whole number, such as the number of rails, has
    no derivative and is left out; so is a polygon, whose every corner would be a parameter.

    For the torsion modulus there is no such formula, because the largest stress may jump along the boundary: take a
    central difference with a relative step of 1e-4, whose error is then about 1e-6 of W.

    >>> from varistiff.sections import HollowCircle
    >>> tube = HollowCircle(outer_radius=0.011, inner_radius=0.0087)
    >>> found = torsion_sensitivity(tube)["inner_radius"]
    >>> round(found / (-2.0 * 3.141592653589793 * 0.0087**3), 9)
    1.0
    """
    solution = solve_torsion(section.outline())
    nodes, outline = solution.nodes, solution.outline
    copies = outline.rotations * (2 if outline.mirror else 1)
    rate = copies * solution.edge_stress**2 * nodes.weight
    sharp = any(corner.is_reentrant for corner in solution.corners)
    found = {}
    for field in fields(section):
        value = getattr(section, field.name)
        if not isinstance(value, float) or value <= 0.0:
            continue
        if sharp:
            found[field.name] = _difference(section, field.name, value)
        else:
            low, high = (_moved(section, field.name, value * (1.0 + way * STEP), nodes) for way in (-1.0, 1.0))
            velocity = (high - low) / (2.0 * STEP * value)
            found[field.name] = float(((velocity * nodes.normal).sum(axis=1) * rate).sum())
    return found


def _with(section: Section, name: str, value: float) -> Section:
    lengths = {field.name: getattr(section, field.name) for field in fields(section)} | {name: value}
    return type(section)(**lengths)


def _difference(section: Section, name: str, value: float) -> float:
    low, high = (_with(section, name, value * (1.0 + way * WIDE_STEP)).torsion_constant for way in (-1.0, 1.0))
    return (high - low) / (2.0 * WIDE_STEP * value)


def _moved(section: Section, name: str, value: float, nodes: Nodes) -> Points:
    """Where the nodes lie after one length has changed."""
    segments = [segment for piece in _with(section, name, value).outline().pieces for segment in piece]
    moved = [segment.point(t) for segment, t in zip(segments, nodes.parameters, strict=True)]
    return np.concatenate(moved)
