"""Energy, load, stiffness and adjusting load belong to one potential, on every kind.

Differences are central, of fourth order (Richardson), on `energy` alone. With a step of 2e-3 of the range the
truncation is below 1e-9 of the largest value and rounding below 1e-11: 1e-7 leaves a wide margin, and a wrong
sign or a forgotten term misses it by seven orders.
"""

from __future__ import annotations

from collections.abc import Callable

import jax.numpy as jnp
import numpy as np
import pytest
from hypothesis import Phase, given, settings
from hypothesis import strategies as st
from numpy.typing import NDArray

from .catalogue import CATALOGUE, Case
from .evaluation import energy, energy_gradient, respond

Floats = NDArray[np.float64]
STEP = 2e-3
SHOWN = 5  # points of an eager evaluation


def _floor(case: Case, *, setting: bool = False) -> float:
    """Size of the load in the range: batches of points that are all at rest have no scale of their own."""
    found = respond(case.actuator, *case.sample(0))
    return float(np.max(np.abs(found["adjusting_load" if setting else "load"])))


every_case = pytest.mark.parametrize("case", CATALOGUE, ids=lambda case: case.name)
some = settings(max_examples=8, deadline=None, derandomize=True, phases=(Phase.explicit, Phase.generate, Phase.shrink))


def difference(f: Callable[[float], Floats], step: float) -> Floats:
    """Derivative at 0, error of fourth order in the step."""
    near, far = f(step) - f(-step), f(2 * step) - f(-2 * step)
    return (8 * near - far) / (12 * step)


def assert_close(found: Floats, wanted: Floats, *, relative: float, floor: float = 0.0) -> None:
    """Equal up to a share of the largest value: loads and stiffnesses may cross zero."""
    scale = float(np.max(np.abs(wanted))) + floor
    np.testing.assert_allclose(found, wanted, rtol=0, atol=relative * scale)


@every_case
@some
@given(data=st.data())
def test_load_is_the_slope_of_the_energy(case: Case, data: st.DataObject) -> None:
    deflection, setting = data.draw(case.points())
    actuator, step = case.actuator, STEP * case.reach[0]
    slope = difference(lambda h: energy(actuator, deflection + h, setting), step)
    assert_close(respond(actuator, deflection, setting)["load"], slope, relative=1e-7, floor=_floor(case))


@every_case
@some
@given(data=st.data())
def test_adjusting_load_is_the_slope_of_the_energy(case: Case, data: st.DataObject) -> None:
    deflection, setting = data.draw(case.points())
    actuator = case.actuator
    found = respond(actuator, deflection, setting)["adjusting_load"]
    if case.setting is None:
        assert np.isnan(found).all()
        return
    slope = difference(lambda h: energy(actuator, deflection, setting + h), STEP * case.reach[1])
    assert_close(found, slope, relative=1e-7, floor=_floor(case, setting=True))


@every_case
@some
@given(data=st.data())
def test_stiffness_is_the_slope_of_the_load(case: Case, data: st.DataObject) -> None:
    deflection, setting = data.draw(case.points())
    actuator, step = case.actuator, STEP * case.reach[0]
    slope = difference(lambda h: respond(actuator, deflection + h, setting)["load"], step)
    assert_close(respond(actuator, deflection, setting)["stiffness"], slope, relative=1e-7)


@every_case
@some
@given(data=st.data())
def test_gradient_of_the_energy_is_exact(case: Case, data: st.DataObject) -> None:
    """Automatic differentiation of `energy` meets the stated loads to rounding."""
    deflection, setting = data.draw(case.points())
    found = respond(case.actuator, deflection, setting)
    along, across = energy_gradient(case.actuator, deflection, setting)
    assert_close(along, found["load"], relative=1e-11, floor=_floor(case))
    if case.setting is not None:
        assert_close(across, found["adjusting_load"], relative=1e-11, floor=_floor(case, setting=True))


@every_case
@some
@given(data=st.data())
def test_points_of_the_catalogue_are_ok(case: Case, data: st.DataObject) -> None:
    """Inside its range a device has status ok, finite numbers, and energy equal to `energy`."""
    deflection, setting = data.draw(case.points())
    found = respond(case.actuator, deflection, setting)
    assert (found["status"] == 0).all()
    assert np.isfinite(found["energy"]).all()
    assert (found["energy"] >= 0).all()
    assert np.isfinite(found["load"]).all()
    assert np.isfinite(found["stiffness"]).all()
    stored = energy(case.actuator, deflection, setting)
    np.testing.assert_allclose(found["energy"], stored, rtol=1e-12, atol=1e-18)


@every_case
def test_numbers_are_double_precision(case: Case) -> None:
    found = respond(case.actuator, *case.sample(1))
    assert found["status"].dtype == np.int8
    assert {name for name, value in found.items() if value.dtype != np.float64} == {"status"}


@every_case
def test_work_done_is_the_energy_stored(case: Case) -> None:
    """The load's integral along a deflection is the difference of energies (64 Gauss points: exact here)."""
    actuator = case.actuator
    low, high = case.deflections[0]
    nodes, weights = np.polynomial.legendre.leggauss(24)
    path = low + (high - low) * (nodes + 1) / 2
    for share in (0.1, 0.9):
        setting = 0.0 if case.setting is None else case.setting[0] + share * (case.setting[1] - case.setting[0])
        work = float(weights @ respond(actuator, path, np.full(24, setting))["load"]) * (high - low) / 2
        ends = np.linspace(low, high, 24)
        stored = energy(actuator, ends, np.full(24, setting))
        assert work == pytest.approx(stored[-1] - stored[0], rel=1e-6, abs=1e-9 * float(stored.max()))


@every_case
def test_evaluate_is_respond(case: Case) -> None:
    """Blocks, padding and compilation change nothing but rounding."""
    deflection, setting = (values[:SHOWN] for values in case.sample(2))
    found = respond(case.actuator, deflection, setting)
    response, details = case.actuator.respond(jnp.asarray(deflection), jnp.asarray(setting))
    direct = {**response._asdict(), **details}
    assert direct.keys() == found.keys()
    assert set(case.actuator.details) >= set(details)
    for name, value in direct.items():
        assert found[name].shape == (SHOWN,)
        np.testing.assert_allclose(found[name], np.asarray(value), rtol=1e-12, atol=1e-300, err_msg=name)
