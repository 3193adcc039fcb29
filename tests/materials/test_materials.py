"""The built-in materials and a user's own."""

from __future__ import annotations

import re
from pathlib import Path

import pytest

from varistiff.core.errors import InputError
from varistiff.materials import Material, builtin_materials, find_material, read_materials
from varistiff.materials.table import PROPERTIES

EXPECTED = {
    "spring_steel_1075",
    "spring_steel_1095",
    "spring_steel_5160",
    "spring_steel_51crv4",
    "music_wire",
    "stainless_304",
    "aluminium_6061",
    "aluminium_7075",
    "titanium_ti6al4v",
    "low_carbon_steel",
    "pa2200",
    "pe",
    "pom",
    "peek",
    "tpu",
    "glass_fibre_laminate",
    "carbon_fibre_laminate",
}
METALS = ("steel", "stainless", "aluminium", "titanium", "wire")


def test_the_table_has_what_was_promised() -> None:
    assert set(builtin_materials()) >= EXPECTED


@pytest.mark.parametrize("material", builtin_materials().values(), ids=lambda material: material.key)
def test_every_value_is_plausible_and_has_a_source(material: Material) -> None:
    assert material.youngs_modulus is not None
    assert material.density is not None
    for name in ("youngs_modulus", "shear_modulus", "density", "yield_strength", "fatigue_limit"):
        known = getattr(material, name)
        assert known is None or len(known.source) > 8
    assert 10e6 < material.youngs_modulus.value < 250e9
    assert 900.0 < material.density.value < 8100.0
    if material.yield_strength is not None:
        # more than 11 % of elastic strain would be no structural material
        assert 5e-4 < material.yield_strength.value / material.youngs_modulus.value < 0.11
    if material.shear_modulus is not None and material.isotropic:
        poisson = material.youngs_modulus.value / (2.0 * material.shear_modulus.value) - 1.0
        metal = any(word in material.key for word in METALS)
        assert (0.25 if metal else 0.3) < poisson < (0.36 if metal else 0.5)
    if material.fatigue_limit is not None:
        assert material.yield_strength is not None
        below = material.fatigue_limit.value < material.yield_strength.value
        assert below != ("yield governs" in material.fatigue_limit.source)


def test_what_is_not_known_is_listed_here() -> None:
    lacking = {
        (key, name)
        for key, material in builtin_materials().items()
        for name in PROPERTIES
        if getattr(material, name) is None
    }
    assert lacking == {("tpu", "fatigue_limit")}  # no reversed test of it found


@pytest.mark.parametrize("material", builtin_materials().values(), ids=lambda material: material.key)
def test_no_source_is_a_guess(material: Material) -> None:
    for name in PROPERTIES:
        known = getattr(material, name)
        assert known is None or not re.search(r"typical value|assumed|from memory", known.source)


RULES = {"rule": 0.5, "rule of wire": 0.225 / (1.0 - 0.225**2), "rule of polymers": 0.2}


@pytest.mark.parametrize("material", builtin_materials().values(), ids=lambda material: material.key)
def test_a_strength_by_rule_fits_what_it_says(material: Material) -> None:
    allowed = material.yield_strength and re.match(r"allowable: (\d+) % of (\d+) MPa\b", material.yield_strength.source)
    if allowed and material.yield_strength:
        expected = float(allowed[1]) / 100.0 * float(allowed[2]) * 1e6
        assert material.yield_strength.value == pytest.approx(expected, rel=2e-3)
    ruled = material.fatigue_limit and re.match(
        r"(rule[a-z ]*), from (?:its tensile strength of (\d+) MPa|(\d+) MPa|the yield strength)",
        material.fatigue_limit.source,
    )
    assert bool(ruled) == bool(material.fatigue_limit and material.fatigue_limit.source.startswith("rule"))
    if ruled and material.fatigue_limit and material.yield_strength:
        named = ruled[2] or ruled[3]
        strength = float(named) * 1e6 if named else material.yield_strength.value
        expected = min(RULES[ruled[1]] * strength, 700e6)
        assert material.fatigue_limit.value == pytest.approx(expected, rel=1e-2)


def test_only_the_laminates_are_not_isotropic() -> None:
    laminates = {key for key, material in builtin_materials().items() if not material.isotropic}
    assert laminates == {"glass_fibre_laminate", "carbon_fibre_laminate"}


def test_a_derived_shear_modulus_fits_what_it_says() -> None:
    derived = {}
    for key, material in builtin_materials().items():
        said = material.shear_modulus and re.match(r"from E and nu = (\d\.\d+): ", material.shear_modulus.source)
        if said and material.shear_modulus and material.youngs_modulus:
            derived[key] = material.shear_modulus.value
            expected = material.youngs_modulus.value / (2.0 * (1.0 + float(said[1])))
            assert material.shear_modulus.value == pytest.approx(expected, rel=5e-3)  # three digits are written
    assert set(derived) == {
        "spring_steel_51crv4",
        "stainless_301_full_hard",
        "aluminium_7075",
        "pa2200",
        "pe",
        "pom",
        "peek",
        "tpu",
    }


def test_both_strengths_of_a_wire_are_of_one_diameter() -> None:
    for key in ("music_wire", "stainless_302_wire"):
        material = find_material(key)
        assert "diameter 2 mm" in material.name
        tensile = set()
        for known in (material.yield_strength, material.fatigue_limit):
            assert known is not None
            tensile |= set(re.findall(r"(\d+) MPa", known.source))
        assert len(tensile) == 1


def test_the_near_miss_is_named() -> None:
    with pytest.raises(
        InputError, match=r'unknown material "spring_steel_1074" \(did you mean "spring_steel_1075"\?\)'
    ):
        find_material("spring_steel_1074")


def write(tmp_path: Path, text: str) -> Path:
    path = tmp_path / "mine.yaml"
    path.write_text(text, encoding="utf-8")
    return path


def test_a_users_file_adds_and_replaces(tmp_path: Path) -> None:
    path = write(
        tmp_path,
        "bronze:\n  name: Spring bronze\n  source: our tensile test 12\n  youngs_modulus: 110 GPa\n"
        "  yield_strength: {value: 500 MPa, source: supplier}\n"
        "pa2200: {youngs_modulus: 1.5 GPa, source: our test}\n",
    )
    own = read_materials(path)
    bronze = find_material("bronze", extra=own)
    assert bronze.youngs_modulus is not None
    assert (bronze.youngs_modulus.value, bronze.youngs_modulus.source) == (110e9, "our tensile test 12")
    assert bronze.yield_strength is not None
    assert bronze.yield_strength.source == "supplier"
    assert bronze.shear_modulus is None
    replaced = find_material("pa2200", extra=own).youngs_modulus
    assert replaced is not None
    assert replaced.value == 1.5e9


def test_a_users_laminate_is_marked(tmp_path: Path) -> None:
    own = read_materials(
        write(tmp_path, "ply: {isotropic: false}\nbrass: {}\ncarbon_fibre_laminate: {isotropic: true}")
    )
    assert not own["ply"].isotropic
    assert own["brass"].isotropic
    assert find_material("carbon_fibre_laminate", extra=own).isotropic


@pytest.mark.parametrize(
    "text, said",
    [
        ("ply: {isotropic: 0}", "ply.isotropic: is 0; allowed is true or false"),
        ("ply: {isotropic: }", "ply.isotropic: is nothing; allowed is true or false"),
        ("ply: {isotropc: false}", 'did you mean "isotropic"'),
        ("bronze: {youngs_modulus: 110 GPa}", "bronze.youngs_modulus: has no source"),
        ("bronze: {youngs_modulus: 110, source: x}", "bronze.youngs_modulus: 110 has no unit"),
        ("bronze: {youngs_modulus: -1 GPa, source: x}", "above zero"),
        ("bronze: {density: 8 GPa, source: x}", "is a stress or modulus; allowed is a density"),
        ("bronze: {youngs: 110 GPa, source: x}", 'did you mean "youngs_modulus"'),
        ("bronze: {density: {value: 1 kg/m^3, sauce: x}}", 'did you mean "source"'),
        ("bronze: 3", "allowed is a mapping"),
        ("- bronze", "allowed is a mapping"),
        ("Bronze!: {}", "no material name"),
        ("bronze: {name: [1]}", "must be text"),
        ("a: {}\n---\nb: {}", "holds 2 YAML documents"),
    ],
)
def test_a_wrong_file_is_one_line(tmp_path: Path, text: str, said: str) -> None:
    path = write(tmp_path, text)
    with pytest.raises(InputError) as caught:
        read_materials(path)
    assert str(caught.value).startswith(f"{path}: ")
    assert said in str(caught.value)
