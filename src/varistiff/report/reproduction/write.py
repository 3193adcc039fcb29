"""The board as files, together or not at all."""

from __future__ import annotations

import os
from collections.abc import Callable, Sequence
from dataclasses import replace

from varistiff.characteristic.provenance import package_versions
from varistiff.core.writing import staged_directory
from varistiff.papers.finding import Finding
from varistiff.papers.registry import PAPERS, paper_file
from varistiff.report.files import saved
from varistiff.report.replaceable import FIGURES, check_replaceable
from varistiff.report.reproduction.drawings import draw_all
from varistiff.report.reproduction.page import page
from varistiff.report.reproduction.records import as_csv, as_json

MARKERS = ("scoreboard.csv", "scoreboard.html", "scoreboard.json")
READINGS = tuple(f"{paper}.yaml" for paper in PAPERS)


def write_board(
    findings: Sequence[Finding], output: str | os.PathLike[str], *, tell: Callable[[str], None] = lambda text: None
) -> None:
    """Write the board as HTML, CSV and JSON, our figures, and each paper's corrected reading as a design file.

    Parameters
    ----------
    findings : of every paper that is wanted
    output : directory; made, or replaced if it holds an earlier board
    tell : is told what is going on

    Raises
    ------
    InputError : the directory cannot be written, or holds something else
    """
    check_output(output)
    papers = list(dict.fromkeys(finding.paper for finding in findings))
    with staged_directory(output) as folder:
        pictures = {}
        for paper in papers:
            tell(f"{paper}: figures")
            pictures[paper] = [
                (figure, saved(replace(drawing, name=f"{paper}_{drawing.name}"), folder / FIGURES))
                for figure, drawing in draw_all(paper)
            ]
            reading = paper_file(paper, "corrected_reading.yaml").read_text(encoding="utf-8")
            (folder / f"{paper}.yaml").write_text(reading, encoding="utf-8")
        versions = ", ".join(package_versions(("jax", "numpy", "scipy")))
        (folder / "scoreboard.html").write_text(page(findings, pictures, versions), encoding="utf-8")
        (folder / "scoreboard.csv").write_text(as_csv(findings), encoding="utf-8")
        (folder / "scoreboard.json").write_text(as_json(findings), encoding="utf-8")


def check_output(output: str | os.PathLike[str]) -> None:
    """Refuse a directory with anything in it that an earlier board did not write."""
    check_replaceable(output, markers=MARKERS, files=(*MARKERS, *READINGS))
