"""``varistiff verify``: one clear line for wrong input, nothing half-written, and a result that says what it is."""

from __future__ import annotations

import csv
import json
import sys
from collections.abc import Callable
from pathlib import Path

import pytest

from varistiff.cli.main import main
from varistiff.cli.verification import end_model
from varistiff.core.errors import InputError
from varistiff.core.textfile import parse_yaml
from varistiff.design.read import validated
from varistiff.design.spec import TorsionTubeSpec
from varistiff.elastic.end_effect import EndEffect
from varistiff.fe.end_fit import EndFit
from varistiff.fe.torsion_body import Body
from varistiff.fe.torsion_cases import Outcome

ROD = """name: Short rod
actuator:
  kind: torsion_tube
  shear_modulus: 0.63 GPa
  yield_strength: 48 MPa
  section: {shape: circle, radius: 9 mm}
  length: 60 mm
  setting: {min: 20 mm, max: 40 mm}
  deflection: {min: -5 deg, max: 5 deg}
verification: {poissons_ratio: 0.35, bearing_length: 8 mm}
"""


@pytest.fixture
def rod(tmp_path: Path) -> Path:
    path = tmp_path / "rod.yaml"
    path.write_text(ROD, encoding="utf-8")
    return path


def refused(capsys: pytest.CaptureFixture[str], arguments: list[str], output: Path) -> str:
    before = sorted(output.parent.iterdir())
    assert main(["verify", *arguments, "--output", str(output)]) == 2
    said = capsys.readouterr().err.strip().splitlines()
    assert sorted(output.parent.iterdir()) == before
    assert len(said) == 1
    return said[0]


@pytest.mark.parametrize(
    ("options", "said"),
    [
        (["--setting", "51"], '--setting: "51" has no unit; allowed is a length'),
        (["--setting", "51 N"], "--setting: "),
        (["--setting", "70mm"], "70 mm is outside the element; allowed is 0 mm to below 60 mm"),
        (["--setting", "-1mm"], "-1 mm is outside the element"),
        (
            ["--setting", "0mm"],
            "rod.yaml: --setting: 0 mm is the rigid lock, where the bearing meets the clamp and",
        ),
        (["--deflection", "1deg"], "--deflection: is given, but a torsion tube's stiffness"),
        (["--tolerance", "0.5"], "--tolerance: is 0.5; allowed is from 0.0001 to 0.1"),
        (["--tolerance", "much"], "--tolerance"),
        (["--measured", "missing.csv"], "missing.csv: cannot be read"),
    ],
)
def test_wrong_options(
    capsys: pytest.CaptureFixture[str], rod: Path, tmp_path: Path, options: list[str], said: str
) -> None:
    pytest.importorskip("ngsolve")
    assert said in refused(capsys, [str(rod), *options], tmp_path / "out")


def test_a_measurement_with_a_text_cell(capsys: pytest.CaptureFixture[str], rod: Path, tmp_path: Path) -> None:
    table = tmp_path / "measured.csv"
    table.write_text("setting,stiffness\n0.02,300\n0.03,soft\n", encoding="utf-8")
    said = refused(capsys, [str(rod), "--measured", str(table)], tmp_path / "out")
    assert "measured.csv: row 2 (line 3), column stiffness" in said


def test_a_kind_without_a_solid(
    capsys: pytest.CaptureFixture[str], example: Callable[[str], str], tmp_path: Path
) -> None:
    path = tmp_path / "sea.yaml"
    path.write_text(example("series_elastic"), encoding="utf-8")
    assert "a series_elastic has no solid to check; allowed: torsion_tube" in refused(
        capsys, [str(path)], tmp_path / "out"
    )


def test_the_extra_is_missing(
    capsys: pytest.CaptureFixture[str], rod: Path, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setitem(sys.modules, "ngsolve", None)
    assert "pip install 'varistiff[fe]'" in refused(capsys, [str(rod), "--setting", "30mm"], tmp_path / "out")


def test_a_directory_of_somebody_else(capsys: pytest.CaptureFixture[str], rod: Path, tmp_path: Path) -> None:
    pytest.importorskip("ngsolve")
    output = tmp_path / "mine"
    output.mkdir()
    (output / "thesis.txt").write_text("years of work", encoding="utf-8")
    assert "holds 'thesis.txt'" in refused(capsys, [str(rod)], output)
    assert (output / "thesis.txt").read_text(encoding="utf-8") == "years of work"


def test_a_rod_is_checked(
    capsys: pytest.CaptureFixture[str], rod: Path, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    pytest.importorskip("ngsolve")
    monkeypatch.setenv("VARISTIFF_CACHE", "off")
    table, output = tmp_path / "measured.csv", tmp_path / "out"
    table.write_text("setting,stiffness\n0.03,210\n", encoding="utf-8")
    arguments = ["verify", str(rod), "--setting", "30mm", "--measured", str(table), "-o", str(output)]
    assert main(arguments) == 0
    said = capsys.readouterr()
    first, second, *_ = said.err.splitlines()
    assert first.startswith("varistiff: 1 setting, in all: about ")
    assert first.endswith(" GiB with 3; estimates, within a factor of about two")
    assert second.startswith("varistiff: setting 1 of 1")
    assert "section theory" in said.out
    rows = list(csv.DictReader((output / "comparison.csv").read_text(encoding="utf-8").splitlines()))
    found = {row["method"]: float(row["stiffness"]) for row in rows}
    # a circle does not warp: a rigid end flange twists it exactly as the formula says, to the solid's 0.5 %
    assert found["end_flange_free"] == pytest.approx(found["section_theory"], rel=0.005)
    assert found["measured"] == 210.0
    about = json.loads((output / "comparison.json").read_text(encoding="utf-8"))["about"]
    assert about["design"] == ROD
    assert len(about["design_hash"]) == 64
    assert "ngsolve" in about["versions"]
    assert about["strength"] == "2.77128e+07 Pa"  # 48 MPa/sqrt(3)
    assert "broken_assumption" not in about
    page = (output / "report.html").read_text(encoding="utf-8")
    assert "Short rod" in page
    assert "Provenance" in page
    assert (output / "figures" / "comparison.svg").exists()


@pytest.fixture
def unmeshable(monkeypatch: pytest.MonkeyPatch) -> None:
    """Let Netgen fail as it does."""
    geometry = pytest.importorskip("netgen.geom2d").SplineGeometry
    from netgen.libngpy._meshing import NgException

    def fail(*_: object, **__: object) -> None:
        raise NgException("meshing failed")

    monkeypatch.setattr(geometry, "GenerateMesh", fail)


def test_a_section_that_netgen_cannot_mesh(
    capsys: pytest.CaptureFixture[str], rod: Path, tmp_path: Path, unmeshable: None, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setenv("VARISTIFF_CACHE", "off")
    assert refused(capsys, [str(rod)], tmp_path / "out") == (
        f"varistiff: {rod}: actuator.section: the section cannot be meshed (Netgen says: meshing failed); allowed is "
        "an outline without walls, gaps and details that are far smaller than the rest"
    )


def test_results_before_a_failure_are_kept(
    capsys: pytest.CaptureFixture[str], rod: Path, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    pytest.importorskip("ngsolve")
    from varistiff.fe import torsion_solve

    kept, output = tmp_path / "kept", tmp_path / "out"
    monkeypatch.setenv("VARISTIFF_CACHE", str(kept))
    run = torsion_solve.flange_outcome

    def fail(body: Body) -> Outcome:
        if body.problem.active_length > 0.035:
            raise InputError("the section cannot be meshed (as it were)", field="actuator.section")
        return run(body)

    monkeypatch.setattr(torsion_solve, "flange_outcome", fail)
    arguments = ["verify", str(rod), "--setting", "30mm", "--setting", "40mm", "--tolerance", "0.1", "-o", str(output)]
    assert main(arguments) == 2
    told = capsys.readouterr().err.splitlines()
    assert told[0].startswith("varistiff: 2 settings, in all: about ")
    assert told[-1] == f"varistiff: {rod}: setting 40 mm, actuator.section: the section cannot be meshed (as it were)"
    assert not output.exists()
    (entry,) = (kept / "varistiff" / "verify").iterdir()
    before = entry.read_bytes()
    assert main(arguments) == 2
    again = capsys.readouterr().err.splitlines()
    assert again[0].startswith("varistiff: 1 setting (1 more kept from an earlier run), in all: about ")
    assert again[1:3] == ["varistiff: setting 1 of 2, 30 mm", "varistiff: setting 2 of 2, 40 mm"]  # no mesh in between
    assert entry.read_bytes() == before


def test_a_point_without_a_load(
    capsys: pytest.CaptureFixture[str], example: Callable[[str], str], tmp_path: Path
) -> None:
    pytest.importorskip("ngsolve")
    path = tmp_path / "beam.yaml"
    path.write_text(example("roller_beam"), encoding="utf-8")
    said = refused(capsys, [str(path), "--setting", "300mm", "--deflection", "0deg"], tmp_path / "out")
    assert said == (
        f"varistiff: {path}: --deflection: 0 deg at the setting 300 mm is no_contact; allowed is a point with a load: "
        "reduce the clearance or preload the element if play is unwanted"
    )


def test_a_step_file_that_cannot_be_written(capsys: pytest.CaptureFixture[str], rod: Path, tmp_path: Path) -> None:
    pytest.importorskip("ngsolve")
    for target, said in [
        (rod / "rod.step", "cannot be written: not a directory; choose another --step"),
        (rod, "is the design itself; choose another --step"),
    ]:
        assert main(["verify", str(rod), "--step", str(target)]) == 2
        assert capsys.readouterr().err == f"varistiff: {target}: {said}\n"
    assert [path.name for path in tmp_path.iterdir()] == ["rod.yaml"]


def test_a_section_that_is_no_solid(
    capsys: pytest.CaptureFixture[str], rod: Path, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    occ = pytest.importorskip("netgen.occ")

    def fail(*_: object) -> None:
        raise RuntimeError("BRep_API: command not done\nat line 7")

    monkeypatch.setattr(occ, "Face", fail)
    assert main(["verify", str(rod), "--step", str(tmp_path / "rod.step")]) == 2
    assert capsys.readouterr().err.startswith(
        f"varistiff: {rod}: actuator.section: no solid can be made of the section (the CAD kernel says: BRep_API: "
        "command not done); allowed is"
    )
    assert [path.name for path in tmp_path.iterdir()] == ["rod.yaml"]


def test_a_printed_end_model_is_one_that_a_design_takes() -> None:
    lock = EndEffect(offset=0.0033, lock_offset=0.0003, decay=0.0029, shortest=0.0, longest=0.166)
    plain = EndEffect(offset=-0.0012, lock_offset=0.0, decay=0.1, shortest=0.011, longest=0.166)
    for effect in (lock, plain):
        text = end_model(EndFit(effect, 0.001)).removeprefix("end_model: ")
        (document,) = parse_yaml(ROD.replace("  length: 60 mm", f"  length: 200 mm\n  end_model: {text}"))
        actuator = validated(document).actuator
        assert isinstance(actuator, TorsionTubeSpec)
        assert actuator.end_model is not None
        assert actuator.end_model.offset == pytest.approx(effect.offset, rel=1e-3)
        assert actuator.end_model.lock_offset == pytest.approx(effect.lock_offset, rel=1e-2)


def test_a_measurement_in_millimetres(capsys: pytest.CaptureFixture[str], rod: Path, tmp_path: Path) -> None:
    table = tmp_path / "measured.csv"
    table.write_text("setting,stiffness\n30,210\n", encoding="utf-8")
    said = refused(capsys, [str(rod), "--measured", str(table)], tmp_path / "out")
    assert "row 1, column setting: 30 m is outside the element; allowed is 0 to 0.06, in metres" in said
