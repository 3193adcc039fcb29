"""What Wang et al. (2024) start from, in SI units; the input claims print the same digits."""

from __future__ import annotations

import math

# Table 2
YOUNGS_MODULUS = 206e9  # Pa
WIDTH = 0.025  # m, b
THICKNESS = 0.001  # m, h
COUNT = 1  # N
CLAMP_RADIUS = 0.025  # m, r_2
OUTER_RADIUS = 0.054  # m, r_1
OUTER_ANGLE = math.radians(47.0)  # alpha_1
JOINT_DIAMETER = 0.140  # m

# section 2.2: the small-deflection assumption; section 3: what the design uses of it, "about"
ROTATION_ASSUMED = math.radians(10.0)
ROTATION_DESIGN = math.radians(9.0)

# section 2.4
LENGTH_MIN, LENGTH_MAX = 0.006, 0.025  # m, the effective range of l_1

# results of the paper from which it computes others
DEFLECTION_LIMIT = math.radians(3.03)  # Table 2

# section 4.3
TEST_STIFFNESS = 200.0  # N m/rad
STIFFNESS_AMPLITUDE = 200.0  # N m/rad
POSITION_AMPLITUDE = math.radians(30.0)
FREQUENCY = 1.0  # Hz, of both sines
