"""Every kind draws, with units on its axes, and the drawn leaves are the actuator's own."""

from __future__ import annotations

import math
import re
from pathlib import Path

import numpy as np
import pytest
import xarray as xr
from matplotlib.figure import Figure

from varistiff.core.status import Status
from varistiff.design.design import Design
from varistiff.elastic.leaf import Leaf
from varistiff.elastic.sliding_leaf import SlidingLeaf
from varistiff.elastic.wrapped_leaf import WrappedLeaf
from varistiff.report.display import display, number
from varistiff.report.figures import draw_all
from varistiff.report.figures.status_map import label_spots
from varistiff.report.mechanism import draw_mechanism
from varistiff.report.mechanism.leaf_shape import between_horizontals
from varistiff.report.view import View

from .conftest import map_of

UNIT = re.compile(r"\[(deg|mm|mJ|J|kJ|m?N|kN|[mk]?N·m|k?N·m/rad|k?N/mm|MPa)\]$")


def _labels(figure: Figure) -> list[str]:
    found = [text for axes in figure.axes for text in (axes.get_xlabel(), axes.get_ylabel())]
    return [text for text in found if text]


def test_axes_carry_units(dataset: xr.Dataset) -> None:
    names = []
    for drawing in draw_all(dataset):
        names.append(drawing.name)
        labels = _labels(drawing.figure)
        assert len(labels) >= 1
        for label in labels:
            assert UNIT.search(label), label
        assert drawing.caption.endswith(".")
    assert "load_deflection" in names
    assert ("adjusting" in names) == ("setting" in dataset.dims)
    assert ("stress" in names) == bool(np.isfinite(dataset.stress.values).any())
    assert len(names) == len(set(names))


def test_curves_are_the_numbers_of_the_map(folder: Path) -> None:
    """A line of the torque figure carries the map's torques in the unit of its label."""
    dataset = map_of("series_elastic", folder)
    drawing = next(drawing for drawing in draw_all(dataset) if drawing.name == "load_deflection")
    line = max(drawing.figure.axes[0].lines, key=lambda part: len(part.get_xdata()))
    x, y = np.asarray(line.get_xdata(), float), np.asarray(line.get_ydata(), float)
    np.testing.assert_allclose(y, 160.0 * np.radians(x), rtol=1e-12)


def test_mechanism_draws(design: Design, dataset: xr.Dataset) -> None:
    drawing = draw_mechanism(design.actuator, dataset)
    assert drawing is not None
    svg = drawing.svg()
    assert svg.startswith("<svg")
    assert svg.count("<path") > 10
    # one scale both ways, or an angle drawn is not the angle meant
    for axes in drawing.figure.axes:
        left, right = axes.get_xlim()
        bottom, top = axes.get_ylim()
        box = axes.get_position()
        width, height = drawing.figure.get_size_inches()
        across, along = (right - left) / (box.width * width), (top - bottom) / (box.height * height)
        assert across == pytest.approx(along, rel=1e-6)


@pytest.mark.parametrize("span", [0.2, 0.1, 0.0665])
@pytest.mark.parametrize("radius", [math.inf, 0.035])
def test_drawn_leaf_is_the_law_s(span: float, radius: float) -> None:
    leaf, rise = Leaf(youngs_modulus=210e9, width=0.05, thickness=0.0005), 0.0405
    law = SlidingLeaf() if math.isinf(radius) else WrappedLeaf(protection_radius=radius)
    drawn = between_horizontals(span, rise, radius=radius, points=201)
    np.testing.assert_allclose(drawn[[0, -1]], [[0.0, 0.0], [span, rise]], atol=1e-12)
    # distance of the law's points from the drawn polyline; 40 micrometres are far under the width of a line
    for point in law.centreline(leaf, span, rise):
        piece = np.diff(drawn, axis=0)
        part = np.clip(((point - drawn[:-1]) * piece).sum(axis=1) / (piece**2).sum(axis=1), 0.0, 1.0)
        assert np.hypot(*(drawn[:-1] + part[:, None] * piece - point).T).min() < 4e-5


def test_svg_is_self_contained_and_repeatable(folder: Path) -> None:
    dataset = map_of("torsion_tube", folder)
    first, second = ([drawing.svg() for drawing in draw_all(dataset)] for _ in range(2))
    assert first == second
    for svg in first:
        references = re.findall(r'(?:href|src)="([^"]*)"', svg) + re.findall(r"url\(([^)]*)\)", svg)
        assert all(reference.startswith(("#", "data:")) for reference in references)
        assert "<text" not in svg  # letters are outlines: no font is needed


def test_a_label_stays_inside_its_region() -> None:
    mask = np.zeros((80, 120), bool)
    mask[:, 50:53] = True  # too thin for any label
    assert label_spots(mask, width=0.1, height=0.1) == []
    mask[:, 90:] = True
    (spot,) = label_spots(mask, width=0.1, height=0.1)
    assert 0.75 + 0.05 <= spot[0] <= 0.95
    both = ~mask
    assert len(label_spots(both, width=0.1, height=0.1)) == 2  # left and right of the thin region


def test_settings_without_ok_points_are_not_shown(folder: Path) -> None:
    view = View.of(map_of("torsion_tube", folder))
    assert view.setting is not None
    rows = view.some_settings(5)
    assert (view.status[-1] == Status.ELEMENT_TOO_SHORT).all()
    assert all(view.ok[row].any() for row in rows)
    assert rows == sorted(set(rows))


@pytest.mark.parametrize(
    ("value", "text"),
    [(0.0, "0"), (-1234.5, "−1234"), (0.0012345, "0.001234"), (2.5e9, "2.5e9"), (math.inf, "infinite"), (20.0, "20")],
)
def test_numbers_for_people(value: float, text: str) -> None:
    assert number(value) == text


def test_units_for_people() -> None:
    assert display("rad").text(math.pi / 6.0) == "30 deg"
    assert display("Pa").text(5e8) == "500 MPa"
    assert display("N/m").text(1802.0) == "1.802 N/mm"
    assert display("J", 0.05).text(0.05) == "50 mJ"
    assert display("N*m/rad", 3.0).text(None) == "—"
