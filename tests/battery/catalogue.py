"""Every kind with its variants, and where to test each: one list that the whole battery runs over.

A case names regions of (deflection, setting) where the status is ``ok`` and the energy is smooth, and can be
built again with all lengths, the elastic modulus or the width scaled.
"""

from __future__ import annotations

import math
from collections.abc import Callable
from dataclasses import dataclass

import numpy as np
from hypothesis import strategies as st
from numpy.typing import NDArray

from varistiff.actuators import (
    Actuator,
    FixedPair,
    Groove,
    LargeDeflection,
    LeafJointTheory,
    Maccepa,
    RollerBeam,
    SeriesElastic,
    SingleLower,
    SingleUpper,
    SliderLeafJoint,
    SmallDeflection,
    SwivellingPair,
    TorsionTube,
)
from varistiff.actuators.antagonistic_leaves import AntagonisticLeaves
from varistiff.elastic.end_effect import EndEffect
from varistiff.elastic.guided_leaf import GuidedLeaf
from varistiff.elastic.leaf import Leaf
from varistiff.elastic.leaf_law import LeafLaw
from varistiff.elastic.sliding_leaf import SlidingLeaf
from varistiff.elastic.wrapped_leaf import WrappedLeaf
from varistiff.sections import Circle, HollowCircle, SplinedTube

from .evaluation import BATCH

Floats = NDArray[np.float64]
Region = tuple[float, float]
POINTS = BATCH  # of every sample


@dataclass(frozen=True)
class Scale:
    """Factors on all lengths, on the elastic modulus and on the width alone."""

    length: float = 1.0
    modulus: float = 1.0
    width: float = 1.0


@dataclass(frozen=True)
class Case:
    """One actuator of the battery.

    ``deflections`` are intervals valid for every setting in ``setting``; ``symmetric`` says V(-d) = V(d);
    ``has_width`` that the energy is proportional to the leaf's width; ``ok`` that no other status occurs.
    """

    name: str
    build: Callable[[Scale], Actuator]
    deflections: tuple[Region, ...]
    setting: Region | None
    symmetric: bool
    has_width: bool = False

    @property
    def actuator(self) -> Actuator:
        """The device itself."""
        return self.build(Scale())

    @property
    def linear(self) -> bool:
        """Whether the deflection is a length."""
        return self.actuator.deflection_unit == "m"

    @property
    def reach(self) -> tuple[float, float]:
        """Scales of the steps of differences: largest |deflection|, smallest |setting| or its range."""
        largest = max(abs(end) for region in self.deflections for end in region)
        if self.setting is None:
            return largest, 1.0
        return largest, min(*(abs(end) for end in self.setting), self.setting[1] - self.setting[0])

    def place(self, unit: Floats) -> tuple[Floats, Floats]:
        """Points (deflection, setting) of numbers in the unit square, shape (POINTS, 2)."""
        share = unit[:, 0] * len(self.deflections)
        which = np.minimum(share.astype(int), len(self.deflections) - 1)
        low, high = np.array(self.deflections).T
        deflection = low[which] + (share - which) * (high - low)[which]
        if self.setting is None:
            return deflection, np.zeros_like(deflection)
        return deflection, self.setting[0] + unit[:, 1] * (self.setting[1] - self.setting[0])

    def sample(self, seed: int) -> tuple[Floats, Floats]:
        """A fixed batch of points."""
        return self.place(np.random.default_rng(seed).random((POINTS, 2)))

    def points(self) -> st.SearchStrategy[tuple[Floats, Floats]]:
        """Batches of points, the corners of the regions among them."""
        coordinate = st.floats(0.0, 1.0, width=32)
        row = st.tuples(coordinate, coordinate)
        rows = st.lists(row, min_size=POINTS, max_size=POINTS)
        return rows.map(lambda values: self.place(np.array(values)))


def _beam(scale: Scale) -> Leaf:
    return Leaf(
        youngs_modulus=194e9 * scale.modulus,
        width=0.02545 * scale.length * scale.width,
        thickness=0.00316 * scale.length,
        length=0.9 * scale.length,
        yield_strength=80e9,
    )


def _swivelling(scale: Scale) -> Actuator:
    size = scale.length
    return RollerBeam(
        beam=_beam(scale),
        rollers=SwivellingPair(offset=0.003 * size, clearance=0.0004 * size),
        mounting_angle=0.04,
        clamp_offset_along=0.03 * size,
        clamp_offset_across=-0.004 * size,
    )


def _swivelling_plain(scale: Scale) -> Actuator:
    return RollerBeam(beam=_beam(scale), rollers=SwivellingPair(offset=0.0, clearance=0.0002 * scale.length))


def _lower(scale: Scale) -> Actuator:
    size = scale.length
    return RollerBeam(
        beam=_beam(scale),
        rollers=SingleLower(offset=-0.007 * size, radius=0.012 * size),
        mounting_angle=-0.05,
        clamp_offset_along=-0.02 * size,
        clamp_offset_across=0.006 * size,
    )


def _upper(scale: Scale) -> Actuator:
    size = scale.length
    return RollerBeam(
        beam=_beam(scale),
        rollers=SingleUpper(offset=0.007 * size, radius=0.012 * size),
        mounting_angle=0.05,
        clamp_offset_along=-0.02 * size,
        clamp_offset_across=-0.006 * size,
    )


def _fixed_pair(scale: Scale) -> Actuator:
    size = scale.length
    return RollerBeam(
        beam=_beam(scale),
        rollers=FixedPair(offset=0.002 * size, radius=0.005 * size, clearance=0.004 * size),
        mounting_angle=0.03,
        clamp_offset_along=0.02 * size,
        clamp_offset_across=0.003 * size,
    )


def _torsion(scale: Scale) -> Actuator:
    size = scale.length
    return TorsionTube(
        shear_modulus=0.63e9 * scale.modulus,
        section=HollowCircle(outer_radius=0.011 * size, inner_radius=0.0087 * size),
        length=0.17 * size,
        series_stiffness=650.0 * scale.modulus * size**3,
        yield_strength=48e9,
    )


def _torsion_solid(scale: Scale) -> Actuator:
    return TorsionTube(
        shear_modulus=0.63e9 * scale.modulus, section=Circle(radius=0.009 * scale.length), yield_strength=48e9
    )


def _torsion_splined(scale: Scale) -> Actuator:
    """A solved section, and ends that lengthen it."""
    size = scale.length
    return TorsionTube(
        shear_modulus=0.63e9 * scale.modulus,
        section=SplinedTube(
            outer_radius=0.011 * size,
            inner_radius=0.0087 * size,
            rails=6,
            rail_width=0.004 * size,
            rail_height=0.0025 * size,
            root_fillet=0.0005 * size,
        ),
        end_effect=EndEffect(
            offset=0.0013 * size,
            lock_offset=0.002 * size,
            decay=0.004 * size,
            shortest=0.002 * size,
            longest=0.2 * size,
        ),
        yield_strength=48e9,
    )


def _antagonistic(law: Callable[[float], LeafLaw]) -> Callable[[Scale], Actuator]:
    def build(scale: Scale) -> Actuator:
        size = scale.length
        return AntagonisticLeaves(
            leaf=Leaf(
                youngs_modulus=210e9 * scale.modulus,
                width=0.05 * size * scale.width,
                thickness=0.0005 * size,
                yield_strength=80e9,
            ),
            law=law(size),
            roller_distance=0.345 * size,
            clamp_height=0.0405 * size,
        )

    return build


def _slider(theory: LeafJointTheory, driven_by: str) -> Callable[[Scale], Actuator]:
    def build(scale: Scale) -> Actuator:
        size = scale.length
        return SliderLeafJoint(
            leaf=Leaf(
                youngs_modulus=206e9 * scale.modulus,
                width=0.025 * size * scale.width,
                thickness=0.001 * size,
                length=0.04 * size,
                yield_strength=80e9,
            ),
            count=3,
            clamp_radius=0.025 * size,
            theory=theory,
            groove=Groove(
                inner_radius=0.025 * size,
                outer_radius=0.054 * size,
                outer_angle=math.radians(47),
                arc_radius=0.0368 * size,
                centre="near",
            ),
            driven_by=driven_by,
        )

    return build


def _series(scale: Scale) -> Actuator:
    return SeriesElastic(stiffness=160.0 * scale.modulus * scale.length**3)


def _maccepa(scale: Scale) -> Actuator:
    size = scale.length
    return Maccepa(spring_rate=394.0 * scale.modulus * size, lever_length=0.036 * size, anchor_distance=0.135 * size)


def _both(low: float, high: float) -> tuple[Region, ...]:
    """A region and its mirror image."""
    return ((low, high), (-high, -low))


CATALOGUE: tuple[Case, ...] = (
    Case("roller_swivelling", _swivelling, _both(0.20, 1.10), (0.2, 0.45), False, True),
    Case("roller_swivelling_plain", _swivelling_plain, _both(0.02, 1.45), (0.2, 0.45), True, True),
    Case("roller_lower", _lower, ((0.20, 1.30),), (0.2, 0.45), False, True),
    Case("roller_upper", _upper, ((-1.30, -0.20),), (0.2, 0.45), False, True),
    Case("roller_fixed_pair", _fixed_pair, _both(0.20, 0.60), (0.2, 0.45), False, True),
    Case("torsion_series", _torsion, ((-0.26, 0.26),), (0.011, 0.166), True),
    Case("torsion_splined", _torsion_splined, ((-0.26, 0.26),), (0.003, 0.166), True),
    Case("torsion_solid", _torsion_solid, ((-0.26, 0.26),), (0.011, 0.166), True),
    Case("leaves_guided", _antagonistic(lambda _: GuidedLeaf()), ((-0.015, 0.015),), (0.0615, 0.183), True, True),
    Case("leaves_sliding", _antagonistic(lambda _: SlidingLeaf()), ((-0.015, 0.015),), (0.0615, 0.183), True, True),
    Case(
        "leaves_wrapped",
        _antagonistic(lambda size: WrappedLeaf(protection_radius=0.035 * size)),
        _both(0.004, 0.013),  # one leaf of a pair lies on the cylinders, the other is free: away from both kinks
        (0.180, 0.185),
        True,
        True,
    ),
    # the groove ends at 29 mm: differences have to stay on it
    Case("slider_small_length", _slider(SmallDeflection(), "length"), _both(0.001, 0.02), (0.012, 0.0285), True, True),
    Case("slider_large_length", _slider(LargeDeflection(), "length"), _both(0.001, 0.2), (0.012, 0.0285), True, True),
    Case("slider_small_disc", _slider(SmallDeflection(), "disc"), _both(0.001, 0.02), (0.3, 0.8), True, True),
    Case("slider_large_disc", _slider(LargeDeflection(), "disc"), _both(0.001, 0.2), (0.3, 0.8), True, True),
    Case("series_elastic", _series, ((-0.17, 0.17),), None, True),
    Case("maccepa", _maccepa, ((-1.05, 1.05),), (0.005, 0.025), True),
)
