"""The paper's equations that are wrong as printed."""

from __future__ import annotations

import numpy as np
import pytest

from varistiff.core.quantity_units import parse_unit
from varistiff.papers.schuy_2013 import paper_values as paper
from varistiff.papers.schuy_2013 import prototype, table_one
from varistiff.papers.schuy_2013.device import stiffness, tube_of


@pytest.mark.parametrize("section", sorted(table_one.KINDS))
def test_printed_equation_6_gives_twice_the_stiffness(section: str) -> None:
    """Put into Eq. (5), with the same printed c_g, the b of Eq. (6) gives 700 N m/rad in place of 350."""
    modulus, factor = 0.63e9, paper.STIFFNESS_FACTORS[section]
    b = table_one.across_flats_as_printed(section=section, shear_modulus=modulus)
    assert modulus * factor * b**4 / paper.LENGTH_MIN == pytest.approx(2.0 * paper.STIFFNESS_MAX, rel=1e-12)  # exact
    ours = table_one.across_flats(section=section, shear_modulus=modulus)
    assert b / ours == pytest.approx(2.0**0.25, rel=2e-3)  # 18.9 %; the printed factors are up to 0.5 % off
    assert ours == pytest.approx(paper.ACROSS_FLATS[section], abs=0.05e-3)  # Table I follows the corrected form
    device = tube_of(shear_modulus=modulus, section=table_one.KINDS[section](across_flats=ours))
    assert stiffness(device, active_length=paper.LENGTH_MIN) == pytest.approx(paper.STIFFNESS_MAX, rel=1e-9)


def test_fitted_line_is_a_torque() -> None:
    """Fitted to torque over twist, k_lin is the stiffness and k_off a torque; the printed left side is neither."""
    twist = np.linspace(-0.2, 0.2, 9)
    k = prototype.measured_stiffness(active_length=0.051)
    offset, slope = prototype.fitted_line(twist=twist, torque=0.05 + k * twist)
    assert slope == pytest.approx(k, rel=1e-9)  # a line is fitted exactly
    assert offset == pytest.approx(0.05, rel=1e-9)
    # printed: stiffness = k_off + k_lin angle; with k_lin a stiffness the last term is a torque
    torque = parse_unit("N*m/rad*rad").signature
    assert torque == parse_unit("N*m").signature
    assert torque != parse_unit("N*m/rad").signature
