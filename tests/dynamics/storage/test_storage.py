"""Storages against closed forms: discharge, largest power, batteries, and where every watt goes."""

from __future__ import annotations

import math
from typing import Any

import jax
import jax.numpy as jnp
import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from scipy.integrate import solve_ivp

from varistiff.core.errors import InputError
from varistiff.dynamics.storage import Battery, Storage, StorageFlows, Supercapacitor, Supply


def ask(storage: Storage, power: float, charge: float | None = None) -> StorageFlows:
    """Flows as plain floats, at the start's charge without another."""
    at = storage.charge0 if charge is None else charge
    return StorageFlows(*(float(value) for value in storage.flows(jnp.asarray(at), jnp.asarray(power))))


def discharge(storage: Storage, power: float, times: np.ndarray) -> np.ndarray:
    """Charge over time under a constant power, by SciPy at tight tolerance."""
    rate = jax.jit(lambda charge: storage.flows(charge, jnp.asarray(power)).charge_rate)

    def slope(_: float, charge: np.ndarray) -> list[float]:
        return [float(rate(charge[0]))]

    start = [storage.charge0]
    solution = solve_ivp(slope, (0.0, times[-1]), start, t_eval=times, method="DOP853", rtol=1e-12, atol=1e-12)
    return np.asarray(solution.y[0])


def test_capacitor_discharges_through_its_leakage() -> None:
    capacitor = Supercapacitor(capacitance=50.0, voltage=27.0, series_resistance=0.2, leakage_resistance=400.0)
    times = np.array([1e3, 2e4, 6e4])
    expected = 50.0 * 27.0 * np.exp(-times / (400.0 * 50.0))
    assert discharge(capacitor, 0.0, times) == pytest.approx(expected, rel=1e-8)  # of the integrator
    assert ask(capacitor, 0.0).leakage_power == pytest.approx(27.0**2 / 400.0, rel=1e-14)
    assert ask(capacitor, 0.0).series_power == 0.0


def test_ideal_capacitor_under_constant_power() -> None:
    # C V^2/2 falls by P t
    capacitor = Supercapacitor(capacitance=50.0, voltage=27.0)
    times = np.array([10.0, 150.0, 350.0])
    expected = 50.0 * np.sqrt(27.0**2 - 2.0 * 50.0 * times / 50.0)
    assert discharge(capacitor, 50.0, times) == pytest.approx(expected, rel=1e-8)


def test_capacitor_behind_a_resistance_under_constant_power() -> None:
    # t = (C/4P) [f(V_0) - f(V)], f = V^2 + V sqrt(V^2 - 4RP) - 4RP ln(V + sqrt(V^2 - 4RP)): Q' = -i, V = Q/C,
    # dt = -C dV/i = -C (V + s)/(2P) dV
    c, r, p, v0, v1 = 20.0, 0.3, 60.0, 27.0, 12.0

    def integral(v: float) -> float:
        s = math.sqrt(v * v - 4.0 * r * p)
        return v * v + v * s - 4.0 * r * p * math.log(v + s)

    time = c / (4.0 * p) * (integral(v0) - integral(v1))
    capacitor = Supercapacitor(capacitance=c, voltage=v0, series_resistance=r)
    assert discharge(capacitor, p, np.array([time]))[0] == pytest.approx(c * v1, rel=1e-8)


@pytest.mark.parametrize("storage", [Supply(voltage=20.0, series_resistance=0.5), Supercapacitor(10.0, 20.0, 0.5)])
def test_largest_power_through_a_series_resistance(storage: Storage) -> None:
    most = 20.0**2 / (4.0 * 0.5)
    at_most = ask(storage, most)
    assert -at_most.charge_rate == pytest.approx(20.0 / (2.0 * 0.5), rel=1e-7)  # root of a rounding error
    assert at_most.series_power == pytest.approx(most, rel=1e-7)  # half of what the source gives
    assert at_most.shortfall == 0.0
    beyond = ask(storage, 1.5 * most)
    assert -beyond.charge_rate == pytest.approx(20.0, rel=1e-14)
    assert beyond.shortfall == pytest.approx(0.5 * most, rel=1e-14)


@pytest.mark.parametrize("power", [-500.0, -3.0, 0.0, 1e-6, 4.0, 150.0, 199.9])
def test_current_is_the_smaller_root(power: float) -> None:
    flows = ask(Supply(voltage=20.0, series_resistance=0.5), power)
    root = min(np.roots([0.5, -20.0, power]).real)
    assert -flows.charge_rate == pytest.approx(root, rel=1e-9, abs=1e-12)  # numpy's root of small ones
    assert flows.supplied_power == pytest.approx(20.0 * root, rel=1e-9, abs=1e-11)


def test_supply_without_losses_gives_what_is_asked() -> None:
    for power in (-30.0, 0.0, 70.0):
        assert ask(Supply(voltage=24.0), power) == pytest.approx((-power / 24.0, 0.0, 0.0, 0.0, 0.0, power, 0.0))


def test_converter_loses_both_ways() -> None:
    supply = Supply(voltage=24.0, converter_efficiency=0.9)
    assert ask(supply, 90.0).supplied_power == pytest.approx(100.0, rel=1e-14)
    assert ask(supply, 90.0).converter_power == pytest.approx(10.0, rel=1e-13)
    assert ask(supply, -100.0).supplied_power == pytest.approx(-90.0, rel=1e-14)
    assert ask(supply, -100.0).converter_power == pytest.approx(10.0, rel=1e-13)


def test_energy_of_a_round_trip_through_capacitor_and_converter() -> None:
    # drawn through the efficiency, returned through it: what comes back of a round trip has it twice
    capacitor = Supercapacitor(capacitance=30.0, voltage=20.0, converter_efficiency=0.85)
    low = discharge(capacitor, 40.0, np.array([25.0]))[0]
    drawn = capacitor.energy(jnp.asarray(capacitor.charge0)) - capacitor.energy(jnp.asarray(low))
    assert float(drawn) == pytest.approx(40.0 * 25.0 / 0.85, rel=1e-7)  # of the integrator
    emptied = Supercapacitor(capacitance=30.0, voltage=low / 30.0, converter_efficiency=0.85)
    high = discharge(emptied, -40.0, np.array([25.0]))[0]
    taken = capacitor.energy(jnp.asarray(high)) - capacitor.energy(jnp.asarray(low))
    assert float(taken) == pytest.approx(0.85 * 40.0 * 25.0, rel=1e-7)


@pytest.mark.parametrize(
    "storage",
    [
        Supply(voltage=24.0, converter_efficiency=0.9, regenerative=False),
        Battery(3600.0, 25.2, 18.0, 0.1, converter_efficiency=0.9, regenerative=False),
        Supercapacitor(10.0, 20.0, 0.1, converter_efficiency=0.9, regenerative=False),
    ],
)
def test_not_regenerative_burns_what_comes_back(storage: Storage) -> None:
    flows = ask(storage, -35.0)
    assert flows.converter_power == pytest.approx(35.0, rel=1e-14)
    assert flows.charge_rate == 0.0
    assert ask(storage, 35.0).converter_power == pytest.approx(35.0 / 0.9 - 35.0, rel=1e-13)


def test_battery_of_constant_voltage_loses_its_charge_evenly() -> None:
    battery = Battery(7200.0, 24.0, 24.0, series_resistance=0.1, charge_share=0.9)
    current = (24.0 - math.sqrt(24.0**2 - 4.0 * 0.1 * 200.0)) / 0.2
    times = np.array([10.0, 300.0])
    assert discharge(battery, 200.0, times) == pytest.approx(6480.0 - current * times, rel=1e-9)


def test_ideal_battery_under_constant_power() -> None:
    # V_0 q + (V_1 - V_0) q^2/(2 Q) falls by P t
    battery = Battery(3600.0, 25.2, 18.0, charge_share=0.9)
    charge = discharge(battery, 60.0, np.array([400.0]))[0]
    slope = (25.2 - 18.0) / 3600.0
    energy = 18.0 * 3240.0 + 0.5 * slope * 3240.0**2 - 60.0 * 400.0
    assert charge == pytest.approx((math.sqrt(18.0**2 + 2.0 * slope * energy) - 18.0) / slope, rel=1e-8)


def test_battery_voltage_is_linear_in_the_charge() -> None:
    battery = Battery(3600.0, 25.2, 18.0)
    for share, voltage in ((0.0, 18.0), (0.5, 21.6), (1.0, 25.2)):
        assert float(battery.open_voltage(jnp.asarray(3600.0 * share))) == pytest.approx(voltage, rel=1e-14)


def test_full_storages_send_what_is_returned_to_the_brake_resistor() -> None:
    battery = Battery(3600.0, 25.2, 18.0, converter_efficiency=0.9)
    capacitor = Supercapacitor(10.0, 20.0, voltage_max=20.0, converter_efficiency=0.9)
    for storage, full in ((battery, 3600.0), (capacitor, 200.0)):
        assert ask(storage, -50.0, full).converter_power == pytest.approx(50.0, rel=1e-14)
        assert ask(storage, -50.0, full).charge_rate == 0.0
        assert ask(storage, -50.0, 0.995 * full).converter_power == pytest.approx(5.0 + 22.5, rel=1e-9)  # half of it
        assert ask(storage, -50.0, 0.99 * full).converter_power == pytest.approx(5.0, rel=1e-9)
        assert ask(storage, 50.0, full).shortfall == 0.0


def test_empty_storages_give_nothing() -> None:
    battery = Battery(3600.0, 25.2, 18.0, converter_efficiency=0.8)
    assert ask(battery, 40.0, 0.0).shortfall == pytest.approx(50.0, rel=1e-14)
    assert ask(battery, 40.0, 18.0).shortfall == pytest.approx(25.0, rel=1e-9)  # half of 1 % of the capacity
    for resistance in (0.0, 0.1):
        capacitor = Supercapacitor(10.0, 20.0, series_resistance=resistance)
        for charge in (0.0, -1e-6):
            flows = ask(capacitor, 40.0, charge)
            assert flows.shortfall == 40.0
            assert flows.charge_rate == 0.0
    # an empty capacitor takes a power through its resistance: R i^2 = P
    assert ask(Supercapacitor(10.0, 20.0, 0.1), -40.0, 0.0).charge_rate == pytest.approx(20.0, rel=1e-12)
    assert ask(Supercapacitor(10.0, 20.0), -40.0, 0.0).shortfall == -40.0


resistances = st.one_of(st.just(0.0), st.floats(1e-3, 2.0))
common: dict[str, Any] = {
    "series_resistance": resistances,
    "converter_efficiency": st.floats(0.5, 1.0),
    "regenerative": st.booleans(),
}
leaks = st.sampled_from([50.0, 9e3, math.inf])
storages = st.one_of(
    st.builds(Supply, voltage=st.floats(1.0, 60.0), **common),
    st.builds(
        Battery,
        capacity=st.floats(10.0, 1e5),
        voltage_full=st.floats(20.0, 60.0),
        voltage_empty=st.floats(1.0, 20.0),
        leakage_resistance=leaks,
        charge_share=st.one_of(st.floats(0.0, 1.0), st.floats(0.0, 0.02), st.floats(0.98, 1.0)),
        **common,
    ),
    st.builds(
        Supercapacitor,
        capacitance=st.floats(0.01, 500.0),
        voltage=st.one_of(st.just(0.0), st.floats(0.1, 50.0)),
        leakage_resistance=leaks,
        voltage_max=st.sampled_from([None, 20.0, 48.0]),
        **common,
    ),
)


@jax.jit
def compiled(storage: Storage, charge: jax.Array, power: jax.Array) -> StorageFlows:
    return storage.flows(charge, power)


@given(storages, st.floats(-2000.0, 2000.0))
def test_every_watt_has_a_name(storage: Storage, power: float) -> None:
    flows = compiled(jax.tree.map(jnp.asarray, storage), storage.charge0, power)
    lost = flows.series_power + flows.leakage_power + flows.converter_power
    left = float(power + lost + flows.stored_power - flows.supplied_power - flows.shortfall)
    # at the largest power the current, 2 P/(V + s), carries the root of a rounding error, but V i - R i^2 is flat there
    scale = abs(power) + float(lost) + abs(float(flows.stored_power)) + abs(float(flows.supplied_power))
    assert abs(left) <= 1e-13 * scale + 1e-300  # or denormal
    for loss in (flows.series_power, flows.leakage_power, flows.converter_power):
        assert float(loss) >= 0.0
    if power <= 0.0 and storage.charge0 != 0.0:
        assert float(flows.shortfall) == 0.0
    if not storage.regenerative:  # every storage has the field
        assert float(flows.stored_power) <= 0.0
        assert float(flows.supplied_power) >= 0.0


@jax.jit
def energy_slope(storage: Storage, charge: jax.Array) -> tuple[jax.Array, jax.Array]:
    return jax.grad(lambda q: storage.energy(q))(charge), storage.open_voltage(charge)


@given(storages, st.floats(0.001, 1.0))
def test_stored_power_is_the_rate_of_the_energy(storage: Storage, share: float) -> None:
    charge = share * (storage.charge0 or 1.0)
    slope, voltage = energy_slope(jax.tree.map(jnp.asarray, storage), charge)
    flows = compiled(jax.tree.map(jnp.asarray, storage), charge, 20.0)
    assert float(flows.stored_power) == pytest.approx(float(slope * flows.charge_rate), rel=1e-12, abs=1e-12)
    if not isinstance(storage, Supply):
        assert float(slope) == pytest.approx(float(voltage), rel=1e-12)  # rounding


@jax.jit
def gradient(storage: Storage, charge: jax.Array, power: jax.Array) -> Any:
    def total(storage: Storage, charge: jax.Array, power: jax.Array) -> jax.Array:
        return sum(storage.flows(charge, power), jnp.asarray(0.0))

    return jax.grad(total, argnums=(0, 1, 2))(storage, charge, power)


@pytest.mark.parametrize("power", [-60.0, 0.0, 60.0, 5e4])
@pytest.mark.parametrize("charge", [0.0, 100.0, 200.0])
@pytest.mark.parametrize("resistance", [0.0, 0.2])
def test_gradients_are_finite(power: float, charge: float, resistance: float) -> None:
    for storage in (
        Supply(24.0, resistance, converter_efficiency=0.9),
        Battery(200.0, 25.2, 18.0, resistance, converter_efficiency=0.9),
        Supercapacitor(10.0, 20.0, resistance, voltage_max=20.0, converter_efficiency=0.9),
    ):
        for leaf in jax.tree.leaves(gradient(jax.tree.map(jnp.asarray, storage), charge, power)):
            assert np.all(np.isfinite(leaf))


def test_gradient_of_the_current_is_that_of_the_root() -> None:
    # R i^2 - V i + P = 0  =>  di/dP = 1/(V - 2 R i)
    supply = Supply(20.0, 0.5)
    slope = jax.grad(lambda p: -supply.flows(jnp.asarray(0.0), p).charge_rate)(jnp.asarray(120.0))
    current = -ask(supply, 120.0).charge_rate
    assert float(slope) == pytest.approx(1.0 / (20.0 - current), rel=1e-12)


@pytest.mark.parametrize(
    "make, said",
    [
        (lambda: Supply(voltage=0.0), "voltage: is 0.0; allowed is a number above zero"),
        (lambda: Supply(series_resistance=-1.0), "series_resistance: is -1.0"),
        (lambda: Supply(converter_efficiency=1.2), "converter_efficiency: is 1.2"),
        (lambda: Supercapacitor(0.0, 20.0), "capacitance: is 0.0"),
        (lambda: Supercapacitor(10.0, -1.0), "voltage: is -1.0"),
        (lambda: Supercapacitor(10.0, 20.0, leakage_resistance=0.0), "leakage_resistance: is 0.0"),
        (lambda: Supercapacitor(10.0, math.inf), "voltage: is inf; allowed is a finite number"),
        (lambda: Battery(0.0, 25.0, 18.0), "capacity: is 0.0"),
        (lambda: Battery(10.0, 18.0, 25.0), "voltage_empty: is 25.0; allowed is at most 18.0"),
        (lambda: Battery(10.0, 25.0, 18.0, charge_share=1.1), "charge_share: is 1.1; allowed is at most 1.0"),
    ],
)
def test_a_storage_that_cannot_be_is_refused(make: Any, said: str) -> None:
    with pytest.raises(InputError) as caught:
        make()
    assert str(caught.value).startswith(said)


def test_capacitor_of_the_page() -> None:
    module = Supercapacitor(165.0, 48.0, series_resistance=6.3e-3, leakage_resistance=48.0 / 5.2e-3)
    left = discharge(module, 0.0, np.array([17.63 * 86400.0]))[0]
    assert left / module.charge0 == pytest.approx(math.exp(-1.0), rel=1e-3)  # days with four digits
    assert ask(module, 1e6).shortfall == pytest.approx(1e6 - 48.0**2 / (4.0 * 6.3e-3), rel=1e-12)


@pytest.mark.parametrize("margin, share", [(0.0, 0.0), (0.0025, 0.15625), (0.005, 0.5), (0.0075, 0.84375), (0.01, 1.0)])
def test_the_end_of_a_battery_fades_in_smoothly(margin: float, share: float) -> None:
    battery = Battery(3600.0, 25.2, 18.0)
    taken = ask(battery, -50.0, 3600.0 * (1.0 - margin))
    assert taken.stored_power == pytest.approx(50.0 * share, rel=1e-9, abs=1e-9)  # of 1 - margin
    assert ask(battery, 50.0, 3600.0 * margin).shortfall == pytest.approx(50.0 * (1.0 - share), rel=1e-9, abs=1e-9)
