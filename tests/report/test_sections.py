"""Reports of torsion elements: the section drawn truly, its stress, and honesty where that has no bound."""

from __future__ import annotations

import json
import math
from functools import cache
from pathlib import Path

import numpy as np
import pytest
import shapely
import xarray as xr

from varistiff.actuators.torsion_tube import TorsionTube
from varistiff.characteristic.datasheet import datasheet
from varistiff.characteristic.map import characteristic_map
from varistiff.core.errors import InputError
from varistiff.design.design import load
from varistiff.report.analyse import analyse
from varistiff.report.figures import draw_all, section_stress
from varistiff.report.html import one_line
from varistiff.report.mechanism import draw_mechanism
from varistiff.report.mechanism.element_view import Edges, edges_of, seen_from_the_side, silhouette
from varistiff.report.section_field import section_field
from varistiff.report.section_path import contains, section_loops
from varistiff.sections import (
    P3G,
    P4C,
    Circle,
    Ellipse,
    Hexagon,
    HollowCircle,
    Octagon,
    Rectangle,
    Section,
    SplinedTube,
    Square,
    Triangle,
)
from varistiff.sections.filleted import filleted
from varistiff.sections.polygon import polygon_of_points

RAILS = {"outer_radius": 0.011, "inner_radius": 0.0087, "rails": 6, "rail_width": 0.004, "rail_height": 0.0025}
SHARP = SplinedTube(**RAILS, root_fillet=0.0)
ROUNDED = SplinedTube(**RAILS, root_fillet=0.0005)
ANGLE = polygon_of_points([(0.0, 0.0), (0.02, 0.0), (0.02, 0.006), (0.006, 0.006), (0.006, 0.02), (0.0, 0.02)])
SECTIONS: dict[str, Section] = {
    "circle": Circle(radius=0.009),
    "hollow_circle": HollowCircle(outer_radius=0.011, inner_radius=0.0087),
    "square": Square(across_flats=0.014),
    "rectangle": Rectangle(width=0.02, height=0.005),
    "hexagon": Hexagon(across_flats=0.014),
    "octagon": Octagon(across_flats=0.014),
    "ellipse": Ellipse(semi_major=0.010, semi_minor=0.006),
    "triangle": Triangle(side=0.02),
    "p3g": P3G(mean_diameter=0.02, eccentricity=0.0008),
    "p4c": P4C(inner_diameter=0.021, outer_diameter=0.025, eccentricity=0.0035),
    "rounded": ROUNDED,
    "sharp": SHARP,
    "angle": ANGLE,
}


@cache
def _tube(name: str) -> TorsionTube:
    return TorsionTube(shear_modulus=0.63e9, section=SECTIONS[name], length=0.17, yield_strength=48e6)


@cache
def _map(name: str) -> xr.Dataset:
    deflection, setting = np.linspace(-0.25, 0.25, 31), np.linspace(0.011, 0.166, 21)
    return characteristic_map(_tube(name), deflection=deflection, setting=setting)


@pytest.mark.parametrize("name", SECTIONS)
def test_every_section_has_its_pictures(name: str) -> None:
    tube, dataset = _tube(name), _map(name)
    mechanism = draw_mechanism(tube, dataset)
    stress = section_stress.draw(tube, dataset)
    assert mechanism is not None
    assert stress is not None
    assert stress.figure.axes[0].get_aspect() == 1.0  # to scale
    for drawing in (mechanism, stress):
        assert drawing.svg().startswith("<svg")
        assert drawing.caption.endswith(".")


@pytest.mark.parametrize("name", SECTIONS)
def test_points_of_a_grid_lie_inside_where_shapely_says(name: str) -> None:
    loops = SECTIONS[name].outline().polylines()
    low, high = loops[0].min(axis=0), loops[0].max(axis=0)
    x, y = (np.linspace(a - 0.0003, b + 0.0004, 83) for a, b in zip(low, high, strict=True))
    whole = shapely.Polygon(loops[0], loops[1:])
    expected = shapely.contains_xy(whole, *(part.ravel() for part in np.meshgrid(x, y))).reshape(y.size, x.size)
    assert np.array_equal(contains(loops, x, y), expected)


@pytest.mark.parametrize("name", [name for name in SECTIONS if name not in ("sharp", "angle")])
def test_the_painted_stress_reaches_the_largest_and_no_more(name: str) -> None:
    field = section_field(SECTIONS[name])
    largest = 1.0 / SECTIONS[name].torsion_modulus
    inside = field.values[np.isfinite(field.values)]
    # pixel centres stay off the boundary, where the largest sits; a fillet of 0.5 mm is 7 pixels
    assert (0.85 if name == "rounded" else 0.97) * largest < inside.max() <= 1.001 * largest
    pixel = (field.extent[1] - field.extent[0]) * (field.extent[3] - field.extent[2]) / field.values.size
    assert inside.size * pixel == pytest.approx(SECTIONS[name].area, rel=4e-3)


def test_datasheet_states_the_section() -> None:
    sheet = datasheet(_map("hollow_circle"))
    assert sheet["section_area"].value == pytest.approx(math.pi * (0.011**2 - 0.0087**2), rel=1e-12)
    assert sheet["torsion_constant"].note == "closed form"
    assert sheet["torsion_modulus"].value == pytest.approx(sheet["torsion_constant"].value / 0.011, rel=1e-12)
    assert sheet["torsion_modulus"].note == "largest stress on the whole rim"
    assert "shear_centre_x" not in {row.key for row in sheet.rows}
    solved = datasheet(_map("rounded"))
    assert "boundary integral, relative error below" in solved["torsion_constant"].note
    unsymmetric = datasheet(_map("angle"))
    assert unsymmetric["shear_centre_x"].value == pytest.approx(unsymmetric["shear_centre_y"].value, rel=1e-6)
    assert 0.003 < unsymmetric["shear_centre_x"].value < 0.005  # where the middles of the legs meet, nearly
    assert unsymmetric["second_moment_xy"].value < 0.0


@pytest.mark.parametrize("name", ["sharp", "angle"])
def test_a_stress_without_a_bound_is_said_to_be_one(name: str) -> None:
    dataset = _map(name)
    assert np.isinf(dataset.stress.values).any()
    sheet = datasheet(dataset)
    for key in ("stress_peak", "utilisation", "torsion_modulus"):
        assert sheet[key].value is None
        assert "unbounded" in sheet[key].note
    json.dumps(sheet.as_dict(), allow_nan=False)
    assert "no point can count as yielded" in one_line(sheet)
    drawings = {drawing.name: drawing for drawing in draw_all(dataset)}
    assert "stress" not in drawings
    assert "unbounded" in drawings["status"].caption
    drawing = section_stress.draw(_tube(name), dataset)
    assert drawing is not None
    assert "unbounded" in drawing.caption
    assert ("root fillet of 0.5 mm" in drawing.caption) == (name == "sharp")


def test_the_filleted_tube_is_given_instead() -> None:
    assert filleted(SHARP) == ROUNDED  # a fifth of the rail height, 0.5 mm
    assert filleted(ROUNDED) is None
    assert filleted(ANGLE) is None
    note = datasheet(_map("sharp"))["torsion_modulus"].note
    assert f"root fillet of 0.5 mm W would be {1e9 * ROUNDED.torsion_modulus:.4g} mm^3" in note
    crowded = SplinedTube(**(RAILS | {"rails": 8, "rail_width": 0.008}), root_fillet=0.0)
    rounded = filleted(crowded)  # the gaps have no room for a fifth
    assert rounded is not None
    assert rounded.root_fillet < 0.0005


def test_analyse_writes_a_report_of_a_sharp_section(tmp_path: Path) -> None:
    design = tmp_path / "sharp.yaml"
    section = "{shape: splined_tube, outer_radius: 11 mm, inner_radius: 8.7 mm, rails: 6, rail_width: 4 mm,"
    design.write_text(
        f"name: Sharp\nactuator: {{kind: torsion_tube, material: pa2200, section: {section} rail_height: 2.5 mm}},"
        " setting: {min: 11 mm, max: 166 mm}, deflection: {min: -15 deg, max: 15 deg}}\n",
        encoding="utf-8",
    )
    found = analyse(load(design), tmp_path / "out")
    assert "unbounded" in found.summary[0]
    page = (found.output / "report.html").read_text(encoding="utf-8")
    assert "Every point of the map is safe" not in page
    assert "unbounded" in page
    assert (found.output / "figures" / "section_stress.svg").exists()
    json.loads((found.output / "datasheet.json").read_text(encoding="utf-8"), parse_constant=pytest.fail)


def test_side_view_of_a_square() -> None:
    """At rest a square shows its flat; at 45 degrees one edge in the middle and the diagonal as silhouette."""
    (outline,) = section_loops(Square(across_flats=0.014))
    angles = np.array([0.0, math.pi / 4.0])
    low, high = silhouette(outline, angles)
    np.testing.assert_allclose(high, [7.0, 7.0 * math.sqrt(2.0)], rtol=1e-12)
    np.testing.assert_allclose(low, -high, rtol=1e-12)
    edges = edges_of(outline)
    assert edges.points.shape == (4, 2)
    shown = seen_from_the_side(outline, edges, angles)
    assert np.isfinite(shown[:, 1]).sum() == 3  # the fourth is behind
    np.testing.assert_allclose(Edges.facing(outline).points, [[7.0, 0.0]], atol=1e-12)


def test_rails_and_fillets_are_edges() -> None:
    for section, count in ((SHARP, 24), (ROUNDED, 24), (Circle(radius=0.01), 0), (SECTIONS["p3g"], 0)):
        assert edges_of(section_loops(section)[0]).points.shape[0] == count


def _star(points: int, root: float) -> Section:
    at = np.tile([0.01, 0.01 * root], points) * np.exp(1j * np.pi * np.arange(2 * points) / points)
    return polygon_of_points([(float(z.real), float(z.imag)) for z in at])


def test_many_re_entrant_corners_are_painted_more_coarsely() -> None:
    """A star of 40 points in less room than its finest solution asks: no stress in the tips, a little in the middle."""
    section = _star(40, 0.8)
    field = section_field(section)
    rows, columns = field.values.shape
    typical = float(np.nanmedian(field.values))
    assert np.nanmax(field.values[rows // 2, -3:]) < 0.3 * typical
    assert field.values[rows // 2, columns // 2] < 0.1 * typical


def test_a_section_that_cannot_be_painted_has_no_picture(monkeypatch: pytest.MonkeyPatch) -> None:
    def refuse(_: Section) -> None:
        raise InputError("has too many corners")

    monkeypatch.setattr(section_stress, "section_field", refuse)
    assert section_stress.draw(_tube("square"), _map("square")) is None
