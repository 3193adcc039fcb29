"""What lengths make a shape: checks that need nothing but arithmetic, in the words of the design file."""

from __future__ import annotations

import math
from collections.abc import Callable

from varistiff.core.errors import InputError


def check_ellipse(*, semi_major: float, semi_minor: float) -> None:
    """Refuse an ellipse whose names are swapped.

    Raises
    ------
    InputError : the minor semi-axis is the longer one
    """
    if semi_minor > semi_major:
        raise InputError("is above semi_major; allowed is semi_minor <= semi_major", field="semi_minor")


def check_p3g(*, mean_diameter: float, eccentricity: float) -> None:
    """Refuse a P3G whose curvature radius Dm/2 - 8 e is not above zero.

    Raises
    ------
    InputError : an eccentricity below zero, or one that gives a cusp
    """
    if not 0.0 <= eccentricity < mean_diameter / 16.0:
        raise InputError(
            f"gives a cusp or is negative; allowed is from 0 mm to below mean_diameter/16, {_mm(mean_diameter / 16.0)}",
            field="eccentricity",
        )


def p4c_cut(*, inner_diameter: float, outer_diameter: float, eccentricity: float) -> tuple[float, float]:
    """Parameter a of a P4C's curve, and angle about the axis, where the outer circle cuts it [rad].

    Raises
    ------
    InputError : the circle does not cut the curve between two flats
    """
    if not eccentricity > 0.0:
        raise InputError("is not above zero; allowed is a length above 0 mm", field="eccentricity")
    if not outer_diameter > inner_diameter:
        raise InputError(
            "is not above inner_diameter; allowed is outer_diameter > inner_diameter", field="outer_diameter"
        )
    mean = 0.5 * inner_diameter + eccentricity
    # the curve runs outward until the corner on the diagonal, or until its cusp where mean + 15 e cos 4a = 0
    end = 0.25 * math.pi
    if mean < 15.0 * eccentricity:
        end = 0.25 * math.acos(-mean / (15.0 * eccentricity))

    def place(a: float) -> tuple[float, float]:
        h, slope = mean - eccentricity * math.cos(4.0 * a), 4.0 * eccentricity * math.sin(4.0 * a)
        return math.hypot(h, slope), a + math.atan2(slope, h)

    last = _bisect(lambda a: place(a)[1] - 0.25 * math.pi, 0.0, end) if place(end)[1] > 0.25 * math.pi else end
    largest = 2.0 * place(last)[0]
    if not outer_diameter < largest:
        raise InputError(
            f"does not cut the profile; allowed is above inner_diameter and below {_mm(largest)}",
            field="outer_diameter",
        )
    a = _bisect(lambda a: place(a)[0] - 0.5 * outer_diameter, 0.0, last)
    return a, place(a)[1]


def check_splined_tube(
    *,
    outer_radius: float,
    inner_radius: float,
    rails: int,
    rail_width: float,
    rail_height: float,
    root_fillet: float,
) -> None:
    """Refuse rails that overlap or leave the tube, and fillets that have no room.

    Raises
    ------
    InputError : which field, and what is allowed
    """
    if not 0.0 <= inner_radius < outer_radius:
        raise InputError("is not below outer_radius; allowed is inner_radius < outer_radius", field="inner_radius")
    if rails < 1:
        raise InputError(f"is {rails}; allowed is a whole number of 1 or more", field="rails")
    for name, value in (("rail_width", rail_width), ("rail_height", rail_height)):
        if not value > 0.0:
            raise InputError("is not above zero; allowed is a length above 0 mm", field=name)
    widest = 2.0 * outer_radius * (math.sin(math.pi / rails) if rails > 1 else 1.0)
    if not rail_width < widest:
        what = "overlap" if rails > 2 else "leave the tube"
        raise InputError(f"makes the rails {what}; allowed is below {_mm(widest)}", field="rail_width")
    if root_fillet < 0.0:
        raise InputError("is negative; allowed is a length of 0 mm or more", field="root_fillet")
    if root_fillet == 0.0:
        return
    reach, y = outer_radius + root_fillet, 0.5 * rail_width + root_fillet
    fits = y < reach and math.sqrt(reach**2 - y**2) <= outer_radius + rail_height
    if not fits or math.asin(y / reach) > math.pi / rails:
        raise InputError(
            "has no room between the rails or on their height; allowed is a smaller radius", field="root_fillet"
        )


def _bisect(function: Callable[[float], float], low: float, high: float) -> float:
    from scipy.optimize import brentq

    return float(brentq(function, low, high, xtol=1e-15, rtol=1e-14))


def _mm(length: float) -> str:
    return f"{1e3 * length:.6g} mm"
