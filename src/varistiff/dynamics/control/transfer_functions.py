"""Controllers as transfer functions, for analysis with python-control."""

from __future__ import annotations

from typing import TYPE_CHECKING

from varistiff.core.errors import InputError
from varistiff.dynamics.control.checks import check_number
from varistiff.dynamics.control.pid import Pid

if TYPE_CHECKING:
    import control


def transfer_function(pid: Pid) -> control.TransferFunction:
    """C(s) = k_p + k_i/s + k_d s/(T_f s + 1): the loop's controller, from the error to the command.

    The limit and the anti-windup are not linear and are left out. Where the derivative acts on the measurement this is
    the controller of the feedback loop; a reference sees ``reference_transfer_function``.
    """
    return _sum(pid, float(pid.derivative))


def reference_transfer_function(pid: Pid) -> control.TransferFunction:
    """From the wanted signal to the command: without the derivative where that acts on the measurement.

    The closed loop from wanted to measured is P C_r/(1 + P C).
    """
    return _sum(pid, float(pid.derivative) if pid.derivative_on == "error" else 0.0)


def sampled_transfer_function(pid: Pid, period: float) -> control.TransferFunction:
    """C(z) of the law as it is sampled.

        C(z) = k_p + k_i T/(z - 1) + k_d (z - 1)/((T_f + T) z - T_f)

    Parameters
    ----------
    pid : the law; limit and anti-windup are left out
    period : T [s], above 0

    Raises
    ------
    InputError : the period is not above 0
    """
    import control

    check_number("period", period, above=0.0)
    filtered = float(pid.filter_time)
    law = control.tf([float(pid.proportional)], [1.0], period)
    if float(pid.integral) != 0.0:
        law = law + control.tf([float(pid.integral) * period], [1.0, -1.0], period)
    if float(pid.derivative) != 0.0:
        gain = float(pid.derivative)
        law = law + control.tf([gain, -gain], [filtered + period, -filtered], period)
    return law


def delay_transfer_function(delay: float, *, order: int = 3) -> control.TransferFunction:
    """Pade approximation of e^(-s T), for loops with a sampled controller.

    Holding a command from sample to sample delays it by half a period on average: give the delay of readings and
    command, in seconds, plus half a period.

    Parameters
    ----------
    delay : T [s], at least 0
    order : of the approximation, at least 1; its phase is right up to about 2 order/T [rad/s]

    Raises
    ------
    InputError : a number is out of range
    """
    import control

    check_number("delay", delay, least=0.0)
    if order < 1:
        raise InputError(f"must be at least 1, not {order}", field="order")
    return control.tf(*control.pade(delay, order)) if delay > 0.0 else control.tf([1.0], [1.0])


def _sum(pid: Pid, derivative: float) -> control.TransferFunction:
    import control

    law = control.tf([float(pid.proportional)], [1.0])
    if float(pid.integral) != 0.0:
        law = law + control.tf([float(pid.integral)], [1.0, 0.0])
    if derivative != 0.0:
        law = law + control.tf([derivative, 0.0], [float(pid.filter_time), 1.0])
    return law
