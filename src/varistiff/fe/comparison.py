"""One quantity by several methods, over settings."""

from __future__ import annotations

from dataclasses import dataclass, field

import numpy as np
from numpy.typing import NDArray

from varistiff.fe.leaf_problem import LeafResult
from varistiff.fe.torsion_problem import StressField

Floats = NDArray[np.float64]


@dataclass(frozen=True, eq=False)
class Method:
    """Values of one method.

    Parameters
    ----------
    name : for tables and files, a word
    label : for people
    values : SI, shape of the comparison's settings; NaN where the method has none
    errors : relative errors that the method states; NaN where it states none
    """

    name: str
    label: str
    values: Floats
    errors: Floats


@dataclass(frozen=True, eq=False)
class Comparison:
    """A quantity of a device by several methods, all under the same settings and deflections.

    Parameters
    ----------
    quantity, unit : what is compared, such as "stiffness" in "N*m/rad"
    setting, deflection : SI, shape (n,); deflection is None where the quantity does not depend on it
    methods : the first is the one that the others are held against
    assumptions : what the design left open and was assumed, a sentence each
    remarks : what a reader should know of the numbers, a sentence each
    measured : settings and values of a measurement, each shape (m,), or None
    fields : stress in a torsion element, for pictures
    leaf : the last solid leaf, for a picture
    """

    quantity: str
    unit: str
    setting: Floats
    deflection: Floats | None
    methods: tuple[Method, ...]
    assumptions: tuple[str, ...] = ()
    remarks: tuple[str, ...] = ()
    measured: tuple[Floats, Floats] | None = None
    fields: tuple[StressField, ...] = field(default=())
    leaf: LeafResult | None = None

    @property
    def reference(self) -> Method:
        """The method that the others are held against."""
        return self.methods[0]

    def difference(self, method: Method) -> Floats:
        """Relative difference from the reference, shape (n,)."""
        return method.values / self.reference.values - 1.0
