"""Torque, elastic energy and adjusting force over length and deflection (Eqs. 7, 10 and 12; Figs. 7 to 9)."""

from __future__ import annotations

import numpy as np

from varistiff.papers.wang_2024 import paper_values as paper
from varistiff.papers.wang_2024.device import Answer, answer, deflections, effective_lengths, joint


def _field() -> Answer:
    """Everything over deflections (rows) and lengths (columns)."""
    return answer(joint(), deflection=deflections()[:, None], length=effective_lengths())


def torque_steeper_when_short() -> float:
    """Torque per deflection at 6 mm over that at 25 mm, less 1."""
    torque = _field().torque
    return float(torque[-1, 0] / torque[-1, -1] - 1.0)


def torque_follows_deflection() -> float:
    """Influence of the deflection on the torque over that on the stiffness, both as ranges over the largest, less 1."""
    field = _field()
    torque, stiffness = np.ptp(field.torque, axis=0), np.ptp(field.stiffness, axis=0)
    share = (torque / field.torque.max(axis=0)) / (stiffness / field.stiffness.max(axis=0))
    return float(share.min() - 1.0)


def torque_growth_towards_zero() -> float:
    """How much faster than l_1^-2 the torque grows where l_1 goes to zero, at the printed limit of deflection."""
    short = np.array([1e-7, 1e-6])
    values = np.log(answer(joint(), deflection=paper.DEFLECTION_LIMIT, length=short).torque)
    return float(-(values[1] - values[0]) / np.log(short[1] / short[0]) - 2.0)


def energy_falls_with_length() -> float:
    """Least relative fall of the energy per relative step of the length, at any deflection but rest."""
    slopes = -np.diff(np.log(_field().energy[1:]), axis=1) / np.diff(np.log(effective_lengths()))
    return float(slopes.min())


def energy_grows_with_deflection() -> float:
    """Least rise of the energy between neighbouring deflections, over the energy at the limit [-]."""
    energy = _field().energy
    return float((np.diff(energy, axis=0) / energy[-1]).min())


def energy_least_at_rest() -> float:
    """Least excess of the energy at deflections to both sides over that at rest [J]."""
    phi = np.concatenate([-deflections()[:0:-1], deflections()[1:]])[:, None]
    moved = answer(joint(), deflection=phi, length=effective_lengths()).energy
    rest = answer(joint(), deflection=0.0, length=effective_lengths()).energy
    return float((moved - rest).min())


def resistance_nonlinear_in_deflection() -> float:
    """Adjusting force at the limit over twice that at half of it, less 1: zero if it were proportional."""
    lengths = effective_lengths()
    half, whole = (
        answer(joint(), deflection=share * paper.DEFLECTION_LIMIT, length=lengths).thrust for share in (0.5, 1.0)
    )
    return float((whole / (2.0 * half)).min() - 1.0)


def resistance_nonlinear_in_length() -> float:
    """Largest deviation of the adjusting force from the straight line between its ends, over their difference, -5 %."""
    lengths = effective_lengths()
    thrust = np.abs(_field().thrust[-1])
    line = np.interp(lengths, lengths[[0, -1]], thrust[[0, -1]])
    return float(np.abs(thrust - line).max() / np.ptp(thrust)) - 0.05


def resistance_needs_force() -> float:
    """Least magnitude of the adjusting force with a deflection, over the whole field [N]: it has to be overcome."""
    return float(-_field().thrust[1:].max())
