"""The design file as data: one model per kind, in SI units, exactly the contract's names."""

from __future__ import annotations

import math
from typing import Annotated, Any, ClassVar, Literal

from pydantic import ConfigDict, Discriminator, Field, SerializeAsAny, Tag, field_validator, model_validator

from varistiff.core import quantity
from varistiff.design.fields import (
    Angle,
    AngleRange,
    Length,
    LengthRange,
    NonNegativeLength,
    Part,
    PositiveAngle,
    PositiveLength,
    PositiveLengthRange,
    PositiveLinearStiffness,
    PositiveRotationalStiffness,
    PositiveStress,
    wrong,
)
from varistiff.design.section_spec import SectionSpec

Count = Annotated[int, Field(ge=1, le=1000, strict=True)]
MaterialName = Annotated[str, Field(description="Name of a material; `varistiff materials` lists them")]
YoungsModulus = Annotated[PositiveStress | None, Field(description="Overrides the material's")]
YieldStrength = Annotated[
    PositiveStress | None,
    Field(description="Tensile; overrides the material's. Without one no point is ever `yielded`"),
]


class LeafSpec(Part):
    """A leaf of rectangular cross-section."""

    material: MaterialName | None = None
    youngs_modulus: YoungsModulus = None
    width: PositiveLength = Field(description="Across the plane of bending")
    thickness: PositiveLength = Field(description="In the plane of bending")
    length: PositiveLength | None = Field(default=None, description="Free length; optional")
    yield_strength: YieldStrength = None

    @model_validator(mode="after")
    def _has_modulus(self) -> LeafSpec:
        if self.material is None and self.youngs_modulus is None:
            raise wrong("neither material nor youngs_modulus is given; allowed is one of them or both", field="")
        return self


class BeamSpec(LeafSpec):
    """The beam of a roller beam: a leaf with a length."""

    length: PositiveLength = Field(description="Free length")


class CountedLeafSpec(LeafSpec):
    """Equal leaves side by side."""

    count: Count = Field(default=1, description="Number of leaves")


class SingleRollerSpec(Part):
    """One roller below or above the beam; radius 0 is a knife edge."""

    arrangement: Literal["single_lower", "single_upper"]
    offset: Length = Field(default=0.0, validate_default=False, description="d_r, roller centre from the link axis")
    radius: NonNegativeLength


class FixedPairSpec(Part):
    """Two rollers fixed to the link, one on each side of the beam."""

    arrangement: Literal["fixed_pair"]
    offset: Length = Field(default=0.0, validate_default=False, description="Middle of the pair from the link axis")
    radius: NonNegativeLength
    clearance: PositiveLength


class SwivellingPairSpec(Part):
    """Two rollers that turn with the beam about a pivot."""

    arrangement: Literal["swivelling_pair"]
    offset: Length = Field(default=0.0, validate_default=False, description="Pivot from the link axis")
    radius: NonNegativeLength | None = Field(default=None, description="Of no effect: the pair turns with the beam")
    clearance: NonNegativeLength


RollerSpec = Annotated[SingleRollerSpec | FixedPairSpec | SwivellingPairSpec, Field(discriminator="arrangement")]


class RollerBeamSpec(Part):
    """Roller on a cantilever beam (dos Santos and Richter 2019)."""

    kind: Literal["roller_beam"]
    beam: BeamSpec
    mounting_angle: Angle = Field(default=0.0, validate_default=False, description="alpha_w")
    clamp_offset_along: Length = Field(default=0.0, validate_default=False, description="d_1")
    clamp_offset_across: Length = Field(default=0.0, validate_default=False, description="d_0")
    roller: RollerSpec
    setting: PositiveLengthRange = Field(description="Roller position x_r")
    deflection: AngleRange = Field(description="Joint angle theta_j")


class EndModelSpec(Part):
    """What the ends add to the active length, fitted to three-dimensional results; `varistiff verify` prints it."""

    offset: Length = Field(description="Length that the ends add far from the flange; below zero they stiffen")
    lock_length: PositiveLength | None = Field(
        default=None, description="Effective length at an active length of zero; optional, with decay_length"
    )
    decay_length: PositiveLength | None = Field(
        default=None, description="Active length over which the ends separate; optional, with lock_length"
    )
    valid: PositiveLengthRange = Field(description="Active lengths that it was fitted to; outside_validity elsewhere")

    @model_validator(mode="after")
    def _consistent(self) -> EndModelSpec:
        if (self.lock_length is None) != (self.decay_length is None):
            raise wrong("one of lock_length and decay_length is missing; allowed is both or neither", field="")
        shortest = self.valid.min + self.offset + self.lock_offset * math.exp(-self.valid.min / self.decay)
        if shortest <= 0.0:
            raise wrong("makes the effective length zero or less; allowed is a larger one", field="offset")
        return self

    @property
    def lock_offset(self) -> float:
        """Effective length at zero, beyond the offset [m]."""
        return 0.0 if self.lock_length is None else self.lock_length - self.offset

    @property
    def decay(self) -> float:
        """Length over which it fades [m]; of no effect without a lock length."""
        return self.valid.max if self.decay_length is None else self.decay_length


class TorsionTubeSpec(Part):
    """Torsion bar of variable active length (Schuy et al. 2013)."""

    kind: Literal["torsion_tube"]
    material: MaterialName | None = None
    shear_modulus: PositiveStress | None = Field(default=None, description="Overrides the material's")
    yield_strength: YieldStrength = None
    section: SerializeAsAny[SectionSpec]  # a polygon's becomes an OutlineSpec once it is read
    series_stiffness: PositiveRotationalStiffness | None = Field(
        default=None, description="Everything else in the drive train; optional"
    )
    length: PositiveLength | None = Field(default=None, description="Length of the element; optional")
    end_model: EndModelSpec | None = Field(default=None, description="End effects; optional")
    setting: PositiveLengthRange = Field(description="Active length x")
    deflection: AngleRange

    @model_validator(mode="after")
    def _has_modulus(self) -> TorsionTubeSpec:
        if self.material is None and self.shear_modulus is None:
            raise wrong("neither material nor shear_modulus is given; allowed is one of them or both", field="")
        return self


class AntagonisticLeavesSpec(Part):
    """Two antagonistic pairs of leaves (Chacon et al. 2011); a linear spring."""

    kind: Literal["antagonistic_leaves"]
    leaf: LeafSpec
    roller_distance: PositiveLength = Field(description="D")
    clamp_height: PositiveLength = Field(description="y_f")
    end_condition: Literal["sliding", "guided"] = Field(description="sliding: exact; guided: as the paper models it")
    protection_radius: PositiveLength | None = Field(
        default=None, description="Radius of the cylinders that the leaf wraps on; sliding only; optional"
    )
    screw_lead: PositiveLength | None = Field(default=None, description="Lead of the adjusting screw; optional")
    setting: PositiveLengthRange = Field(description="Nut distance delta")
    deflection: LengthRange

    @model_validator(mode="after")
    def _consistent(self) -> AntagonisticLeavesSpec:
        if self.protection_radius is not None and self.end_condition != "sliding":
            raise wrong("is given with end_condition guided; allowed only with sliding", field="protection_radius")
        return self


class GrooveSpec(Part):
    """Circular groove that turns the disc angle into the active length."""

    outer_radius: PositiveLength = Field(description="r_1, outer end of the groove from the axis")
    outer_angle: PositiveAngle = Field(description="alpha_1, disc angle at the outer end")
    arc_radius: PositiveLength = Field(description="r_s")
    centre: Literal["near", "far"] = Field(description="Which of the two circles through both ends")

    @field_validator("outer_angle", mode="after")
    @classmethod
    def _below_half_turn(cls, angle: float) -> float:
        if angle >= math.pi:
            raise wrong("is half a turn or more; allowed is an angle above 0 deg and below 180 deg")
        return angle

    def meets_each_angle_once(self, inner_radius: float) -> bool:
        """Whether every ray from the axis between the groove's ends crosses the arc once.

        It does where both ends lie on the same side of the arc's tangent rays: there (end - centre) . end has one sign.
        """
        start = (0.0, inner_radius)
        end = (self.outer_radius * math.sin(self.outer_angle), self.outer_radius * math.cos(self.outer_angle))
        chord = math.dist(start, end)
        height = math.sqrt(max(self.arc_radius**2 - 0.25 * chord**2, 0.0))
        normal = ((start[1] - end[1]) / chord, (end[0] - start[0]) / chord)
        centres = [
            tuple(0.5 * (p + q) + side * height * n for p, q, n in zip(start, end, normal, strict=True))
            for side in (-1.0, 1.0)
        ]
        pick = min if self.centre == "near" else max
        x, y = pick(centres, key=lambda centre: math.hypot(*centre))
        signs = [(px - x) * px + (py - y) * py > 0.0 for px, py in (start, end)]
        return signs[0] == signs[1]


def _measure_of_range(value: Any) -> str:
    """Return which kind of setting a slider's range is written in."""
    if isinstance(value, AngleRange):
        return "angle"
    if not isinstance(value, dict):
        return "length"
    kinds = [quantity.kind_of(end, (quantity.LENGTH, quantity.ANGLE)) for end in (value.get("min"), value.get("max"))]
    return "angle" if quantity.ANGLE in kinds and quantity.LENGTH not in kinds else "length"


SliderSetting = Annotated[
    Annotated[PositiveLengthRange, Tag("length")] | Annotated[AngleRange, Tag("angle")],
    Discriminator(_measure_of_range),
]


class SliderLeafJointSpec(Part):
    """Leaf with a sliding contact that a grooved disc moves (Wang et al. 2024)."""

    kind: Literal["slider_leaf_joint"]
    leaf: CountedLeafSpec
    clamp_radius: PositiveLength = Field(description="r_2")
    beam_theory: Literal["small_deflection", "large_deflection"] = Field(
        description="small_deflection: the paper's, valid to 10 deg of leaf rotation; large_deflection: exact"
    )
    groove: GrooveSpec | None = Field(default=None, description="Optional")
    setting: SliderSetting = Field(description="Active length l_1; with a groove also the disc angle")
    deflection: AngleRange

    @property
    def driven_by(self) -> Literal["length", "disc"]:
        """What the setting is."""
        return "disc" if isinstance(self.setting, AngleRange) else "length"

    @model_validator(mode="after")
    def _consistent(self) -> SliderLeafJointSpec:
        groove = self.groove
        if groove is None:
            if self.driven_by == "disc":
                raise wrong("is an angle without a groove; allowed is a length, or give the groove", field="setting")
            return self
        if not groove.outer_radius > self.clamp_radius:
            raise wrong(
                "is not above clamp_radius; allowed is outer_radius > clamp_radius",
                field="groove.outer_radius",
            )
        chord = math.sqrt(
            self.clamp_radius**2
            + groove.outer_radius**2
            - 2.0 * self.clamp_radius * groove.outer_radius * math.cos(groove.outer_angle)
        )
        if groove.arc_radius < 0.5 * chord:
            limit = f"{500.0 * chord:.6g} mm"
            raise wrong(
                f"is too small to join the groove's ends; allowed is half their distance or more, {limit}",
                field="groove.arc_radius",
            )
        if self.driven_by == "disc" and not groove.meets_each_angle_once(self.clamp_radius):
            raise wrong(
                f"makes a groove that meets a disc angle twice with the {groove.centre} centre; allowed is a larger "
                "arc_radius, or the other centre",
                field="groove.arc_radius",
            )
        return self


class SeriesElasticSpec(Part):
    """Fixed rotational spring (Pratt and Williamson 1995); it has no setting."""

    kind: Literal["series_elastic"]
    stiffness: PositiveRotationalStiffness
    deflection: AngleRange


class MaccepaSpec(Part):
    """Lever, cable and pretensioned spring (Van Ham et al. 2007)."""

    kind: Literal["maccepa"]
    spring_rate: PositiveLinearStiffness
    lever_length: PositiveLength = Field(description="B")
    anchor_distance: PositiveLength = Field(description="C, different from B")
    setting: LengthRange = Field(description="Pretension P; below zero the cable hangs slack around rest")
    deflection: AngleRange

    @model_validator(mode="after")
    def _has_a_rest(self) -> MaccepaSpec:
        # B = C: the cable's length at rest is zero and its direction undefined; units round, so 35 mm is 0.035 m
        if math.isclose(self.anchor_distance, self.lever_length, rel_tol=1e-9):
            raise wrong("equals lever_length; allowed is a different length", field="anchor_distance")
        return self


ActuatorSpec = Annotated[
    RollerBeamSpec | TorsionTubeSpec | AntagonisticLeavesSpec | SliderLeafJointSpec | SeriesElasticSpec | MaccepaSpec,
    Field(discriminator="kind"),
]
AnyActuatorSpec = (
    RollerBeamSpec | TorsionTubeSpec | AntagonisticLeavesSpec | SliderLeafJointSpec | SeriesElasticSpec | MaccepaSpec
)


class VerificationSpec(Part):
    """What `varistiff verify` needs of the hardware and no map does; every field is optional."""

    poissons_ratio: Annotated[float, Field(ge=0.0, le=0.49)] | None = Field(
        default=None, description="A bare number; from the material's E and G where it is left out"
    )
    bearing_length: PositiveLength | None = Field(
        default=None, description="Of a torsion tube's counter bearing along the element"
    )
    bearing_clearance: NonNegativeLength | None = Field(default=None, description="Gap between bearing and element")
    flange_radius: PositiveLength | None = Field(default=None, description="Of the drive-side disc, for STEP")
    flange_thickness: PositiveLength | None = Field(default=None, description="Of the drive-side disc, for STEP")

    @model_validator(mode="after")
    def _whole_flange(self) -> VerificationSpec:
        if (self.flange_radius is None) != (self.flange_thickness is None):
            raise wrong("one of flange_radius and flange_thickness is missing; allowed is both or neither", field="")
        return self


class DesignSpec(Part):
    """A varistiff design: one variable stiffness actuator and the range of its map."""

    model_config = ConfigDict(title="varistiff design")
    schema_version: ClassVar[str] = "https://json-schema.org/draft/2020-12/schema"

    name: Annotated[str, Field(min_length=1, max_length=200, description="Title of the report")]
    actuator: ActuatorSpec
    verification: VerificationSpec | None = Field(default=None, description="For the 3-D check; optional")
    materials_file: Annotated[
        str | None,
        Field(min_length=1, description="YAML file with your own materials, relative to this file; optional"),
    ] = None

    @field_validator("name", mode="after")
    @classmethod
    def _one_line(cls, name: str) -> str:
        if not name.strip() or not name.isprintable():
            raise wrong("is not one line of text; allowed is a title of one line")
        return name.strip()


def json_schema() -> dict[str, Any]:
    """Return the JSON schema of a design file, for editors."""
    return {"$schema": DesignSpec.schema_version, **DesignSpec.model_json_schema(mode="validation")}
