"""Variable stiffness actuators, one published device per file, each an elastic energy in SI units.

A device is imported where it is first asked for: one kind does not wait for what another one needs.
"""

from __future__ import annotations

from importlib import import_module
from typing import TYPE_CHECKING, Any

from varistiff.core import precision

if TYPE_CHECKING:
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

precision.enable()  # here, so that no module of the package can trace anything before it

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

_FILES = {
    "Actuator": "actuator",
    "AntagonisticLeaves": "antagonistic_leaves",
    "FixedPair": "rollers",
    "Groove": "groove",
    "LargeDeflection": "leaf_joint_theory",
    "LeafJointTheory": "leaf_joint_theory",
    "Maccepa": "maccepa",
    "Quantity": "actuator",
    "Response": "actuator",
    "RollerBeam": "roller_beam",
    "Rollers": "rollers",
    "SeriesElastic": "series_elastic",
    "SingleLower": "rollers",
    "SingleUpper": "rollers",
    "SliderLeafJoint": "slider_leaf_joint",
    "SmallDeflection": "leaf_joint_theory",
    "SwivellingPair": "rollers",
    "TorsionTube": "torsion_tube",
}


def __getattr__(name: str) -> Any:
    if name not in _FILES:
        raise AttributeError(f"module {__name__!r} has no attribute {name!r}")
    return getattr(import_module(f"{__name__}.{_FILES[name]}"), name)


def __dir__() -> list[str]:
    return sorted({*globals(), *__all__})
