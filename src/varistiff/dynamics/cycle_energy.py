"""Energy of one cycle of a periodic run, such as a step: what the drives drew, gave back, and where it went."""

from __future__ import annotations

from dataclasses import dataclass

import jax
import jax.numpy as jnp
import numpy as np
from jaxtyping import Array, Bool, Float

from varistiff.core.errors import InputError
from varistiff.dynamics.drives import Motor
from varistiff.dynamics.ledger import LOSSES
from varistiff.dynamics.semi_active import regenerates
from varistiff.dynamics.simulate import Run

Scalar = Float[Array, ""]
_ON_A_ROW = 1e-6  # of the period: how near a row an end of the cycle has to be


@dataclass(frozen=True)
class CycleEnergy:
    """Energies of one cycle [J]; the audit's terms unless said otherwise.

        drawn - returned = series + leakage + converter losses taken off what the storage and a supply gave

    Parameters
    ----------
    start, duration : of the cycle [s]
    drawn, returned : by the drives at the bus: trapezoids over the rows' power above and below zero
    stored : gain of the storage
    supplied : from a supply
    work_on_joint : done on the link from outside, by the walker; above zero where the joint brakes
    elastic_exchanged : half of the way that the elastic energy goes up and down, by the rows
    elastic_max : largest elastic energy, by the rows
    losses : by name, those of the plant only
    changes : of the energies that should be back where they were: kinetic, elastic, gravity, stops
    residual : what the balance of this cycle leaves open
    turnover : energy turned over
    regenerating_share : share of the time in which the setting motor feeds the bus by Richter's condition; NaN of an
        ideal source
    """

    start: float
    duration: float
    drawn: float
    returned: float
    stored: float
    supplied: float
    work_on_joint: float
    elastic_exchanged: float
    elastic_max: float
    losses: dict[str, float]
    changes: dict[str, float]
    residual: float
    turnover: float
    regenerating_share: float

    @property
    def net_drawn(self) -> float:
        """Drawn less returned, from the audit [J]: what storage and supply gave less their own losses."""
        own = sum(self.losses.get(name, 0.0) for name in ("series_loss", "leakage", "converter_loss"))
        return self.supplied - self.stored - own

    @property
    def mean_power(self) -> float:
        """Mean power that the storage loses [W]; below zero where it gains."""
        return -self.stored / self.duration

    @property
    def periodicity(self) -> float:
        """Largest change of what should be back where it was, over the energy turned over: 0 in a steady state."""
        return max(abs(change) for change in self.changes.values()) / self.turnover


def cycle_energy(run: Run, *, start: float, duration: float) -> CycleEnergy:
    """Energy account of one cycle of a run.

    Parameters
    ----------
    start : of the cycle [s]; it and its end have to be instants of rows
    duration : of the cycle [s]

    Raises
    ------
    InputError : the cycle is not within the run, or its ends are no rows
    """
    first, last = _row(run, start, "start"), _row(run, start + duration, "duration")
    if last <= first:
        raise InputError(f"is {duration!r} s; allowed is above zero", field="duration")
    part = slice(first, last + 1)
    time, rows = run.time[part], run.rows
    change = {name: float(term[last] - term[first]) for name, term in run.audit.terms.items()}
    power = np.asarray(rows.flows.drive.electrical_power) + np.asarray(rows.flows.setting.electrical_power)
    elastic = np.asarray(rows.stores.elastic)[part]
    return CycleEnergy(
        start=float(time[0]),
        duration=float(time[-1] - time[0]),
        drawn=float(np.trapezoid(np.maximum(power[part], 0.0), time)),
        returned=float(np.trapezoid(np.maximum(-power[part], 0.0), time)),
        stored=change["stored"],
        supplied=change["supplied"],
        work_on_joint=change["external_work"],
        elastic_exchanged=0.5 * float(np.sum(np.abs(np.diff(elastic)))),
        elastic_max=float(np.max(elastic)),
        losses={name: change[name] for name in LOSSES if name in rows.state.ledger.losses},
        changes={name: change[name] for name in ("kinetic", "elastic", "gravity", "stop_elastic")},
        residual=float(run.audit.residual[last] - run.audit.residual[first]),
        turnover=float(run.audit.turnover[last] - run.audit.turnover[first]),
        regenerating_share=_regenerating_share(run, part),
    )


def _row(run: Run, instant: float, field: str) -> int:
    index = round(instant / run.case.period)
    if not 0 <= index < run.time.size or abs(run.time[index] - instant) > _ON_A_ROW * run.case.period:
        near = f"whole numbers of periods of {run.case.period!r} s up to {run.time[-1]:.6g} s"
        raise InputError(f"ends the cycle at {instant!r} s, where the run has no row; allowed are {near}", field=field)
    return index


def _regenerating_share(run: Run, part: slice) -> float:
    """0 < tau_v sign(w) < a^2 |w|/R for the torque tau_v = -a i of the setting motor, at each row but the last."""
    motor = run.case.plant.setting_motor
    if not isinstance(motor, Motor):
        return float("nan")
    coupling = motor.gear_ratio * motor.torque_constant
    hot = 1.0 + motor.resistance_coefficient * jnp.asarray(run.rows.state.setting_heat.winding)[part]
    torque = -coupling * jnp.asarray(run.rows.flows.setting.current)[part]
    rate = jnp.asarray(run.rows.state.motion.motion_rate)[part]

    def feeds(own: Scalar, speed: Scalar, factor: Scalar) -> Bool[Array, ""]:
        # the condition knows R tau only: a hotter winding counts as a larger torque
        return regenerates(own * factor, speed, resistance=motor.resistance, coupling=coupling)

    return float(jnp.mean(jax.vmap(feeds)(torque, rate, hot)[:-1]))
