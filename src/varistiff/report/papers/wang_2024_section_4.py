"""Figures 16 to 18 of Wang et al. (2024) as our simulations give them: steps, the lever, and the sines."""

from __future__ import annotations

import math
from collections.abc import Sequence
from typing import Any

import numpy as np
from matplotlib.axes import Axes
from matplotlib.figure import Figure

from varistiff.papers.wang_2024.section_4 import position_set
from varistiff.papers.wang_2024.section_4_cases import (
    AMPLITUDE,
    CENTRE,
    LENGTH_MAX,
    LENGTH_MIN,
    STEP_TIME,
    SWING,
)
from varistiff.papers.wang_2024.section_4_facts import position_runs, setting_run
from varistiff.papers.wang_2024.section_4_measures import (
    SETTING_SAMPLES,
    STEP_SAMPLES,
    instants,
    length_course,
    stiffness_course,
    wave,
)
from varistiff.report.style import BLUE, INK, SOFT, VERMILION, WIDTH, Drawing, styled

LEFT, RIGHT = 0.115, 0.70  # of the width
FREE: dict[str, Any] = {"color": BLUE}
LOADED: dict[str, Any] = {"color": VERMILION, "linestyle": (0, (6, 1.6))}
WANTED: dict[str, Any] = {"color": INK, "linewidth": 1.2}


def figure_16() -> Drawing:
    """Steps of the output position at 200 N m/rad, small and large, without and with load."""
    own, run = position_set("steps"), position_runs()["steps"]
    facts, time = run.facts, instants(STEP_SAMPLES)
    rows = (
        (
            "small",
            own.small,
            run.courses[:2, 0],
            facts.small_overshoot_by_load,
            facts.small_settling_by_load,
            "5",
            0.25,
        ),
        (
            "large",
            own.large,
            run.courses[2:4, 0],
            facts.large_overshoot_by_load,
            facts.large_settling_by_load,
            "15",
            0.16,
        ),
    )
    with styled():
        figure, panels = _panels(2, 6.2, "Step of the output position")
        for axes, (name, stroke, links, over, settling, over_printed, settling_printed) in zip(
            panels, rows, strict=True
        ):
            axes.plot(time, np.degrees(np.where(time < STEP_TIME, 0.0, stroke)), label="wanted", **WANTED)
            axes.plot(time, np.degrees(links[0, : time.size]), label="no load", **FREE)
            axes.plot(time, np.degrees(links[1, : time.size]), label="load", **LOADED)
            axes.set_ylabel(f"Output, {name} [deg]")
            _beside(
                axes,
                f"The load adds, here (printed):\n\novershoot {100 * over:+.1f} %  ({over_printed})\n"
                f"settling {settling:+.2f} s  ({settling_printed})",
            )
        _finish(panels, float(time[-1]))
    caption = (
        f"Steps of {math.degrees(own.small):.0f} and {math.degrees(own.large):.0f} degrees at 200 N m/rad with the set "
        "`steps`, whose gains, inertias and load were fitted to the printed changes; the paper prints no strokes."
    )
    return Drawing("figure_16", "Step of the output position", figure, caption)


def figure_17() -> Drawing:
    """Step of the lever's position, from 25 to 6 mm, without and with load."""
    run, time = setting_run(), instants(SETTING_SAMPLES)
    facts = run.facts
    with styled():
        figure, (axes,) = _panels(1, 4.3, "Step of the lever position")
        axes.plot(time, 1e3 * np.where(time < STEP_TIME, LENGTH_MAX, LENGTH_MIN), label="wanted", **WANTED)
        axes.plot(time, 1e3 * length_course(run.steps[0, 0]), label="no load", **FREE)
        axes.plot(time, 1e3 * length_course(run.steps[1, 0]), label="load", **LOADED)
        axes.set_ylabel("Active length [mm]")
        _beside(
            axes,
            f"Settling time:\n{facts.regulation_time:.2f} s without load,\n"
            f"{facts.regulation_time_loaded:.2f} s with load\n"
            "(printed: 0.34 s, with load\nalmost the same)\n\n"
            f"Overshoot:\n{100 * facts.lever_overshoot:.1f} and {100 * facts.lever_overshoot_loaded:.1f} %\n"
            "(printed: slightly more\nwith load)",
        )
        _finish((axes,), 1.2)
    caption = (
        "The slider on its way from 25 to 6 mm while the output makes its large step. The gains of the stiffness drive "
        "were fitted to the printed 0.34 s and to the errors of Fig. 18c."
    )
    return Drawing("figure_17", "Step of the lever position", figure, caption)


def figure_18() -> Drawing:
    """Sines of position and stiffness, without and with load: positions, errors, stiffness."""
    run, stiff = position_runs()["sine"], setting_run()
    facts, links = run.facts, np.degrees(run.courses[4:, 0])
    time = instants(links.shape[1])
    wanted = math.degrees(AMPLITUDE) * wave(time.size)
    courses = [stiffness_course(*course) for course in stiff.sines]
    short = instants(courses[0].size)
    reference = CENTRE + SWING * wave(short.size)
    with styled():
        figure, panels = _panels(4, 9.6, "Sines of 1 Hz: position and stiffness")
        position, error, stiffness, off = panels
        position.plot(time, wanted, label="wanted", **WANTED)
        stiffness.plot(short, reference, label="wanted", **WANTED)
        for number, (label, look) in enumerate((("no load", FREE), ("load", LOADED))):
            position.plot(time, links[number], label=label, **look)
            error.plot(time, wanted - links[number], label=label, **look)
            stiffness.plot(short, courses[number], label=label, **look)
            off.plot(short, reference - courses[number], label=label, **look)
        names = ("Output [deg]", "Error [deg]", "Stiffness\n[N m/rad]", "Error\n[N m/rad]")
        for axes, label in zip(panels, names, strict=True):
            axes.set_ylabel(label)
        degrees = [math.degrees(value) for value in facts[-4:]]
        _beside(position)
        _beside(
            error,
            "Largest, here (printed):\nfirst, no load {:.1f}° (11°)\nfirst, load {:.1f}° (13°)\n"
            "later, no load {:.1f}° (6°)\nlater, load {:.1f}° (4°)".format(*degrees),
        )
        _beside(stiffness)
        _beside(
            off,
            "Largest, here (printed):\n"
            f"no load {stiff.facts.stiffness_error:.1f} (10)\nload {stiff.facts.stiffness_error_loaded:.1f} (16)",
        )
        _finish(panels[:2], float(time[-1]), label="")
        _finish(panels[2:], float(short[-1]))
    caption = (
        "Position with the set `sine` at 200 N m/rad; stiffness with the set `stiffness`, about a mean of "
        f"{CENTRE:.0f} N m/rad, which the paper does not print. The later errors are printed in an order that "
        "contradicts the sentence after them; the fit takes 4 degrees without and 6 with load."
    )
    return Drawing("figure_18", "Tracking of sines", figure, caption)


def _panels(count: int, height: float, title: str) -> tuple[Figure, list[Axes]]:
    figure = Figure(figsize=(WIDTH + 1.0, height))
    foot, head, gap = 0.62 / height, 0.45 / height, 0.34 / height
    each = (1.0 - foot - head - gap * (count - 1)) / count
    figure.text(LEFT, 1.0 - 0.10 / height, title, fontsize=12.5, fontweight="bold", va="top")
    bottoms = [foot + (count - 1 - row) * (each + gap) for row in range(count)]
    return figure, [figure.add_axes((LEFT, bottom, RIGHT - LEFT, each)) for bottom in bottoms]


def _beside(axes: Axes, words: str = "") -> None:
    """Key, and below it what is printed, to the right of the axes."""
    axes.legend(loc="upper left", bbox_to_anchor=(1.03, 1.0))
    axes.text(1.03, 0.0, words, transform=axes.transAxes, va="bottom", fontsize=10.0, color=SOFT)


def _finish(panels: Sequence[Axes], end: float, label: str = "Time [s]") -> None:
    for axes in panels:
        axes.set_xlim(0.0, end)
        axes.tick_params(labelbottom=axes is panels[-1])
    panels[-1].set_xlabel(label)
