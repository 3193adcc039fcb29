"""The time loop: samples of control, steps of the plant, one row of numbers per sample."""

from __future__ import annotations

import os
from collections.abc import Callable
from concurrent.futures import ThreadPoolExecutor
from functools import cache
from typing import Any, NamedTuple

import equinox as eqx
import jax
import jax.numpy as jnp
import numpy as np
from jaxtyping import Array, Float

from varistiff.dynamics.control_loop import ControlLoop, Inputs
from varistiff.dynamics.drives import Temperatures
from varistiff.dynamics.equations import Flows, Outside, flows, losses_of, rates
from varistiff.dynamics.ledger import INFLOWS, Ledger, Stores
from varistiff.dynamics.packing import Layout, Numbers, pack
from varistiff.dynamics.plant import Plant
from varistiff.dynamics.state import Command, Motion, State
from varistiff.dynamics.stepper import located_step, runge_kutta, signs_of
from varistiff.dynamics.switching import switch_names, switch_values

Scalar = Float[Array, ""]
_ABREAST = 16  # runs of a batch that go side by side: they fill the processor's vectors, and its cache holds them


class Case(eqx.Module):
    """Everything that a run is computed from.

    Parameters
    ----------
    plant, loop, inputs : the joint, its control and its signals
    motion : positions and rates at the start
    period : of control, and of the rows that are kept [s]
    """

    plant: Plant
    loop: ControlLoop
    inputs: Inputs
    motion: Motion
    period: float


class Course(NamedTuple):
    """What the time loop keeps at each sample instant, after control has spoken."""

    time: Scalar
    state: State
    command: Command
    switchings: Scalar  # located in the period that ends here
    first_switching: Scalar  # instant of the first of them, NaN for none


class Row(NamedTuple):
    """A course with everything that follows from it at each instant."""

    time: Scalar
    state: State
    command: Command
    flows: Flows
    stores: Stores
    setting: Scalar
    deflection: Scalar
    wanted_position: Scalar
    wanted_stiffness: Scalar
    switchings: Scalar
    first_switching: Scalar


def start_state(case: Case) -> State:
    """State at the start: cold motors, the storage at its first charge, an empty account."""
    plant, motion, zero = case.plant, jax.tree.map(jnp.asarray, case.motion), jnp.asarray(0.0)
    if plant.link.mode == "prescribed":
        link = case.inputs.link_sample(zero)
        motion = motion._replace(link=link.value, link_rate=link.rate)
    cold = Temperatures(zero, zero)
    ledger = Ledger(dict.fromkeys(losses_of(plant), zero), dict.fromkeys(INFLOWS, zero), zero)
    return State(motion, jnp.asarray(plant.storage.charge0), cold, cold, ledger)


def _outside(inputs: Inputs, time: Scalar) -> Outside:
    return Outside(inputs.load.at(time).value, inputs.link_sample(time))


def observe(case: Case, course: Course) -> Row:
    """Forces, powers, energies and wanted values at one instant of a course."""
    time, state, command, switchings, first = course
    plant, wanted = case.plant, case.inputs.wanted(time)
    return Row(
        time=time,
        state=state,
        command=command,
        flows=flows(plant, state, command, _outside(case.inputs, time)),
        stores=plant.stores(state.motion, state.charge),
        setting=plant.setting_path.at(state.motion.motion).value,
        deflection=plant.deflection(state.motion),
        wanted_position=jnp.asarray(wanted.position),
        wanted_stiffness=jnp.asarray(wanted.stiffness),
        switchings=switchings,
        first_switching=first,
    )


def run(case: Case, samples: int, substeps: int | Scalar, names: tuple[str, ...]) -> Course:
    """Course at ``samples`` instants from 0, a ``case.period`` apart; NaN from where the state is no longer finite.

    Parameters
    ----------
    substeps : Runge-Kutta steps per period; a traced number serves any, but only an int can be differentiated backwards
    names : switchings to locate, of ``switch_names``
    """
    plant, inputs, period = case.plant, case.inputs, jnp.asarray(case.period)
    step = period / substeps

    def values(now: Scalar, at: State) -> tuple[Scalar, ...]:
        return switch_values(names, plant, now, at)

    def advance(time: Scalar, state: State, command: Command, signs: Any) -> Any:
        def slope(now: Scalar, at: State) -> State:
            return rates(plant, at, command, _outside(inputs, now))

        def part(index: Any, carry: Any) -> Any:
            here, side, count, first = carry
            now = time + index * step
            if not names:
                return runge_kutta(slope, now, here, step), side, count, first
            here, side, more, instant = located_step(slope, values, now, here, step, side)
            return here, side, count + more, jnp.where(jnp.isnan(first), instant, first)

        carry = state, signs, jnp.asarray(0.0), jnp.asarray(jnp.nan)
        if isinstance(substeps, int) and substeps == 1:
            return part(0, carry)
        return jax.lax.fori_loop(0, substeps, part, carry)

    def sample(carry: Any, index: Scalar) -> tuple[Any, Course]:
        state, memory, signs, *switched = carry
        time = index * period
        command, memory = case.loop.sample(memory, state.motion, inputs.wanted(time), index, period)
        kept = Course(time, state, command, *switched)
        state, signs, *switched = advance(time, state, command, signs)
        return (state, memory, signs, *switched), kept

    start = start_state(case)
    memory = case.loop.start(start.motion, inputs.wanted(jnp.asarray(0.0)))
    signs = signs_of(values, jnp.asarray(0.0), start)
    carry = start, memory, signs, jnp.asarray(0.0), jnp.asarray(jnp.nan)
    _, course = jax.lax.scan(sample, carry, jnp.arange(samples, dtype=float))
    return course


@cache
def _compiled(
    layout: Layout[Case], samples: int, substeps: int | None, names: tuple[str, ...], many: bool
) -> Callable[[Numbers, Any], Course]:
    """Compiled run; one compilation serves every number of substeps but 1, which is faster by itself."""

    def one(numbers: Numbers, parts: Any) -> Course:
        return run(layout.tree(numbers), samples, parts if substeps is None else substeps, names)

    def each(numbers: Numbers, parts: Any) -> Course:
        if names:  # runs that search for instants would wait for each other
            return jax.lax.map(lambda own: one(own, parts), numbers)
        return jax.vmap(one, in_axes=(0, None))(numbers, parts)

    return jax.jit(each if many else one)


@cache
def _observed(layout: Layout[Case]) -> Callable[[Numbers, Course], Row]:
    return jax.jit(lambda numbers, course: jax.vmap(lambda one: observe(layout.tree(numbers), one))(course))


def rows_of(case: Case, course: Course) -> Row:
    """Everything that follows from a course of shape (samples,), at all its instants at once."""
    numbers, layout = pack(case)
    return _observed(layout)(numbers, course)


def run_one(case: Case, *, duration: float, substeps: int) -> Course:
    """Compiled run; arrays of shape (samples,) with an instant at both ends of ``duration``."""
    numbers, layout = pack(case)
    names = switch_names(case.plant, case.inputs, duration)
    fixed = 1 if substeps == 1 else None
    return _compiled(layout, samples_of(case.period, duration), fixed, names, False)(numbers, np.asarray(substeps))


def run_many(cases: list[Case], *, duration: float, substeps: int) -> Course:
    """The same for cases that differ in numbers only, on every core; arrays of shape (case, samples).

    Raises
    ------
    ValueError : the cases differ in more than numbers
    """
    layout = pack(cases[0])[1]
    names = switch_names(cases[0].plant, cases[0].inputs, duration)
    if any(switch_names(case.plant, case.inputs, duration) != names for case in cases):
        raise ValueError("the cases of a batch may differ in numbers only, not in switchings")
    fixed = 1 if substeps == 1 else None
    compiled = _compiled(layout, samples_of(cases[0].period, duration), fixed, names, True)

    def course(start: int) -> Course:
        own = [layout.numbers(case) for case in cases[start : start + _ABREAST]]
        own += own[-1:] * (_ABREAST - len(own))  # groups of one size share one compilation
        numbers = jax.tree.map(lambda *leaves: np.stack(leaves), *own)
        return jax.tree.map(np.asarray, compiled(numbers, np.asarray(substeps)))

    starts = range(0, len(cases), _ABREAST)
    whole: list[np.ndarray] = []
    with ThreadPoolExecutor(_cores()) as pool:  # XLA and NumPy let go of the interpreter while they work
        for start, found in zip(starts, pool.map(course, starts), strict=True):
            leaves, structure = jax.tree.flatten(found)
            whole = whole or [np.empty((len(cases), *leaf.shape[1:]), leaf.dtype) for leaf in leaves]
            for kept, leaf in zip(whole, leaves, strict=True):
                kept[start : start + _ABREAST] = leaf[: len(cases) - start]
    return jax.tree.unflatten(structure, whole)


def _cores() -> int:
    """Cores that this process may use."""
    return len(os.sched_getaffinity(0)) if hasattr(os, "sched_getaffinity") else os.cpu_count() or 1


def samples_of(period: float, duration: float) -> int:
    """Number of sample instants, both ends included."""
    return round(duration / period) + 1
