"""Hadamard's derivative of J against differences, JAX and Euler's theorem on homogeneous functions."""

from __future__ import annotations

from dataclasses import fields

import jax
import pytest

from varistiff.core import precision
from varistiff.sections import (
    P3G,
    P4C,
    Circle,
    Ellipse,
    Hexagon,
    HollowCircle,
    Rectangle,
    SplinedTube,
    Square,
    Triangle,
)
from varistiff.sections.section import Section
from varistiff.sections.sensitivity import torsion_sensitivity

from .shapes import SPLINED

precision.enable()

CLOSED = [
    Circle(radius=0.009),
    HollowCircle(outer_radius=0.011, inner_radius=0.0087),
    Ellipse(semi_major=0.010, semi_minor=0.006),
    Rectangle(width=0.02, height=0.008),
    Rectangle(width=0.008, height=0.02),
    Square(across_flats=0.01),
    Triangle(side=0.01),
    Hexagon(across_flats=0.012),
]
SOLVED = [
    P3G(mean_diameter=0.02, eccentricity=0.0008),
    P4C(inner_diameter=0.021, outer_diameter=0.025, eccentricity=0.0035),
    SplinedTube(**SPLINED),
    SplinedTube(**SPLINED, root_fillet=0.0008),
]


def constant(section: Section, name: str, value: object) -> float:
    lengths = {field.name: getattr(section, field.name) for field in fields(section)} | {name: value}
    return type(section)(**lengths).torsion_constant


@pytest.mark.parametrize("section", CLOSED, ids=lambda section: section.shape)
def test_closed_forms(section: Section) -> None:
    """JAX differentiates the closed form; the outline's differences cost about 1e-10."""
    found = torsion_sensitivity(section)
    assert set(found) == {field.name for field in fields(section)}
    for name, value in found.items():
        exact = jax.grad(lambda length, name=name: constant(section, name, length))(getattr(section, name))
        assert value == pytest.approx(float(exact), rel=1e-8)


@pytest.mark.parametrize("section", SOLVED, ids=["p3g", "p4c", "sharp", "filleted"])
def test_solved_shapes(section: Section) -> None:
    """Central differences of the solved J, steps of 1e-3: their error is 5e-6 at the most."""
    found = torsion_sensitivity(section)
    steepest = max(abs(value) * getattr(section, name) for name, value in found.items())
    for name, value in found.items():
        length = getattr(section, name)
        low, high = (constant(section, name, length * (1.0 + way * 1e-3)) for way in (-1.0, 1.0))
        assert value * length == pytest.approx((high - low) / 2e-3, abs=1e-5 * steepest)


@pytest.mark.parametrize("section", [*CLOSED, *SOLVED], ids=lambda section: section.shape)
def test_euler(section: Section) -> None:
    """J is homogeneous of degree four in the lengths: sum of p dJ/dp = 4 J.

    1e-8, and 1e-6 at a sharp root, where the square of an unbounded stress is integrated.
    """
    total = sum(getattr(section, name) * value for name, value in torsion_sensitivity(section).items())
    sharp = section.properties().torsion_modulus == 0.0
    assert total == pytest.approx(4.0 * section.torsion_constant, rel=1e-6 if sharp else 1e-8)


def test_whole_numbers_have_no_derivative() -> None:
    assert set(torsion_sensitivity(SplinedTube(**SPLINED))) == {
        "outer_radius",
        "inner_radius",
        "rail_width",
        "rail_height",
    }
