"""The joint and the groove of Wang et al. (2024) as varistiff's own devices."""

from __future__ import annotations

from typing import NamedTuple

import numpy as np
import numpy.typing as npt

from varistiff.actuators import Groove, SliderLeafJoint
from varistiff.actuators.compiled import respond_block
from varistiff.actuators.leaf_joint_theory import LargeDeflection, SmallDeflection
from varistiff.elastic.leaf import Leaf
from varistiff.papers.wang_2024 import paper_values as paper

Numbers = npt.NDArray[np.float64]


class Answer(NamedTuple):
    """What the joint answers, SI units, one shape."""

    energy: Numbers
    torque: Numbers
    stiffness: Numbers
    thrust: Numbers  # dV/dl_1 [N]
    stress: Numbers
    rotation: Numbers  # of the leaf at the slider [rad]


def joint(
    *,
    exact: bool = False,
    count: int = paper.COUNT,
    youngs_modulus: float = paper.YOUNGS_MODULUS,
    width: float = paper.WIDTH,
    thickness: float = paper.THICKNESS,
    clamp_radius: float = paper.CLAMP_RADIUS,
) -> SliderLeafJoint:
    """Joint of Table 2, by the paper's theory or by the exact leaf; SI units."""
    return SliderLeafJoint(
        leaf=Leaf(youngs_modulus=youngs_modulus, width=width, thickness=thickness),
        count=count,
        clamp_radius=clamp_radius,
        theory=LargeDeflection() if exact else SmallDeflection(),
    )


def answer(actuator: SliderLeafJoint, *, deflection: npt.ArrayLike, length: npt.ArrayLike) -> Answer:
    """Answer at deflections [rad] and active lengths [m] of shapes that broadcast."""
    phi, l_1 = np.broadcast_arrays(np.asarray(deflection, float), np.asarray(length, float))
    response, details = respond_block(actuator, phi.ravel(), l_1.ravel())
    fields = (response.energy, response.load, response.stiffness, response.adjusting_load, response.stress)
    numbers = (np.asarray(field).reshape(phi.shape) for field in (*fields, details["leaf_rotation"]))
    return Answer(*numbers)


def groove(arc_radius: float, *, centre: str = "near") -> Groove:
    """Groove through A and C of Table 2 with an arc radius [m], which the paper does not give."""
    return Groove(
        inner_radius=paper.CLAMP_RADIUS,
        outer_radius=paper.OUTER_RADIUS,
        outer_angle=paper.OUTER_ANGLE,
        arc_radius=arc_radius,
        centre=centre,
    )


def effective_lengths(count: int = 39) -> Numbers:
    """Active lengths of the paper's effective range [m]."""
    return np.linspace(paper.LENGTH_MIN, paper.LENGTH_MAX, count)


def deflections(count: int = 13) -> Numbers:
    """Deflections from rest to the printed limit [rad]."""
    return np.linspace(0.0, paper.DEFLECTION_LIMIT, count)
