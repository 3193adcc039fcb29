"""The prototype of section III: the analytic design, the measured stiffness, and what lies between them."""

from __future__ import annotations

from collections.abc import Sequence

import jax
import jax.numpy as jnp
import numpy as np

from varistiff.actuators.torsion_tube import TorsionTube
from varistiff.core.status import Status
from varistiff.papers.schuy_2013 import paper_values as paper
from varistiff.papers.schuy_2013.corrected_reading import prototype
from varistiff.papers.schuy_2013.device import bare_tube, respond, stiffness, tube_of
from varistiff.papers.schuy_2013.rails import bare_section, stiffening
from varistiff.papers.schuy_2013.table_one import common_modulus

_SMALL = 1e-9  # relative; closed forms in double precision agree far better


def analytic_stiffness(*, shear_modulus: float = paper.POLYAMIDE, active_length: float = 0.166) -> float:
    """Return the stiffness of the tube without rails after Eq. (3) [N m/rad], by default with the printed G."""
    tube = bare_tube(shear_modulus=shear_modulus, bore_ratio=paper.RADIUS_RATIO, outer_radius=paper.OUTER_RADIUS)
    return stiffness(tube, active_length=active_length)


def analytic_stiffness_of_table() -> tuple[float, float]:
    """Return the same over the shear moduli that meet all four dimensions of Table I [N m/rad].

    Raises
    ------
    ValueError : no modulus meets them
    """
    common = common_modulus()
    if common is None:
        raise ValueError("no shear modulus meets the four dimensions of Table I")
    low, high = (analytic_stiffness(shear_modulus=modulus) for modulus in common)
    return low, high


def least_length() -> float:
    """Return the active length that an element has to have for the tests [m]: the longest one in them."""
    return max(paper.TESTED_LENGTHS)


def fits_element(*, element_length: float) -> bool:
    """Whether an element of a length [m] can be tested at every active length that the paper names."""
    tube = tube_of(shear_modulus=paper.POLYAMIDE, section=bare_section(), length=element_length)
    found = [int(respond(tube, twist=0.0, active_length=x).status) for x in paper.TESTED_LENGTHS]
    return Status.ELEMENT_TOO_SHORT not in found


def softest_reached_margin() -> tuple[float, float]:
    """Return how far the analytic design goes below 50 N m/rad, as a share of it: computed and as printed."""
    low, high = sorted(1.0 - k / paper.STIFFNESS_MIN for k in (analytic_stiffness(), paper.ANALYTIC_MIN))
    return low, high


def beyond_the_bearing_margin() -> float:
    """Return 1e-9 minus the relative change of stiffness when the element is longer beyond its counter bearing."""
    one, two = (
        stiffness(
            tube_of(shear_modulus=paper.POLYAMIDE, section=bare_section(), length=length),
            active_length=paper.ELEMENT_LENGTH,
        )
        for length in (0.17, 0.25)
    )
    return _SMALL - abs(two / one - 1.0)


def drive_angle(*, motor_angle: float) -> float:
    """Return the angle at the element's driven end from that of the motor [rad], over the gear; both rigid."""
    return motor_angle / paper.GEAR_RATIO


def stiffness_from_statics(*, gravity_torque: float, drive_angle: float, link_angle: float) -> float:
    """Return the stiffness that angles at rest give [N m/rad]; Eq. (9)."""
    return gravity_torque / (drive_angle - link_angle)


def fitted_line(*, twist: Sequence[float], torque: Sequence[float]) -> tuple[float, float]:
    """Return k_off [N m] and k_lin [N m/rad] of the line through torque over twist, by least squares.

    Parameters
    ----------
    twist : drive minus link angle at rest [rad]
    torque : of the pendulum there [N m]
    """
    slope, offset = np.polynomial.polynomial.polyfit(np.asarray(twist), np.asarray(torque), 1)[::-1]
    return float(offset), float(slope)


def statics_margin() -> float:
    """Return 1e-9 minus the relative error of Eq. (9) on the device at rest, over the tested lengths.

    The pendulum is balanced by the device's torque, and the slope of its energy has to say the same.
    """
    tube, link, gravity = _printed_tube(), 0.4, 3.0  # rad, N m: any will do
    worst = 0.0
    for x in paper.TESTED_LENGTHS:
        expected = stiffness(tube, active_length=x)
        drive = drive_angle(motor_angle=paper.GEAR_RATIO * (link + gravity / expected))
        slope = float(jax.grad(tube.energy)(jnp.asarray(drive - link), jnp.asarray(x)))
        for held in (float(respond(tube, twist=drive - link, active_length=x).load), slope):
            found = stiffness_from_statics(gravity_torque=held, drive_angle=drive, link_angle=link)
            worst = max(worst, abs(found / expected - 1.0), abs(held / gravity - 1.0))
    return _SMALL - worst


def linearity_margin() -> float:
    """Return 1e-9 minus the relative change of the secant stiffness over 15 degrees, over the tested lengths."""
    tube = _printed_tube()
    worst = 0.0
    for x in paper.TESTED_LENGTHS:
        small, large = (float(respond(tube, twist=twist, active_length=x).load) / twist for twist in (1e-3, 0.26))
        worst = max(worst, abs(large / small - 1.0))
    return _SMALL - worst


def torque_offset_margin() -> float:
    """Return 1e-9 N m minus the largest torque at rest over the tested lengths."""
    tube = _printed_tube()
    return _SMALL - max(abs(float(respond(tube, twist=0.0, active_length=x).load)) for x in paper.TESTED_LENGTHS)


def measured_stiffness(*, active_length: float = 0.166) -> float:
    """Return the stiffness of the whole drive train under the corrected reading [N m/rad]."""
    return stiffness(prototype(), active_length=active_length)


def crossing() -> float:
    """Return the active length at which the whole drive train is as stiff as the analytic tube [m].

    Both compliances are straight lines over the length; the difference of the lines vanishes there.
    """
    tube, at = prototype(), 0.1  # m
    alone = tube_of(shear_modulus=tube.shear_modulus, section=tube.section)
    whole, rails, bare = (1.0 / stiffness(one, active_length=at) for one in (tube, alone, _analytic()))
    return at * (whole - rails) / (bare - rails)


def measured_above_margin() -> float:
    """Return the smallest excess of the measured over the analytic stiffness at tested lengths above 0.04 m."""
    return min(_excess(x) for x in paper.TESTED_LENGTHS if x > paper.CROSSING)


def measured_below_margin() -> float:
    """Return the smallest excess of the analytic over the measured stiffness at tested lengths below 0.04 m."""
    return min(1.0 / (1.0 + _excess(x)) - 1.0 for x in paper.TESTED_LENGTHS if x < paper.CROSSING)


def finite_at_clamp_margin() -> float:
    """Return 1e-3 minus the relative change of the measured stiffness over the last decade towards the clamp."""
    near, nearer = (measured_stiffness(active_length=x) for x in (1e-6, 1e-7))
    return 1e-3 - abs(nearer / near - 1.0)


def reinforcement_margin() -> float:
    """Return how much rails raise J at least, the smallest and the largest that are assumed, as a ratio less 1."""
    return min(stiffening())


def range_covered_margin() -> float:
    """Return the excess of the drive train over 350 N m/rad at the shortest tested length, as a ratio less 1."""
    return measured_stiffness(active_length=paper.TESTED_LENGTHS[0]) / paper.STIFFNESS_MAX - 1.0


def most_of_range_margin() -> float:
    """Return the share of the required range that the drive train reaches over the tested lengths, minus one half."""
    reached = [measured_stiffness(active_length=x) for x in paper.TESTED_LENGTHS]
    low, high = max(min(reached), paper.STIFFNESS_MIN), min(max(reached), paper.STIFFNESS_MAX)
    return (high - low) / (paper.STIFFNESS_MAX - paper.STIFFNESS_MIN) - 0.5


def excess_from_rails_margin() -> float:
    """Return the share of the printed 62 % that section theory gives with the fitted rails, minus one half."""
    raised = float(prototype().torsion_constant / bare_section().torsion_constant) - 1.0
    return raised / paper.SOLID_EXCESS - 0.5


def whole_range_margin() -> float:
    """Return the excess over 350 N m/rad at the shortest length of the element that has 50 N m/rad at the longest.

    The rest of the drive train is the corrected reading's; the element's J is free.
    """
    series = prototype().series_stiffness
    near, far = paper.TESTED_LENGTHS[0], paper.TESTED_LENGTHS[-1]
    rigidity = far / (1.0 / paper.STIFFNESS_MIN - 1.0 / series)
    scale = rigidity / (prototype().shear_modulus * bare_section().torsion_constant)
    tube = tube_of(shear_modulus=prototype().shear_modulus * scale, section=bare_section(), series_stiffness=series)
    return stiffness(tube, active_length=near) / paper.STIFFNESS_MAX - 1.0


def element_above_drive_train_margin() -> float:
    """Return the smallest excess of the element alone over the whole drive train, over the tested lengths."""
    return min(_alone_excess(x) for x in paper.TESTED_LENGTHS)


def closer_when_long_margin() -> float:
    """Return by how much that excess shrinks from the shortest to the longest tested length."""
    return _alone_excess(paper.TESTED_LENGTHS[0]) - _alone_excess(paper.TESTED_LENGTHS[-1])


def constant_deviation_margin() -> float:
    """Return 5 % minus the change of measured/analytic between 0.04 m and 0.166 m, from the printed numbers."""
    return 0.05 - abs(paper.MEASURED_MIN / paper.ANALYTIC_MIN - 1.0)


def _printed_tube() -> TorsionTube:
    """The tube without rails with the printed shear modulus."""
    return tube_of(shear_modulus=paper.POLYAMIDE, section=bare_section())


def _analytic() -> TorsionTube:
    return tube_of(shear_modulus=prototype().shear_modulus, section=bare_section())


def _excess(active_length: float) -> float:
    analytic = stiffness(_analytic(), active_length=active_length)
    return measured_stiffness(active_length=active_length) / analytic - 1.0


def _alone_excess(active_length: float) -> float:
    tube = prototype()
    alone = tube_of(shear_modulus=tube.shear_modulus, section=tube.section)
    return stiffness(alone, active_length=active_length) / stiffness(tube, active_length=active_length) - 1.0
