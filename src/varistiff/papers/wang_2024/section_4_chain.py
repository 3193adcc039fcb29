"""What the paper's simplifications cost in the closed loop: the line of Eq. (16), the leaf of Eq. (9), sensing."""

from __future__ import annotations

from functools import cache
from typing import NamedTuple

import numpy as np

from varistiff.actuators.leaf_joint_theory import LargeDeflection, LeafJointTheory, SmallDeflection
from varistiff.dynamics.control import exact_chain
from varistiff.dynamics.program import run_one
from varistiff.dynamics.state import Motion
from varistiff.papers.wang_2024.device import answer
from varistiff.papers.wang_2024.section_4 import position_set, setting_set
from varistiff.papers.wang_2024.section_4_cases import (
    LENGTH_MIN,
    LINK,
    LINK_FRICTION,
    PERIOD,
    USED_MAX,
    joint,
    stiffness_case,
)
from varistiff.papers.wang_2024.section_4_measures import ErrorNumbers, length_course, stiffness_numbers

DURATION = 2.0  # s
LEAVES: dict[str, LeafJointTheory] = {"small": SmallDeflection(), "exact": LargeDeflection()}
CHAINS = ("line", "exact")


class ClosedLoop(NamedTuple):
    """Courses of one stiffness sine; stiffness and load are those of the plant's own leaf, arrays of shape (2001,)."""

    motion: Motion
    length: np.ndarray
    stiffness: np.ndarray
    load: np.ndarray


@cache
def stiffness_sine(*, leaf: str, chain: str, loaded: bool) -> ClosedLoop:
    """Stiffness and position sines with the stored sets.

    Parameters
    ----------
    leaf : of the plant: ``small`` deflection, Eq. (9), or ``exact``
    chain : of the controller: the ``line`` of Eq. (16) or the ``exact`` groove
    loaded : with the load
    """
    case = stiffness_case(
        position_set("steps"),
        setting_set(),
        loaded=float(loaded),
        sine=1.0,
        theory=LEAVES[leaf],
        chain=None if chain == "line" else exact_chain(joint(), setting_min=LENGTH_MIN, setting_max=USED_MAX),
    )
    motion = run_one(case, duration=DURATION, substeps=2).state.motion
    length = length_course(np.asarray(motion.motion))
    given = answer(joint(LEAVES[leaf]), deflection=np.asarray(motion.drive - motion.link), length=length)
    return ClosedLoop(motion, length, given.stiffness, given.torque)


def stiffness_errors(*, leaf: str, chain: str, loaded: bool) -> ErrorNumbers:
    """Largest stiffness error of ``stiffness_sine`` [N m/rad], of all and after the first second."""
    return stiffness_numbers(stiffness_sine(leaf=leaf, chain=chain, loaded=loaded).stiffness)


class Sensed(NamedTuple):
    """Largest errors [N m] of the external torque that is sensed in the second second of ``stiffness_sine``.

    Parameters
    ----------
    torque : what really acts on the link from outside: the load's torque, and its inertia's reaction (largest)
    plain : error by deflection and Eq. (9) alone, as in the paper
    corrected : error when the link's own inertia and friction are taken off
    """

    torque: float
    plain: float
    corrected: float


def sensed_torque(*, leaf: str) -> Sensed:
    """External torque from two encoders, the disc angle and Eq. (9), beside the true one, with load."""
    run, own = stiffness_sine(leaf=leaf, chain="line", loaded=True), setting_set()
    deflection = np.asarray(run.motion.drive - run.motion.link)
    rate = np.asarray(run.motion.link_rate)
    believed = answer(joint(), deflection=deflection, length=run.length).torque
    # the link's own equation gives its acceleration, without differences of samples
    acceleration = (run.load - LINK_FRICTION * rate - own.load_torque) / (LINK + own.load_inertia)
    true = own.load_torque + own.load_inertia * acceleration
    late = slice(round(1.0 / PERIOD), None)
    corrected = believed - LINK * acceleration - LINK_FRICTION * rate

    def most(values: np.ndarray) -> float:
        return float(np.abs(values[late]).max())

    return Sensed(most(true), most(believed - true), most(corrected - true))
