"""Published torsion constants, as printed, with their places."""

from __future__ import annotations

from typing import NamedTuple


class Bar(NamedTuple):
    """Rectangular bar of sides b >= a: largest stress = k G theta' a, torque = k1 G theta' a^3 b = k2 a^2 b stress."""

    ratio: float
    k: str
    k1: str
    k2: str


# S. P. Timoshenko and J. N. Goodier, Theory of Elasticity, 3rd ed., McGraw-Hill 1970, art. 109, table "Constants for
# torsion of a rectangular bar"
TIMOSHENKO_GOODIER_ART_109 = (
    Bar(1.0, "0.675", "0.1406", "0.208"),
    Bar(1.2, "0.759", "0.166", "0.219"),
    Bar(1.5, "0.848", "0.196", "0.231"),
    Bar(2.0, "0.930", "0.229", "0.246"),
    Bar(2.5, "0.968", "0.249", "0.258"),
    Bar(3.0, "0.985", "0.263", "0.267"),
    Bar(4.0, "0.997", "0.281", "0.282"),
    Bar(5.0, "0.999", "0.291", "0.291"),
    Bar(10.0, "1.000", "0.312", "0.312"),
    Bar(1e6, "1.000", "0.333", "0.333"),  # printed: infinity
)

# J. Schuy et al., "Dimensioning and Evaluation of the Elastic Element in a Variable Torsion Stiffness Actuator",
# IEEE/ASME AIM 2013, Table I, rows c_g and c_r of the square, hexagonal and octagonal columns
SCHUY_2013_TABLE_1 = {
    "square": ("0.141", "0.208"),
    "hexagon": ("0.115", "0.188"),
    "octagon": ("0.108", "0.185"),
}

# W. C. Young and R. G. Budynas, Roark's Formulas for Stress and Strain, 7th ed., McGraw-Hill 2002, Table 10.1: circular
# shaft of radius r with flats of depth h, K = 2 C r^4 and largest stress = T B/r^3; coefficients of powers of h/r
ROARK_TWO_FLATS_C = (0.7854, -0.4053, -3.5810, 5.2708, -2.0772)
ROARK_TWO_FLATS_B = (0.6366, 2.5303, -11.157, 49.568, -85.886, 69.849)
ROARK_FOUR_FLATS_C = (0.7854, -0.7000, -7.7982, 14.578)
ROARK_FOUR_FLATS_B = (0.6366, 2.6298, -5.6147, 30.853)

# square of the energy norm of -Laplace u = 1, u = 0 on the boundary of three unit squares in an L; J is four times it.
# Reference value of P. Bammer, used as such by codes of adaptive finite elements; its ninth digit is not ours
L_SHAPE_ENERGY = 0.214075802220546
