"""Control of a scenario file: encoders, delay, and a controller for each drive."""

from __future__ import annotations

from typing import Annotated, Literal

from pydantic import Field, model_validator

from varistiff.design.fields import Part, wrong
from varistiff.design.scenario_fields import (
    Delay,
    Every,
    Nodes,
    NonNegativeDamping,
    NonNegativeNumber,
    NonNegativePerTime,
    NonNegativeStiffness,
    NonNegativeStiffnessRate,
    NonNegativeTime,
    Position,
    PositiveLoad,
    PositiveNumber,
    PositivePosition,
    PositiveRate,
    PositiveTime,
)
from varistiff.design.scenario_signal_spec import SignalSpec


class EncoderSpec(Part):
    """An encoder with a resolution, or with counts in a turn of its own shaft."""

    resolution: PositivePosition | None = Field(default=None, description="Of the coordinate that it measures")
    counts: PositiveNumber | None = Field(
        default=None, description="In one turn of its own shaft, after quadrature; for a coordinate that turns"
    )
    ratio: PositiveNumber | None = Field(
        default=None, description="Turns of the encoder per turn of the coordinate; with counts; without it 1"
    )

    @model_validator(mode="after")
    def _one_way(self) -> EncoderSpec:
        if (self.resolution is None) == (self.counts is None):
            raise wrong("needs resolution or counts, one of them", field="")
        if self.ratio is not None and self.counts is None:
            raise wrong("is given without counts; allowed only with them", field="ratio")
        return self


class EncodersSpec(Part):
    """Encoders; one that is left out is ideal."""

    link: EncoderSpec | None = None
    drive: EncoderSpec | None = None
    setting: EncoderSpec | None = Field(default=None, description="On the setting drive's own coordinate")


class ChannelSpec(Part):
    """What every controller has."""

    every: Every = Field(default=1, description="It is sampled at each so many periods; without it 1")


class ServoSpec(ChannelSpec):
    """A controller with a PID law on a position, in the units of what it drives."""

    proportional: NonNegativeStiffness = Field(description="Torque or force per position")
    integral: NonNegativeStiffnessRate | None = Field(default=None, description="Without it zero")
    derivative: NonNegativeDamping | None = Field(default=None, description="Without it zero")
    filter_time: NonNegativeTime = Field(
        default=0.0, validate_default=False, description="Of the derivative; without it zero"
    )
    windup_time: PositiveTime | None = Field(
        default=None, description="In which a saturated integral runs back; without it none does"
    )
    derivative_on: Literal["measurement", "error"] = "measurement"
    limit: PositiveLoad | None = Field(default=None, description="Of the command; without it the drive's own")


class TorqueLoopSpec(ChannelSpec):
    """A controller with a PID law on the torque or force of the spring."""

    proportional: NonNegativeNumber = Field(description="A plain number: command per torque")
    integral: NonNegativePerTime = Field(default=0.0, validate_default=False, description="Without it zero")
    derivative: NonNegativeTime = Field(default=0.0, validate_default=False, description="Without it zero")
    filter_time: NonNegativeTime = Field(
        default=0.0, validate_default=False, description="Of the derivative; without it zero"
    )
    windup_time: PositiveTime | None = Field(
        default=None, description="In which a saturated integral runs back; without it none does"
    )
    derivative_on: Literal["measurement", "error"] = "measurement"
    limit: PositiveLoad | None = Field(default=None, description="Of the command; without it the drive's own")


class PositionPidSpec(ServoSpec):
    """PID control of the position, as Wang et al. (2024) have it."""

    kind: Literal["pid"]
    feedback: Literal["link", "drive"] = Field(
        default="link", description="link: over the spring; drive: the link hangs on the spring passively"
    )


class TorqueControlSpec(TorqueLoopSpec):
    """The spring's torque follows the wanted one, which is fed forward."""

    kind: Literal["torque"]


class ImpedanceSpec(TorqueLoopSpec):
    """A virtual spring-damper around a torque loop."""

    kind: Literal["impedance"]
    stiffness: NonNegativeStiffness = Field(description="Of the virtual spring")
    damping: NonNegativeDamping | None = Field(default=None, description="Of the virtual damper; without it zero")
    inertia_feedforward: bool = Field(default=False, description="The link's inertia times the wanted acceleration")
    rate_filter_time: NonNegativeTime = Field(
        default=0.0, validate_default=False, description="Of the link's rate; without it zero"
    )


class DecouplingSpec(ServoSpec):
    """Computed torque through the spring by the map; the gains are those of the drive's servo."""

    kind: Literal["decoupling"]
    stiffness: NonNegativeStiffness = Field(description="That the link is to have about its wanted position")
    damping: NonNegativeDamping | None = Field(default=None, description="The same for its rate; without it zero")
    rate_filter_time: NonNegativeTime = Field(
        default=0.0, validate_default=False, description="Of the link's rate; without it zero"
    )


class LqrSpec(ChannelSpec):
    """State feedback with gains over the setting, weighted by the largest values that are welcome (Bryson)."""

    kind: Literal["lqr"]
    link_error: PositivePosition
    command: PositiveLoad
    link_rate: PositiveRate | None = Field(default=None, description="Without it not weighted")
    drive_error: PositivePosition | None = Field(default=None, description="Without it not weighted")
    drive_rate: PositiveRate | None = Field(default=None, description="Without it not weighted")
    integral_time: PositiveTime | None = Field(
        default=None, description="For which link_error is welcome; without it no integral action"
    )
    nodes: Nodes = Field(default=17, description="Settings at which a regulator is designed; without it 17")
    design: Literal["sampled", "continuous"] = "sampled"
    rate_filter_time: NonNegativeTime = Field(
        default=0.0, validate_default=False, description="Of both rates; without it zero"
    )
    limit: PositiveLoad | None = Field(default=None, description="Of the command; without it the drive's own")


class StiffnessPidSpec(ServoSpec):
    """PID control of the setting drive's coordinate that the wanted stiffness asks for."""

    kind: Literal["pid"]
    chain: Literal["map", "exact", "wang_line"] = Field(
        default="map",
        description="map: the actuator's own map; exact: Eq. (9) and the groove; wang_line: Eq. (9) and its line",
    )
    stiffness_at: Literal["rest", "measured"] = Field(default="rest", description="Deflection that the map is asked at")
    adjusting_feedforward: bool = Field(default=False, description="Adds what the map says that the setting needs")


class SettingHoldSpec(ServoSpec):
    """A servo that holds one setting."""

    kind: Literal["hold"]
    setting: Position | None = Field(default=None, description="Without it the one at the start")
    adjusting_feedforward: bool = Field(default=False, description="Adds what the map says that the setting needs")


class VirtualSpringDamperSpec(ServoSpec):
    """The setting of a semi-active joint renders a torque; the gains are those of the setting's servo."""

    kind: Literal["virtual_spring_damper"]
    stiffness: NonNegativeStiffness | None = Field(default=None, description="Of the virtual spring; without it zero")
    damping: NonNegativeDamping | None = Field(default=None, description="Of the virtual damper; without it zero")
    dead_band: PositivePosition = Field(description="Deflection up to which the setting stays")
    rate_filter_time: NonNegativeTime = Field(
        default=0.0, validate_default=False, description="Of the link's rate; without it zero"
    )


class SettingScheduleSpec(ServoSpec):
    """The setting follows a signal of its own, with what the map and its inertia ask for fed forward."""

    kind: Literal["schedule"]
    setting: SignalSpec = Field(description="Of the setting, against the time of the run")


DriveControlSpec = Annotated[
    PositionPidSpec | TorqueControlSpec | ImpedanceSpec | DecouplingSpec | LqrSpec, Field(discriminator="kind")
]
SettingControlSpec = Annotated[
    StiffnessPidSpec | SettingHoldSpec | SettingScheduleSpec | VirtualSpringDamperSpec, Field(discriminator="kind")
]
AnyDriveControlSpec = PositionPidSpec | TorqueControlSpec | ImpedanceSpec | DecouplingSpec | LqrSpec
AnySettingControlSpec = StiffnessPidSpec | SettingHoldSpec | SettingScheduleSpec | VirtualSpringDamperSpec


class ControlSpec(Part):
    """Sampled control."""

    period: PositiveTime = Field(description="Of control, and of the rows of the result")
    delay: Delay = Field(default=0, description="Of the readings; without it none")
    encoders: EncodersSpec | None = None
    drive: DriveControlSpec | None = Field(default=None, description="Without it the drive gets no command")
    setting: SettingControlSpec | None = Field(default=None, description="Without it the setting drive gets no command")
