"""The generic chain: any actuator, its own map, solved at every sample."""

from __future__ import annotations

from typing import Literal

import equinox as eqx
import numpy as np

from varistiff.characteristic.evaluate import evaluate
from varistiff.dynamics.control.checks import check_choice
from varistiff.dynamics.control.controller import Number, Scalar, as_scalar
from varistiff.dynamics.control.motion_of_setting import motion_of_setting
from varistiff.dynamics.control.setting_inverse import SettingInverse
from varistiff.dynamics.control.stiffness_chain import StiffnessChain
from varistiff.dynamics.path import Affine, Path


class MapChain(StiffnessChain):
    """Stiffness command to setting by the actuator's own map, then to the drive's coordinate by its path.

    Parameters
    ----------
    inverse : of the actuator's stiffness, made by ``setting_inverse``
    path : setting over the setting drive's coordinate
    at : ``rest`` takes the stiffness at deflection 0; ``measured`` the tangent stiffness at the measured deflection
    """

    inverse: SettingInverse
    path: Path = Affine()
    at: Literal["rest", "measured"] = eqx.field(static=True, default="rest")

    def __check_init__(self) -> None:
        check_choice("at", self.at, ("rest", "measured"))

    def _deflection(self, deflection: Number) -> Scalar:
        return as_scalar(deflection if self.at == "measured" else 0.0)

    def motion(self, stiffness: Number, deflection: Number) -> Scalar:
        """See ``StiffnessChain.motion``."""
        return motion_of_setting(self.path, self.inverse.at(stiffness, self._deflection(deflection)))

    def stiffness(self, motion: Number, deflection: Number) -> Scalar:
        """See ``StiffnessChain.stiffness``."""
        setting = self.path.at(as_scalar(motion)).value
        return self.inverse.actuator.respond(self._deflection(deflection), setting)[0].stiffness

    def reach(self) -> tuple[Scalar, Scalar]:
        """See ``StiffnessChain.reach``."""
        ends = np.asarray([self.inverse.setting_min, self.inverse.setting_max], dtype=float)
        ends = evaluate(self.inverse.actuator, 0.0, ends).stiffness
        return as_scalar(ends.min()), as_scalar(ends.max())
