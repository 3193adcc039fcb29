"""The design file says what the search finds, and meets the printed numbers."""

from __future__ import annotations

import math

import pytest

from varistiff.papers.schuy_2013 import paper_values as paper
from varistiff.papers.schuy_2013 import prototype, rails
from varistiff.papers.schuy_2013.corrected_reading import design, roundest, search
from varistiff.papers.schuy_2013.corrected_reading import prototype as reading
from varistiff.sections import SplinedTube


def test_file_says_what_the_search_finds() -> None:
    found, tube = search(), reading()
    section = tube.section
    assert isinstance(section, SplinedTube)
    assert tube.shear_modulus == pytest.approx(found.shear_modulus, rel=1e-12)  # the same digits
    assert section.inner_radius == pytest.approx(found.bore_radius, rel=1e-12)
    assert section.inner_radius == pytest.approx(rails.BORE_RADIUS, rel=1e-12)
    assert section.root_fillet == pytest.approx(rails.FILLET, rel=1e-12)
    assert tube.series_stiffness == pytest.approx(found.series_stiffness, rel=1e-12)
    assert section.rail_height == pytest.approx(found.rail_height, abs=0.5e-6)  # the file says micrometres
    assert section.outer_radius == pytest.approx(paper.OUTER_RADIUS)
    assert section.rails == paper.RAILS
    assert tube.length == pytest.approx(paper.TESTED_LENGTHS[-1])
    assert design().warnings == ()


def test_search_lies_in_its_intervals() -> None:
    found = search()
    low, high = found.modulus_interval
    assert low < found.shear_modulus < high
    assert found.modulus_of_table_solid is None
    assert found.modulus_of_table is not None
    assert found.modulus_of_table[0] > found.modulus_at_printed_length[1]
    assert found.section_factor_interval[0] < found.section_factor < found.section_factor_interval[1]
    assert found.series_stiffness_interval[0] < found.series_stiffness < found.series_stiffness_interval[1]


def test_two_statements_fix_factor_and_series_stiffness() -> None:
    """Two compliances, two equations: x/(s G J) + 1/k_s = x/(G J) at 40 mm and 1/71.56 at 166 mm."""
    found = search()
    rigidity = found.shear_modulus * 0.5 * math.pi * (0.011**4 - 0.0087**4)
    s, series = found.section_factor, found.series_stiffness
    assert 0.166 / (s * rigidity) + 1.0 / series == pytest.approx(1.0 / 71.56, rel=1e-9)  # solved for s last
    assert 0.04 / (s * rigidity) + 1.0 / series == pytest.approx(0.04 / rigidity, rel=1e-3)  # k_s in whole N m/rad


def test_reading_meets_every_printed_number() -> None:
    """Half a unit of the last printed digit, as on the board."""
    tube = reading()
    assert prototype.measured_stiffness() == pytest.approx(71.56, abs=0.005)
    assert prototype.crossing() == pytest.approx(0.04, abs=0.0005)
    bare = tube.shear_modulus * rails.bare_section().torsion_constant
    assert bare / 0.166 == pytest.approx(53.13, abs=0.005)
    assert rails.bare_section().inner_radius / 0.011 == pytest.approx(0.791, abs=0.0005)


@pytest.mark.parametrize("low, high, expected", [(0.2, 1.4, 1.0), (8.6955, 8.7065, 8.7), (0.6289, 0.6312, 0.63)])
def test_roundest(low: float, high: float, expected: float) -> None:
    assert roundest(low, high) == expected


def test_series_stiffness_is_felt_where_the_element_is_short() -> None:
    """A sign turned round in the series law would make the measured curve the higher one there."""
    assert prototype.measured_below_margin() > 0.0
    assert prototype.measured_above_margin() > 0.0
    short, long = (prototype.measured_stiffness(active_length=x) for x in (0.011, 0.166))
    assert short < reading().series_stiffness
    assert long < short
