"""Solid rectangle."""

from __future__ import annotations

import math
from typing import Any, ClassVar

import jax
import jax.numpy as jnp
import numpy as np

from varistiff.sections.outline import Line, Outline
from varistiff.sections.properties import SectionProperties
from varistiff.sections.section import Section, centred

# odd terms 1, 3, ... of the series, which fall with n^-5 tanh or exp(-n pi/2)
ODD = np.arange(1, 41, 2) * 1.0
ZETA_5 = 1.03692775514336992633  # sum of n^-5


class Rectangle(Section):
    """Solid rectangle, width along x and height along y [m].

    Saint-Venant's series with a >= b the sides:

        J = a b^3 (1/3 - 64 b/(pi^5 a) sum of tanh(n pi a/(2 b))/n^5),
        largest stress = G theta' b (1 - 8/pi^2 sum of 1/(n^2 cosh(n pi a/(2 b)))), amid the longer sides,

    over odd n. Timoshenko and Goodier, Theory of Elasticity, 3rd ed., art. 109, tabulate both.

    >>> round(Rectangle(width=0.002, height=0.001).torsion_constant * 1e12, 4)
    0.4574
    """

    shape: ClassVar[str] = "rectangle"

    width: float
    height: float

    def outline(self) -> Outline:
        """A quarter of the rectangle."""
        x, y = 0.5 * self.width, 0.5 * self.height
        return Outline(((Line((x, 0.0), (x, y)), Line((x, y), (0.0, y))),), rotations=2, mirror=True)

    @property
    def area(self) -> float:
        """Area [m^2]."""
        return self.width * self.height

    @property
    def torsion_constant(self) -> float:
        """J [m^4]; the series, whose rest after 20 terms is below the rounding of doubles for any sides."""
        xp = _namespace(self.width, self.height)
        a, b = xp.maximum(self.width, self.height), xp.minimum(self.width, self.height)
        # tanh z = 1 - 2/(exp 2z + 1): the ones add up to 31/32 zeta(5)
        falling = xp.exp(-ODD * math.pi * a / b)
        series = 31.0 / 32.0 * ZETA_5 - (2.0 * falling / (1.0 + falling) / ODD**5).sum()
        found: float = _plain(a * b**3 * (1.0 / 3.0 - 64.0 * b / (math.pi**5 * a) * series))
        return found

    @property
    def torsion_modulus(self) -> float:
        """W = J/(largest stress over G theta') [m^3]."""
        xp = _namespace(self.width, self.height)
        a, b = xp.maximum(self.width, self.height), xp.minimum(self.width, self.height)
        falling = xp.exp(-ODD * 0.5 * math.pi * a / b)
        series = (2.0 * falling / (1.0 + falling**2) / ODD**2).sum()
        found: float = _plain(self.torsion_constant / (b * (1.0 - 8.0 / math.pi**2 * series)))
        return found

    def properties(self) -> SectionProperties:
        """See ``Section.properties``."""
        width, height = self.width, self.height
        along, across = (0.0, 0.5 * float(height)), (0.5 * float(width), 0.0)
        amid = [point for point, side in ((along, width), (across, height)) if side >= max(width, height)]
        return centred(
            area=self.area,
            second_moments=(width**3 * height / 12.0, width * height**3 / 12.0),
            torsion_constant=self.torsion_constant,
            torsion_modulus=self.torsion_modulus,
            stress_points=tuple((sign * x, sign * y) for x, y in amid for sign in (1.0, -1.0)),
            method="series",
        )


def _namespace(*lengths: object) -> Any:
    """NumPy for numbers; JAX where it differentiates or compiles."""
    return jnp if any(isinstance(length, jax.Array) for length in lengths) else np


def _plain(value: Any) -> Any:
    return value if isinstance(value, jax.Array) else float(value)
