"""`varistiff simulate`: exit status, one clear line, and partial results that say what they are."""

from __future__ import annotations

import json
import shutil
from collections.abc import Callable
from dataclasses import replace
from pathlib import Path
from typing import Any

import pytest
import xarray as xr

from varistiff.cli.simulation import exit_status, failure, summary
from varistiff.design.scenario import Scenario, Simulation, load_scenario
from varistiff.dynamics.outcome import Outcome

EXAMPLES = Path(__file__).parents[2] / "examples"
FILES = ["data.csv", "data.nc", "figures", "report.html", "simulation.json"]
TEXT = """
name: Push
design: series_elastic.yaml
duration: 50 ms
plant:
  link: {inertia: 0.05 kg*m^2}
  drive: {inertia: 0.02 kg*m^2}
control:
  period: 1 ms
  drive: {kind: pid, feedback: drive, proportional: 5 N*m/rad, derivative: 0.5 N*m*s/rad}
reference:
  position: {kind: step, time: 5 ms, after: 2 deg}
"""


def names(directory: Path) -> list[str]:
    return sorted(path.name for path in directory.iterdir())


@pytest.fixture
def scenario(tmp_path: Path) -> Callable[..., Path]:
    shutil.copy(EXAMPLES / "series_elastic.yaml", tmp_path)

    def write(*changes: tuple[str, str]) -> Path:
        text = TEXT
        for old, new in changes:
            assert old in text
            text = text.replace(old, new, 1)
        path = tmp_path / "push.yaml"
        path.write_text(text, encoding="utf-8")
        return path

    return write


def test_a_result_is_written_and_told(
    run: Callable[..., Any], scenario: Callable[..., Path], monkeypatch: pytest.MonkeyPatch
) -> None:
    path = scenario()
    monkeypatch.chdir(path.parent)
    done = run("simulate", path)
    assert (done.status, done.err) == (0, "")
    assert names(path.parent) == ["push.yaml", "push_simulation", "series_elastic.yaml"]
    assert names(path.parent / "push_simulation") == FILES
    lines = done.out.splitlines()
    assert lines[0] == "Push (Series elastic joint, series_elastic)"
    assert lines[1].startswith("outcome: done. ")
    assert lines[2].startswith("computed: 0.05 s of 0.05 s, 51 samples, step ")
    assert lines[3].startswith("energy: residual ")
    assert lines[3].endswith(": the balance closes")
    assert any(line.startswith("  largest position error ") and line.endswith(" deg") for line in lines)
    assert lines[-1] == "Results are in push_simulation"
    assert run("simulate", path).status == 0  # again, over the first


def test_an_unstable_loop_says_when_and_keeps_what_there_is(
    run: Callable[..., Any], scenario: Callable[..., Path]
) -> None:
    path = scenario(("derivative: 0.5", "derivative: 500"), ("proportional: 5 ", "proportional: 90000 "))
    output = path.parent / "out"
    done = run("simulate", path, "--output", output)
    assert done.status == 2
    assert done.line.startswith(f"varistiff: {path}: unstable at 0.0")
    assert "The controlled joint runs away." in done.line
    assert "outcome: unstable" in done.out
    assert names(output) == FILES
    with xr.open_dataset(output / "data.nc", engine="h5netcdf") as data:
        assert data.attrs["outcome"] == "unstable"
        assert data.sizes["time"] > 1
    assert json.loads((output / "simulation.json").read_text())["is_result"] is False
    assert "unstable" in (output / "report.html").read_text()


def test_a_step_too_large_is_the_users(run: Callable[..., Any], scenario: Callable[..., Path]) -> None:
    """sqrt(k (1/J + 1/J_1)) h = 3.3: beyond 2.8 the Runge-Kutta method is unstable."""
    path = scenario(("0.05 kg*m^2", "3e-5 kg*m^2"), ("0.02 kg*m^2", "3e-5 kg*m^2"), ("50 ms", "50 ms\nstep: 1 ms"))
    uncontrolled = path.read_text().split("control:")[0]
    path.write_text(uncontrolled + "start: {drive: 1 deg}\n", encoding="utf-8")
    done = run("simulate", path, "--output", path.parent / "out")
    assert done.status == 2
    assert done.line.startswith(f"varistiff: {path}: step_too_large at ")
    assert "Leave `step` out, or make it smaller." in done.line


@pytest.fixture(scope="module")
def finished(tmp_path_factory: pytest.TempPathFactory) -> Simulation:
    folder = tmp_path_factory.mktemp("finished")
    shutil.copy(EXAMPLES / "series_elastic.yaml", folder)
    (folder / "push.yaml").write_text(TEXT, encoding="utf-8")
    return load_scenario(folder / "push.yaml").simulate()


def turned(simulation: Simulation, outcome: Outcome, *, step: str | None) -> Simulation:
    """The same run with another end."""
    spec = simulation.scenario.spec.model_copy(update={"step": step})
    scenario: Scenario = replace(simulation.scenario, spec=spec)
    failed = None if outcome is Outcome.DONE else 0.012
    return replace(simulation, scenario=scenario, run=replace(simulation.run, outcome=outcome, failed_at=failed))


@pytest.mark.parametrize(
    "outcome, chosen_by_user, status",
    [
        (Outcome.DONE, False, 0),
        (Outcome.DONE, True, 0),
        (Outcome.UNSTABLE, False, 2),
        (Outcome.LEFT_MAP, False, 2),
        (Outcome.LEFT_MAP, True, 2),
        (Outcome.STEP_TOO_LARGE, True, 2),
        (Outcome.AUDIT_OPEN, True, 2),
        (Outcome.AUDIT_OPEN, False, 1),
    ],
)
def test_every_outcome_has_its_exit_status(
    finished: Simulation, outcome: Outcome, chosen_by_user: bool, status: int
) -> None:
    simulation = turned(finished, outcome, step=1e-3 if chosen_by_user else None)
    assert exit_status(simulation) == status
    if status:
        line = failure(simulation)
        assert line.startswith(f"{simulation.scenario.path}: {outcome.value} at 0.012 s: {outcome.meaning} ")
        assert line.isprintable()
        assert ("`step`" in line) <= chosen_by_user  # nobody can leave out what is not there
    assert f"outcome: {outcome.value}. {outcome.meaning}" in list(summary(simulation))


def test_a_wrong_scenario_leaves_nothing(run: Callable[..., Any], scenario: Callable[..., Path]) -> None:
    path = scenario(("0.05 kg*m^2", "0 kg*m^2"))
    done = run("simulate", path, "--output", path.parent / "out")
    assert done.status == 2
    assert done.line.startswith(f"varistiff: {path}: plant.link.inertia: ")
    assert names(path.parent) == ["push.yaml", "series_elastic.yaml"]


def test_the_output_is_tried_before_anything_is_computed(
    run: Callable[..., Any], scenario: Callable[..., Path], monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(Scenario, "simulate", lambda *_, **__: pytest.fail("computed"))
    path = scenario()
    for output, said in [(path / "out", "not a directory"), (path, "is a file"), (path.parent, "holds ")]:
        done = run("simulate", path, "--output", output)
        assert done.status == 2
        assert said in done.line
    assert names(path.parent) == ["push.yaml", "series_elastic.yaml"]


def test_validate_takes_scenarios_beside_designs(run: Callable[..., Any], scenario: Callable[..., Path]) -> None:
    path = scenario()
    design = path.parent / "series_elastic.yaml"
    done = run("validate", path, design)
    assert done.status == 0
    first, second = done.out.splitlines()
    assert first.startswith(f"{path}: ok: Push (scenario, series_elastic), hash ")
    assert second.startswith(f"{design}: ok: Series elastic joint (series_elastic), hash ")
    path.write_text(TEXT.replace("kind: pid", "kind: pdi"))
    done = run("validate", path, design)
    assert done.status == 2
    assert done.line.startswith(f"varistiff: {path}: control.drive.kind: unknown kind")
    assert done.out.count(": ok: ") == 1


def test_the_schema_of_scenarios_is_printed(run: Callable[..., Any]) -> None:
    assert json.loads(run("schema", "--scenario").out)["title"] == "varistiff scenario"
    assert json.loads(run("schema").out)["title"] == "varistiff design"
