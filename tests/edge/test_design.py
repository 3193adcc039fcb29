"""What a design knows before anything is computed."""

from __future__ import annotations

import json
import math
import re
import subprocess
import sys
from collections.abc import Callable
from pathlib import Path
from typing import Any

import pytest

from varistiff.core.citations import citation, citations
from varistiff.core.errors import InputError
from varistiff.core.textfile import parse_yaml
from varistiff.design.design import Design, load
from varistiff.design.spec import TorsionTubeSpec, json_schema

KINDS = ("roller_beam", "torsion_tube", "antagonistic_leaves", "slider_leaf_joint", "series_elastic", "maccepa")


@pytest.fixture
def loaded(tmp_path: Path) -> Callable[[str], Design]:
    def from_text(text: str) -> Design:
        path = tmp_path / "design.yaml"
        path.write_text(text, encoding="utf-8")
        return load(path)

    return from_text


@pytest.mark.parametrize("kind", KINDS)
def test_the_examples_are_designs(example: Callable[[str], str], loaded: Callable[[str], Design], kind: str) -> None:
    design = loaded(example(kind))
    assert design.kind == kind
    assert design.warnings == ()
    assert kind in repr(design)
    assert "<table>" in design._repr_html_()
    assert re.fullmatch("[0-9a-f]{64}", design.hash)


def test_ranges_and_units_are_those_of_the_file(example: Callable[[str], str], loaded: Callable[[str], Design]) -> None:
    beam = loaded(example("roller_beam"))
    assert beam.setting_range == (0.2, 0.6)
    assert beam.deflection_range == pytest.approx((-math.pi / 18.0, math.pi / 18.0), rel=1e-15)
    assert (beam.deflection_unit, beam.setting_unit) == ("rad", "m")
    spring = loaded(example("antagonistic_leaves"))
    assert (spring.deflection_unit, spring.setting_unit) == ("m", "m")
    assert spring.deflection_range == (-0.015, 0.015)
    fixed = loaded(example("series_elastic"))
    assert (fixed.setting_unit, fixed.setting_range) == (None, None)
    by_disc = loaded(example("slider_leaf_joint").replace("{min: 15 mm, max: 25 mm}", "{min: 10 deg, max: 40 deg}"))
    assert by_disc.setting_unit == "rad"


def test_the_hash_sees_values_and_nothing_else(example: Callable[[str], str], loaded: Callable[[str], Design]) -> None:
    text = example("roller_beam")
    before = loaded(text).hash
    same = [
        text.replace("3.16 mm", "0.00316 m"),
        text.replace("-10 deg", "-600 arcmin"),
        text.replace("194 GPa", "1.94e11 Pa"),
        text.replace("194 GPa", "194e3 N/mm^2"),
        text.replace("mounting_angle: 0 deg", "mounting_angle: -0 rad"),
        text + "# a comment\n",
        text.replace("name: Spring-steel roller beam", "name: Another name"),
        text.replace("material: spring_steel_1075", "material: peek"),  # both its values are overridden
    ]
    assert {loaded(other).hash for other in same} == {before}
    different = [
        text.replace("3.16 mm", "3.160001 mm"),
        text.replace("-10 deg", "-10.1 deg"),
        text.replace("swivelling_pair", "fixed_pair"),
        text.replace("yield_strength: 500 MPa", ""),
    ]
    assert len({loaded(other).hash for other in different} | {before}) == 5


def test_a_length_and_an_angle_of_one_number_differ(
    example: Callable[[str], str], loaded: Callable[[str], Design]
) -> None:
    text = example("slider_leaf_joint")
    length = loaded(text.replace("{min: 15 mm, max: 25 mm}", "{min: 0.015 m, max: 0.025 m}"))
    angle = loaded(text.replace("{min: 15 mm, max: 25 mm}", "{min: 0.015 rad, max: 0.025 rad}"))
    assert length.setting_range == angle.setting_range
    assert length.hash != angle.hash


def test_a_value_in_the_file_overrides_the_materials(
    example: Callable[[str], str], loaded: Callable[[str], Design]
) -> None:
    text = example("torsion_tube").replace("material: pa2200", "material: aluminium_6061")
    both = loaded(text).elements
    assert isinstance(both, TorsionTubeSpec)
    assert (both.shear_modulus, both.yield_strength) == (0.63e9, 48e6)
    alone = loaded(re.sub(r"  (shear_modulus|yield_strength):.*\n", "", text)).elements
    assert isinstance(alone, TorsionTubeSpec)
    assert (alone.shear_modulus, alone.yield_strength) == (26e9, 276e6)


def test_a_materials_file_lies_beside_the_design(
    tmp_path: Path, example: Callable[[str], str], loaded: Callable[[str], Design]
) -> None:
    text = example("torsion_tube").replace("material: pa2200", "material: mine").replace("  shear_modulus", "  # G")
    (tmp_path / "mine.yaml").write_text("mine: {shear_modulus: 1 GPa, source: test}\n")
    with pytest.raises(InputError, match=r"actuator\.material: unknown material \"mine\""):
        loaded(text)
    design = loaded(text + "materials_file: mine.yaml\n")
    assert isinstance(design.elements, TorsionTubeSpec)
    assert design.elements.shear_modulus == 1e9
    (tmp_path / "other.yaml").write_text("mine: {shear_modulus: 2 GPa, source: test}\n")
    other = load(design.path, materials=tmp_path / "other.yaml")
    assert other.hash != design.hash
    with pytest.raises(InputError, match=r"missing\.yaml: cannot be read"):
        loaded(text + "materials_file: missing.yaml\n")


def test_several_designs_in_one_file_are_refused_with_their_names(
    example: Callable[[str], str], loaded: Callable[[str], Design]
) -> None:
    text = "---\n".join(example(kind) for kind in ("maccepa", "series_elastic")) + "---\nactuator: 1\n"
    said = "holds 3 designs (MACCEPA, Series elastic joint, without a name); allowed is one design per file"
    with pytest.raises(InputError, match=re.escape(said)):
        loaded(text)
    assert loaded("---\n" + example("maccepa") + "---\n").name == "MACCEPA"  # an empty document is none


def test_a_stubby_beam_is_warned_about(example: Callable[[str], str], loaded: Callable[[str], Design]) -> None:
    text = example("roller_beam")
    assert loaded(text.replace("length: 0.90 m", "length: 17.07 mm")).warnings == ()  # 5.402 thicknesses
    (warning,) = loaded(text.replace("length: 0.90 m", "length: 17.0 mm")).warnings
    assert "length/thickness" in warning


def test_the_schema_completes_every_field_and_holds_for_the_examples(example: Callable[[str], str]) -> None:
    schema = json_schema()
    json.dumps(schema)
    text = json.dumps(schema)
    for kind in KINDS:
        (document,) = parse_yaml(example(kind))
        assert conforms(document, schema, schema)
        for name in field_names(document):
            assert f'"{name}"' in text
    (document,) = parse_yaml(example("roller_beam"))
    for broken in ("3.16", "thick", "- 3 mm", "-3 mm"):
        document["actuator"]["beam"]["thickness"] = broken
        assert not conforms(document, schema, schema)
    document["actuator"]["beam"]["thickness"] = "3 mm"
    document["actuator"]["beam"]["thicknes"] = "3 mm"
    assert not conforms(document, schema, schema)


def field_names(document: dict[str, Any]) -> set[str]:
    inner = [field_names(value) for value in document.values() if isinstance(value, dict)]
    return set(document).union(*inner)


def conforms(value: Any, schema: dict[str, Any], root: dict[str, Any]) -> bool:
    """A validator of the few words of JSON schema that ours uses."""
    if "$ref" in schema:
        return conforms(value, root["$defs"][schema["$ref"].rsplit("/", 1)[1]], root)
    for word in ("oneOf", "anyOf"):
        if word in schema:
            passing = sum(conforms(value, option, root) for option in schema[word])
            return passing == 1 if word == "oneOf" else passing > 0
    if "const" in schema and value != schema["const"]:
        return False
    if "enum" in schema and value not in schema["enum"]:
        return False
    kind = schema.get("type")
    if kind == "object":
        fields = schema["properties"]
        return (
            isinstance(value, dict)
            and set(value) <= set(fields)
            and set(schema.get("required", ())) <= set(value)
            and all(conforms(item, fields[name], root) for name, item in value.items())
        )
    if kind == "string":
        return isinstance(value, str) and re.search(schema.get("pattern", ""), value) is not None
    if kind == "integer":
        return isinstance(value, int) and schema["minimum"] <= value <= schema["maximum"]
    return kind != "null" or value is None


def test_fields_of_a_section_file_say_what_they_mean() -> None:
    fields = json_schema()["$defs"]["PolygonSpec"]["properties"]
    assert "CSV" in fields["file"]["description"]
    assert "relative to the design file" in fields["file"]["description"]
    assert "required for CSV" in fields["unit"]["description"]


def test_a_wrong_section_file_is_said_with_the_designs_field(
    example: Callable[[str], str], loaded: Callable[[str], Design], tmp_path: Path
) -> None:
    (tmp_path / "outline.csv").write_text("x,y\n0,0\n20,0\n0,z\n", encoding="utf-8")
    whole = r"  section:.*?\n  (?=\w)"
    text = re.sub(
        whole, "  section: {shape: polygon, file: OUT, unit: mm}\n  ", example("torsion_tube"), flags=re.DOTALL
    )
    for name, said in [
        ("outlin.csv", 'cannot be read: no such file or directory (did you mean "outline.csv"?)'),
        ("other.dxf", "cannot be read: no such file or directory"),
        ("outline.csv", 'line 4, column y: "z" is not a number; allowed is a finite number without a unit'),
    ]:
        with pytest.raises(InputError) as caught:
            loaded(text.replace("OUT", name))
        assert str(caught.value) == (f"{tmp_path / 'design.yaml'}: actuator.section.file: {tmp_path / name}: {said}")


def test_every_citation_is_complete() -> None:
    for entry in citations().values():
        assert str(entry.year) in entry.key
        assert entry.doi is None or entry.doi.startswith("10.")
        assert entry.title in str(entry)
    with pytest.raises(InputError, match='did you mean "van_ham_2007"'):
        citation("van_ham_2008")


def test_designs_are_checked_without_the_slow_libraries(example: Callable[[str], str], tmp_path: Path) -> None:
    path = tmp_path / "design.yaml"
    path.write_text(example("roller_beam"), encoding="utf-8")
    script = (
        "import sys, varistiff; from varistiff.cli.main import main\n"
        f"assert main(['validate', {str(path)!r}]) == 0 and main(['schema']) == 0 and main(['materials']) == 0\n"
        "slow = {'jax', 'xarray', 'matplotlib', 'equinox'} & set(sys.modules)\n"
        "assert not slow, slow\n"
    )
    subprocess.run([sys.executable, "-c", script], check=True, stdout=subprocess.DEVNULL)
