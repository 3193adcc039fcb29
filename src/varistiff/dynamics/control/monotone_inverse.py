"""Inverse of a monotone function of one number, with a fixed amount of work."""

from __future__ import annotations

from collections.abc import Callable
from typing import NamedTuple

import jax
import jax.numpy as jnp

from varistiff.dynamics.control.controller import Number, Scalar, as_scalar

Function = Callable[[Scalar], Scalar]


def monotone_inverse(
    function: Function,
    target: Number,
    low: Number,
    high: Number,
    *,
    rising: bool,
    bisections: int = 4,
    newton_steps: int = 5,
) -> Scalar:
    """Argument x in [low, high] with function(x) = target; the nearer end where the target lies beyond it.

    Bisections narrow the bracket to (high - low)/2^n, Newton steps that must stay in it finish. A NaN of the function
    counts as a value above every target. Derivatives with respect to the target, and to whatever the function closes
    over, are those of the implicit function; at an end they are 0.

    Parameters
    ----------
    function : differentiable, strictly monotone on [low, high]
    target : wanted value
    low, high : ends of the bracket
    rising : whether the function rises
    bisections, newton_steps : how often each is done; the defaults leave only rounding for powers from
        -3.5 to 3.5 over a range of one to fifteen

    >>> round(float(monotone_inverse(lambda x: x**-3.0, 8.0, 0.25, 1.0, rising=False)), 14)
    0.5
    """
    goal, low, high = as_scalar(target), as_scalar(low), as_scalar(high)
    frozen_goal, start, end = (jax.lax.stop_gradient(number) for number in (goal, low, high))

    # derivatives are made at the end, none passes through the loop; the function is compiled in it only once
    def improve(index: int, state: _Bracket) -> _Bracket:
        x, bottom, top, _ = state
        value, slope = jax.lax.stop_gradient(jax.jvp(function, (x,), (jnp.ones_like(x),)))
        root_below = ~(value <= frozen_goal) if rising else value <= frozen_goal
        bottom = jnp.where(root_below, bottom, jnp.maximum(bottom, x))
        top = jnp.where(root_below, jnp.minimum(top, x), top)
        better = _step(x, value - frozen_goal, slope, (bottom, top), (start, end))
        return _Bracket(jnp.where(index < bisections, 0.5 * (bottom + top), better), bottom, top, slope)

    first = _Bracket(0.5 * (start + end), start, end, jnp.zeros_like(start))
    x, bottom, top, slope = jax.lax.fori_loop(0, bisections + newton_steps, improve, first)
    value = function(x)
    # beyond an end, or beside a hole, the root is not in the bracket: no step and no derivative
    room = top - bottom + 1e-9 * (end - start)
    usable = jnp.isfinite(value) & (slope != 0.0) & (jnp.abs(value - frozen_goal) <= room * jnp.abs(slope))
    # a Newton step with a frozen slope has the derivatives of the implicit function
    step = jnp.where(usable, value - goal, 0.0) / jax.lax.stop_gradient(jnp.where(usable, slope, 1.0))
    return jnp.clip(x - step, low, high)


class _Bracket(NamedTuple):
    """Best argument, the bracket around the root, and the slope where it was last asked for."""

    x: Scalar
    bottom: Scalar
    top: Scalar
    slope: Scalar


def _step(
    x: Scalar, error: Scalar, slope: Scalar, bracket: tuple[Scalar, Scalar], ends: tuple[Scalar, Scalar]
) -> Scalar:
    """Newton's step; where it leaves the bracket, to the middle, or to an end of the range that nothing excludes.

    Leaving it by its own width is allowed, or by rounding: the root may lie at an end, and Newton comes back.
    """
    bottom, top = bracket
    middle = 0.5 * (bottom + top)
    wished = x - error / jnp.where(slope == 0.0, jnp.nan, slope)
    slack = top - bottom + 1e-9 * (ends[1] - ends[0])
    x = jnp.where((wished >= bottom - slack) & (wished <= top + slack), wished, middle)
    x = jnp.where((wished < bottom) & (bottom == ends[0]), bottom, x)
    return jnp.clip(jnp.where((wished > top) & (top == ends[1]), top, x), ends[0], ends[1])
