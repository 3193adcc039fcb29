"""Controllers of drives and settings: sampled laws of numbers, what they know of the spring, and their sensors."""

from varistiff.core import precision
from varistiff.dynamics.control.active_length import active_length_from_stiffness
from varistiff.dynamics.control.controller import Controller, Measured, Wanted
from varistiff.dynamics.control.delay import Delay, DelayedController
from varistiff.dynamics.control.encoder import Encoder, rotary_encoder
from varistiff.dynamics.control.external_torque import external_torque
from varistiff.dynamics.control.filtered_rate import filtered_rate, start_rate
from varistiff.dynamics.control.groove_chain import ExactChain, WangChain, exact_chain, wang_chain
from varistiff.dynamics.control.impedance_control import ImpedanceControl
from varistiff.dynamics.control.link_demand import GravityTorque, LinkModel, wanted_deflection
from varistiff.dynamics.control.lqr import LqrWeights, closed_loop_poles, is_stable, lqr_gains, open_loop
from varistiff.dynamics.control.map_chain import MapChain
from varistiff.dynamics.control.monotone_inverse import monotone_inverse
from varistiff.dynamics.control.motion_of_setting import motion_of_setting
from varistiff.dynamics.control.pid import Pid
from varistiff.dynamics.control.position_pid import PositionPid
from varistiff.dynamics.control.scheduled_lqr import ScheduledLqr, scheduled_lqr
from varistiff.dynamics.control.sensed_spring import SensedSpring
from varistiff.dynamics.control.setting_hold import SettingHold
from varistiff.dynamics.control.setting_inverse import SettingInverse, setting_inverse
from varistiff.dynamics.control.stiffness_chain import StiffnessChain
from varistiff.dynamics.control.stiffness_decoupling import StiffnessDecoupling
from varistiff.dynamics.control.stiffness_pid import StiffnessPid
from varistiff.dynamics.control.straight_line import StraightLine, straight_line
from varistiff.dynamics.control.torque_control import TorqueControl
from varistiff.dynamics.control.transfer_functions import (
    delay_transfer_function,
    reference_transfer_function,
    sampled_transfer_function,
    transfer_function,
)
from varistiff.dynamics.control.two_mass import TwoMass, tangent_stiffness
from varistiff.dynamics.control.virtual_spring_damper import VirtualSpringDamper, virtual_spring_damper
from varistiff.dynamics.control.wang_encoders import wang_encoders

precision.enable()

__all__ = [
    "Controller",
    "Delay",
    "DelayedController",
    "Encoder",
    "ExactChain",
    "GravityTorque",
    "ImpedanceControl",
    "LinkModel",
    "LqrWeights",
    "MapChain",
    "Measured",
    "Pid",
    "PositionPid",
    "ScheduledLqr",
    "SensedSpring",
    "SettingHold",
    "SettingInverse",
    "StiffnessChain",
    "StiffnessDecoupling",
    "StiffnessPid",
    "StraightLine",
    "TorqueControl",
    "TwoMass",
    "VirtualSpringDamper",
    "WangChain",
    "Wanted",
    "active_length_from_stiffness",
    "closed_loop_poles",
    "delay_transfer_function",
    "exact_chain",
    "external_torque",
    "filtered_rate",
    "is_stable",
    "lqr_gains",
    "monotone_inverse",
    "motion_of_setting",
    "open_loop",
    "reference_transfer_function",
    "rotary_encoder",
    "sampled_transfer_function",
    "scheduled_lqr",
    "setting_inverse",
    "start_rate",
    "straight_line",
    "tangent_stiffness",
    "transfer_function",
    "virtual_spring_damper",
    "wang_chain",
    "wang_encoders",
    "wanted_deflection",
]
