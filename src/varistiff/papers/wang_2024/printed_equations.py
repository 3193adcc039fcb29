"""Equations of Wang et al. (2024) as printed, where that is not what mechanics gives; SI units."""

from __future__ import annotations

import math
from collections.abc import Iterator
from itertools import product


def energy_as_printed(*, rigidity: float, clamp_radius: float, length: float, deflection: float) -> float:
    """Eq. (10): E b h^3 l_2^2 (1 - cos phi)/(4 l_1^3) [J], without N; ``rigidity`` is E b h^3 [N m^2]."""
    return rigidity * (clamp_radius + length) ** 2 * (1.0 - math.cos(deflection)) / (4.0 * length**3)


def energy_to_the_leaf_rotation(*, rigidity: float, clamp_radius: float, length: float, deflection: float) -> float:
    """Eq. (10) with the printed upper limit of its integral, the leaf's rotation theta of Eq. (2) [J]."""
    theta = 1.5 * (clamp_radius + length) * math.tan(deflection) / length
    return energy_as_printed(rigidity=rigidity, clamp_radius=clamp_radius, length=length, deflection=theta)


def resistance_as_printed(*, rigidity: float, clamp_radius: float, length: float, deflection: float) -> float:
    """Eq. (12): E b h^3 (1 - cos phi)(l_1^2 + 4 r_2 l_1 + 3 r_2^2)/(4 l_1^4), printed as a torque; it is in N."""
    polynomial = length**2 + 4.0 * clamp_radius * length + 3.0 * clamp_radius**2
    return rigidity * (1.0 - math.cos(deflection)) * polynomial / (4.0 * length**4)


def linear_torque(*, stiffness: float, deflection: float) -> float:
    """Torque K_s (q_1 - q) [N m] of Eq. (17)."""
    return stiffness * deflection


def centres_as_printed(
    *, inner_radius: float, outer_radius: float, outer_angle: float, arc_radius: float, in_e_2: float
) -> Iterator[tuple[float, float]]:
    """Eq. (14): every centre (x_o, y_o) [m] that the printed letters can give, whatever their signs.

    Minus signs are read both ways wherever one can stand, the order of terms is as printed. ``in_e_2`` is the radius
    in e_2 = (r_2 -+ in_e_2 cos a_1)/(r_1 sin a_1): printed is l_2, the radius of the slider.
    """
    r_1, r_2, r_s = outer_radius, inner_radius, arc_radius
    sine, cosine = math.sin(outer_angle), math.cos(outer_angle)
    for signs in product((-1.0, 1.0), repeat=6):
        in_1, in_2, in_x, in_y, in_constant, of_root = signs
        e_1 = (r_2**2 + in_1 * r_1**2) / (2.0 * r_1 * sine)
        e_2 = (r_2 + in_2 * in_e_2 * cosine) / (r_1 * sine)
        quadratic = e_2**2 + 1.0
        middle = (in_y * e_1 * e_2 + r_2) / quadratic
        square = middle**2 - (e_1**2 + r_2**2 + in_constant * r_s**2) / quadratic
        if square >= 0.0:
            y = middle + of_root * math.sqrt(square)
            yield in_x * e_1 + e_2 * y, y
