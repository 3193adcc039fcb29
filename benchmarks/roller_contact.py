"""Roller contact: speed and error of the kernel beside what a user would write instead."""

from __future__ import annotations

import time
from typing import Any

import jax
import jax.numpy as jnp
import mpmath as mp
import numpy as np

from benchmarks import contenders, reference_mpmath
from benchmarks.sample import DISTRIBUTION, RIGIDITY, Problems, edges, problems
from benchmarks.timing import in_turn
from varistiff.core import precision
from varistiff.elastic.link_contact import link_contact

OUTPUTS = ("slope", "force", "length", "moment", "thrust", "energy", "stiffness")


def seven(deflection: Any, setting: Any, clamp_offset: Any, roller_offset: Any, radius: Any) -> tuple[Any, ...]:
    """The kernel's seven outputs."""
    solved = link_contact(
        deflection,
        setting,
        offset=roller_offset,
        joint=(-clamp_offset, jnp.zeros_like(clamp_offset)),
        radius=radius,
        flexural_rigidity=jnp.asarray(RIGIDITY),
    )
    state = solved.contact
    load = (solved.moment, solved.thrust, state.energy, solved.stiffness)
    return state.slope, state.force, state.arc_length, *load


def arguments(sample: Problems) -> tuple[jax.Array, ...]:
    """The sample as arrays on the default device."""
    return tuple(jnp.asarray(getattr(sample, name)) for name in sample.__dataclass_fields__)


def errors(sample: Problems) -> np.ndarray:
    """Largest error of each output against 40 digits, relative to slope, F, L, F x_r, F, V, F x_r^2."""
    values = np.array([np.asarray(v) for v in jax.jit(seven)(*arguments(sample))])
    worst = np.zeros(7)
    for index in range(len(sample.setting)):
        x_r = float(sample.setting[index])
        truth = reference_mpmath.joint(
            x_r,
            float(sample.deflection[index]),
            flexural_rigidity=RIGIDITY,
            radius=float(sample.radius[index]),
            roller_offset=float(sample.roller_offset[index]),
            clamp_offset_along=float(sample.clamp_offset[index]),
        )
        exact = (truth.slope, truth.force, truth.length, truth.moment, truth.thrust, truth.energy, truth.stiffness)
        f = truth.force
        scale = (truth.slope, f, truth.length, f * x_r, f, truth.energy, f * x_r**2)
        found = [float(abs(mp.mpf(float(v)) - e) / s) for v, e, s in zip(values[:, index], exact, scale, strict=True)]
        worst = np.maximum(worst, found)
    return worst


def operations(sample: Problems) -> int:
    """Arithmetic operations per element that the kernel traces to, without the loop for the rare hard points."""
    counted = {"add", "sub", "mul", "div", "sqrt", "rsqrt", "max", "min", "select_n", "abs", "gt", "lt", "ge", "neg"}

    def count(jaxpr: Any) -> int:
        total = 0
        for equation in jaxpr.eqns:
            name = equation.primitive.name
            if name == "cond":
                continue
            inner = [v for v in equation.params.values() if hasattr(v, "jaxpr") or hasattr(v, "eqns")]
            total += sum(count(getattr(v, "jaxpr", v)) for v in inner) if inner else name in counted
        return total

    return count(jax.make_jaxpr(seven)(*arguments(sample)).jaxpr)


def floor(number: int) -> float:
    """Nanoseconds for ``number`` operations at the rate of a plain multiply-add loop that stays in the cache."""
    x = jnp.linspace(0.0, 1.0, 4096)

    def chains(v: jax.Array) -> jax.Array:
        values = [v + k for k in range(8)]
        for _ in range(64):
            values = [w * v + 0.5 for w in values]
        return sum(values[1:], values[0])

    loop = jax.jit(chains).lower(x).compile()
    spent = in_turn([lambda: jax.block_until_ready(loop(x))], rounds=300).seconds[0]
    return number * spent / (8 * 64 * 2 * x.size) * 1e9


def table(count: int = 100_000) -> list[str]:
    """Rows of the Markdown table."""
    precision.enable()
    sample = problems(count)
    inputs = arguments(sample)
    kernel = jax.jit(seven).lower(*inputs).compile()
    timing = in_turn([lambda: np.sin(sample.deflection), lambda: jax.block_until_ready(kernel(*inputs))])
    sine, ours = timing.seconds / count * 1e9
    number = operations(sample)
    least = floor(number)
    worst, hard = errors(sample.take(300)), errors(edges())
    x, y = sample.take(20_000).centre
    radius = sample.radius
    start = time.process_time()
    newton = contenders.carlson_newton(x, y, radius[:20_000])
    newton_each = (time.process_time() - start) / 20_000 * 1e9
    slope = np.asarray(kernel(*inputs)[0])
    newton_good = np.mean(np.abs(newton - slope[:20_000]) < 1e-8)
    rows = [
        f"Distribution: {DISTRIBUTION}.",
        "",
        "| method | time per solve | of `numpy.sin` | solved |",
        "|---|---|---|---|",
        f"| `numpy.sin`, one element | {sine:.1f} ns | 1 | |",
        f"| **varistiff, seven outputs** | **{ours:.0f} ns** | **{timing.ratio[1]:.1f}** | 100 % |",
        f"| floor: {number} operations at the measured multiply-add rate | {least:.0f} ns | {least / sine:.1f} | |",
        f"| Newton on SciPy's Carlson integrals, slope only | {newton_each:.0f} ns | {newton_each / sine:.0f} "
        f"| {100 * newton_good:.0f} % |",
    ]
    slow = (("quad and fsolve, the paper's algorithm, slope only", contenders.quad_and_fsolve, 200),
            ("`solve_bvp` with unknown length, slope only", contenders.boundary_value, 60))  # fmt: skip
    for name, solver, number in slow:
        start = time.process_time()
        found = np.array([solver(x[i], y[i], radius[i]) for i in range(number)])
        each = (time.process_time() - start) / number
        good = np.mean(np.abs(found - slope[:number]) < 1e-5)
        rows.append(f"| {name} | {each * 1e3:.2f} ms | {each * 1e9 / sine:.0f} | {100 * good:.0f} % |")
    rows += ["", "Largest error against 40 digits, relative as stated above:", ""]
    rows += ["| problems | " + " | ".join(OUTPUTS) + " |", "|---" * 8 + "|"]
    for name, found in (
        ("300 of the distribution", worst),
        ("60 at 1e-5 ... 1e-3 rad from first contact or fold", hard),
    ):
        rows.append(f"| {name} | " + " | ".join(f"{value:.0e}" for value in found) + " |")
    return rows
