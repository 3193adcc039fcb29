"""The base idea: a signal is a function of time with its first two derivatives."""

from __future__ import annotations

from abc import abstractmethod
from typing import NamedTuple

import equinox as eqx
from jaxtyping import Array, Float

Field = Float[Array, "..."]


class Sample(NamedTuple):
    """A signal at an instant; every field has the shape of the time."""

    value: Field
    rate: Field  # per second
    acceleration: Field  # per second squared


class Signal(eqx.Module):
    """A function of time [s] with exact derivatives; its unit is the user's.

    Where a signal jumps it has the value after the jump, and the derivatives of the smooth pieces: no impulse.
    """

    @abstractmethod
    def at(self, time: Field) -> Sample:
        """Value, rate and acceleration at a time [s], for any shape of it."""

    @property
    @abstractmethod
    def breaks(self) -> tuple[float, ...]:
        """Instants [s], in order, at which the value or its rate jumps; not inside a trace."""
