"""Torque, stiffness, resistance and energy held against each other: each is the slope or the work of another.

Signs and factors of Eqs. (7) to (12) are seen here, for the paper's theory and for the exact leaf.
"""

from __future__ import annotations

from collections.abc import Callable

import numpy as np
import numpy.typing as npt

from varistiff.actuators import SliderLeafJoint
from varistiff.papers.wang_2024 import paper_values as paper
from varistiff.papers.wang_2024.device import Numbers, answer, deflections, effective_lengths, groove, joint
from varistiff.papers.wang_2024.printed_equations import resistance_as_printed

_STEP = 1e-5  # of a central difference, as a share of the point: truncation and rounding stay below 1e-9
_NODES, _WEIGHTS = np.polynomial.legendre.leggauss(48)  # exact to rounding for the courses here
_ARC_RADII = (0.025, 0.04, 1.0)  # m; the groove's is not published, and any will do


def _slope(course: Callable[[Numbers], Numbers], points: Numbers) -> Numbers:
    """Derivative at points away from zero, by central differences."""
    step = _STEP * points
    return (course(points + step) - course(points - step)) / (2.0 * step)


def _integral(course: Callable[[Numbers], Numbers], start: float, end: float) -> float:
    """Integral from ``start`` to ``end``, by Gauss quadrature."""
    half = 0.5 * (end - start)
    return float(half * (_WEIGHTS * course(start + half * (1.0 + _NODES))).sum())


def _off(found: npt.ArrayLike, wanted: npt.ArrayLike) -> float:
    """Largest relative difference."""
    return float(np.abs(np.asarray(found) / np.asarray(wanted) - 1.0).max())


def _stiffness_off(actuator: SliderLeafJoint) -> float:
    """Relative difference of the stiffness from d(torque)/d(deflection)."""
    phi, lengths = deflections()[1:, None], effective_lengths(9)
    slope = _slope(lambda values: answer(actuator, deflection=values, length=lengths).torque, phi)
    return _off(answer(actuator, deflection=phi, length=lengths).stiffness, slope)


def stiffness_is_slope_of_torque() -> float:
    """1e-6 less the relative difference of the stiffness from d(torque)/d(deflection), both theories (Eqs. 8, 9)."""
    return 1e-6 - max(_stiffness_off(joint()), _stiffness_off(joint(exact=True)))


def _torque_work(actuator: SliderLeafJoint, length: float) -> float:
    """Work [J] of the torque from rest to the printed limit of deflection, at one length [m]."""
    return _integral(lambda phi: answer(actuator, deflection=phi, length=length).torque, 0.0, paper.DEFLECTION_LIMIT)


def energy_is_work() -> float:
    """1e-9 less the relative difference of the energy from the work of the torque, one leaf and three (Eq. 10)."""
    off = []
    for actuator in (joint(), joint(count=3)):
        lengths = effective_lengths(5)
        energy = answer(actuator, deflection=paper.DEFLECTION_LIMIT, length=lengths).energy
        off.append(_off(energy, [_torque_work(actuator, float(length)) for length in lengths]))
    return 1e-9 - max(off)


def _thrust_off(actuator: SliderLeafJoint, settings: Numbers) -> float:
    """Relative difference of the adjusting load from d(energy)/d(setting)."""
    phi = deflections()[1:, None]
    slope = _slope(lambda values: answer(actuator, deflection=phi, length=values).energy, settings)
    return _off(answer(actuator, deflection=phi, length=settings).thrust, slope)


def _driven_by_disc(arc_radius: float) -> SliderLeafJoint:
    """Joint of Table 2 that is set by the angle of a stiffness disc, whose groove has an arc radius [m]."""
    printed = joint()
    return SliderLeafJoint(
        printed.leaf, printed.count, printed.clamp_radius, printed.theory, groove(arc_radius), driven_by="disc"
    )


def resistance_is_slope_of_energy() -> float:
    """1e-6 less the relative difference of the resistance from dV/dl_1, from Eq. (12), and from dV/d(alpha).

    Both theories set by the length, the paper's with three leaves and set by the disc too; Eq. (12) gives the magnitude
    for one leaf.
    """
    lengths = effective_lengths(9)
    angles = np.linspace(0.35, 0.95, 7) * paper.OUTER_ANGLE
    rigidity = paper.YOUNGS_MODULUS * paper.WIDTH * paper.THICKNESS**3
    ours = answer(joint(count=1), deflection=paper.DEFLECTION_LIMIT, length=lengths).thrust
    printed = [
        resistance_as_printed(
            rigidity=rigidity,
            clamp_radius=paper.CLAMP_RADIUS,
            length=float(length),
            deflection=paper.DEFLECTION_LIMIT,
        )
        for length in lengths
    ]
    return 1e-6 - max(
        _off(-ours, printed),
        *(_thrust_off(actuator, lengths) for actuator in (joint(), joint(count=3), joint(exact=True))),
        *(_thrust_off(_driven_by_disc(radius), angles) for radius in _ARC_RADII),
    )


def energy_is_returned() -> float:
    """1e-9 less the net work of a closed path through deflection and length, over the energy stored on it.

    The joint is deflected to the printed limit at 6 mm, lengthened to 25 mm, brought back to rest and shortened.
    """
    actuator, limit = joint(), paper.DEFLECTION_LIMIT
    short, long = paper.LENGTH_MIN, paper.LENGTH_MAX
    lengthening = _integral(lambda l_1: answer(actuator, deflection=limit, length=l_1).thrust, short, long)
    shortening = _integral(lambda l_1: answer(actuator, deflection=0.0, length=l_1).thrust, long, short)
    net = _torque_work(actuator, short) + lengthening - _torque_work(actuator, long) + shortening
    return 1e-9 - abs(net) / float(answer(actuator, deflection=limit, length=short).energy)
