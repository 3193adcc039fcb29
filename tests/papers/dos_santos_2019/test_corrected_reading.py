"""The design file says what the search finds."""

from __future__ import annotations

import math
from importlib import resources

import pytest

import varistiff
from varistiff.papers.dos_santos_2019.corrected_reading import Evidence, search


@pytest.fixture(scope="module")
def evidence() -> Evidence:
    return search()


def test_file_says_what_the_search_finds(evidence):
    with resources.as_file(resources.files("varistiff.papers.dos_santos_2019") / "corrected_reading.yaml") as path:
        design = varistiff.load(path)
    (found,) = [beam for beam in evidence.beams if beam.beam == "spring_steel"]
    leaf = design.actuator.beam
    assert (leaf.thickness, leaf.width) == (found.thickness, found.width)
    assert leaf.youngs_modulus == found.youngs_modulus
    assert leaf.length == pytest.approx(found.length, abs=5e-4)  # written in whole millimetres
    assert found.length_interval[0] < leaf.length < found.length_interval[1]
    deflection, setting = design.spec.actuator.deflection, design.spec.actuator.setting
    assert (setting.min, setting.max) == (0.43, 0.75)
    assert math.degrees(deflection.max) == pytest.approx(math.degrees(evidence.joint_angle), abs=0.05)  # one digit
    assert deflection.min == -deflection.max


def test_one_order_gives_every_cell_and_the_other_none(evidence):
    assert [(order.order, order.agree, order.cells) for order in evidence.orders] == [
        ("thickness x width", 16, 16),
        ("width x thickness", 0, 16),
    ]
    assert evidence.orders[0].worst < 1.0 < evidence.orders[1].worst


def test_only_gigapascal_has_equilibria_and_a_handbook(evidence):
    kept = [
        reading.unit for reading in evidence.moduli if reading.beams_in_equilibrium == 4 and reading.largest_factor < 2
    ]
    assert kept == ["GPa"]


def test_table_2_alone_fixes_the_sides(evidence):
    for beam in evidence.beams:
        for value, (low, high) in (
            (beam.thickness, beam.thickness_by_table_2),
            (beam.width, beam.width_by_table_2),
        ):
            assert low <= value <= high
            assert high - low < 0.005 * value  # the ratios have three digits or more
        assert beam.length > 0.75


def test_one_paired_split_gives_the_error_over_all_trials(evidence):
    assert evidence.splits == 26235
    assert len(evidence.fitting_splits) == 23
    assert evidence.paired_splits == ((16, 16, 12, 12),)
    assert all(sum(split) == 56 for split in evidence.fitting_splits)
    assert evidence.equal_error == pytest.approx(1.900, abs=5e-4)


def test_no_beam_yields_over_the_printed_forces(evidence):
    assert evidence.stress_max < 1.0
