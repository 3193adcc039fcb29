"""The PID law with a filtered derivative, a torque limit and back-calculation against windup."""

from __future__ import annotations

import math
from typing import Literal, NamedTuple

import equinox as eqx
import jax.numpy as jnp

from varistiff.dynamics.control.checks import check_choice, check_number
from varistiff.dynamics.control.controller import Number, Scalar, as_scalar
from varistiff.dynamics.control.filtered_rate import RateMemory, filtered_rate, start_rate


class PidMemory(NamedTuple):
    """The integral part [command], and the differentiated signal with its filtered rate."""

    integral: Scalar
    rate: RateMemory


class Pid(eqx.Module):
    """PID law on one signal, e = wanted - measured, with a limit and without windup.

        u = sat(f + k_p e + I + k_d r),      I_(k+1) = I_k + T k_i e + (T/T_t) (u - v)

    where f is a feedforward, v the bracket before saturation and r the filtered rate of e (or of -measured), so that
    the continuous law is C(s) = k_p + k_i/s + k_d s/(T_f s + 1). Integral by forward, derivative by backward
    differences: C(z) = k_p + k_i T/(z - 1) + k_d (z - 1)/((T_f + T) z - T_f).

    Parameters
    ----------
    proportional, integral, derivative : k_p [command per signal], k_i [.../s], k_d [... s]
    filter_time : T_f [s] of the derivative; 0 for none
    windup_time : T_t [s] in which a saturated integral part runs back; infinite for no anti-windup, and never faster
        than one sample
    limit : largest command, the same in both directions; infinite for none
    derivative_on : ``measurement`` (no kick from a step) or ``error`` (as in a plain PID)

    Notes
    -----
    Astrom and Hagglund (1995), PID Controllers, chapter 3; back-calculation: Astrom and Rundqwist (1989), Integrator
    windup and how to avoid it, American Control Conference, 1693-1698.

    Raises
    ------
    InputError : a number is not finite, or a time or the limit is out of range
    """

    proportional: Number
    integral: Number = 0.0
    derivative: Number = 0.0
    filter_time: Number = 0.0
    windup_time: Number = math.inf
    limit: Number = math.inf
    derivative_on: Literal["measurement", "error"] = eqx.field(static=True, default="measurement")

    def __check_init__(self) -> None:
        for name in ("proportional", "integral", "derivative"):
            check_number(name, getattr(self, name))
        check_number("filter_time", self.filter_time, least=0.0)
        check_number("windup_time", self.windup_time, above=0.0, infinite=True)
        check_number("limit", self.limit, above=0.0, infinite=True)
        check_choice("derivative_on", self.derivative_on, ("measurement", "error"))

    def _differentiated(self, wanted: Number, measured: Number) -> Scalar:
        return as_scalar(wanted - measured if self.derivative_on == "error" else -measured)

    def start(self, wanted: Number, measured: Number) -> PidMemory:
        """Memory with nothing integrated and nothing moving."""
        return PidMemory(as_scalar(0.0), start_rate(self._differentiated(wanted, measured)))

    def sample(
        self, memory: PidMemory, wanted: Number, measured: Number, period: Number, feedforward: Number = 0.0
    ) -> tuple[Scalar, PidMemory]:
        """Command and next memory; the limit holds the sum of feedback and ``feedforward``."""
        error = as_scalar(wanted - measured)
        rate = filtered_rate(memory.rate, self._differentiated(wanted, measured), period, self.filter_time)
        unlimited = feedforward + self.proportional * error + memory.integral + self.derivative * rate.rate
        command = jnp.clip(unlimited, -self.limit, self.limit)
        recovery = jnp.minimum(period / self.windup_time, 1.0)
        integral = memory.integral + self.integral * period * error + recovery * (command - unlimited)
        return command, PidMemory(integral, rate)
