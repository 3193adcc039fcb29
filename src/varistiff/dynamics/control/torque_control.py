"""Torque control of a series elastic joint: the spring is the sensor."""

from __future__ import annotations

from varistiff.core.errors import InputError
from varistiff.dynamics.control.controller import Controller, Measured, Number, Scalar, Wanted
from varistiff.dynamics.control.pid import Pid, PidMemory
from varistiff.dynamics.control.sensed_spring import SensedSpring


class TorqueControl(Controller):
    """Drive torque u_1 = torque wanted + PID(torque wanted - torque of the spring on the link).

    The spring's torque is read from the deflection and the map. The wanted torque itself is fed forward: it is what
    the spring puts back on the drive.

    Parameters
    ----------
    pid : gains [N m per N m, 1/s, s] and limit [N m]
    spring : map of a driven joint

    Notes
    -----
    Pratt and Williamson (1995), doi 10.1109/IROS.1995.525827.

    Raises
    ------
    InputError : the joint is semi-active and has no drive
    """

    pid: Pid
    spring: SensedSpring

    def __check_init__(self) -> None:
        require_drive(self.spring)

    def start(self, measured: Measured, wanted: Wanted) -> PidMemory:
        """See ``Controller.start``."""
        return self.pid.start(wanted.torque, self.spring.link_load(measured))

    def sample(self, memory: PidMemory, measured: Measured, wanted: Wanted, period: Number) -> tuple[Scalar, PidMemory]:
        """See ``Controller.sample``."""
        return self.pid.sample(memory, wanted.torque, self.spring.link_load(measured), period, wanted.torque)


def require_drive(spring: SensedSpring) -> None:
    """Refuse a semi-active joint.

    Raises
    ------
    InputError : the joint has no drive
    """
    if not spring.driven:
        raise InputError("a semi-active joint has no drive that could be controlled", field="spring.driven")
