"""Impedance control: a virtual spring-damper around a torque loop."""

from __future__ import annotations

from typing import NamedTuple

from varistiff.dynamics.control.checks import check_number
from varistiff.dynamics.control.controller import Controller, Measured, Number, Scalar, Wanted, as_scalar
from varistiff.dynamics.control.filtered_rate import RateMemory, filtered_rate, start_rate
from varistiff.dynamics.control.pid import PidMemory
from varistiff.dynamics.control.torque_control import TorqueControl


class ImpedanceMemory(NamedTuple):
    """Of the torque loop, and the link's rate."""

    torque: PidMemory
    link: RateMemory


class ImpedanceControl(Controller):
    """Cascade: the link is to feel a virtual spring-damper, and the inner loop makes the spring give it.

        tau = K_v (q_w - q) + D_v (q_w' - q') + J_v q_w'' + tau_w

    with the wanted position q_w and the wanted torque tau_w.

    Parameters
    ----------
    torque_control : the inner loop
    stiffness : K_v [N m/rad or N/m], at least 0
    damping : D_v [N m s/rad or N s/m], at least 0
    inertia : J_v [kg m^2 or kg] of the link, for the wanted acceleration; 0 leaves it out
    filter_time : of the link's rate [s]

    Notes
    -----
    Hogan (1985), doi 10.1115/1.3140702. Above the bandwidth of the inner loop the link feels the spring, whatever
    K_v is: choose K_v below the spring's own stiffness.

    Raises
    ------
    InputError : a number is negative or not finite
    """

    torque_control: TorqueControl
    stiffness: Number
    damping: Number = 0.0
    inertia: Number = 0.0
    filter_time: Number = 0.0

    def __check_init__(self) -> None:
        for name in ("stiffness", "damping", "inertia", "filter_time"):
            check_number(name, getattr(self, name), least=0.0)

    def torque(self, measured: Measured, wanted: Wanted, rate: Number) -> Scalar:
        """Torque [N m] or force [N] that the link is to feel, at a link rate [rad/s or m/s]."""
        spring = self.stiffness * (wanted.position - measured.link)
        damper = self.damping * (wanted.position_rate - rate)
        return as_scalar(spring + damper + self.inertia * wanted.position_acceleration + wanted.torque)

    def start(self, measured: Measured, wanted: Wanted) -> ImpedanceMemory:
        """See ``Controller.start``."""
        asked = wanted._replace(torque=self.torque(measured, wanted, 0.0))
        return ImpedanceMemory(self.torque_control.start(measured, asked), start_rate(measured.link))

    def sample(
        self, memory: ImpedanceMemory, measured: Measured, wanted: Wanted, period: Number
    ) -> tuple[Scalar, ImpedanceMemory]:
        """See ``Controller.sample``."""
        link = filtered_rate(memory.link, measured.link, period, self.filter_time)
        asked = wanted._replace(torque=self.torque(measured, wanted, link.rate))
        command, torque = self.torque_control.sample(memory.torque, measured, asked, period)
        return command, ImpedanceMemory(torque, link)
