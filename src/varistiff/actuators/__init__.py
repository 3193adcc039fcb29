"""Variable stiffness actuators, one published device per file, each an elastic energy in SI units."""

from varistiff.actuators.actuator import Actuator, Quantity, Response
from varistiff.actuators.antagonistic_leaves import AntagonisticLeaves
from varistiff.actuators.groove import Groove
from varistiff.actuators.leaf_joint_theory import LargeDeflection, LeafJointTheory, SmallDeflection
from varistiff.actuators.maccepa import Maccepa
from varistiff.actuators.roller_beam import RollerBeam
from varistiff.actuators.rollers import FixedPair, Rollers, SingleLower, SingleUpper, SwivellingPair
from varistiff.actuators.series_elastic import SeriesElastic
from varistiff.actuators.slider_leaf_joint import SliderLeafJoint
from varistiff.actuators.torsion_tube import TorsionTube
from varistiff.core import precision

precision.enable()

__all__ = [
    "Actuator",
    "AntagonisticLeaves",
    "FixedPair",
    "Groove",
    "LargeDeflection",
    "LeafJointTheory",
    "Maccepa",
    "Quantity",
    "Response",
    "RollerBeam",
    "Rollers",
    "SeriesElastic",
    "SingleLower",
    "SingleUpper",
    "SliderLeafJoint",
    "SmallDeflection",
    "SwivellingPair",
    "TorsionTube",
]
