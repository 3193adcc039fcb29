"""The knee in level walking: a representative cycle of its angle and moment."""

from __future__ import annotations

import math
from functools import cache
from importlib import resources
from typing import Any

import equinox as eqx

from varistiff.core.textfile import parse_yaml
from varistiff.dynamics.signals import Samples, Scaled
from varistiff.dynamics.signals.limits import check_positive
from varistiff.dynamics.signals.signal import Field


class KneeGait(eqx.Module):
    """Periodic angle and net internal moment of a knee over the gait cycle, from heel contact to heel contact.

    The moment extends the knee where it is positive: it acts on the shank against increasing flexion. A ``roller_beam``
    whose joint angle theta_j is the flexion therefore has to carry a load of just this moment, because what it puts on
    the shank in +theta_j is minus its load.

    Parameters
    ----------
    angle : flexion [rad], 0 for a straight leg
    extensor_moment : per body mass [N m/kg]
    cycle_duration : from heel contact to the next one of the same foot [s]
    walking_speed : [m/s]
    source : publication and table
    """

    angle: Samples
    extensor_moment: Samples
    cycle_duration: float
    walking_speed: float
    source: str = eqx.field(static=True)

    def moment(self, body_mass: float) -> Scaled:
        """Extensor moment [N m] of a person of this mass [kg].

        Raises
        ------
        InputError : the mass is not above zero
        """
        check_positive("body_mass", body_mass, "kg")
        return Scaled(self.extensor_moment, body_mass)

    def power(self, time: Field) -> Field:
        """Power that the muscles deliver at the knee per body mass [W/kg]: -extensor moment times rate of flexion.

        Negative while they brake; a regenerative joint could store that.
        """
        return -self.extensor_moment.at(time).value * self.angle.at(time).rate


def knee_gait(*, start: float = 0.0) -> KneeGait:
    """Return the knee of healthy adults in level walking at their natural cadence.

    Means of published tables at every 2 % of the cycle, joined by periodic cubic splines through them. A mean over
    people is smoother than any of them: peaks of moment and power are lower than a single person's.

    Parameters
    ----------
    start : an instant of heel contact [s]

    Notes
    -----
    D. A. Winter (1987), The Biomechanics and Motor Control of Human Gait, University of Waterloo Press; see
    ``knee_gait.yaml``. Valid for level walking at about 1.3 m/s.

    >>> knee = knee_gait()
    >>> round(float(knee.extensor_moment.at(0.14 * knee.cycle_duration).value), 3)  # just before mid-stance
    0.615
    """
    table = _table()
    duration = float(table["cycle_duration"])
    percent, flexion, moment = (list(column) for column in zip(*table["rows"], strict=True))
    times = [start + duration * part / 100.0 for part in percent]

    def periodic(column: list[float], unit: float) -> Samples:
        contact = 0.5 * (column[0] + column[-1])
        return Samples.through(times, [unit * value for value in (contact, *column[1:-1], contact)], periodic=True)

    return KneeGait(
        angle=periodic(flexion, math.pi / 180.0),
        extensor_moment=periodic(moment, 1.0),
        cycle_duration=duration,
        walking_speed=float(table["walking_speed"]),
        source=str(table["source"]),
    )


@cache
def _table() -> dict[str, Any]:
    text = resources.files("varistiff.dynamics.gait").joinpath("knee_gait.yaml").read_text(encoding="utf-8")
    (document,) = parse_yaml(text)
    return dict(document)
