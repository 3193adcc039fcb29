"""From a published leaf device at one point to the leaves that the 3-D check solves, and back to the device's load."""

from __future__ import annotations

import math
from collections.abc import Sequence
from typing import NamedTuple

import equinox as eqx
import jax
import jax.numpy as jnp
import numpy as np

from varistiff.actuators.actuator import Actuator
from varistiff.actuators.antagonistic_leaves import AntagonisticLeaves
from varistiff.actuators.compiled import respond_block
from varistiff.actuators.leaf_joint_theory import LargeDeflection
from varistiff.actuators.roller_beam import RollerBeam
from varistiff.actuators.slider_leaf_joint import SliderLeafJoint
from varistiff.core.errors import InputError
from varistiff.core.status import Status
from varistiff.elastic.guided_leaf import GuidedLeaf
from varistiff.elastic.leaf import Leaf
from varistiff.elastic.leaf_law import LeafLaw
from varistiff.elastic.sliding_leaf import end_curvature, free_shape
from varistiff.elastic.wrapped_leaf import WrappedLeaf
from varistiff.fe.leaf_problem import Hold, LeafProblem, LeafResult, Motion, SlidingContact, UprightContact

_TAIL_WIDTHS = 1.0  # the free end is at rest after about one width
_SHORT_TAIL = 0.05  # of the width: shorter ones are left out
_free_shape = jax.jit(free_shape)  # unjitted, each call would compile its conditionals again
_NEARLY_WRAPPED = 0.9  # of the cylinder's curvature: the solid bends a little tighter at its clamp


def is_leaf_device(actuator: Actuator) -> bool:
    """Whether ``problems_of`` knows the actuator."""
    return isinstance(actuator, RollerBeam | AntagonisticLeaves | SliderLeafJoint)


class BeamAnswer(NamedTuple):
    """Numbers of the beam theory at one point, SI units of the device."""

    load: float
    stiffness: float
    energy: float
    stress: float


def beam_answer(actuator: Actuator, deflection: float, setting: float) -> tuple[BeamAnswer, dict[str, float]]:
    """Numbers and details of the exact beam theory at one point.

    The slider leaf joint answers with its exact leaf, whatever theory the design asks for.

    Raises
    ------
    InputError : the point has no numbers or no contact; one line with what to change
    """
    if isinstance(actuator, SliderLeafJoint):
        actuator = eqx.tree_at(lambda joint: joint.theory, actuator, LargeDeflection())
    response, details = respond_block(actuator, np.array([float(deflection)]), np.array([float(setting)]))
    status = Status(int(response.status[0]))
    if status in (Status.NO_CONTACT, Status.OUTSIDE_VALIDITY) or not math.isfinite(float(response.load[0])):
        at = f"{_said(deflection, actuator.deflection_unit)} at the setting {_said(setting, actuator.setting_unit)}"
        remedy = status.remedy[:1].lower() + status.remedy[1:].removesuffix(".")
        raise InputError(f"{at} is {status.label}; allowed is a point with a load: {remedy}", field="deflection")
    numbers = BeamAnswer(
        load=float(response.load[0]),
        stiffness=float(response.stiffness[0]),
        energy=float(response.energy[0]),
        stress=float(response.stress[0]),
    )
    return numbers, {name: float(values[0]) for name, values in details.items()}


def _said(value: float, unit: str | None) -> str:
    return f"{math.degrees(value):.6g} deg" if unit == "rad" else f"{1e3 * value:.6g} mm"


def problems_of(
    actuator: Actuator, deflection: float, setting: float, *, poissons_ratio: float
) -> tuple[LeafProblem, ...]:
    """The leaves that make the device's load at one point: one, or left and right of the antagonistic leaves.

    Only published geometry enters, not the beam theory's answer (which bounds the length of the free end).

    Parameters
    ----------
    actuator : RollerBeam, AntagonisticLeaves or SliderLeafJoint
    deflection, setting : of the device, SI
    poissons_ratio : of the leaf [-]

    Raises
    ------
    InputError : another kind of actuator, or a point without a solution or contact
    """
    if not isinstance(actuator, RollerBeam | AntagonisticLeaves | SliderLeafJoint):
        raise InputError(
            f"is {actuator.kind}; the 3-D leaf check is for roller_beam, antagonistic_leaves and slider_leaf_joint",
            field="actuator.kind",
        )
    _, details = beam_answer(actuator, deflection, setting)
    if isinstance(actuator, RollerBeam):
        return (_roller_beam(actuator, deflection, setting, poissons_ratio, details["active_length"]),)
    if isinstance(actuator, SliderLeafJoint):
        if deflection == 0.0:
            raise InputError("is 0, where the leaf is straight; allowed is another deflection", field="deflection")
        return (_slider_leaf(actuator, deflection, setting, poissons_ratio, details["active_arc_length"]),)
    return _antagonistic(actuator, deflection, setting, poissons_ratio)


def problem_of(actuator: Actuator, deflection: float, setting: float, *, poissons_ratio: float) -> LeafProblem:
    """The only leaf of a roller beam or slider leaf joint; see ``problems_of``."""
    problems = problems_of(actuator, deflection, setting, poissons_ratio=poissons_ratio)
    if len(problems) > 1:
        raise InputError("has more than one leaf; use problems_of", field="actuator.kind")
    return problems[0]


def load_of(results: Sequence[LeafResult]) -> float:
    """The device's load: a torque [N m] or a force [N]."""
    return math.fsum(result.load for result in results)


def stiffness_of(results: Sequence[LeafResult]) -> float:
    """The device's tangent stiffness."""
    return math.fsum(result.stiffness for result in results)


def energy_of(results: Sequence[LeafResult]) -> float:
    """The device's elastic energy [J]."""
    return math.fsum(result.problem.motion.copies * result.energy for result in results)


def _problem(
    leaf: Leaf, hold: Hold, motion: Motion, *, poissons_ratio: float, arc: float, tail: bool, side: float, name: str
) -> LeafProblem:
    length = min(leaf.length - arc, _TAIL_WIDTHS * leaf.width) if tail else 0.0
    return LeafProblem(
        youngs_modulus=float(leaf.youngs_modulus),
        poissons_ratio=poissons_ratio,
        width=float(leaf.width),
        thickness=float(leaf.thickness),
        hold=hold,
        tail=float(length) if length > _SHORT_TAIL * leaf.width else 0.0,
        motion=motion,
        side=side,
        name=name,
    )


def _turning(centre: tuple[float, float], joint: tuple[float, float], side: float, copies: float) -> Motion:
    """Motion of a point that turns about a joint, in the leaf's frame (mirrored where side is -1)."""
    x, y = centre[0] - joint[0], centre[1] - joint[1]
    return Motion(rate=(-y, side * x), acceleration=(-x, -side * y), copies=copies)


def _roller_beam(
    actuator: RollerBeam, deflection: float, setting: float, poissons_ratio: float, arc: float
) -> LeafProblem:
    angle, position = jnp.asarray(float(deflection)), jnp.asarray(float(setting))
    bearing = actuator.rollers.acting(lambda offset: actuator.centre(angle, position, offset), actuator.beam.thickness)
    side = float(bearing.side)
    x, y = map(float, actuator.centre(angle, position, bearing.offset))
    joint_x, joint_y = map(float, actuator.joint())
    return _problem(
        actuator.beam,
        SlidingContact((x, side * y), float(bearing.radius)),
        _turning((x, y), (joint_x, joint_y), side, 1.0),
        poissons_ratio=poissons_ratio,
        arc=arc,
        tail=True,
        side=side,
        name="beam",
    )


def _slider_leaf(
    actuator: SliderLeafJoint, deflection: float, setting: float, poissons_ratio: float, arc: float
) -> LeafProblem:
    radius = actuator.clamp_radius + float(actuator.active_length(jnp.asarray(float(setting))))
    side = math.copysign(1.0, deflection)
    x, y = radius * math.cos(deflection) - actuator.clamp_radius, radius * math.sin(deflection)
    return _problem(
        actuator.leaf,
        SlidingContact((x, side * y)),
        _turning((x, y), (-actuator.clamp_radius, 0.0), side, float(actuator.count)),
        poissons_ratio=poissons_ratio,
        arc=arc,
        tail=True,
        side=side,
        name="leaf",
    )


def _antagonistic(
    actuator: AntagonisticLeaves, deflection: float, setting: float, poissons_ratio: float
) -> tuple[LeafProblem, ...]:
    """Half a leaf from its clamp to its middle, which stays straight across and in place by point symmetry."""
    rise, leaf = float(actuator.clamp_height), actuator.leaf
    spans = np.asarray(actuator.spans(jnp.asarray(float(deflection)), jnp.asarray(float(setting))))
    problems = []
    for span, direction, name in zip(spans, (-1.0, 1.0), ("left leaf", "right leaf"), strict=True):
        middle = (0.5 * float(span), 0.5 * rise)
        hold: Hold = UprightContact(middle)
        if not isinstance(actuator.law, GuidedLeaf):
            hold = SlidingContact(middle, guard_radius=_guard(actuator.law, float(span), rise))
        # two leaves on each side, two halves each; half the span moves by half the deflection
        motion = Motion(rate=(0.5 * direction, 0.0), copies=4.0)
        problems.append(
            _problem(leaf, hold, motion, poissons_ratio=poissons_ratio, arc=0.0, tail=False, side=1.0, name=name)
        )
    return tuple(problems)


def _guard(law: LeafLaw, span: float, rise: float) -> float:
    """Radius of the protection cylinder that the leaf lies on [m], infinite where it lies on none."""
    if not isinstance(law, WrappedLeaf) or rise > 4.0 * law.protection_radius:
        return math.inf
    shape = _free_shape(jnp.asarray(span), jnp.asarray(rise))
    tight = float(end_curvature(shape)) * law.protection_radius > _NEARLY_WRAPPED or float(shape.terms.cosine) < 0.0
    return float(law.protection_radius) if tight else math.inf
