"""The corrected reading of Chacon et al. (2011): what the search finds, and that the file says it."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest

import varistiff
from varistiff.papers import chacon_2011
from varistiff.papers.chacon_2011.corrected_reading import FILE, Search, search, variation_of_file
from varistiff.papers.chacon_2011.devices import nut_distance

from .quadrature import guided_end_curvature, second_derivative


@pytest.fixture(scope="module")
def found() -> Search:
    return search()


@pytest.fixture(scope="module")
def design() -> varistiff.Design:
    return varistiff.load(Path(chacon_2011.__file__).with_name(FILE))


def test_no_end_condition_reaches_the_variation_with_every_number_as_printed(found: Search) -> None:
    for theory in ("guided", "sliding", "wrapped"):
        assert 9.0 < found.as_printed[theory] < 10.0
    assert found.as_printed["linear"] == pytest.approx(1.75**5 - 1.0, rel=1e-12)  # the only one "above 1500 %"
    assert found.as_printed["linear"] > 15.0


def test_every_reading_gives_the_variation(found: Search) -> None:
    assert len(found.readings) == 10
    for reading in found.readings:
        assert abs(reading.residual) < 1e-5
    printed = {(reading.theory, reading.changed) for reading in found.readings}
    assert len(printed) == 10


def test_guided_reading_by_quadrature(found: Search) -> None:
    (reading,) = (r for r in found.readings if (r.theory, r.changed) == ("guided", "stiff_aspect_ratio"))
    for value, times in ((reading.value, 16.0), (reading.value_fifteenfold, 15.0)):
        assert second_derivative(value) / second_derivative(3.5) == pytest.approx(times, rel=1e-6)
    stress = 0.5 * 2.1e11 * 0.0005 * guided_end_curvature(reading.value) / 0.0405
    assert reading.stress == pytest.approx(stress, rel=1e-9)
    assert not reading.elastic


def test_only_leaves_on_cylinders_stay_elastic(found: Search) -> None:
    for reading in found.readings:
        assert reading.elastic == (reading.theory == "wrapped")
    chosen = found.chosen
    others = [abs(r.change) for r in found.readings if r.elastic and r.change is not None and r != chosen]
    assert chosen.change is not None
    assert abs(chosen.change) < 0.06 < min(others)
    assert chosen.value < chosen.value_fifteenfold < 2.0


def test_file_says_what_the_search_finds(found: Search, design: varistiff.Design) -> None:
    low, high = design.setting_range or (np.nan, np.nan)
    assert low == pytest.approx(float(nut_distance(3.5)), abs=1e-9)
    # rounded up to a tenth of a millimetre
    assert 0.0 <= high - float(nut_distance(found.chosen.value)) < 1e-4
    assert getattr(design.elements, "end_condition", None) == "sliding"
    assert getattr(design.elements, "protection_radius", None) == pytest.approx(0.035)
    assert 15.0 <= variation_of_file() < 15.06


def test_page_says_what_the_search_finds(root: Path, found: Search) -> None:
    laws = {"guided": "guided", "sliding": "sliding", "wrapped": "on cylinders"}
    text = (root / "docs" / "papers" / "chacon_2011.md").read_text(encoding="utf-8").replace("**", "")
    rows = [
        [cell.strip() for cell in line.strip("|").split("|")] for line in text.splitlines() if line.endswith("MPa |")
    ]
    assert len(rows) == len(found.readings)
    for row, reading in zip(rows, found.readings, strict=True):
        length = reading.changed in ("protecting_radius", "displacement")
        needed = f"{1e3 * reading.value:.1f} mm" if length else f"{reading.value:.3f}"
        assert (row[0], row[3], row[4]) == (laws[reading.theory], needed, f"{reading.stress / 1e6:.0f} MPa")


def test_corrected_reading_is_elastic_over_its_whole_map(design: varistiff.Design) -> None:
    deflection, setting = design.deflection_range, design.setting_range
    assert setting is not None
    points = design.evaluate(np.linspace(*deflection, 21)[:, None], np.linspace(*setting, 40))
    assert set(points.counts()) == {varistiff.Status.OK}
