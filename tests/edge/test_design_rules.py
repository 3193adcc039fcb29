"""Every wrong design gets one line: field, what is wrong, what is allowed."""

from __future__ import annotations

import re
from collections.abc import Callable
from pathlib import Path

import pytest
from hypothesis import HealthCheck, given, settings
from hypothesis import strategies as st

from varistiff.core.errors import InputError
from varistiff.core.textfile import parse_yaml
from varistiff.design.design import load
from varistiff.design.read import validated
from varistiff.design.resolve import resolved, unlimited
from varistiff.design.spec import RollerBeamSpec, TorsionTubeSpec
from varistiff.materials import find_material

ROLLER, TUBE, LEAVES, SLIDER = "roller_beam", "torsion_tube", "antagonistic_leaves", "slider_leaf_joint"
HOLLOW = """
    shape: hollow_circle            # any of the shapes in the documentation
    outer_radius: 11 mm
    inner_radius: 8.7 mm"""
SPLINED = (
    " {{shape: splined_tube, outer_radius: 11 mm, inner_radius: 8.7 mm, rails: {rails}, rail_width: {width},"
    " rail_height: 2.5 mm, root_fillet: {fillet}}}"
)
LENGTHS = "{min: 15 mm, max: 25 mm}"

WRONG = [
    # a bare number, a wrong unit kind
    (ROLLER, "length: 0.90 m", "length: 0.90", "actuator.beam.length: 0.9 has no unit"),
    (ROLLER, "length: 0.90 m", "length: 1e3", "actuator.beam.length: 1000.0 has no unit"),
    (ROLLER, "194 GPa", "194 N", 'actuator.beam.youngs_modulus: "194 N" is a force; allowed is a stress'),
    (ROLLER, "mounting_angle: 0 deg", "mounting_angle: 0 mm", "is a length; allowed is an angle"),
    (ROLLER, "{min: -10 deg, max: 10 deg}", "{min: -10 mm, max: 10 mm}", "allowed is an angle"),
    (TUBE, "650 N*m/rad", "650 N*m", "is a torque; allowed is a rotational stiffness"),
    (TUBE, "650 N*m/rad", "650 J", "is an energy; allowed is a rotational stiffness"),
    (LEAVES, "{min: -15 mm, max: 15 mm}", "{min: -15 deg, max: 15 deg}", "is an angle; allowed is a length"),
    ("series_elastic", "160 N*m/rad", "160 N/m", "is a linear stiffness; allowed is a rotational"),
    ("maccepa", "394 N/m", "394 N*m/rad", "is a rotational stiffness; allowed is a linear"),
    # a misspelt field, kind, option or material
    (ROLLER, "thickness:", "thicknes:", 'unknown field "thicknes" (did you mean "thickness"?)'),
    (ROLLER, "name:", "nam:", 'unknown field "nam" (did you mean "name"?)'),
    (ROLLER, "kind: roller_beam", "kind: rollerbeam", 'kind "rollerbeam" (did you mean "roller_beam"?)'),
    (ROLLER, "kind: roller_beam", "knd: roller_beam", 'actuator.kind: is missing (is "knd" meant?)'),
    (ROLLER, "kind: roller_beam", "kind: [1]", "unknown kind a list"),
    (ROLLER, "swivelling_pair", "swiveling_pair", 'did you mean "swivelling_pair"'),
    (ROLLER, "spring_steel_1075", "spring_steel_1057", 'actuator.beam.material: unknown material "spring_steel_1057"'),
    (LEAVES, "end_condition: sliding", "end_condition: slidin", 'did you mean "sliding"'),
    (SLIDER, "small_deflection", "small", 'actuator.beam_theory: unknown choice "small" (did you mean "small_def'),
    ("maccepa", "lever_length", "lever", 'did you mean "lever_length"'),
    # values out of range
    (ROLLER, "3.16 mm", "-3.16 mm", 'actuator.beam.thickness: "-3.16 mm" is not allowed; allowed is a length above'),
    (ROLLER, "3.16 mm", "0 mm", "allowed is a length above zero"),
    (ROLLER, "min: 0.20 m", "min: 0.90 m", "actuator.setting.min: min is not below max"),
    (ROLLER, "min: 0.20 m", "min: 600 mm", "actuator.setting.min: min is not below max"),
    (ROLLER, "min: 0.20 m", "min: -0.2 m", "allowed is a length above zero"),
    (ROLLER, "min: -10 deg", "min: 11 deg", "actuator.deflection.min: min is not below max"),
    (ROLLER, "min: 0.20 m", "min: .nan", "nan is not a finite number"),
    (ROLLER, "min: 0.20 m", "min: nan m", "is not a finite number"),
    (ROLLER, "max: 0.60 m", "max: inf m", "is not a finite number"),
    (ROLLER, "max: 0.60 m", "max: .inf", "is not a finite number"),
    (ROLLER, "max: 0.60 m", "max: 1e390 m", "is not finite"),
    (TUBE, "min: 11 mm", "min: 0 mm", "allowed is a length above zero"),
    (SLIDER, "count: 1 ", "count: 0 ", "allowed is a whole number"),
    (SLIDER, "count: 1 ", "count: 1.5 ", "allowed is a whole number"),
    (SLIDER, "count: 1 ", "count: true ", "allowed is a whole number"),
    (SLIDER, "outer_angle: 47 deg", "outer_angle: 190 deg", "below 180 deg"),
    # the wrong shape of data
    (ROLLER, "name: Spring-steel roller beam", "name: 12", "name: is 12; allowed is text"),
    (ROLLER, "name: Spring-steel roller beam", "name: ''", "name: is empty"),
    (ROLLER, "name: Spring-steel roller beam", 'name: "a\\nb"', "is not one line of text"),
    (ROLLER, "setting: {min: 0.20 m, max: 0.60 m}", "setting: 3", "actuator.setting: is 3; allowed is a mapping"),
    (ROLLER, "setting: {min: 0.20 m, max: 0.60 m}", "setting: {}", "actuator.setting.min: is missing"),
    (ROLLER, "offset: 0 mm", "offset: [0 mm]", "actuator.roller.offset: is a list"),
    (ROLLER, "offset: 0 mm", "offset:", "actuator.roller.offset: is nothing"),
    # rules between fields
    (ROLLER, "swivelling_pair", "single_lower", "actuator.roller: a single roller has no clearance"),
    (ROLLER, "clearance: 0.2 mm", "clearance: -0.2 mm", "of zero or above"),
    (TUBE, "inner_radius: 8.7 mm", "inner_radius: 11 mm", "actuator.section.inner_radius: is not below outer"),
    (TUBE, "hollow_circle ", "square ", "across_flats"),
    (
        TUBE,
        HOLLOW,
        " {shape: p3g, mean_diameter: 20 mm, eccentricity: -1 mm}",
        "actuator.section.eccentricity: gives a",
    ),
    (TUBE, HOLLOW, " {shape: p3g, mean_diameter: 20 mm, eccentricity: 1.25 mm}", "below mean_diameter/16, 1.25 mm"),
    (
        TUBE,
        HOLLOW,
        " {shape: p4c, inner_diameter: 21 mm, outer_diameter: 31 mm, eccentricity: 3.5 mm}",
        "actuator.section.outer_diameter: does not cut the profile",
    ),
    (TUBE, HOLLOW, SPLINED.format(rails=6, width="12 mm", fillet="0 mm"), "rail_width: makes the rails overlap"),
    (TUBE, HOLLOW, SPLINED.format(rails=1, width="23 mm", fillet="0 mm"), "rail_width: makes the rails leave the tube"),
    (TUBE, HOLLOW, SPLINED.format(rails=6, width="4 mm", fillet="9 mm"), "actuator.section.root_fillet: has no room"),
    (TUBE, HOLLOW, SPLINED.format(rails=0, width="4 mm", fillet="0 mm"), "allowed is a whole number from 1 to 1000"),
    (TUBE, HOLLOW, " {shape: ellipse, semi_major: 3 mm, semi_minor: 5 mm}", "section.semi_minor: is above semi_major"),
    (TUBE, HOLLOW, " {shape: polygon}", "actuator.section: needs points or a file"),
    (TUBE, HOLLOW, " {shape: polygon, points: [[1 mm, 2 mm], [3 mm, 0 mm]]}", "a list of 3 to 2000 corners [x, y]"),
    (TUBE, HOLLOW, " {shape: polygon, points: [[1 mm, 2 mm], [3 mm], 5]}", "a corner [x, y], two lengths with units"),
    (TUBE, HOLLOW, " {shape: polygon, points: 7}", "actuator.section.points: is 7; allowed is a list"),
    (TUBE, HOLLOW, " {shape: polygon, file: a.csv, holes: []}", "actuator.section.holes: is given beside a file"),
    (
        TUBE,
        "  length: 170 mm ",
        "  end_model: {offset: -12 mm, valid: {min: 11 mm, max: 1 m}} ",
        "end_model.offset: makes",
    ),
    (
        TUBE,
        "  length: 170 mm ",
        "  end_model: {offset: 1 mm, lock_length: 2 mm, valid: {min: 11 mm, max: 1 m}} ",
        "actuator.end_model: one of lock_length and decay_length is missing",
    ),
    (TUBE, "hollow_circle ", "hollow_cirle ", 'did you mean "hollow_circle"'),
    (LEAVES, "end_condition: sliding", "end_condition: guided", "actuator.protection_radius: is given with"),
    (LEAVES, "    youngs_modulus: 210 GPa\n", "", "actuator.leaf: neither material nor youngs_modulus"),
    (SLIDER, "arc_radius: 36.8 mm", "arc_radius: 20 mm", "actuator.groove.arc_radius: is too small"),
    (SLIDER, "outer_radius: 54 mm", "outer_radius: 25 mm", "actuator.groove.outer_radius: is not above clamp"),
    (SLIDER, LENGTHS, "{min: 1 deg, max: 25 mm}", "is an angle; allowed is a length"),
    (SLIDER, LENGTHS, "{min: 1 kg, max: 2 kg}", "is a mass; allowed is a length"),
    ("series_elastic", "  deflection", "  setting: {min: 1 mm, max: 2 mm}\n  deflection", "has no setting"),
    ("maccepa", "135 mm", "36 mm", "anchor_distance: equals lever_length; allowed is a different length"),
    ("maccepa", "135 mm", "0.036 m", "actuator.anchor_distance: equals lever_length"),
]


@pytest.mark.parametrize("kind, old, new, said", WRONG)
def test_a_wrong_design_is_one_line(
    tmp_path: Path, example: Callable[[str], str], kind: str, old: str, new: str, said: str
) -> None:
    text = example(kind)
    assert old in text
    path = tmp_path / "design.yaml"
    path.write_text(text.replace(old, new, 1), encoding="utf-8")
    with pytest.raises(InputError) as caught:
        load(path)
    line = str(caught.value)
    assert line.startswith(f"{path}: ")
    assert said in line
    assert line.isprintable()
    assert "pydantic" not in line
    assert "Input should" not in line


def tube(
    tmp_path: Path, example: Callable[[str], str], properties: str, materials: Path | None = None
) -> TorsionTubeSpec:
    """The resolved tube with these fields in place of material, shear_modulus and yield_strength."""
    text = example(TUBE)
    start, end = text.index("material: pa2200"), text.index("section:")
    path = tmp_path / "design.yaml"
    path.write_text(f"{text[:start]}{properties}\n  {text[end:]}", encoding="utf-8")
    elements = load(path, materials=materials).elements
    assert isinstance(elements, TorsionTubeSpec)
    return elements


@pytest.mark.parametrize("laminate", ["glass_fibre_laminate", "carbon_fibre_laminate"])
def test_a_laminates_strength_along_its_fibres_does_not_limit_torsion(
    tmp_path: Path, example: Callable[[str], str], laminate: str
) -> None:
    with pytest.raises(InputError) as caught:
        tube(tmp_path, example, f"material: {laminate}\n  shear_modulus: 5 GPa")
    assert caught.value.field == "actuator.yield_strength"
    assert "sqrt(3) times the laminate's in-plane shear strength" in str(caught.value)
    given = tube(tmp_path, example, f"material: {laminate}\n  yield_strength: 130 MPa")
    shear_modulus = find_material(laminate).shear_modulus
    assert shear_modulus is not None
    assert (given.yield_strength, given.shear_modulus) == (130e6, shear_modulus.value)


def test_a_material_without_the_modulus_that_is_needed(tmp_path: Path, example: Callable[[str], str]) -> None:
    (tmp_path / "own.yaml").write_text("rubber: {youngs_modulus: 2 MPa, source: a test}\n", encoding="utf-8")
    with pytest.raises(InputError, match="material rubber has no known shear_modulus"):
        tube(tmp_path, example, "material: rubber", materials=tmp_path / "own.yaml")


def test_a_laminate_in_bending_keeps_its_strength(tmp_path: Path, example: Callable[[str], str]) -> None:
    text = example(ROLLER).replace("spring_steel_1075", "carbon_fibre_laminate")
    text = re.sub(r"    (youngs_modulus|yield_strength):.*\n", "", text)
    path = tmp_path / "design.yaml"
    path.write_text(text, encoding="utf-8")
    elements = load(path).elements
    assert isinstance(elements, RollerBeamSpec)
    assert (elements.beam.youngs_modulus, elements.beam.yield_strength) == (126e9, 1480e6)


def test_an_element_without_a_limit_is_named(tmp_path: Path, example: Callable[[str], str]) -> None:
    said = "no yield strength: nothing is reported as yielded"
    assert unlimited(tube(tmp_path, example, "shear_modulus: 1 GPa")) == (f"actuator: {said}",)
    assert unlimited(tube(tmp_path, example, "material: pa2200")) == ()
    (document,) = parse_yaml(example(LEAVES))
    document["actuator"]["leaf"] = {"youngs_modulus": "1 GPa", "width": "5 cm", "thickness": "0.5 mm"}
    assert unlimited(resolved(validated(document).actuator)) == (f"actuator.leaf: {said}",)
    for kind in ("series_elastic", "maccepa"):  # a spring of any make has no stress
        (document,) = parse_yaml(example(kind))
        assert unlimited(resolved(validated(document).actuator)) == ()


def test_a_disc_angle_needs_a_groove(example: Callable[[str], str]) -> None:
    (document,) = parse_yaml(example(SLIDER).replace(LENGTHS, "{min: 1 deg, max: 9 deg}"))
    assert validated(document).actuator.driven_by == "disc"
    del document["actuator"]["groove"]
    with pytest.raises(InputError, match=r"actuator\.setting: is an angle without a groove"):
        validated(document)


@pytest.mark.parametrize(
    "roller, said",
    [
        ("arrangement: single_lower, offset: 0 mm, radius: 10 mm", None),
        ("arrangement: single_upper, offset: -3 mm, radius: 10 mm", None),
        ("arrangement: single_upper, offset: 0 mm", "actuator.roller.radius: is missing"),
        ("arrangement: single_upper, offset: 0 mm, radius: -1 mm", "of zero or above"),
        ("arrangement: fixed_pair, offset: 0 mm, radius: 10 mm, clearance: 0.2 mm", None),
        ("arrangement: fixed_pair, offset: 0 mm, radius: 10 mm, clearance: 0 mm", "above zero"),
        ("arrangement: fixed_pair, offset: 0 mm, radius: 10 mm", "actuator.roller.clearance: is missing"),
        ("arrangement: fixed_pair, offset: 0 mm, clearance: 1 mm", "actuator.roller.radius: is missing"),
        ("arrangement: swivelling_pair, offset: 0 mm, clearance: 0 mm", None),
        ("arrangement: swivelling_pair, offset: 0 mm, radius: 3 mm", "actuator.roller.clearance: is missing"),
        ("offset: 0 mm", "actuator.roller.arrangement: is missing"),
    ],
)
def test_every_arrangement_has_its_own_fields(example: Callable[[str], str], roller: str, said: str | None) -> None:
    (document,) = parse_yaml(example(ROLLER))
    (document["actuator"]["roller"],) = parse_yaml(f"{{{roller}}}")
    if said is None:
        validated(document)
        return
    with pytest.raises(InputError) as caught:
        validated(document)
    assert said in str(caught.value)


@pytest.mark.parametrize("document", [None, 3, "text", [1], {}, {"name": "x"}, {"actuator": None, "name": "x"}])
def test_what_is_no_design_at_all(document: object) -> None:
    with pytest.raises(InputError):
        validated(document)


def complaint(call: Callable[[], object]) -> str:
    """The line that a call fails with, empty if it does not; any other exception goes through."""
    try:
        call()
    except InputError as error:
        return str(error)
    return ""


LEAVES_OF_DATA = st.one_of(
    st.none(), st.booleans(), st.integers(), st.floats(), st.text(max_size=8), st.sampled_from(["1 mm", "2 deg", "{x}"])
)
DATA = st.recursive(
    LEAVES_OF_DATA,
    lambda inner: st.lists(inner, max_size=3) | st.dictionaries(st.text(max_size=8), inner, max_size=3),
    max_leaves=8,
)


@given(data=st.data(), kind=st.sampled_from([ROLLER, TUBE, LEAVES, SLIDER, "series_elastic", "maccepa"]), value=DATA)
@settings(suppress_health_check=[HealthCheck.function_scoped_fixture], deadline=None)
def test_any_value_in_any_field_is_accepted_or_one_line(
    example: Callable[[str], str], data: st.DataObject, kind: str, value: object
) -> None:
    (document,) = parse_yaml(example(kind))
    place = document
    for _ in range(data.draw(st.integers(0, 3))):
        inner = [key for key, item in place.items() if isinstance(item, dict)]
        if inner:
            place = place[data.draw(st.sampled_from(inner))]
    place[data.draw(st.sampled_from([*place, "new", "setting"]))] = value
    line = complaint(lambda: validated(document))
    assert line.isprintable()
    assert "pydantic" not in line
    assert "Input should" not in line


@given(text=st.text(alphabet=" \n:-{}[],'\"#&*!|>%@`abkinderolactum0123456789.", max_size=80))
@settings(deadline=None)
def test_any_text_is_a_design_or_one_line(text: str) -> None:
    assert complaint(lambda: [validated(document) for document in parse_yaml(text)]).isprintable()


def test_a_missing_yield_strength_is_a_warning(example: Callable[[str], str], tmp_path: Path) -> None:
    path = tmp_path / "design.yaml"
    text = example("slider_leaf_joint")
    path.write_text(text.replace("    yield_strength: 1400 MPa", "    # none"), encoding="utf-8")
    assert "no yield strength" in " ".join(load(path).warnings)
    path.write_text(text, encoding="utf-8")
    assert "no yield strength" not in " ".join(load(path).warnings)
