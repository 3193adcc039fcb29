"""Gradient of a cost of a run with respect to every number that the run is computed from."""

from __future__ import annotations

from collections.abc import Callable
from functools import cache
from typing import Any

import equinox as eqx
import jax
import numpy as np
from jaxtyping import Array, Float

from varistiff.core.errors import InputError
from varistiff.dynamics.program import Case, Course, run, samples_of
from varistiff.dynamics.switching import switch_names

Scalar = Float[Array, ""]
Cost = Callable[[Course], Scalar]


def run_gradient(case: Case, cost: Cost, *, duration: float, substeps: int = 1) -> tuple[float, Case]:
    """Value of a cost, and its derivative with respect to each float of the case, backwards through the whole run.

    Parameters
    ----------
    case : what is run
    cost : a differentiable function of the course; compiled once per function, so pass the same one again
    duration : [s], a whole number of periods
    substeps : Runge-Kutta steps per period

    Returns
    -------
    The cost, and a Case that holds in place of each number the derivative with respect to it: the one to a gain is
    ``gradient.loop.drive.controller.pid.proportional``.

    Raises
    ------
    InputError : the plant has switchings, whose search cannot be differentiated backwards

    Notes
    -----
    Encoders count as ideal: their derivative is taken as 1. Where a limit is active the derivative is the limit's.
    """
    names = switch_names(case.plant, case.inputs, duration)
    if names:
        raise InputError(
            f"has switchings ({', '.join(names)}); allowed is a plant without stops, backlash and lost contact",
            field="plant",
        )
    arrays = jax.tree.map(lambda leaf: np.asarray(leaf) if isinstance(leaf, float) else leaf, case)
    numbers, static = eqx.partition(arrays, eqx.is_array)
    value, gradient = _gradient(static, cost, samples_of(case.period, duration), substeps)(numbers)
    return float(value), eqx.combine(gradient, static)


@cache
def _gradient(static: Case, cost: Cost, samples: int, substeps: int) -> Callable[[Case], Any]:
    def value(numbers: Case) -> Scalar:
        return cost(run(eqx.combine(numbers, static), samples, substeps, ()))

    return jax.jit(jax.value_and_grad(value))
