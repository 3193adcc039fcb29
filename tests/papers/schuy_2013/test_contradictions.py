"""Where the paper disagrees with itself, one proof each."""

from __future__ import annotations

import math

import pytest

from varistiff.papers.schuy_2013 import ideal_cylinder, prototype, table_one
from varistiff.papers.schuy_2013 import paper_values as paper
from varistiff.papers.schuy_2013.corrected_reading import modulus_of_prototype
from varistiff.papers.schuy_2013.table_one import overlap

REQUIRED = 350.0 * 0.010  # N m^2, G J of every section in Table I


def hollow_circle(outer: float, ratio: float) -> float:
    return 0.5 * math.pi * outer**4 * (1.0 - ratio**4)


def test_ten_millimetres_cannot_be_the_largest_length() -> None:
    """At 10 mm, its stiffness is still above the largest that is required."""
    rigidity = 0.387e9 * hollow_circle(0.009, 0.5)
    assert rigidity / 0.01 > paper.STIFFNESS_MAX
    assert ideal_cylinder.length_of_softest() == pytest.approx(rigidity / 50.0, rel=1e-12)  # closed form
    assert rigidity / 50.0 < 0.1  # which would be long enough


def test_printed_modulus_meets_no_dimension() -> None:
    """0.68 GPa is outside every interval that rounds to a printed dimension, by the printed factors."""
    found = [
        REQUIRED / (factor * (size + 0.05e-3) ** 4)
        for factor, size in ((0.141, 0.0141), (0.115, 0.0148), (0.108, 0.0151), (hollow_circle(1.0, 0.5), 0.0078))
    ]
    highest = [
        REQUIRED / (factor * (size - 0.05e-3) ** 4)
        for factor, size in ((0.141, 0.0141), (0.115, 0.0148), (0.108, 0.0151), (hollow_circle(1.0, 0.5), 0.0078))
    ]
    assert max(highest) < paper.POLYAMIDE
    common = table_one.common_modulus()
    assert common is not None
    assert common == pytest.approx((max(found), min(highest)), rel=1e-12)  # closed form
    assert common[0] > 0.6255e9  # 0.626 to 0.632 GPa
    assert common[1] < 0.6325e9


def test_one_modulus_needs_a_hollow_cylinder() -> None:
    assert table_one.common_modulus(ratio=0.0) is None
    assert table_one.common_modulus(ratio=0.0, exact=True) is None
    solid = table_one.cylinder_interval(ratio=0.0)
    assert solid[1] < min(table_one.polygon_interval(section=name, exact=False)[0] for name in ("square", "hexagon"))


@pytest.mark.parametrize("section", ["square", "hexagon", "octagon"])
def test_stress_row_needs_a_solid_cylinder(section: str) -> None:
    """Hollow, as the dimensions need it, the cylinder's own stress is higher by 1/(1 - 0.5^4)."""
    printed = paper.STRESS_RATIOS[section]
    assert table_one.stress_ratio(section=section) == pytest.approx(printed, abs=0.005)  # half a printed digit
    hollow = table_one.stress_ratio_hollow(section=section)
    assert hollow == pytest.approx(table_one.stress_ratio(section=section) * (1.0 - 0.5**4), rel=1e-12)
    assert abs(hollow - printed) > 0.05


@pytest.mark.parametrize("ratio", [0.0, 0.5])
def test_equally_stiff_sections_differ_less(ratio: float) -> None:
    """The largest stress at equal J is torque J/W: (W_c/W) with the closed forms of circle and square."""
    constant = REQUIRED / paper.POLYAMIDE
    outer = (constant / hollow_circle(1.0, ratio)) ** 0.25
    side = (constant / 0.1405770) ** 0.25  # Saint-Venant's square: J = 0.1405770 b^4, W = 0.2081653 b^3
    expected = constant / outer / (0.2081653 * side**3)
    found = table_one.stress_ratio_at_equal_stiffness(section="square", ratio=ratio)
    assert found == pytest.approx(expected, rel=1e-6)  # digits of the square's factors
    assert found < paper.STRESS_RATIOS["square"] - 0.01


def test_element_is_too_short_for_its_tests() -> None:
    assert not prototype.fits_element(element_length=paper.ELEMENT_LENGTH)
    assert not prototype.fits_element(element_length=0.165)  # the longest that still rounds to 0.16 m
    assert prototype.fits_element(element_length=0.166)


def test_required_range_is_not_matched() -> None:
    """The printed minimum itself is above 50 N m/rad; every shear modulus of the paper or of Table I gives more too."""
    assert paper.ANALYTIC_MIN > paper.STIFFNESS_MIN
    common = table_one.common_modulus()
    assert common is not None
    for modulus in (*common, paper.POLYAMIDE):
        for length in (paper.ELEMENT_LENGTH, paper.TESTED_LENGTHS[-1]):
            assert modulus * hollow_circle(0.011, 0.791) / length > paper.STIFFNESS_MIN


def test_prototype_has_the_modulus_of_table_one() -> None:
    """53.13 N m/rad at 0.166 m and Table I have a shear modulus in common; at l = 0.16 m they have none."""
    table = table_one.common_modulus()
    assert table is not None
    tested, printed_length = (modulus_of_prototype(active_length=x) for x in (0.166, 0.16))
    assert overlap([table, tested]) is not None
    assert overlap([table, printed_length]) is None
    assert tested[1] < paper.POLYAMIDE
    closed = 53.125 * 0.166 / hollow_circle(0.011, 0.7905)
    assert tested[0] == pytest.approx(closed, rel=1e-12)  # closed form
    expected = [modulus * hollow_circle(0.011, 0.791) / 0.166 for modulus in table]
    assert prototype.analytic_stiffness_of_table() == pytest.approx(expected, rel=1e-12)  # closed form
    assert expected[0] < paper.ANALYTIC_MIN < expected[1]
