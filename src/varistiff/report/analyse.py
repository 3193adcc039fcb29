"""The main job: a design to a directory with its map, datasheet, figures and report."""

from __future__ import annotations

import json
import os
import sys
from dataclasses import dataclass
from datetime import UTC, datetime
from pathlib import Path
from typing import TYPE_CHECKING

from varistiff.core.status import Status
from varistiff.core.writing import staged_directory
from varistiff.report.replaceable import FIGURES, check_replaceable

if TYPE_CHECKING:
    import xarray as xr

    from varistiff.characteristic.datasheet import Datasheet
    from varistiff.design.design import Design
    from varistiff.report.html import Picture
    from varistiff.report.style import Drawing

MARKERS = ("map.nc", "datasheet.json", "report.html")  # a directory with all of them is a result of ours
FILES = (*MARKERS, "datasheet.csv")


@dataclass(frozen=True)
class Analysis:
    """What ``analyse`` wrote and what it found.

    ``summary`` is for a terminal: the actuator in one line, then every status other than ok with its count and
    remedy, then the design's warnings.
    """

    output: Path
    dataset: xr.Dataset
    datasheet: Datasheet
    summary: tuple[str, ...]


def analyse(design: Design, output: str | os.PathLike[str], *, progress: bool = False) -> Analysis:
    """Compute the map of a design and write everything about it to a directory.

    Parameters
    ----------
    design : as ``load`` returns it
    output : directory; made if it does not exist, replaced if it is empty or an earlier result, refused otherwise
    progress : tell on the standard error stream what is being done

    Written: map.nc (netCDF), datasheet.json, datasheet.csv, figures/*.svg and *.png, report.html. They appear
    together or not at all, also when the run is interrupted; nothing is left beside them.

    Raises
    ------
    InputError : the directory holds something else, or cannot be written
    """
    from varistiff.characteristic.datasheet import datasheet

    _check_replaceable(output)
    tell = _teller(progress)
    tell("map")
    dataset = design.map(progress=progress)
    dataset.attrs.setdefault("created", datetime.now(UTC).isoformat(timespec="seconds"))
    sheet = datasheet(dataset)
    with staged_directory(output) as folder:
        pictures = _write_figures(design, dataset, folder / FIGURES, tell)
        tell("report")
        _write_report(design, dataset, sheet, pictures, folder)
        tell("data")
        _write_data(dataset, sheet, folder)
        _check_replaceable(output)  # again: somebody may have put a file there meanwhile
    return Analysis(output=Path(output), dataset=dataset, datasheet=sheet, summary=_summary(design, sheet))


def _write_figures(design: Design, dataset: xr.Dataset, folder: Path, tell: _Tell) -> list[Picture]:
    from varistiff.report.figures import draw_all
    from varistiff.report.files import saved
    from varistiff.report.mechanism import draw_mechanism

    folder.mkdir()
    pictures = []
    first, last = draw_mechanism(design.actuator, dataset), _section_stress(design, dataset)
    for drawing in (drawing for drawing in (first, *draw_all(dataset), last) if drawing is not None):
        tell(f"figure {drawing.name}")
        pictures.append(saved(drawing, folder))
    return pictures


def _section_stress(design: Design, dataset: xr.Dataset) -> Drawing | None:
    if design.kind != "torsion_tube":
        return None
    from varistiff.report.figures import section_stress  # SciPy, which the other kinds do without

    return section_stress.draw(design.actuator, dataset)


def _write_report(design: Design, dataset: xr.Dataset, sheet: Datasheet, pictures: list[Picture], folder: Path) -> None:
    from varistiff.report.html import render_report

    text = render_report(dataset, sheet, pictures, warnings=design.warnings, path=design.path)
    (folder / "report.html").write_text(text, encoding="utf-8")


def _write_data(dataset: xr.Dataset, sheet: Datasheet, folder: Path) -> None:
    from varistiff.report.files import write_netcdf

    write_netcdf(dataset, folder / "map.nc")
    text = json.dumps(sheet.as_dict(), indent=2, ensure_ascii=False, allow_nan=False)
    (folder / "datasheet.json").write_text(text + "\n", encoding="utf-8")
    (folder / "datasheet.csv").write_text(sheet.as_csv(), encoding="utf-8")


def _summary(design: Design, sheet: Datasheet) -> tuple[str, ...]:
    from varistiff.report.html import one_line

    lines = [f"{sheet.name} ({sheet.kind}): {one_line(sheet)}"]
    for entry in sheet.statuses:
        if entry.status is not Status.OK:
            share = f"{entry.count} points ({100.0 * entry.fraction:.3g} %)"
            lines.append(f"{entry.status.label}: {share}. {entry.meaning} {entry.status.remedy}")
    lines += [f"warning: {warning}" for warning in design.warnings]
    return tuple(lines)


def _check_replaceable(output: str | os.PathLike[str]) -> None:
    check_replaceable(output, markers=MARKERS, files=FILES)


class _Tell:
    """Says on the standard error stream what is being done; on a terminal each line replaces the last."""

    def __call__(self, what: str) -> None:
        """Say it."""


class _TellAloud(_Tell):
    def __call__(self, what: str) -> None:
        """Say it."""
        sys.stderr.write(f"varistiff: {what}\n")
        sys.stderr.flush()


def _teller(progress: bool) -> _Tell:
    return _TellAloud() if progress else _Tell()
