"""A virtual spring-damper on a semi-active drive: the setting renders the torque."""

from __future__ import annotations

from typing import NamedTuple

import jax.numpy as jnp
import numpy as np

from varistiff.core.errors import InputError
from varistiff.dynamics.control.checks import check_number
from varistiff.dynamics.control.controller import Controller, Measured, Number, Scalar, Wanted, as_scalar
from varistiff.dynamics.control.filtered_rate import RateMemory, filtered_rate, start_rate
from varistiff.dynamics.control.motion_of_setting import motion_of_setting
from varistiff.dynamics.control.pid import Pid, PidMemory
from varistiff.dynamics.control.sensed_spring import SensedSpring
from varistiff.dynamics.control.setting_inverse import SettingInverse, setting_inverse

_CHECKED = 7  # deflections on each side at which the load is tried


class VirtualMemory(NamedTuple):
    """Of the setting's servo, the link's rate, and the setting that was last chosen."""

    motion: PidMemory
    link: RateMemory
    setting: Scalar


class VirtualSpringDamper(Controller):
    """The setting of a semi-active joint is chosen so that the spring puts the wanted torque on the link.

        tau = K_v (q_w - q) + D_v (q_w' - q') + tau_w,      -load(q, s) = tau

    and a servo brings the setting drive there: u_2 = PID(z(s) - z) + dV/ds ds/dz. Without K_v and D_v the joint
    follows the wanted torque, a knee moment for example.

    The spring only pushes back, within its range: a torque of the wrong sign, or too small, gets the softest setting,
    one that is too large the stiffest. Within the dead band about rest the setting has no say and stays. ``rendered``
    tells what can be had.

    Parameters
    ----------
    spring : map of the semi-active joint
    inverse : setting from load, of the same actuator; ``virtual_spring_damper`` makes and checks it
    pid : servo of the setting drive, with its limit
    stiffness : K_v [N m/rad], at least 0
    damping : D_v [N m s/rad], at least 0
    dead_band : deflection [rad] up to which the setting stays
    filter_time : of the link's rate [s]

    Notes
    -----
    The device and its purpose: dos Santos and Richter (2019), doi 10.3390/act8010012, whose control law is in a paper
    of its own; the law above is the plain inversion of the moment.

    Raises
    ------
    InputError : a number is out of range, or the joint has a drive of its own
    """

    spring: SensedSpring
    inverse: SettingInverse
    pid: Pid
    stiffness: Number = 0.0
    damping: Number = 0.0
    dead_band: Number = 0.0
    filter_time: Number = 0.0

    def __check_init__(self) -> None:
        for name in ("stiffness", "damping", "dead_band", "filter_time"):
            check_number(name, getattr(self, name), least=0.0)
        if self.spring.driven:
            raise InputError("a joint with a drive of its own needs no virtual spring-damper", field="spring.driven")

    def torque(self, measured: Measured, wanted: Wanted, rate: Number) -> Scalar:
        """Torque [N m] that the link is to feel, at a link rate [rad/s]."""
        spring = self.stiffness * (wanted.position - measured.link)
        return as_scalar(spring + self.damping * (wanted.position_rate - rate) + wanted.torque)

    def rendered(self, measured: Measured, wanted: Wanted, rate: Number) -> Scalar:
        """Torque [N m] that the spring would give at the chosen setting: what can be had of the wanted one."""
        deflection = self.spring.deflection(measured)
        setting = self.inverse.at(-self.torque(measured, wanted, rate), deflection)
        return -self.spring.actuator.respond(deflection, setting)[0].load

    def start(self, measured: Measured, wanted: Wanted) -> VirtualMemory:
        """See ``Controller.start``."""
        del wanted
        setting = self.spring.setting(measured)
        return VirtualMemory(
            self.pid.start(motion_of_setting(self.spring.path, setting), measured.motion),
            start_rate(measured.link),
            as_scalar(setting),
        )

    def sample(
        self, memory: VirtualMemory, measured: Measured, wanted: Wanted, period: Number
    ) -> tuple[Scalar, VirtualMemory]:
        """See ``Controller.sample``."""
        link = filtered_rate(memory.link, measured.link, period, self.filter_time)
        deflection = self.spring.deflection(measured)
        chosen = self.inverse.at(-self.torque(measured, wanted, link.rate), deflection)
        setting = jnp.where(jnp.abs(deflection) > self.dead_band, chosen, memory.setting)
        goal = motion_of_setting(self.spring.path, setting)
        command, motion = self.pid.sample(
            memory.motion, goal, measured.motion, period, self.spring.adjusting_torque(measured)
        )
        return command, VirtualMemory(motion, link, setting)


def virtual_spring_damper(
    spring: SensedSpring,
    pid: Pid,
    *,
    deflection_max: float,
    deflection_min: float | None = None,
    stiffness: float = 0.0,
    damping: float = 0.0,
    dead_band: float,
    filter_time: float = 0.0,
) -> VirtualSpringDamper:
    """Make a ``VirtualSpringDamper`` after checking that the load is monotone in the setting.

    Parameters
    ----------
    spring : map of the semi-active joint with a finite range of settings
    pid, stiffness, damping, filter_time : see ``VirtualSpringDamper``
    deflection_max, deflection_min : range of the joint angle in use [rad]; None for minus ``deflection_max``
    dead_band : above 0; wide enough for the element to be in contact over the whole range of settings

    Raises
    ------
    InputError : the load turns back over the settings at a deflection in use, or does not exist there
    """
    check_number("dead_band", dead_band, above=0.0)
    low = -deflection_max if deflection_min is None else deflection_min
    used: list[float] = []
    for start, end in ((dead_band, deflection_max), (-dead_band, low)):
        if end / start > 1.0:  # a joint that bends to one side only has nothing to check on the other
            used.extend(float(value) for value in np.linspace(start, end, _CHECKED))
    if not used:
        raise InputError("no deflection in use lies beyond the dead band", field="dead_band")
    inverse = setting_inverse(
        spring.actuator,
        setting_min=float(spring.setting_min),
        setting_max=float(spring.setting_max),
        quantity="load",
        deflections=used,
    )
    return VirtualSpringDamper(spring, inverse, pid, stiffness, damping, dead_band, filter_time)
