"""The mechanism of each kind in motion, to scale and with its elastic element deformed."""

from __future__ import annotations

import math
from dataclasses import replace
from importlib import import_module
from typing import Any

from varistiff.actuators.actuator import Actuator
from varistiff.report.mechanism import KINDS
from varistiff.report.simulation.mechanism.frames import Frames
from varistiff.report.simulation.mechanism.scene import Scene
from varistiff.report.style import INK


def build_scene(actuator: Actuator, frames: Frames) -> Scene | None:
    """Build the moving mechanism; None for a kind that has no drawing yet.

    Each kind has its module here, named as the kind, with ``build(actuator, frames)``.
    """
    if actuator.kind not in KINDS:
        return None
    module: Any = import_module(f"{__name__}.{actuator.kind}")
    scene: Scene = module.build(actuator, frames)
    if actuator.deflection_unit != "rad":
        return scene  # the marks are arms
    key = list(scene.key)
    if frames.wanted is not None:
        key.append(("wanted", INK, "dash"))
    if any(map(math.isfinite, frames.stops)):
        key.append(("stop", INK, "patch"))
    return replace(scene, key=tuple(key))
