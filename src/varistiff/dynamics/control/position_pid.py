"""PID control of the joint's position, as Wang et al. (2024) use it for the main drive."""

from __future__ import annotations

from typing import Literal

import equinox as eqx

from varistiff.dynamics.control.checks import check_choice
from varistiff.dynamics.control.controller import Controller, Measured, Number, Scalar, Wanted
from varistiff.dynamics.control.pid import Pid, PidMemory


class PositionPid(Controller):
    """Drive torque u_1 = PID(wanted position - measured position).

    Parameters
    ----------
    pid : gains [N m/rad, N m/(rad s), N m s/rad] and limit [N m] (forces and metres for a linear device)
    feedback : ``link`` closes the loop over the spring (the paper's output position), ``drive`` leaves the spring
        outside, so that the link hangs on it passively

    Notes
    -----
    Wang et al. (2024), section 4.2 and Fig. 15, doi 10.3390/app14072685; its gains are not published.
    """

    pid: Pid
    feedback: Literal["link", "drive"] = eqx.field(static=True, default="link")

    def __check_init__(self) -> None:
        check_choice("feedback", self.feedback, ("link", "drive"))

    def _position(self, measured: Measured) -> Number:
        return measured.link if self.feedback == "link" else measured.drive

    def start(self, measured: Measured, wanted: Wanted) -> PidMemory:
        """See ``Controller.start``."""
        return self.pid.start(wanted.position, self._position(measured))

    def sample(self, memory: PidMemory, measured: Measured, wanted: Wanted, period: Number) -> tuple[Scalar, PidMemory]:
        """See ``Controller.sample``."""
        return self.pid.sample(memory, wanted.position, self._position(measured), period)
