"""A state with a given motion and everything else as at the start."""

from __future__ import annotations

from collections.abc import Iterable

import jax.numpy as jnp
import numpy as np
from jaxtyping import Array, Float

from varistiff.dynamics.drives import Temperatures
from varistiff.dynamics.equations import Outside
from varistiff.dynamics.ledger import Ledger
from varistiff.dynamics.plant import Plant
from varistiff.dynamics.program import Case
from varistiff.dynamics.signals import Sample
from varistiff.dynamics.state import Motion, State

Scalar = Float[Array, ""]


def state_at(plant: Plant, motion: Motion) -> State:
    """State with cold motors, the storage's first charge and an empty energy account."""
    zero = jnp.asarray(0.0)
    cold = Temperatures(zero, zero)
    return State(motion, jnp.asarray(plant.storage.charge0, dtype=float), cold, cold, Ledger({}, {}, zero))


def pushed(torque: Scalar) -> Outside:
    """An external torque against +q, and no prescribed motion."""
    zero = jnp.asarray(0.0)
    return Outside(torque, Sample(zero, zero, zero))


def motion_of(values: Iterable[float | Scalar]) -> Motion:
    """Motion of six numbers: position and rate of link, drive and setting drive."""
    return Motion(*(jnp.asarray(float(value)) for value in values))


def standing(link: float, drive: float, motion: float) -> Motion:
    """Motion at rest."""
    return motion_of((link, 0.0, drive, 0.0, motion, 0.0))


def numbers_of(motion: Motion) -> np.ndarray:
    """The six numbers of a motion."""
    return np.array([float(value) for value in motion])


def start_of(case: Case) -> Motion:
    """Motion at the start; of a prescribed link that of its signal."""
    start = motion_of(case.motion)
    if case.plant.link.mode != "prescribed":
        return start
    link = case.inputs.link_sample(jnp.asarray(0.0))
    return start._replace(link=jnp.asarray(link.value), link_rate=jnp.asarray(link.rate))


def first_load(case: Case) -> float:
    """External torque at the start [N m or N]."""
    return float(case.inputs.load.at(jnp.asarray(0.0)).value)
