"""Published numbers on the elastica, as printed, with their places.

Mattiasson: the end of a cantilever of length L under a vertical end load P, by elliptic integrals.
Lemniscate: the two halves of Euler's product; the elastica whose end force is at a right angle to its clamp
(the "rectangular" one) has its end coordinates and its length in these ratios.
"""

from __future__ import annotations

from typing import NamedTuple


class EndOfCantilever(NamedTuple):
    """One row: load parameter P L^2/(E I), vertical w/L and horizontal u/L displacement, end slope [rad]."""

    load: float
    vertical: str
    horizontal: str
    slope: str


# K. Mattiasson, "Numerical results from large deflection beam and frame problems analysed by means of
# elliptic integrals", Int. J. Numer. Meth. Eng. 17 (1981) 145-153, Table I (cantilever with a vertical end
# load).
MATTIASSON_1981_TABLE_1 = (
    EndOfCantilever(1.0, "0.30172", "0.05643", "0.46135"),
    EndOfCantilever(2.0, "0.49346", "0.16064", "0.78175"),
    EndOfCantilever(5.0, "0.71379", "0.38763", "1.21537"),
    EndOfCantilever(10.0, "0.81061", "0.55500", "1.43029"),
)

# Lengths in units of the end's distance from the clamp's tangent, for the rectangular elastica (Jakob
# Bernoulli 1694; L. Euler, Methodus inveniendi lineas curvas, 1744, Additamentum I, where the product of
# the two is pi/4). Digits: J. Todd, "The lemniscate constants", Comm. ACM 18 (1975) 14-19, constants A and
# B.
RECTANGULAR_ELASTICA_LENGTH = "1.3110287771461"
RECTANGULAR_ELASTICA_DISTANCE = "0.5990701173678"
