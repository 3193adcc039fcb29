"""Field types of a design file: quantities by kind and sign, and ranges."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Annotated, Any, Literal

from pydantic import BaseModel, ConfigDict, Field, GetCoreSchemaHandler, GetJsonSchemaHandler, model_validator
from pydantic_core import CoreSchema, PydanticCustomError, core_schema

from varistiff.core import quantity
from varistiff.core.errors import InputError
from varistiff.core.quantity import Kind
from varistiff.core.quantity_units import atoms
from varistiff.core.suggest import quoted

NUMBER_PATTERN = r"([0-9]+\.?[0-9]*|\.[0-9]+)([eE][-+]?[0-9]+)?\s*"
_ANY_UNIT = r"[A-Za-z\u00b5\u03bc\u00b0\u03a9\u2126].*"

Sign = Literal["any", "positive", "not negative"]


@dataclass(frozen=True, slots=True)
class QuantityOf:
    """Annotation of a float field that a file gives as text with a unit of one kind."""

    kind: Kind
    sign: Sign = "any"

    def parse(self, value: Any) -> float:
        """Return the SI value; raise what pydantic collects."""
        try:
            number = quantity.parse_quantity(value, self.kind)
        except InputError as error:
            raise wrong(error.problem) from None
        if (self.sign == "positive" and number <= 0.0) or (self.sign == "not negative" and number < 0.0):
            limit = "above zero" if self.sign == "positive" else "of zero or above"
            raise wrong(f"{quoted(value)} is not allowed; {self.kind.allowed(limit)}")
        return number

    def __get_pydantic_core_schema__(self, source: Any, handler: GetCoreSchemaHandler) -> CoreSchema:
        return core_schema.no_info_plain_validator_function(self.parse)

    def __get_pydantic_json_schema__(self, schema: CoreSchema, handler: GetJsonSchemaHandler) -> dict[str, Any]:
        limit = {"any": "", "positive": " above zero", "not negative": " of zero or above"}[self.sign]
        description = f"{self.kind.name}{limit} as text with a unit, for example {self.kind.example}"
        sign = "[-+]?" if self.sign == "any" else r"\+?"
        return {
            "type": "string",
            "description": description[0].upper() + description[1:],
            "pattern": rf"^\s*{sign}{NUMBER_PATTERN}({unit_pattern(self.kind)})\s*$",
            "examples": [self.kind.example],
        }


def unit_pattern(kind: Kind) -> str:
    """Return a pattern for the units of a kind: exactly its symbols where it is measured directly."""
    direct = [symbol for symbol, unit in atoms().items() if unit.signature in kind.signatures]
    simple = all(len(signature) == 1 and signature[0][1] == 1 for signature in kind.signatures)
    return "|".join(sorted(direct)) if simple else _ANY_UNIT


def wrong(problem: str, *, field: str | None = None) -> PydanticCustomError:
    """Return a validation error that already says what is wrong and what is allowed, in our words."""
    # the text travels in the context: pydantic formats the template, and braces in user text would upset it
    return PydanticCustomError("varistiff", "{problem}", {"problem": problem, "field": field or ""})


Length = Annotated[float, QuantityOf(quantity.LENGTH)]
PositiveLength = Annotated[float, QuantityOf(quantity.LENGTH, "positive")]
NonNegativeLength = Annotated[float, QuantityOf(quantity.LENGTH, "not negative")]
Angle = Annotated[float, QuantityOf(quantity.ANGLE)]
PositiveAngle = Annotated[float, QuantityOf(quantity.ANGLE, "positive")]
PositiveStress = Annotated[float, QuantityOf(quantity.STRESS, "positive")]
PositiveLinearStiffness = Annotated[float, QuantityOf(quantity.LINEAR_STIFFNESS, "positive")]
PositiveRotationalStiffness = Annotated[float, QuantityOf(quantity.ROTATIONAL_STIFFNESS, "positive")]


class Part(BaseModel):
    """A mapping of a design file; unknown fields are errors."""

    model_config = ConfigDict(extra="forbid", frozen=True, strict=True, allow_inf_nan=False)


class Range(Part):
    """Smallest and largest value of a map."""

    @model_validator(mode="after")
    def _ordered(self) -> Range:
        low, high = self.bounds
        if not low < high:
            raise wrong("min is not below max; allowed is min < max", field="min")
        return self

    @property
    def bounds(self) -> tuple[float, float]:
        """Smallest and largest value in SI units."""
        raise NotImplementedError


class AngleRange(Range):
    """Range of an angle."""

    min: Angle = Field(examples=["-10 deg"])
    max: Angle = Field(examples=["10 deg"])

    @property
    def bounds(self) -> tuple[float, float]:
        """Smallest and largest angle [rad]."""
        return self.min, self.max


class LengthRange(Range):
    """Range of a length that may have either sign."""

    min: Length = Field(examples=["-15 mm"])
    max: Length = Field(examples=["15 mm"])

    @property
    def bounds(self) -> tuple[float, float]:
        """Smallest and largest length [m]."""
        return self.min, self.max


class PositiveLengthRange(Range):
    """Range of a length that must be above zero."""

    min: PositiveLength = Field(examples=["20 mm"])
    max: PositiveLength = Field(examples=["60 mm"])

    @property
    def bounds(self) -> tuple[float, float]:
        """Smallest and largest length [m]."""
        return self.min, self.max
