"""One step of the classical Runge-Kutta method that stops at every switching instant."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any, NamedTuple, TypeVar

import jax
import jax.numpy as jnp
from jaxtyping import Array, Bool, Float, Int

Scalar = Float[Array, ""]
Tree = TypeVar("Tree")
Rates = Callable[[Scalar, Tree], Tree]
Switches = Callable[[Scalar, Tree], tuple[Scalar, ...]]
Signs = tuple[Bool[Array, ""], ...]

_MOST = 6  # switchings located in one step; more are stepped over
_HALVINGS = 36  # bracket of a switching: h/2^36, the error of stepping over it is of that order


def runge_kutta(rates: Rates[Tree], time: Scalar, state: Tree, step: Scalar) -> Tree:
    """Classical fourth-order step.

    Notes
    -----
    Hairer, Norsett and Wanner (1993), Solving Ordinary Differential Equations I, II.1, doi 10.1007/978-3-540-78862-1.
    """
    # one copy of the equations for the four stages compiles in a third of the time of four
    ahead, weight = jnp.array([0.5, 0.5, 1.0, 0.0]), jnp.array([1.0, 2.0, 2.0, 1.0]) / 6.0
    late = jnp.array([0.0, 0.5, 0.5, 1.0])

    def stage(index: int, carry: tuple[Tree, Tree]) -> tuple[Tree, Tree]:
        at, end = carry
        slope = rates(time + late[index] * step, at)
        return _along(state, slope, ahead[index] * step), _along(end, slope, weight[index] * step)

    end: Tree = jax.lax.fori_loop(0, 4, stage, (state, state))[1]
    return end


def _along(state: Tree, slope: Tree, step: Scalar) -> Tree:
    return jax.tree.map(lambda y, k: y + step * k, state, slope)


def signs_of(switches: Switches[Tree], time: Scalar, state: Tree) -> Signs:
    """Whether each switching function is at or above zero."""
    return tuple(value >= 0.0 for value in switches(time, state))


class _Search(NamedTuple):
    """Progress through a step: done up to ``now``; ``low`` and ``high`` bracket the next switching from there."""

    now: Scalar
    state: Any
    signs: Signs
    phase: Int[Array, ""]
    low: Scalar
    high: Scalar
    located: Scalar
    first: Scalar


_WHOLE, _HALVE, _UP_TO, _ACROSS = range(4)


def located_step(
    rates: Rates[Tree], switches: Switches[Tree], time: Scalar, state: Tree, step: Scalar, signs: Signs
) -> tuple[Tree, Signs, Scalar, Scalar]:
    """Step over ``step``, split at each instant where a switching function changes sign.

    The method keeps its order because no segment but one of width step/2^36 spans a kink or a jump: the bracket of a
    sign change is halved until it is that narrow, one segment ends at its lower end and a short one leads across. A
    function that changes sign twice within a step is not seen, and of more than six switchings the rest are stepped
    over. Differentiable in forward mode.

    Parameters
    ----------
    rates : time derivative of the state
    switches : functions whose sign tells the branch of the equations
    time, state, step : where the step starts [s], and its length [s]
    signs : of the switching functions at the start, from ``signs_of`` or the step before

    Returns
    -------
    state and signs after the step, number of switchings located, instant of the first [s] or NaN
    """
    end = time + step

    def attempt(search: _Search) -> _Search:
        # one copy of the equations serves every phase: it is most of what there is to compile
        rest, middle = end - search.now, 0.5 * (search.low + search.high)
        widths = (rest, middle, search.low, search.high - search.low)
        width = widths[-1]
        for phase in (_UP_TO, _HALVE, _WHOLE):
            width = jnp.where(search.phase == phase, widths[phase], width)
        at = runge_kutta(rates, search.now, search.state, width)
        return _decide(search, at, signs_of(switches, search.now + width, at), width, end, step)

    zero = 0.0 * step
    start = _Search(time, state, signs, jnp.asarray(_WHOLE), zero, zero, zero, jnp.nan + zero)
    ended = jax.lax.while_loop(lambda search: search.now < end, attempt, start)
    return ended.state, ended.signs, ended.located, ended.first


def _decide(search: _Search, at: Any, signs: Signs, width: Scalar, end: Scalar, step: Scalar) -> _Search:
    """What an attempt of this width means for the search, and what to try next."""
    crossed = jnp.asarray(False)
    for before, after in zip(search.signs, signs, strict=True):
        crossed = crossed | (before != after)
    crossed = crossed & (search.located < _MOST)
    whole, halve, across = (search.phase == phase for phase in (_WHOLE, _HALVE, _ACROSS))
    done = whole & ~crossed
    accepted = done | across | (search.phase == _UP_TO)
    low = jnp.where(halve & ~crossed, width, jnp.where(whole, 0.0, search.low))
    high = jnp.where((halve | whole) & crossed, width, search.high)
    narrow = high - low <= step * 2.0**-_HALVINGS
    now = jnp.where(done, end, jnp.where(accepted, search.now + width, search.now))
    phase = jnp.where(whole, _HALVE, jnp.where(halve, jnp.where(narrow, _UP_TO, _HALVE), jnp.where(across, 0, _ACROSS)))
    return _Search(
        now=now,
        state=jax.tree.map(lambda new, old: jnp.where(accepted, new, old), at, search.state),
        signs=tuple(jnp.where(done | across, new, old) for new, old in zip(signs, search.signs, strict=True)),
        phase=phase,
        low=low,
        high=high,
        located=search.located + jnp.where(across, 1.0, 0.0),
        first=jnp.where(across & jnp.isnan(search.first), now, search.first),
    )
