"""Signals of a scenario file."""

from __future__ import annotations

from typing import Annotated, Literal

from pydantic import Field, model_validator

from varistiff.design.fields import Part, wrong
from varistiff.design.scenario_fields import (
    Angle,
    AnyNumber,
    NonNegativeTime,
    PositiveFrequency,
    PositiveMass,
    PositiveTime,
    SignalValue,
    Time,
)

_PARTS_MAX = 16

Zero = Annotated[SignalValue | None, Field(description="Without it zero")]


class ConstantSpec(Part):
    """One value for all time."""

    kind: Literal["constant"]
    value: SignalValue


class StepSpec(Part):
    """A jump; the new value holds from its instant on."""

    kind: Literal["step"]
    time: Time = Field(description="Instant of the jump")
    before: Zero = None
    after: SignalValue


class MinimumJerkSpec(Part):
    """From rest to rest with the least jerk."""

    kind: Literal["minimum_jerk"]
    start: Time
    duration: PositiveTime
    before: Zero = None
    after: SignalValue


class SineSpec(Part):
    """A harmonic signal for all time."""

    kind: Literal["sine"]
    offset: Zero = None
    amplitude: SignalValue = Field(description="Half of peak to peak")
    frequency: PositiveFrequency
    phase: Angle = Field(default=0.0, validate_default=False, description="At the time 0; without it zero")


class ChirpSpec(Part):
    """A sine whose frequency sweeps; it rests before and goes on at the last frequency afterwards."""

    kind: Literal["chirp"]
    start: Time = Field(default=0.0, validate_default=False, description="Of the sweep; without it 0 s")
    duration: PositiveTime = Field(description="Of the sweep")
    offset: Zero = None
    amplitude: SignalValue = Field(description="Half of peak to peak")
    first_frequency: PositiveFrequency
    last_frequency: PositiveFrequency
    sweep: Literal["linear", "logarithmic"] = "linear"


class PulseSpec(Part):
    """A blow: zero but for a short time."""

    kind: Literal["pulse"]
    start: Time
    duration: PositiveTime
    height: SignalValue
    shape: Literal["half_sine", "rectangle"] = "half_sine"


class TrajectorySpec(Part):
    """A column of a CSV file or of OpenSim's .sto or .mot over its column `time`."""

    kind: Literal["trajectory"]
    file: Annotated[str, Field(min_length=1, description="Relative to the scenario file")]
    column: Annotated[str, Field(min_length=1, description="Name without its unit")]
    sign: Literal["same", "opposite"] = Field(description="Whether the file counts the same direction positive")
    unit: Annotated[str, Field(min_length=1, description="Where the file states none, such as deg")] | None = None
    time_unit: Annotated[str, Field(min_length=1, description="Where a CSV file states none")] | None = None
    body_mass: PositiveMass | None = Field(default=None, description="For a column that is per body mass")
    scale: AnyNumber = Field(default=1.0, description="Multiplies the values; without it 1")
    start: Time = Field(default=0.0, validate_default=False, description="Added to the file's times; without it 0 s")
    periodic: bool = Field(default=False, description="The last value is the first of the next period")
    ends: Literal["not_a_knot", "natural", "at_rest"] = Field(
        default="not_a_knot", description="Of the spline; at_rest: with a rate of zero at both ends"
    )


class GaitSpec(Part):
    """The knee of healthy adults in level walking (Winter 1987), which repeats."""

    kind: Literal["gait"]
    joint: Literal["knee"]
    quantity: Literal["angle", "moment"] = Field(description="Flexion, or the moment that extends, per step")
    body_mass: PositiveMass | None = Field(default=None, description="Required for the moment")
    scale: AnyNumber = Field(default=1.0, description="Multiplies the values, -1 for the other direction; without it 1")
    start: NonNegativeTime = Field(default=0.0, validate_default=False, description="A heel contact; without it 0 s")

    @model_validator(mode="after")
    def _has_mass(self) -> GaitSpec:
        if (self.body_mass is None) == (self.quantity == "moment"):
            problem = (
                "is missing; a moment needs it" if self.body_mass is None else "is given for an angle; leave it out"
            )
            raise wrong(problem, field="body_mass")
        return self


class SumSpec(Part):
    """Signals added to one another."""

    kind: Literal["sum"]
    parts: Annotated[list[SignalSpec], Field(min_length=1, max_length=_PARTS_MAX, description="At most 16 signals")]


SignalSpec = Annotated[
    ConstantSpec | StepSpec | MinimumJerkSpec | SineSpec | ChirpSpec | PulseSpec | TrajectorySpec | GaitSpec | SumSpec,
    Field(discriminator="kind"),
]
AnySignalSpec = (
    ConstantSpec | StepSpec | MinimumJerkSpec | SineSpec | ChirpSpec | PulseSpec | TrajectorySpec | GaitSpec | SumSpec
)

SumSpec.model_rebuild()
