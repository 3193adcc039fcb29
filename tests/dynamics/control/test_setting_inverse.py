"""Inverse of a monotone map: closed forms, ends, holes, derivatives, refusals."""

from __future__ import annotations

import math
from typing import Any, ClassVar

import equinox as eqx
import jax
import jax.numpy as jnp
import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from varistiff.actuators import Actuator, Maccepa, Response, RollerBeam, SeriesElastic, SliderLeafJoint, TorsionTube
from varistiff.actuators.compiled import respond_block
from varistiff.core.errors import InputError
from varistiff.dynamics.control import SettingInverse, monotone_inverse, setting_inverse
from varistiff.sections import Circle


@given(low=st.floats(0.01, 1.0), span=st.floats(1.5, 15.0), part=st.floats(0.0, 1.0), power=st.floats(-3.5, 3.0))
def test_powers_are_inverted(low: float, span: float, part: float, power: float) -> None:
    if abs(power) < 0.2:
        return  # too flat: the function's own rounding moves its argument
    x, high = low * (1.0 + part * (span - 1.0)), low * span
    found = INVERSE(x**power, low, high, power, power > 0.0)
    assert float(found) == pytest.approx(x, rel=1e-11)  # rounding over the power


INVERSE = jax.jit(
    lambda target, low, high, power, rising: monotone_inverse(lambda x: x**power, target, low, high, rising=rising),
    static_argnames="rising",
)


@pytest.mark.parametrize("rising", [True, False])
def test_targets_beyond_the_range_end_at_its_ends(rising: bool) -> None:
    def cube(x: Any) -> Any:
        return x**3 if rising else -(x**3)

    solve = jax.jit(jax.value_and_grad(lambda t: monotone_inverse(cube, t if rising else -t, 0.5, 2.0, rising=rising)))
    for target, end in ((-100.0, 0.5), (100.0, 2.0)):
        found, slope = solve(target)
        assert float(found) == end
        assert float(slope) == 0.0


def test_holes_on_the_steep_side_are_left_out() -> None:
    def stiffness(x: Any) -> Any:
        return jnp.where(x > 0.3, x**-2.0, jnp.nan)

    found = monotone_inverse(stiffness, 4.0, 0.1, 1.0, rising=False)
    assert float(found) == pytest.approx(0.5, rel=1e-13)
    edge = monotone_inverse(stiffness, 1e6, 0.1, 1.0, rising=False)
    assert float(edge) == pytest.approx(0.3, abs=0.9 / 16.0)  # as near as bisection comes to the last value


def test_holes_on_the_steep_side_of_a_rising_function_are_left_out() -> None:
    found = monotone_inverse(lambda x: jnp.where(x < 0.4, x, jnp.nan), 0.1, 0.0, 1.0, rising=True)
    assert float(found) == pytest.approx(0.1, rel=1e-13)


def test_flat_functions_do_not_break_it() -> None:
    found = monotone_inverse(lambda x: jnp.where(x < 0.5, 0.0, x - 0.5), 0.25, 0.0, 1.0, rising=True)
    assert float(found) == pytest.approx(0.75, rel=1e-13)
    assert math.isfinite(float(monotone_inverse(lambda x: 0.0 * x, 1.0, 0.0, 1.0, rising=True)))


def test_derivatives_are_those_of_the_implicit_function() -> None:
    def solve(target: Any, factor: Any) -> Any:
        return monotone_inverse(lambda x: factor * jnp.exp(x), target, 0.0, 3.0, rising=True)

    value, (by_target, by_factor) = jax.jit(jax.value_and_grad(solve, argnums=(0, 1)))(5.0, 1.3)
    # x = log(t/f)
    assert float(value) == pytest.approx(math.log(5.0 / 1.3), rel=1e-13)
    assert float(by_target) == pytest.approx(1.0 / 5.0, rel=1e-12)
    assert float(by_factor) == pytest.approx(-1.0 / 1.3, rel=1e-12)


def test_torsion_tube_is_found_again() -> None:
    tube = TorsionTube(shear_modulus=0.63e9, section=Circle(radius=0.008))
    inverse = setting_inverse(tube, setting_min=0.011, setting_max=0.166)
    assert not inverse.rising
    torsion = 0.63e9 * math.pi * 0.008**4 / 2.0  # G J of a circle
    for length in (0.011, 0.03, 0.1659):
        assert float(setting_at(inverse, torsion / length)) == pytest.approx(length, rel=1e-12)


def test_maccepa_rises_with_its_setting() -> None:
    inverse = setting_inverse(Maccepa(394.0, 0.036, 0.135), setting_min=0.005, setting_max=0.025)
    assert inverse.rising
    arm = 394.0 * 0.036 * 0.135 / 0.099
    assert float(setting_at(inverse, arm * 0.02)) == pytest.approx(0.02, rel=1e-12)


def test_load_of_a_roller_beam_on_both_sides(knee: RollerBeam) -> None:
    angles = (-0.15, -0.01, 0.01, 0.15)
    inverse = setting_inverse(knee, setting_min=0.2, setting_max=0.6, quantity="load", deflections=angles)
    rigidity = 194e9 * 0.02545 * 0.00316**3 / 12.0
    for angle in angles:
        setting = 0.37
        load = float(respond_block(knee, np.array([angle]), np.array([setting]))[0].load[0])
        found = float(setting_at(inverse, load, angle))
        assert found == pytest.approx(setting, rel=1e-10)  # the load's own solver
        # M = 3 E I theta/x_r, right to the square of the angle
        assert 3.0 * rigidity * angle / load == pytest.approx(found, rel=3.0 * angle**2 + 1e-9)
    # a load of the wrong sign: the softest setting, which is the largest
    assert float(setting_at(inverse, -5.0, 0.1)) == 0.6
    assert float(setting_at(inverse, 5.0, -0.1)) == 0.6
    assert float(setting_at(inverse, 1e4, 0.1)) == 0.2


def test_batch_is_the_single_answer(wang_joint: SliderLeafJoint) -> None:
    inverse = setting_inverse(wang_joint, setting_min=0.006, setting_max=0.025)
    targets = jnp.array([210.0, 800.0, 5000.0])
    many = np.asarray(jax.jit(jax.vmap(inverse.at))(targets))
    assert many == pytest.approx([float(setting_at(inverse, target)) for target in targets], rel=1e-14)


# numbers that are traced: a Python number would be compiled in
def setting_at(inverse: SettingInverse, target: Any, deflection: float = 0.0) -> Any:
    return COMPILED_AT(inverse, jnp.asarray(target), jnp.asarray(deflection))


COMPILED_AT = eqx.filter_jit(lambda inverse, target, deflection: inverse.at(target, deflection))


class Dip(Actuator):
    """Stiffness 1 + (s - 0.4)^2: no inverse over a range around 0.4."""

    kind: ClassVar[str] = "dip"
    deflection_unit: ClassVar[str] = "rad"
    references: ClassVar[tuple[str, ...]] = ()

    @property
    def setting_unit(self) -> str:
        return "m"

    @property
    def strength(self) -> None:
        return None

    def energy(self, deflection: Any, setting: Any) -> Any:
        return 0.5 * (1.0 + (setting - 0.4) ** 2) * deflection**2

    def respond(self, deflection: Any, setting: Any) -> tuple[Response, dict[str, Any]]:
        stiffness = 1.0 + (setting - 0.4) ** 2 + 0.0 * deflection
        zero = 0.0 * stiffness
        status = jnp.zeros(jnp.shape(stiffness), jnp.int8)
        response = Response(status, self.energy(deflection, setting), stiffness * deflection, stiffness, zero, zero)
        return response, {}


def test_maps_without_an_inverse_are_refused(wang_joint: SliderLeafJoint, knee: RollerBeam) -> None:
    with pytest.raises(InputError, match=r"the stiffness at a deflection of 0 rad must rise or fall .* 0\.4 m"):
        setting_inverse(Dip(), setting_min=0.0, setting_max=0.8)
    assert setting_inverse(Dip(), setting_min=0.4, setting_max=0.8).rising
    with pytest.raises(InputError, match="has no setting"):
        setting_inverse(SeriesElastic(stiffness=1.0), setting_min=0.0, setting_max=1.0)
    with pytest.raises(InputError, match=r"no stiffness at a deflection of 0 rad .* of 0 m: no_solution"):
        setting_inverse(wang_joint, setting_min=0.0, setting_max=0.02)
    with pytest.raises(InputError, match="lower end"):
        setting_inverse(wang_joint, setting_min=0.02, setting_max=0.01)
    with pytest.raises(InputError, match="quantity: must be one of"):
        setting_inverse(wang_joint, setting_min=0.01, setting_max=0.02, quantity="energy")  # type: ignore[arg-type]  # what a user may write
    # at rest every setting of a roller beam has the load 0
    with pytest.raises(InputError, match="rests"):
        setting_inverse(knee, setting_min=0.2, setting_max=0.6, quantity="load")


def test_inverse_made_by_hand_needs_no_check() -> None:
    inverse = SettingInverse(Maccepa(394.0, 0.036, 0.135), 0.005, 0.025, rising=True)
    assert float(setting_at(inverse, 394.0 * 0.036 * 0.135 / 0.099 * 0.01)) == pytest.approx(0.01, rel=1e-12)
