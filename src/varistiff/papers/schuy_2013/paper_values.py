"""What Schuy et al. (2013) print, in SI: every computation of this package takes its numbers from here.

The printed digits themselves stand in ``claims.yaml``; a test compares the two.
"""

from __future__ import annotations

STIFFNESS_MIN, STIFFNESS_MAX = 50.0, 350.0  # N m/rad, required range, section II.A
LENGTH_MIN = 0.010  # m, x_min, section II.B

HOLLOW_RATIO = 0.5  # lambda of the ideal cylinder, section II.A
IDEAL_RADIUS = 0.009  # m, of the ideal cylinder, section II.A
POLYETHYLENE = 0.387e9  # Pa, shear modulus, section II.A
POLYAMIDE = 0.68e9  # Pa, shear modulus, section II.B

TABLE_RADIUS = 7.8e-3  # m, cylinder in Table I
ACROSS_FLATS = {"square": 14.1e-3, "hexagon": 14.8e-3, "octagon": 15.1e-3}  # m, b in Table I
STIFFNESS_FACTORS = {"square": 0.141, "hexagon": 0.115, "octagon": 0.108}  # c_g
RESISTANCE_FACTORS = {"square": 0.208, "hexagon": 0.188, "octagon": 0.185}  # c_r
STRESS_RATIOS = {"square": 1.28, "hexagon": 1.22, "octagon": 1.17}
HALF_DIGIT = 0.05e-3  # m, Table I rounds to 0.1 mm

OUTER_RADIUS, RADIUS_RATIO = 0.011, 0.791  # m and 1, of the prototype without its rails, section III
HALF_RATIO = 0.0005  # half a unit of the last digit of lambda
RAILS = 6
GEAR_RATIO = 80.0  # between motor and element, section III
ELEMENT_LENGTH = 0.16  # m, l
TESTED_LENGTHS = (0.011, 0.031, 0.051, 0.071, 0.091, 0.111, 0.131, 0.151, 0.166)  # m
ANALYTIC_MIN = 53.13  # N m/rad, expected of the design at the longest tested length
MEASURED_MIN = 71.56  # N m/rad, measured there
CROSSING = 0.04  # m, above it the measured stiffness exceeds the analytic one
SOLID_EXCESS = 0.62  # largest excess of the finite element stiffness over the analytic one, section IV.A
LOCAL_SHARE = 0.008  # local deflection of the rails, section IV.A
SHOWN_LENGTHS = (0.011, 0.031, 0.051, 0.091, 0.131, 0.166)  # m, those of Fig. 8
PICTURED_TORQUE = 1.0  # N m, of the stress pictures, section IV.B
