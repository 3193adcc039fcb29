"""A controlled run of the slider leaf joint, beside what a user would write with SciPy."""

from __future__ import annotations

import math
import time
from collections.abc import Callable
from pathlib import Path

import equinox as eqx
import jax
import numpy as np
from scipy.integrate import odeint

import varistiff
from benchmarks.timing import in_turn
from varistiff.actuators import LargeDeflection, SliderLeafJoint
from varistiff.dynamics.control.groove_chain import wang_chain
from varistiff.dynamics.control.pid import Pid
from varistiff.dynamics.control.position_pid import PositionPid
from varistiff.dynamics.control.stiffness_pid import StiffnessPid
from varistiff.dynamics.control_loop import Channel, ControlLoop, Inputs
from varistiff.dynamics.drives import TorqueSource
from varistiff.dynamics.friction import Friction
from varistiff.dynamics.path import GroovePath
from varistiff.dynamics.plant import Member, Plant
from varistiff.dynamics.program import Case, rows_of, run_many, run_one
from varistiff.dynamics.run_gradient import run_gradient
from varistiff.dynamics.signals import Sine
from varistiff.dynamics.state import Motion

DESIGN = Path(__file__).parents[1] / "examples/slider_leaf_joint.yaml"
DURATION, PERIOD, BATCH = 3.0, 1e-3, 256
LINK, DRIVE, DISC = (0.05, 0.5), (0.1, 2.0), (0.002, 0.05)  # inertia and viscous friction
POSITION = {"proportional": 20.0, "integral": 10.0, "derivative": 1.0, "filter_time": 0.005}
STIFFNESS = {"proportional": 2.0, "integral": 5.0, "derivative": 0.05, "filter_time": 0.005}


def wang_case(*, exact: bool = False, gain: float = 1.0) -> Case:
    """Position and stiffness of the joint tracked at 1 kHz, 1 Hz sines, Eq. (17) with ideal torques."""
    joint = varistiff.load(DESIGN).actuator
    assert isinstance(joint, SliderLeafJoint)
    assert joint.groove is not None
    if exact:
        joint = eqx.tree_at(lambda own: own.theory, joint, LargeDeflection())
    start = float(joint.groove.angle(np.asarray(0.020)))
    plant = Plant(
        joint,
        link=Member(LINK[0], Friction(LINK[1])),
        drive=Member(DRIVE[0], Friction(DRIVE[1])),
        setting=Member(DISC[0], Friction(DISC[1])),
        setting_path=GroovePath(joint.groove),
        drive_motor=TorqueSource(limit=20.0),
        setting_motor=TorqueSource(limit=5.0),
    )
    loop = ControlLoop(
        drive=Channel(PositionPid(Pid(**{**POSITION, "proportional": 20.0 * gain}, limit=20.0), "drive")),
        setting=Channel(
            StiffnessPid(Pid(**STIFFNESS, limit=5.0), wang_chain(joint, setting_min=0.015, setting_max=0.025))
        ),
    )
    inputs = Inputs(position=Sine(0.0, 0.2, 1.0), stiffness=Sine(330.0, 80.0, 1.0))
    return Case(plant, loop, inputs, Motion(0.0, 0.0, 0.0, 0.0, start, 0.0), PERIOD)


def scipy_run(case: Case) -> np.ndarray:
    """The same loop as a user would write it: Eq. (17) in Python, LSODA between the samples; link positions."""
    joint, groove = case.plant.actuator, case.plant.actuator.groove
    rigidity, clamp = joint.count * joint.leaf.flexural_rigidity, joint.clamp_radius
    x, y = (float(value) for value in groove.centre_position)
    sign = math.copysign(
        1.0, float(groove.active_length(np.asarray(0.3))) + clamp - (x * math.sin(0.3) + y * math.cos(0.3))
    )
    fourth = x * x + y * y - groove.arc_radius**2
    line = case.loop.setting.controller.chain.line
    used = case.loop.setting.controller.chain.used

    def length(angle: float) -> tuple[float, float]:
        third, rate = x * math.sin(angle) + y * math.cos(angle), x * math.cos(angle) - y * math.sin(angle)
        root = sign * math.sqrt(third * third - fourth)
        return third + root - clamp, rate * (1.0 + third / root)

    def slope(state: np.ndarray, _: float, torque: float, turn: float) -> list[float]:
        q, w, q1, w1, z, wz = state
        active, gain = length(z)
        arm, phi = clamp + active, q1 - q
        scale = 3.0 * rigidity / active**3
        load = scale * arm * arm * math.sin(phi)
        adjusting = -scale * (1.0 - math.cos(phi)) * arm * (active + 3.0 * clamp) / active
        return [
            w,
            (load - LINK[1] * w) / LINK[0],
            w1,
            (torque - load - DRIVE[1] * w1) / DRIVE[0],
            wz,
            (turn - adjusting * gain - DISC[1] * wz) / DISC[0],
        ]

    def law(gains: dict[str, float], limit: float) -> Callable[[float, float], float]:
        memory = {"integral": 0.0, "last": None, "rate": 0.0}

        def sample(wanted: float, measured: float) -> float:
            last = measured if memory["last"] is None else memory["last"]
            memory["rate"] = (gains["filter_time"] * memory["rate"] + measured - last) / (gains["filter_time"] + PERIOD)
            memory["last"] = measured
            error = wanted - measured
            raw = gains["proportional"] * error + memory["integral"] - gains["derivative"] * memory["rate"]
            memory["integral"] += PERIOD * gains["integral"] * error
            return min(max(raw, -limit), limit)

        return sample

    position, turning = law(POSITION, 20.0), law(STIFFNESS, 5.0)
    from varistiff.dynamics.control.active_length import active_length_from_stiffness

    samples = round(DURATION / PERIOD) + 1
    times = PERIOD * np.arange(samples)
    wanted = 330.0 + 80.0 * np.sin(2.0 * np.pi * times)
    lengths = np.asarray(active_length_from_stiffness(wanted, bending=3.0 * rigidity, clamp_radius=clamp))
    angles = np.clip((lengths - line.intercept) / line.slope, float(used.angle_min), float(used.angle_max))
    state, links = np.array([*map(float, case.motion)]), np.empty(samples)
    for k, now in enumerate(times):
        links[k] = state[0]
        torque = position(0.2 * math.sin(2.0 * math.pi * now), state[2])
        turn = turning(angles[k], state[4])
        state = odeint(slope, state, [0.0, PERIOD], args=(torque, turn), rtol=1e-8, atol=1e-10)[-1]
    return links


def _position_cost(course: object) -> object:
    return jax.numpy.mean((course.state.motion.link - 0.2 * jax.numpy.sin(2.0 * jax.numpy.pi * course.time)) ** 2)


def table() -> list[str]:
    """Rows of the Markdown table."""

    def wait(value: object) -> object:
        return jax.block_until_ready(value)

    rows = ["| what | wall time of a run | against LSODA |", "|---|---|---|"]
    small, exact = wang_case(), wang_case(exact=True)
    slow = in_turn([lambda: scipy_run(small)], rounds=3, clock=time.perf_counter).seconds[0]
    rows.append(f"| SciPy's LSODA (`odeint`), Eq. (17) in Python, rtol 1e-8 | {slow * 1e3:.0f} ms | 1 |")
    for name, case in (("small deflection", small), ("exact leaf", exact)):
        batch = [wang_case(exact=case is exact, gain=gain) for gain in np.linspace(0.9, 1.1, BATCH)]
        course = run_one(case, duration=DURATION, substeps=1)
        spent = in_turn(
            [
                lambda case=case: wait(run_one(case, duration=DURATION, substeps=1)),
                lambda batch=batch: wait(run_many(batch, duration=DURATION, substeps=1)),
                lambda case=case, course=course: wait(rows_of(case, course)),
            ],
            rounds=9,
            clock=time.perf_counter,
        ).seconds
        each = spent[1] / BATCH
        rows.append(f"| {name}, one run | {spent[0] * 1e3:.2f} ms | 1/{slow / spent[0]:.0f} |")
        rows.append(
            f"| {name}, {BATCH} runs in a batch on every core, each | {each * 1e3:.2f} ms | 1/{slow / each:.0f} |"
        )
        rows.append(f"| {name}, forces and powers of every sample, besides | {spent[2] * 1e3:.2f} ms | |")
    gradient = in_turn(
        [lambda: run_gradient(small, _position_cost, duration=DURATION)], rounds=5, clock=time.perf_counter
    ).seconds[0]
    rows.append(f"| small deflection, cost and its gradient to every number | {gradient * 1e3:.1f} ms | |")
    return rows
