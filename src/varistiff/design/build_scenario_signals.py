"""From the signals of a scenario file to signals of time."""

from __future__ import annotations

from functools import singledispatch
from pathlib import Path
from typing import NamedTuple

from varistiff.core.errors import InputError
from varistiff.core.quantity import ANGLE, TORQUE, Kind
from varistiff.design.scenario_joint import si, within
from varistiff.design.scenario_signal_spec import (
    AnySignalSpec,
    ChirpSpec,
    ConstantSpec,
    GaitSpec,
    MinimumJerkSpec,
    PulseSpec,
    SineSpec,
    StepSpec,
    SumSpec,
    TrajectorySpec,
)
from varistiff.design.trajectory_file import TORQUE_PER_MASS, TrajectoryColumn, read_trajectory
from varistiff.dynamics.gait import knee_gait
from varistiff.dynamics.signals import Chirp, Constant, MinimumJerk, Pulse, Samples, Scaled, Signal, Sine, Step, Sum


class Place(NamedTuple):
    """Where a signal stands: what it measures, its field, and the folder that its files are relative to."""

    kind: Kind
    field: str
    directory: Path


def build_signal(spec: AnySignalSpec, place: Place) -> Signal:
    """Return the signal that a spec states.

    Raises
    ------
    InputError : a quantity of another kind, a file that is wrong, or numbers that make no signal
    """
    with within(place.field):
        return _build(spec, place._replace(field=""))


@singledispatch
def _build(spec: AnySignalSpec, place: Place) -> Signal:
    raise AssertionError(f"no signal is made of a {type(spec).__name__}")


@_build.register
def _(spec: ConstantSpec, place: Place) -> Signal:
    return Constant(spec.value.of(place.kind, "value"))


@_build.register
def _(spec: StepSpec, place: Place) -> Signal:
    return Step(time=spec.time, before=si(spec.before, place.kind, "before"), after=spec.after.of(place.kind, "after"))


@_build.register
def _(spec: MinimumJerkSpec, place: Place) -> Signal:
    return MinimumJerk(
        start=spec.start,
        duration=spec.duration,
        before=si(spec.before, place.kind, "before"),
        after=spec.after.of(place.kind, "after"),
    )


@_build.register
def _(spec: SineSpec, place: Place) -> Signal:
    return Sine(
        offset=si(spec.offset, place.kind, "offset"),
        amplitude=spec.amplitude.of(place.kind, "amplitude"),
        frequency=spec.frequency,
        phase=spec.phase,
    )


@_build.register
def _(spec: ChirpSpec, place: Place) -> Signal:
    return Chirp(
        start=spec.start,
        duration=spec.duration,
        offset=si(spec.offset, place.kind, "offset"),
        amplitude=spec.amplitude.of(place.kind, "amplitude"),
        first_frequency=spec.first_frequency,
        last_frequency=spec.last_frequency,
        sweep=spec.sweep,
    )


@_build.register
def _(spec: PulseSpec, place: Place) -> Signal:
    return Pulse(
        start=spec.start, duration=spec.duration, height=spec.height.of(place.kind, "height"), shape=spec.shape
    )


@_build.register
def _(spec: TrajectorySpec, place: Place) -> Signal:
    kind = place.kind if spec.body_mass is None else _per_mass(place.kind)
    column = TrajectoryColumn(spec.column, kind, 1 if spec.sign == "same" else -1, spec.unit)
    path = place.directory / spec.file
    found = read_trajectory(path, [column], time_unit=spec.time_unit)
    times = [spec.start + instant for instant in found.times]
    try:
        samples = Samples.through(times, found.values[spec.column], periodic=spec.periodic, ends=spec.ends)
    except InputError as error:
        field = f"column {'time' if error.field == 'times' else spec.column}"
        raise InputError(error.problem, file=str(path), field=field) from None
    factor = spec.scale * (1.0 if spec.body_mass is None else spec.body_mass)
    return samples if factor == 1.0 else Scaled(samples, factor)


def _per_mass(kind: Kind) -> Kind:
    if kind is not TORQUE:
        raise InputError("is given, but only a torque is stated per body mass; leave it out", field="body_mass")
    return TORQUE_PER_MASS


@_build.register
def _(spec: GaitSpec, place: Place) -> Signal:
    wanted = ANGLE if spec.quantity == "angle" else TORQUE
    if place.kind is not wanted:
        raise InputError(f"{spec.quantity} is {wanted.name}, but this is {place.kind.name}", field="quantity")
    knee = knee_gait(start=spec.start)
    signal = knee.angle if spec.body_mass is None else knee.moment(spec.body_mass)
    return signal if spec.scale == 1.0 else Scaled(signal, spec.scale)


@_build.register
def _(spec: SumSpec, place: Place) -> Signal:
    return Sum(tuple(build_signal(part, place._replace(field=f"parts.{at}")) for at, part in enumerate(spec.parts)))
