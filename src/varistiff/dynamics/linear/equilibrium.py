"""Equilibrium of a joint: positions and torques at which nothing moves, and whether they are stable."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Literal

import numpy as np

from varistiff.core.errors import InputError
from varistiff.core.status import Status
from varistiff.dynamics.linear.balance import balance
from varistiff.dynamics.linear.matrices import COORDINATES, Coordinate
from varistiff.dynamics.linear.state_at import standing
from varistiff.dynamics.linear.statics import Statics, real_coordinates, statics
from varistiff.dynamics.plant import Plant
from varistiff.dynamics.state import Motion

_NEUTRAL = 1e-9  # of the largest stiffness, below which a direction counts as having none
_FORCES: dict[Coordinate, str] = {"link": "external_torque", "drive": "drive_torque", "motion": "setting_torque"}
_Numbers = dict[Coordinate, float | None]
_SIGNS: dict[Coordinate, float] = {"link": -1.0, "drive": 1.0, "motion": 1.0}  # tau_ext acts against the link


@dataclass(frozen=True)
class Equilibrium:
    """A joint at rest.

    Parameters
    ----------
    motion : positions [rad or m]; the rates are 0
    external_torque : tau_ext [N m or N], against the link's positive direction
    drive_torque, setting_torque : what the drives hold with, u_1 and u_2 [N m or N]; 0 where there is no such drive
    residual : largest force that is left unbalanced [N m or N]
    free : coordinates whose force was given: they may move, the others are held where they are
    hessian : second derivatives of the potential energy with respect to those
    status : of the actuator at this point
    """

    motion: Motion
    external_torque: float
    drive_torque: float
    setting_torque: float
    residual: float
    free: tuple[Coordinate, ...]
    hessian: np.ndarray
    status: Status

    @property
    def stability(self) -> Literal["stable", "neutral", "unstable"]:
        """Of the free coordinates under constant loads: by the least eigenvalue of the potential's Hessian.

        Coordinates of different units are scaled to equal stiffness first, which changes no sign. Nothing free is
        stable; a rigid turn of link and drive together is neutral.
        """
        if not self.free:
            return "stable"
        size = np.sqrt(np.abs(np.diag(self.hessian)))
        size[size == 0.0] = 1.0
        values = np.linalg.eigvalsh(self.hessian / np.outer(size, size))
        bound = _NEUTRAL * float(np.max(np.abs(values)))
        if values[0] > bound:
            return "stable"
        return "neutral" if values[0] >= -bound else "unstable"


def equilibrium(
    plant: Plant,
    *,
    guess: Motion | None = None,
    link: float | None = None,
    drive: float | None = None,
    motion: float | None = None,
    external_torque: float | None = None,
    drive_torque: float | None = None,
    setting_torque: float | None = None,
) -> Equilibrium:
    """Rest of a joint of which some positions and some forces are known.

    The balances are those of the equations of motion with every rate and acceleration zero, one per coordinate:

        load - dV_g/dq = tau_ext,    u_1 = load,    u_2 = dV/ds ds/dz + dV_g/dz

    and the stops' forces. Give as many numbers as there are coordinates: three of the six for a driven joint, two of
    four (no drive) for a semi-active one or (no setting) for an actuator without a setting. The others are found: the
    unknown positions by Newton's method from ``guess``, the unknown forces from their balances. Friction and backlash
    hold within a range; the answer has no friction, and in a dead band it is the point nearest to the guess.

    Parameters
    ----------
    guess : where to look for unknown positions; None for zeros
    link, drive, motion : positions of link, drive and setting drive [rad or m]
    external_torque : tau_ext [N m or N]
    drive_torque, setting_torque : u_1, u_2 at the outputs [N m or N]; limits of the motors are not looked at

    Raises
    ------
    InputError : too few or too many are given, they do not determine the rest, or no equilibrium is found near
        the guess

    >>> from varistiff.actuators import SeriesElastic
    >>> from varistiff.dynamics.plant import Member
    >>> joint = Plant(SeriesElastic(stiffness=160.0), link=Member(0.1), drive=Member(0.02))
    >>> rest = equilibrium(joint, drive=0.3, external_torque=8.0)
    >>> round(float(rest.motion.link), 12), round(rest.drive_torque, 9), rest.stability
    (0.25, 8.0, 'stable')
    """
    given: _Numbers = {"link": link, "drive": drive, "motion": motion}
    forces: _Numbers = {"link": external_torque, "drive": drive_torque, "motion": setting_torque}
    real = real_coordinates(plant)
    _check(real, given, forces)
    start = standing(0.0, 0.0, 0.0) if guess is None else guess
    places = np.array([_place(name, given, start, real) for name in COORDINATES])
    unknown = [COORDINATES.index(name) for name in real if given[name] is None]
    free = tuple(name for name in real if forces[name] is not None)
    held = [COORDINATES.index(name) for name in free]
    applied = np.array([_SIGNS[name] * float(forces[name] or 0.0) for name in free])

    balances = statics(plant)

    def unbalance(values: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
        at = places.copy()
        at[unknown] = values
        found = balances(at)
        return found.forces[held] + applied, found.slopes[np.ix_(held, unknown)]

    root = balance(unbalance, places[unknown], float(np.max(np.abs(applied), initial=0.0)))
    if not root.converged:
        raise InputError(_none_found(plant, free, root.residual))
    places[unknown] = root.unknowns
    return _result(balances(places), places, real, free, forces, root.residual)


def _place(name: Coordinate, given: _Numbers, guess: Motion, real: tuple[Coordinate, ...]) -> float:
    value = given[name]
    if name not in real:
        return 0.0
    return float(getattr(guess, name)) if value is None else float(value)


def _check(real: tuple[Coordinate, ...], given: _Numbers, forces: _Numbers) -> None:
    names = [*real, *(_FORCES[name] for name in real)]
    for name in COORDINATES:
        if name not in real and (given[name] is not None or forces[name] is not None):
            raise InputError(f"this joint has no such coordinate; give {len(real)} of {', '.join(names)}", field=name)
    told = [(name, given[name]) for name in real] + [(_FORCES[name], forces[name]) for name in real]
    known = [field for field, value in told if value is not None]
    for field, value in told:
        if value is not None and not np.isfinite(value):
            raise InputError(f"must be a finite number, not {value!r}", field=field)
    unknown = sum(given[name] is None for name in real)
    if len(known) != len(real) or unknown != sum(forces[name] is not None for name in real):
        raise InputError(
            f"an equilibrium needs {len(real)} of {', '.join(names)}; given are {', '.join(known) or 'none'}"
        )


def _none_found(plant: Plant, free: tuple[Coordinate, ...], residual: float) -> str:
    unit = "N*m" if plant.actuator.deflection_unit == "rad" else "N"
    left = f"{residual:.4g} {unit} stays unbalanced" if np.isfinite(residual) else "the actuator has no solution there"
    return (
        f"no equilibrium of the {' and the '.join(free)} is found near the guess: {left}; change the loads or the guess"
    )


def _result(
    found: Statics,
    places: np.ndarray,
    real: tuple[Coordinate, ...],
    free: tuple[Coordinate, ...],
    given: _Numbers,
    residual: float,
) -> Equilibrium:
    torques = dict.fromkeys(_FORCES.values(), 0.0)
    for name in real:
        force = given[name]
        balancing = -_SIGNS[name] * float(found.forces[COORDINATES.index(name)])
        torques[_FORCES[name]] = (balancing if force is None else float(force)) + 0.0  # no minus zero
    if not np.isfinite(list(torques.values())).all():
        raise InputError(f"the actuator has no solution at this point: {Status(found.status).label}")
    held = [COORDINATES.index(name) for name in free]
    return Equilibrium(
        motion=standing(*map(float, places)),
        **torques,
        residual=residual,
        free=free,
        hessian=-found.slopes[np.ix_(held, held)],
        status=Status(found.status),
    )
