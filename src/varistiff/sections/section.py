"""A cross-section in torsion."""

from __future__ import annotations

from abc import abstractmethod
from dataclasses import fields
from functools import lru_cache
from typing import ClassVar, Literal

import equinox as eqx

from varistiff.sections.outline import Outline
from varistiff.sections.properties import SectionProperties


class Section(eqx.Module):
    """A cross-section: its outline, and what follows from it.

    Final subclasses are frozen sets of lengths [m]. The torsion constant and the torsion modulus of a closed form are
    differentiable by JAX; of the others, and of every shape, ``torsion_sensitivity`` gives the derivatives of J.
    """

    shape: ClassVar[str]

    @abstractmethod
    def outline(self) -> Outline:
        """The boundary."""

    @property
    @abstractmethod
    def area(self) -> float:
        """Area [m^2]."""

    @property
    @abstractmethod
    def torsion_constant(self) -> float:
        """J [m^4]: torque = G J twist per length."""

    @property
    @abstractmethod
    def torsion_modulus(self) -> float:
        """W [m^3]: the largest shear stress is torque/W; 0 where a sharp re-entrant corner makes it unbounded."""

    @abstractmethod
    def properties(self) -> SectionProperties:
        """Area, second moments, torsion, shear centre, and how well they are known."""


class SolvedSection(Section):
    """A cross-section without a closed form: Saint-Venant torsion is solved on its outline, once."""

    @property
    def area(self) -> float:
        """Area [m^2]."""
        return self.properties().area

    @property
    def torsion_constant(self) -> float:
        """J [m^4]."""
        return self.properties().torsion_constant

    @property
    def torsion_modulus(self) -> float:
        """W [m^3]; 0 where the ideal stress is unbounded."""
        return self.properties().torsion_modulus

    def properties(self) -> SectionProperties:
        """See ``Section.properties``; solved at the first call, then kept."""
        return _kept(type(self), tuple(getattr(self, field.name) for field in fields(self)))


@lru_cache(maxsize=256)
def _kept(kind: type[SolvedSection], parameters: tuple[object, ...]) -> SectionProperties:
    from varistiff.sections.solved import solved_properties  # SciPy, which closed forms do without

    return solved_properties(kind(*parameters).outline())


def centred(
    *,
    area: float,
    second_moments: tuple[float, float],
    torsion_constant: float,
    torsion_modulus: float,
    stress_points: tuple[tuple[float, float], ...],
    method: Literal["closed form", "series"] = "closed form",
) -> SectionProperties:
    """Properties of a section with two axes of symmetry through the origin, from closed forms."""
    return SectionProperties(
        area=float(area),
        centroid=(0.0, 0.0),
        second_moments=(float(second_moments[0]), float(second_moments[1]), 0.0),
        torsion_constant=float(torsion_constant),
        torsion_modulus=float(torsion_modulus),
        stress_points=stress_points,
        shear_centre=(0.0, 0.0),
        error=0.0,
        method=method,
    )
