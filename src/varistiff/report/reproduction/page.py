"""The board as one HTML page."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from datetime import UTC, datetime
from typing import Any

from varistiff.core.citations import citation
from varistiff.papers.equation import load_equations
from varistiff.papers.finding import Finding
from varistiff.papers.paper_figure import PaperFigure
from varistiff.papers.verdict import Verdict
from varistiff.report.html import Picture, embedded, filled
from varistiff.report.reproduction.table import HEADER, line, of_paper, summary


def page(
    findings: Sequence[Finding], pictures: Mapping[str, Sequence[tuple[PaperFigure, Picture]]], versions: str
) -> str:
    """Return the HTML of the board.

    Parameters
    ----------
    findings : of every paper on the page
    pictures : by paper, its figures and ours
    versions : what it was computed with
    """
    papers = list(dict.fromkeys(finding.paper for finding in findings))
    context = {
        "header": HEADER,
        "summary": summary(findings),
        "meanings": [(verdict.value.replace("_", " "), verdict.meaning) for verdict in Verdict],
        "papers": [_paper(key, of_paper(findings, key), pictures.get(key, ())) for key in papers],
        "versions": versions,
        "created": datetime.now(UTC).isoformat(timespec="seconds"),
    }
    return filled("scoreboard.html.j2", context)


def _paper(key: str, findings: Sequence[Finding], pictures: Sequence[tuple[PaperFigure, Picture]]) -> dict[str, Any]:
    source = citation(key)
    return {
        "key": key,
        "source": str(source),
        "title": source.title,
        "summary": summary(findings),
        "rows": [
            {"cells": line(each).cells, "reason": line(each).reason, "verdict": each.verdict.value} for each in findings
        ],
        "equations": [
            {
                "number": equation.number,
                "what": equation.what,
                "names": [name.replace(":", ".") for name in equation.implemented_by],
                "correction": equation.correction,
            }
            for equation in load_equations(key)
        ],
        "figures": [
            {"number": figure.number, "shows": f"{figure.shows.rstrip('.')}.", "picture": embedded(picture)}
            for figure, picture in pictures
        ],
    }
