"""What dos Santos and Richter (2019) print and the computations start from, in SI units.

Table 1 gives two lengths for each cross-section without saying rightly which is which, and moduli in a unit that
cannot be meant; ``beams`` reads them, and ``corrected_reading`` shows why in that way.
"""

from __future__ import annotations

from typing import NamedTuple

MILLIMETRE = 1e-3
PRINTED_MODULUS_UNIT = 1e6  # the head of Table 1 says MPa
MODULUS_UNIT = 1e9  # GPa is meant: corrected_reading.modulus_readings


class PrintedBeam(NamedTuple):
    """One row of Table 1 and the beam's error of the text."""

    material: str  # key in varistiff's table of materials
    first_side: float  # of the cross-section, as printed left of the cross [m]
    second_side: float  # right of it [m]
    mass: float  # [kg]
    modulus: float  # the number alone
    rms_error: float  # of the force, over the beam's trials [N]


BEAMS = {
    "aluminium_wide": PrintedBeam("aluminium_6061", 5.46 * MILLIMETRE, 31.70 * MILLIMETRE, 0.3823, 70.8, 1.1525),
    "aluminium_narrow": PrintedBeam("aluminium_6061", 5.46 * MILLIMETRE, 25.49 * MILLIMETRE, 0.4044, 63.1, 2.9869),
    "spring_steel": PrintedBeam("spring_steel_1075", 3.16 * MILLIMETRE, 25.45 * MILLIMETRE, 0.5646, 194.0, 0.92602),
    "low_carbon_steel": PrintedBeam("low_carbon_steel", 4.69 * MILLIMETRE, 25.20 * MILLIMETRE, 0.8440, 169.2, 1.8255),
}
ACTIVE_LENGTHS = {"l_1": 0.75, "l_2": 0.43}  # [m]
FORCES = (2.0, 20.0)  # least and largest contact force of the experiment [N]
TRIALS = 56
RMS_ERROR = 1.956  # over all trials [N]
YEAR = 2019  # of the paper
FIRST_WORK = 1945  # Bisshopp and Drucker, the first cited work on large deflections
ADJUSTER_ACTUATORS = 3  # of the mechanical impedance adjuster, as the introduction counts
MOTORS = 1  # of the roller beam
