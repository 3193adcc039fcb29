"""Drives: what turns a command into torque, with its losses, limits and heat; motors from data sheets."""

from varistiff.core import precision
from varistiff.dynamics.drives.drive import Drive, DriveFlows, Temperatures
from varistiff.dynamics.drives.motor_table import MotorData, motor, motor_data, motor_table
from varistiff.dynamics.drives.permanent_magnet_motor import Motor
from varistiff.dynamics.drives.torque_source import TorqueSource
from varistiff.dynamics.drives.two_node_heating import TwoNodeHeating

precision.enable()

__all__ = [
    "Drive",
    "DriveFlows",
    "Motor",
    "MotorData",
    "Temperatures",
    "TorqueSource",
    "TwoNodeHeating",
    "motor",
    "motor_data",
    "motor_table",
]
