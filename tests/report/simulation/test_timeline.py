"""What is drawn over time: no peak is lost, no label meets another, no unit is missing."""

from __future__ import annotations

import re
from collections.abc import Callable
from dataclasses import replace
from itertools import pairwise

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from matplotlib.figure import Figure

from varistiff.characteristic.map import characteristic_map
from varistiff.dynamics.audit import Audit
from varistiff.dynamics.outcome import Event, Outcome
from varistiff.report.simulation.balance import Balance
from varistiff.report.simulation.figures import (
    draw_all,
    drives,
    energy,
    map_path,
    residual,
    safe_area,
    stiffness,
    storage,
    temperature,
    tracking,
)
from varistiff.report.simulation.run import Run
from varistiff.report.simulation.safe_range import SafeRange
from varistiff.report.simulation.timeline import DIGIT, clusters, thinned

from .synthetic import Made

UNIT = re.compile(r"\[(s|ms|deg|mm|mJ|J|kJ|m?N|kN|[mk]?N·m|k?N·m/rad|k?N/mm|MPa|A|V|W|K)\]$")


def _texts(figure: Figure) -> list[str]:
    return [text.get_text() for text in figure.texts]


def _line(figure: Figure, axes: int, label: str) -> tuple[np.ndarray, np.ndarray]:
    (found,) = [line for line in figure.axes[axes].lines if line.get_label() == label]
    return np.asarray(found.get_xdata(), float), np.asarray(found.get_ydata(), float)


@given(
    st.lists(st.floats(-1e6, 1e6) | st.just(float("nan")), min_size=30, max_size=200),
    st.integers(4, 20),
)
def test_thinning_keeps_extremes_and_gaps(values: list[float], most: int) -> None:
    y = np.array(values)
    time = np.arange(y.size, dtype=float)
    x, kept = thinned(time, y, 2 * most)
    np.testing.assert_array_equal(kept, y[x.astype(int)])  # samples themselves, nothing in between
    assert (np.diff(x) > 0.0).all()
    assert (x[0], x[-1]) == (0.0, time[-1])
    if np.isfinite(y).any():
        assert np.nanmax(kept) == np.nanmax(y)
        assert np.nanmin(kept) == np.nanmin(y)
    inside = np.isnan(y[1:-1])
    if inside.any() and not inside.all():
        assert np.isnan(kept).any()  # a gap stays one


@given(st.lists(st.floats(0.0, 1.0), min_size=1, max_size=80))
def test_numbers_of_events_do_not_meet(places: list[float]) -> None:
    ordered = sorted(places)
    groups = clusters(ordered, DIGIT)
    assert [number for first, last, _ in groups for number in range(first, last + 1)] == list(range(1, len(places) + 1))
    for one, other in pairwise(groups):
        widths = [len(f"{first}" if first == last else f"{first}-{last}") for first, last, _ in (one, other)]
        assert other[2] - one[2] >= 0.5 * DIGIT * sum(widths)
        assert ordered[other[0] - 1] >= ordered[one[1] - 1]


def _drawings(made: Made) -> dict[str, Figure]:
    design = made.design
    setting = None if design.setting_range is None else np.linspace(*design.setting_range, 15)
    grid = characteristic_map(design.actuator, deflection=np.linspace(*design.deflection_range, 41), setting=setting)
    return {drawing.name: drawing.figure for drawing in draw_all(Run(made), grid)}


def test_every_kind_draws_with_units(run_of_kind: Made) -> None:
    figures = _drawings(run_of_kind)
    for name, figure in figures.items():
        labels = [text for axes in figure.axes for text in (axes.get_xlabel(), axes.get_ylabel()) if text]
        assert labels
        for label in labels:
            assert UNIT.search(label), (name, label)
        assert "No result" not in " ".join(_texts(figure))
    assert {"tracking", "stiffness", "safe_area", "energy", "residual"} <= set(figures)
    driven = run_of_kind.design.kind != "roller_beam"
    assert ("drive" in figures) == ("storage" in figures) == ("temperature" in figures) == driven
    assert ("map_path" in figures) == (run_of_kind.design.setting_unit is not None)


def test_lines_are_the_numbers_of_the_run(made: Callable[[str], Made]) -> None:
    run = made("series_elastic")
    drawing = tracking.draw(Run(run))
    assert drawing is not None
    data, figure = run.data, drawing.figure
    np.testing.assert_allclose(_line(figure, 0, "link")[1], np.degrees(data.link.values), rtol=1e-12)
    np.testing.assert_allclose(_line(figure, 0, "wanted")[1], np.degrees(data.wanted_position.values), rtol=1e-12)
    error = np.degrees(data.wanted_position.values - data.link.values)
    np.testing.assert_allclose(_line(figure, 1, "wanted minus\nlink")[1], error, rtol=1e-12)


def test_what_is_not_there_is_not_drawn(made: Callable[[str], Made]) -> None:
    run = made("series_elastic")
    still = np.zeros_like(run.data.time.values)
    names = [name for name in run.data if name.startswith(("drive", "storage", "wanted", "external"))]
    quiet = run.data.assign({name: ("time", still, run.data[name].attrs) for name in names})
    quiet["wanted_position"] = quiet.wanted_position * np.nan
    bare = Run(replace(run, data=quiet))
    for draw in (drives.draw_drive, drives.draw_setting, storage.draw, temperature.draw):
        assert draw(bare) is None
    assert stiffness.draw(bare) is None  # a spring has one stiffness
    drawing = tracking.draw(bare)
    assert drawing is not None
    assert len(drawing.figure.axes) == 1  # neither an error nor a load


def test_a_limit_is_drawn_where_it_is_near_and_told_where_it_is_far(made: Callable[[str], Made]) -> None:
    run = made("series_elastic")
    weak = run.data.drive_current / float(np.abs(run.data.drive_current).max())
    data = run.data.assign(drive_current=weak.assign_attrs(units="A", limits=(-7.5, 7.5)))
    drawing = drives.draw_drive(Run(replace(run, data=data)))
    assert drawing is not None
    torque, current = drawing.figure.axes[:2]
    top = run.data.drive_torque.attrs["limits"][1]
    heights = [float(line.get_ydata()[0]) for line in torque.lines if line.get_label() == "limit"]
    assert top in heights
    assert torque.get_ylim()[1] >= top
    told = [text.get_text() for text in current.get_legend().get_texts()]
    assert "limit ±7.5 A:\noff the axis" in told


def test_the_stack_of_losses_ends_at_their_sum(made: Callable[[str], Made]) -> None:
    run = made("maccepa")
    time = run.data.time.values
    terms = {**run.audit.terms, "copper_drive": 0.3 * time, "gear_drive": 0.1 * time**2}
    drawing = energy.draw(Run(replace(run, audit=replace(run.audit, terms=terms))))
    assert drawing is not None
    edge = max(drawing.figure.axes[-1].lines, key=lambda line: len(line.get_xdata()))
    total = terms["friction_link"] + 0.3 * time + 0.1 * time**2
    np.testing.assert_allclose(np.asarray(edge.get_ydata(), float), total, rtol=1e-12, atol=1e-15)
    names = [text.get_text() for text in drawing.figure.axes[-1].get_legend().get_texts()]
    ends = {name.replace("_", " "): float(terms[name][-1]) for name in ("copper_drive", "gear_drive", "friction_link")}
    assert names == sorted(ends, key=lambda name: ends[name])  # as they lie: the smallest on top


def test_the_residual_stands_against_its_allowance(made: Callable[[str], Made]) -> None:
    run = made("series_elastic")
    size = 1e-4 * np.linspace(-1.0, 2.0, run.data.time.size) ** 3
    whole = replace(run.audit, residual=size, turnover=np.linspace(0.0, 4.0, size.size), allowance=1e-3)
    drawing = residual.draw(Run(replace(run, audit=whole)))
    assert drawing is not None
    axes = drawing.figure.axes[0]
    assert axes.get_yscale() == "log"
    (allowed,) = [line for line in axes.lines if line.get_label() == "allowed"]
    assert float(allowed.get_ydata()[0]) == pytest.approx(4e-3, rel=1e-12)  # 1e-3 of 4 J
    assert np.max(_line(drawing.figure, 0, "magnitude")[1]) == pytest.approx(8e-4, rel=1e-12)
    assert "closes: its residual reaches 8e−4 J, 2e−4 of the 4 J turned over; allowed is 0.001." in drawing.caption


@pytest.mark.parametrize(("worst", "closes"), [(0.99e-6, True), (1.01e-6, False), (np.nan, False)])
def test_the_balance_says_whether_it_closes(made: Callable[[str], Made], worst: float, closes: bool) -> None:
    run = made("series_elastic")
    audit = Audit(run.audit.terms, np.array([0.0, worst]), np.array([0.0, 1.0]), 1e-6)
    balance = Balance.of(Run(replace(run, audit=audit)))
    assert balance.closes is closes
    assert ("does NOT close" in balance.sentence) is not closes


def test_the_safe_area_ends_where_the_tube_yields(made: Callable[[str], Made]) -> None:
    """At a short active length the tube yields at strength * W/k: closed form, k in series with the drive train."""
    design = made("torsion_tube").design
    tube, length = design.actuator, 0.015
    grid = np.linspace(*design.deflection_range, 301)
    found = SafeRange.of(characteristic_map(tube, deflection=grid, setting=np.array([length, 0.1])))
    k = 1.0 / (length / (tube.shear_modulus * tube.torsion_constant) + 1.0 / tube.series_stiffness)
    limit = 48e6 / np.sqrt(3.0) * tube.torsion_modulus / k
    (low, high), (least, most) = found.at(np.full(3, length), 3)
    step = grid[1] - grid[0]
    assert limit - step <= high[0] <= limit  # the last point of the grid before it
    assert low[0] == pytest.approx(-high[0], rel=1e-12)
    assert (least[0], most[0]) == pytest.approx((-k * high[0], k * high[0]), rel=1e-9)
    outside, _ = found.at(np.array([0.2]), 1)
    assert np.isnan(outside[0][0])  # beyond the map nothing is called safe


def test_no_contact_around_rest_is_safe(made: Callable[[str], Made]) -> None:
    design = made("roller_beam").design
    grid = characteristic_map(design.actuator, deflection=np.linspace(-0.17, 0.17, 341), setting=np.array([0.5]))
    assert (grid.status.values == 3).any()  # the clearance
    (_, high), _ = SafeRange.of(grid).at(np.array([0.5]), 1)
    assert high[0] == pytest.approx(0.17)


def test_a_run_that_is_no_result_says_so_on_every_picture(made: Callable[[str], Made]) -> None:
    failed = replace(made("slider_leaf_joint"), outcome=Outcome.LEFT_MAP, failed_at=0.734)
    figures = _drawings(failed)
    assert len(figures) >= 8
    for figure in figures.values():
        assert "No result: left map at 0.734 s" in _texts(figure)
    heights = [line.get_xdata()[0] for line in figures["tracking"].axes[0].lines]
    assert 0.734 in heights  # and where


def test_what_comes_after_a_run_went_astray_does_not_squeeze_the_rest(made: Callable[[str], Made]) -> None:
    run = made("series_elastic")
    wild = run.data.copy(deep=True)
    wild["link"][-40:] = 1e12
    failed = Run(replace(run, data=wild, outcome=Outcome.UNSTABLE, failed_at=float(wild.time[-41])))
    drawing = tracking.draw(failed)
    assert drawing is not None
    top = drawing.figure.axes[0].get_ylim()[1]
    before = np.degrees(np.abs(run.data.wanted_position.values).max())
    assert before < top < 30.0 * before


def test_statuses_that_are_not_safe_are_hatched(made: Callable[[str], Made]) -> None:
    run = made("slider_leaf_joint")
    design = run.design
    grid = characteristic_map(
        design.actuator, deflection=np.linspace(-0.035, 0.035, 41), setting=np.array([0.015, 0.025])
    )
    codes = run.data.status.copy(data=np.where(run.data.time < 1.0, 0, 5).astype(np.int8))
    drawing = safe_area.draw(Run(replace(run, data=run.data.assign(status=codes))), grid)
    assert drawing is not None
    told = [text.get_text() for text in drawing.figure.axes[0].get_legend().get_texts()]
    assert "yielded" in told
    assert "safe" in told


def test_a_setting_that_stays_has_no_path(made: Callable[[str], Made]) -> None:
    run = made("torsion_tube")
    still = run.data.assign(setting=run.data.setting * 0.0 + 0.05)
    grid = run.design.map(deflection_points=11, setting_points=5)
    assert map_path.draw(Run(replace(run, data=still)), grid) is None
    assert map_path.draw(Run(run), grid) is not None


def test_many_events_are_ticks_and_few_are_lines(made: Callable[[str], Made]) -> None:
    run = made("series_elastic")
    many = tuple(Event(0.01 * number, "stick", "It sticks.") for number in range(100))
    for events in (many, many[:5], ()):
        drawing = tracking.draw(Run(replace(run, events=events)))
        assert drawing is not None
        marks = drawing.figure.axes[0].collections
        assert len(marks) == bool(events)
        if events:
            starts = {float(segment[0][1]) for segment in marks[0].get_segments()}
            assert starts == ({0.94} if len(events) > 40 else {0.0})
