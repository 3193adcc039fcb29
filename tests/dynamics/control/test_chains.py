"""Chains from a stiffness to the setting drive: Eq. (9), the groove, its straight line, and any map."""

from __future__ import annotations

import math
from typing import Any

import equinox as eqx
import jax
import jax.numpy as jnp
import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from scipy.integrate import simpson

from varistiff.actuators import LargeDeflection, Maccepa, SliderLeafJoint
from varistiff.core.errors import InputError
from varistiff.dynamics.control import (
    MapChain,
    Measured,
    Pid,
    SensedSpring,
    SettingHold,
    StiffnessChain,
    StiffnessPid,
    WangChain,
    Wanted,
    active_length_from_stiffness,
    exact_chain,
    motion_of_setting,
    setting_inverse,
    straight_line,
    wang_chain,
)
from varistiff.dynamics.path import Affine, GroovePath, Path, Place

BENDING = 206e9 * 0.025 * 0.001**3 / 4.0  # N E b h^3/4 with the printed numbers
RANGE = {"setting_min": 0.006, "setting_max": 0.025}


def by_disc_angle(joint: SliderLeafJoint) -> SliderLeafJoint:
    return SliderLeafJoint(joint.leaf, joint.count, joint.clamp_radius, joint.theory, joint.groove, "disc")


@given(length=st.floats(1e-4, 1.0), radius=st.floats(1e-3, 0.5), bending=st.floats(1e-3, 1e3))
def test_equation_9_is_inverted_to_rounding(length: float, radius: float, bending: float) -> None:
    stiffness = bending * (radius + length) ** 2 / length**3
    found = float(LENGTH(stiffness, bending, radius))
    assert found == pytest.approx(length, rel=2e-13)  # a dozen operations, none of which cancels


LENGTH = jax.jit(lambda k, c, r: active_length_from_stiffness(k, bending=c, clamp_radius=r))


def test_equation_9_at_the_ends_of_the_paper_s_range() -> None:
    # 206 N m/rad at 25 mm and 5728 at 6 mm follow from the printed numbers
    for stiffness, length in ((206.0, 0.025), (BENDING * 0.031**2 / 0.006**3, 0.006)):
        found = active_length_from_stiffness(stiffness, bending=BENDING, clamp_radius=0.025)
        assert float(found) == pytest.approx(length, rel=1e-13)
    assert pytest.approx(5728.0, abs=0.5) == BENDING * 0.031**2 / 0.006**3  # as rounded in the theory page


def test_straight_line_is_least_squares(wang_joint: SliderLeafJoint) -> None:
    groove = wang_joint.groove
    low, high = 0.15, math.radians(47.0)
    line = straight_line(groove, low, high)

    angle = np.linspace(low, high, 2001)
    length = np.asarray(groove.active_length(jnp.asarray(angle)))
    residual = float(line.slope) * angle + float(line.intercept) - length
    # the normal equations: the error has neither mean nor tilt; Simpson's rule errs by less than 1e-15 here
    for power in (0, 1):
        assert abs(simpson(residual * angle**power, x=angle)) < 1e-14
    assert float(line.error) == pytest.approx(np.abs(residual).max(), rel=1e-4)  # both look at a grid
    # beside it a fit of points
    slope, intercept = np.polyfit(angle, length, 1)
    assert float(line.slope) == pytest.approx(slope, rel=2e-4)  # points at the ends weigh double there
    assert float(line.intercept) == pytest.approx(intercept, rel=5e-3)


def test_straight_line_of_a_straight_groove_is_exact() -> None:
    class Straight(eqx.Module):
        def active_length(self, angle: Any) -> Any:
            return 0.04 * angle - 0.002

    line = straight_line(Straight(), 0.1, 0.9)  # type: ignore[arg-type]  # all that is asked of a groove
    assert float(line.slope) == pytest.approx(0.04, rel=1e-14)
    assert float(line.intercept) == pytest.approx(-0.002, rel=1e-13)
    assert float(line.error) < 1e-15  # rounding


def test_error_of_the_line_at_both_ends_of_the_groove(wang_joint: SliderLeafJoint) -> None:
    disc = by_disc_angle(wang_joint)
    end = math.radians(47.0)
    chain = wang_chain(disc, setting_min=1e-9, setting_max=end)
    p, q = float(chain.line.slope), float(chain.line.intercept)
    # at A the active length is 0, at C it is r_1 - r_2 = 29 mm
    assert float(chain.length_error(0.0)) == pytest.approx(q, abs=1e-15)
    assert float(chain.length_error(end)) == pytest.approx(p * end + q - 0.029, abs=1e-15)
    # 36.8 mm is nearly the best radius: within 0.40 mm over 47 degrees (theory page), to its digits
    assert float(chain.line.error) == pytest.approx(0.40e-3, abs=0.005e-3)
    assert p == pytest.approx(0.029 / end, rel=0.05)  # about the chord


@pytest.mark.parametrize("theory", ["small", "large"])
def test_exact_chain_ends_in_the_commanded_stiffness(wang_joint: SliderLeafJoint, theory: str) -> None:
    joint = wang_joint
    if theory == "large":
        joint = eqx.tree_at(lambda j: j.theory, wang_joint, LargeDeflection())
    chain = exact_chain(joint, **RANGE)
    for stiffness in (206.5, 400.0, 1234.5, 5700.0):
        angle = chain.motion(stiffness, 0.0)
        response, _ = joint.respond(jnp.asarray(0.0), joint.groove.active_length(angle))
        assert float(response.stiffness) == pytest.approx(stiffness, rel=1e-11)  # arccos on the groove
        assert float(chain.stiffness(angle, 0.0)) == pytest.approx(stiffness, rel=1e-11)


def test_wang_chain_errs_by_its_line(wang_joint: SliderLeafJoint) -> None:
    chain = wang_chain(wang_joint, **RANGE)
    p, q = float(chain.line.slope), float(chain.line.intercept)
    for stiffness in (250.0, 400.0, 3000.0):
        length = float(active_length_from_stiffness(stiffness, bending=BENDING, clamp_radius=0.025))
        angle = float(chain.motion(stiffness, 0.02))
        assert angle == pytest.approx((length - q) / p, rel=1e-14)
        # believed by the line, and what the groove makes of it
        assert float(chain.stiffness(angle, 0.0)) == pytest.approx(stiffness, rel=1e-12)
        real = float(wang_joint.groove.active_length(jnp.asarray(angle)))
        error = BENDING * (0.025 + real) ** 2 / real**3 - stiffness
        assert float(chain.stiffness_error(stiffness)) == pytest.approx(error, rel=1e-9)
        # to first order dK/dl_1 times the error of the length
        slope = -stiffness * (1.0 / real + 2.0 * 0.025 / (real * (0.025 + real)))
        assert error == pytest.approx(-slope * float(chain.length_error(angle)), rel=0.1)
        assert abs(error) > 1e-3


@pytest.mark.parametrize("make", [wang_chain, exact_chain])
def test_commands_beyond_the_range_are_held(wang_joint: SliderLeafJoint, make: Any) -> None:
    chain = make(wang_joint, **RANGE)
    groove = wang_joint.groove
    softest, stiffest = (float(groove.angle(jnp.asarray(length))) for length in (0.025, 0.006))
    tolerance = {"abs": 2.0 * float(getattr(chain, "line", (1.0, 0.0, 1e-12))[2]) / 0.037}  # the line's error as angle
    for command, angle in ((-5.0, softest), (0.0, softest), (150.0, softest), (1e5, stiffest)):
        found = float(chain.motion(command, 0.0))
        assert found == pytest.approx(angle, **tolerance)
        assert stiffest <= found <= softest
    assert math.isfinite(float(jax.grad(lambda k: chain.motion(k, 0.0))(0.0)))


def test_driven_by_length_or_disc_is_the_same_chain(wang_joint: SliderLeafJoint) -> None:
    disc = by_disc_angle(wang_joint)
    ends = [float(wang_joint.groove.angle(jnp.asarray(length))) for length in RANGE.values()]
    by_disc = wang_chain(disc, setting_min=ends[0], setting_max=ends[1])
    by_length = wang_chain(wang_joint, **RANGE)
    assert float(by_disc.motion(700.0, 0.0)) == pytest.approx(float(by_length.motion(700.0, 0.0)), rel=1e-10)


def test_cosine_that_the_chain_leaves_out(wang_joint: SliderLeafJoint) -> None:
    # Eq. (9) at the paper's largest deflection, 3.03 degrees
    stiff = [
        float(wang_joint.respond(jnp.asarray(math.radians(a)), jnp.asarray(0.02))[0].stiffness) for a in (0.0, 3.03)
    ]
    assert stiff[1] / stiff[0] == pytest.approx(0.9986, abs=5e-5)


def test_chains_refuse_what_they_cannot_do(wang_joint: SliderLeafJoint) -> None:
    bare = SliderLeafJoint(leaf=wang_joint.leaf, count=1, clamp_radius=0.025)
    with pytest.raises(InputError, match="groove"):
        wang_chain(bare, **RANGE)
    with pytest.raises(InputError, match=r"setting_max: an active length of 0\.05 m is not on the groove"):
        exact_chain(wang_joint, setting_min=0.006, setting_max=0.05)
    with pytest.raises(InputError, match="setting_min: an active length of 0 m is not on the groove"):
        exact_chain(wang_joint, setting_min=0.0, setting_max=0.02)
    with pytest.raises(InputError, match="lower end"):
        wang_chain(wang_joint, setting_min=0.02, setting_max=0.006)


def test_gradients_pass_the_chain_and_its_fit(wang_joint: SliderLeafJoint) -> None:
    def angle(thickness: Any) -> Any:
        joint = eqx.tree_at(lambda j: j.leaf.thickness, wang_joint, thickness)
        return wang_chain(joint, **RANGE).motion(500.0, 0.0)

    gradient = jax.jit(jax.grad(angle))(0.001)
    difference = (angle(0.001 * (1 + 1e-5)) - angle(0.001 * (1 - 1e-5))) / 2e-8
    assert float(gradient) == pytest.approx(float(difference), rel=1e-7)  # differences of size^2


@pytest.mark.parametrize("at", ["rest", "measured"])
def test_map_chain_of_a_maccepa(at: Any) -> None:
    spring, lever, distance, lead = 394.0, 0.036, 0.135, 0.002
    maccepa = Maccepa(spring_rate=spring, lever_length=lever, anchor_distance=distance)
    path = Affine(start=0.001, ratio=lead)
    inverse = setting_inverse(maccepa, setting_min=0.005, setting_max=0.025)
    chain = MapChain(inverse, path, at)
    # at rest K = k P B C/|C - B|
    arm = spring * lever * distance / (distance - lever)
    motion_of = eqx.filter_jit(chain.motion)
    motion = motion_of(jnp.asarray(arm * 0.014), jnp.asarray(0.0))
    assert float(motion) == pytest.approx((0.014 - 0.001) / lead, rel=1e-12)
    assert float(chain.stiffness(motion, 0.0)) == pytest.approx(arm * 0.014, rel=1e-12)
    # at a deflection K = k (A'^2 + e A''), linear in P
    phi = 0.5
    a = math.sqrt(lever**2 + distance**2 - 2.0 * lever * distance * math.cos(phi))
    first = lever * distance * math.sin(phi) / a
    second = (lever * distance * math.cos(phi) - first**2) / a
    pretension = 0.014
    stiffness = spring * (first**2 + (a + pretension - (distance - lever)) * second)
    found = float(motion_of(jnp.asarray(stiffness), jnp.asarray(phi)))
    expected = (pretension - 0.001) / lead if at == "measured" else (stiffness / arm - 0.001) / lead
    assert found == pytest.approx(expected, rel=1e-11)
    # K at rest is linear in P
    assert [float(end) for end in chain.reach()] == pytest.approx([arm * 0.005, arm * 0.025], rel=1e-13)


@pytest.mark.parametrize("make", [wang_chain, exact_chain])
def test_reach_is_equation_9_at_the_ends(make: Any, wang_joint: SliderLeafJoint) -> None:
    least, most = make(wang_joint, **RANGE).reach()
    assert float(least) == pytest.approx(206.0, rel=1e-13)  # N E b h^3 l_2^2/(4 l_1^3) at 25 mm
    assert float(most) == pytest.approx(BENDING * 0.031**2 / 0.006**3, rel=1e-13)


def test_motion_of_setting_inverts_the_paths(wang_joint: SliderLeafJoint) -> None:
    for path in (Affine(start=0.1, ratio=-0.02), GroovePath(wang_joint.groove), GroovePath(wang_joint.groove, 0.025)):
        for motion in (0.3, 0.55):
            value = path.at(jnp.asarray(motion)).value
            assert float(motion_of_setting(path, value)) == pytest.approx(motion, rel=1e-11)  # arccos

    class Odd(Path):
        def at(self, motion: Any) -> Place:
            return Place(motion**3, 3.0 * motion**2, 6.0 * motion)

    with pytest.raises(TypeError, match="Odd"):
        motion_of_setting(Odd(), 0.1)


def test_stiffness_pid_asks_for_an_angle(wang_joint: SliderLeafJoint) -> None:
    chain = wang_chain(wang_joint, **RANGE)
    measured, wanted = Measured(link=0.30, drive=0.31, motion=0.4), Wanted(stiffness=600.0)
    error = float(chain.motion(600.0, 0.0)) - 0.4
    controller = StiffnessPid(Pid(proportional=12.0), chain)
    command, _ = controller.sample(controller.start(measured, wanted), measured, wanted, 0.001)
    assert float(command) == pytest.approx(12.0 * error, rel=1e-12)
    # with the map the load on the disc is held beside it
    spring = SensedSpring(wang_joint, GroovePath(wang_joint.groove), setting_min=0.006, setting_max=0.025)
    helped = StiffnessPid(Pid(proportional=12.0), chain, spring)
    command, _ = helped.sample(helped.start(measured, wanted), measured, wanted, 0.001)
    assert float(command) == pytest.approx(12.0 * error + float(spring.adjusting_torque(measured)), rel=1e-12)
    assert float(spring.adjusting_torque(measured)) < -0.1  # the slider wants outwards


class Echo(StiffnessChain):
    """Asks for a coordinate equal to the deflection that it is told."""

    def motion(self, stiffness: Any, deflection: Any) -> Any:
        return deflection

    def stiffness(self, motion: Any, deflection: Any) -> Any:
        return motion

    def reach(self) -> Any:
        return 0.0, 1.0


@pytest.mark.parametrize("driven, deflection", [(True, 0.2), (False, 0.3)])
def test_chain_is_told_the_deflection(driven: bool, deflection: float) -> None:
    measured, wanted = Measured(link=0.3, drive=0.5, motion=0.0), Wanted(stiffness=600.0)
    controller = StiffnessPid(Pid(proportional=1.0), Echo(), driven=driven)
    command, _ = controller.sample(controller.start(measured, wanted), measured, wanted, 0.001)
    assert float(command) == pytest.approx(deflection, rel=1e-14)


def test_setting_hold_is_a_servo_to_one_place(wang_joint: SliderLeafJoint) -> None:
    measured, wanted = Measured(link=0.30, drive=0.31, motion=0.4), Wanted(stiffness=600.0)
    controller = SettingHold(Pid(proportional=12.0), motion=0.5)
    command, _ = controller.sample(controller.start(measured, wanted), measured, wanted, 0.001)
    assert float(command) == pytest.approx(1.2, rel=1e-12)
    with pytest.raises(InputError, match="motion"):
        SettingHold(Pid(proportional=12.0), motion=math.nan)


def test_chain_is_a_module_of_numbers(wang_joint: SliderLeafJoint) -> None:
    chain = wang_chain(wang_joint, **RANGE)
    assert isinstance(chain, WangChain)
    many = jax.vmap(lambda k: chain.motion(k, 0.0))(jnp.array([250.0, 900.0]))
    assert np.asarray(many) == pytest.approx([float(chain.motion(k, 0.0)) for k in (250.0, 900.0)], rel=1e-14)
