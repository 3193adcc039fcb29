"""Delay by whole samples."""

from __future__ import annotations

from typing import Any, NamedTuple, TypeVar

import equinox as eqx
import jax

from varistiff.core.errors import InputError
from varistiff.dynamics.control.checks import check_number
from varistiff.dynamics.control.controller import Controller, Measured, Number, Scalar, Wanted, as_scalar

T = TypeVar("T")


class Delay(eqx.Module):
    """A first-in, first-out queue: what goes in comes out ``samples`` samples later.

    Parameters
    ----------
    samples : length of the queue, 0 for none

    Raises
    ------
    InputError : not a whole number of at least 0
    """

    samples: int = eqx.field(static=True, default=0)

    def __check_init__(self) -> None:
        samples: object = self.samples
        if isinstance(samples, bool) or not isinstance(samples, int) or samples < 0:
            raise InputError(f"must be a whole number of at least 0, not {samples!r}", field="samples")

    def start(self, value: T) -> tuple[T, ...]:
        """Queue full of one value, a number or a NamedTuple of numbers."""
        filled: T = jax.tree.map(as_scalar, value)
        return (filled,) * self.samples

    def sample(self, memory: tuple[T, ...], value: T) -> tuple[T, tuple[T, ...]]:
        """The value that leaves, and the queue for the next sample."""
        queue = (*memory, jax.tree.map(as_scalar, value))
        return queue[0], queue[1:]


class DelayedMemory(NamedTuple):
    """Memory of the controller inside, and the commands on their way."""

    inside: Any
    queue: tuple[Scalar, ...]


class DelayedController(Controller):
    """A controller whose command reaches the drive ``delay`` samples later (computation, bus).

    Parameters
    ----------
    controller : the one inside
    delay : of the command
    command : what the drive gets until the first command arrives [N m] or [N]
    """

    controller: Controller
    delay: Delay
    command: Number = 0.0

    def __check_init__(self) -> None:
        check_number("command", self.command)

    def start(self, measured: Measured, wanted: Wanted) -> DelayedMemory:
        """See ``Controller.start``."""
        return DelayedMemory(self.controller.start(measured, wanted), self.delay.start(as_scalar(self.command)))

    def sample(
        self, memory: DelayedMemory, measured: Measured, wanted: Wanted, period: Number
    ) -> tuple[Scalar, DelayedMemory]:
        """See ``Controller.sample``."""
        computed, inside = self.controller.sample(memory.inside, measured, wanted, period)
        command, queue = self.delay.sample(memory.queue, computed)
        return command, DelayedMemory(inside, queue)
