"""Gradients through a whole run against central differences."""

from __future__ import annotations

import equinox as eqx
import jax.numpy as jnp
import numpy as np
import pytest

from varistiff.core.errors import InputError
from varistiff.dynamics.program import run_one
from varistiff.dynamics.run_gradient import run_gradient

from . import cases

GAINS = ("proportional", "integral", "derivative")


def _cost(course):
    wanted = 0.1 * jnp.sin(2.0 * jnp.pi * course.time)
    return jnp.mean((course.state.motion.link - wanted) ** 2) + 1e-6 * jnp.mean(course.command.drive**2)


@pytest.mark.parametrize("exact", [False, True])
def test_gradient_with_respect_to_gains(exact):
    case = cases.leaf_joint(exact=exact)
    value, gradient = run_gradient(case, _cost, duration=0.3)
    assert value == pytest.approx(float(_cost(run_one(case, duration=0.3, substeps=1))), rel=1e-10)  # rounding
    for name in GAINS:

        def gain(case, name=name):
            return getattr(case.loop.drive.controller.pid, name)

        middle = gain(case)
        step = 1e-4 * middle
        ends = [
            float(_cost(run_one(eqx.tree_at(gain, case, middle + side), duration=0.3, substeps=1)))
            for side in (-step, step)
        ]
        difference = (ends[1] - ends[0]) / (2.0 * step)
        # a central difference errs by step^2 relative and by rounding of the cost over the step
        np.testing.assert_allclose(float(gain(gradient)), difference, rtol=1e-6)


def test_a_plant_with_switchings_is_refused():
    with pytest.raises(InputError, match=r"switchings.*backlash_lower"):
        run_gradient(cases.wall(), _cost, duration=0.1)
