"""The chains of a slider leaf joint: the straight line as published, and the exact groove."""

from __future__ import annotations

from typing import NamedTuple

import jax.numpy as jnp
import numpy as np

from varistiff.actuators.groove import Groove
from varistiff.actuators.slider_leaf_joint import SliderLeafJoint
from varistiff.core.errors import InputError
from varistiff.dynamics.control.active_length import active_length_from_stiffness
from varistiff.dynamics.control.checks import check_range, is_traced
from varistiff.dynamics.control.controller import Number, Scalar, as_scalar
from varistiff.dynamics.control.stiffness_chain import StiffnessChain
from varistiff.dynamics.control.straight_line import StraightLine, straight_line


class UsedRange(NamedTuple):
    """Active lengths [m] and disc angles [rad] between which a chain works."""

    length_min: Number
    length_max: Number
    angle_min: Number
    angle_max: Number


class ExactChain(StiffnessChain):
    """Stiffness command to Eq. (9) at rest, to l_1, to the disc angle on the groove's own circle.

    Parameters
    ----------
    joint : with a groove
    used : lengths and disc angles between which it works; ``exact_chain`` finds them from a range of settings
    """

    joint: SliderLeafJoint
    used: UsedRange

    def motion(self, stiffness: Number, deflection: Number) -> Scalar:
        """Disc angle [rad]; the deflection is not asked. See ``StiffnessChain.motion``."""
        del deflection
        return _groove(self.joint).angle(_commanded_length(self, stiffness))

    def stiffness(self, motion: Number, deflection: Number) -> Scalar:
        """Stiffness at rest [N m/rad] at a disc angle [rad]."""
        del deflection
        return _rest_stiffness(self.joint, _groove(self.joint).active_length(as_scalar(motion)))

    def reach(self) -> tuple[Scalar, Scalar]:
        """See ``StiffnessChain.reach``."""
        return _reach(self)


class WangChain(StiffnessChain):
    """Wang's chain as published: stiffness command to Eq. (9) at rest, to l_1, to the disc angle a = (l_1 - q)/p.

    The straight line l_1 = p a + q of Eq. (16) stands for the groove; the disc is not sent beyond the angles of the
    used range. ``length_error`` and ``stiffness_error`` tell what the line costs.

    Parameters
    ----------
    joint : with a groove
    used : lengths and disc angles between which it works; ``wang_chain`` finds them from a range of settings
    line : p [m/rad] and q [m]

    Notes
    -----
    Wang et al. (2024), section 4.2, doi 10.3390/app14072685. Eq. (9) is taken at phi = 0: its cos(phi) is 0.9986 at
    the paper's 3.03 degrees.
    """

    joint: SliderLeafJoint
    used: UsedRange
    line: StraightLine

    def motion(self, stiffness: Number, deflection: Number) -> Scalar:
        """Disc angle [rad]; the deflection is not asked. See ``StiffnessChain.motion``."""
        del deflection
        angle = (_commanded_length(self, stiffness) - self.line.intercept) / self.line.slope
        return jnp.clip(angle, self.used.angle_min, self.used.angle_max)

    def stiffness(self, motion: Number, deflection: Number) -> Scalar:
        """Stiffness at rest [N m/rad] that the line tells at a disc angle [rad]."""
        del deflection
        return _rest_stiffness(self.joint, self.line.slope * as_scalar(motion) + self.line.intercept)

    def reach(self) -> tuple[Scalar, Scalar]:
        """See ``StiffnessChain.reach``."""
        return _reach(self)

    def length_error(self, motion: Number) -> Scalar:
        """Length by the line minus length in the groove [m] at a disc angle [rad]: q at A, p a_1 + q - l_1 at C."""
        angle = as_scalar(motion)
        return self.line.slope * angle + self.line.intercept - _groove(self.joint).active_length(angle)

    def stiffness_error(self, stiffness: Number) -> Scalar:
        """Stiffness at rest that a command [N m/rad] ends in, minus the command [N m/rad]."""
        length = _groove(self.joint).active_length(self.motion(stiffness, 0.0))
        return _rest_stiffness(self.joint, length) - as_scalar(stiffness)


def exact_chain(joint: SliderLeafJoint, *, setting_min: Number, setting_max: Number) -> ExactChain:
    """Exact chain over a range of the joint's settings [m], or [rad] where the disc drives it.

    Raises
    ------
    InputError : the joint has no groove, or the range is empty or not on it
    """
    return ExactChain(joint, _used_range(joint, setting_min, setting_max))


def wang_chain(joint: SliderLeafJoint, *, setting_min: Number, setting_max: Number) -> WangChain:
    """Wang's chain with the line fitted by least squares to a range of the joint's settings [m or rad].

    Raises
    ------
    InputError : the joint has no groove, or the range is empty or not on it
    """
    used = _used_range(joint, setting_min, setting_max)
    return WangChain(joint, used, straight_line(_groove(joint), used.angle_min, used.angle_max))


def _groove(joint: SliderLeafJoint) -> Groove:
    if joint.groove is None:
        raise InputError("the chain from stiffness to disc angle needs a groove", field="actuator.groove")
    return joint.groove


def _used_range(joint: SliderLeafJoint, setting_min: Number, setting_max: Number) -> UsedRange:
    groove = _groove(joint)
    check_range("setting", setting_min, setting_max)
    lengths = [joint.active_length(as_scalar(setting)) for setting in (setting_min, setting_max)]
    angles = [groove.angle(length) for length in lengths]
    for field, length, angle in zip(("setting_min", "setting_max"), lengths, angles, strict=True):
        if not is_traced(angle) and not (float(length) > 0.0 and np.isfinite(angle)):
            raise InputError(f"an active length of {float(length):.6g} m is not on the groove", field=field)
    # plain numbers where they are known: they are handed over faster, run by run
    return UsedRange(*(end if is_traced(end) else float(end) for end in (*lengths, *angles)))


def _rest_stiffness(joint: SliderLeafJoint, length: Scalar) -> Scalar:
    """Eq. (9) at phi = 0."""
    return 3.0 * joint.count * joint.leaf.flexural_rigidity * (joint.clamp_radius + length) ** 2 / length**3


def _reach(chain: ExactChain | WangChain) -> tuple[Scalar, Scalar]:
    """Stiffness at rest of the longest and of the shortest active length used."""
    ends = as_scalar(chain.used.length_max), as_scalar(chain.used.length_min)
    return _rest_stiffness(chain.joint, ends[0]), _rest_stiffness(chain.joint, ends[1])


def _commanded_length(chain: ExactChain | WangChain, stiffness: Number) -> Scalar:
    """l_1 of a command, held in the used range."""
    joint = chain.joint
    length_min, length_max = chain.used.length_min, chain.used.length_max
    softest, stiffest = _reach(chain)
    # the command is held first: a stiffness of 0 or below has no length
    length = active_length_from_stiffness(
        jnp.clip(as_scalar(stiffness), softest, stiffest),
        bending=3.0 * joint.count * joint.leaf.flexural_rigidity,
        clamp_radius=joint.clamp_radius,
    )
    return jnp.clip(length, length_min, length_max)
