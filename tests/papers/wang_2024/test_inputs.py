"""Input claims print the digits that the computations start from."""

from __future__ import annotations

import pytest

from varistiff.papers.claim import Claim, Role
from varistiff.papers.claims import load_claims
from varistiff.papers.printed import value_of
from varistiff.papers.wang_2024 import paper_values as paper

CONSTANTS = {
    "youngs_modulus": paper.YOUNGS_MODULUS,
    "width": paper.WIDTH,
    "thickness": paper.THICKNESS,
    "count": paper.COUNT,
    "clamp_radius": paper.CLAMP_RADIUS,
    "outer_radius": paper.OUTER_RADIUS,
    "outer_angle": paper.OUTER_ANGLE,
    "diameter": paper.JOINT_DIAMETER,
    "rotation_assumed": paper.ROTATION_ASSUMED,
    "rotation_design": paper.ROTATION_DESIGN,
    "length_min": paper.LENGTH_MIN,
    "length_max": paper.LENGTH_MAX,
    "test_stiffness": paper.TEST_STIFFNESS,
    "stiffness_amplitude": paper.STIFFNESS_AMPLITUDE,
    "position_amplitude": paper.POSITION_AMPLITUDE,
    "sine_frequency": paper.FREQUENCY,
}


def claim(name: str) -> Claim:
    return next(claim for claim in load_claims("wang_2024") if claim.id == name)


@pytest.mark.parametrize("name", CONSTANTS)
def test_constant_is_the_printed_input(name: str) -> None:
    printed = claim(name)
    assert printed.role is Role.INPUT
    assert value_of(str(printed.published)) * printed.factor == pytest.approx(
        CONSTANTS[name], rel=1e-15
    )  # binary digits


def test_the_printed_deflection_limit_is_the_one_used() -> None:
    printed = claim("deflection_range")
    assert value_of(str(printed.published)) * printed.factor == pytest.approx(paper.DEFLECTION_LIMIT, rel=1e-15)
