"""The mechanism of each kind, to scale, with its elastic element deformed at several loads."""

from __future__ import annotations

from importlib import import_module
from typing import Any

import xarray as xr

from varistiff.actuators.actuator import Actuator
from varistiff.report.style import Drawing

KINDS = (
    "antagonistic_leaves",
    "maccepa",
    "roller_beam",
    "series_elastic",
    "slider_leaf_joint",
    "torsion_tube",
)


def draw_mechanism(actuator: Actuator, dataset: xr.Dataset) -> Drawing | None:
    """Draw the mechanism at settings and loads that the map calls ok; None for a kind that has no drawing yet.

    Each kind has its module here, named as the kind, with ``draw(actuator, dataset)``.
    """
    if actuator.kind not in KINDS:
        return None
    module: Any = import_module(f"varistiff.report.mechanism.{actuator.kind}")
    drawing: Drawing = module.draw(actuator, dataset)
    return drawing
