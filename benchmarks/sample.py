"""The seeded distribution of roller-contact problems that every contender solves."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from benchmarks import reference_mpmath

RIGIDITY = 194e9 * 0.02545 * 0.00316**3 / 12.0  # dos Santos and Richter (2019), Table 1: 1075 spring steel

DISTRIBUTION = (
    "seed 2019; theta_j uniform in 0.01 ... 1.4 rad, x_r in 0.2 ... 0.6 m, d_1 in 0 ... 0.05 m, "
    "d_r in -2 ... 2 mm, r in -0.2 ... 15 mm (below 0: a swivelling pair); all in contact and before the fold"
)


@dataclass(frozen=True)
class Problems:
    """Arrays of one length, SI units; the joint lies ``clamp_offset`` behind the clamp."""

    deflection: np.ndarray
    setting: np.ndarray
    clamp_offset: np.ndarray
    roller_offset: np.ndarray
    radius: np.ndarray

    def take(self, count: int) -> Problems:
        """The first ``count`` of them."""
        return Problems(*(getattr(self, name)[:count] for name in self.__dataclass_fields__))

    @property
    def centre(self) -> tuple[np.ndarray, np.ndarray]:
        """Roller centres in the clamp's frame [m]."""
        sine, cosine = np.sin(self.deflection), np.cos(self.deflection)
        x = self.setting * cosine - self.roller_offset * sine - self.clamp_offset
        return x, self.setting * sine + self.roller_offset * cosine


def problems(count: int = 100_000) -> Problems:
    """Draw ``count`` problems; those out of contact or beyond the fold are drawn again."""
    rng = np.random.default_rng(2019)
    low = np.array([0.01, 0.2, 0.0, -0.002, -0.0002])
    high = np.array([1.4, 0.6, 0.05, 0.002, 0.015])
    kept = np.empty((0, 5))
    while len(kept) < count:
        drawn = rng.uniform(low, high, (count, 5))
        candidate = Problems(*drawn.T)
        x, y = candidate.centre
        # 1.65 rad of polar angle is before the fold for every r/rho of this distribution
        good = (y + candidate.radius > 1e-5) & (np.arctan2(y, x) < 1.65)
        kept = np.concatenate([kept, drawn[good]])
    return Problems(*np.ascontiguousarray(kept[:count].T))


def edges(count: int = 60) -> Problems:
    """Ill-conditioned problems: half at slopes of 1e-5 ... 1e-3 rad, half as close to the angle of the fold."""
    rng = np.random.default_rng(2020)
    ratio = rng.uniform(-0.05, 0.2, count)
    gap = 10.0 ** rng.uniform(-5.0, -3.0, count)
    top = np.array([float(reference_mpmath.fold(float(value))[1]) for value in ratio])
    angle = np.where(np.arange(count) % 2 == 0, -np.arcsin(ratio) + 2.0 / 3.0 * gap, top - gap)
    setting, zero = rng.uniform(0.2, 0.6, count), np.zeros(count)
    return Problems(angle, setting, zero, zero, ratio * setting)
