"""Input claims and the constants of the computations are the same digits."""

from __future__ import annotations

import pytest

from varistiff.papers.claims import load_claims
from varistiff.papers.schuy_2013 import paper_values as paper

CONSTANTS = {
    "stiffness_least": paper.STIFFNESS_MIN,
    "stiffness_most": paper.STIFFNESS_MAX,
    "cylinder_ratio": paper.HOLLOW_RATIO,
    "polyethylene_shear_modulus": paper.POLYETHYLENE,
    "cylinder_radius": paper.IDEAL_RADIUS,
    "polyamide_shear_modulus": paper.POLYAMIDE,
    "length_least": paper.LENGTH_MIN,
    "table_radius": paper.TABLE_RADIUS,
    "rails": paper.RAILS,
    "gear_ratio": paper.GEAR_RATIO,
    "prototype_radius": paper.OUTER_RADIUS,
    "prototype_ratio": paper.RADIUS_RATIO,
    "element_length": paper.ELEMENT_LENGTH,
    "tested_length_longest": paper.TESTED_LENGTHS[-1],
    "crossing_length": paper.CROSSING,
    "measured_least": paper.MEASURED_MIN,
    "analytic_least": paper.ANALYTIC_MIN,
    "local_share": paper.LOCAL_SHARE,
    "solid_excess": paper.SOLID_EXCESS,
    "pictured_torque": paper.PICTURED_TORQUE,
}
for _name in ("square", "hexagon", "octagon"):
    CONSTANTS[f"table_{_name}"] = paper.ACROSS_FLATS[_name]
    CONSTANTS[f"c_g_{_name}"] = paper.STIFFNESS_FACTORS[_name]
    CONSTANTS[f"c_r_{_name}"] = paper.RESISTANCE_FACTORS[_name]
    CONSTANTS[f"stress_ratio_{_name}"] = paper.STRESS_RATIOS[_name]


@pytest.mark.parametrize("name", CONSTANTS)
def test_constant_is_the_printed_number(name: str) -> None:
    claim = {one.id: one for one in load_claims("schuy_2013")}[name]
    assert isinstance(claim.published, str)
    assert float(claim.published) * claim.factor == pytest.approx(CONSTANTS[name], rel=1e-12)  # digits in binary


def test_tested_lengths_are_the_printed_steps() -> None:
    claims = {one.id: one for one in load_claims("schuy_2013")}
    first, last = (float(text) for text in claims["tested_lengths"].published or [])
    step = float(str(claims["tested_step"].published))
    count = round((last - first) / step) + 1
    assert paper.TESTED_LENGTHS[:-1] == pytest.approx([first + number * step for number in range(count)])


def test_shown_lengths_were_tested() -> None:
    claims = {one.id: one for one in load_claims("schuy_2013")}
    printed = tuple(float(text) for text in str(claims["shown_lengths"].published).split(","))
    assert printed == paper.SHOWN_LENGTHS
    assert set(paper.SHOWN_LENGTHS) <= set(paper.TESTED_LENGTHS)
