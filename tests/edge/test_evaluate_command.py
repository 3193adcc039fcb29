"""`varistiff evaluate` on real actuators: the contract's columns, digits and order."""

from __future__ import annotations

import csv
import math
from collections.abc import Callable
from pathlib import Path
from typing import Any

import numpy as np
import pytest

import varistiff
from varistiff.core.citations import citation
from varistiff.core.errors import InputError
from varistiff.core.status import Status
from varistiff.design.design import Design, load

HEADERS = {
    "roller_beam": "deflection,setting,status,energy,torque,stiffness,adjusting_force,stress",
    "torsion_tube": "deflection,setting,status,energy,torque,stiffness,adjusting_force,stress",
    "antagonistic_leaves": "deflection,setting,status,energy,force,stiffness,adjusting_force,stress",
    "slider_leaf_joint": "deflection,setting,status,energy,torque,stiffness,adjusting_force,stress",
    "series_elastic": "deflection,setting,status,energy,torque,stiffness,adjusting_force,stress",
    "maccepa": "deflection,setting,status,energy,torque,stiffness,adjusting_force,stress",
}


def rows(path: Path) -> tuple[str, list[dict[str, str]]]:
    text = path.read_text(encoding="utf-8")
    return text.splitlines()[0], list(csv.DictReader(text.splitlines()))


def write_points(path: Path, points: list[tuple[float, float]]) -> Path:
    path.write_text("deflection,setting\n" + "".join(f"{d!r},{s!r}\n" for d, s in points), encoding="utf-8")
    return path


def written(tmp_path: Path, text: str) -> Path:
    path = tmp_path / "design.yaml"
    path.write_text(text, encoding="utf-8")
    return path


@pytest.mark.parametrize("kind", HEADERS)
def test_every_example_evaluates_to_what_the_library_says(
    run: Callable[..., Any], tmp_path: Path, example: Callable[[str], str], kind: str
) -> None:
    path = written(tmp_path, example(kind))
    design = load(path)
    setting = design.setting_range or (0.1, 0.2)
    at = [(0.3 * design.deflection_range[1], setting[1]), (-0.9 * design.deflection_range[1], setting[0]), (0.0, 0.17)]
    output = tmp_path / "out.csv"
    result = run("evaluate", path, write_points(tmp_path / "points.csv", at), "--output", output)
    assert result.status == 0
    assert result.out == ""
    header, table = rows(output)
    assert header == HEADERS[kind]
    assert [(float(row["deflection"]), float(row["setting"])) for row in table] == at
    given = np.array(at).T
    answer = design.evaluate(given[0], given[1] if design.setting_unit else None)
    load_column, adjusting_column = header.split(",")[4], header.split(",")[6]
    for column, values in [
        ("energy", answer.energy),
        (load_column, answer.load),
        ("stiffness", answer.stiffness),
        (adjusting_column, answer.adjusting_load),
        ("stress", answer.stress),
    ]:
        np.testing.assert_array_equal([float(row[column]) for row in table], values)  # 17 digits lose nothing
    assert [row["status"] for row in table] == [Status(int(code)).label for code in answer.status]


@pytest.mark.parametrize("kind", HEADERS)
def test_every_reference_of_a_kind_is_a_known_citation(
    tmp_path: Path, example: Callable[[str], str], kind: str
) -> None:
    design = load(written(tmp_path, example(kind)))
    actuator = design.actuator
    assert (actuator.kind, actuator.deflection_unit, actuator.setting_unit) == (
        kind,
        design.deflection_unit,
        design.setting_unit,
    )
    assert actuator.references
    for key in actuator.references:
        assert citation(key).key == key


def test_a_disc_angle_gives_an_adjusting_torque(
    run: Callable[..., Any], tmp_path: Path, example: Callable[[str], str]
) -> None:
    text = example("slider_leaf_joint").replace("{min: 15 mm, max: 25 mm}", "{min: 20 deg, max: 40 deg}")
    path = written(tmp_path, text)
    output = tmp_path / "out.csv"
    points = write_points(tmp_path / "points.csv", [(0.01, math.radians(30.0))])
    assert run("evaluate", path, points, "--output", output).status == 0
    header, (row,) = rows(output)
    assert header.split(",")[6] == "adjusting_torque"
    assert row["status"] == "ok"
    assert float(row["adjusting_torque"]) < 0.0  # the slider wants to move outward, to larger disc angles


def test_a_spring_without_setting_and_stress(run: Callable[..., Any], series: Path, points: Path) -> None:
    output = series.parent / "out.csv"
    assert run("evaluate", series, points, "--output", output).status == 0
    # V = k q^2/2 = 0.8 J at 0.1 rad and 160 N m/rad
    _, table = rows(output)
    assert float(table[0]["energy"]) == pytest.approx(0.8, rel=1e-15)
    assert float(table[1]["torque"]) == pytest.approx(-8.0, rel=1e-15)
    assert (table[0]["setting"], table[0]["stress"], table[0]["adjusting_force"]) == ("nan", "nan", "nan")
    assert table[0]["status"] == "ok"
    assert table[0]["deflection"] == "0.10000000000000001"


def test_statuses_other_than_ok_succeed_and_are_counted(
    run: Callable[..., Any], tmp_path: Path, example: Callable[[str], str]
) -> None:
    path = written(tmp_path, example("torsion_tube"))
    points = write_points(tmp_path / "points.csv", [(0.01, 0.1), (0.01, 0.2), (0.01, -0.1), (0.01, 0.3)])
    output = tmp_path / "out.csv"
    result = run("evaluate", path, points, "--output", output)
    assert result.status == 0
    assert "1 of 4 points ok" in result.err
    assert "2 element_too_short: The elastic element is shorter" in result.err
    assert "1 no_solution: " in result.err
    _, table = rows(output)
    assert [row["status"] for row in table] == ["ok", "element_too_short", "no_solution", "element_too_short"]
    assert {row["energy"] for row in table[1:]} == {"nan"}


def test_a_header_alone_gives_a_header(run: Callable[..., Any], series: Path) -> None:
    points = series.parent / "empty.csv"
    points.write_text("deflection,setting\n")
    output = series.parent / "out.csv"
    assert run("evaluate", series, points, "--output", output).status == 0
    assert output.read_text() == HEADERS["series_elastic"] + "\n"


def test_columns_that_are_not_used_are_said(run: Callable[..., Any], series: Path) -> None:
    points = series.parent / "points.csv"
    points.write_text("time,deflection\n0,0.1\n")
    result = run("evaluate", series, points, "--output", series.parent / "out.csv")
    assert result.status == 0
    assert "columns not used: time" in result.err


def test_a_design_answers_in_python(series: Path, tmp_path: Path, example: Callable[[str], str]) -> None:
    spring = varistiff.load(series)
    assert isinstance(spring, Design)
    answer = spring.evaluate(np.array([[0.1], [0.2]]))
    assert answer.load.shape == (2, 1)
    with pytest.raises(InputError, match="has no setting"):
        spring.evaluate(0.1, 0.2)
    joint = varistiff.load(written(tmp_path, example("maccepa")))
    with pytest.raises(InputError, match="needs one in m"):
        joint.evaluate(0.1)
    seen: list[tuple[int, int]] = []
    dataset = joint.map(deflection_points=5, setting_points=3, progress=lambda *done: seen.append(done))
    assert dict(dataset.sizes) == {"setting": 3, "deflection": 5}
    assert seen[-1] == (15, 15)
    assert dataset.attrs["design_hash"] == joint.hash
    assert dataset.attrs["design"] == joint.text
    assert dataset.attrs["title"] == "MACCEPA"
    assert float(dataset["deflection"][0]) == joint.deflection_range[0]
    assert dict(spring.map(deflection_points=4).sizes) == {"deflection": 4}
    with pytest.raises(InputError, match="allowed is 2 or more"):
        joint.map(setting_points=1)
