"""The stepper against closed forms: its order, also through kinks and jumps."""

from __future__ import annotations

import math
from itertools import pairwise

import jax
import jax.numpy as jnp
import numpy as np
import pytest

from varistiff.dynamics.stepper import located_step, runge_kutta, signs_of


def _integrate(rates, switches, state, duration, steps):
    step = jnp.asarray(duration / steps)

    def advance(carry, index):
        state, signs, count = carry
        if switches is None:
            return (runge_kutta(rates, index * step, state, step), signs, count), jnp.nan
        state, signs, more, first = located_step(rates, switches, index * step, state, step, signs)
        return (state, signs, count + more), first

    start = tuple(jnp.asarray(float(x)) for x in state)
    signs = () if switches is None else signs_of(switches, jnp.asarray(0.0), start)
    run = jax.jit(lambda: jax.lax.scan(advance, (start, signs, jnp.asarray(0.0)), jnp.arange(steps, dtype=float)))
    (state, _, count), firsts = run()
    return np.array(state), float(count), np.asarray(firsts)


def _order(errors):
    return [math.log2(coarse / fine) for coarse, fine in pairwise(errors)]


def test_order_on_a_smooth_oscillator():
    def rates(_, state):
        return state[1], -4.0 * state[0]

    errors = []
    for steps in (40, 80, 160):
        state, _, _ = _integrate(rates, None, (1.0, 0.0), 3.0, steps)
        errors.append(np.abs(state - [math.cos(6.0), -2.0 * math.sin(6.0)]).max())
    assert min(_order(errors)) > 3.9  # fourth order, short of it by the next term


def _wall(t):
    """Position and rate of a unit mass that starts at 1 towards a spring of stiffness 100 that begins at 0."""
    reach = math.pi / 10.0
    if t <= 1.0:
        return 1.0 - t, -1.0
    if t <= 1.0 + reach:
        return -0.1 * math.sin(10.0 * (t - 1.0)), -math.cos(10.0 * (t - 1.0))
    return t - 1.0 - reach, 1.0


def _wall_rates(_, state):
    return state[1], 100.0 * jnp.maximum(-state[0], 0.0)


def _touch(_, state):
    return (state[0],)


def test_order_is_kept_through_a_contact():
    errors = []
    for steps in (33, 66, 132, 264):  # the contact begins and ends inside a step of each
        state, count, firsts = _integrate(_wall_rates, _touch, (1.0, -1.0), 2.0, steps)
        assert count == 2.0
        assert np.nanmin(firsts) == pytest.approx(1.0, abs=1e-9)  # 2^-36 of a step is below 1e-11
        errors.append(np.abs(state - _wall(2.0)).max())
    assert min(_order(errors)) > 3.7  # fourth order; 33 steps are few


def test_without_locating_the_order_is_lost():
    errors = []
    for steps in (33, 66, 132, 264):
        state, _, _ = _integrate(_wall_rates, None, (1.0, -1.0), 2.0, steps)
        errors.append(np.abs(state - _wall(2.0)).max())
    assert sum(_order(errors)) / 3.0 < 3.0  # what the locating is for


def test_a_jump_of_the_load_inside_a_step():
    def rates(time, state):
        return state[1], jnp.where(time >= 1.0 / 3.0, 2.0, 0.0)

    state, count, firsts = _integrate(rates, lambda time, _: (time - 1.0 / 3.0,), (0.0, 0.0), 1.0, 7)
    assert count == 1.0
    assert np.nanmin(firsts) == pytest.approx(1.0 / 3.0, abs=1e-11)
    # parabolas are exact for the method; what is left is the bracket of 2^-36 of a step
    np.testing.assert_allclose(state, [(2.0 / 3.0) ** 2, 4.0 / 3.0], atol=1e-10)


def test_several_switchings_in_one_step():
    def rates(time, state):
        inside = (time >= 0.2) & (time < 0.7)
        return (jnp.where(inside, 1.0, -1.0) + 0.0 * state[0],)

    state, count, _ = _integrate(rates, lambda t, _: (t - 0.2, 0.7 - t), (0.0,), 1.0, 1)
    assert count == 2.0
    assert state[0] == pytest.approx(0.0, abs=1e-9)


def test_gradient_through_a_located_step():
    def end(speed):
        step = jnp.asarray(0.02)

        start = (jnp.asarray(1.0), -speed)

        def advance(carry, index):
            state, signs = carry
            return located_step(_wall_rates, _touch, index * step, state, step, signs)[:2], None

        (state, _), _ = jax.lax.scan(advance, (start, signs_of(_touch, 0.0, start)), jnp.arange(100, dtype=float))
        return state[0]

    # after the rebound x = v (t - pi/10) - 1: its derivative at 2 s is 2 - pi/10
    gradient = jax.jit(jax.jacfwd(end))(jnp.asarray(1.1))
    assert float(gradient) == pytest.approx(2.0 - math.pi / 10.0, abs=1e-4)  # (10/s * 0.02 s)^4 over some ten steps
