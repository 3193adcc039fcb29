"""From a setting back to the setting drive's own coordinate."""

from __future__ import annotations

import jax.numpy as jnp

from varistiff.dynamics.control.controller import Number, Scalar
from varistiff.dynamics.path import Affine, GroovePath, Path


def motion_of_setting(path: Path, setting: Number) -> Scalar:
    """Coordinate z [rad or m] of the setting drive at which s(z) is the setting [m or rad], in closed form.

    Raises
    ------
    TypeError : a path that has no closed inverse here

    >>> round(float(motion_of_setting(Affine(start=0.1, ratio=0.02), 0.14)), 12)
    2.0
    """
    if isinstance(path, Affine):
        return (jnp.asarray(setting) - path.start) / path.ratio
    if isinstance(path, GroovePath):
        return path.groove.angle(jnp.asarray(setting) - path.start)
    raise TypeError(f"no inverse is known of a {type(path).__name__}")
