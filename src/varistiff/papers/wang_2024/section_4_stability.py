"""Whether the sampled position loop of a set is stable: it may follow a sine for seconds and not be."""

from __future__ import annotations

import numpy as np

from varistiff.papers.wang_2024.section_4_cases import FILTER_TIME, LINK, LINK_FRICTION, PERIOD, STIFFNESS, PositionSet

FAST = 50.0  # rad/s: above it a pole belongs to the spring, not to the tracking


def sampled_loop(own: PositionSet, *, loaded: float) -> tuple[np.ndarray, np.ndarray]:
    """Loop at 200 N m/rad without limit and for small deflections, exactly between samples.

    The state is link, its rate, drive, its rate, integral part, error before, filtered rate.

    Parameters
    ----------
    loaded : 1 with the load's inertia, 0 without

    Returns
    -------
    What a sample makes of the state, shape (7, 7), and what a wanted position of 1 rad adds, shape (7,).
    """
    from scipy.linalg import expm

    link, drive = LINK + loaded * own.load_inertia, own.drive_inertia
    plant = np.zeros((5, 5))  # link, its rate, drive, its rate, torque that is held
    plant[0, 1] = plant[2, 3] = 1.0
    plant[1, :3] = -STIFFNESS / link, -LINK_FRICTION / link, STIFFNESS / link
    plant[3] = STIFFNESS / drive, 0.0, -STIFFNESS / drive, -own.drive_friction / drive, 1.0 / drive
    held = expm(PERIOD * plant)
    share = 1.0 / (FILTER_TIME + PERIOD)
    error, rate, torque = np.zeros((3, 8))  # over the state and, last, the wanted position
    error[[0, 7]] = -1.0, 1.0
    rate[[5, 6]] = -share, FILTER_TIME * share
    rate += share * error
    torque[4] = 1.0
    torque += own.proportional * error + own.derivative * rate
    whole = np.zeros((7, 8))
    whole[:4, :4] = held[:4, :4]
    whole[:4] += np.outer(held[:4, 4], torque)
    whole[4, 4] = 1.0
    whole[4] += own.integral * PERIOD * error
    whole[5], whole[6] = error, rate
    return whole[:, :7], whole[:, 7]


def fast_radius(own: PositionSet) -> float:
    """Largest magnitude of the loop's fast poles, without and with load: below 1 the spring's motion dies out."""
    poles = np.concatenate([np.linalg.eigvals(sampled_loop(own, loaded=loaded)[0]) for loaded in (0.0, 1.0)])
    fast = poles[np.abs(np.angle(poles)) > FAST * PERIOD]
    return float(np.abs(fast).max(initial=0.0))
