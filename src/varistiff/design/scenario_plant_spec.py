"""The plant of a scenario file: link, drives with their transmissions, carried mass, stops and storage."""

from __future__ import annotations

from typing import Annotated, Any, Literal

from pydantic import Discriminator, Field, Tag, model_validator

from varistiff.design.fields import Part, wrong
from varistiff.design.scenario_fields import (
    Angle,
    Efficiency,
    Length,
    LineSlope,
    NonNegativeCurrent,
    NonNegativeDamping,
    NonNegativeInertia,
    NonNegativePerTemperature,
    NonNegativeResistance,
    NonNegativeRotationalDamping,
    NonNegativeTimePerPosition,
    NonNegativeVoltage,
    Position,
    PositiveCapacitance,
    PositiveCharge,
    PositiveCurrent,
    PositiveInertia,
    PositiveLength,
    PositiveLoad,
    PositiveMass,
    PositiveNumber,
    PositivePosition,
    PositiveRate,
    PositiveResistance,
    PositiveStiffness,
    PositiveTemperatureDifference,
    PositiveThermalResistance,
    PositiveTime,
    PositiveTorqueConstant,
    PositiveVoltage,
    Share,
)
from varistiff.design.scenario_signal_spec import SignalSpec

NoLoss = Annotated[Efficiency, Field(description="Above 0 and up to 1; without it 1")]


class DryFrictionSpec(Part):
    """Coulomb friction with a Stribeck peak, smooth through rest."""

    coulomb: PositiveLoad = Field(description="While it moves")
    breakaway: PositiveLoad | None = Field(default=None, description="At rest; without it as coulomb")
    stribeck_rate: PositiveRate | None = Field(default=None, description="Of the fall between them; without it 0.1 SI")
    smoothing_rate: PositiveRate | None = Field(
        default=None, description="Below it friction fades to zero; without it 0.01 SI"
    )

    @model_validator(mode="after")
    def _peak(self) -> DryFrictionSpec:
        if self.breakaway is not None and self.breakaway.value < self.coulomb.value:
            raise wrong("is below coulomb; allowed is coulomb or more", field="breakaway")
        return self


class StopsSpec(Part):
    """Compliant stops at one or both ends of a travel, with the damping of Hunt and Crossley."""

    min: Position | None = Field(default=None, description="Lower end; without it open")
    max: Position | None = Field(default=None, description="Upper end; without it open")
    stiffness: PositiveStiffness
    damping: NonNegativeTimePerPosition | None = Field(
        default=None, description="Of the force relative to the elastic one, per closing speed; without it zero"
    )

    @model_validator(mode="after")
    def _ordered(self) -> StopsSpec:
        if self.min is None and self.max is None:
            raise wrong("neither min nor max is given; allowed is one of them or both", field="")
        low, high = self.min, self.max
        if low is not None and high is not None and low.kind == high.kind and not low.value < high.value:
            raise wrong("min is not below max; allowed is min < max", field="min")
        return self


class GravitySpec(Part):
    """Weight of a link that swings about a horizontal axis."""

    mass: PositiveMass
    centre_of_mass: PositiveLength = Field(description="From the axis")
    rest: Angle = Field(
        default=0.0, validate_default=False, description="Link angle in which it hangs; without it zero"
    )


class LinkSpec(Part):
    """The link: the output side."""

    inertia: PositiveInertia | None = Field(default=None, description="About the joint; of a joint, required")
    mass: PositiveMass | None = Field(default=None, description="Of a linear device, required")
    viscous_friction: NonNegativeDamping | None = None
    dry_friction: DryFrictionSpec | None = None
    stops: StopsSpec | None = None
    gravity: GravitySpec | None = Field(default=None, description="Of a joint")
    motion: Literal["free", "locked", "prescribed"] = Field(
        default="free", description="locked: it stays where it starts; prescribed: it follows `signal`"
    )
    signal: SignalSpec | None = Field(default=None, description="Position over time of a prescribed link")

    @model_validator(mode="after")
    def _consistent(self) -> LinkSpec:
        if self.motion == "prescribed" and self.signal is None:
            raise wrong("is missing; a prescribed link needs it", field="signal")
        if self.motion != "prescribed" and self.signal is not None:
            raise wrong(f"is given, but motion is {self.motion}; allowed only with prescribed", field="signal")
        return self


class HeatingSpec(Part):
    """Winding and housing, each one temperature, as a data sheet has them."""

    winding_resistance: PositiveThermalResistance = Field(description="From winding to housing")
    housing_resistance: PositiveThermalResistance = Field(description="From housing to ambient")
    winding_time: PositiveTime = Field(description="Thermal time constant of the winding")
    motor_time: PositiveTime = Field(description="Thermal time constant of the motor")
    rise_limit: PositiveTemperatureDifference = Field(description="Of the winding above ambient")


class MotorSpec(Part):
    """A data sheet of your own."""

    torque_constant: PositiveTorqueConstant
    resistance: PositiveResistance = Field(description="Of the winding; of a brushless motor between two phases")
    rotor_inertia: PositiveInertia
    no_load_current: NonNegativeCurrent = Field(
        default=0.0, validate_default=False, description="Its torque is the friction of the rotor; without it zero"
    )
    viscous_friction: NonNegativeRotationalDamping = Field(
        default=0.0, validate_default=False, description="Of the rotor; without it zero"
    )
    resistance_coefficient: NonNegativePerTemperature = Field(
        default=0.0, validate_default=False, description="Of the winding, 0.00393 K^-1 for copper; without it zero"
    )
    heating: HeatingSpec | None = None


def _is_named(value: Any) -> str:
    return "data" if isinstance(value, dict | MotorSpec) else "name"


Motor = Annotated[
    Annotated[Annotated[str, Field(min_length=1, description="Name in the table of motors")], Tag("name")]
    | Annotated[MotorSpec, Tag("data")],
    Discriminator(_is_named),
]


class DriveSpec(Part):
    """A motor with its gear, or without `motor` an ideal source of torque or force."""

    motor: Motor | None = None
    gear_ratio: PositiveNumber | None = Field(default=None, description="Turns of the motor per turn; without it 1")
    gear_efficiency: Efficiency | None = Field(default=None, description="Without it 1")
    gear_inertia: NonNegativeInertia | None = Field(default=None, description="Of the gear, seen at the rotor")
    current_limit: PositiveCurrent | None = Field(
        default=None, description="Without it what a motor of the table bears continuously"
    )
    voltage_limit: PositiveVoltage | None = Field(
        default=None, description="Without it the nominal voltage of a motor of the table"
    )
    torque_limit: PositiveLoad | None = Field(default=None, description="Of an ideal source that turns")
    force_limit: PositiveLoad | None = Field(default=None, description="Of an ideal source that slides")
    inertia: PositiveInertia | None = Field(default=None, description="Beside the rotor, at the output; where it turns")
    mass: PositiveMass | None = Field(default=None, description="The same where it slides")
    viscous_friction: NonNegativeDamping | None = Field(default=None, description="At the output")
    dry_friction: DryFrictionSpec | None = Field(default=None, description="At the output")
    stops: StopsSpec | None = Field(default=None, description="Of the output")
    motion: Literal["free", "locked"] = Field(default="free", description="locked: it stays where it starts")

    @model_validator(mode="after")
    def _one_source(self) -> DriveSpec:
        of_motor = ("gear_ratio", "gear_efficiency", "gear_inertia", "current_limit", "voltage_limit")
        if self.motor is None:
            for name in of_motor:
                if getattr(self, name) is not None:
                    raise wrong("is given without a motor; name the motor, or leave it out", field=name)
        else:
            for name in ("torque_limit", "force_limit"):
                if getattr(self, name) is not None:
                    raise wrong("is given beside a motor; a motor's limit is its current_limit", field=name)
        return self


class DirectSpec(Part):
    """The drive's coordinate is the setting itself."""

    kind: Literal["direct"]


class ScrewSpec(Part):
    """A screw: length per turn."""

    kind: Literal["screw"]
    lead: PositiveLength = Field(description="Length per turn")


class BeltSpec(Part):
    """A belt, rack or cable on a pulley."""

    kind: Literal["belt"]
    pulley_radius: PositiveLength


class LineSpec(Part):
    """A straight line: setting = start + slope * angle of the drive."""

    kind: Literal["line"]
    start: Position = Field(description="Setting at an angle of zero")
    slope: LineSlope = Field(
        description="Not zero; a length per angle, or a plain number where the setting is an angle"
    )


class GrooveTransmissionSpec(Part):
    """The groove of the design's disc; the drive's coordinate is the disc angle."""

    kind: Literal["groove"]


Transmission = Annotated[
    DirectSpec | ScrewSpec | BeltSpec | LineSpec | GrooveTransmissionSpec, Field(discriminator="kind")
]
Slide = Annotated[ScrewSpec | BeltSpec, Field(discriminator="kind")]


class MainDriveSpec(DriveSpec):
    """The drive: a motor with its gear, or without `motor` an ideal source of torque or force."""

    transmission: Slide | None = Field(default=None, description="Between a motor and a linear device")


class CarriedMassSpec(Part):
    """A mass that the setting moves; on a turning body it changes that body's inertia."""

    mass: PositiveMass = Field(description="All sliders together")
    on: Literal["link", "drive", "ground"] = Field(description="Body that it rides on; ground: it turns with neither")
    radius_offset: Length | None = Field(
        default=None,
        description="Radius of its centre at a setting of zero; without it zero, for a slider_leaf_joint clamp_radius",
    )


class SettingDriveSpec(DriveSpec):
    """The stiffness drive; its own coordinate is what its transmission says."""

    transmission: Transmission | None = Field(default=None, description="Without it direct")
    carried_mass: CarriedMassSpec | None = None


class SupplySpec(Part):
    """A constant voltage from outside."""

    kind: Literal["supply"]
    voltage: PositiveVoltage
    series_resistance: NonNegativeResistance = Field(
        default=0.0, validate_default=False, description="With the cable; without it zero"
    )
    converter_efficiency: NoLoss = 1.0
    regenerative: bool = Field(default=True, description="false: what comes back is burnt in a brake resistor")


class BatterySpec(Part):
    """A battery whose voltage falls with its charge."""

    kind: Literal["battery"]
    capacity: PositiveCharge
    voltage_full: PositiveVoltage
    voltage_empty: PositiveVoltage
    series_resistance: NonNegativeResistance = Field(default=0.0, validate_default=False, description="Without it zero")
    leakage_resistance: PositiveResistance | None = Field(default=None, description="Without it no self-discharge")
    charge_share: Share = Field(default=0.8, description="At the start; without it 0.8")
    converter_efficiency: NoLoss = 1.0
    regenerative: bool = Field(default=True, description="false: what comes back is burnt in a brake resistor")


class SupercapacitorSpec(Part):
    """A supercapacitor."""

    kind: Literal["supercapacitor"]
    capacitance: PositiveCapacitance
    voltage: NonNegativeVoltage = Field(description="At the start")
    voltage_max: PositiveVoltage | None = Field(default=None, description="Where the brake resistor takes over")
    series_resistance: NonNegativeResistance = Field(default=0.0, validate_default=False, description="Without it zero")
    leakage_resistance: PositiveResistance | None = Field(default=None, description="Without it no leakage")
    converter_efficiency: NoLoss = 1.0
    regenerative: bool = Field(default=True, description="false: what comes back is burnt in a brake resistor")


StorageSpec = Annotated[SupplySpec | BatterySpec | SupercapacitorSpec, Field(discriminator="kind")]


class PlantSpec(Part):
    """Link, drives and what is between them."""

    link: LinkSpec
    drive: MainDriveSpec | None = Field(
        default=None, description="Without it the drive is locked; a semi-active joint has none"
    )
    setting_drive: SettingDriveSpec | None = Field(default=None, description="Without it the setting is fixed")
    backlash: PositivePosition | None = Field(default=None, description="Play between drive and link, its whole width")
    deflection_stops: StopsSpec | None = Field(default=None, description="Between drive and link")
    storage: StorageSpec | None = Field(
        default=None, description="What both drives draw from; without it a supply of 48 V that takes back"
    )


AnyStorageSpec = SupplySpec | BatterySpec | SupercapacitorSpec
AnyTransmissionSpec = DirectSpec | ScrewSpec | BeltSpec | LineSpec | GrooveTransmissionSpec
