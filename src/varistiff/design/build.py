"""From a resolved spec to the actuator; the actuators bring in JAX and are imported where they are built."""

from __future__ import annotations

import math
from typing import TYPE_CHECKING

from varistiff.core.errors import InputError
from varistiff.design.fields import Part
from varistiff.design.section_spec import OutlineSpec
from varistiff.design.spec import (
    AntagonisticLeavesSpec,
    AnyActuatorSpec,
    EndModelSpec,
    FixedPairSpec,
    LeafSpec,
    MaccepaSpec,
    RollerBeamSpec,
    SeriesElasticSpec,
    SingleRollerSpec,
    SliderLeafJointSpec,
    SwivellingPairSpec,
    TorsionTubeSpec,
)

if TYPE_CHECKING:
    from varistiff.actuators.actuator import Actuator
    from varistiff.actuators.rollers import FixedPair, SingleLower, SingleUpper, SwivellingPair
    from varistiff.elastic.end_effect import EndEffect
    from varistiff.elastic.leaf import Leaf
    from varistiff.sections import Section


def build(spec: AnyActuatorSpec) -> Actuator:
    """Return the actuator of a resolved spec.

    Raises
    ------
    InputError : the numbers describe no mechanism
    """
    try:
        return _build(spec)
    except InputError:
        raise
    except ValueError as error:
        raise InputError(" ".join(str(error).split()), field="actuator") from error


def _build(spec: AnyActuatorSpec) -> Actuator:
    if isinstance(spec, RollerBeamSpec):
        return _roller_beam(spec)
    if isinstance(spec, TorsionTubeSpec):
        return _torsion_tube(spec)
    if isinstance(spec, AntagonisticLeavesSpec):
        return _antagonistic_leaves(spec)
    if isinstance(spec, SliderLeafJointSpec):
        return _slider_leaf_joint(spec)
    if isinstance(spec, SeriesElasticSpec):
        from varistiff.actuators.series_elastic import SeriesElastic

        return SeriesElastic(stiffness=spec.stiffness)
    return _maccepa(spec)


def _leaf(spec: LeafSpec) -> Leaf:
    from varistiff.elastic.leaf import Leaf

    return Leaf(
        youngs_modulus=_given(spec.youngs_modulus),
        width=spec.width,
        thickness=spec.thickness,
        length=_unlimited(spec.length),
        yield_strength=_unlimited(spec.yield_strength),
    )


def _given(value: float | None) -> float:
    if value is None:
        raise AssertionError("the spec is not resolved")
    return value


def _unlimited(value: float | None) -> float:
    return math.inf if value is None else value


def _rollers(
    spec: SingleRollerSpec | FixedPairSpec | SwivellingPairSpec,
) -> SingleLower | SingleUpper | FixedPair | SwivellingPair:
    from varistiff.actuators.rollers import FixedPair, SingleLower, SingleUpper, SwivellingPair

    if isinstance(spec, FixedPairSpec):
        return FixedPair(offset=spec.offset, radius=spec.radius, clearance=spec.clearance)
    if isinstance(spec, SwivellingPairSpec):
        return SwivellingPair(offset=spec.offset, clearance=spec.clearance)
    if spec.arrangement == "single_lower":
        return SingleLower(offset=spec.offset, radius=spec.radius)
    return SingleUpper(offset=spec.offset, radius=spec.radius)


def _roller_beam(spec: RollerBeamSpec) -> Actuator:
    from varistiff.actuators.roller_beam import RollerBeam

    return RollerBeam(
        beam=_leaf(spec.beam),
        rollers=_rollers(spec.roller),
        mounting_angle=spec.mounting_angle,
        clamp_offset_along=spec.clamp_offset_along,
        clamp_offset_across=spec.clamp_offset_across,
    )


_SHAPES = {
    "circle": "Circle",
    "hollow_circle": "HollowCircle",
    "square": "Square",
    "rectangle": "Rectangle",
    "hexagon": "Hexagon",
    "octagon": "Octagon",
    "ellipse": "Ellipse",
    "triangle": "Triangle",
    "p3g": "P3G",
    "p4c": "P4C",
    "splined_tube": "SplinedTube",
}


def _section(spec: Part) -> Section:
    from varistiff import sections

    if isinstance(spec, OutlineSpec):
        return sections.Polygon(loops=spec.loops)
    lengths = spec.model_dump()
    shape: Section = getattr(sections, _SHAPES[lengths.pop("shape")])(**lengths)
    return shape


def _end_effect(spec: EndModelSpec | None) -> EndEffect | None:
    from varistiff.elastic.end_effect import EndEffect

    if spec is None:
        return None
    return EndEffect(
        offset=spec.offset,
        lock_offset=spec.lock_offset,
        decay=spec.decay,
        shortest=spec.valid.min,
        longest=spec.valid.max,
    )


def _torsion_tube(spec: TorsionTubeSpec) -> Actuator:
    from varistiff.actuators.torsion_tube import TorsionTube

    try:
        return TorsionTube(
            shear_modulus=_given(spec.shear_modulus),
            section=_section(spec.section),
            length=_unlimited(spec.length),
            series_stiffness=_unlimited(spec.series_stiffness),
            yield_strength=_unlimited(spec.yield_strength),
            end_effect=_end_effect(spec.end_model),
        )
    except InputError as error:  # the section could not be solved
        raise error.located(field="actuator.section") from None


def _antagonistic_leaves(spec: AntagonisticLeavesSpec) -> Actuator:
    from varistiff.actuators.antagonistic_leaves import AntagonisticLeaves
    from varistiff.elastic.guided_leaf import GuidedLeaf
    from varistiff.elastic.sliding_leaf import SlidingLeaf
    from varistiff.elastic.wrapped_leaf import WrappedLeaf

    law: GuidedLeaf | SlidingLeaf | WrappedLeaf
    if spec.end_condition == "guided":
        law = GuidedLeaf()
    elif spec.protection_radius is None:
        law = SlidingLeaf()
    else:
        law = WrappedLeaf(protection_radius=spec.protection_radius)
    return AntagonisticLeaves(
        leaf=_leaf(spec.leaf),
        law=law,
        roller_distance=spec.roller_distance,
        clamp_height=spec.clamp_height,
        screw_lead=spec.screw_lead,
    )


def _slider_leaf_joint(spec: SliderLeafJointSpec) -> Actuator:
    from varistiff.actuators.groove import Groove
    from varistiff.actuators.leaf_joint_theory import LargeDeflection, SmallDeflection
    from varistiff.actuators.slider_leaf_joint import SliderLeafJoint

    groove = spec.groove
    return SliderLeafJoint(
        leaf=_leaf(spec.leaf),
        count=spec.leaf.count,
        clamp_radius=spec.clamp_radius,
        theory=SmallDeflection() if spec.beam_theory == "small_deflection" else LargeDeflection(),
        groove=None
        if groove is None
        else Groove(
            inner_radius=spec.clamp_radius,
            outer_radius=groove.outer_radius,
            outer_angle=groove.outer_angle,
            arc_radius=groove.arc_radius,
            centre=groove.centre,
        ),
        driven_by=spec.driven_by,
    )


def _maccepa(spec: MaccepaSpec) -> Actuator:
    from varistiff.actuators.maccepa import Maccepa

    return Maccepa(spring_rate=spec.spring_rate, lever_length=spec.lever_length, anchor_distance=spec.anchor_distance)
