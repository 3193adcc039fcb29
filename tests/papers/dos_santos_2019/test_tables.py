"""Tables 1 and 2: the printed heads against the printed numbers, by plain arithmetic on the digits."""

from __future__ import annotations

import math

import numpy as np
import pytest

from varistiff.papers.claims import load_claims
from varistiff.papers.dos_santos_2019 import beams, paper_values
from varistiff.papers.dos_santos_2019.elastica import printed_integral

# first and second side [mm] of Table 1 beside l1/w, l1/h, l2/w, l2/h of Table 2
ROWS = [
    (5.46, 31.70, "23.7", "137.4", "13.6", "78.8"),
    (5.46, 25.49, "29.4", "137.4", "16.9", "78.8"),
    (3.16, 25.45, "29.5", "237.3", "16.9", "136.1"),
    (4.69, 25.20, "29.8", "159.9", "17.1", "91.7"),
]
LENGTHS = (750.0, 430.0)


def agree(width: float, height: float, cells: tuple[str, ...], *, upside_down: bool = False) -> list[bool]:
    values = [length / side for length in LENGTHS for side in (width, height)]
    values = [1.0 / value for value in values] if upside_down else values
    return [abs(value - float(cell)) <= 0.05 for value, cell in zip(values, cells, strict=True)]


def test_printed_order_misses_every_ratio():
    for first, second, *cells in ROWS:
        assert agree(second, first, tuple(cells)) == [True] * 4
        assert agree(first, second, tuple(cells)) == [False] * 4
    assert beams.ratios_by_printed_head() < -100.0  # 237.3 against 29.5 is the worst


def test_caption_has_the_ratios_upside_down():
    for first, second, *cells in ROWS:
        assert agree(second, first, tuple(cells), upside_down=True) == [False] * 4
    assert beams.ratios_by_caption() < -200.0


def test_megapascal_leaves_no_equilibrium():
    moduli = (70.8, 63.1, 194.0, 169.2)
    largest = max(printed_integral(slope) for slope in np.linspace(0.02, 1.55, 300))
    for (thickness, width, *_), modulus in zip(ROWS, moduli, strict=True):
        rigidity = modulus * width * thickness**3 / 12.0  # N mm^2, E in MPa
        needed = [length * math.sqrt(2.0 * 2.0 / rigidity) for length in LENGTHS]
        assert min(needed) > 2.9 * largest
        assert max(needed) * math.sqrt(10.0 / 1000.0) < largest  # 20 N with E in GPa
    assert beams.modulus_in_megapascal() < 0.0


def test_inputs_are_the_constants():
    claims = {claim.id: claim for claim in load_claims("dos_santos_2019")}

    def printed(name: str) -> float:
        return float(claims[name].published) * claims[name].factor

    for beam, row in paper_values.BEAMS.items():
        assert printed(f"{beam}_first_side") == pytest.approx(row.first_side, rel=1e-15)
        assert printed(f"{beam}_second_side") == pytest.approx(row.second_side, rel=1e-15)
        assert printed(f"{beam}_mass") == row.mass
        assert printed(f"{beam}_modulus") == row.modulus * paper_values.PRINTED_MODULUS_UNIT
        assert printed(f"{beam}_error") == row.rms_error
        assert claims[f"{beam}_material"].published.split()[0].lower() in beams.material(beam).name.lower()
    assert [printed("active_length_1"), printed("active_length_2")] == list(paper_values.ACTIVE_LENGTHS.values())
    assert (printed("force_least"), printed("force_largest")) == paper_values.FORCES
    assert printed("trials") == paper_values.TRIALS
    assert printed("overall_error") == paper_values.RMS_ERROR
    assert printed("mia_actuators") == paper_values.ADJUSTER_ACTUATORS
    assert printed("beams_count") == len(paper_values.BEAMS)


def test_bending_thickness_is_the_first_side():
    element = beams.leaf("spring_steel")
    assert element.flexural_rigidity == pytest.approx(194e9 * 25.45e-3 * 3.16e-3**3 / 12.0)
    assert element.thickness == 3.16e-3


def test_lengths_by_mass():
    # 2700 and 7850 kg/m^3 are handbook densities of aluminium and steel
    wanted = {"aluminium_wide": 0.818, "aluminium_narrow": 1.076, "spring_steel": 0.894, "low_carbon_steel": 0.910}
    for beam, length in wanted.items():
        assert beams.beam_length(beam=beam) == pytest.approx(length, abs=5e-4)  # digits of the line above


def test_shear_at_the_quoted_limit_is_a_few_percent():
    # 3 E I/(k G A L^2) of a rectangle of length 5.4 thicknesses, E/G = 2.6
    bending, shear = 5.4**3 / (3.0 / 12.0), 5.4 / (5.0 / 6.0 / 2.6)
    assert beams.shear_share("low_carbon_steel", 5.4) == pytest.approx(shear / bending, rel=0.02)  # E/G of the table
    assert beams.shear_share("low_carbon_steel", 5.4) == pytest.approx(0.027, abs=0.001)
