"""The corrected reading says what the search finds."""

from __future__ import annotations

import math
from pathlib import Path

import pytest

import varistiff
from varistiff.papers.registry import paper_file
from varistiff.papers.wang_2024 import paper_values as paper
from varistiff.papers.wang_2024.corrected_reading import SOFTEST, TORQUE, search
from varistiff.papers.wang_2024.groove_disc import arc_radius


@pytest.fixture(scope="module")
def design(tmp_path_factory: pytest.TempPathFactory) -> varistiff.Design:
    path: Path = tmp_path_factory.mktemp("reading") / "corrected_reading.yaml"
    path.write_text(paper_file("wang_2024", "corrected_reading.yaml").read_text(encoding="utf-8"), encoding="utf-8")
    return varistiff.load(path)


def test_file_says_what_the_search_finds(design: varistiff.Design) -> None:
    found, joint = search(), design.actuator
    assert joint.leaf.thickness == pytest.approx(found.thickness, rel=1e-12)
    assert design.setting_range[0] == pytest.approx(found.shortest_length, abs=0.5e-5)  # written to 0.01 mm
    assert joint.groove.arc_radius == pytest.approx(arc_radius(), abs=0.5e-5)
    # everything else as printed
    assert (joint.leaf.youngs_modulus, joint.leaf.width, joint.count) == (206e9, 0.025, 1)
    assert design.setting_range[1] == pytest.approx(paper.LENGTH_MAX, rel=1e-12)
    assert design.deflection_range[1] == pytest.approx(paper.DEFLECTION_LIMIT, rel=1e-12)


def test_design_gives_the_printed_numbers(design: varistiff.Design) -> None:
    points = design.evaluate([math.radians(3.03), 0.0], [design.setting_range[0], design.setting_range[1]])
    assert round(float(points.load[0]), 1) == 14.6
    assert round(float(points.stiffness[1])) == 9


def test_demands_by_hand() -> None:
    found = search()
    # K = E b h^3 l_2^2/(4 l_1^3) at 25 mm; torque = K sin(phi) at 6 mm
    for demand, printed in zip(found.softness_demand, SOFTEST, strict=True):
        assert demand == pytest.approx(4.0 * printed * 0.025**3 / (206e9 * 0.050**2), rel=1e-9)
    for demand, printed in zip(found.torque_demand, TORQUE, strict=True):
        by_hand = 4.0 * printed * 0.006**3 / (206e9 * 0.031**2 * math.sin(math.radians(3.03)))
        assert demand == pytest.approx(by_hand, rel=1e-9)
    # at exactly 6 mm no leaf has both: the shortest length has to be a little less
    assert found.softness_demand[1] < found.torque_demand[0]


def test_only_the_thickness_is_a_plausible_repair() -> None:
    found = search()
    for name in ("clamp_radius", "longest_length"):
        assert not found.repair(name).possible
    # b = 1 mm is a wire, and 9 GPa is no steel: possible in arithmetic only
    assert found.repair("width").high < 1.2 * paper.THICKNESS
    assert found.repair("youngs_modulus").high < 10e9
    strip = found.repair("thickness")
    assert strip.low < 0.35e-3 < strip.high
    assert not strip.low < 0.30e-3 < strip.high
    assert not strip.low < 0.40e-3 < strip.high


def test_pairs_of_thickness_and_width_have_the_product() -> None:
    found = search()
    for thickness, low, high in found.pairs:
        assert (low * thickness**3, high * thickness**3) == pytest.approx(found.softness_demand, rel=1e-12)
    (at_printed_width,) = (pair for pair in found.pairs if pair[1] <= paper.WIDTH <= pair[2])
    assert at_printed_width[0] == pytest.approx(0.35e-3, rel=1e-12)


def test_stiffness_of_the_tests_lies_inside_only_in_the_corrected_reading() -> None:
    found = search()
    assert found.shortest_length < found.test_length < paper.LENGTH_MAX


def test_the_reading_is_no_joint_to_build() -> None:
    found = search()
    assert math.degrees(found.rotation) > 20.0
    assert found.stress > 5e9  # no steel bears it
