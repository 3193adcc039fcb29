"""The player of the page: what it shows, how fast, and its data."""

from __future__ import annotations

import math
from typing import Any

import numpy as np
from markupsafe import Markup

from varistiff.report.simulation.mechanism.encode import Readout, encode
from varistiff.report.simulation.mechanism.frames import Frames
from varistiff.report.simulation.mechanism.scene import Scene
from varistiff.report.simulation.run import Run

SPEEDS = (0.01, 0.02, 0.05, 0.1, 0.2, 0.5, 1.0, 2.0, 5.0, 10.0)
PLEASANT = 6.0  # seconds that the whole run should play for
READ = (
    ("link", "Link"),
    ("wanted_position", "Wanted"),
    ("drive", "Drive"),
    ("deflection", "Deflection"),
    ("setting", ""),
    ("load", ""),
    ("stiffness", "Stiffness"),
)


def motion(run: Run, scene: Scene, frames: Frames) -> dict[str, Any]:
    """What the template needs to show a scene in motion."""
    readouts = list(_readouts(run, frames))
    drawn = frames.time[0], frames.time[-1]
    events = [(event.time, event.name) for event in run.events if drawn[0] <= event.time <= drawn[1]]
    return {
        "caption": scene.caption + _about_frames(run, frames),
        "readouts": readouts,
        "key": [{"name": name, "colour": colour, "look": look} for name, colour, look in scene.key],
        "speeds": _speeds(float(frames.time[-1] - frames.time[0])),
        "data": Markup(encode(scene, frames, readouts=readouts, events=events)),  # it is escaped there
    }


def _readouts(run: Run, frames: Frames) -> list[Readout]:
    found = []
    for name, label in READ:
        values = run.given(name)
        if values is None or (name == "drive" and run.telling(name) is None):
            continue
        label = label or (run.setting_name if name == "setting" else run.load_name)
        shown = run.shown(run.unit(name), [values])
        found.append(Readout(label, shown.unit, np.asarray(values[frames.index] * shown.factor)))
    return found


def _about_frames(run: Run, frames: Frames) -> str:
    text = f" Between the {frames.count} states that are drawn the picture is interpolated."
    return text if frames.count < run.time.size else ""


def _speeds(duration: float) -> list[dict[str, Any]]:
    """Speeds to choose from; in real time unless that is over in a blink or takes long."""
    natural = 1.0
    if not 2.0 <= duration <= 15.0:
        natural = min(SPEEDS, key=lambda speed: abs(math.log(max(duration, 1e-9) / speed / PLEASANT)))
    return [
        {"value": f"{speed:g}", "text": f"{speed:g} \N{MULTIPLICATION SIGN}", "chosen": speed == natural}
        for speed in SPEEDS
    ]
