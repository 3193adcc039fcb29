"""The base idea: an actuator is its energy."""

from __future__ import annotations

from abc import abstractmethod
from typing import ClassVar, NamedTuple

import equinox as eqx
import jax.numpy as jnp
from jaxtyping import Array, Bool, Float, Int

from varistiff.core.status import Status

Field = Float[Array, "..."]
Mask = Bool[Array, "..."]


class Response(NamedTuple):
    """What an actuator answers at points (deflection, setting); every field has their common shape.

    ``load`` is dV/d(deflection), ``stiffness`` d2V/d(deflection)2 (tangent), ``adjusting_load`` dV/d(setting).
    ``stress`` is the largest in the elastic element, NaN where the kind has none.
    """

    status: Int[Array, "..."]
    energy: Field
    load: Field
    stiffness: Field
    adjusting_load: Field
    stress: Field


class Quantity(NamedTuple):
    """Name for people and SI unit of a number that only some kinds have."""

    long_name: str
    unit: str


class Constant(NamedTuple):
    """Number of an actuator that holds at every point; NaN where it does not exist, and the note says why."""

    value: float
    long_name: str
    unit: str
    note: str = ""


class Actuator(eqx.Module):
    """A variable stiffness actuator: one scalar potential V(deflection, setting) in SI units.

    Final subclasses are frozen parameter sets; they add no state and override nothing but the abstract methods,
    and ``constants`` where there are any.
    """

    kind: ClassVar[str]
    deflection_unit: ClassVar[str]  # "rad" for a joint, "m" for a linear spring
    references: ClassVar[tuple[str, ...]]  # keys of varistiff.core.citations
    details: ClassVar[dict[str, Quantity]] = {}
    broken_assumption: ClassVar[str] = ""  # what ``outside_validity`` means for this kind, one clause
    loses_contact: ClassVar[bool] = False  # whether the element can be free of load over a range: ``no_contact``

    @property
    @abstractmethod
    def setting_unit(self) -> str | None:
        """SI unit of the setting: "m", "rad", or None for an actuator without one."""

    @property
    @abstractmethod
    def strength(self) -> float | None:
        """Stress [Pa] that counts as yielding: infinite without a yield strength, None without a stress."""

    @property
    def constants(self) -> dict[str, Constant]:
        """Numbers that hold at every point and belong into the datasheet, by name."""
        return {}

    @abstractmethod
    def energy(self, deflection: Field, setting: Field) -> Field:
        """Elastic energy V [J] where a solution exists; differentiable."""

    @abstractmethod
    def respond(self, deflection: Field, setting: Field) -> tuple[Response, dict[str, Field]]:
        """Response, and the kind's details by name, at points of one common shape."""


def first_status(
    *,
    no_solution: Mask,
    element_too_short: Mask,
    no_contact: Mask,
    outside_validity: Mask,
    yielded: Mask,
) -> Int[Array, "..."]:
    """Integer status per point: the first mask that is true, in the order of the contract."""
    status = jnp.int8(Status.OK)
    # the last one written wins; jnp.select would search for the first with a reduction
    for mask, value in (
        (yielded, Status.YIELDED),
        (outside_validity, Status.OUTSIDE_VALIDITY),
        (no_contact, Status.NO_CONTACT),
        (element_too_short, Status.ELEMENT_TOO_SHORT),
        (no_solution, Status.NO_SOLUTION),
    ):
        status = jnp.where(mask, jnp.int8(value), status)
    return status


def blank(status: Int[Array, "..."], value: Field, *, extra_nan: Mask | bool = False) -> Field:
    """Hold a number to its status: NaN where none exists, exactly 0 without contact, itself elsewhere."""
    missing = (status == Status.NO_SOLUTION) | (status == Status.ELEMENT_TOO_SHORT) | extra_nan
    return jnp.where(missing, jnp.nan, jnp.where(status == Status.NO_CONTACT, 0.0, value))
