"""The shipped knee cycle against its table, against other publications, and against what a knee does."""

from __future__ import annotations

import math
from importlib import resources
from pathlib import Path

import jax.numpy as jnp
import numpy as np
import pytest
import yaml

from varistiff.core.errors import InputError
from varistiff.dynamics.gait import KneeGait, knee_gait

CYCLE = 1.1396
PHASES = np.linspace(0.0, 1.0, 5001)


@pytest.fixture(scope="module")
def knee() -> KneeGait:
    return knee_gait()


@pytest.fixture(scope="module")
def power(knee: KneeGait) -> np.ndarray:
    return np.asarray(knee.power(jnp.asarray(PHASES * CYCLE)))


def table() -> np.ndarray:
    text = resources.files("varistiff.dynamics.gait").joinpath("knee_gait.yaml").read_text(encoding="utf-8")
    return np.array(yaml.safe_load(text)["rows"])


def test_the_cycle_passes_through_every_row_of_its_table(knee: KneeGait) -> None:
    rows = table()
    assert rows[:, 0] == pytest.approx(np.arange(0.0, 101.0, 2.0))
    times = jnp.asarray(rows[1:-1, 0] / 100.0 * CYCLE)
    np.testing.assert_allclose(knee.angle.at(times).value, np.radians(rows[1:-1, 1]), rtol=0.0, atol=1e-13)
    np.testing.assert_allclose(knee.extensor_moment.at(times).value, rows[1:-1, 2], rtol=0.0, atol=1e-13)
    contact = knee.angle.at(jnp.asarray(0.0)), knee.extensor_moment.at(jnp.asarray(CYCLE))
    assert float(contact[0].value) == pytest.approx(math.radians(0.5 * (3.97 + 2.21)))  # first and last row of the book
    assert float(contact[1].value) == pytest.approx(0.5 * (-0.196 - 0.147))


def test_the_table_is_typed_as_printed() -> None:
    # sums of the columns in another transcription of the book than the one that was typed: a slip in a digit shows
    rows = table()
    assert rows[:, 1].sum() == pytest.approx(1241.26, abs=0.005)
    assert rows[:, 2].sum() == pytest.approx(0.811, abs=0.0005)


def test_heel_contacts_repeat_and_may_be_moved(knee: KneeGait) -> None:
    moved = knee_gait(start=0.4)
    times = np.linspace(-2.0, 5.0, 101)
    for one, other in ((knee.angle, moved.angle), (knee.extensor_moment, moved.extensor_moment)):
        for part, same in zip(one.at(jnp.asarray(times)), other.at(jnp.asarray(times + 0.4 - 3 * CYCLE)), strict=True):
            np.testing.assert_allclose(part, same, rtol=0.0, atol=1e-9)  # rounding of a time times the third derivative
        assert one.breaks == ()


def test_landmarks_are_those_of_the_literature(knee: KneeGait) -> None:
    times = jnp.asarray(PHASES * CYCLE)
    degrees = np.degrees(knee.angle.at(times).value)
    moment = np.asarray(knee.extensor_moment.at(times).value)
    stance, swing = PHASES < 0.5, PHASES > 0.5
    # textbooks: 15 to 20 degrees in stance at 10 to 20 %, about 60 in swing at about 70 %, near straight at contact
    assert 15.0 < degrees[stance & (PHASES < 0.3)].max() < 23.0
    assert 0.10 < PHASES[stance][np.argmax(np.where(PHASES < 0.3, degrees, -1.0)[stance])] < 0.20
    assert 58.0 < degrees.max() < 67.0
    assert 0.68 < PHASES[np.argmax(degrees)] < 0.75
    assert degrees.min() > 0.0
    # Winter's extensor peak in weight acceptance, then a flexor moment about 40 %, and the 0.16 N m/kg before toe-off
    assert moment[stance].max() == pytest.approx(0.615, abs=0.003)
    assert 0.12 < PHASES[np.argmax(moment)] < 0.16
    assert moment[(PHASES > 0.3) & (PHASES < 0.5)].min() == pytest.approx(-0.272, abs=0.003)
    assert moment[swing & (PHASES < 0.7)].max() == pytest.approx(0.16, abs=0.005)


def test_power_agrees_with_another_publication(power: np.ndarray) -> None:
    # Schwartz et al. (2008), free speed, doi 10.1016/j.jbiomech.2008.03.015, means of their table: over the cycle the
    # knee brakes 63 % of the time and takes 0.150 W/kg net; -0.57 W/kg before toe-off, -0.98 W/kg at 92 %.
    # Those are children, and power is their mean of products, here it is the product of means: a fifth is allowed.
    assert np.mean(power < 0.0) == pytest.approx(0.63, abs=0.05)
    assert np.trapezoid(power, PHASES) == pytest.approx(-0.150, rel=0.2)
    late = (PHASES > 0.85) & (PHASES < 1.0)
    assert power[late].min() == pytest.approx(-0.98, rel=0.2)
    assert PHASES[late][np.argmin(power[late])] == pytest.approx(0.92, abs=0.02)
    # Winter's own mean of power before toe-off is -0.76 W/kg
    early = (PHASES > 0.5) & (PHASES < 0.75)
    assert power[early].min() == pytest.approx(-0.76, rel=0.2)


def test_the_energy_that_a_knee_brakes_away_is_the_published_one(power: np.ndarray) -> None:
    # Riemer and Shapiro (2011), doi 10.1186/1743-0003-8-22: 34 W could be had from both knees of a person of 80 kg at
    # about 4 km/h by braking with them; here 4.8 km/h, so somewhat more
    braked = -80.0 * 2.0 * np.trapezoid(np.minimum(power, 0.0), PHASES)
    assert 34.0 < braked < 1.25 * 34.0
    net = CYCLE * np.trapezoid(power, PHASES)
    assert -0.2 < net < -0.1  # J/kg a cycle, the range of both publications


def test_the_power_is_the_rate_of_work_of_the_moment(knee: KneeGait, power: np.ndarray) -> None:
    # work of the moment along the path, by Stieltjes sums over the angle: a sign would show
    times = jnp.asarray(PHASES * CYCLE)
    angle, moment = np.asarray(knee.angle.at(times).value), np.asarray(knee.extensor_moment.at(times).value)
    work = -np.sum(0.5 * (moment[1:] + moment[:-1]) * np.diff(angle))
    assert CYCLE * np.trapezoid(power, PHASES) == pytest.approx(work, rel=1e-5)  # both second order in 1/5000
    # weight acceptance: the knee flexes under an extensor moment, so it brakes
    loading = (PHASES > 0.06) & (PHASES < 0.13)
    assert np.all(power[loading] < 0.0)


def test_a_moment_in_newton_metres_needs_a_body(knee: KneeGait) -> None:
    time = jnp.asarray(0.14 * CYCLE)
    at, one = knee.moment(80.0).at(time), knee.extensor_moment.at(time)
    assert [float(part) for part in at] == pytest.approx([80.0 * float(part) for part in one])
    for mass in (0.0, -70.0, math.inf):
        with pytest.raises(InputError, match=r"^body_mass: "):
            knee.moment(mass)


def test_the_source_is_named(knee: KneeGait) -> None:
    assert "Winter 1987" in knee.source
    assert knee.cycle_duration == pytest.approx(120.0 / 105.3, abs=5e-5)  # the cadence, steps a minute
    assert knee.walking_speed == pytest.approx(1.325)


def test_the_page_prints_what_is_computed(root: Path, knee: KneeGait, power: np.ndarray) -> None:
    page = (root / "docs" / "theory" / "knee_in_gait.md").read_text(encoding="utf-8")
    angle, moment = (signal.at(jnp.asarray(PHASES * CYCLE)) for signal in (knee.angle, knee.extensor_moment))
    degrees, rate, value = np.degrees(angle.value), np.degrees(angle.rate), np.asarray(moment.value)

    def row(name: str, text: str, numbers: np.ndarray, first: float, last: float, sign: float = 1.0) -> str:
        inside = (first <= PHASES) & (last >= PHASES)
        place = int(np.argmax(np.where(inside, sign * numbers, -np.inf)))
        return f"| {name} | {100.0 * PHASES[place]:.0f} % | {text.format(numbers[place], abs(numbers[place]))} |"

    minus = "−{1:.2f} W/kg"
    net, braked = (CYCLE * np.trapezoid(part, PHASES) for part in (power, np.minimum(power, 0.0)))
    assert row("flexion in stance", "{:.1f}°", degrees, 0.0, 0.3) in page
    assert row("flexion in swing", "{:.1f}°", degrees, 0.5, 1.0) in page
    assert row("least flexion", "{:.1f}°", degrees, 0.5, 1.0, -1.0) in page
    assert f"{-rate.min():.0f} °/s, {rate.max():.0f} °/s" in page
    assert row("extensor moment, weight acceptance", "{:.3f} N m/kg", value, 0.0, 0.5) in page
    assert row("flexor moment, mid-stance", "{1:.3f} N m/kg", value, 0.3, 0.5, -1.0) in page
    assert row("extensor moment before toe-off", "{:.3f} N m/kg", value, 0.5, 0.7) in page
    assert row("power, weight acceptance", minus, power, 0.05, 0.14, -1.0) in page
    assert row("power before toe-off", minus, power, 0.5, 0.75, -1.0) in page
    assert row("power, end of swing", minus, power, 0.75, 0.99, -1.0) in page
    assert f"{-braked:.3f}, {net - braked:.3f}, −{-net:.3f} J/kg" in page
    assert f"| {100.0 * np.mean(power < 0.0):.0f} % |" in page
    assert f"net (here {-net / CYCLE:.3f})" in page
    assert f"brake with {-2.0 * 80.0 * braked / CYCLE:.0f} W" in page
