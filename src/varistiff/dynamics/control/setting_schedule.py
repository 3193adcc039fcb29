"""A setting that follows a signal of time of its own, such as a roller's course over a gait cycle."""

from __future__ import annotations

from typing import NamedTuple

from varistiff.dynamics.control.checks import check_number
from varistiff.dynamics.control.controller import Controller, Measured, Number, Scalar, Wanted, as_scalar
from varistiff.dynamics.control.motion_of_setting import motion_of_setting
from varistiff.dynamics.control.pid import Pid, PidMemory
from varistiff.dynamics.control.sensed_spring import SensedSpring
from varistiff.dynamics.path import Affine
from varistiff.dynamics.signals import Signal


class ScheduleMemory(NamedTuple):
    """Of the servo, and its clock [s]."""

    servo: PidMemory
    time: Scalar


class SettingSchedule(Controller):
    """Setting torque u_2 = PID(z_w - z) + J_z z_w'' + dV/ds ds/dz, for a setting s(z_w) that a signal states.

    Parameters
    ----------
    pid : servo of the setting drive, with its limit
    setting : wanted setting [m or rad] against the controller's own time, which starts at 0
    spring : map at the measured point, for dV/ds ds/dz; its path turns a setting into the drive's coordinate
    inertia : J_z of the setting drive with all that it moves [kg m^2 or kg]; 0 for no feedforward of the acceleration

    Notes
    -----
    The clock stands for a gait phase that is known; finding it is another matter. The path is ``Affine``: a screw, a
    belt or a straight line.

    Raises
    ------
    InputError : the inertia is not a number or below zero
    TypeError : the path is not affine
    """

    pid: Pid
    setting: Signal
    spring: SensedSpring
    inertia: Number = 0.0

    def __check_init__(self) -> None:
        check_number("inertia", self.inertia, least=0.0)
        if not isinstance(self.spring.path, Affine):
            raise TypeError(f"a schedule needs an affine path, not a {type(self.spring.path).__name__}")

    def start(self, measured: Measured, wanted: Wanted) -> ScheduleMemory:
        """See ``Controller.start``."""
        del wanted
        goal = motion_of_setting(self.spring.path, self.setting.at(as_scalar(0.0)).value)
        return ScheduleMemory(self.pid.start(goal, measured.motion), as_scalar(0.0))

    def sample(
        self, memory: ScheduleMemory, measured: Measured, wanted: Wanted, period: Number
    ) -> tuple[Scalar, ScheduleMemory]:
        """See ``Controller.sample``."""
        del wanted
        now = self.setting.at(memory.time)
        path = self.spring.path
        goal = motion_of_setting(path, now.value)
        acceleration = now.acceleration / path.at(goal).slope
        ahead = self.inertia * acceleration + self.spring.adjusting_torque(measured)
        command, servo = self.pid.sample(memory.servo, goal, measured.motion, period, ahead)
        return command, ScheduleMemory(servo, memory.time + period)
