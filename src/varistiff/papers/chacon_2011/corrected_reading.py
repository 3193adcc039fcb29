"""Which reading makes the printed numbers consistent: aspect ratios, protecting radius, no yielding and 1500 %.

Together they cannot hold in the paper's model. The search changes one of them at a time, under each end condition of
the leaves, until the stiffness varies by 1500 %, and says whether the leaf then stays elastic.
"""

from __future__ import annotations

from collections.abc import Callable
from functools import cache
from importlib import resources
from typing import NamedTuple

from scipy.optimize import brentq

from varistiff.papers.chacon_2011.devices import THEORIES, Theory, law, states
from varistiff.papers.chacon_2011.paper_values import (
    ASPECT_RATIO_SOFT,
    ASPECT_RATIO_STIFF,
    PROTECTING_RADIUS,
    STIFFNESS_VARIATION,
    YIELD_STRENGTH,
)
from varistiff.papers.chacon_2011.printed_equation import printed_variation
from varistiff.papers.chacon_2011.stiffness import variation

FILE = "corrected_reading.yaml"
_ROUNDING = 1.0 + 1e-9  # a leaf on its protecting cylinder has the yield stress itself


class Case(NamedTuple):
    """A prototype: aspect ratios at its softest and stiffest setting, cylinders [m], displacement at the latter [m]."""

    theory: Theory
    soft: float = ASPECT_RATIO_SOFT
    stiff: float = ASPECT_RATIO_STIFF
    radius: float = PROTECTING_RADIUS
    displacement: float = 0.0


class Reading(NamedTuple):
    """One number changed so that the stiffness varies by 1500 %.

    Parameters
    ----------
    theory : end condition of the leaves
    changed : which number
    printed : its printed value, SI units; None for the displacement, which is unpublished
    value : value with which the stiffness grows by 1500 %, that is sixteenfold
    value_fifteenfold : value with which the higher stiffness is 1500 % of the lower one
    stress : largest in the leaf at the stiffest state, with ``value`` [Pa]
    residual : variation with ``value`` minus the printed one [-]
    """

    theory: Theory
    changed: str
    printed: float | None
    value: float
    value_fifteenfold: float
    stress: float
    residual: float

    @property
    def elastic(self) -> bool:
        """Whether the leaf does not yield."""
        return self.stress <= YIELD_STRENGTH * _ROUNDING

    @property
    def change(self) -> float | None:
        """Relative change of the printed number; None where none is printed."""
        return None if self.printed is None else self.value / self.printed - 1.0


class Search(NamedTuple):
    """What was searched.

    Parameters
    ----------
    as_printed : variation [-] with every number as printed, at rest, by theory of the leaf
    readings : one number changed, one end condition
    chosen : the elastic reading that changes a printed number least
    """

    as_printed: dict[str, float]
    readings: tuple[Reading, ...]
    chosen: Reading


# what may change, how a case takes it, and bounds between which the variation passes 1500 %
_CHANGES: dict[str, tuple[float | None, Callable[[Case, float], Case], tuple[float, float]]] = {
    "stiff_aspect_ratio": (
        ASPECT_RATIO_STIFF,
        lambda case, value: case._replace(stiff=value),
        (1.6, 2.0),
    ),  # the hard stop is at 1.57
    "soft_aspect_ratio": (ASPECT_RATIO_SOFT, lambda case, value: case._replace(soft=value), (3.5, 4.25)),
    "protecting_radius": (PROTECTING_RADIUS, lambda case, value: case._replace(radius=value), (0.035, 0.045)),
    "displacement": (None, lambda case, value: case._replace(displacement=value), (0.0, 0.017)),
}


def case_variation(case: Case) -> float:
    """Stiffness at the stiffest setting and its displacement, over that at rest at the softest one, minus 1."""
    found = states(law(case.theory, protecting_radius=case.radius), [0.0, case.displacement], [case.soft, case.stiff])
    return float(found.stiffness[1] / found.stiffness[0] - 1.0)


def case_stress(case: Case) -> float:
    """Largest stress [Pa] at the stiffest setting."""
    leaves = law(case.theory, protecting_radius=case.radius)
    return float(states(leaves, case.displacement, case.stiff).stress)


def _read(theory: Theory, changed: str) -> Reading:
    printed, put, (low, high) = _CHANGES[changed]
    if theory != "wrapped" and changed == "displacement":
        high = 0.03  # no hard stop

    def miss(value: float, wanted: float) -> float:
        return case_variation(put(Case(theory), value)) - wanted

    value, fifteenfold = (
        float(brentq(miss, low, high, args=(wanted,), xtol=1e-9))
        for wanted in (STIFFNESS_VARIATION, STIFFNESS_VARIATION - 1.0)
    )
    case = put(Case(theory), value)
    residual = case_variation(case) - STIFFNESS_VARIATION
    return Reading(theory, changed, printed, value, fifteenfold, case_stress(case), residual)


@cache
def search() -> Search:
    """Find every single change that gives 1500 %, and the least one under which no leaf yields.

    >>> chosen = search().chosen
    >>> chosen.theory, chosen.changed, round(chosen.value, 3)
    ('wrapped', 'stiff_aspect_ratio', 1.905)
    """
    as_printed: dict[str, float] = {theory: variation(theory=theory) for theory in THEORIES}
    as_printed["printed_equation"] = printed_variation()
    laws: tuple[Theory, ...] = ("guided", "sliding", "wrapped")
    readings = [
        _read(theory, changed)
        for theory in laws
        for changed in _CHANGES
        if theory == "wrapped" or changed != "protecting_radius"
    ]
    elastic = [reading for reading in readings if reading.elastic and reading.change is not None]
    chosen = min(elastic, key=lambda reading: abs(reading.change or 0.0))
    return Search(as_printed, tuple(readings), chosen)


def variation_of_file() -> float:
    """Increase of the stiffness at rest over the nut distances of the corrected reading, over the lower one [-]."""
    from varistiff.design.design import load

    with resources.as_file(resources.files("varistiff.papers.chacon_2011").joinpath(FILE)) as path:
        design = load(path)
    stiffness = design.evaluate(0.0, list(design.elements.setting.bounds)).stiffness  # type: ignore[union-attr]  # this kind has a setting
    return float(stiffness[1] / stiffness[0] - 1.0)
