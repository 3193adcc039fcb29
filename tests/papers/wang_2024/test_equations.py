"""Where the equations of Wang et al. (2024) are not what mechanics gives."""

from __future__ import annotations

import math

import jax
import jax.numpy as jnp
import numpy as np
import pytest

from varistiff.papers.wang_2024 import paper_values as paper
from varistiff.papers.wang_2024.device import answer, groove, joint
from varistiff.papers.wang_2024.groove_disc import arc_radius
from varistiff.papers.wang_2024.printed_equations import (
    centres_as_printed,
    energy_as_printed,
    energy_to_the_leaf_rotation,
    linear_torque,
    resistance_as_printed,
)

RIGIDITY = 206e9 * 0.025 * 0.001**3
LENGTH, PHI = 0.017, 0.04


def integral(count: int) -> float:
    """Work of the torque (7) from rest to PHI, by Gauss quadrature."""
    nodes, weights = np.polynomial.legendre.leggauss(12)
    torque = answer(joint(count=count), deflection=0.5 * PHI * (1.0 + nodes), length=LENGTH).torque
    return float(0.5 * PHI * (weights * torque).sum())


def test_printed_energy_is_not_the_integral_of_the_torque() -> None:
    numbers = {"rigidity": RIGIDITY, "clamp_radius": 0.025, "length": LENGTH, "deflection": PHI}
    printed = energy_as_printed(**numbers)
    assert printed == pytest.approx(integral(1), rel=1e-9)  # one leaf: right
    assert integral(3) == pytest.approx(3.0 * printed, rel=1e-9)  # three: the printed form lacks N
    ours = float(answer(joint(count=3), deflection=PHI, length=LENGTH).energy)
    assert ours == pytest.approx(integral(3), rel=1e-9)
    # the printed limit theta is another angle
    assert energy_to_the_leaf_rotation(**numbers) > 10.0 * printed


def test_printed_resistance_lacks_the_number_of_leaves() -> None:
    printed = resistance_as_printed(rigidity=RIGIDITY, clamp_radius=0.025, length=LENGTH, deflection=PHI)
    for count in (1, 3):
        step = 1e-6
        low, high = answer(joint(count=count), deflection=PHI, length=np.array([LENGTH - step, LENGTH + step])).energy
        slope = float(high - low) / (2.0 * step)
        assert slope == pytest.approx(-count * printed, rel=1e-6)  # of the difference quotient
        assert float(answer(joint(count=count), deflection=PHI, length=LENGTH).thrust) == pytest.approx(slope, rel=1e-6)


def test_resistance_is_a_force_and_the_disc_feels_it_through_the_groove() -> None:
    # dimension: with millimetres for metres (E b h^3 in N mm^2) a force keeps its number, a torque gains 1000
    metres = resistance_as_printed(rigidity=RIGIDITY, clamp_radius=0.025, length=LENGTH, deflection=PHI)
    millimetres = resistance_as_printed(rigidity=1e6 * RIGIDITY, clamp_radius=25.0, length=1e3 * LENGTH, deflection=PHI)
    assert millimetres == pytest.approx(metres, rel=1e-12)  # rounding
    # virtual work: turning the disc stores what the torque dV/dl_1 dl_1/d(alpha) does
    disc, step = groove(arc_radius()), 1e-5
    angle = float(disc.angle(jnp.asarray(LENGTH)))
    lengths = np.asarray(disc.active_length(jnp.asarray([angle - step, angle + step])))
    low, high = answer(joint(), deflection=PHI, length=lengths).energy
    thrust = float(answer(joint(), deflection=PHI, length=LENGTH).thrust)
    torque = thrust * float(disc.active_length_rate(jnp.asarray(angle)))
    assert float(high - low) / (2.0 * step) == pytest.approx(torque, rel=1e-6)  # of the difference quotient
    assert abs(torque) < 0.1 * abs(thrust)  # 37 mm/rad: the two numbers are far apart


def test_torque_is_not_the_work_of_the_printed_displacement() -> None:
    # the leaf's energy at w = l_2 tan(phi), Eqs. (1) to (3), differentiated, against (7)
    radius = 0.025 + LENGTH

    def energy(phi: jax.Array) -> jax.Array:
        return RIGIDITY / 8.0 * (radius * jnp.tan(phi)) ** 2 / LENGTH**3

    work = float(jax.grad(energy)(jnp.asarray(paper.DEFLECTION_LIMIT)))
    torque = float(answer(joint(), deflection=paper.DEFLECTION_LIMIT, length=LENGTH).torque)
    assert 0.002 < work / torque - 1.0 < 0.006  # 1/cos^3(phi) less 1: small, and not zero
    assert work / torque == pytest.approx(math.cos(paper.DEFLECTION_LIMIT) ** -3, rel=1e-9)


@pytest.mark.parametrize("radius", [0.03, 0.03682, 0.1])
def test_no_signs_make_the_printed_centre_right(radius: float) -> None:
    fixed = {
        "inner_radius": paper.CLAMP_RADIUS,
        "outer_radius": paper.OUTER_RADIUS,
        "outer_angle": paper.OUTER_ANGLE,
        "arc_radius": radius,
    }
    corner = paper.OUTER_RADIUS * np.array([math.sin(paper.OUTER_ANGLE), math.cos(paper.OUTER_ANGLE)])

    def miss(x: float, y: float) -> float:
        """How far A and C are off the circle [m]."""
        to_a = math.hypot(x, y - paper.CLAMP_RADIUS)
        return max(abs(to_a - radius), abs(math.hypot(*(corner - [x, y])) - radius))

    # with r_1 in e_2 some signs give the centre; with the slider's radius, anywhere but at C, none do
    assert min(miss(x, y) for x, y in centres_as_printed(**fixed, in_e_2=paper.OUTER_RADIUS)) < 1e-9
    for length in (0.006, 0.015, 0.025):
        centres = centres_as_printed(**fixed, in_e_2=paper.CLAMP_RADIUS + length)
        assert min(miss(x, y) for x, y in centres) > 1e-4


def test_linear_spring_and_resistance_make_energy_from_nothing() -> None:
    # a rectangle in deflection and length, with E b h^3 cos(phi) of (9) at rest as K_s
    def stiffness(length: float) -> float:
        return float(answer(joint(), deflection=0.0, length=length).stiffness)

    start, end, short, long = 0.0, paper.DEFLECTION_LIMIT, 0.010, 0.020

    def linear_work(length: float) -> float:
        return 0.5 * linear_torque(stiffness=stiffness(length), deflection=end) * (end - start)

    def energy(length: float) -> float:
        return float(answer(joint(), deflection=end, length=length).energy)

    # out at the short length, lengthen at the deflection (Eq. 12 is the energy's derivative), back, shorten at rest
    printed = linear_work(short) + (energy(long) - energy(short)) - linear_work(long)
    assert abs(printed) == pytest.approx(1.8e-4 * energy(short), rel=0.05)  # 0.02 % of what is stored
    # with the derivative of the energy as torque the loop closes
    torque_work = []
    nodes, weights = np.polynomial.legendre.leggauss(12)
    for length in (short, long):
        torque = answer(joint(), deflection=0.5 * end * (1.0 + nodes), length=length).torque
        torque_work.append(float(0.5 * end * (weights * torque).sum()))
    ours = torque_work[0] + (energy(long) - energy(short)) - torque_work[1]
    assert abs(ours) < 1e-10 * energy(short)  # quadrature and rounding


def test_elastic_torque_has_no_place_in_the_stiffness_chain() -> None:
    # the force that lengthens the leaf is even in the deflection, the elastic torque odd
    two_sides = np.array([-PHI, PHI])
    both = answer(joint(), deflection=two_sides, length=LENGTH)
    assert both.thrust[0] == pytest.approx(both.thrust[1], rel=1e-12)  # rounding
    assert both.torque[0] == pytest.approx(-both.torque[1], rel=1e-12)
    assert both.thrust[0] != 0.0
