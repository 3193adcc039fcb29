"""PID control of the joint's stiffness through its setting drive."""

from __future__ import annotations

import equinox as eqx

from varistiff.dynamics.control.controller import Controller, Measured, Number, Scalar, Wanted
from varistiff.dynamics.control.pid import Pid, PidMemory
from varistiff.dynamics.control.sensed_spring import SensedSpring
from varistiff.dynamics.control.stiffness_chain import StiffnessChain


class StiffnessPid(Controller):
    """Setting torque u_2 = PID(coordinate that the chain wants - measured coordinate) [+ adjusting torque].

    As published the error is one of the stiffness disc's angle: the chain turns the stiffness command into an angle,
    and the encoder of the stiffness motor closes the loop.

    Parameters
    ----------
    pid : gains [N m/rad, ...] and limit [N m] of the setting drive
    chain : from stiffness to the setting drive's coordinate
    spring : where given, dV/ds ds/dz at the measured point is added: the load then does not disturb the setting
    driven : False for a semi-active joint, whose deflection is the link's position itself

    Notes
    -----
    Wang et al. (2024), section 4.2 and Fig. 15, doi 10.3390/app14072685 (without ``spring``).
    """

    pid: Pid
    chain: StiffnessChain
    spring: SensedSpring | None = None
    driven: bool = eqx.field(static=True, default=True)

    def _wanted_motion(self, measured: Measured, wanted: Wanted) -> Scalar:
        deflection = measured.drive - measured.link if self.driven else measured.link
        return self.chain.motion(wanted.stiffness, deflection)

    def start(self, measured: Measured, wanted: Wanted) -> PidMemory:
        """See ``Controller.start``."""
        return self.pid.start(self._wanted_motion(measured, wanted), measured.motion)

    def sample(self, memory: PidMemory, measured: Measured, wanted: Wanted, period: Number) -> tuple[Scalar, PidMemory]:
        """See ``Controller.sample``."""
        held = 0.0 if self.spring is None else self.spring.adjusting_torque(measured)
        return self.pid.sample(memory, self._wanted_motion(measured, wanted), measured.motion, period, held)
