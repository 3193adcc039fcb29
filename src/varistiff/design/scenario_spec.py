"""The scenario file as data, in SI units."""

from __future__ import annotations

from typing import Annotated, Any, ClassVar

from pydantic import ConfigDict, Discriminator, Field, Tag, field_validator, model_validator

from varistiff.design.fields import Part, wrong
from varistiff.design.scenario_control_spec import ControlSpec
from varistiff.design.scenario_fields import Position, PositiveStiffness, PositiveTime, Rate
from varistiff.design.scenario_plant_spec import PlantSpec
from varistiff.design.scenario_signal_spec import SignalSpec
from varistiff.design.spec import DesignSpec


def _design_form(value: Any) -> str:
    return "inline" if isinstance(value, dict | DesignSpec) else "file"


DesignReference = Annotated[
    Annotated[Annotated[str, Field(min_length=1, description="Design file, relative to this file")], Tag("file")]
    | Annotated[DesignSpec, Tag("inline")],
    Discriminator(_design_form),
]


class StartSpec(Part):
    """The state at the time 0."""

    link: Position | None = Field(default=None, description="Without it zero; a prescribed link has its signal")
    link_rate: Rate | None = Field(default=None, description="Without it zero")
    drive: Position | None = Field(default=None, description="Without it where the spring holds the loads at the start")
    drive_rate: Rate | None = Field(default=None, description="Without it zero")
    setting: Position | None = Field(default=None, description="Required of a kind that has one, or the stiffness")
    stiffness: PositiveStiffness | None = Field(default=None, description="Tangent stiffness at rest, for the setting")
    setting_rate: Rate | None = Field(default=None, description="Without it zero")

    @model_validator(mode="after")
    def _one_setting(self) -> StartSpec:
        if self.setting is not None and self.stiffness is not None:
            raise wrong("is given beside setting; allowed is one of them", field="stiffness")
        return self


class ReferenceSpec(Part):
    """What the controllers are to follow; a reference that none follows is an error."""

    position: SignalSpec | None = Field(default=None, description="Of the link")
    stiffness: SignalSpec | None = Field(default=None, description="Of the joint")
    torque: SignalSpec | None = Field(default=None, description="On the link in its positive direction; of a joint")
    force: SignalSpec | None = Field(default=None, description="The same of a linear device")


class LoadSpec(Part):
    """What acts from outside against the link's positive direction."""

    torque: SignalSpec | None = Field(default=None, description="On a joint")
    force: SignalSpec | None = Field(default=None, description="On a linear device")


class ScenarioSpec(Part):
    """A varistiff scenario: a design in motion."""

    model_config = ConfigDict(title="varistiff scenario")
    schema_version: ClassVar[str] = "https://json-schema.org/draft/2020-12/schema"

    name: Annotated[str, Field(min_length=1, max_length=200, description="Title of the report")]
    design: DesignReference
    duration: PositiveTime = Field(description="A whole number of periods")
    step: PositiveTime | None = Field(
        default=None, description="Of the integration, the period over a whole number; without it varistiff chooses"
    )
    plant: PlantSpec
    start: StartSpec | None = None
    control: ControlSpec | None = Field(default=None, description="Without it no control, and a period of 1 ms")
    reference: ReferenceSpec | None = None
    load: LoadSpec | None = None

    @field_validator("name", mode="after")
    @classmethod
    def _one_line(cls, name: str) -> str:
        if not name.strip() or not name.isprintable():
            raise wrong("is not one line of text; allowed is a title of one line")
        return name.strip()


def scenario_json_schema() -> dict[str, Any]:
    """Return the JSON schema of a scenario file, for editors."""
    return {"$schema": ScenarioSpec.schema_version, **ScenarioSpec.model_json_schema(mode="validation")}
