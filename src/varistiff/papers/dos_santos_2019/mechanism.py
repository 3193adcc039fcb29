"""Sections 2 and 3: what the roller beam does with its energy, its moment, its thrust and its stiffness.

The paper gives no dimension of its mechanism. What holds of every geometry is computed for ``GEOMETRIES``, none of
which is the paper's; the rest for the simplest one, its clamp at the joint and its rollers on the link's axis.
"""

from __future__ import annotations

import math
from dataclasses import replace
from functools import cache

import jax.numpy as jnp
import numpy as np
from scipy.interpolate import RegularGridInterpolator

from varistiff.actuators.roller_beam import RollerBeam
from varistiff.actuators.rollers import SingleLower, SwivellingPair
from varistiff.characteristic.evaluate import Points, evaluate
from varistiff.dynamics.gait.knee import knee_gait
from varistiff.papers.dos_santos_2019.beams import leaf, material
from varistiff.papers.dos_santos_2019.elastica import printed_integral
from varistiff.papers.dos_santos_2019.paper_values import ACTIVE_LENGTHS, BEAMS

IDENTITY = 1e-9  # relative: rounding of sums of a few terms, far below any printed digit
SETTINGS = np.linspace(ACTIVE_LENGTHS["l_2"], ACTIVE_LENGTHS["l_1"], 9)
DEFLECTIONS = np.radians([2.0, 6.0, 10.0, 18.0])  # of the joint, over the range of the experiment

# alpha_w, d_1, d_0, d_r, roller radius, x_r, theta_j: invented, in rad and m
GEOMETRIES = (
    (0.0, 0.0, 0.0, 0.0, 0.010, 0.50, 0.15),
    (0.2, 0.05, 0.02, 0.03, 0.012, 0.55, 0.05),
    (-0.1, 0.10, -0.03, 0.01, 0.008, 0.60, 0.45),
    (0.3, -0.04, 0.05, -0.02, 0.015, 0.45, 0.20),
)


def joint(beam: str = "spring_steel", *, clearance: float = 0.0, offset: float = 0.0) -> RollerBeam:
    """Simplest actuator: the beam's clamp at the joint, the swivelling pair of the paper at ``offset`` [m]."""
    return RollerBeam(beam=leaf(beam), rollers=SwivellingPair(offset=offset, clearance=clearance))


def _general(geometry: tuple[float, ...]) -> tuple[RollerBeam, float, float]:
    mounting, along, across, offset, radius, setting, deflection = geometry
    actuator = RollerBeam(
        beam=leaf("spring_steel"),
        rollers=SingleLower(offset=offset, radius=radius),
        mounting_angle=mounting,
        clamp_offset_along=along,
        clamp_offset_across=across,
    )
    return actuator, deflection, setting


def _number(points: Points, name: str) -> float:
    return float(points.details[name]) if name in points.details else float(getattr(points, name))


def printed_contact(geometry: tuple[float, ...], slope: float) -> tuple[float, float]:
    """a and b [m] by Eqs. (10) and (11) as printed; r is the roller's radius plus half the beam's thickness."""
    mounting, d_1, d_0, d_r, radius, x_r, theta_j = geometry
    angle, r = mounting + theta_j, radius + 0.5 * leaf("spring_steel").thickness
    a = x_r * math.cos(angle) - d_r * math.sin(angle) - r * math.sin(slope)
    b = x_r * math.sin(angle) + d_r * math.cos(angle) + r * math.cos(slope)
    return (
        a - d_1 * math.cos(mounting) + d_0 * math.sin(mounting),
        b - d_0 * math.cos(mounting) - d_1 * math.sin(mounting),
    )


def frames_give_place() -> float:
    """Margin of Eqs. (10) and (11): 1e-9 m, less their largest distance from the device's contact [m].

    The contact is the device's roller centre and a radius along its normal, and the end of the bent part of its beam.
    """
    misses = []
    for geometry in GEOMETRIES:
        actuator, deflection, setting = _general(geometry)
        slope = _number(evaluate(actuator, deflection, setting), "contact_slope")
        centre = np.array(actuator.centre(*map(jnp.asarray, (deflection, setting, geometry[3]))))
        r = geometry[4] + 0.5 * actuator.beam.thickness
        printed = np.array(printed_contact(geometry, slope))
        for place in (
            centre + r * np.array([-math.sin(slope), math.cos(slope)]),
            actuator.element_shapes(deflection, setting)[0][-2],  # the last point is the free end
        ):
            misses.append(float(np.abs(place - printed).max()))
    return 1e-9 - max(misses)


def ratio_of_slope_alone() -> float:
    """Margin of Eq. (12): b/a by Eqs. (10), (11) at the device's slope against the ratio of the two integrals."""
    misses = []
    for geometry in GEOMETRIES:
        slope = _number(evaluate(*_general(geometry)), "contact_slope")
        a, b = printed_contact(geometry, slope)
        misses.append(abs(b / a * printed_integral(slope, "cos") / printed_integral(slope, "sin") - 1.0))
    return IDENTITY - max(misses)


def length_from_either() -> float:
    """Margin of Eqs. (4) and (5): the active length from a, and from b, against the device's."""
    misses = []
    for geometry in GEOMETRIES:
        points = evaluate(*_general(geometry))
        slope, length = _number(points, "contact_slope"), _number(points, "active_length")
        a, b = printed_contact(geometry, slope)
        whole = printed_integral(slope)
        misses += [abs(a * whole / printed_integral(slope, "cos") / length - 1.0)]
        misses += [abs(b * whole / printed_integral(slope, "sin") / length - 1.0)]
    return IDENTITY - max(misses)


def moment_and_thrust() -> float:
    """Margin of M_b, F_b and their stiffness, which the paper announces: against differences of energy and load."""
    misses = []
    for geometry in GEOMETRIES:
        actuator, deflection, setting = _general(geometry)
        points, step = evaluate(actuator, deflection, setting), 1e-5
        ends = [evaluate(actuator, deflection + s * step, setting).energy for s in (-1.0, 1.0)]
        misses.append(abs((ends[1] - ends[0]) / (2.0 * step) / points.load - 1.0))
        loads = [evaluate(actuator, deflection + s * step, setting).load for s in (-1.0, 1.0)]
        misses.append(abs((loads[1] - loads[0]) / (2.0 * step) / points.stiffness - 1.0))
        ends = [evaluate(actuator, deflection, setting + s * step).energy for s in (-1.0, 1.0)]
        misses.append(
            abs((ends[1] - ends[0]) / (2.0 * step) - points.adjusting_load) / _number(points, "contact_force")
        )
    return 1e-6 - float(max(misses))  # central differences of this step leave 1e-8


def moment_balance() -> float:
    """Margin of Eq. (13)'s left side: P (a + y_d + n (b + x_d)) against the load.

    Figure 6 alone defines x_d and y_d. The joint is put at (-y_d, -x_d), where the equation holds.
    """
    misses = []
    for geometry in GEOMETRIES:
        actuator, deflection, setting = _general(geometry)
        points = evaluate(actuator, deflection, setting)
        slope, force = _number(points, "contact_slope"), _number(points, "contact_force")
        a, b = printed_contact(geometry, slope)
        x, y = (float(value) for value in actuator.joint())
        n, transverse = math.tan(slope), force * math.cos(slope)
        misses.append(abs(transverse * (n * -y - x + a + b * n) / float(points.load) - 1.0))
    return IDENTITY - max(misses)


def moment_from_normal_component() -> tuple[float, float]:
    """Margin of "the normal component makes the moment", for pivots on the link's axis and up to 50 mm beside it."""
    margins = []
    for offset in (0.0, 0.02, 0.05):
        actuator = joint(offset=offset)
        points = evaluate(actuator, 0.2, 0.5)
        zeta = 0.2 - _number(points, "contact_slope")
        normal = _number(points, "contact_force") * math.cos(zeta)
        margins.append(1e-3 - abs(0.5 * normal / float(points.load) - 1.0))
    return min(margins), max(margins)


def stored_energy_returns() -> float:
    """Margin of "can store and return": work of load and adjusting force round a loop, over the largest energy."""
    nodes, weights = np.polynomial.legendre.leggauss(12)
    (low, high), (near, far) = DEFLECTIONS[[0, -1]], SETTINGS[[0, -1]]
    angles, places = 0.5 * (low + high + (high - low) * nodes), 0.5 * (near + far + (far - near) * nodes)
    work = 0.0
    for place, sign in ((near, 1.0), (far, -1.0)):
        work += sign * 0.5 * (high - low) * float(weights @ evaluate(joint(), angles, place).load)
    for angle, sign in ((high, 1.0), (low, -1.0)):
        work += sign * 0.5 * (far - near) * float(weights @ evaluate(joint(), angle, places).adjusting_load)
    return IDENTITY - abs(work) / float(evaluate(joint(), high, near).energy)


@cache
def _map() -> Points:
    return evaluate(joint(), DEFLECTIONS[:, None], SETTINGS[None, :])


def stiffness_falls() -> float:
    """Least relative fall of the tangent stiffness from one roller position to the next outer one."""
    values = _map().stiffness
    return float((1.0 - values[:, 1:] / values[:, :-1]).min())


def moment_falls() -> float:
    """Least relative fall of the moment at one joint angle from one roller position to the next outer one."""
    values = _map().load
    return float((1.0 - values[:, 1:] / values[:, :-1]).min())


def release_by_thrust() -> float:
    """Least work that the shuttle gives back on its way out at a fixed joint angle, over the energy at its start."""
    nodes, weights = np.polynomial.legendre.leggauss(12)
    near, far = SETTINGS[[0, -1]]
    places = 0.5 * (near + far + (far - near) * nodes)
    force = evaluate(joint(), DEFLECTIONS[:, None], places[None, :]).adjusting_load
    return float((-0.5 * (far - near) * force @ weights / _map().energy[:, 0]).min())


def adjusting_work_share() -> float:
    """A tenth, less the work on the shuttle over the range of settings, as a share of the energy at the stiff end."""
    energy = _map().energy
    return 0.1 - float((1.0 - energy[:, -1] / energy[:, 0]).max())


def backdriven() -> float:
    """Least thrust of the deflected beam on the shuttle, over the contact force: zero would be self-locking."""
    points = _map()
    return float(np.min(np.abs(points.adjusting_load) / points.details["contact_force"]))


def one_roller_at_a_time() -> float:
    """Least gap [m] between beam and idle roller, for pairs of 5 mm to 30 mm radius with 0.1 mm to 1 mm of play."""
    gaps = []
    for play in (1e-4, 1e-3):
        device = joint(clearance=play)
        for angle in DEFLECTIONS:
            for setting in SETTINGS[[0, 4, 8]]:
                slope = _number(evaluate(device, angle, setting), "contact_slope")
                line = device.element_shapes(float(angle), float(setting))[0]
                pivot = setting * np.array([math.cos(angle), math.sin(angle)])
                gaps += [_idle_gap(line, pivot, slope, radius, play) for radius in (0.005, 0.03)]
    return min(gaps)


def _idle_gap(line: np.ndarray, pivot: np.ndarray, slope: float, radius: float, play: float) -> float:
    """Distance [m] from the beam, drawn as ``line``, to the roller on the far side of a pair turned by ``slope``."""
    middle = radius + 0.5 * leaf("spring_steel").thickness
    start, step = line[:-1], np.diff(line, axis=0)
    away = pivot + (middle + play) * np.array([-math.sin(slope), math.cos(slope)]) - start
    part = np.clip((away * step).sum(axis=1) / (step**2).sum(axis=1), 0.0, 1.0)
    return float(np.hypot(*(away - part[:, None] * step).T).min()) - middle


def rotation_at_yield(beam: str, *, setting: float) -> float:
    """Joint angle [rad] at which the root yields, strength from varistiff's table of materials; simplest geometry."""
    strength = material(beam).yield_strength
    assert strength is not None  # every metal of the table has one
    angles = np.radians(np.linspace(0.5, 95.0, 379))
    stress = evaluate(
        RollerBeam(beam=replace(leaf(beam), length=math.inf), rollers=SwivellingPair(0.0, 0.0)), angles, setting
    ).stress
    return float(np.interp(strength.value, stress, angles))


def beam_beside_link() -> float:
    """Largest distance of the spring-steel beam from link 2's axis at 18 degrees, roller at 0.43 m, less 50 mm [m]."""
    angle = float(DEFLECTIONS[-1])
    line = joint().element_shapes(angle, float(SETTINGS[0]))[0]
    return float(np.abs(line @ np.array([-math.sin(angle), math.cos(angle)])).max()) - 0.05


def knee_beyond_yield() -> float:
    """Largest flexion of a knee in level walking less the largest rotation at which any of the beams yields [rad]."""
    knee = knee_gait()
    flexion = max(float(knee.angle.at(knee.cycle_duration * part).value) for part in np.linspace(0.0, 1.0, 101))
    return flexion - max(rotation_at_yield(beam, setting=ACTIVE_LENGTHS["l_1"]) for beam in BEAMS)


def table_of_moments() -> float:
    """A thousandth, less the error of a 33 x 33 table of the moment read linearly, over the largest moment."""
    angles, places = np.linspace(0.0, DEFLECTIONS[-1], 33), np.linspace(SETTINGS[0], SETTINGS[-1], 33)
    grid = evaluate(joint(), angles[:, None], places[None, :]).load
    table = RegularGridInterpolator((angles, places), grid)
    between = np.stack(np.meshgrid(0.5 * (angles[1:] + angles[:-1]), 0.5 * (places[1:] + places[:-1]), indexing="ij"))
    exact = evaluate(joint(), between[0], between[1]).load
    return 1e-3 - float(np.abs(table(np.moveaxis(between, 0, -1)) - exact).max() / grid.max())
