"""Field types of a scenario file: quantities of one of several kinds, plain numbers, and what a coordinate measures."""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import Annotated, Any, NamedTuple

from pydantic import GetCoreSchemaHandler, GetJsonSchemaHandler
from pydantic_core import CoreSchema, core_schema

from varistiff.core import quantity
from varistiff.core.errors import InputError
from varistiff.core.quantity import Kind
from varistiff.core.suggest import quoted
from varistiff.design.fields import NUMBER_PATTERN, QuantityOf, Sign, unit_pattern, wrong

SMALLEST = 1e-15  # magnitude in SI units; its inverse is the largest
PURE_NUMBER = Kind("a plain number", "0.5", "1", ())


class Amount(NamedTuple):
    """A quantity whose field takes several kinds; which one is meant follows from the joint.

    Parameters
    ----------
    value : in SI units
    kind : what its unit says that it is
    text : as the file has it
    """

    value: float
    kind: Kind
    text: str

    def of(self, kind: Kind, field: str) -> float:
        """SI value, after a check that it is of one kind.

        Raises
        ------
        InputError : it is of another one
        """
        if self.kind != kind:
            raise InputError(f"{quoted(self.text)} is {self.kind.name}; {kind.allowed()}", field=field)
        return self.value


@dataclass(frozen=True, slots=True)
class Measures:
    """Kinds of quantity that belong to a coordinate: an angle's or a length's."""

    word: str
    position: Kind
    rate: Kind
    load: Kind
    inertia: Kind
    stiffness: Kind
    stiffness_rate: Kind
    damping: Kind
    time_per_position: Kind


ROTARY = Measures(
    "turns",
    quantity.ANGLE,
    quantity.ANGULAR_RATE,
    quantity.TORQUE,
    quantity.MOMENT_OF_INERTIA,
    quantity.ROTATIONAL_STIFFNESS,
    quantity.ROTATIONAL_STIFFNESS_RATE,
    quantity.ROTATIONAL_DAMPING,
    quantity.TIME_PER_ANGLE,
)
LINEAR = Measures(
    "slides",
    quantity.LENGTH,
    quantity.VELOCITY,
    quantity.FORCE,
    quantity.MASS,
    quantity.LINEAR_STIFFNESS,
    quantity.LINEAR_STIFFNESS_RATE,
    quantity.LINEAR_DAMPING,
    quantity.TIME_PER_LENGTH,
)


def bounded(number: float, value: object) -> float:
    """Refuse a magnitude that no joint has, whose square or quotient a float may not even hold."""
    if number != 0.0 and not SMALLEST <= abs(number) <= 1.0 / SMALLEST:
        raise wrong(f"{quoted(value)} is no magnitude of a joint; allowed is from 1e-15 to 1e15 in SI units, or zero")
    return number


@dataclass(frozen=True, slots=True)
class Bounded:
    """Annotation of a float field that a file gives as text with a unit of one kind, neither tiny nor huge."""

    quantity: QuantityOf

    def parse(self, value: Any) -> float:
        """Return the SI value; raise what pydantic collects."""
        return bounded(self.quantity.parse(value), value)

    def __get_pydantic_core_schema__(self, source: Any, handler: GetCoreSchemaHandler) -> CoreSchema:
        return core_schema.no_info_plain_validator_function(self.parse)

    def __get_pydantic_json_schema__(self, schema: CoreSchema, handler: GetJsonSchemaHandler) -> dict[str, Any]:
        return self.quantity.__get_pydantic_json_schema__(schema, handler)


@dataclass(frozen=True, slots=True)
class QuantityOfOne:
    """Annotation of an ``Amount`` field that a file gives as text with a unit of one of several kinds."""

    kinds: tuple[Kind, ...]
    sign: Sign = "any"

    def parse(self, value: Any) -> Amount:
        """Return value and kind; raise what pydantic collects."""
        kind = quantity.kind_of(value, self.kinds)
        try:
            number = quantity.parse_quantity(value, kind or self.kinds[0])
        except InputError as error:
            raise wrong(error.problem.removesuffix(self.kinds[0].allowed()) + self.allowed()) from None
        if (self.sign == "positive" and number <= 0.0) or (self.sign == "not negative" and number < 0.0):
            raise wrong(f"{quoted(value)} is not allowed; {self.allowed()}")
        return Amount(bounded(number, value), kind or self.kinds[0], str(value))

    def allowed(self) -> str:
        """What is allowed, with examples."""
        limit = {"any": "", "positive": " above zero", "not negative": " of zero or above"}[self.sign]
        names, examples = ([getattr(kind, part) for kind in self.kinds] for part in ("name", "example"))
        listed = ", ".join(names[:-1]) + " or " * (len(names) > 1) + names[-1]
        return f"allowed is {listed}{limit}, for example {' or '.join(examples[:2])}"

    def __get_pydantic_core_schema__(self, source: Any, handler: GetCoreSchemaHandler) -> CoreSchema:
        return core_schema.no_info_plain_validator_function(self.parse)

    def __get_pydantic_json_schema__(self, schema: CoreSchema, handler: GetJsonSchemaHandler) -> dict[str, Any]:
        units = "|".join(dict.fromkeys(unit_pattern(kind) for kind in self.kinds))
        sign = "[-+]?" if self.sign == "any" else r"\+?"
        description = self.allowed().removeprefix("allowed is ")
        return {
            "type": "string",
            "description": description[0].upper() + description[1:],
            "pattern": rf"^\s*{sign}{NUMBER_PATTERN}({units})\s*$",
            "examples": [kind.example for kind in self.kinds],
        }


@dataclass(frozen=True, slots=True)
class NumberOf:
    """Annotation of a plain number.

    Parameters
    ----------
    text : what is allowed, as messages say it
    low, high : bounds, both allowed
    above : bound that is not allowed itself
    whole : whether only whole numbers are allowed
    """

    text: str
    low: float = -math.inf
    high: float = math.inf
    above: float = -math.inf
    whole: bool = False

    def parse(self, value: Any) -> float:
        """Return the number; raise what pydantic collects."""
        is_number = isinstance(value, int if self.whole else int | float) and not isinstance(value, bool)
        # compared as they are: a whole number may be too large for a float
        if (
            not is_number
            or not (self.low <= value <= self.high and value > self.above)
            or value in (math.inf, -math.inf)
        ):
            raise wrong(f"is {quoted(value)}; allowed is {self.text}")
        return value if self.whole else bounded(float(value), value)

    def __get_pydantic_core_schema__(self, source: Any, handler: GetCoreSchemaHandler) -> CoreSchema:
        return core_schema.no_info_plain_validator_function(self.parse)

    def __get_pydantic_json_schema__(self, schema: CoreSchema, handler: GetJsonSchemaHandler) -> dict[str, Any]:
        bounds = {"minimum": self.low, "maximum": self.high, "exclusiveMinimum": self.above}
        finite = {word: bound for word, bound in bounds.items() if math.isfinite(bound)}
        kind = "integer" if self.whole else "number"
        return {"type": kind, "description": self.text[0].upper() + self.text[1:], **finite}


@dataclass(frozen=True, slots=True)
class SlopeOfLine:
    """Annotation of the slope of a straight line of an angle: a length per angle, or a plain number; not zero."""

    def parse(self, value: Any) -> Amount:
        """Return value and kind; raise what pydantic collects."""
        if isinstance(value, int | float) and not isinstance(value, bool):
            slope = Amount(NumberOf("a finite number").parse(value), PURE_NUMBER, repr(value))
        else:
            slope = QuantityOfOne((quantity.LENGTH_PER_ANGLE,)).parse(value)
        if slope.value == 0.0:
            raise wrong("is zero; allowed is any other slope")
        return slope

    def __get_pydantic_core_schema__(self, source: Any, handler: GetCoreSchemaHandler) -> CoreSchema:
        return core_schema.no_info_plain_validator_function(self.parse)

    def __get_pydantic_json_schema__(self, schema: CoreSchema, handler: GetJsonSchemaHandler) -> dict[str, Any]:
        length = QuantityOfOne((quantity.LENGTH_PER_ANGLE,)).__get_pydantic_json_schema__(schema, handler)
        return {"anyOf": [length, {"type": "number"}]}


@dataclass(frozen=True, slots=True)
class DelayOf:
    """Annotation of a delay: a time with its unit, or a whole number of periods."""

    periods_max: int = 100

    def parse(self, value: Any) -> float | int:
        """Return seconds as a float or periods as a whole number; raise what pydantic collects."""
        if isinstance(value, int) and not isinstance(value, bool):
            if not 0 <= value <= self.periods_max:
                raise wrong(f"is {quoted(value)}; allowed is a whole number of periods from 0 to {self.periods_max}")
            return value
        try:
            seconds = quantity.parse_quantity(value, quantity.TIME)
        except InputError as error:
            raise wrong(f"{error.problem}, or a whole number of periods") from None
        if bounded(seconds, value) < 0.0:
            raise wrong(f"{quoted(value)} is not allowed; {quantity.TIME.allowed('of zero or above')}")
        return seconds

    def __get_pydantic_core_schema__(self, source: Any, handler: GetCoreSchemaHandler) -> CoreSchema:
        return core_schema.no_info_plain_validator_function(self.parse)

    def __get_pydantic_json_schema__(self, schema: CoreSchema, handler: GetJsonSchemaHandler) -> dict[str, Any]:
        time = QuantityOf(quantity.TIME, "not negative").__get_pydantic_json_schema__(schema, handler)
        return {"anyOf": [time, {"type": "integer", "minimum": 0, "maximum": self.periods_max}]}


_POSITION = (quantity.ANGLE, quantity.LENGTH)
_RATE = (quantity.ANGULAR_RATE, quantity.VELOCITY)
_LOAD = (quantity.TORQUE, quantity.FORCE)
_STIFFNESS = (quantity.ROTATIONAL_STIFFNESS, quantity.LINEAR_STIFFNESS)
_STIFFNESS_RATE = (quantity.ROTATIONAL_STIFFNESS_RATE, quantity.LINEAR_STIFFNESS_RATE)
_DAMPING = (quantity.ROTATIONAL_DAMPING, quantity.LINEAR_DAMPING)
_TIME_PER_POSITION = (quantity.TIME_PER_ANGLE, quantity.TIME_PER_LENGTH)

Position = Annotated[Amount, QuantityOfOne(_POSITION)]
PositivePosition = Annotated[Amount, QuantityOfOne(_POSITION, "positive")]
Rate = Annotated[Amount, QuantityOfOne(_RATE)]
PositiveRate = Annotated[Amount, QuantityOfOne(_RATE, "positive")]
PositiveLoad = Annotated[Amount, QuantityOfOne(_LOAD, "positive")]
PositiveStiffness = Annotated[Amount, QuantityOfOne(_STIFFNESS, "positive")]
NonNegativeStiffness = Annotated[Amount, QuantityOfOne(_STIFFNESS, "not negative")]
NonNegativeStiffnessRate = Annotated[Amount, QuantityOfOne(_STIFFNESS_RATE, "not negative")]
NonNegativeDamping = Annotated[Amount, QuantityOfOne(_DAMPING, "not negative")]
NonNegativeTimePerPosition = Annotated[Amount, QuantityOfOne(_TIME_PER_POSITION, "not negative")]
SignalValue = Annotated[Amount, QuantityOfOne((*_POSITION, *_LOAD, *_STIFFNESS))]
LineSlope = Annotated[Amount, SlopeOfLine()]
Delay = Annotated[float | int, DelayOf()]

Angle = Annotated[float, Bounded(QuantityOf(quantity.ANGLE))]
Length = Annotated[float, Bounded(QuantityOf(quantity.LENGTH))]
PositiveLength = Annotated[float, Bounded(QuantityOf(quantity.LENGTH, "positive"))]
Time = Annotated[float, Bounded(QuantityOf(quantity.TIME))]
PositiveTime = Annotated[float, Bounded(QuantityOf(quantity.TIME, "positive"))]
NonNegativeTime = Annotated[float, Bounded(QuantityOf(quantity.TIME, "not negative"))]
PositiveFrequency = Annotated[float, Bounded(QuantityOf(quantity.FREQUENCY, "positive"))]
PositiveMass = Annotated[float, Bounded(QuantityOf(quantity.MASS, "positive"))]
PositiveInertia = Annotated[float, Bounded(QuantityOf(quantity.MOMENT_OF_INERTIA, "positive"))]
NonNegativeInertia = Annotated[float, Bounded(QuantityOf(quantity.MOMENT_OF_INERTIA, "not negative"))]
PositiveVoltage = Annotated[float, Bounded(QuantityOf(quantity.VOLTAGE, "positive"))]
NonNegativeVoltage = Annotated[float, Bounded(QuantityOf(quantity.VOLTAGE, "not negative"))]
PositiveCurrent = Annotated[float, Bounded(QuantityOf(quantity.CURRENT, "positive"))]
NonNegativeCurrent = Annotated[float, Bounded(QuantityOf(quantity.CURRENT, "not negative"))]
PositiveResistance = Annotated[float, Bounded(QuantityOf(quantity.RESISTANCE, "positive"))]
NonNegativeResistance = Annotated[float, Bounded(QuantityOf(quantity.RESISTANCE, "not negative"))]
PositiveCapacitance = Annotated[float, Bounded(QuantityOf(quantity.CAPACITANCE, "positive"))]
PositiveCharge = Annotated[float, Bounded(QuantityOf(quantity.CHARGE, "positive"))]
PositiveTorqueConstant = Annotated[float, Bounded(QuantityOf(quantity.TORQUE_CONSTANT, "positive"))]
PositiveThermalResistance = Annotated[float, Bounded(QuantityOf(quantity.THERMAL_RESISTANCE, "positive"))]
PositiveTemperatureDifference = Annotated[float, Bounded(QuantityOf(quantity.TEMPERATURE_DIFFERENCE, "positive"))]
NonNegativePerTemperature = Annotated[float, Bounded(QuantityOf(quantity.PER_TEMPERATURE, "not negative"))]
NonNegativePerTime = Annotated[float, Bounded(QuantityOf(quantity.PER_TIME, "not negative"))]
NonNegativeRotationalDamping = Annotated[float, Bounded(QuantityOf(quantity.ROTATIONAL_DAMPING, "not negative"))]

AnyNumber = Annotated[float, NumberOf("a finite number")]
NonNegativeNumber = Annotated[float, NumberOf("a number of zero or above", low=0.0)]
PositiveNumber = Annotated[float, NumberOf("a number above zero", above=0.0)]
Efficiency = Annotated[float, NumberOf("a number above 0 and up to 1", above=0.0, high=1.0)]
Share = Annotated[float, NumberOf("a number from 0 to 1", low=0.0, high=1.0)]
Every = Annotated[int, NumberOf("a whole number from 1 to 10000", low=1, high=10000, whole=True)]
Nodes = Annotated[int, NumberOf("a whole number from 2 to 257", low=2, high=257, whole=True)]
