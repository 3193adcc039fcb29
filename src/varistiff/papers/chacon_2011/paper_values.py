"""Numbers that Chacon et al. (2011) start from, SI units; the input claims hold the same digits."""

from __future__ import annotations

LEAF_WIDTH = 50e-3  # section 4
LEAF_THICKNESS = 0.5e-3
YOUNGS_MODULUS = 2.1e11  # below Eq. (3)
YIELD_STRENGTH = 1500e6
ROLLER_DISTANCE = 345e-3  # D, below Eq. (4)
CLAMP_HEIGHT = 40.5e-3  # y_f
ASPECT_RATIO_SOFT = 3.5  # alpha_0
ASPECT_RATIO_STIFF = 2.0  # alpha_1

# results that other computations hold something against
PROTECTING_RADIUS = 35e-3
STIFFNESS_VARIATION = 15.0  # 1500 %, read as an increase by that much
