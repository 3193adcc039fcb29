"""A run as files: data, figures and one HTML page."""

from __future__ import annotations

import json
import os
from collections.abc import Callable
from datetime import UTC, datetime
from pathlib import Path
from typing import Any

import xarray as xr

from varistiff.core.writing import staged_directory
from varistiff.report.files import saved, write_netcdf
from varistiff.report.html import Picture
from varistiff.report.replaceable import FIGURES, check_replaceable
from varistiff.report.simulation.contract import SimulationLike
from varistiff.report.simulation.data_csv import as_csv
from varistiff.report.simulation.figures import draw_all
from varistiff.report.simulation.mechanism import build_scene
from varistiff.report.simulation.mechanism.frames import Frames
from varistiff.report.simulation.mechanism.strip import draw_strip
from varistiff.report.simulation.motion import motion
from varistiff.report.simulation.page import render_page
from varistiff.report.simulation.run import Run
from varistiff.report.simulation.summary import as_dict

MARKERS = ("data.nc", "data.csv", "simulation.json", "report.html")
ACROSS, ALONG = 121, 61  # deflections and settings of the map, for the safe area in the pictures

Tell = Callable[[str], None]


def write_simulation(
    simulation: SimulationLike, output: str | os.PathLike[str], *, tell: Tell = lambda text: None
) -> None:
    """Write data.nc, data.csv, simulation.json, figures/ and report.html; together or not at all.

    A run that is no result is written too: every picture, the page and the data say so.

    Parameters
    ----------
    simulation : a finished run
    output : directory; made if it does not exist, replaced if it is empty or an earlier result, refused otherwise
    tell : told what is being done, a line each

    Raises
    ------
    InputError : the directory holds something else, or cannot be written
    """
    check_output(output)
    run = Run(simulation)
    simulation.data.attrs.setdefault("created", datetime.now(UTC).isoformat(timespec="seconds"))
    with staged_directory(output) as folder:
        pictures, moving = _pictures(run, folder / FIGURES, tell)
        tell("report")
        (folder / "report.html").write_text(render_page(run, pictures, moving), encoding="utf-8")
        tell("data")
        write_netcdf(_marked(run), folder / "data.nc")
        (folder / "data.csv").write_text(as_csv(simulation.data), encoding="utf-8")
        text = json.dumps(as_dict(run), indent=2, ensure_ascii=False, allow_nan=False)
        (folder / "simulation.json").write_text(text + "\n", encoding="utf-8")
        check_output(output)  # again: somebody may have put a file there meanwhile


def check_output(output: str | os.PathLike[str]) -> None:
    """Refuse a directory with anything in it that an earlier simulation did not write."""
    check_replaceable(output, markers=MARKERS, files=MARKERS)


def _pictures(run: Run, folder: Path, tell: Tell) -> tuple[list[Picture], dict[str, Any] | None]:
    folder.mkdir()
    pictures, moving = [], None
    frames = Frames.of(run)
    scene = None if frames is None else build_scene(run.simulation.design.actuator, frames)
    if frames is not None and scene is not None:
        tell("mechanism")
        moving = motion(run, scene, frames)
        pictures.append(saved(draw_strip(run, scene, frames), folder))
    tell("map")
    for drawing in draw_all(run, run.simulation.design.map(deflection_points=ACROSS, setting_points=ALONG)):
        tell(f"figure {drawing.name}")
        pictures.append(saved(drawing, folder))
    return pictures, moving


def _marked(run: Run) -> xr.Dataset:
    """The data with the outcome, so that a file on its own cannot pass for a result."""
    outcome = run.simulation.outcome
    failed = {} if run.done else {"failed_at": run.stopped_at, "outcome_text": f"{outcome.meaning} {outcome.remedy}"}
    return run.simulation.data.assign_attrs(outcome=outcome.value, **failed)
