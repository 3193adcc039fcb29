"""Sampled control: which controller reads which encoders, when, and how late."""

from __future__ import annotations

from typing import Any, NamedTuple

import equinox as eqx
import jax
import jax.numpy as jnp
from jaxtyping import Array, Float

from varistiff.dynamics.control.controller import Controller, Measured, Wanted
from varistiff.dynamics.control.encoder import Encoder
from varistiff.dynamics.signals import Constant, Sample, Signal
from varistiff.dynamics.state import Command, Motion

Scalar = Float[Array, ""]


class Inputs(eqx.Module):
    """Signals of a run: what is wanted, and what acts from outside.

    Parameters
    ----------
    position : wanted link position [rad] or [m]
    stiffness : wanted stiffness [N m/rad] or [N/m]
    torque : wanted joint torque [N m] or force [N]
    load : torque or force against the link's positive direction (tau_ext)
    link : motion of a prescribed link; None where the link is free
    """

    position: Signal = Constant(0.0)
    stiffness: Signal = Constant(0.0)
    torque: Signal = Constant(0.0)
    load: Signal = Constant(0.0)
    link: Signal | None = None

    def wanted(self, time: Scalar) -> Wanted:
        """What the controllers are asked for."""
        position, stiffness = self.position.at(time), self.stiffness.at(time)
        return Wanted(
            position=position.value,
            position_rate=position.rate,
            position_acceleration=position.acceleration,
            stiffness=stiffness.value,
            stiffness_rate=stiffness.rate,
            torque=self.torque.at(time).value,
        )

    def link_sample(self, time: Scalar) -> Sample:
        """Prescribed motion of the link, zeros where it is free."""
        still = 0.0 * time
        return Sample(still, still, still) if self.link is None else self.link.at(time)

    @property
    def breaks(self) -> tuple[float, ...]:
        """Instants at which the load or a prescribed motion jumps or bends."""
        return (*self.load.breaks, *(() if self.link is None else self.link.breaks))


class Channel(eqx.Module):
    """A controller and how often it is sampled.

    Parameters
    ----------
    controller : what it computes
    every : sampled at each ``every``-th period of the loop
    """

    controller: Controller
    every: int = eqx.field(static=True, default=1)


class ControlLoop(eqx.Module):
    """Encoders, a delay, and a controller for each drive; a drive without one gets the command 0.

    Parameters
    ----------
    drive, setting : controllers of the two drives
    encoders : of link, drive and setting drive
    delay : of the readings, in periods
    """

    drive: Channel | None = None
    setting: Channel | None = None
    encoders: tuple[Encoder, Encoder, Encoder] = (Encoder(), Encoder(), Encoder())
    delay: int = eqx.field(static=True, default=0)

    def read(self, motion: Motion) -> Measured:
        """Positions as the encoders give them."""
        link, drive, setting = self.encoders
        return Measured(link.read(motion.link), drive.read(motion.drive), setting.read(motion.motion))

    def start(self, motion: Motion, wanted: Wanted) -> Memory:
        """Memory of the controllers before the first sample."""
        measured = self.read(motion)
        zero = jnp.asarray(0.0)
        return Memory(
            drive=None if self.drive is None else self.drive.controller.start(measured, wanted),
            setting=None if self.setting is None else self.setting.controller.start(measured, wanted),
            command=Command(zero, zero),
            readings=(measured,) * self.delay,
        )

    def sample(
        self, memory: Memory, motion: Motion, wanted: Wanted, index: Scalar, period: Scalar
    ) -> tuple[Command, Memory]:
        """Commands that hold from this instant to the next sample."""
        readings = (self.read(motion), *memory.readings)
        measured = readings[-1]

        def one(channel: Channel | None, own: Any, held: Scalar) -> tuple[Scalar, Any]:
            if channel is None:
                return held, own
            interval = period * channel.every
            if channel.every == 1:
                return channel.controller.sample(own, measured, wanted, interval)
            due = jnp.mod(index, channel.every) == 0
            return jax.lax.cond(
                due,
                lambda: channel.controller.sample(own, measured, wanted, interval),
                lambda: (held, own),
            )

        drive, drive_memory = one(self.drive, memory.drive, memory.command.drive)
        setting, setting_memory = one(self.setting, memory.setting, memory.command.setting)
        command = Command(drive, setting)
        return command, Memory(drive_memory, setting_memory, command, readings[: self.delay])


class Memory(NamedTuple):
    """What control carries from sample to sample."""

    drive: Any
    setting: Any
    command: Command
    readings: tuple[Measured, ...]
