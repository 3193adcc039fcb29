"""Timings that survive a noisy machine: contenders in turn, ratios pair by pair."""

from __future__ import annotations

import os
import time
from collections.abc import Callable, Sequence
from dataclasses import dataclass

import numpy as np


@dataclass(frozen=True)
class Timing:
    """Medians over the rounds."""

    seconds: np.ndarray
    ratio: np.ndarray  # to the first contender, pair by pair


def pin_to_one_core() -> None:
    """Keep this process on one core, where the system lets it."""
    if hasattr(os, "sched_setaffinity"):
        os.sched_setaffinity(0, {max(os.sched_getaffinity(0))})


def in_turn(
    contenders: Sequence[Callable[[], object]], rounds: int = 60, clock: Callable[[], float] = time.process_time
) -> Timing:
    """Run the contenders A B C A B C ... and take medians, of processor time unless another clock is given."""
    for contender in contenders:
        contender()
    spent = np.empty((rounds, len(contenders)))
    for row in spent:
        for column, contender in enumerate(contenders):
            start = clock()
            contender()
            row[column] = clock() - start
    return Timing(np.median(spent, axis=0), np.median(spent / spent[:, :1], axis=0))
