"""Cross-sections of a design file, exactly the contract's names."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from typing import Annotated, Any, Literal

from pydantic import Field, model_validator

from varistiff.core.errors import InputError
from varistiff.design.fields import Length, NonNegativeLength, Part, PositiveLength, wrong
from varistiff.sections.limits import check_ellipse, check_p3g, check_splined_tube, p4c_cut

Rails = Annotated[int, Field(ge=1, le=1000, strict=True)]
Point = Annotated[list[Length], Field(min_length=2, max_length=2, description="[x, y]")]
Corners = Annotated[list[Point], Field(min_length=3, max_length=2000)]


class CircleSpec(Part):
    """Solid circular section."""

    shape: Literal["circle"]
    radius: PositiveLength


class HollowCircleSpec(Part):
    """Tube."""

    shape: Literal["hollow_circle"]
    outer_radius: PositiveLength
    inner_radius: NonNegativeLength

    @model_validator(mode="after")
    def _ordered(self) -> HollowCircleSpec:
        if not self.inner_radius < self.outer_radius:
            raise wrong("is not below outer_radius; allowed is inner_radius < outer_radius", field="inner_radius")
        return self


class SquareSpec(Part):
    """Solid square."""

    shape: Literal["square"]
    across_flats: PositiveLength


class RectangleSpec(Part):
    """Solid rectangle."""

    shape: Literal["rectangle"]
    width: PositiveLength
    height: PositiveLength


class HexagonSpec(Part):
    """Solid regular hexagon."""

    shape: Literal["hexagon"]
    across_flats: PositiveLength


class OctagonSpec(Part):
    """Solid regular octagon."""

    shape: Literal["octagon"]
    across_flats: PositiveLength


class EllipseSpec(Part):
    """Solid ellipse."""

    shape: Literal["ellipse"]
    semi_major: PositiveLength
    semi_minor: PositiveLength

    @model_validator(mode="after")
    def _ordered(self) -> EllipseSpec:
        _checked(check_ellipse, self.model_dump(exclude={"shape"}))
        return self


class TriangleSpec(Part):
    """Solid equilateral triangle."""

    shape: Literal["triangle"]
    side: PositiveLength


class P3GSpec(Part):
    """Three-lobed polygon profile of DIN 32711."""

    shape: Literal["p3g"]
    mean_diameter: PositiveLength
    eccentricity: Length

    @model_validator(mode="after")
    def _is_a_profile(self) -> P3GSpec:
        _checked(check_p3g, self.model_dump(exclude={"shape"}))
        return self


class P4CSpec(Part):
    """Four-sided polygon profile of DIN 32712."""

    shape: Literal["p4c"]
    inner_diameter: PositiveLength
    outer_diameter: PositiveLength
    eccentricity: Length

    @model_validator(mode="after")
    def _is_a_profile(self) -> P4CSpec:
        _checked(p4c_cut, self.model_dump(exclude={"shape"}))
        return self


class SplinedTubeSpec(Part):
    """Tube with rails."""

    shape: Literal["splined_tube"]
    outer_radius: PositiveLength
    inner_radius: NonNegativeLength
    rails: Rails
    rail_width: PositiveLength
    rail_height: PositiveLength
    root_fillet: NonNegativeLength = Field(
        default=0.0, validate_default=False, description="0 mm: a sharp root, whose ideal stress is unbounded"
    )

    @model_validator(mode="after")
    def _is_a_tube(self) -> SplinedTubeSpec:
        _checked(check_splined_tube, self.model_dump(exclude={"shape"}))
        return self


class PolygonSpec(Part):
    """Any section: corners here, or an outline from a CSV or DXF file."""

    shape: Literal["polygon"]
    points: Corners | None = Field(default=None, description="Corners of the outer outline")
    holes: list[Corners] | None = Field(default=None, max_length=100, description="Corners of each hole; optional")
    file: Annotated[str, Field(min_length=1)] | None = Field(
        default=None,
        description="CSV file (columns x and y) or DXF drawing, in place of points; relative to the design file",
        examples=["outline.csv"],
    )
    unit: Annotated[str, Field(min_length=1)] | None = Field(
        default=None,
        description="Of the numbers in that file; required for CSV, and for a DXF drawing that states none",
        examples=["mm"],
    )

    @model_validator(mode="after")
    def _one_source(self) -> PolygonSpec:
        if (self.points is None) == (self.file is None):
            raise wrong("needs points or a file, one of them", field="")
        if self.file is not None and self.holes is not None:
            raise wrong("is given beside a file; the file holds the holes", field="holes")
        if self.file is None and self.unit is not None:
            raise wrong("is given without a file; points carry their units", field="unit")
        return self


class OutlineSpec(Part):
    """A polygon after its file was read and its loops were checked; no design file can hold one."""

    shape: Literal["polygon"] = "polygon"
    loops: tuple[Any, ...]  # of segments


SectionSpec = Annotated[
    CircleSpec
    | HollowCircleSpec
    | SquareSpec
    | RectangleSpec
    | HexagonSpec
    | OctagonSpec
    | EllipseSpec
    | TriangleSpec
    | P3GSpec
    | P4CSpec
    | SplinedTubeSpec
    | PolygonSpec,
    Field(discriminator="shape"),
]


def _checked(check: Callable[..., Any], lengths: Mapping[str, Any]) -> None:
    try:
        check(**lengths)
    except InputError as error:
        raise wrong(error.problem, field=error.field) from None
