"""The same sampled loop, integrated between samples by an adaptive method of order 8 to a tight tolerance."""

from __future__ import annotations

from typing import Any

import diffrax
import jax
import jax.numpy as jnp

from varistiff.dynamics.equations import Outside, rates
from varistiff.dynamics.program import Case
from varistiff.dynamics.state import Motion


def reference_motion(case: Case, start: Any, *, duration: float, tolerance: float = 1e-11) -> Motion:
    """Motion at the sample instants; ``start`` is the state from which the run begins."""
    period, inputs = case.period, case.inputs

    def slope(time, state, command):
        outside = Outside(inputs.load.at(time).value, inputs.link_sample(time))
        return rates(case.plant, state, command, outside)

    def sample(carry, index):
        state, memory = carry
        time = index * period
        command, memory = case.loop.sample(memory, state.motion, inputs.wanted(time), index, period)
        solved = diffrax.diffeqsolve(
            diffrax.ODETerm(slope),
            diffrax.Dopri8(),
            time,
            time + period,
            period / 4.0,
            state,
            args=command,
            stepsize_controller=diffrax.PIDController(rtol=tolerance, atol=tolerance),
            saveat=diffrax.SaveAt(t1=True),
            max_steps=10_000,
        )
        after = jax.tree.map(lambda values: values[0], solved.ys)
        return (after, memory), state.motion

    memory = case.loop.start(start.motion, inputs.wanted(jnp.asarray(0.0)))
    samples = jnp.arange(round(duration / period) + 1, dtype=float)
    return jax.jit(lambda: jax.lax.scan(sample, (start, memory), samples)[1])()
