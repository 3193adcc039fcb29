"""Holding the setting where it is wanted, without a stiffness in mind."""

from __future__ import annotations

from varistiff.dynamics.control.checks import check_number
from varistiff.dynamics.control.controller import Controller, Measured, Number, Scalar, Wanted
from varistiff.dynamics.control.pid import Pid, PidMemory
from varistiff.dynamics.control.sensed_spring import SensedSpring


class SettingHold(Controller):
    """Setting torque u_2 = PID(motion - measured coordinate) [+ adjusting torque]: a servo to one place.

    Parameters
    ----------
    pid : gains and limit of the setting drive
    motion : coordinate of the setting drive to be held [rad or m]
    spring : where given, dV/ds ds/dz at the measured point is added
    """

    pid: Pid
    motion: Number
    spring: SensedSpring | None = None

    def __check_init__(self) -> None:
        check_number("motion", self.motion)

    def start(self, measured: Measured, wanted: Wanted) -> PidMemory:
        """See ``Controller.start``."""
        del wanted
        return self.pid.start(self.motion, measured.motion)

    def sample(self, memory: PidMemory, measured: Measured, wanted: Wanted, period: Number) -> tuple[Scalar, PidMemory]:
        """See ``Controller.sample``."""
        del wanted
        held = 0.0 if self.spring is None else self.spring.adjusting_torque(measured)
        return self.pid.sample(memory, self.motion, measured.motion, period, held)
