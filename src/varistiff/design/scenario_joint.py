"""What a design says about the coordinates of a scenario, and how its quantities become numbers."""

from __future__ import annotations

from collections.abc import Iterator
from contextlib import contextmanager
from dataclasses import dataclass

from varistiff.core.errors import InputError
from varistiff.core.quantity import Kind
from varistiff.design.design import Design
from varistiff.design.scenario_fields import LINEAR, ROTARY, Amount, Measures
from varistiff.design.scenario_plant_spec import DriveSpec, LinkSpec

_SEMI_ACTIVE = ("roller_beam",)


@dataclass(frozen=True, slots=True)
class Joint:
    """A design as a scenario sees it.

    Parameters
    ----------
    design : whose actuator moves
    """

    design: Design

    @property
    def kind(self) -> str:
        """Kind of actuator."""
        return self.design.kind

    @property
    def name(self) -> str:
        """Kind with its article, as messages say it."""
        return f"{'an' if self.kind[0] in 'aeiou' else 'a'} {self.kind}"

    @property
    def driven(self) -> bool:
        """Whether it has a drive; a semi-active joint has only a setting drive."""
        return self.kind not in _SEMI_ACTIVE

    @property
    def link(self) -> Measures:
        """What link and drive measure."""
        return ROTARY if self.design.deflection_unit == "rad" else LINEAR

    @property
    def setting(self) -> Measures | None:
        """What the setting measures; None for a kind without one."""
        if self.design.setting_unit is None:
            return None
        return ROTARY if self.design.setting_unit == "rad" else LINEAR

    def check_driven(self, given: object, field: str) -> None:
        """Refuse something that only a joint with a drive has.

        Raises
        ------
        InputError : it is given and the joint is semi-active
        """
        if given is not None and not self.driven:
            raise InputError(f"{self.name} is semi-active: it has no drive, only a setting drive", field=field)

    def check_setting(self, given: object, field: str) -> None:
        """Refuse something that only a joint with a setting has.

        Raises
        ------
        InputError : it is given and the kind has no setting
        """
        if given is not None and self.setting is None:
            raise InputError(f"{self.name} has no setting; leave it out", field=field)


def si(amount: Amount | None, kind: Kind, field: str, *, default: float = 0.0) -> float:
    """SI value of an optional amount.

    Raises
    ------
    InputError : it is of another kind
    """
    return default if amount is None else amount.of(kind, field)


def inertia_of(part: LinkSpec | DriveSpec, measures: Measures, field: str) -> float | None:
    """Moment of inertia of a part that turns [kg m^2], or mass of one that slides [kg]; None where it is left out.

    Raises
    ------
    InputError : the other one is given
    """
    own, other = ("inertia", "mass") if measures is ROTARY else ("mass", "inertia")
    if getattr(part, other) is not None:
        raise InputError(f"is given, but this part {measures.word}; give {own} instead", field=f"{field}.{other}")
    found: float | None = getattr(part, own)
    return found


@contextmanager
def within(field: str) -> Iterator[None]:
    """Say of errors inside that they are about a field, or one below it."""
    try:
        yield
    except InputError as error:
        if error.file is not None:
            raise
        raise InputError(error.problem, field=".".join(part for part in (field, error.field) if part)) from None
