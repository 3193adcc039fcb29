"""Position control whose behaviour does not depend on the stiffness: the map is fed forward."""

from __future__ import annotations

from typing import NamedTuple

from varistiff.dynamics.control.checks import check_number
from varistiff.dynamics.control.controller import Controller, Measured, Number, Scalar, Wanted
from varistiff.dynamics.control.filtered_rate import RateMemory, filtered_rate, start_rate
from varistiff.dynamics.control.link_demand import LinkModel, wanted_deflection
from varistiff.dynamics.control.pid import Pid, PidMemory
from varistiff.dynamics.control.sensed_spring import SensedSpring
from varistiff.dynamics.control.torque_control import require_drive


class DecouplingMemory(NamedTuple):
    """Of the drive's servo, and the link's rate."""

    drive: PidMemory
    link: RateMemory


class StiffnessDecoupling(Controller):
    """Computed torque through a spring whose stiffness changes while it works.

    The link is to move by J e'' + (D + D_v) e' + K_v e = 0, e = q_w - q, which needs the load

        tau = J q_w'' + D q_w' + gravity(q_w) + tau_w + K_v e + D_v e'

    The map says at which deflection the spring gives it, at the measured setting, and the drive is sent to
    q_1w = q + d_w by a servo that is freed of the spring's reaction:

        u_1 = load(d, s) + J_1 q_w'' + D_1 q_w' + PID(q_1w - q_1)

    Neither loop knows the stiffness any more; a setting that moves shifts d_w at once. What is left of the coupling
    comes from the servo's bandwidth: it must lie well above sqrt(K_v/J).

    Parameters
    ----------
    spring : map of a driven joint
    pid : servo of the drive [N m/rad, ...] with the limit of the whole command [N m]
    link : inertia, damping and gravity of the link
    stiffness : K_v [N m/rad or N/m], at least 0
    damping : D_v [N m s/rad or N s/m], at least 0
    drive_inertia, drive_damping : J_1 and D_1, reflected rotor included; 0 leaves the feedforward out
    stiffness_min : see ``wanted_deflection``
    filter_time : of the link's rate [s]

    Notes
    -----
    The elastic joint's inverse dynamics: Spong (1987), doi 10.1115/1.3143860, without its fourth derivative: d_w'' is
    left to the servo.

    Raises
    ------
    InputError : a number is out of range, or the joint is semi-active
    """

    spring: SensedSpring
    pid: Pid
    link: LinkModel
    stiffness: Number
    damping: Number = 0.0
    drive_inertia: Number = 0.0
    drive_damping: Number = 0.0
    stiffness_min: Number = 1e-6
    filter_time: Number = 0.0

    def __check_init__(self) -> None:
        for name in ("stiffness", "damping", "drive_inertia", "drive_damping", "filter_time"):
            check_number(name, getattr(self, name), least=0.0)
        check_number("stiffness_min", self.stiffness_min, above=0.0)
        require_drive(self.spring)

    def _goal(self, measured: Measured, wanted: Wanted, rate: Number) -> tuple[Scalar, Scalar]:
        """Wanted drive position q_1w, and the spring's load now."""
        response = self.spring.response(measured)
        feedback = self.stiffness * (wanted.position - measured.link) + self.damping * (wanted.position_rate - rate)
        deflection = wanted_deflection(
            response,
            self.spring.deflection(measured),
            self.link.load(wanted) + feedback,
            stiffness_min=self.stiffness_min,
        )
        return measured.link + deflection, response.load

    def start(self, measured: Measured, wanted: Wanted) -> DecouplingMemory:
        """See ``Controller.start``."""
        goal, _ = self._goal(measured, wanted, 0.0)
        return DecouplingMemory(self.pid.start(goal, measured.drive), start_rate(measured.link))

    def sample(
        self, memory: DecouplingMemory, measured: Measured, wanted: Wanted, period: Number
    ) -> tuple[Scalar, DecouplingMemory]:
        """See ``Controller.sample``."""
        link = filtered_rate(memory.link, measured.link, period, self.filter_time)
        goal, load = self._goal(measured, wanted, link.rate)
        ahead = self.drive_inertia * wanted.position_acceleration + self.drive_damping * wanted.position_rate
        command, drive = self.pid.sample(memory.drive, goal, measured.drive, period, load + ahead)
        return command, DecouplingMemory(drive, link)
