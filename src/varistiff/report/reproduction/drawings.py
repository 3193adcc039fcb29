"""Our figures of what a paper computed."""

from __future__ import annotations

from collections.abc import Iterator
from importlib import import_module

from varistiff.papers.paper_figure import PaperFigure, load_figures
from varistiff.report.style import Drawing


def draw_all(paper: str) -> Iterator[tuple[PaperFigure, Drawing]]:
    """Draw ours of every figure of a paper that is a computation.

    Raises
    ------
    InputError : no such paper
    """
    for figure in load_figures(paper):
        if figure.drawn_by is not None:
            module, _, function = figure.drawn_by.rpartition(".")
            drawing = getattr(import_module(f"varistiff.report.papers.{module or paper}"), function)()
            yield figure, drawing
