"""What holds for every controller: a time loop carries it, batches equal single runs, gradients are finite."""

from __future__ import annotations

import subprocess
import sys
from typing import Any

import equinox as eqx
import jax
import jax.numpy as jnp
import numpy as np
import pytest

from varistiff.actuators import Maccepa, SliderLeafJoint
from varistiff.dynamics import control
from varistiff.dynamics.control import (
    Controller,
    Delay,
    DelayedController,
    ImpedanceControl,
    LinkModel,
    LqrWeights,
    MapChain,
    Measured,
    Pid,
    PositionPid,
    SensedSpring,
    SettingHold,
    StiffnessDecoupling,
    StiffnessPid,
    TorqueControl,
    TwoMass,
    VirtualSpringDamper,
    Wanted,
    exact_chain,
    scheduled_lqr,
    setting_inverse,
    virtual_spring_damper,
    wang_chain,
)
from varistiff.dynamics.path import Affine, GroovePath

PID = Pid(30.0, 12.0, 1.5, filter_time=0.004, windup_time=0.3, limit=8.0)
STRONG = Pid(30.0, 12.0, 1.5, filter_time=0.004, windup_time=0.3, limit=500.0)
RANGE = {"setting_min": 0.006, "setting_max": 0.025}
NAMES = [
    "position",
    "delayed",
    "wang",
    "exact",
    "map",
    "hold",
    "torque",
    "impedance",
    "decoupling",
    "lqr",
    "virtual",
]


@pytest.fixture(scope="module")
def controllers(wang_joint: SliderLeafJoint) -> dict[str, Controller]:
    spring = SensedSpring(wang_joint, GroovePath(wang_joint.groove), **RANGE)
    maccepa = Maccepa(394.0, 0.036, 0.135)
    pretension = {"setting_min": 0.005, "setting_max": 0.025}
    inverse = setting_inverse(maccepa, **pretension, deflections=(0.0, 0.1))
    swinging = SensedSpring(maccepa, Affine(ratio=0.02), **pretension, driven=False)
    torque = TorqueControl(STRONG, spring)
    return {
        "position": PositionPid(PID),
        "delayed": DelayedController(PositionPid(PID), Delay(3)),
        "wang": StiffnessPid(PID, wang_chain(wang_joint, **RANGE), spring),
        "exact": StiffnessPid(PID, exact_chain(wang_joint, **RANGE)),
        "map": StiffnessPid(STRONG, MapChain(inverse, Affine(ratio=0.02), "measured")),
        "hold": SettingHold(PID, 0.4, spring),
        "torque": torque,
        "impedance": ImpedanceControl(torque, 20.0, 1.0, 0.1, 0.003),
        "decoupling": StiffnessDecoupling(spring, PID, LinkModel(0.1, 0.02), 20.0, 1.0, 0.05, 0.1),
        "lqr": scheduled_lqr(spring, TwoMass(0.1, 0.05), LqrWeights(100.0, 0.01, integral=100.0), nodes=5, limit=8.0),
        "virtual": virtual_spring_damper(swinging, PID, deflection_max=0.5, dead_band=0.01, stiffness=1.0, damping=0.1),
    }


def commands(controller: Controller, shift: Any) -> Any:
    """Commands over 30 samples of moving readings."""
    # what the MACCEPA and the leaf can give
    stiffness = 0.3 if isinstance(getattr(controller, "chain", None), MapChain) else 700.0

    def reading(time: Any) -> tuple[Measured, Wanted]:
        link = 0.15 + shift + 0.1 * jnp.sin(20.0 * time)
        measured = Measured(link, link + 0.01 * jnp.cos(9.0 * time), 0.5 + 0.1 * jnp.sin(7.0 * time))
        return measured, Wanted(0.1 + time, 1.0, 0.3, stiffness * (1.0 + time), stiffness, 0.4)

    def advance(memory: Any, index: Any) -> Any:
        command, memory = controller.sample(memory, *reading(2e-3 * index), 2e-3)
        return memory, command

    start = controller.start(*reading(jnp.asarray(0.0)))
    return jax.lax.scan(advance, start, jnp.arange(30, dtype=float))[1]


@pytest.mark.parametrize("name", NAMES)
def test_time_loop_carries_it_and_batches_equal_single_runs(controllers: dict[str, Controller], name: str) -> None:
    shifts = jnp.array([0.0, 0.02, 0.05])
    controller = controllers[name]
    many = np.asarray(jax.jit(jax.vmap(lambda shift: commands(controller, shift)))(shifts))
    one = jax.jit(lambda shift: commands(controller, shift))
    assert np.isfinite(many).all()
    assert np.ptp(many) > 1e-3  # it does something
    for row, shift in zip(many, shifts, strict=True):
        assert row == pytest.approx(np.asarray(one(shift)), rel=1e-10, abs=1e-10)  # fused multiply-adds differ


@pytest.mark.parametrize("name", NAMES)
def test_gradients_with_respect_to_all_numbers_are_finite(controllers: dict[str, Controller], name: str) -> None:
    as_arrays = jax.tree.map(lambda leaf: jnp.asarray(leaf) if isinstance(leaf, float) else leaf, controllers[name])
    # infinite numbers (no limit, an unlimited leaf) are no parameters that could be tuned
    tuned, rest = eqx.partition(as_arrays, lambda leaf: eqx.is_inexact_array(leaf) and bool(jnp.isfinite(leaf).all()))

    def cost(numbers: Any) -> Any:
        return jnp.sum(commands(eqx.combine(numbers, rest), 0.0) ** 2)

    gradient = jax.tree.leaves(jax.jit(jax.grad(cost))(tuned))
    assert all(np.isfinite(np.asarray(part)).all() for part in gradient)
    assert any(np.any(np.asarray(part) != 0.0) for part in gradient)


def test_every_kind_of_controller_is_tried(controllers: dict[str, Controller]) -> None:
    kinds = {value for value in vars(control).values() if isinstance(value, type) and issubclass(value, Controller)}
    assert {type(controller) for controller in controllers.values()} == kinds - {Controller}
    assert sorted(controllers) == sorted(NAMES)
    assert VirtualSpringDamper in kinds


def test_python_control_is_imported_only_where_it_is_needed() -> None:
    code = "import sys, varistiff.dynamics.control; print('control' in sys.modules)"
    done = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, check=True)
    assert done.stdout.strip() == "False"
