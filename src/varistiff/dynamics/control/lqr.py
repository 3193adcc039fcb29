"""Linear quadratic regulator of a joint, designed at several settings."""

from __future__ import annotations

from typing import TYPE_CHECKING, NamedTuple

import numpy as np

from varistiff.core.errors import InputError
from varistiff.dynamics.control.checks import check_number
from varistiff.dynamics.control.two_mass import TwoMass

if TYPE_CHECKING:
    import control

_STATES = 4
_LINK = np.array([[1.0, 0.0, 0.0, 0.0]])


class LqrWeights(NamedTuple):
    """Weights of the cost: integral of sum(w_i x_i^2) + w_u u^2.

    By Bryson's rule a weight is one over the square of the largest value that is welcome: ``link`` [1/rad^2],
    ``link_rate`` [s^2/rad^2], ``drive``, ``drive_rate``, ``torque`` [1/(N m)^2], and ``integral`` [1/(rad s)^2] of the
    integrated link error; 0 leaves the integral action out.
    """

    link: float
    torque: float
    link_rate: float = 0.0
    drive: float = 0.0
    drive_rate: float = 0.0
    integral: float = 0.0

    def matrices(self) -> tuple[np.ndarray, np.ndarray]:
        """Q (4, 4), or (5, 5) with integral action, and R (1, 1).

        Raises
        ------
        InputError : a weight is negative, or that of the torque not above 0
        """
        for name in ("link_rate", "drive", "drive_rate", "integral"):
            check_number(name, getattr(self, name), least=0.0)
        check_number("link", self.link, above=0.0)
        check_number("torque", self.torque, above=0.0)
        states = [self.link, self.link_rate, self.drive, self.drive_rate]
        return np.diag(states + [self.integral] * (self.integral > 0.0)), np.array([[self.torque]])


def lqr_gains(model: TwoMass, stiffness: np.ndarray, weights: LqrWeights, *, period: float | None = None) -> np.ndarray:
    """Gains of u = -K x at several stiffnesses by python-control, shape (n, 4), or (n, 5) with integral action.

    Parameters
    ----------
    model : of the joint; its states are (q, q', q_1, q_1'), with the integral of q last
    stiffness : tangent stiffness [N m/rad or N/m] at each design point, above 0
    weights : of the cost
    period : None for the continuous regulator; a sample time [s] for the one that is optimal with a command held
        between samples

    Raises
    ------
    InputError : a stiffness is not above 0, or the regulator does not exist
    """
    import control

    check_number("stiffness", stiffness, above=0.0)
    q, r = weights.matrices()
    rows = []
    for value in np.asarray(stiffness, dtype=float):
        a, b = _augmented(model, float(value), weights.integral > 0.0, period)
        try:
            gain, _, _ = (control.lqr if period is None else control.dlqr)(a, b, q, r)
        except (ValueError, np.linalg.LinAlgError, control.ControlArgument) as error:
            raise InputError(f"no regulator exists at a stiffness of {value:.6g}: {error}") from None
        rows.append(np.asarray(gain)[0])
    return np.array(rows)


def open_loop(model: TwoMass, stiffness: float, *, period: float | None = None) -> control.StateSpace:
    """The joint from u_1 to its link position, continuous or held between samples [s].

    Raises
    ------
    InputError : a number is out of range
    """
    import control

    a, b = model.matrices(stiffness)
    system = control.ss(a, b, _LINK, 0.0)
    if period is None:
        return system
    check_number("period", period, above=0.0)
    return control.c2d(system, period, "zoh")


def closed_loop_poles(
    model: TwoMass, stiffness: float, gains: np.ndarray, *, period: float | None = None
) -> np.ndarray:
    """Poles of x' = (A - B K) x [rad/s], or of the sampled loop (inside the unit circle where stable).

    Parameters
    ----------
    model, stiffness : the joint
    gains : (4,), or (5,) with integral action
    period : sample time [s]; None for the continuous loop
    """
    a, b = _augmented(model, stiffness, gains.size == _STATES + 1, period)
    return np.linalg.eigvals(a - b @ gains[None, :])


def is_stable(poles: np.ndarray, *, sampled: bool) -> bool:
    """Whether all poles lie in the left half plane, or inside the unit circle for a sampled loop."""
    return bool((np.abs(poles) < 1.0).all() if sampled else (poles.real < 0.0).all())


def _augmented(model: TwoMass, stiffness: float, integral: bool, period: float | None) -> tuple[np.ndarray, np.ndarray]:
    """A and B of the joint, with the time integral of q as a fifth state where it is asked for."""
    system = open_loop(model, stiffness, period=period)
    a, b = np.asarray(system.A), np.asarray(system.B)
    if not integral:
        return a, b
    # over time, not over samples: the gain then has the same unit in both loops
    row = _LINK if period is None else period * _LINK
    corner = 0.0 if period is None else 1.0
    a = np.block([[a, np.zeros((_STATES, 1))], [row, np.array([[corner]])]])
    return a, np.vstack([b, [[0.0]]])
