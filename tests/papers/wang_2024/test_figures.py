"""Every figure that is a computation can be drawn."""

from __future__ import annotations

import pytest

from varistiff.papers.paper_figure import load_figures
from varistiff.report.papers import wang_2024
from varistiff.report.style import Drawing

DRAWN = [f"figure_{number}" for number in range(2, 10)]


def test_figures_2_to_9_are_ours() -> None:
    named = [figure.drawn_by for figure in load_figures("wang_2024") if figure.drawn_by in DRAWN]
    assert named == DRAWN


@pytest.mark.parametrize("name", DRAWN)
def test_figure_is_drawn_with_units_and_a_caption(name: str) -> None:
    drawing = getattr(wang_2024, name)()
    assert isinstance(drawing, Drawing)
    assert drawing.name == name
    assert len(drawing.caption) > 60
    axes = drawing.figure.axes[0]
    assert "[" in axes.get_xlabel()
    assert "[" in axes.get_ylabel()
    assert drawing.svg().startswith("<svg")
