"""A signal through measured or tabulated values: a cubic spline."""

from __future__ import annotations

import math
from collections.abc import Sequence
from typing import TYPE_CHECKING, Literal

import equinox as eqx
import jax.numpy as jnp
import numpy as np
from jaxtyping import Array, Float

from varistiff.core.errors import InputError
from varistiff.dynamics.signals.signal import Field, Sample, Signal

if TYPE_CHECKING:
    from scipy.interpolate import CubicSpline

Ends = Literal["not_a_knot", "natural", "at_rest"]
Table = np.ndarray[tuple[int, ...], np.dtype[np.float64]]

_SCIPY_ENDS = {"not_a_knot": "not-a-knot", "natural": "natural", "at_rest": "clamped"}
_EVEN = 1e-9  # of a step: times written with all their digits
_CLOSED = 1e-9  # of the range of the values
_FAITHFUL, _TOLERABLE = 1e-6, 1e-3  # of the range: where refining stops, and what is refused
_LONGEST = 2**20  # cells; 32 MB of coefficients


class Samples(Signal):
    """Cubic spline on cells of equal length, twice continuously differentiable; a look-up takes the same time anywhere.

        x = c_0 u^3 + c_1 u^2 + c_2 u + c_3,  u the time since the cell began

    Outside its table a periodic signal repeats; any other holds the value at the end, with a rate of zero. Make it with
    ``Samples.through``.

    Parameters
    ----------
    start : of the first cell [s]
    step : length of a cell [s]
    coefficients : c_0 to c_3 of each cell
    resampling_error : how far this spline is from the one through the given points, at most; 0 for even times
    periodic : whether the table repeats
    """

    start: float
    step: float
    coefficients: Float[Array, "cell 4"]
    resampling_error: float = 0.0
    periodic: bool = eqx.field(static=True, default=False)

    @classmethod
    def through(
        cls, times: Sequence[float], values: Sequence[float], *, periodic: bool = False, ends: Ends = "not_a_knot"
    ) -> Samples:
        """Return the spline through points.

        Uneven times: the spline through them is sampled on even cells, halved until both agree to 1e-6 of the range of
        the values, or to 1e-3 of it with a million cells; ``resampling_error`` tells.

        Parameters
        ----------
        times : [s], strictly increasing
        values : one for each time
        periodic : the last value is the first of the next period; ``ends`` has no meaning then
        ends : third derivative continuous across the second and last but one point; or second derivative zero at the
            ends; or rate zero at the ends, which makes holding them smooth

        Raises
        ------
        InputError : fewer than two points (three if periodic), not finite, not increasing, a period that does not
            close, or times too uneven to resample

        >>> line = Samples.through([0.0, 1.0, 2.0], [1.0, 3.0, 5.0])
        >>> [round(float(number), 12) for number in line.at(jnp.asarray(0.25))]
        [1.5, 2.0, 0.0]
        """
        instants, points = _checked(times, values, periodic)
        boundary = "periodic" if periodic else _SCIPY_ENDS[ends]
        coefficients, step, error = _even(instants, points, boundary)
        return cls(float(instants[0]), step, jnp.asarray(coefficients), error, periodic)

    @property
    def duration(self) -> float:
        """Length of the table [s]; the period of a periodic one."""
        return self.step * self.coefficients.shape[-2]

    def at(self, time: Field) -> Sample:
        """See ``Signal.at``."""
        shift, length, cells = time - self.start, self.duration, self.coefficients.shape[-2]
        local = shift - length * jnp.floor(shift / length) if self.periodic else jnp.clip(shift, 0.0, length)
        cell = jnp.clip(jnp.floor(local / self.step).astype(int), 0, cells - 1)
        u = local - cell * self.step
        c_0, c_1, c_2, c_3 = jnp.moveaxis(self.coefficients[cell], -1, 0)
        value = ((c_0 * u + c_1) * u + c_2) * u + c_3
        rate = (3.0 * c_0 * u + 2.0 * c_1) * u + c_2
        acceleration = 6.0 * c_0 * u + 2.0 * c_1
        if self.periodic:
            return Sample(value, rate, acceleration)
        slack = _EVEN * self.step  # an end that rounding missed is still an end
        held = (shift < -slack) | (shift > length + slack)
        return Sample(value, jnp.where(held, 0.0, rate), jnp.where(held, 0.0, acceleration))

    @property
    def breaks(self) -> tuple[float, ...]:
        """Ends of a table at which the signal does not rest; none if it is periodic."""
        if self.periodic:
            return ()
        c_0, c_1, c_2, _ = np.asarray(self.coefficients, dtype=float).T
        rates = np.append(c_2, (3.0 * c_0[-1] * self.step + 2.0 * c_1[-1]) * self.step + c_2[-1])
        moving = np.abs(rates) > 1e-9 * np.max(np.abs(rates))  # rounding of a spline that was asked to rest
        instants = float(self.start), float(self.start + self.duration)
        return tuple(instant for instant, moves in zip(instants, moving[[0, -1]], strict=True) if moves)


def _checked(times: Sequence[float], values: Sequence[float], periodic: bool) -> tuple[Table, Table]:
    instants, points = np.array(times, dtype=float), np.array(values, dtype=float)
    if instants.ndim != 1 or instants.shape != points.shape:
        raise InputError(f"has {points.size} numbers; allowed is one for each of {instants.size} times", field="values")
    least = 3 if periodic else 2
    if instants.size < least:
        raise InputError(f"has {instants.size} points; allowed are at least {least}", field="times")
    for name, numbers in (("times", instants), ("values", points)):
        if not np.all(np.isfinite(numbers)):
            raise InputError(f"number {int(np.argmin(np.isfinite(numbers))) + 1} is not finite", field=name)
    steps = np.diff(instants)
    if np.any(steps <= 0.0):
        number = int(np.argmax(steps <= 0.0)) + 2
        raise InputError(
            f"number {number} is not later than the one before; allowed are increasing times", field="times"
        )
    if periodic:
        if abs(points[-1] - points[0]) > _CLOSED * np.ptp(points):
            raise InputError(
                f"begins at {points[0]:.9g} and ends at {points[-1]:.9g}; allowed is a period that closes",
                field="values",
            )
        points[-1] = points[0]
    return instants, points


def _even(instants: Table, points: Table, boundary: str) -> tuple[Table, float, float]:
    """Coefficients on even cells, the length of a cell, and how far they are from the spline through the points."""
    from scipy.interpolate import CubicSpline

    spline = CubicSpline(instants, points, bc_type=boundary)
    begin, span, cells = instants[0], instants[-1] - instants[0], instants.size - 1
    even = begin + span / cells * np.arange(cells + 1)
    if np.max(np.abs(instants - even)) <= _EVEN * span / cells:
        return np.ascontiguousarray(spline.c.T), float(span / cells), 0.0
    scale = max(float(np.ptp(points)), 1e-6 * float(np.max(np.abs(points))))  # of a constant: above its rounding
    return _resampled(spline, instants, scale, boundary)


def _resampled(spline: CubicSpline, instants: Table, scale: float, boundary: str) -> tuple[Table, float, float]:
    """The same of a spline on uneven times, on even cells that are no longer than the shortest between two times."""
    from scipy.interpolate import CubicSpline

    begin, end = instants[0], instants[-1]
    shortest = np.min(np.diff(instants))
    # beginnings and thirds: instants of the points, and some between
    tested = np.concatenate([instants[:-1] + part * np.diff(instants) for part in (0.0, 1 / 3, 2 / 3)])
    cells, error = int(np.ceil(min((end - begin) / shortest, _LONGEST + 1.0))), math.inf
    while cells <= _LONGEST and error > _FAITHFUL * scale:
        grid = np.linspace(begin, end, cells + 1)
        given = spline(grid)
        given[-1] = given[0] if boundary == "periodic" else given[-1]
        even = CubicSpline(grid, given, bc_type=boundary)
        middles = 0.5 * (grid[:-1] + grid[1:])
        error = max(float(np.max(np.abs(even(at) - spline(at)))) for at in (tested, middles))
        cells *= 2
    if error > _TOLERABLE * scale:
        raise InputError(
            f"are too uneven: the shortest step is {shortest:.3g} s of {end - begin:.3g} s; "
            f"allowed are times that {_LONGEST} even steps can follow",
            field="times",
        )
    return np.ascontiguousarray(even.c.T), float(grid[1] - grid[0]), error
