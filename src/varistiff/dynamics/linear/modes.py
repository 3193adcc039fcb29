"""Natural frequencies and damping ratios, of poles and of zeros."""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np

if TYPE_CHECKING:
    import control

_RIGID = 1e-6  # of the largest root: a double root at zero is found to about the square root of rounding


@dataclass(frozen=True)
class Mode:
    """One root of a characteristic polynomial, of a conjugate pair the one above the real axis.

    Parameters
    ----------
    root : [1/s]; 0 for a rigid motion
    """

    root: complex

    @property
    def natural_frequency(self) -> float:
        """Magnitude of the root [rad/s]: of a pair the undamped frequency w_0."""
        return abs(self.root)

    @property
    def frequency(self) -> float:
        """w_0/(2 pi) [Hz]."""
        return abs(self.root) / (2.0 * math.pi)

    @property
    def damping_ratio(self) -> float:
        """-Re(root)/w_0: 1 for a real stable root, negative for one that grows, NaN for a rigid motion."""
        return -self.root.real / abs(self.root) if self.root != 0.0 else math.nan

    @property
    def oscillates(self) -> bool:
        """Whether it is one of a conjugate pair."""
        return self.root.imag != 0.0


def modes(system: control.StateSpace) -> tuple[Mode, ...]:
    """Modes of a system in continuous time, slowest first; the poles themselves are the roots.

    Roots below a millionth of the largest count as rigid motions, exactly 0.
    """
    return modes_of(np.linalg.eigvals(system.A))


def antiresonances(system: control.StateSpace, input_name: str, output_name: str) -> tuple[Mode, ...]:
    """Modes of the zeros between one input and one output, slowest first.

    From a drive's command to its own position the oscillating ones are the antiresonances: frequencies at which the
    link swings against a drive that stands still.

    Raises
    ------
    ValueError : the system has no such input or output
    """
    import control

    row, column = system.output_labels.index(output_name), system.input_labels.index(input_name)
    single = control.ss(system.A, system.B[:, [column]], system.C[[row], :], system.D[np.ix_([row], [column])])
    return modes_of(control.zeros(single))


def modes_of(roots: np.ndarray) -> tuple[Mode, ...]:
    """Modes of given roots [1/s]."""
    values = np.asarray(roots, dtype=complex)
    largest = float(np.max(np.abs(values), initial=0.0))
    values = np.where(np.abs(values) <= _RIGID * largest, 0.0, values)
    kept = [complex(value) for value in values if value.imag >= 0.0]
    return tuple(Mode(root) for root in sorted(kept, key=lambda root: (abs(root), root.real)))
