"""Quantities: text with a unit of the right kind, and nothing else."""

from __future__ import annotations

import math
import subprocess
import sys
import time
from fractions import Fraction

import pint
import pytest
from hypothesis import given
from hypothesis import strategies as st

from varistiff.core import quantity
from varistiff.core.errors import InputError
from varistiff.core.quantity import KINDS, Kind, parse_quantity
from varistiff.core.quantity_units import atoms


@pytest.mark.parametrize(
    "text, kind, value",
    [
        ("25.45 mm", quantity.LENGTH, 0.02545),
        ("0.90 m", quantity.LENGTH, 0.9),
        ("1.94e11 Pa", quantity.STRESS, 194e9),
        ("194 GPa", quantity.STRESS, 194e9),
        ("3 kN/mm²", quantity.STRESS, 3e9),
        ("5 N/mm2", quantity.STRESS, 5e6),
        ("180 deg", quantity.ANGLE, math.pi),
        ("-10deg", quantity.ANGLE, -math.pi / 18.0),
        ("\u22122 mm", quantity.LENGTH, -0.002),
        ("+.5 µm", quantity.LENGTH, 5e-7),
        ("1 in", quantity.LENGTH, 0.0254),
        ("650 N*m/rad", quantity.ROTATIONAL_STIFFNESS, 650.0),
        ("1 N*m/deg", quantity.ROTATIONAL_STIFFNESS, 180.0 / math.pi),
        ("2 N m rad^-1", quantity.ROTATIONAL_STIFFNESS, 2.0),
        ("394 N/m", quantity.LINEAR_STIFFNESS, 394.0),
        ("2 N/mm", quantity.LINEAR_STIFFNESS, 2000.0),
        ("1.5 Nm", quantity.TORQUE, 1.5),
        ("3 J/rad", quantity.TORQUE, 3.0),
        ("60 rpm", quantity.ANGULAR_RATE, 2.0 * math.pi),
        ("7.85 g/cm^3", quantity.DENSITY, 7850.0),
        ("92.5 g*cm^2", quantity.MOMENT_OF_INERTIA, 9.25e-6),
        ("0.18 N*m*s/deg", quantity.ROTATIONAL_DAMPING, 32.4 / math.pi),
        ("2 J*s/rad^2", quantity.ROTATIONAL_DAMPING, 2.0),
        ("3 N*s/mm", quantity.LINEAR_DAMPING, 3000.0),
        ("20 s^-1", quantity.PER_TIME, 20.0),
        ("5 N*m/rad/s", quantity.ROTATIONAL_STIFFNESS_RATE, 5.0),
        ("5 N/mm/s", quantity.LINEAR_STIFFNESS_RATE, 5000.0),
        ("180 mm/s", quantity.VELOCITY, 0.18),
        ("9 mm/deg", quantity.LENGTH_PER_ANGLE, 1.62 / math.pi),
        ("0.1 s/rad", quantity.TIME_PER_ANGLE, 0.1),
        ("0.1 s/mm", quantity.TIME_PER_LENGTH, 100.0),
        ("48 V", quantity.VOLTAGE, 48.0),
        ("750 mA", quantity.CURRENT, 0.75),
        ("299 mohm", quantity.RESISTANCE, 0.299),
        ("2.2 k\u03a9", quantity.RESISTANCE, 2200.0),
        ("3 V/A", quantity.RESISTANCE, 3.0),
        ("470 \u00b5F", quantity.CAPACITANCE, 4.7e-4),
        ("2 Ah", quantity.CHARGE, 7200.0),
        ("3 A*h", quantity.CHARGE, 10800.0),
        ("70 W", quantity.POWER, 70.0),
        ("6 J/s", quantity.POWER, 6.0),
        ("30.2 mNm/A", quantity.TORQUE_CONSTANT, 0.0302),
        ("130 K", quantity.TEMPERATURE_DIFFERENCE, 130.0),
        ("4.57 K/W", quantity.THERMAL_RESISTANCE, 4.57),
    ],
)
def test_a_quantity_becomes_its_si_value(text: str, kind: Kind, value: float) -> None:
    # one rounding on each side
    assert parse_quantity(text, kind) == pytest.approx(value, rel=3e-16)


@pytest.mark.parametrize(
    "text, kind, said",
    [
        ("1 J", quantity.TORQUE, "is an energy"),
        ("1 N*m", quantity.ENERGY, "is a torque"),
        ("1 Hz", quantity.ANGULAR_RATE, "is a frequency"),
        ("1 rad/s", quantity.FREQUENCY, "is an angular rate"),
        ("1 N*m", quantity.ROTATIONAL_STIFFNESS, "is a torque"),
        ("1 N*m/rad", quantity.TORQUE, "is a rotational stiffness"),
        ("1 N/m", quantity.STRESS, "is a linear stiffness"),
        ("1 mm/mm", quantity.ANGLE, "is a pure number"),
        ("1 deg", quantity.LENGTH, "is an angle"),
        ("1 kg", quantity.FORCE, "is a mass"),
        ("1 m/s^2", quantity.LENGTH, "of another kind"),
        ("1 m/s", quantity.ANGULAR_RATE, "is a velocity"),
        ("1 kg", quantity.MOMENT_OF_INERTIA, "is a mass"),
        ("1 N*m*s", quantity.ROTATIONAL_DAMPING, "of another kind"),
        ("1 N*s/m", quantity.ROTATIONAL_DAMPING, "is a linear damping"),
        ("1 N*m/rad", quantity.ROTATIONAL_STIFFNESS_RATE, "is a rotational stiffness"),
        ("1 mm/rad", quantity.LENGTH, "is a length per angle"),
        ("1 C", quantity.CAPACITANCE, "is a charge"),
        ("1 Wh", quantity.POWER, "is an energy"),
        ("1 W*s", quantity.ENERGY, "of another kind"),
        ("1 V", quantity.CURRENT, "is a voltage"),
        ("1 N*m", quantity.TORQUE_CONSTANT, "is a torque"),
        ("1 degC", quantity.TEMPERATURE_DIFFERENCE, "unknown unit"),
        ("1 MV", quantity.VOLTAGE, 'did you mean "mV"'),
        ("1 mPa", quantity.STRESS, 'did you mean "MPa"'),
        ("1 Mm", quantity.LENGTH, 'did you mean "mm"'),
        ("1 dimensionless", quantity.ANGLE, "unknown unit"),
        ("1 percent", quantity.ANGLE, "unknown unit"),
        ("1 nan", quantity.LENGTH, "unknown unit"),
        ("2 rads", quantity.ANGLE, 'did you mean "rad"'),
        ("1 N per mm", quantity.LINEAR_STIFFNESS, "unknown unit"),
        ("1 m squared", quantity.LENGTH, "unknown unit"),
        ("1 2*mm", quantity.LENGTH, "cannot read the unit"),
        ("1 [length]", quantity.LENGTH, "cannot read the unit"),
        ("1 m^0", quantity.LENGTH, "is a pure number"),
        ("1 m^5", quantity.LENGTH, "power beyond 4"),
        ("20 degC", quantity.ANGLE, "unknown unit"),
        ("3 %", quantity.LENGTH, "cannot read the unit"),
        ("0.9", quantity.LENGTH, "has no unit"),
        ("1e3", quantity.LENGTH, "has no unit"),
        (0.9, quantity.LENGTH, "has no unit"),
        (0, quantity.ANGLE, "has no unit"),
        (True, quantity.LENGTH, "is true"),
        (None, quantity.LENGTH, "is nothing"),
        (["1 mm"], quantity.LENGTH, "is a list"),
        ("", quantity.LENGTH, "is empty"),
        ("nan mm", quantity.LENGTH, "not a finite number"),
        ("-inf mm", quantity.LENGTH, "not a finite number"),
        (math.nan, quantity.LENGTH, "not a finite number"),
        ("1e400 mm", quantity.LENGTH, "not finite"),
        ("1e308 GPa", quantity.STRESS, "not finite"),
        ("25,4 mm", quantity.LENGTH, "decimal comma"),
        ("mm", quantity.LENGTH, "does not begin with a number"),
        ("1_000 mm", quantity.LENGTH, "cannot read the unit"),
        ("٣ mm", quantity.LENGTH, "does not begin with a number"),
        ("1 mm; 2 mm", quantity.LENGTH, "cannot read the unit"),
        ("1 N**m", quantity.TORQUE, "cannot read the unit"),
        ("1 (mm)", quantity.LENGTH, "cannot read the unit"),
        ("1 mm*", quantity.LENGTH, "cannot read the unit"),
    ],
)
def test_anything_else_is_refused_with_an_example(text: object, kind: Kind, said: str) -> None:
    with pytest.raises(InputError) as caught:
        parse_quantity(text, kind)
    assert said in str(caught.value)
    assert kind.name in str(caught.value)
    assert kind.example in str(caught.value)


@pytest.mark.parametrize(
    "text",
    ["9**9**9 mm", "1e999999999 mm", "1 m^999999999", "1 m**9999", "1" * 10**6 + " mm", "1 " + "m*" * 10**6 + "m"],
)
def test_nothing_is_evaluated(text: str) -> None:
    start = time.perf_counter()
    with pytest.raises(InputError) as caught:
        parse_quantity(text, quantity.LENGTH)
    assert time.perf_counter() - start < 0.5  # 10**999999999 alone would take minutes
    assert len(str(caught.value)) < 250


@pytest.mark.parametrize("kind", KINDS, ids=lambda kind: kind.name)
def test_the_example_of_a_kind_is_of_no_other_kind(kind: Kind) -> None:
    assert [other.name for other in KINDS if quantity.kind_of(kind.example, (other,))] == [kind.name]


def parsed(text: str, kind: Kind) -> tuple[float, str]:
    """The value, or the line that refuses it; any other exception goes through."""
    try:
        return parse_quantity(text, kind), ""
    except InputError as error:
        return 0.0, str(error)


NUMBERS = st.floats(allow_nan=False, allow_infinity=False, min_value=-1e200, max_value=1e200)


@given(NUMBERS)
def test_a_number_in_si_units_comes_back_exactly(number: float) -> None:
    assert parse_quantity(f"{number!r} m", quantity.LENGTH) == number


@given(st.integers(min_value=-(10**17), max_value=10**17))
def test_the_unit_does_not_change_the_value(micrometres: int) -> None:
    """Exactly: the hash of a design must not see in which unit a length was written."""
    texts = (f"{micrometres}e-6 m", f"{micrometres}e-3 mm", f"{micrometres}e-4 cm", f"{micrometres} um")
    assert len({parse_quantity(text, quantity.LENGTH) for text in texts}) == 1


@given(st.text(max_size=60), st.sampled_from(KINDS))
def test_any_text_gives_a_finite_number_or_one_line(text: str, kind: Kind) -> None:
    number, line = parsed(text, kind)
    assert math.isfinite(number)
    assert line.isprintable()
    assert len(line) < 250


@given(st.text(alphabet="0123456789.eE+-*/^ mNradgPJ²", max_size=30), st.sampled_from(KINDS))
def test_text_that_looks_like_a_quantity_does_no_harm(text: str, kind: Kind) -> None:
    number, line = parsed(text, kind)
    assert math.isfinite(number)
    assert line.isprintable()


@pytest.mark.parametrize(
    ("symbol", "factor"),
    [
        # legal definitions: international yard and pound 1959, standard gravity CGPM 1901, SI Brochure table 8
        ("in", "0.0254"),
        ("ft", "0.3048"),
        ("lb", "0.45359237"),
        ("kgf", "9.80665"),
        ("lbf", "4.4482216152605"),
        ("psi", Fraction("4.4482216152605") / Fraction("0.00064516")),
        ("ksi", Fraction("4448.2216152605") / Fraction("0.00064516")),
        ("bar", 100000),
        ("l", "0.001"),
        ("t", 1000),
        ("h", 3600),
        ("Wh", 3600),
        ("kNm", 1000),
        ("Nmm", "0.001"),
        ("µm", "0.000001"),
        ("Ah", 3600),
        ("\u2126", 1),
    ],
)
def test_a_defined_unit_has_exactly_its_factor(symbol: str, factor: str | int | Fraction) -> None:
    assert atoms()[symbol].factor == Fraction(factor)


def test_a_quantity_is_rounded_once() -> None:
    assert parse_quantity("25.4 mm", quantity.LENGTH) == 0.0254  # 25.4 * 1e-3 is 0.025399999999999999
    assert parse_quantity("360 deg", quantity.ANGLE) == 2.0 * math.pi
    assert parse_quantity("180 deg", quantity.ANGLE) == parse_quantity("0.5 turn", quantity.ANGLE) == math.pi


def test_every_unit_agrees_with_the_default_table_of_pint() -> None:
    registry = pint.UnitRegistry()
    base = {
        "length": "m",
        "angle": "rad",
        "force": "N",
        "mass": "kg",
        "time": "s",
        "pressure": "Pa",
        "energy": "J",
        "frequency": "Hz",
        "voltage": "V",
        "current": "A",
        "resistance": "ohm",
        "capacitance": "F",
        "charge": "C",
        "power": "W",
        "temperature": "K",
    }
    other_names = {"Nm": "N*m", "Nmm": "N*mm", "lb": "pound", "L": "liter", "rev": "turn", "h": "hour"}
    assert len(atoms()) > 80
    for symbol, unit in atoms().items():
        name = other_names.get(symbol, symbol).replace("\u03a9", "ohm").replace("\u2126", "ohm")
        if symbol.endswith("Nm"):
            name = f"{symbol[:-1]}*m"
        expected = registry.Quantity(1.0, name)
        si = registry.Quantity(1.0, "*".join(f"{base[measure]}**{power}" for measure, power in unit.signature))
        # a few roundings of doubles in the other table
        assert float(unit.factor) == pytest.approx((expected / si).to_base_units().magnitude, rel=1e-14), symbol


def test_pint_waits_for_the_first_quantity() -> None:
    script = (
        "import sys; from varistiff.core import quantity; assert not {'pint', 'numpy'} & set(sys.modules)\n"
        "quantity.parse_quantity('1 mm', quantity.LENGTH); assert 'pint' in sys.modules\n"
    )
    subprocess.run([sys.executable, "-c", script], check=True)
